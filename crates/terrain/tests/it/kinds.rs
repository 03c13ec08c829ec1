//! Kinds of ground: pure where nobody built, kept where somebody did, the same at every level and in every chunk.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry, strategy};
use antipode_terrain::{
    ChunkEdits, Field, Generator, Ground, Kind, Level, Part, Samples, Shape, Stroke, march,
};
use glam::{DVec3, IVec3, Vec3};

use crate::common::{Random, World, chunk, flat, sphere};

/// The kind byte of a vertex without what it says of the skin.
fn kind_of(byte: u8) -> Kind {
    Kind::of_byte(byte & 0x1f).unwrap()
}

fn build(pos: DVec3, kind: Option<Kind>) -> Stroke {
    Stroke {
        centre: ChartPoint::a(pos),
        radius_m: 4.0,
        amount: -14.0,
        part: Part::Whole,
        kind,
        shape: Shape::Ball,
        power: None,
    }
}

/// Applies a stroke as the game does, by what the ground is.
fn apply(world: &mut World, stroke: &Stroke) {
    let space = Arc::clone(world.field.strategy());
    for coord in stroke.touched(&*space) {
        let now = world.samples(coord);
        let ground = Ground {
            samples: &now,
            field: &world.field,
        };
        let edits = world.edits.entry(coord).or_default();
        stroke.apply_to(coord, Arc::make_mut(edits), &*space, Some(ground));
    }
}

#[test]
fn levels_and_chunks_agree_on_the_kind_of_every_sample_that_they_share() {
    for space in [flat(), sphere()] {
        let world = World::new(7, space);
        let here = chunk(ChartId::FIRST, 0, 0, 0);
        let field = &world.field;
        let full = field.samples(here);
        let mut compared = 0;
        for level in [Level::ALL[1], Level::ALL[3]] {
            let coarse = field.samples_at(here, level);
            for n in 0..5_usize.pow(3) {
                let at = [n / 25, n / 5 % 5, n % 5].map(|c| c * 8);
                let [i, j, k] = at.map(|c| c + 1);
                if full.get(i, j, k) < 0.0 {
                    let local = DVec3::from(at.map(|c| c as f64));
                    let kind =
                        |samples: &Samples| samples.kind_of_sample(field, here, local.as_ivec3());
                    assert_eq!(kind(&full), kind(&coarse), "{level:?} {local}");
                    compared += 1;
                }
            }
        }
        let beside = chunk(ChartId::FIRST, 1, 0, 0);
        let other = field.samples(beside);
        for n in 0..33_usize.pow(2) {
            let (y, z) = ((n / 33) as f64, (n % 33) as f64);
            if full.get(33, n / 33 + 1, n % 33 + 1) < 0.0 {
                let at = |x: f64| DVec3::new(x, y, z).as_ivec3();
                let a = full.kind_of_sample(field, here, at(32.0));
                let b = other.kind_of_sample(field, beside, at(0.0));
                assert_eq!(a, b, "{y} {z}");
                compared += 1;
            }
        }
        assert!(compared > 300, "{compared}");
    }
}

/// How often each kind is the solid end of an edge over chunks round the middle.
fn at_the_surface(field: &Field) -> BTreeMap<Kind, usize> {
    let mut counts = BTreeMap::new();
    for n in 0..50 {
        let coord = chunk(ChartId::FIRST, n % 5 - 2, n / 25, n / 5 % 5 - 2);
        for level in [Level::FULL, Level::ALL[3]] {
            for vertex in march(&field.samples_at(coord, level), field, coord).vertices {
                *counts.entry(kind_of(vertex.colour[3])).or_default() += 1;
            }
        }
    }
    counts
}

#[test]
fn ten_kinds_lie_at_the_surface_and_those_of_the_deep_do_not() {
    let mut seen = BTreeMap::new();
    for seed in 0..5 {
        let counts = at_the_surface(&Field::made_by(Generator::OneBiome, seed, flat()));
        assert!(counts.len() >= 4, "seed {seed}: {counts:?}");
        for (kind, count) in counts {
            assert!(!kind.is_deep(), "seed {seed}: {kind:?}");
            *seen.entry(kind).or_insert(0) += count;
        }
    }
    assert_eq!(seen.len(), 10, "{seen:?}");
    assert!(seen.values().all(|count| *count > 300), "{seen:?}");
}

