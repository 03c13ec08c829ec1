//! Edits and strokes: rates, limits, padding and both charts of the sphere.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::common::{Random, World, chunk, flat, sphere};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry, Strategy, strategy};
use antipode_terrain::{
    ChunkEdits, EDIT_LIMIT_M, EDIT_STEP, EditsError, Gate, Level, Part, Stroke,
};
use glam::{DVec2, DVec3};

fn stroke(pos: DVec3, radius_m: f64, amount: f32) -> Stroke {
    Stroke {
        centre: ChartPoint::a(pos),
        radius_m,
        amount,
        part: Part::Whole,
        kind: None,
        shape: antipode_terrain::Shape::Ball,
        power: None,
    }
}

#[test]
fn a_second_at_60_hz_digs_what_a_second_at_30_hz_does() {
    for (weight, radius) in [(1.0, 10.0), (3.0, 5.0), (5.0, 10.0)] {
        let [fast, slow] = [60_u8, 30].map(|rate| {
            let mut world = World::new(2, flat());
            let one = stroke(
                DVec3::new(16.3, 15.8, 15.9),
                radius,
                weight / f32::from(rate),
            );
            for _ in 0..rate {
                world.apply(&one);
            }
            world.edits[&chunk(ChartId::FIRST, 0, 0, 0)].clone()
        });
        for i in 6..27 {
            for j in 6..27 {
                let (a, b) = (fast.delta(i, j, 16), slow.delta(i, j, 16));
                assert!((a - b).abs() <= 0.03 * b.abs() + 1.1 * EDIT_STEP, "{a} {b}");
            }
        }
        assert!((fast.delta(16, 16, 16) - weight).abs() < 0.03 * weight);
    }
}

#[test]
fn changes_far_below_a_step_add_up() {
    let mut edits = ChunkEdits::new();
    for _ in 0..600 {
        edits.add(1, 2, 3, EDIT_STEP / 60.0);
    }
    assert!(
        (i16::abs(edits.get(1, 2, 3) - 10)) <= 1,
        "{}",
        edits.get(1, 2, 3)
    );
}

#[test]
fn edits_saturate_and_never_wrap() {
    let mut edits = ChunkEdits::new();
    for _ in 0..100 {
        edits.add(5, 5, 5, 3.0);
        edits.add(6, 5, 5, -3.0);
    }
    assert_eq!(edits.get(5, 5, 5), i16::MAX);
    assert_eq!(edits.get(6, 5, 5), -i16::MAX);
    edits.add(5, 5, 5, f32::INFINITY);
    edits.add(7, 5, 5, f32::NAN);
    assert_eq!(edits.delta(5, 5, 5), EDIT_LIMIT_M);
    assert_eq!(edits.get(7, 5, 5), 0);
    edits.add(5, 5, 5, -EDIT_LIMIT_M);
    assert_eq!(edits.get(5, 5, 5), 0, "and come back");
}

#[test]
fn bytes_round_trip_and_damaged_ones_are_refused_in_words() {
    let mut edits = ChunkEdits::new();
    assert!(edits.is_empty());
    edits.add(0, 0, 0, 1.0);
    edits.add(31, 30, 29, -2.0);
    assert!(!edits.is_empty());
    let bytes = edits.to_bytes();
    assert_eq!(bytes.len(), 65_536);
    let read = ChunkEdits::from_bytes(&bytes).unwrap();
    assert_eq!(read, edits);
    assert_eq!(read.get(31, 30, 29), -4096);
    assert_eq!(
        ChunkEdits::from_bytes(&bytes[1..]),
        Err(EditsError::OddBytes { found: 65_535 })
    );
    let short = ChunkEdits::from_units(&[1, 2, 3]).unwrap_err();
    assert!(short.to_string().contains("damaged"), "{short}");
    let lowest = ChunkEdits::from_units(&vec![i16::MIN; 32_768]).unwrap();
    assert_eq!(lowest.get(9, 9, 9), -i16::MAX);
}

