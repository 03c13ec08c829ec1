//! The built-in tour: a script through the four spaces that leaves pictures behind.

use std::path::Path;

use crate::common::{Adapter, Common};
use crate::failure::Failure;
use crate::output;
use crate::script::{Shooting, run_text};

/// The tour's script.
const SCRIPT: &str = include_str!("tour.script");

/// Plays the tour and writes its pictures into a directory.
///
/// # Errors
/// When the directory cannot be made, there is no adapter, or a picture cannot be written.
pub fn run(out: &Path, common: &Common) -> Result<(), Failure> {
    if common.adapter == Adapter::None {
        return Err(Failure::Usage(
            "The tour makes pictures; it cannot run with --adapter none".to_owned(),
        ));
    }
    std::fs::create_dir_all(out).map_err(|e| {
        Failure::Runtime(format!(
            "The directory {} could not be made: {e}",
            out.display()
        ))
    })?;
    run_text(SCRIPT, common, Shooting::Into(out.to_owned()))?;
    output::line(&format!("The tour's pictures are in {}", out.display()))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used, reason = "tests fail by panicking")]

    use antipode_geometry::Geometry;

    use crate::script::{Order, parse};

    #[test]
    fn the_tour_is_a_sound_script_that_photographs_every_space() {
        let lines = parse(super::SCRIPT).expect("the tour parses");
        for geometry in Geometry::ALL {
            let is_shown =
                |order: &Order| matches!(order, Order::New(new) if new.geometry == geometry);
            assert!(lines.iter().any(|line| is_shown(&line.order)), "{geometry}");
        }
        assert!(
            lines
                .iter()
                .filter(|line| matches!(line.order, Order::Shot(_)))
                .count()
                >= 6
        );
    }
}