/// The kinds of solid ground under a chart's middle with their depths below the surface, metres.
fn below(field: &Field) -> Vec<(Kind, f64)> {
    let mut found = Vec::new();
    for n in 0..64 {
        let coord = chunk(ChartId::FIRST, n % 8 - 4, 0, n / 8 - 4);
        let samples = field.samples(coord);
        for at in 0..8 * 32 * 8 {
            let local = DVec3::new(
                f64::from(at % 8 * 4),
                f64::from(at / 8 % 32),
                f64::from(at / 256 * 4),
            );
            let [i, j, k] = local.to_array().map(|c| c as usize + 1);
            let depth = f64::from(-samples.get(i, j, k));
            if depth > 0.0 {
                let kind = samples.kind_of_sample(field, coord, local.as_ivec3());
                found.push((kind, depth));
            }
        }
    }
    found
}

#[test]
fn the_deeper_an_ore_the_rarer_it_is() {
    for space in [flat(), sphere()] {
        for seed in 0..3 {
            let all = below(&Field::made_by(Generator::OneBiome, seed, space.clone()));
            let of = |kind: Kind| all.iter().filter(move |(it, _)| *it == kind);
            let ores = [Kind::Coal, Kind::Copper, Kind::Crystal];
            let counts = ores.map(|kind| of(kind).count());
            let least = ores.map(|kind| of(kind).map(|it| it.1).fold(f64::MAX, f64::min));
            assert!(counts.is_sorted_by(|a, b| a > b), "{seed} {counts:?}");
            assert!(
                counts[2] > 0 && least.is_sorted(),
                "{seed} {counts:?} {least:?}"
            );
            let share = counts.iter().sum::<usize>() as f64 / all.len() as f64;
            assert!((0.01..0.2).contains(&share), "{seed} {share}");
            assert!(of(Kind::Slate).count() > 100);
        }
    }
}

/// What a player is told who has dug deep and found none.
#[test]
fn coal_lies_under_about_half_of_the_land_and_within_thirty_metres_of_the_rest() {
    const STEP_M: i32 = 10;
    const SIDE: i32 = 21;
    for space in [flat(), strategy(Geometry::Spherical, 256.0)] {
        let (mut with, mut all, mut ways_m) = (0, 0, Vec::new());
        for seed in 40..44 {
            let field = Field::made_by(Generator::Climates, seed, space.clone());
            let mut known = BTreeMap::new();
            let half = SIDE * STEP_M / 2;
            let places =
                (0..SIDE * SIDE).map(|n| [n % SIDE, n / SIDE].map(|it| it * STEP_M - half));
            let found: Vec<_> = places
                .map(|place| (place, has_coal(&field, &mut known, place)))
                .collect();
            with += found.iter().filter(|(_, coal)| *coal).count();
            all += found.len();
            for (from, _) in found.iter().filter(|(_, coal)| !coal) {
                let way =
                    |to: [i32; 2]| f64::from(to[0] - from[0]).hypot(f64::from(to[1] - from[1]));
                let there = found.iter().filter(|(_, coal)| *coal);
                ways_m.push(there.map(|(to, _)| way(*to)).fold(f64::MAX, f64::min));
            }
        }
        let share = with as f64 / all as f64;
        ways_m.sort_by(f64::total_cmp);
        let [half, most] = [2, 10].map(|part| ways_m[ways_m.len() - 1 - ways_m.len() / part]);
        assert!((0.45..0.6).contains(&share), "{share}");
        assert!(half <= 15.0 && most <= 30.0, "{half} {most}");
    }
}

/// Whether whoever digs straight down in a column meets coal within a dozen metres.
fn has_coal(field: &Field, known: &mut BTreeMap<ChunkCoord, Samples>, [x, z]: [i32; 2]) -> bool {
    let (x, z) = (f64::from(x), f64::from(z));
    let y = field.surface_height(ChartId::FIRST, x, z).floor();
    (1..=12).any(|down| {
        let point = ChartPoint::a(DVec3::new(x, y - f64::from(down), z));
        let coord = ChunkCoord::containing(point);
        let samples = known.entry(coord).or_insert_with(|| field.samples(coord));
        let local = (point.pos - coord.origin()).as_ivec3();
        let [i, j, k] = local.to_array().map(|c| c as usize + 1);
        samples.get(i, j, k) < 0.0 && samples.kind_of_sample(field, coord, local) == Kind::Coal
    })
}