#[test]
fn strokes_commute_with_padding() {
    let mut world = World::new(4, flat());
    let centre = DVec3::new(31.7, 16.2, 0.4);
    world.apply(&stroke(centre, 6.0, 2.0));
    let chunks = [(0, -1), (1, -1), (0, 0), (1, 0)].map(|(x, z)| chunk(ChartId::FIRST, x, 0, z));
    for coord in chunks {
        let before = world.field.samples(coord);
        let after = world.samples(coord);
        for i in 0..35 {
            for j in 0..35 {
                for k in 0..35 {
                    let p = coord.origin() + DVec3::new(i as f64, j as f64, k as f64) - 1.0;
                    let d2 = p.distance_squared(centre);
                    let expected = if d2 <= 36.0 {
                        2.0 * (-0.1 * d2).exp()
                    } else {
                        0.0
                    };
                    let found = f64::from(after.get(i, j, k) - before.get(i, j, k));
                    assert!((found - expected).abs() < f64::from(EDIT_STEP), "{p}");
                }
            }
        }
    }
}

/// The chunks of a window around the origin whose blocks a stroke changes, by looking.
fn changed_blocks(world: &mut World, one: &Stroke, all: &[ChunkCoord]) -> BTreeSet<ChunkCoord> {
    let before: Vec<_> = all.iter().map(|&c| world.samples(c)).collect();
    world.apply(one);
    let changed = all.iter().zip(before);
    changed
        .filter(|(c, before)| world.samples(**c) != *before)
        .map(|(c, _)| *c)
        .collect()
}

#[test]
fn remeshed_names_every_chunk_that_sees_a_change() {
    let mut all = Vec::new();
    for chart in [ChartId::FIRST, ChartId::SECOND] {
        for x in -2..2 {
            for z in -2..2 {
                all.push(chunk(chart, x, 0, z));
            }
        }
    }
    let mut random = Random(11);
    let (mut both, mut exact) = (0, 0);
    for n in 0..24 {
        let space = sphere();
        let rim = space.domain(ChartId::FIRST).radius_m().unwrap();
        let mut world = World::new(n, space.clone());
        let angle = random.between(0.0, std::f64::consts::TAU);
        let ground = DVec2::from_angle(angle) * random.between(rim - 30.0, rim + 0.2);
        let centre = DVec3::new(ground.x, random.between(6.0, 14.0), ground.y);
        let one = stroke(centre, random.between(1.0, 10.0), 4.0);
        let named: BTreeSet<_> = one.remeshed(&*space).into_iter().collect();
        let changed = changed_blocks(&mut world, &one, &all);
        assert!(changed.is_subset(&named), "{changed:?} {named:?}");
        exact += usize::from(all.iter().all(|c| named.contains(c) == changed.contains(c)));
        both += usize::from(changed.iter().any(|c| c.chart == ChartId::SECOND));
        let touched = one.touched(&*space);
        assert!(touched.is_sorted() && touched.iter().all(|c| named.contains(c)));
    }
    assert!(both >= 6, "only {both} strokes reached the other chart");
    assert!(exact >= 20, "only {exact} lists of 24 name nothing in vain");
}

/// Coarse borders reach farther: a stroke next door may turn a normal.
#[test]
fn coarse_chunks_that_see_a_change_are_named_too() {
    let mut random = Random(12);
    for level in Level::ALL {
        let mut beside = 0;
        for n in 0..24 {
            let space = flat();
            let mut world = World::new(n, space.clone());
            let all: Vec<_> = (0..27)
                .map(|c| chunk(ChartId::FIRST, c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1))
                .collect();
            let centre = DVec3::from([(); 3].map(|()| random.between(-2.0, 34.0)));
            let one = stroke(centre, random.between(1.0, 6.0), 4.0);
            let before: Vec<_> = all.iter().map(|&c| world.samples_at(c, level)).collect();
            world.apply(&one);
            let named = one.remeshed_at(&*space, level);
            for (coord, before) in all.iter().zip(before) {
                if world.samples_at(*coord, level) != before {
                    assert!(named.contains(coord), "{level:?} {coord:?} {centre}");
                    beside += usize::from(!one.touched(&*space).contains(coord));
                }
            }
        }
        assert!(
            beside > 6,
            "{level:?}: only {beside} chunks saw it from beside"
        );
    }
}

