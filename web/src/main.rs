//! The app in the page.

fn main() {
    msape_web::start();
}