/// Clay that patches do not explain lies over copper: in forests patches are of moss.
#[test]
fn what_lies_at_the_surface_tells_of_the_copper_below() {
    let field = Field::made_by(Generator::OneBiome, 2, flat());
    let (mut with, mut without) = ([0_u32; 2], [0_u32; 2]);
    for n in 0..6400 {
        let (x, z) = (f64::from(n % 80 * 5 - 200), f64::from(n / 80 * 5 - 200));
        let y = field.surface_height(ChartId::FIRST, x, z).floor();
        let kind_at = |y: f64| {
            let point = ChartPoint::a(DVec3::new(x, y, z));
            let coord = ChunkCoord::containing(point);
            let local = point.pos - coord.origin();
            (field.sample(point) < 0.0).then(|| {
                field
                    .samples(coord)
                    .kind_of_sample(&field, coord, local.as_ivec3())
            })
        };
        let has = (5..12).any(|d| kind_at(y - f64::from(d)) == Some(Kind::Copper));
        let count = if kind_at(y) == Some(Kind::Clay) {
            &mut with
        } else {
            &mut without
        };
        count[usize::from(has)] += 1;
        if n > 1500 && with[1] > 20 {
            break;
        }
    }
    let share = |[no, yes]: [u32; 2]| f64::from(yes) / f64::from(no + yes);
    assert!(share(with) > 4.0 * share(without), "{with:?} {without:?}");
}

#[test]
fn only_what_turns_to_ground_is_laid_and_both_chunks_at_a_border_know_it() {
    let mut world = World::new(2, flat());
    let y = world.field.surface_height(ChartId::FIRST, 0.0, 5.0).round();
    let middle = DVec3::new(0.0, y + 2.0, 5.0);
    let before = world.field.clone();
    apply(&mut world, &build(middle, Some(Kind::Crystal)));
    let (mut laid, mut whole) = (0, 0);
    let sides = [-1, 0].map(|x| {
        let at = ChunkCoord::containing(ChartPoint::a(middle));
        chunk(ChartId::FIRST, x, at.index.y, at.index.z)
    });
    for coord in sides {
        let edits = world.edits[&coord].clone();
        let now = world.samples(coord);
        for n in 0..32_usize.pow(3) {
            let [i, j, k] = [n / 1024, n / 32 % 32, n % 32];
            let local = DVec3::new(i as f64, j as f64, k as f64);
            let point = ChartPoint::new(coord.chart, coord.origin() + local);
            let was = before.sample(point) < 0.0;
            let is = now.get(i + 1, j + 1, k + 1) < 0.0;
            assert_eq!(edits.kind_byte(i, j, k) != 0, is && !was, "{point:?}");
            laid += usize::from(is && !was);
            whole += usize::from(was);
        }
    }
    assert!(laid > 60 && whole > 1000, "{laid} {whole}");
    let here = |coord: ChunkCoord, world: &mut World| {
        let samples = world.samples(coord);
        let local = middle + DVec3::Y - coord.origin();
        samples.kind(&world.field, coord, local, Vec3::Y)
    };
    assert_eq!(
        sides.map(|coord| here(coord, &mut world)),
        [Kind::Crystal; 2]
    );
}

#[test]
fn built_anew_without_a_kind_old_bytes_go_and_dug_ground_keeps_what_is_below() {
    let mut world = World::new(2, flat());
    let y = world
        .field
        .surface_height(ChartId::FIRST, 16.0, 16.0)
        .round();
    let middle = DVec3::new(16.0, y + 3.0, 16.0);
    apply(&mut world, &build(middle, Some(Kind::Snow)));
    let coord = ChunkCoord::containing(ChartPoint::a(middle));
    assert!(
        world.edits[&coord]
            .kind_bytes()
            .contains(&Kind::Snow.byte())
    );
    let dig = Stroke {
        amount: 30.0,
        ..build(middle, None)
    };
    apply(&mut world, &dig);
    let back = Stroke {
        amount: -40.0,
        ..build(middle, None)
    };
    apply(&mut world, &back);
    let local = middle - coord.origin();
    let samples = world.samples(coord);
    assert!(samples.density(local) < 0.0);
    assert_ne!(
        samples.kind(&world.field, coord, local, Vec3::Y),
        Kind::Snow
    );
}

