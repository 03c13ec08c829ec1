//! What must hold of noise in tiles.

use antipode_geometry::tiling::{Frame, rings};
use antipode_geometry::{Atlas, ChartId, Domain, Geometry, HyperbolicWorld, strategy};
use glam::{DVec3, Vec4};

use super::*;
use crate::climate::Climate;
use crate::fractal::{AXIS_FREQUENCY, Octave};
use crate::lattice::{Cell, Lattice, LatticeCoord, SCALE, blend, fade};

fn world(n: usize) -> HyperbolicWorld {
    HyperbolicWorld::new(HyperbolicWorld::RADII_M[n])
}

fn half_m(world: &HyperbolicWorld) -> f64 {
    match world.domain(ChartId::FIRST) {
        Domain::Rectangle { high, .. } => high.x,
        other => panic!("{other:?}"),
    }
}

/// Charts of tiles all about, and some far out.
fn charts(count: usize) -> Vec<ChartId> {
    let near = rings(&Frame::ROOT, 5, 2000).unwrap();
    let near = near.iter().flatten();
    let near = near.map(|frame| ChartId::new(frame.path().unwrap().number()));
    let far = (0..).map(|n: u128| ChartId::new((1 << 100) + n * 7919));
    near.step_by(3).take(count / 2).chain(far).take(count).collect()
}

fn perlin(lattice: &Lattice, at: DVec3) -> f32 {
    let [x, y, z] = at.to_array().map(LatticeCoord::new);
    let cell = Cell::new(lattice, [x.low, y.low, z.low]);
    let corners = cell.corners(x.part, y.part, z.part, fade(z.part));
    let (u, v) = (Vec4::splat(fade(x.part)), Vec4::splat(fade(y.part)));
    blend([corners; 4], u, v).x * SCALE
}

/// Mean and standard deviation.
fn spread(all: &[f32]) -> [f64; 2] {
    let count = all.len() as f64;
    let mean = all.iter().map(|it| f64::from(*it)).sum::<f64>() / count;
    let squares = all.iter().map(|it| (f64::from(*it) - mean).powi(2));
    [mean, (squares.sum::<f64>() / count).sqrt()]
}

/// Octave by octave, then the broad noise: five columns.
fn noises(world: &HyperbolicWorld, tracts: &Tracts, lattice: &Lattice, chart: ChartId, at: [f64; 2], y: f64) -> [f32; 5] {
    let spot = tracts.spot(world, chart, at);
    let octave = |frequency: f64| {
        spot.blended(y, |place| perlin(lattice, place * AXIS_FREQUENCY * frequency))
    };
    let broad = spot.broad;
    [octave(0.1), octave(0.2), octave(0.4), broad[0].x, broad[1].x]
}

#[test]
fn noise_varies_as_much_in_the_middle_of_a_tile_as_at_its_edges_and_corners() {
    let world = world(1);
    let half = half_m(&world);
    let charts = charts(400);
    let kinds = [[0.0, 0.0], [half, 0.0], [half, half], [0.5 * half, 0.7 * half]];
    let mut found = [[[0.0; 2]; 5]; 4];
    for (kind, at) in kinds.into_iter().enumerate() {
        let mut all: [Vec<f32>; 5] = Default::default();
        for seed in 0..20 {
            let tracts = Tracts::new(seed, !seed, &world).unwrap();
            let lattice = Lattice::new(seed);
            for (n, chart) in charts.iter().enumerate() {
                let y = (n as f64 * 17.3 + 6.1 * seed as f64) % 1000.0;
                let noises = noises(&world, &tracts, &lattice, *chart, at, y);
                for (all, noise) in all.iter_mut().zip(noises) {
                    all.push(noise);
                }
            }
        }
        found[kind] = all.each_ref().map(|it| spread(it));
    }
    println!("{found:.3?}");
    for kind in found {
        for (n, [mean, deviation]) in kind.into_iter().enumerate() {
            let expected = found[0][n][1];
            // 8000 numbers: 1.1 % and 0.8 %, more where neighbours share some.
            assert!(mean.abs() < 0.06 * expected, "{n}: {mean} {found:?}");
            assert!((deviation / expected - 1.0).abs() < 0.05, "{n}: {deviation} {found:?}");
        }
    }
}

#[test]
fn noise_in_tiles_is_as_strong_as_that_of_flat_worlds() {
    let mut octaves = Vec::new();
    let mut climates = Vec::new();
    for seed in 0..40 {
        let lattice = Lattice::new(seed);
        let climate = Climate::new(seed, &*strategy(Geometry::Euclidean, 0.0));
        for n in 0..2500 {
            let at = DVec3::new(f64::from(n % 50), 0.02, f64::from(n / 50)) * 97.0;
            let octave = Octave { frequency: 0.05, amplitude_m: 2.0 };
            octaves.push(perlin(&lattice, at * octave.frequencies() + DVec3::Y * f64::from(n) * 0.37));
            let here = climate.at(at);
            climates.push([here.y, here.z]);
        }
    }
    let humid: Vec<_> = climates.iter().map(|it| it[0]).collect();
    let high: Vec<_> = climates.iter().map(|it| it[1]).collect();
    println!("{:.4?} {:.4?} {:.4?}", spread(&octaves), spread(&humid), spread(&high));
}
