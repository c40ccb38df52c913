//! The app: for now a page that sends one number to the worker and shows the answer.

mod worker_link;

use leptos::prelude::*;

fn main() {
    console_error_panic_hook::set_once();
    if let Some(skeleton) = document().get_element_by_id("skeleton") {
        skeleton.remove();
    }
    leptos::mount::mount_to_body(App);
}

#[component]
fn App() -> impl IntoView {
    let (number, set_number) = signal(3.0);
    let (answer, set_answer) = signal(None::<f64>);
    let link = worker_link::start(move |value| set_answer.set(Some(value)));
    Effect::new(move || {
        if let Ok(link) = &link {
            link.post(number.get());
        }
    });

    view! {
        <header>
            <h1>"M-SAPE"</h1>
        </header>
        <main>
            <label>
                "Number "
                <input
                    type="number"
                    prop:value=number
                    on:input:target=move |event| {
                        if let Ok(value) = event.target().value().parse() {
                            set_number.set(value);
                        }
                    }
                />
            </label>
            <p>
                "Its square root, computed in the worker: "
                <output>{move || answer.get().map(|value| value.to_string())}</output>
            </p>
        </main>
    }
}
