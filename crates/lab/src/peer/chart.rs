//! The port's own types: a point as a vector of the exponential chart about the eye, brought into
//! the eye's hyperbolic space by the closed form of the raised map with its offset at zero.
//!
//! The formulas are those of `antipode_geometry::Raised`: a chart vector u goes to
//! `(u sinh|u| / |u|, cosh|u|)`, and two points have the distance D with
//! `sinh^2(D/2) = sinh^2((a-b)/2) + sinh a sinh b sin^2(theta/2)`. A chart holds places, not
//! motions, so only the tests of far tiles and pairs say something about it.

use super::disk::Disk;
use super::number::{Number, length};
use super::outcome::Outcome;
use super::reference::{Pair, PolarCoords};
use super::trials;

/// Up to this distance the product of two sines stays finite in single precision, in radii.
const DIRECT_RADII: f64 = 40.0;

/// The space part of a ported point: its direction from the eye, `sinh` of its distance long.
pub fn ported<N: Number>(u: [N; 2]) -> [N; 2] {
    let distance = length(u);
    if distance == N::of(0.0) {
        return u;
    }
    let stretch = distance.sinh() / distance;
    u.map(|part| part * stretch)
}

/// The distance of two ported points from each other, in radii.
pub fn between<N: Number>(a: [N; 2], b: [N; 2]) -> N {
    let (half, one) = (N::of(0.5), N::of(1.0));
    let (length_a, length_b) = (length(a), length(b));
    let apart = ((length_a.asinh() - length_b.asinh()) * half).sinh();
    let (share_a, share_b) = (one / length_a, one / length_b);
    let turn = [
        a[0] * share_a - b[0] * share_b,
        a[1] * share_a - b[1] * share_b,
    ];
    let across = half * length(turn) * length_a.sqrt() * length_b.sqrt();
    N::of(2.0) * length([apart, across]).asinh()
}

/// A chart vector at a distance in a direction, in radii and radians.
fn polar<N: Number>(distance: N, angle: N) -> [N; 2] {
    [distance * angle.cos(), distance * angle.sin()]
}

/// Whether a far tile, put into the chart where it is, is seen where it is.
fn is_seen<N: Number>(place: PolarCoords, tolerance: f64) -> bool {
    let x = ported(polar(N::of(place.distance), N::of(place.angle)));
    trials::agrees(length(x).asinh(), x[1].atan2(x[0]), place, tolerance)
}

/// Distance and direction of the centre of a far tile.
pub fn angledist<N: Number>(seed: u64, tolerance: f64) -> Outcome {
    trials::places(seed, |_, _, place| is_seen::<N>(place, tolerance))
}

/// The distance of two points on a circle about the eye, in a random direction: both are far
/// from the eye, as nothing is that the game draws.
pub fn pair<N: Number>(pair: Pair, seed: u64, tolerance: f64) -> Outcome {
    trials::pairs(pair, seed, tolerance, |direction: N, r| {
        let distance = N::of(f64::from(r));
        let first = polar(distance, direction);
        let second = polar(distance, direction + trials::pair_angle(pair, r));
        between(ported(first), ported(second))
    })
}

/// The same pair by the camera-relative rule: the direction that both share drops out before any
/// coordinate is made, and the angle between them goes into the formula as it is.
pub fn pair_relative<N: Number>(pair: Pair, seed: u64, tolerance: f64) -> Outcome {
    trials::pairs(pair, seed, tolerance, |_: N, r| {
        let (r, half) = (f64::from(r), N::of(0.5));
        let sin = (trials::pair_angle::<N>(pair, r as u32) * half).sin();
        if r < DIRECT_RADII {
            return N::of(2.0) * (N::of(r).sinh() * sin).asinh();
        }
        // Past e^40 the sine is half the exponential to every bit; the sum is taken of logarithms.
        Disk::distance_of_half_chord(N::of(r) + (half * sin).ln())
    })
}
