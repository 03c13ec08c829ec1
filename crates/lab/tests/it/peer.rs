//! The peer comparison: that the representations are of the same plane, that the tile graph is
//! exact, and that the figures come out the same every time.

use std::f64::consts::PI;

use antipode_geometry::{ChartPoint, Eye, Map, Metric, Raised};
use antipode_lab::peer::disk::Disk;
use antipode_lab::peer::halfplane::HalfPlane;
use antipode_lab::peer::linear::{BARE, COLUMNS, LIFTED, Linear};
use antipode_lab::peer::model::{Model, Moves, Pose, Spot};
use antipode_lab::peer::outcome::Outcome;
use antipode_lab::peer::polar::Polar;
use antipode_lab::peer::reference::Pair;
use antipode_lab::peer::suite::{Test, subjects};
use antipode_lab::peer::tiling::{EDGES, Tile, Tiling};
use antipode_lab::peer::trials::{self, Keeping};
use antipode_lab::peer::walkers::{self, Parting};
use antipode_lab::peer::{self, chart};
use antipode_lab::{Cell, Effort};
use glam::DVec3;

const EXACT: f64 = 1e-12;

/// How far an isometry moves a point beside the origin, in radii.
fn moved<M: Model<N = f64>>(isometry: &M::Isometry) -> f64 {
    let beside = M::apply(&M::compose(&M::spin(0.4), &M::push(0.5)), &M::origin());
    let back = M::inverse(&M::push_to(&beside));
    M::distance(&M::apply(&back, &M::apply(isometry, &beside)))
}

/// The three tiles about the corner that follows an edge of a tile, and the first again.
fn around_corner(tiling: &mut Tiling, tile: Tile, edge: usize) -> [Tile; 4] {
    let (second, back) = tiling.neighbour(tile, edge);
    let (third, _) = tiling.neighbour(second, (back + EDGES - 1) % EDGES);
    [tile, second, third, tile]
}

fn keeps_the_relations<M: Model<N = f64>>() {
    let seventh = M::spin(2.0 * PI / EDGES as f64);
    let turned = (0..EDGES).fold(M::identity(), |all, _| M::compose(&all, &seventh));
    assert!(moved::<M>(&turned) < EXACT, "{}: seven turns", M::NAME);
    let (mut tiling, moves) = (Tiling::new(), Moves::<M>::new());
    for edge in 0..EDGES {
        let (beside, _) = tiling.neighbour(Tiling::FIRST, edge);
        for tile in [Tiling::FIRST, beside] {
            let corner = around_corner(&mut tiling, tile, edge);
            let round = moves.along(&mut tiling, &corner, Pose(M::identity())).0;
            assert!(moved::<M>(&round) < EXACT, "{}: corner {edge}", M::NAME);
        }
    }
    let there = M::compose(&M::spin(1.0), &M::push(2.0));
    let nowhere = M::compose(&there, &M::inverse(&there));
    assert!(moved::<M>(&nowhere) < EXACT, "{}: way back", M::NAME);
}

#[test]
fn every_representation_keeps_the_relations_of_the_heptagrid() {
    keeps_the_relations::<Linear<f64, BARE>>();
    keeps_the_relations::<Linear<f64, COLUMNS>>();
    keeps_the_relations::<Linear<f64, LIFTED>>();
    keeps_the_relations::<HalfPlane<f64>>();
    keeps_the_relations::<Polar<f64>>();
    keeps_the_relations::<Disk<f64>>();
}

/// Distance and angle of a point three tiles off, by a way with a turn in it.
fn seen<M: Model<N = f64>>() -> [f64; 2] {
    let mut tiling = Tiling::new();
    let mut path = vec![Tiling::FIRST];
    for edge in [2, 4, 3] {
        let tile = path[path.len() - 1];
        path.push(tiling.neighbour(tile, edge).0);
    }
    let point = M::apply(&M::push(0.2), &M::origin());
    let point = Moves::<M>::new().along(&mut tiling, &path, Spot(point)).0;
    [M::distance(&point), M::angle(&point)]
}

#[test]
fn all_representations_see_the_same_place() {
    let reference = seen::<Linear<f64, BARE>>();
    assert!(reference[0] > 2.0);
    let others = [
        seen::<Linear<f64, LIFTED>>(),
        seen::<HalfPlane<f64>>(),
        seen::<Polar<f64>>(),
        seen::<Disk<f64>>(),
    ];
    for other in others {
        for (a, b) in reference.iter().zip(other) {
            assert!((a - b).abs() < 1e-11, "{reference:?} {other:?}");
        }
    }
}

