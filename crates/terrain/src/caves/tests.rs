//! What caves are like to somebody who looks for them: ways in are near, can be walked, and lead into the dark.

use std::collections::{HashSet, VecDeque};
use std::sync::Arc;

use antipode_geometry::{ChartPoint, Geometry, Strategy, strategy};
use glam::{DVec2, IVec3, Vec3Swizzles as _};

use super::layout::{direction, either_way};
use super::stretch::FLOOR;
use super::*;
use crate::generator::Generator;

fn flat() -> Arc<dyn Strategy> {
    strategy(Geometry::Euclidean, 20.0)
}

fn land(seed: u64, space: Arc<dyn Strategy>) -> Field {
    Field::made_by(Generator::Climates, seed, space)
}

/// Whether a place of an open world lies over its land.
fn is_out(field: &Field, place: DVec3) -> bool {
    place.y > field.land_height(place.with_y(0.0)) - 2.0
}

/// The places of noise space where ways up of squares from the first to the last come out.
fn mouths(field: &Field, [first, last]: [[i64; 2]; 2]) -> Vec<DVec3> {
    let caves = field.caves().expect("caves");
    let mut found = Vec::new();
    for i in first[0]..=last[0] {
        for k in first[1]..=last[1] {
            let seed = caves.seed;
            let passages = Open { seed, field }.passages([i, k]);
            let ends = passages.iter().filter_map(|it| it.stretches.last());
            found.extend(ends.map(Stretch::end).filter(|end| is_out(field, *end)));
        }
    }
    found
}

/// How deep below the land one comes who walks into a mouth of a flat world, metres: floors of a metre's grid with 2 m of air over
/// them, steps of a metre at most.
fn walked_m(field: &Field, mouth: DVec3) -> f64 {
    const REACH: i32 = 60;
    let middle = mouth.round();
    let at = |cell: IVec3| ChartPoint::a(middle + cell.as_dvec3());
    let is_air = |cell: IVec3| field.sample(at(cell)) > 0.0;
    let stands = |cell: IVec3| is_air(cell) && is_air(cell + IVec3::Y) && !is_air(cell - IVec3::Y);
    let mut ways: VecDeque<IVec3> = (-3..=3)
        .flat_map(|x| (-3..=3).flat_map(move |z| (-6..=6).map(move |y| IVec3::new(x, y, z))))
        .filter(|cell| stands(*cell) && field.land(at(*cell)) > -1.5)
        .collect();
    let mut known: HashSet<IVec3> = ways.iter().copied().collect();
    let mut deepest = 0.0_f64;
    while let Some(cell) = ways.pop_front() {
        let place = middle + cell.as_dvec3();
        deepest = deepest.max(field.land_height(place.with_y(0.0)) - place.y);
        for step in [IVec3::X, -IVec3::X, IVec3::Z, -IVec3::Z] {
            for rise in [0, 1, -1] {
                let next = cell + step + IVec3::Y * rise;
                let is_near = next.abs().max_element() <= REACH && field.land(at(next)) < 1.5;
                if is_near && stands(next) && known.insert(next) {
                    ways.push_back(next);
                }
            }
        }
    }
    deepest
}

#[test]
fn a_way_in_is_near_nearly_everywhere() {
    let mut far = Vec::new();
    for seed in 700..720 {
        let field = land(seed, flat());
        let mouths = mouths(&field, [[-9, -9], [8, 8]]);
        for n in 0..100 {
            let key = stirred(seed << 8 | n);
            let place = DVec2::new(either_way(key, 0), either_way(key, 1)) * 1500.0;
            let nearest = mouths.iter().map(|it| it.xz().distance(place));
            far.push(nearest.fold(f64::INFINITY, f64::min));
        }
    }
    far.sort_by(f64::total_cmp);
    let share = far.iter().filter(|far| **far <= 250.0).count() as f64 / far.len() as f64;
    println!(
        "{:.1} % within 250 m, median {:.0} m",
        100.0 * share,
        far[far.len() / 2]
    );
    assert!(share >= 0.95, "{share}");
}

