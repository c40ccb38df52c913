//! App of the page.

fn main() {
    msape_app::start();
}