#[test]
fn both_charts_hold_the_same_hole() {
    let space = sphere();
    let rim = space.domain(ChartId::FIRST).radius_m().unwrap();
    let mut world = World::new(8, space.clone());
    let ground = DVec2::from_angle(0.9) * (rim - 1.5);
    let centre = DVec3::new(ground.x, 10.0, ground.y);
    world.apply(&stroke(centre, 8.0, 6.0));
    let mut compared = 0;
    for step in -30..=30 {
        for across in -3..=3 {
            let offset = DVec2::from_angle(0.9 + f64::from(across) * 0.03);
            let ground = offset * (rim + f64::from(step) * 0.2);
            let here = ChartPoint::a(DVec3::new(ground.x, 10.5, ground.y));
            let there = space.images(here, f64::INFINITY)[0].point;
            let [a, b] = [here, there].map(|p| {
                let coord = ChunkCoord::containing(p);
                world.samples(coord).density(p.pos - coord.origin())
            });
            // The charts' lattices differ, so their interpolations do, by a curvature's worth;
            // at the brush's cut-off, by a sample's.
            if here.pos.distance(centre) < 6.0 {
                assert!((a - b).abs() < 0.45, "{here:?}: {a} {b}");
                compared += 1;
            }
        }
    }
    assert!(compared > 100);
}

/// The list of columns that a stroke visits in the other chart must not be too short: every
/// sample there that the carrying map puts within the radius is looked at.
#[test]
fn a_stroke_misses_no_sample_of_the_other_chart() {
    let space = sphere();
    let rim = space.domain(ChartId::FIRST).radius_m().unwrap();
    for (from_rim, radius) in [(-2.0, 10.0), (-9.0, 10.0), (0.1, 4.0)] {
        let ground = DVec2::from_angle(2.2) * (rim + from_rim);
        let centre = DVec3::new(ground.x, 11.0, ground.y);
        let mut world = World::new(8, space.clone());
        world.apply(&stroke(centre, radius, 4.0));
        let mut within = 0;
        for x in -58..=58 {
            for z in -58..=58 {
                let p = DVec3::new(f64::from(x), 11.0, f64::from(z));
                let carried = space.images(ChartPoint::new(ChartId::SECOND, p), f64::INFINITY)[0];
                let d2 = carried.point.pos.distance_squared(centre);
                if d2 > radius * radius || p.length() > rim + 11.0 {
                    continue;
                }
                let coord = ChunkCoord::containing(ChartPoint::new(ChartId::SECOND, p));
                let [i, j, k] = (p - coord.origin()).to_array().map(|c| c as usize);
                let found = world.edits.get(&coord).map_or(0.0, |e| e.delta(i, j, k));
                let expected = (4.0 * (-0.1 * d2).exp()) as f32;
                assert!(
                    (found - expected).abs() < EDIT_STEP,
                    "{p}: {found} {expected}"
                );
                within += 1;
            }
        }
        assert!(within > 20, "{within}");
    }
}

#[test]
fn bedrock_stays_solid_and_the_sky_stays_open() {
    // Bedrock at 3.2 m, and at 2.9 m, just below a sample.
    for radius in [32.0, 29.0] {
        dig_and_build_as_far_as_it_goes(&strategy(Geometry::Spherical, radius));
    }
}

fn dig_and_build_as_far_as_it_goes(space: &Arc<dyn Strategy>) {
    let limits = space.limits().unwrap();
    let mut world = World::new(6, space.clone());
    for y in 0..12 {
        for _ in 0..20 {
            world.apply(&stroke(DVec3::new(4.0, f64::from(y), 5.0), 10.0, 5.0));
            let top = limits.ceiling_m + f64::from(y) - 6.0;
            world.apply(&stroke(DVec3::new(16.0, top, 16.0), 10.0, -5.0));
        }
    }
    assert!(limits.ceiling_m > 34.0 && limits.ceiling_m < 64.0);
    let low = world.samples(chunk(ChartId::FIRST, 0, 0, 0));
    let high = world.samples(chunk(ChartId::FIRST, 0, 1, 0));
    for n in 0..=32 {
        for m in 0..=16 {
            let at = |y| DVec3::new(f64::from(n), y, f64::from(m) * 2.0);
            assert!(low.density(at(limits.bedrock_m)) < 0.0);
            assert!(high.density(at(limits.ceiling_m - 32.0)) > 0.0);
        }
    }
    assert!(
        low.density(DVec3::new(4.0, limits.bedrock_m + 2.0, 5.0)) > 0.0,
        "dug to bedrock"
    );
    assert!(
        high.density(DVec3::new(16.0, limits.ceiling_m - 34.0, 16.0)) < 0.0,
        "built to the ceiling"
    );
}

