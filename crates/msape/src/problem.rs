//! A checked case: the same as the case, impossible to misuse.

use crate::answer::Answer;
use crate::case::{Case, InputError, Reader};
use crate::flight::Request;
use crate::library::Library;

pub(crate) fn fly(
    case: &Case,
    _library: &Library,
    _request: Request,
) -> Result<Answer, Vec<InputError>> {
    Err(Reader::new(case).faults)
}

pub(crate) fn design(
    case: &Case,
    _library: &Library,
    _request: Request,
) -> Result<Answer, Vec<InputError>> {
    Err(Reader::new(case).faults)
}
