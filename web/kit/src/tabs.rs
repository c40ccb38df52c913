//! Tabs: one of several panels is visible. Arrow keys, Home and End move along them.

use leptos::ev::KeyboardEvent;
use leptos::prelude::*;
use wasm_bindgen::JsCast;

/// Tab.
#[derive(Clone, Copy)]
pub struct Tab {
    /// Name used in identifiers.
    pub id: &'static str,
    /// Displayed name.
    pub label: &'static str,
    /// Content of the panel.
    pub view: fn() -> AnyView,
}

/// Row of tabs and the panel of the selected one.
#[component]
pub fn Tabs(
    /// Name of the row.
    name: &'static str,
    /// The tabs.
    tabs: &'static [Tab],
    /// Identifier of the selected one.
    now: RwSignal<&'static str>,
) -> impl IntoView {
    let place = move || tabs.iter().position(|tab| tab.id == now.get()).unwrap_or(0);
    let place = Memo::new(move |_| place());
    let on_key = move |event: KeyboardEvent| {
        let (here, count) = (place.get_untracked(), tabs.len());
        let next = match event.key().as_str() {
            "ArrowRight" => (here + 1) % count,
            "ArrowLeft" => (here + count - 1) % count,
            "Home" => 0,
            "End" => count - 1,
            _ => return,
        };
        event.prevent_default();
        now.set(tabs[next].id);
        let tab = document().get_element_by_id(&format!("tab-{}", tabs[next].id));
        if let Some(tab) = tab.and_then(|tab| tab.dyn_into::<web_sys::HtmlElement>().ok()) {
            // the tab is on the screen and takes the focus
            let _ = tab.focus();
        }
    };
    view! {
        <div class="tabs" role="tablist" aria-label=name on:keydown=on_key>
            {tabs.iter().enumerate().map(|(i, tab)| {
                let is_now = move || place.get() == i;
                view! {
                    <button type="button" role="tab" id=format!("tab-{}", tab.id)
                        aria-selected=move || is_now().to_string()
                        aria-controls=move || is_now().then(|| format!("panel-{}", tab.id))
                        tabindex=move || if is_now() { "0" } else { "-1" }
                        on:click=move |_| now.set(tab.id)>{tab.label}</button>
                }
            }).collect_view()}
        </div>
        {move || {
            let tab = &tabs[place.get()];
            view! {
                <div class="tab-panel" role="tabpanel" id=format!("panel-{}", tab.id) aria-labelledby=format!("tab-{}", tab.id)>
                    {(tab.view)()}
                </div>
            }
        }}
    }
}
