//! Cases to start from.

use msape::Case;
use msape::library::cases;
use msape::quantity::input;

/// Shipped case.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// Short name, as in links.
    pub id: String,
    /// Case.
    pub case: Case,
}

/// Name of the case shown when the app opens.
pub const FIRST: &str = "msr-eev-pica";
/// The report's run page.
pub const RUN_PAGE: &str = "run-page";

/// Shipped designs, the report's run page last.
pub fn starts() -> Vec<Start> {
    let mut starts: Vec<Start> = cases()
        .filter_map(|(path, text)| {
            let id = path.rsplit('/').next()?.strip_suffix(".toml")?;
            let case = Case::from_toml(text).ok()?;
            (is_design(&case) && id != RUN_PAGE).then(|| Start {
                id: id.to_string(),
                case,
            })
        })
        .collect();
    starts.sort_by_key(|start| start.id != FIRST);
    starts.push(Start {
        id: RUN_PAGE.to_string(),
        case: Case::run_page(),
    });
    starts
}

/// Whether a case asks for a design.
pub fn is_design(case: &Case) -> bool {
    case.gives_any(input::design::INPUTS)
}

/// Case shown when the app opens.
pub fn first() -> Case {
    starts()
        .into_iter()
        .next()
        .map_or_else(Case::run_page, |start| start.case)
}
