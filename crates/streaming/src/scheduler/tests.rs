//! The scheduler without threads: every job ends when the test says so.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "tests fail by panicking"
)]

mod plans;
mod views;

use super::*;
use crate::api::{Detail, Reach, Wish};
use crate::levels::faces;
use antipode_geometry::{ChartId, ChartPoint, Geometry, strategy};
use glam::{DVec3, IVec3};
use views::{Rings, Vanishing};

fn scheduler(edited: &[ChunkCoord]) -> ChunkScheduler {
    let space = strategy(Geometry::Euclidean, f64::INFINITY);
    let field = Arc::new(Field::new(3, space.clone()));
    ChunkScheduler::new(field, space, edited.iter().copied().collect())
}

fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
    ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(x, y, z),
    }
}

fn wish_at(x: f64, view_distance: u32) -> Wish {
    let centre = ChartPoint::a(DVec3::new(x, 16.0, 16.0));
    Wish::new(centre, DVec3::X, view_distance)
}

fn full(coord: ChunkCoord) -> Make {
    Make {
        coord,
        level: Level::FULL,
        solid: true,
    }
}

fn take_all(scheduler: &mut ChunkScheduler) -> Vec<ChunkCoord> {
    std::iter::from_fn(|| scheduler.next_load(usize::MAX))
        .map(|make| make.coord)
        .collect()
}

/// Wishes, and carries the plan out; returns the chunks that are gone.
fn wish(scheduler: &mut ChunkScheduler, wish: &Wish) -> Vec<ChunkCoord> {
    scheduler.wish(wish);
    let Some(request) = scheduler.next_plan() else {
        return Vec::new();
    };
    let planned = request.plan(&scheduler.field);
    scheduler.planned(planned);
    scheduler.settle_all()
}

#[test]
fn going_there_and_back_neither_loses_nor_doubles_a_chunk() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_at(16.0, 1));
    let first = take_all(&mut scheduler);
    wish(&mut scheduler, &wish_at(16.0 + 96.0, 1));
    wish(&mut scheduler, &wish_at(16.0, 1));
    assert!(
        take_all(&mut scheduler)
            .iter()
            .all(|coord| !first.contains(coord)),
        "a chunk is made twice"
    );
    assert!(
        first
            .iter()
            .all(|&coord| scheduler.loaded(full(coord), 0) == Verdict::Show)
    );
    assert_eq!(scheduler.resident_count(), first.len());
}

#[test]
fn one_chunk_beyond_is_kept_and_two_are_not() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_at(16.0, 1));
    let first = take_all(&mut scheduler);
    for &coord in &first {
        assert_eq!(scheduler.loaded(full(coord), 0), Verdict::Show);
    }
    assert!(wish(&mut scheduler, &wish_at(16.0 + 32.0, 1)).is_empty());
    let gone = wish(&mut scheduler, &wish_at(16.0 + 64.0, 1));
    let want: Vec<_> = first.iter().filter(|coord| coord.index.x == -1).collect();
    assert!(
        !want.is_empty()
            && gone.len() == want.len()
            && gone.iter().all(|coord| coord.index.x == -1)
    );
}

#[test]
fn a_load_older_than_a_shown_batch_is_made_again() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_at(16.0, 1));
    let coord = take_all(&mut scheduler)[0];
    scheduler.batch_ended(&[coord], &[coord], 1);
    assert_eq!(scheduler.loaded(full(coord), 0), Verdict::Drop);
    assert_eq!(take_all(&mut scheduler), [coord]);
    assert_eq!(scheduler.loaded(full(coord), 1), Verdict::Show);
}

#[test]
fn a_load_newer_than_what_is_shown_waits_for_its_batch() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_at(16.0, 1));
    let coords = take_all(&mut scheduler);
    assert_eq!(scheduler.loaded(full(coords[0]), 1), Verdict::Hold);
    scheduler.batch_ended(&[coords[1]], &[coords[1]], 1);
    assert_eq!(scheduler.loaded(full(coords[0]), 1), Verdict::Show);
}

