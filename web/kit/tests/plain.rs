//! Parts of the kit on a plain page, without the app.
#![cfg(target_arch = "wasm32")]

use leptos::mount::{UnmountHandle, mount_to};
use leptos::prelude::*;
use leptos::task::tick;
use msape::case::Value;
use msape::quantity::input;
use msape::units::Unit;
use msape_kit::chart::Chart;
use msape_kit::choice::Select;
use msape_kit::number::NumberInput;
use msape_kit::tabs::{Tab, Tabs};
use msape_plot::{Axis, Figure, Series};
use std::sync::{Arc, Mutex};
use wasm_bindgen::JsCast;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::{Element, Event, EventInit, HtmlElement, HtmlInputElement, HtmlSelectElement};
use web_sys::{KeyboardEvent, KeyboardEventInit};

wasm_bindgen_test_configure!(run_in_browser);

/// Values that a callback received.
type Heard<T> = Arc<Mutex<Vec<T>>>;

/// A new element at the end of the page.
fn place() -> HtmlElement {
    let place = document().create_element("div").unwrap();
    document().body().unwrap().append_child(&place).unwrap();
    place.unchecked_into()
}

fn find<E: JsCast>(place: &HtmlElement, selector: &str) -> E {
    let found = place.query_selector(selector).unwrap();
    found.expect(selector).unchecked_into()
}

fn fire(element: &Element, kind: &str) {
    let bubbles = EventInit::new();
    bubbles.set_bubbles(true);
    let event = Event::new_with_event_init_dict(kind, &bubbles).unwrap();
    element.dispatch_event(&event).unwrap();
}

fn press(element: &Element, key: &str) {
    let init = KeyboardEventInit::new();
    init.set_bubbles(true);
    init.set_key(key);
    let event = KeyboardEvent::new_with_keyboard_event_init_dict("keydown", &init).unwrap();
    element.dispatch_event(&event).unwrap();
}

fn number(place: &HtmlElement, heard: Heard<Option<Value>>) -> UnmountHandle<impl Mountable> {
    let input = &input::design::DIAMETER_M;
    let value = RwSignal::new(Some(Value::Number(0.9)));
    let edit = move |edited: Option<Value>| {
        heard.lock().unwrap().push(edited.clone());
        value.set(edited);
    };
    mount_to(place.clone(), move || {
        view! {
            <NumberInput input value unit=Signal::stored(Unit::find("m").unwrap()) turn=Signal::stored(0) invalid=Signal::stored(false)
                id="d".to_string() described_by=String::new() on_edit=edit on_settle=|()| () on_unit=|_| () />
        }
    })
}

#[wasm_bindgen_test]
async fn a_number_is_typed_with_a_unit_and_stepped_by_keys() {
    let (place, heard) = (place(), Heard::default());
    let _mounted = number(&place, heard.clone());
    let field: HtmlInputElement = find(&place, "input[type=text]");
    tick().await;
    assert_eq!(field.value(), "0.9");
    fire(&field, "focus");
    field.set_value("120 cm");
    fire(&field, "input");
    press(&field, "Enter");
    tick().await;
    assert_eq!(field.value(), "1.2");
    press(&field, "ArrowUp");
    tick().await;
    press(&field, "Escape");
    field.set_value("wide");
    fire(&field, "input");
    let numbers = [1.2, 1.21, 0.9].map(|number| Some(Value::Number(number)));
    let text = Some(Value::Text("wide".to_string()));
    assert_eq!(*heard.lock().unwrap(), [&numbers[..], &[text]].concat());
}

#[wasm_bindgen_test]
async fn a_name_is_chosen_and_a_foreign_one_stays_visible() {
    let (place, heard) = (place(), Heard::default());
    let told = heard.clone();
    let choices = ["a", "b"].map(|name| (name.to_string(), name.to_uppercase()));
    let _mounted = mount_to(place.clone(), move || {
        let told = told.clone();
        view! {
            <Select choices=Signal::stored(choices.to_vec()) now=Signal::stored("c".to_string()) invalid=Signal::stored(true)
                id="s".to_string() described_by=String::new() on_choose=move |name: String| told.lock().unwrap().push(name) />
        }
    });
    let list: HtmlSelectElement = find(&place, "select");
    assert_eq!((list.value(), list.length()), ("c".to_string(), 3));
    assert_eq!(list.get_attribute("aria-invalid").as_deref(), Some("true"));
    list.set_value("b");
    fire(&list, "change");
    assert_eq!(*heard.lock().unwrap(), ["b"]);
}

#[wasm_bindgen_test]
async fn a_cursor_goes_along_a_chart_by_keys() {
    let place = place();
    let cursor = RwSignal::new(None::<usize>);
    let points = vec![(0.0, 1.0), (1.0, 4.0), (2.0, 9.0)];
    let figure = Figure {
        x: Axis {
            label: "Time".to_string(),
            ..Axis::default()
        },
        series: vec![Series {
            name: "Height".to_string(),
            points: points.clone(),
            ..Series::default()
        }],
        ..Figure::default()
    };
    let _mounted = mount_to(place.clone(), move || {
        view! {
            <div style="width: 400px; height: 300px">
                <Chart title=Signal::stored("Heights".to_string()) figure=Signal::stored(figure) points=Signal::stored(points)
                    along_x=Signal::stored(true) dark=Signal::stored(false) cursor focused=RwSignal::new(false) />
            </div>
        }
    });
    let chart: HtmlElement = find(&place, ".chart");
    assert!(
        chart
            .get_attribute("aria-label")
            .unwrap()
            .starts_with("Heights.")
    );
    for (key, row) in [
        ("ArrowRight", Some(0)),
        ("ArrowRight", Some(1)),
        ("End", Some(2)),
        ("Escape", None),
    ] {
        press(&chart, key);
        tick().await;
        assert_eq!(cursor.get_untracked(), row, "{key}");
    }
}

#[wasm_bindgen_test]
async fn one_tab_is_shown_and_arrow_keys_move_along_them() {
    const TABS: [Tab; 2] = [
        Tab {
            id: "one",
            label: "One",
            view: || "first".into_any(),
        },
        Tab {
            id: "two",
            label: "Two",
            view: || "second".into_any(),
        },
    ];
    let place = place();
    let _mounted = mount_to(place.clone(), || {
        view! { <Tabs name="Both" tabs=&TABS now=RwSignal::new("one") /> }
    });
    let panel = || find::<HtmlElement>(&place, "[role=tabpanel]").inner_text();
    assert_eq!(panel(), "first");
    press(&find(&place, "[aria-selected=true]"), "ArrowRight");
    tick().await;
    assert_eq!(panel(), "second");
    press(&find(&place, "[aria-selected=true]"), "ArrowRight");
    tick().await;
    assert_eq!(panel(), "first");
}

#[wasm_bindgen_test]
async fn a_part_that_is_taken_away_leaves_nothing() {
    let (place, heard) = (place(), Heard::default());
    for _ in 0..100 {
        drop(number(&place, heard.clone()));
    }
    tick().await;
    assert_eq!(place.child_element_count(), 0);
    // the callbacks are gone with the parts
    assert_eq!(Arc::strong_count(&heard), 1);
}
