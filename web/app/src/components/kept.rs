//! Messages about stored work, with the possible actions: nothing here replaces anything by itself.

use crate::saving::Saver;
use crate::state::State;
use crate::state::document::{Place, Why};
use crate::state::keeping::Stored;
use crate::storage::stock::{KeptApart, Unreadable};
use leptos::prelude::*;
use msape_kit::display::date;
use msape_kit::files;

/// All messages; empty if there are none.
#[component]
pub fn Kept() -> impl IntoView {
    let state = State::expect();
    view! {
        <Told label="About the link" words=state.keeping.link_words />
        <Told label="About the stored work" words=state.keeping.refused />
        <ShownApart />
        <OthersApart />
        <UnreadableRecords />
    }
}

fn with_saver(state: State, act: impl FnOnce(&Saver)) {
    state.saver.with_value(|saver| {
        if let Some(saver) = saver {
            act(saver);
        }
    });
}

/// Sentences that stay until they are dismissed.
#[component]
fn Told(label: &'static str, words: RwSignal<Vec<String>>) -> impl IntoView {
    view! {
        <div role="alert">
            {move || words.with(|list| (!list.is_empty()).then(|| view! {
                <section class="kept" aria-label=label>
                    {list.iter().map(|words| view! { <p>{words.clone()}</p> }).collect_view()}
                    <button type="button" class="small" on:click=move |_| words.set(Vec::new())>"Dismiss"</button>
                </section>
            }))}
        </div>
    }
}

/// Shown while the page displays something other than the stored work.
#[component]
fn ShownApart() -> impl IntoView {
    let state = State::expect();
    let why = Memo::new(move |_| {
        state.document.with(|document| match &document.place {
            Place::Apart(apart) => Some((apart.why, document.is_view())),
            Place::Stored => None,
        })
    });
    let stored = move || match state.keeping.stored.get() {
        Some(Stored { name, saved_ms }) => format!(
            "Your stored work, {}{}, is kept.",
            name_of(&name),
            when(saved_ms)
        ),
        None => "Nothing else is stored.".to_string(),
    };
    let words = |why: Why, is_view: bool| match (why, is_view) {
        (Why::Link, true) => "A link is open beside your stored work.",
        (Why::Link, false) => {
            "A link is open beside your stored work; what you change here is kept apart."
        }
        (Why::OtherTab, _) => {
            "Another tab has changed the stored work since; what this tab shows is kept apart."
        }
        (Why::Early, _) => {
            "You began before the stored work had been read; what you change here is kept apart."
        }
        (Why::Closed | Why::Unread, _) => "This was kept apart from the stored work, and still is.",
    };
    view! {
        <div role="status">
            {move || why.get().map(|(why, is_view)| {
                let back = if why == Why::OtherTab { "Take the other tab's" } else { "Return to it" };
                view! {
                    <section class="kept" aria-label="Kept apart">
                        <p>{words(why, is_view)} " " {stored}</p>
                        <div class="tools">
                            <button type="button" class="small" on:click=move |_| with_saver(state, Saver::return_to_stored)>{back}</button>
                            <button type="button" class="small" title="The stored work becomes a named run"
                                on:click=move |_| with_saver(state, Saver::keep_this)>"Keep this instead"</button>
                        </div>
                    </section>
                }
            })}
        </div>
    }
}

#[component]
fn OthersApart() -> impl IntoView {
    let state = State::expect();
    let others = Memo::new(move |_| {
        let shown = state.document.with(|document| match &document.place {
            Place::Apart(apart) => Some(apart.id.clone()),
            Place::Stored => None,
        });
        let list = state.keeping.apart.get();
        list.into_iter()
            .filter(|apart| Some(&apart.id) != shown.as_ref())
            .collect::<Vec<_>>()
    });
    view! {
        {move || others.with(|list| (!list.is_empty()).then(|| view! {
            <section class="kept" aria-label="Work kept apart">
                <p>"Kept apart from the stored work:"</p>
                <ul>{list.iter().cloned().map(|apart| view! { <Other apart /> }).collect_view()}</ul>
            </section>
        }))}
    }
}

#[component]
fn Other(apart: KeptApart) -> impl IntoView {
    let state = State::expect();
    let name = name_of(&apart.document.case.name);
    let line = format!("{name}{}, {}", when(apart.saved_ms), from(apart.why));
    let (open, discard) = (
        format!("Open {name}, kept apart"),
        format!("{name}, kept apart"),
    );
    let id = apart.id.clone();
    view! {
        <li>
            <span>{line}</span>
            <button type="button" class="small" aria-label=open
                on:click=move |_| with_saver(state, |saver| saver.open_apart(&apart))>"Open"</button>
            <Discard what=discard discard=move || with_saver(state, |saver| saver.discard_apart(&id)) />
        </li>
    }
}

fn from(why: Why) -> &'static str {
    match why {
        Why::Link => "from a link",
        Why::OtherTab => "of another tab",
        Why::Early => "begun before the stored work was read",
        Why::Closed => "of a page that was closed before it was saved",
        Why::Unread => "which could not be read before",
    }
}

#[component]
fn UnreadableRecords() -> impl IntoView {
    let state = State::expect();
    let records = state.keeping.unreadable;
    view! {
        <div role="alert">
            {move || records.with(|list| (!list.is_empty()).then(|| view! {
                <section class="kept bad" aria-label="Records that cannot be read">
                    <p>"What this version cannot read is kept as it is, and nothing is written over it:"</p>
                    <ul>{list.iter().cloned().map(|record| view! { <Record record /> }).collect_view()}</ul>
                </section>
            }))}
        </div>
    }
}

#[component]
fn Record(record: Unreadable) -> impl IntoView {
    let state = State::expect();
    let download = {
        let record = record.clone();
        move |_| {
            let name = files::file_name(&record.what, "json");
            let handed = files::download(&name, "application/json", record.found.spelled());
            if let Err(error) = handed {
                state.notice.set(format!("The browser refused: {error:?}"));
            }
        }
    };
    let (label, what) = (format!("Download {}", record.what), record.what.clone());
    view! {
        <li>
            <span>{record.what.clone()} ": " {shortened(&record.why)}</span>
            <button type="button" class="small" aria-label=label on:click=download>"Download"</button>
            <Discard what discard=move || with_saver(state, |saver| saver.discard_unreadable(&record)) />
        </li>
    }
}

/// Asks for confirmation, since undo cannot restore it.
#[component]
fn Discard(what: String, discard: impl Fn() + Send + Sync + 'static) -> impl IntoView {
    let sure = RwSignal::new(false);
    let words = move || {
        if sure.get() {
            "Discard for good"
        } else {
            "Discard"
        }
    };
    view! {
        <button type="button" class="small" aria-label=move || format!("{} {what}", words())
            on:blur=move |_| sure.set(false)
            on:click=move |_| if sure.get_untracked() { discard() } else { sure.set(true) }>{words}</button>
    }
}

fn name_of(name: &str) -> String {
    if name.trim().is_empty() {
        "without a name".to_string()
    } else {
        name.to_string()
    }
}

fn when(saved_ms: Option<f64>) -> String {
    saved_ms.map_or_else(String::new, |ms| format!(", {}", date(ms)))
}

/// A reason shortened to a line or two.
fn shortened(text: &str) -> String {
    const MOST: usize = 200;
    if text.chars().count() <= MOST {
        return text.to_string();
    }
    let start: String = text.chars().take(MOST).collect();
    format!("{start} …")
}
