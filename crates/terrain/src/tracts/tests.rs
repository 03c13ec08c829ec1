//! What must hold of noise in tiles.

use antipode_geometry::tiling::{Frame, rings};
use antipode_geometry::{Atlas, ChartId, ChartPoint, Domain, Geometry, HyperbolicWorld, strategy};
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
    let number = |frame: &Frame| ChartId::new(frame.path().unwrap().number());
    let far = (1..).map(|n: u128| ChartId::new((1 << 90) + n * 7919));
    let near = near.iter().flatten().map(number).take(count - count / 10);
    near.chain(far).take(count).collect()
}

pub(super) fn perlin(lattice: &Lattice, at: DVec3) -> f32 {
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
fn noises(
    world: &HyperbolicWorld,
    tracts: &Tracts,
    lattice: &Lattice,
    chart: ChartId,
    at: [f64; 2],
    y: f64,
) -> [f32; 5] {
    let spot = tracts.spot(world, chart, at);
    let octave = |frequency: f64| {
        spot.blended(y, |place| {
            perlin(lattice, place * AXIS_FREQUENCY * frequency)
        })
    };
    let (climate, octaves) = (spot.climate(), spot.octaves());
    [octave(0.1), octave(0.2), octave(0.4), climate.x, octaves[0]]
}

#[test]
fn noise_varies_as_much_in_the_middle_of_a_tile_as_at_its_edges_and_corners() {
    let world = world(1);
    let half = half_m(&world);
    let charts = charts(250);
    let kinds = [
        [0.0, 0.0],
        [half, 0.0],
        [half, half],
        [0.5 * half, 0.7 * half],
    ];
    let mut all: [[Vec<f32>; 5]; 4] = Default::default();
    for seed in 0..24 {
        let tracts = Tracts::new(seed, !seed, &world).unwrap();
        let lattice = Lattice::new(seed);
        for (n, chart) in charts.iter().enumerate() {
            let y = (n as f64 * 17.3 + 6.1 * seed as f64) % 1000.0;
            for (all, at) in all.iter_mut().zip(kinds) {
                let noises = noises(&world, &tracts, &lattice, *chart, at, y);
                for (all, noise) in all.iter_mut().zip(noises) {
                    all.push(noise);
                }
            }
        }
    }
    let found = all
        .each_ref()
        .map(|kind| kind.each_ref().map(|it| spread(it)));
    println!("{found:.3?}");
    for kind in found {
        for (n, [mean, deviation]) in kind.into_iter().enumerate() {
            let expected = found[0][n][1];
            // Of 6000 numbers 1.3 % and 0.9 %; broad ones are of fewer that do not hang together.
            assert!(mean.abs() < 0.12 * expected, "{n}: {mean} {found:?}");
            assert!(
                (deviation / expected - 1.0).abs() < 0.06,
                "{n}: {deviation} {found:?}"
            );
        }
    }
}

/// A place of a chart, and the same in other charts of the tiles that share it.
fn shared(world: &HyperbolicWorld, chart: ChartId, x: f64, z: f64) -> Vec<ChartPoint> {
    let point = ChartPoint::new(chart, DVec3::new(x, 0.0, z));
    let images = world.images(point, 1e-6).into_iter().map(|it| {
        // What is carried is rounded; samples of chunks lie at whole metres.
        let pos = (it.point.pos * 4.0).round() / 4.0;
        assert!(pos.distance(it.point.pos) < 1e-9, "{it:?}");
        ChartPoint::new(it.point.chart, pos)
    });
    std::iter::once(point).chain(images).collect()
}

#[test]
fn all_tiles_that_share_a_place_find_the_same_noise_there_to_the_bit() {
    for n in 0..3 {
        let world = world(n);
        let half = half_m(&world);
        let tracts = Tracts::new(5, 6, &world).unwrap();
        let (mut edges, mut corners) = (0, 0);
        for (k, chart) in charts(60).into_iter().enumerate() {
            let along = (k as f64 * 0.25) % half;
            for [x, z] in [
                [half, along],
                [-along, half],
                [-half, along],
                [along, -half],
                [half, -half],
            ] {
                let places = shared(&world, chart, x, z);
                let is_corner = x.abs() == z.abs();
                assert_eq!(places.len(), if is_corner { 5 } else { 2 }, "{places:?}");
                let spots = places
                    .iter()
                    .map(|it| tracts.spot(&world, it.chart, [it.pos.x, it.pos.z]));
                let spots: Vec<_> = spots.collect();
                for spot in &spots {
                    assert_eq!(spot.lots(), spots[0].lots());
                    assert_eq!(spot.broad, spots[0].broad);
                    let squares: f32 = spot.lots().iter().map(|it| it.2 * it.2).sum();
                    assert!((squares - 1.0).abs() < 1e-5);
                }
                *(if is_corner { &mut corners } else { &mut edges }) += 1;
            }
        }
        assert!(edges >= 200 && corners >= 50, "{edges} {corners}");
    }
}

#[test]
fn what_a_chart_writes_past_its_edges_is_the_noise_of_who_is_there() {
    let world = world(1);
    let half = half_m(&world);
    let tracts = Tracts::new(5, 6, &world).unwrap();
    let lattice = Lattice::new(5);
    let (mut most, mut count) = (0.0_f32, 0);
    for (n, chart) in charts(100).into_iter().enumerate() {
        let at = [half + 0.3 + 0.07 * n as f64, 34.0 - 0.7 * n as f64];
        let here = noises(&world, &tracts, &lattice, chart, at, 7.5);
        let point = ChartPoint::new(chart, DVec3::new(at[0], 7.5, at[1]));
        let Some(image) = world.cross(point) else {
            continue;
        };
        let pos = image.point.pos;
        let there = noises(
            &world,
            &tracts,
            &lattice,
            image.point.chart,
            [pos.x, pos.z],
            7.5,
        );
        for (here, there) in here.into_iter().zip(there) {
            most = most.max((here - there).abs());
        }
        count += 1;
    }
    println!("{most} at {count} places");
    assert!(count > 90 && most < 1e-5, "{most} {count}");
}

/// Noises on the way along x of the chart through a place, so far apart that four of five straddle an edge at `half`.
fn bends(
    world: &HyperbolicWorld,
    tracts: &Tracts,
    lattice: &Lattice,
    chart: ChartId,
    [x, z]: [f64; 2],
) -> [f64; 5] {
    const STEP_M: f64 = 0.25;
    let at = |k: f64| noises(world, tracts, lattice, chart, [x + k * STEP_M, z], 3.0);
    let [a, b, c] = [-1.0, 0.0, 1.0].map(at);
    std::array::from_fn(|n| f64::from(a[n] - 2.0 * b[n] + c[n]).abs())
}

#[test]
fn noise_has_no_crease_at_an_edge() {
    let world = world(1);
    let half = half_m(&world);
    let (mut across, mut within) = ([0.0; 5], [0.0; 5]);
    for seed in 0..4 {
        let tracts = Tracts::new(seed, !seed, &world).unwrap();
        let lattice = Lattice::new(seed);
        for (n, chart) in charts(150).into_iter().enumerate() {
            let z = (n as f64 * 7.3) % 40.0 - 20.0;
            let add = |sums: &mut [f64; 5], x: f64| {
                let bends = bends(&world, &tracts, &lattice, chart, [x, z]);
                for (sum, bend) in sums.iter_mut().zip(bends) {
                    *sum += bend;
                }
            };
            add(&mut across, half);
            add(&mut within, half - 3.0);
        }
    }
    let ratios: [f64; 5] = std::array::from_fn(|n| across[n] / within[n]);
    println!("{ratios:.3?}");
    assert!(
        ratios.iter().all(|it| (0.7..1.4).contains(it)),
        "{ratios:?}"
    );
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
            let octave = Octave {
                frequency: 0.05,
                amplitude_m: 2.0,
            };
            let at_octave = at * octave.frequencies() + DVec3::Y * f64::from(n) * 0.37;
            octaves.push(perlin(&lattice, at_octave));
            let here = climate.at(at);
            climates.push([here.y, here.z]);
        }
    }
    let humid: Vec<_> = climates.iter().map(|it| it[0]).collect();
    let high: Vec<_> = climates.iter().map(|it| it[1]).collect();
    let world = world(1);
    let mut tiled: [Vec<f32>; 3] = Default::default();
    for seed in 0..24 {
        let tracts = Tracts::new(seed, !seed, &world).unwrap();
        let lattice = Lattice::new(seed);
        for chart in charts(200) {
            let at = [3.0, 11.0];
            tiled[0].push(noises(&world, &tracts, &lattice, chart, at, 7.7)[0]);
            let here = Climate::at_spot(&tracts.spot(&world, chart, at));
            tiled[1].push(here.y);
            tiled[2].push(here.z);
        }
    }
    for (tiled, flat) in tiled.iter().zip([&octaves, &humid, &high]) {
        let [tiled, flat] = [tiled, flat].map(|it| spread(it));
        println!("{tiled:.4?} {flat:.4?}");
        let ratio = tiled[1] / flat[1];
        assert!((0.85..1.15).contains(&ratio), "{tiled:?} {flat:?}");
    }
}
