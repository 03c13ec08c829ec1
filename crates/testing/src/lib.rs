//! Helpers that the tests of all crates share.
//!
//! - A test that needs an adapter, a display or a program asks [`needed`] or [`may_skip`]. Where it is missing, the
//!   test passes and says loudly that it tested nothing. With `ANTIPODE_REQUIRE_GPU` set it fails.
//! - [`pictures`] measures how far two pictures differ.
//! - [`tiled`] and [`cone`] are two spaces that no player gets: flat space in endlessly many charts, and a cone.
//! - [`rooms`] makes rooms of deformed space by chance.

pub mod cone;
pub mod pictures;
pub mod rooms;
pub mod tiled;

use std::ffi::OsStr;
use std::fmt::Display;
use std::io::Write;

/// What was found, or `None` with a loud word; `what` names what the test cannot do without.
///
/// # Panics
/// When it is missing and must be there.
pub fn needed<T, E: Display>(what: &str, found: Result<T, E>) -> Option<T> {
    found
        .inspect_err(|why| {
            may_skip(&format!("{what} ({why})"));
        })
        .ok()
}

/// Whether a test may pass without `what`: only where nobody demands it, and then it says so.
///
/// # Panics
/// When it must be there.
pub fn may_skip(what: &str) -> bool {
    assert!(
        !is_demanded(std::env::var_os("ANTIPODE_REQUIRE_GPU").as_deref()),
        "{what} is missing, and ANTIPODE_REQUIRE_GPU says it must be there"
    );
    skipped(&format!("{what} is missing"));
    true
}

/// Says that the test of this thread tested nothing, and why.
pub fn skipped(why: &str) {
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("a test");
    // Written past the test harness, which swallows what a test that passes prints.
    let _ = writeln!(std::io::stderr(), "SKIPPED {test}: {why}");
}

fn is_demanded(variable: Option<&OsStr>) -> bool {
    variable.is_some_and(|value| !value.is_empty() && value != "0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there_is_given_and_what_is_missing_may_be_demanded() {
        assert_eq!(needed("a number", Ok::<_, String>(3)), Some(3));
        let demanded = |value: &str| is_demanded(Some(OsStr::new(value)));
        assert!(demanded("1") && !demanded("0") && !demanded(""));
        assert!(!is_demanded(None));
    }
}