#[test]
fn a_way_in_is_near_nearly_everywhere_in_large_closed_worlds() {
    let radius_m = 256.0;
    let mut far = Vec::new();
    for seed in 700..720 {
        let field = land(seed, strategy(Geometry::Spherical, radius_m));
        let all = field
            .caves()
            .and_then(|it| it.closed.as_ref())
            .expect("caves");
        let ends = all
            .iter()
            .filter(|it| it.stretches.iter().any(|it| it.is_open));
        let mouths: Vec<_> = ends
            .filter_map(|it| it.stretches.last())
            .map(Stretch::end)
            .collect();
        for n in 0..100 {
            let place = direction(stirred(seed << 8 | n));
            let angle = |mouth: &DVec3| mouth.normalize().dot(place).acos();
            let nearest = mouths.iter().map(angle).fold(f64::INFINITY, f64::min);
            far.push(nearest * radius_m);
        }
    }
    let share = far.iter().filter(|far| **far <= 250.0).count() as f64 / far.len() as f64;
    println!("{:.1} % within 250 m", 100.0 * share);
    assert!(share >= 0.95, "{share}");
}

#[test]
fn who_walks_straight_on_for_ten_minutes_comes_by_a_way_in() {
    const WAY_M: f64 = 600.0 * 4.5;
    const SEEN_M: f64 = 40.0;
    let mut came = 0;
    for seed in 740..760 {
        let field = land(seed, flat());
        let mouths = mouths(&field, [[-15, -15], [14, 14]]);
        for n in 0..10 {
            let heading = DVec2::from_angle(std::f64::consts::PI * either_way(seed, n));
            let is_by = |mouth: &DVec3| {
                let along = mouth.xz().dot(heading).clamp(0.0, WAY_M);
                mouth.xz().distance(heading * along) <= SEEN_M
            };
            came += usize::from(mouths.iter().any(is_by));
        }
    }
    println!("{came} of 200 walks come by a way in");
    assert!(came >= 180, "{came}");
}

#[test]
fn one_walks_from_most_mouths_into_the_dark() {
    let mut deep = Vec::new();
    for seed in 720..728 {
        let field = land(seed, flat());
        deep.extend(
            mouths(&field, [[-2, -1], [1, 1]])
                .into_iter()
                .map(|it| walked_m(&field, it)),
        );
    }
    deep.sort_by(f64::total_cmp);
    println!("deepest of {} ways in, metres: {deep:.0?}", deep.len());
    let blocked = deep.iter().filter(|deep| **deep < 6.0).count();
    assert!(blocked * 10 <= deep.len(), "{blocked} of {}", deep.len());
}

#[test]
fn closed_worlds_have_caves_where_there_is_room() {
    for (radius_m, least) in [(32.0, 2), (64.0, 3), (128.0, 10), (256.0, 40)] {
        let mut halls = Vec::new();
        for seed in 0..10 {
            let field = land(seed, strategy(Geometry::Spherical, radius_m));
            let limits = field.strategy().limits().expect("a closed world");
            let all = field
                .caves()
                .and_then(|it| it.closed.as_ref())
                .expect("caves");
            for stretch in all.iter().flat_map(|passage| &passage.stretches) {
                for t in [0.0, 0.5, 1.0] {
                    let radius = stretch.radius_m[0] + t * stretch.radius_m[1];
                    let height = stretch.height_m[0] + t * stretch.height_m[1];
                    assert!(
                        height - FLOOR * radius >= limits.bedrock_m + 1.0,
                        "{radius_m} {seed}"
                    );
                }
            }
            halls.push(
                all.iter()
                    .filter(|it| it.stretches.iter().any(|it| it.is_hall))
                    .count(),
            );
        }
        println!("R {radius_m}: halls {halls:?}");
        halls.sort_unstable();
        assert!(halls[3] >= least, "{radius_m}: {halls:?}");
    }
}

/// For looking at them.
#[test]
#[ignore = "prints where caves of a world are"]
fn print_caves() {
    let field = land(5, flat());
    for square in [[-1, -1], [-1, 0], [0, -1], [0, 0]] {
        let seed = field.caves().expect("caves").seed;
        for passage in (Open {
            seed,
            field: &field,
        })
        .passages(square)
        {
            let kind = match passage.stretches.as_slice() {
                [only] if only.is_hall => "hall",
                [.., last] if is_out(&field, last.end()) => "way up",
                _ => "tunnel",
            };
            let places = passage
                .stretches
                .iter()
                .step_by(4)
                .map(|it| format!("{:.0}", it.from));
            println!(
                "{square:?} {kind}: {}",
                places.collect::<Vec<_>>().join(" ")
            );
        }
    }
}