#[test]
fn deep_ground_can_be_dug_and_high_air_be_built_in() {
    let mut world = World::new(1, flat());
    for (y, amount) in [(-300.5, 5.0 / 60.0), (300.5, -5.0 / 60.0)] {
        let here = DVec3::new(8.0, y, 8.0);
        for _ in 0..150 {
            world.apply(&stroke(here, 5.0, amount));
        }
        let coord = ChunkCoord::containing(ChartPoint::a(here));
        let value = world.samples(coord).density(here - coord.origin());
        assert_eq!(value > 0.0, amount > 0.0, "at {y}: {value}");
    }
}

#[test]
fn nonsense_strokes_do_nothing() {
    let space = sphere();
    for pos in [DVec3::splat(f64::NAN), DVec3::new(f64::INFINITY, 0.0, 0.0)] {
        assert!(stroke(pos, 5.0, 1.0).remeshed(&*space).is_empty());
    }
    assert!(
        stroke(DVec3::ZERO, f64::NAN, 1.0)
            .touched(&*space)
            .is_empty()
    );
    assert!(stroke(DVec3::Y * 8.0, 1e9, 1.0).touched(&*space).len() < 100);
    let mut edits = ChunkEdits::new();
    let coord = chunk(ChartId::FIRST, 0, 0, 0);
    assert!(!stroke(DVec3::Y * 8.0, 5.0, f32::NAN).apply(coord, &mut edits, &*space));
    assert!(edits.is_empty());
    let far = stroke(DVec3::new(1e30, 0.0, 1e30), 5.0, 1.0);
    assert!(far.touched(&*flat()).is_empty(), "past the last chunk");
}

/// A gate parts a stroke: what is reached through it and what is not are the whole, and have no sample in common.
#[test]
fn a_stroke_before_a_gate_and_through_it_are_the_whole_stroke() {
    let whole = stroke(DVec3::new(16.3, 15.2, 15.9), 6.0, 1.5);
    let gate = Gate {
        foot: DVec3::new(17.5, 14.0, 16.4),
        heading_rad: 0.6,
        half_width_m: 1.0,
        height_m: 2.2,
    };
    let edited = |part: Part| {
        let mut world = World::new(2, flat());
        world.apply(&Stroke { part, ..whole });
        world.edits[&chunk(ChartId::FIRST, 0, 0, 0)].clone()
    };
    let [all, before, through] = [Part::Whole, Part::Before(gate), Part::Through(gate)].map(edited);
    let mut counts = [0, 0];
    for i in 0..32 {
        for j in 0..32 {
            for k in 0..32 {
                let [all, a, b] = [&all, &before, &through].map(|it| it.get(i, j, k));
                assert!(a == 0 || b == 0);
                assert_eq!(a + b, all, "{i} {j} {k}");
                counts[0] += usize::from(a != 0);
                counts[1] += usize::from(b != 0);
            }
        }
    }
    assert!(counts[0] > 300 && counts[1] > 30, "{counts:?}");
    // Right behind the gate, beside it as far off, and above its lintel.
    for (at, is_through) in [
        ([19, 15, 17], true),
        ([17, 15, 20], false),
        ([17, 20, 17], false),
    ] {
        let [i, j, k] = at;
        assert_eq!(through.get(i, j, k) != 0, is_through, "{at:?}");
        assert_eq!(before.get(i, j, k) != 0, !is_through, "{at:?}");
    }
}