#[test]
fn a_stored_edit_gives_a_chunk_without_a_surface_a_mesh() {
    let sky = chunk(0, 60, 0);
    let mut plain = scheduler(&[]);
    let mut built = scheduler(&[sky]);
    let there = Wish::new(ChartPoint::a(sky.origin()), DVec3::X, 2);
    wish(&mut plain, &there);
    wish(&mut built, &there);
    assert!(plain.is_resident(sky) && plain.coming() == 0);
    assert!(!built.is_resident(sky));
    // Its own cells, and those of the seven chunks whose last layer uses its first samples.
    assert_eq!(take_all(&mut built).len(), 8);
}

fn wish_with_rings(x: i32, width: i32) -> Wish {
    let centre = ChartPoint::a(DVec3::new(f64::from(x) * 32.0 + 16.0, 16.0, 16.0));
    Wish {
        bodies: vec![Reach::around(centre, 10.0)],
        detail: Some(Arc::new(Rings { x, width })),
        ..Wish::new(centre, DVec3::X, 8)
    }
}

/// Ground under bodies waits for no neighbour.
fn without_bodies(wish: Wish) -> Wish {
    Wish {
        bodies: Vec::new(),
        ..wish
    }
}

/// Greatest difference of level between neighbours that are there.
fn widest_step(scheduler: &ChunkScheduler) -> usize {
    let steps = scheduler.resident.iter().flat_map(|(&coord, shown)| {
        let beside =
            faces(&*scheduler.strategy, coord).filter_map(|next| scheduler.resident.get(&next));
        beside.map(|next| next.level.index().abs_diff(shown.level.index()))
    });
    steps.max().unwrap_or(0)
}

/// Makes what is asked for until nothing is, `at_once` chunks at a time and the last of them first;
/// returns how many were made and the widest step seen after all of the first pass were there.
fn make_all(scheduler: &mut ChunkScheduler, at_once: usize) -> (usize, usize) {
    let (mut made, mut widest) = (0, 0);
    loop {
        let makes: Vec<_> = std::iter::from_fn(|| scheduler.next_load(at_once)).collect();
        if makes.is_empty() {
            return (made, widest);
        }
        for make in makes.into_iter().rev() {
            scheduler.loaded(make, 0);
            made += 1;
            widest = widest.max(widest_step(scheduler));
        }
    }
}

fn assert_as_planned(scheduler: &ChunkScheduler) {
    let wanted = scheduler
        .plan
        .targets
        .iter()
        .filter(|(_, target)| target.wanted);
    for (&coord, target) in wanted {
        assert_eq!(scheduler.level(coord), Some(target.level), "{coord:?}");
    }
    assert_eq!(scheduler.coming(), 0);
}

#[test]
fn levels_follow_the_eye_and_neighbours_are_never_two_apart() {
    for at_once in [1, 7, 10_000] {
        let mut scheduler = scheduler(&[]);
        for x in [0, 1, 2, 9, 3, -20, 0] {
            wish(&mut scheduler, &without_bodies(wish_with_rings(x, 2)));
            let (made, widest) = make_all(&mut scheduler, at_once);
            assert!(
                made > 0 && widest <= 1,
                "{at_once} {x}: {made} made, {widest} apart"
            );
            assert_as_planned(&scheduler);
        }
    }
}

#[test]
fn a_plan_that_comes_while_chunks_are_made_is_carried_out_all_the_same() {
    let mut scheduler = scheduler(&[]);
    for x in 0..40 {
        wish(
            &mut scheduler,
            &without_bodies(wish_with_rings(x % 13, 1 + x % 3)),
        );
        for make in (0..9)
            .map_while(|_| scheduler.next_load(9))
            .collect::<Vec<_>>()
        {
            scheduler.loaded(make, 0);
            assert!(widest_step(&scheduler) <= 1);
        }
    }
    make_all(&mut scheduler, 5);
    assert_as_planned(&scheduler);
}

