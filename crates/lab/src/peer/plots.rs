//! The comparison as pictures.

use super::disk::Disk;
use super::halfplane::HalfPlane;
use super::linear::{COLUMNS, Linear};
use super::model::Model;
use super::number::Number;
use super::polar::Polar;
use super::suite::Test;
use super::tables::{Measured, TOLERANCES};
use super::tiling::Tiling;
use super::trials::{Keeping, loop_error};
use crate::random::Numbers;
use crate::{Plot, Scale, Series};

/// The farthest loop that is drawn, in tiles.
const LOOP_TILES: u32 = 40;
/// Loops whose median is drawn at each distance.
const LOOPS: u64 = 11;
/// Errors from this on say no more than that nothing is left, in radii.
const LOST: f64 = 100.0;

/// The median error of loops that reach so many tiles; one that is not a number is the largest.
fn median_error<M: Model>(keeping: Keeping, distance: u32) -> f64 {
    let mut errors: Vec<_> = (0..LOOPS)
        .map(|seed| {
            let numbers = &mut Numbers::new(seed);
            loop_error::<M>(keeping, numbers, &mut Tiling::new(), distance)
        })
        .map(|error| {
            if error.is_nan() {
                LOST
            } else {
                error.min(LOST)
            }
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    errors[errors.len() / 2]
}

fn loop_series<M: Model>(keeping: Keeping, name: &str) -> Series {
    let points: Vec<_> = (1..=LOOP_TILES)
        .map(|distance| (f64::from(distance), median_error::<M>(keeping, distance)))
        .collect();
    let is_exact = points.iter().all(|&(_, error)| error == 0.0);
    let note = if is_exact { " (0 throughout)" } else { "" };
    Series::line(
        format!("{name} {}{note}", M::N::NAME),
        points.into_iter().filter(|&(_, y)| y > 0.0),
    )
}

fn loop_both<A: Model, B: Model>(keeping: Keeping, name: &str) -> [Series; 2] {
    [
        loop_series::<A>(keeping, name),
        loop_series::<B>(keeping, name),
    ]
}

/// The error of an isometry carried round a loop, against how far the loop reaches.
pub fn loops() -> Plot {
    type LinearOf<N> = Linear<N, COLUMNS>;
    let kept = Keeping::Coordinates;
    Plot::new(
        "peers-loop",
        "Error after a loop",
        Scale::Logarithmic.axes("farthest tile of the loop, tiles", "median error, radii"),
        [
            loop_both::<LinearOf<f32>, LinearOf<f64>>(kept, LinearOf::<f64>::NAME),
            loop_both::<HalfPlane<f32>, HalfPlane<f64>>(kept, HalfPlane::<f64>::NAME),
            loop_both::<Polar<f32>, Polar<f64>>(kept, Polar::<f64>::NAME),
            loop_both::<Disk<f32>, Disk<f64>>(Keeping::Tiles, "camera-relative"),
        ]
        .concat(),
    )
}

/// The medians of every representation, test by test, at the first tolerance.
pub fn medians(measured: &[Measured]) -> Plot {
    let names: Vec<_> = (1..)
        .zip(Test::ALL)
        .map(|(number, test)| format!("{number} {}", test.name()))
        .collect();
    let series = measured.iter().map(|one| {
        Series::dots(
            format!("{} {}", one.subject.name, one.subject.precision),
            (1_u32..)
                .zip(one.medians[0])
                .filter_map(|(number, median)| Some((number.into(), median?.reached().into()))),
        )
    });
    Plot::new(
        "peers-medians",
        format!(
            "Median tiles, radii or steps before failing, tolerance {}",
            TOLERANCES[0]
        ),
        [
            Scale::Linear.axis(names.join(", ")),
            Scale::Logarithmic.axis("median; or the farthest tried"),
        ],
        series,
    )
}
