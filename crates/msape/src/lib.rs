//! Systems analysis of planetary entry vehicles, after NASA/TM-2014-218507 ("the report").
//!
//! A case goes in, an answer comes out; nothing else is read or stored.
//!
//! ```
//! use msape::{Case, Library, Outcome, Request, design};
//!
//! let library = Library::builtin().unwrap();
//! let text = msape::library::data_file("cases/msr-eev-pica.toml").unwrap();
//! let mut case = Case::from_text(text).unwrap();
//! case.set("entry.speed_m_s", "11.4 km/s");
//! let answer = design(&case, &library, Request::Nothing).unwrap();
//! assert_eq!(answer.outcome, Outcome::Converged);
//! ```
//!
//! # The tour
//!
//! From text to answer:
//!
//! 1. [`case`]: keys and values as typed, from TOML or JSON, faults included.
//! 2. [`problem`]: the same, checked against [`quantity::input`] and [`library`]; every fault at once, or none. After it
//!    physics cannot fail.
//! 3. [`flight`] for [`fly`], with three or [six](flight::six_dof) degrees of freedom; the passes of [`design`](mod@design) for [`design`](fn@design).
//! 4. [`answer`]: outcome, numbers, adjustments, findings, the record of the passes.
//! 5. [`table`]: the answer as CSV and KML; [`answer::json`] as JSON.
//!
//! A pass of a design, in the order of section 2.2 of the report:
//!
//! 1. [`vehicle`]: outline, component profiles, masses, impact, structure, until the vehicle closes.
//! 2. [`flight`] with the drag of [`aero`] over [`planet`]: the closed form of Allen and Eggers in the first passes, three
//!    degrees of freedom after them.
//! 3. [`heating`]: integrated along the flight, then shoulder and aftbody.
//! 4. [`soak`]: temperature of the payload.
//! 5. [`tps`]: thickness of both heat shields, from which the next pass starts.
//!
//! After the passes, [`shell`]: the carrier structure as a shell, in addition to the rules of [`vehicle::structure`].
//!
//! In addition:
//!
//! - [`quantity`]: every input, output and trajectory column, declared once. Forms, tables, help, CSV and schema come
//!   from it.
//! - [`units`]: the only conversions. Memory holds SI and radians; files and results hold SI and degrees.
//! - [`finding`]: use outside a model's range, as a value returned with the result.
//! - [`aero`]: coefficients of any outline over the angle of attack, for rigid bodies and for `msape aero`.
//! - `ablation`: materials and sizing of a heat shield in depth; a feature of that name, on by default.
//! - `validation`: the shipped cases compared with their references; a feature of that name, on by default.
//!
//! # What is deliberately absent
//!
//! - Files, clocks, threads, environment, random sources, global state: the same case gives the same bits everywhere. The
//!   command line and the page, which call this crate, have all of these.
//! - The elementary functions of the standard library: their last bit differs between platforms. `numerics::math` has them.
//! - Errors after the check: "does not close", "skipped out" and "not converged" are outcomes.
//! - Model limits as errors: a number outside a model's range is given, with a finding.
//! - Drawing, storage and concurrency: they belong to the crates around this one.
//! - Heat shields in depth within the passes of a design (they are answered beside it, with the feature `ablation`), trade studies, optimization, surrogates: not written yet. What stands in for each is named in the result.

#[cfg(feature = "ablation")]
pub mod ablation;
pub mod aero;
pub mod answer;
pub mod case;
pub mod data;
pub mod design;
pub mod finding;
pub mod flight;
pub mod heating;
pub mod library;
pub mod outcome;
pub mod planet;
pub mod problem;
pub mod progress;
pub mod quantity;
pub mod shell;
pub mod soak;
pub mod table;
pub mod tps;
pub mod units;
#[cfg(feature = "validation")]
pub mod validation;
pub mod vehicle;

pub use answer::Answer;
pub use case::{Case, InputError};
pub use flight::Request;
pub use library::Library;
pub use outcome::Outcome;
pub use problem::{design, fly};
