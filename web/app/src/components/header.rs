//! Header: name, undo, units, expert mode, theme, share.

use crate::app::Page;
use crate::components::runs::Saved;
use crate::components::share::Share;
use crate::pages::library;
use crate::state::State;
use crate::state::document::Document;
use crate::state::preferences::ThemeChoice;
use leptos::prelude::*;
use msape_kit::display::UnitSystem;
use msape_kit::segments::Segments;

/// The header.
#[component]
pub fn Header(page: Memo<Page>) -> impl IntoView {
    let state = State::expect();
    let name = move || state.case.with(|case| case.name.clone());
    view! {
        <header class="top">
            <div class="brand">
                <h1>"M-SAPE"</h1>
                <span class="subtitle">"planetary entry vehicles"</span>
            </div>
            <nav class="pages" aria-label="Pages">
                {[("#/design", "Design", Page::Design), (library::ADDRESS, "Library", Page::Library)].into_iter().map(|(address, name, this)| view! {
                    <a href=address aria-current=move || page.get().is_part_of(this).then_some("page")>{name}</a>
                }).collect_view()}
            </nav>
            <div class="document">
                <label class="hidden-visually" for="case-name">"Name of the case"</label>
                <input id="case-name" class="name" type="text" autocomplete="off" spellcheck="false" prop:value=name
                    on:input:target=move |event| {
                        let text = event.target().value();
                        state.edit("Name", Some("name"), |document| document.with_case(|case| case.name = text));
                    }
                    on:blur=move |_| state.close_step() />
                <Saved />
            </div>
            <div class="commands">
                <UndoRedo />
                <Segments legend="Units" choices=UnitSystem::ALL.map(|system| (system, system.label())).to_vec()
                    now=Signal::derive(move || state.document.with(|document| document.units))
                    choose=move |units| state.edit(&format!("Units {}", units.label()), None, |document| Document { units, unit_of: Default::default(), ..document.clone() }) />
                <Segments legend="Inputs shown" choices=vec![(false, "Basic"), (true, "Expert")]
                    now=state.preferences.expert
                    choose=move |expert| state.preferences.expert.set(expert) />
                <label class="inline">
                    <span class="hidden-visually">"Theme"</span>
                    <select on:change:target=move |event| {
                        let name = event.target().value();
                        if let Some(theme) = ThemeChoice::ALL.into_iter().find(|theme| theme.name() == name) {
                            state.preferences.theme.set(theme);
                        }
                    }>
                        {ThemeChoice::ALL.into_iter().map(|theme| view! {
                            <option value=theme.name() prop:selected=move || state.preferences.theme.get() == theme>{theme.name()}</option>
                        }).collect_view()}
                    </select>
                </label>
                <Share />
            </div>
        </header>
    }
}

#[component]
fn UndoRedo() -> impl IntoView {
    let state = State::expect();
    let undo_label = Memo::new(move |_| {
        state
            .history
            .with(|history| history.undo_label().map(str::to_string))
    });
    let redo_label = Memo::new(move |_| {
        state
            .history
            .with(|history| history.redo_label().map(str::to_string))
    });
    let words = |word: &'static str, label: Option<String>| match label {
        Some(label) => format!("{word}: {label}"),
        None => format!("{word}: nothing"),
    };
    view! {
        <div class="undo" role="group" aria-label="Undo and redo">
            <button type="button" class="icon" disabled=move || undo_label.get().is_none()
                aria-label=move || words("Undo", undo_label.get()) title=move || format!("{} (Ctrl+Z)", words("Undo", undo_label.get()))
                on:click=move |_| state.undo()>"↶"</button>
            <button type="button" class="icon" disabled=move || redo_label.get().is_none()
                aria-label=move || words("Redo", redo_label.get()) title=move || format!("{} (Ctrl+Shift+Z)", words("Redo", redo_label.get()))
                on:click=move |_| state.redo()>"↷"</button>
        </div>
    }
}
