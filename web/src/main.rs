//! App of the page.

fn main() {
    msape_web::start();
}
