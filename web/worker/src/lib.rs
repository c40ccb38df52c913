//! Workers of the page: two programs that answer questions, and the page's connection to them.
//!
//! - [`protocol`]: a question, its answer and its refusal as one type; bytes of messages.
//! - [`questions`]: the questions, one file each, and which worker answers which.
//! - [`serve`]: the workers' side of the connection; [`desk`]: data that a worker keeps between questions.
//! - [`client`]: the page's side: start, watch, restart, stop; [`pool`]: several workers for many questions.
//! - [`catalog`]: data of the library that the page shows; [`clock`]: time.
//!
//! A worker is started with its first question and reads the library at once. It may use the 4 GB of 32-bit WebAssembly;
//! a worker that fails, cannot be loaded or gives no answer is ended and reported by [`client`].

pub mod catalog;
pub mod client;
pub mod clock;
pub mod desk;
pub mod pool;
pub mod protocol;
pub mod questions;
pub mod serve;
