//! What the tests are judged by: double precision, in forms that lose nothing with distance.
//!
//! The place of a tile comes from multiplying the moves of a shortest path in the disk
//! representation, whose shared power of two keeps the relative precision of every entry; the
//! distance of two points on one circle from `sinh(D/2) = sinh r sin(theta/2)`, taken in
//! logarithms.

use std::f64::consts::LN_2;

use super::disk::Disk;
use super::model::{Model, Moves, Pose};
use super::tiling::{Tile, Tiling};

/// Distance in radii and direction in radians.
#[derive(Clone, Copy, Debug)]
pub struct PolarCoords {
    /// From the first tile's centre, in radii.
    pub distance: f64,
    /// From the first tile's edge 0, counterclockwise.
    pub angle: f64,
}

/// Where the centre of a tile lies as seen from the first.
pub fn place(tiling: &mut Tiling, tile: Tile) -> PolarCoords {
    let path = tiling.path(Tiling::FIRST, tile);
    let start = Pose(Disk::<f64>::identity());
    let pose = Moves::<Disk<f64>>::new().along(tiling, &path, start).0;
    PolarCoords {
        distance: Disk::distance(&pose),
        angle: Disk::angle(&pose),
    }
}

/// Which pair of points on a circle of radius r about the origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pair {
    /// `exp(-r)` radians apart: neighbours, however large the circle.
    Similar,
    /// `pi + exp(-r)` radians apart: opposite.
    Opposite,
}

/// The logarithm of `sinh r` for r of one or more.
fn ln_sinh(r: f64) -> f64 {
    r - LN_2 + (-(-2.0 * r).exp()).ln_1p()
}

/// The distance between the two points of a pair, in radii, for r of one or more.
pub fn pair_distance(pair: Pair, r: f64) -> f64 {
    let half = 0.5 * (-r).exp();
    let ln_sin = match pair {
        // ln(sin x / x) + ln x, of which the first is nothing to double precision past x = 1e-8.
        Pair::Similar if r > 20.0 => -r - LN_2,
        Pair::Similar => half.sin().ln(),
        Pair::Opposite => half.cos().ln(),
    };
    let ln_half_chord = ln_sinh(r) + ln_sin;
    if ln_half_chord > 300.0 {
        return 2.0 * (ln_half_chord + LN_2);
    }
    2.0 * ln_half_chord.exp().asinh()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peer::linear::{BARE, Linear};
    use crate::peer::model::Spot;
    use crate::peer::outcome::within;
    use crate::peer::wander;
    use crate::random::Numbers;

    #[test]
    fn the_place_of_a_tile_agrees_with_the_hyperboloid() {
        for seed in 0..10 {
            let mut tiling = Tiling::new();
            let path = wander::outwards(&mut Numbers::new(seed), &mut tiling, 40);
            let tile = path[path.len() - 1];
            let found = place(&mut tiling, tile);
            // Carried inwards from the far end, a hyperboloid vector only gains precision.
            let short = tiling.path(Tiling::FIRST, tile);
            let start = Spot(Linear::<f64, BARE>::origin());
            let point = Moves::<Linear<f64, BARE>>::new()
                .along(&mut tiling, &short, start)
                .0;
            let distance = Linear::<f64, BARE>::distance(&point);
            let angle = Linear::<f64, BARE>::angle(&point);
            assert!(
                within(found.distance - distance, 1e-11),
                "{found:?} {distance}"
            );
            assert!(
                within((found.angle - angle).sin(), 1e-11),
                "{found:?} {angle}"
            );
        }
    }

    #[test]
    fn pairs_have_the_distances_of_the_cosine_rule() {
        for r in [1.0_f64, 2.0, 4.0] {
            for (pair, angle) in [(Pair::Similar, 0.0), (Pair::Opposite, std::f64::consts::PI)] {
                let angle = angle + (-r).exp();
                let cosh = r.cosh().powi(2) - r.sinh().powi(2) * angle.cos();
                assert!(within(pair_distance(pair, r) - cosh.acosh(), 1e-10));
            }
        }
        // Far out the similar pair keeps its distance, 2 asinh(1/4).
        assert!(within(
            pair_distance(Pair::Similar, 999.0) - 2.0 * 0.25_f64.asinh(),
            1e-12
        ));
        assert!(within(pair_distance(Pair::Opposite, 999.0) - 1998.0, 1e-9));
    }
}
