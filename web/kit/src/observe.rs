//! Watches elements of the page for as long as the component that asks for it is there.

use leptos::__reexports::send_wrapper::SendWrapper;
use leptos::html::Div;
use leptos::prelude::*;
use wasm_bindgen::{JsCast, JsValue, closure::Closure};
use web_sys::{IntersectionObserver, IntersectionObserverEntry, ResizeObserver};

/// Keeps `size` at width and height of an element, CSS px.
pub fn size(frame: NodeRef<Div>, size: RwSignal<(f64, f64)>) {
    Effect::new(move |_| {
        let Some(element) = frame.get() else {
            return;
        };
        let measured = element.clone();
        let on_size = Closure::<dyn Fn(JsValue)>::new(move |_| {
            let now = [measured.client_width(), measured.client_height()].map(f64::from);
            let now = now.into();
            // The signal may be gone before the observer: hence `try_`.
            if size.try_get_untracked().is_some_and(|before| before != now) {
                size.set(now);
            }
        });
        if let Ok(observer) = ResizeObserver::new(on_size.as_ref().unchecked_ref()) {
            observer.observe(&element);
            until_cleanup(on_size, move || observer.disconnect());
        }
    });
}

/// Keeps `in_view` at whether an element is on the screen.
pub fn in_view(frame: NodeRef<Div>, in_view: RwSignal<bool>) {
    Effect::new(move |_| {
        let Some(element) = frame.get() else {
            return;
        };
        let on_view = Closure::<dyn Fn(JsValue)>::new(move |entries: JsValue| {
            let newest = entries.unchecked_into::<js_sys::Array>().pop();
            let newest = newest.dyn_into::<IntersectionObserverEntry>();
            if let (Ok(entry), Some(before)) = (newest, in_view.try_get_untracked())
                && entry.is_intersecting() != before
            {
                in_view.set(!before);
            }
        });
        if let Ok(observer) = IntersectionObserver::new(on_view.as_ref().unchecked_ref()) {
            observer.observe(&element);
            until_cleanup(on_view, move || observer.disconnect());
        }
    });
}

/// Keeps what an observer calls until the effect is cleaned up, when the observer ends first.
fn until_cleanup(called: Closure<dyn Fn(JsValue)>, end: impl FnOnce() + 'static) {
    let kept = SendWrapper::new((called, end));
    on_cleanup(move || {
        let (called, end) = kept.take();
        end();
        drop(called);
    });
}