#[test]
fn a_loop_by_tiles_comes_home_exactly_and_by_coordinates_does_not() {
    for seed in 0..5 {
        let by_tiles = trials::loop_iso::<Disk<f32>>(Keeping::Tiles, seed, 1e-30);
        assert_eq!(by_tiles, Outcome::Held(trials::LOOP_LIMIT));
        let lost = trials::loop_iso::<Disk<f32>>(Keeping::Coordinates, seed, 0.1);
        assert!(matches!(lost, Outcome::Failed(5..30)), "{lost:?}");
    }
}

#[test]
fn walkers_that_round_each_for_themselves_part_and_kept_together_do_not() {
    let apart = walkers::apart::<Disk<f32>>(Parting::Tiles, 1);
    assert!(matches!(apart, Outcome::Failed(150..500)), "{apart:?}");
    for parting in [Parting::Tiles, Parting::Distance(1e-3)] {
        let beside = walkers::beside::<f32>(parting, 1);
        assert_eq!(beside, Outcome::Held(walkers::WALK_LIMIT));
    }
}

/// Past 88 radii hyperbolic sines leave single precision: what comes of them is not a number or
/// infinite, and a failure.
#[test]
fn what_overflows_fails() {
    let pair = trials::pair::<Linear<f32, BARE>>(Pair::Opposite, 3, 1e6);
    assert!(matches!(pair, Outcome::Failed(20..90)), "{pair:?}");
    let far = trials::angledist::<Linear<f32, BARE>>(Keeping::Coordinates, 3, 1e6);
    assert!(matches!(far, Outcome::Failed(20..130)), "{far:?}");
}

#[test]
fn the_chart_measures_like_the_hyperboloid() {
    let points = [[0.3, 0.4], [-1.5, 0.2], [2.0, -2.5], [0.0, 1e-3]];
    for a in points {
        for b in points {
            let [x, y] = [a, b].map(|u| {
                let [x, y] = chart::ported(u);
                [x, y, (1.0_f64 + x * x + y * y).sqrt()]
            });
            let cosh: f64 = x[2] * y[2] - x[0] * y[0] - x[1] * y[1];
            let expected = cosh.max(1.0).acosh();
            let found = chart::between(chart::ported(a), chart::ported(b));
            assert!(
                (found - expected).abs() < 1e-7,
                "{a:?} {b:?} {found} {expected}"
            );
        }
        let length = f64::hypot(a[0], a[1]);
        let [x, y] = chart::ported(a);
        assert!((f64::hypot(x, y).asinh() - length).abs() < 1e-14 * length.max(1.0));
    }
}

#[test]
fn the_chart_is_the_one_of_the_game() {
    let (space, eye) = (Raised::new(1.0), Eye::default());
    let place = |[x, z]: [f64; 2]| ChartPoint::a(DVec3::new(x, 0.0, z));
    let points = [[0.3, 0.4], [-1.5, 0.2], [12.0, -2.5], [30.0, 30.0]];
    for a in points {
        let [x, y] = chart::ported(a);
        let view = space.view_point(&eye, place(a));
        let game = f64::hypot(view.x, view.z);
        assert!((f64::hypot(x, y) - game).abs() <= 1e-14 * game);
        for b in points {
            let game = space.distance_m(place(a), place(b), &eye);
            let found = chart::between(chart::ported(a), chart::ported(b));
            assert!((found - game).abs() < 1e-12, "{a:?} {b:?} {found} {game}");
        }
    }
}

#[test]
fn medians_come_out_the_same_every_time() {
    for subject in subjects() {
        for test in [Test::LoopIso, Test::Similarity, Test::Close] {
            let first = subject.median(test, 0.1, 3);
            assert_eq!(first, subject.median(test, 0.1, 3), "{}", subject.name);
        }
    }
}

#[test]
fn the_comparison_stands_by_its_verdicts() {
    let section = peer::run(Effort { quick: true });
    assert_eq!(section.id, "peers");
    let verdicts = section
        .tables
        .iter()
        .flat_map(|table| &table.rows)
        .flatten();
    let verdicts: Vec<_> = verdicts
        .filter(|cell| matches!(cell, Cell::Verdict(_)))
        .collect();
    assert!(verdicts.len() > 30);
    assert!(section.passed(), "{:#?}", section.tables);
    let curves = &section.plots[0].series;
    assert!(curves.iter().any(|curve| curve.points.len() > 30));
    let finite = |&(x, y): &(f64, f64)| x.is_finite() && y.is_finite() && y > 0.0;
    let mut points = section.plots.iter().flat_map(|plot| &plot.series);
    assert!(points.all(|curve| curve.points.iter().all(finite)));
}
