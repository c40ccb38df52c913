//! The command `wasm-bindgen` for Trunk, which `cargo xtask setup trunk` puts beside it under that name: a program of that
//! name cannot be built here.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen::run_cli_with_args(std::env::args_os())
}
