//! What grows low: on which ground, and that it is the same whoever asks.

use std::collections::BTreeMap;
use std::sync::Arc;

use antipode_geometry::{CHUNK_CELLS, ChartId, ChartPoint, ChunkCoord, Geometry, strategy};
use antipode_plants::{Growth, undergrowth};
use antipode_terrain::{ChunkEdits, ChunkMesh, Field, Generator, Level, Tuft, apply_edits, march};
use glam::{DVec3, IVec3};

fn field(seed: u64) -> Field {
    Field::new(seed, strategy(Geometry::Euclidean, 0.0))
}

fn growth(tuft: &Tuft) -> Growth {
    Growth::of_byte(tuft.growth).unwrap()
}

/// The chunk that the ground over a place of the plan is in.
fn chunk_at(field: &Field, x: f64, z: f64) -> ChunkCoord {
    let y = field.surface_height(ChartId::FIRST, x, z);
    ChunkCoord::containing(ChartPoint::a(DVec3::new(x, y, z)))
}

fn mesh(field: &Field, coord: ChunkCoord) -> ChunkMesh {
    march(&field.samples(coord), field, coord)
}

/// Some chunks of the ground.
fn ground(field: &Field, chunks: i32) -> impl Iterator<Item = ChunkCoord> {
    let at = |n: i32| f64::from(n % 6 * 7 - 20) * f64::from(CHUNK_CELLS) + 16.0;
    (0..chunks).map(move |n| chunk_at(field, at(n), at(n / 6)))
}

/// What grows low on them.
fn on_ground(field: &Field, chunks: i32) -> Vec<(ChunkCoord, Tuft)> {
    let on = |coord: ChunkCoord| {
        let tufts = undergrowth(field, coord, &mesh(field, coord));
        tufts.into_iter().map(move |tuft| (coord, tuft))
    };
    ground(field, chunks).flat_map(on).collect()
}

#[test]
fn grass_grows_on_meadows_and_each_kind_somewhere() {
    let mut found: BTreeMap<Growth, usize> = BTreeMap::new();
    for seed in 3000..3008 {
        for (_, tuft) in on_ground(&field(seed), 36) {
            *found.entry(growth(&tuft)).or_default() += 1;
        }
    }
    println!("{found:?}");
    let open = Growth::ALL
        .into_iter()
        .filter(|it| !matches!(it, Growth::Crystal | Growth::Cobble));
    for growth in open {
        assert!(found.contains_key(&growth), "no {growth:?}");
    }
    assert!(!found.contains_key(&Growth::Cobble), "there are no squares");
    let most = found.values().max().unwrap();
    assert_eq!(found[&Growth::Grass], *most);
    // Of 2.25 places on a square metre; half the land bears none.
    let per_chunk = *most as f64 / (8.0 * 36.0);
    assert!((120.0..1400.0).contains(&per_chunk), "{per_chunk}");
}

#[test]
fn small_growth_stands_on_its_mesh_and_is_the_same_each_time() {
    let field = field(3010);
    let tufts = on_ground(&field, 12);
    assert_eq!(tufts, on_ground(&field, 12));
    assert!(tufts.len() > 500, "{}", tufts.len());
    for (coord, tuft) in &tufts {
        let pos = coord.origin() + tuft.root.as_dvec3();
        let at = field.sample(ChartPoint::new(coord.chart, pos));
        assert!(at.abs() < 0.4, "{pos}: {at}");
        assert!(tuft.ground[3] <= 6 && tuft.size >= 128);
    }
}

#[test]
fn caves_have_mushrooms_and_crystals_and_no_grass() {
    let mut found: BTreeMap<Growth, usize> = BTreeMap::new();
    for seed in 3020..3024 {
        let field = field(seed);
        let indices = (0..6)
            .flat_map(|x| (0..6).flat_map(move |z| (-2..2).map(move |y| IVec3::new(x, y, z))));
        for coord in indices.map(|index| ChunkCoord::new(ChartId::FIRST, index)) {
            for tuft in undergrowth(&field, coord, &mesh(&field, coord)) {
                if tuft.ground[3] <= 2 {
                    *found.entry(growth(&tuft)).or_default() += 1;
                }
            }
        }
    }
    println!("{found:?}");
    let kinds: Vec<_> = found.keys().copied().collect();
    assert_eq!(kinds, [Growth::Mushroom, Growth::Crystal]);
}

#[test]
fn nothing_grows_where_somebody_has_dug_nor_in_older_worlds_nor_on_coarse_land() {
    let field = field(3030);
    let (coord, tufts) = ground(&field, 36)
        .map(|coord| (coord, undergrowth(&field, coord, &mesh(&field, coord))))
        .max_by_key(|(_, tufts)| tufts.len())
        .unwrap();
    assert!(tufts.len() > 100);
    // A metre off all of it.
    let mut edits = ChunkEdits::new();
    let side = CHUNK_CELLS as usize;
    for (i, j, k) in
        (0..side).flat_map(|i| (0..side).flat_map(move |j| (0..side).map(move |k| (i, j, k))))
    {
        edits.add(i, j, k, 1.0);
    }
    let edits = Arc::new(edits);
    let mut samples = field.samples(coord);
    apply_edits(&mut samples, coord, |near| {
        (near == coord).then(|| Arc::clone(&edits))
    });
    let dug = march(&samples, &field, coord);
    let left = undergrowth(&field, coord, &dug).len();
    assert!(20 * left < tufts.len(), "{left} of {}", tufts.len());
    let coarse = march(&field.samples_at(coord, Level::ALL[1]), &field, coord);
    assert_eq!(undergrowth(&field, coord, &coarse), []);
    let old = Field::made_by(
        Generator::Climates,
        3030,
        strategy(Geometry::Euclidean, 0.0),
    );
    assert_eq!(undergrowth(&old, coord, &mesh(&old, coord)), []);
}