#[test]
fn kinds_of_later_games_are_shown_plain_and_keep_their_bytes() {
    let mut bytes = vec![0; 32 * 32 * 32];
    bytes[77] = 200;
    bytes[78] = Kind::Moss.byte();
    let edits = ChunkEdits::from_units(&vec![0; 32 * 32 * 32]).unwrap();
    assert!(!edits.has_unknown_kinds());
    let edits = edits.with_kind_bytes(&bytes).unwrap();
    assert!(edits.has_unknown_kinds());
    assert_eq!(edits.kind_bytes(), bytes);
    // Sample 77 of (i * 32 + k) * 32 + j.
    let coord = chunk(ChartId::FIRST, 0, -1, 0);
    let mut world = World::new(1, flat());
    world.edits.insert(coord, Arc::new(edits));
    let samples = world.samples(coord);
    let kind = |j: i32| samples.kind_of_sample(&world.field, coord, IVec3::new(0, j, 2));
    assert_eq!([kind(13), kind(14)], [Kind::PLAIN, Kind::Moss]);
    assert!(ChunkEdits::new().with_kind_bytes(&[1, 2]).is_err());
}

/// A stroke of each shape that digs or builds, and where it must have led the ground.
#[test]
fn bodies_come_out_as_they_are() {
    let middle = DVec3::new(16.0, -20.0, 16.0);
    for (shape, corner) in [(Shape::Box, true), (Shape::Cylinder, false)] {
        let mut world = World::new(2, flat());
        let dig = Stroke {
            amount: 30.0,
            shape,
            power: None,
            ..build(middle, None)
        };
        apply(&mut world, &dig);
        let mut random = Random(3);
        for _ in 0..3000 {
            let off = DVec3::from([(); 3].map(|()| random.between(-7.0, 7.0)));
            let aside = if corner {
                off.x.abs().max(off.z.abs())
            } else {
                off.x.hypot(off.z)
            };
            let inside = 4.0 - aside.max(off.y.abs());
            let point = ChartPoint::a(middle + off);
            let coord = ChunkCoord::containing(point);
            let density = world.samples(coord).density(point.pos - coord.origin());
            // Corners are cut by the grid.
            if inside.abs() > 0.8 {
                assert_eq!(density >= 0.0, inside > 0.0, "{shape:?} {off} {density}");
            }
        }
    }
}

#[test]
fn flattened_ground_is_flat_and_smoothed_ground_is_less_rough() {
    let space = strategy(Geometry::Euclidean, 20.0);
    let mut world = World::new(5, space);
    let y = world
        .field
        .surface_height(ChartId::FIRST, 16.0, 16.0)
        .round();
    let height_m = y + 0.4;
    let flatten = Stroke {
        amount: 30.0,
        shape: Shape::Flatten { height_m },
        power: None,
        ..build(DVec3::new(16.0, y, 16.0), None)
    };
    apply(&mut world, &flatten);
    for n in 0..25 {
        let (x, z) = (f64::from(n % 5) + 14.0, f64::from(n / 5) + 14.0);
        let density = |y: f64| {
            let point = ChartPoint::a(DVec3::new(x, y, z));
            let coord = ChunkCoord::containing(point);
            f64::from(world.edits.get(&coord).map_or(0.0, |edits| {
                let [i, j, k] = (point.pos - coord.origin()).to_array().map(|c| c as usize);
                edits.delta(i, j, k)
            })) + f64::from(world.field.sample(point))
        };
        for dy in -2..=2 {
            let at = y + f64::from(dy);
            assert!((density(at) - (at - height_m)).abs() < 0.01, "{x} {z} {dy}");
        }
    }
    let mut world = World::new(5, flat());
    let smooth = Stroke {
        amount: 30.0,
        radius_m: 8.0,
        shape: Shape::Smooth,
        power: None,
        ..build(DVec3::new(16.0, y, 16.0), None)
    };
    let rough = |world: &mut World| {
        let coord = ChunkCoord::containing(ChartPoint::a(DVec3::new(16.0, y, 16.0)));
        let samples = world.samples(coord);
        let bend = |[i, j, k]: [usize; 3]| {
            let ends = samples.get(i - 1, j, k) + samples.get(i + 1, j, k);
            (ends - 2.0 * samples.get(i, j, k)).abs()
        };
        let near = (0..125).map(|n| [14 + n / 25, 14 + n / 5 % 5, 14 + n % 5]);
        near.map(|at| f64::from(bend(at))).sum::<f64>()
    };
    let before = rough(&mut world);
    for _ in 0..3 {
        apply(&mut world, &smooth);
    }
    let after = rough(&mut world);
    assert!(after < 0.75 * before, "{before} {after}");
}
