//! Display preferences; stored, but not part of the document.

use gloo::events::EventListener;
use leptos::__reexports::send_wrapper::SendWrapper;
use leptos::prelude::*;

/// Light, dark, or following the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThemeChoice {
    /// Follow the system.
    System,
    /// Light.
    Light,
    /// Dark.
    Dark,
}

impl ThemeChoice {
    /// All choices, in the order of menus.
    pub const ALL: [ThemeChoice; 3] = [ThemeChoice::System, ThemeChoice::Light, ThemeChoice::Dark];

    /// Name in menus and in the attribute of the page.
    pub fn name(self) -> &'static str {
        match self {
            ThemeChoice::System => "System",
            ThemeChoice::Light => "Light",
            ThemeChoice::Dark => "Dark",
        }
    }
}

/// Preferences as signals.
#[derive(Clone, Copy)]
pub struct Preferences {
    /// Whether inputs for experts are shown.
    pub expert: RwSignal<bool>,
    /// Theme choice.
    pub theme: RwSignal<ThemeChoice>,
    /// Whether the current theme is dark.
    pub dark: Memo<bool>,
    /// Selected tab of the vehicle card.
    pub vehicle_tab: RwSignal<&'static str>,
}

const EXPERT: &str = "msape-expert";
const THEME: &str = "msape-theme";

impl Preferences {
    /// Loads the stored preferences; changes are stored and applied.
    pub fn load() -> Preferences {
        let read = |key| storage().and_then(|storage| storage.get_item(key).ok().flatten());
        let theme_name = read(THEME).unwrap_or_default();
        let remembered = ThemeChoice::ALL
            .into_iter()
            .find(|theme| theme.name() == theme_name);
        let theme = RwSignal::new(remembered.unwrap_or(ThemeChoice::System));
        let expert = RwSignal::new(read(EXPERT).as_deref() == Some("true"));
        let system_dark = system_is_dark();
        let dark = Memo::new(move |_| match theme.get() {
            ThemeChoice::System => system_dark.get(),
            chosen => chosen == ThemeChoice::Dark,
        });
        Effect::new(move |_| {
            let name = theme.get().name();
            write(THEME, name);
            if let Some(root) = document().document_element() {
                let _ = root.set_attribute("data-theme", &name.to_lowercase());
            }
        });
        Effect::new(move |_| write(EXPERT, if expert.get() { "true" } else { "false" }));
        Preferences {
            expert,
            theme,
            dark,
            vehicle_tab: RwSignal::new("section"),
        }
    }
}

fn storage() -> Option<web_sys::Storage> {
    window().local_storage().ok().flatten()
}

fn write(key: &str, value: &str) {
    if let Some(storage) = storage() {
        // if storage is full or forbidden, only the preference is lost
        let _ = storage.set_item(key, value);
    }
}

fn system_is_dark() -> RwSignal<bool> {
    let query = window()
        .match_media("(prefers-color-scheme: dark)")
        .ok()
        .flatten();
    let dark = RwSignal::new(query.as_ref().is_some_and(web_sys::MediaQueryList::matches));
    if let Some(query) = query {
        let heard =
            EventListener::new(&query.clone(), "change", move |_| dark.set(query.matches()));
        let heard = SendWrapper::new(heard);
        on_cleanup(move || drop(heard));
    }
    dark
}
