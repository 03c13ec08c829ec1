//! The tests at the extremes: each quantity over its whole range, against a better reference.
//!
//! Inputs are exact `f32` numbers from a fixed generator. What is computed in `f32` or on the GPU
//! is compared with `f64` from the defining formulas, what is computed in `f64` with double-double
//! arithmetic; where a closed form is known it is used, and the suite says so. The bars are the
//! best figures known for each quantity.

mod cases;
mod curvature;
mod depth;
mod distance;
mod errors;
mod eye_distance;
mod functions;
mod light;
mod moves;
mod normals;
mod picture;
mod port;
mod positions;
mod robust;
mod row;
mod sphere;
mod vertices;
mod view;

use antipode_render::{AdapterChoice, Gpu};

use crate::Effort;
use crate::error::LabError;
use crate::report::{Plot, Section};

pub(crate) use cases::projection;
pub(crate) use moves::off_orthogonal;
pub use row::{Arithmetic, Row, Worst};

/// What the suites work with.
#[derive(Debug)]
pub struct Bench {
    /// How thoroughly.
    pub effort: Effort,
    /// The adapter in use, if there is one.
    pub gpu: Option<Gpu>,
}

impl Bench {
    /// Opens the adapter; `None` measures nothing on a GPU.
    ///
    /// # Errors
    /// When there is no adapter of the kind asked for, or it will not open.
    pub fn open(effort: Effort, adapter: Option<AdapterChoice>) -> Result<Self, LabError> {
        let gpu = adapter.map(Gpu::headless).transpose()?;
        Ok(Self { effort, gpu })
    }
}

/// What a suite returns: rows of one table, and plots.
#[derive(Debug, Default)]
struct Findings {
    rows: Vec<Row>,
    plots: Vec<Plot>,
}

/// A suite: identity, heading, how it is measured, and the measurement.
pub struct Suite {
    /// Short and stable.
    pub id: &'static str,
    title: &'static str,
    method: &'static [&'static str],
    measure: fn(&Bench) -> Result<Findings, LabError>,
}

/// Every suite, in the order of the report.
pub const SUITES: &[Suite] = &[
    Suite {
        id: "accuracy-port",
        title: "The port",
        method: port::METHOD,
        measure: port::run,
    },
    Suite {
        id: "accuracy-view",
        title: "The view, near and far",
        method: view::METHOD,
        measure: view::run,
    },
    Suite {
        id: "accuracy-distance",
        title: "Distances, directions and light",
        method: distance::METHOD,
        measure: distance::run,
    },
    Suite {
        id: "accuracy-normals",
        title: "Normals",
        method: normals::METHOD,
        measure: normals::run,
    },
    Suite {
        id: "accuracy-depth",
        title: "Depth",
        method: depth::METHOD,
        measure: depth::run,
    },
    Suite {
        id: "accuracy-sphere",
        title: "The sphere's equator, poles and antipode",
        method: sphere::METHOD,
        measure: sphere::run,
    },
    Suite {
        id: "accuracy-moves",
        title: "Translations and moves of the camera",
        method: moves::METHOD,
        measure: moves::run,
    },
    Suite {
        id: "accuracy-curvature",
        title: "Curvature from nothing to its top, and through zero",
        method: curvature::METHOD,
        measure: curvature::run,
    },
    Suite {
        id: "accuracy-positions",
        title: "Positions in the world",
        method: positions::METHOD,
        measure: positions::run,
    },
    Suite {
        id: "accuracy-picture",
        title: "Edges and culling",
        method: picture::METHOD,
        measure: picture::run,
    },
    Suite {
        id: "accuracy-vertices",
        title: "Vertices in the picture",
        method: vertices::METHOD,
        measure: vertices::run,
    },
    Suite {
        id: "accuracy-robust",
        title: "Any input, any run",
        method: robust::METHOD,
        measure: robust::run,
    },
    Suite {
        id: "accuracy-functions",
        title: "Functions: our polynomials and the built-in ones",
        method: functions::METHOD,
        measure: functions::run,
    },
];

/// The suite of that name.
pub fn suite(id: &str) -> Option<&'static Suite> {
    SUITES.iter().find(|suite| suite.id == id)
}

impl Suite {
    /// Runs it.
    ///
    /// # Errors
    /// When the adapter fails; errors of figures are verdicts in the section.
    pub fn run(&self, bench: &Bench) -> Result<Section, LabError> {
        let found = (self.measure)(bench)?;
        Ok(Section::new(
            self.id,
            self.title,
            self.method.iter().copied(),
            [row::table(self.title, &found.rows)],
        )
        .with(found.plots))
    }
}