#[test]
fn a_chunk_that_cannot_be_made_holds_nobody_up_for_ever() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_with_rings(0, 1));
    make_all(&mut scheduler, 5);
    wish(&mut scheduler, &wish_with_rings(6, 1));
    let broken = scheduler.next_load(5).map(|make| make.coord).unwrap();
    scheduler.give_up(broken);
    make_all(&mut scheduler, 5);
    assert_eq!(scheduler.coming(), 0);
    assert!(scheduler.is_ready(broken));
}

#[test]
fn ground_is_solid_where_bodies_are_and_for_a_while_where_they_were() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_with_rings(0, 2));
    make_all(&mut scheduler, 5);
    let solid = |scheduler: &ChunkScheduler| {
        let solid = scheduler.resident.iter().filter(|(_, shown)| shown.solid);
        solid
            .map(|(coord, _)| coord.index.x)
            .collect::<std::collections::BTreeSet<_>>()
    };
    assert_eq!(solid(&scheduler), [0].into());
    assert!(
        scheduler.wish(&wish_with_rings(1, 2)).is_empty(),
        "half a chunk beyond it is kept"
    );
    let planned = scheduler.next_plan().unwrap().plan(&scheduler.field);
    scheduler.planned(planned);
    scheduler.settle_all();
    make_all(&mut scheduler, 5);
    assert_eq!(solid(&scheduler), [0, 1].into());
    let left = scheduler.wish(&wish_with_rings(3, 2));
    assert!(!left.is_empty() && left.iter().all(|coord| coord.index.x < 2));
}

#[test]
fn ground_that_a_body_comes_to_is_not_ready_before_it_is_solid() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_with_rings(0, 3));
    make_all(&mut scheduler, 5);
    let there = wish_with_rings(2, 3);
    let under = ChunkCoord::containing(there.centre);
    assert!(scheduler.is_ready(under) && scheduler.level(under) == Some(Level::FULL));
    scheduler.wish(&there);
    assert!(
        !scheduler.is_ready(under) && scheduler.is_coming(under) && scheduler.is_ground_coming()
    );
    let make = scheduler.next_load(5).unwrap();
    assert!(make.solid && make.level == Level::FULL);
    assert_eq!(scheduler.loaded(make, 0), Verdict::Harden);
    assert!(scheduler.is_ready(make.coord));
}

#[test]
fn an_edit_is_shown_at_the_level_the_chunk_has() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_with_rings(0, 2));
    make_all(&mut scheduler, 5);
    let coarse = |coord: &&ChunkCoord| scheduler.level(**coord) == Some(Level::ALL[2]);
    let coord = *scheduler.resident.keys().filter(coarse).min().unwrap();
    let makes = scheduler.begin_batch([coord].into_iter());
    assert_eq!((makes[0].level, makes[0].solid), (Level::ALL[2], false));
    // Nothing of the batch changes its level before it has ended.
    wish(&mut scheduler, &wish_with_rings(coord.index.x, 2));
    while let Some(make) = scheduler.next_load(100) {
        assert_ne!(make.coord, coord);
        scheduler.loaded(make, 0);
    }
    scheduler.batch_ended(&[coord], &[coord], 1);
    assert!(scheduler.show_edited(makes[0]));
    assert_eq!(scheduler.level(coord), Some(Level::ALL[2]));
    // What was dug may be lost at a coarser level: with its next plan it is as fine as that takes.
    let planned = scheduler.next_plan().unwrap().plan(&scheduler.field);
    scheduler.planned(planned);
    scheduler.settle_all();
    make_all_at(&mut scheduler, 1);
    assert_eq!(scheduler.level(coord), Some(Level::FULL));
}

fn make_all_at(scheduler: &mut ChunkScheduler, revision: u64) {
    while let Some(make) = scheduler.next_load(100) {
        scheduler.loaded(make, revision);
    }
}
