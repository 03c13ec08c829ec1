//! One plan after another: what of an earlier one is kept, made, dropped or waits.

use super::*;
use crate::scheduler::wishing::{LEAST_SETTLED, SETTLED_SHARE};

#[test]
fn a_new_plan_is_carried_out_some_chunks_a_frame() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &wish_at(16.0, 4));
    make_all(&mut scheduler, 100);
    let there = scheduler.resident_count();
    scheduler.wish(&wish_at(16.0 + 3200.0, 4));
    let planned = scheduler.next_plan().unwrap().plan(&scheduler.field);
    let left = planned.changed.len();
    scheduler.planned(planned);
    let mut frames = Vec::new();
    while frames.iter().sum::<usize>() < there {
        assert!(scheduler.coming() > 0, "there is more to come");
        frames.push(scheduler.settle_some().len());
    }
    let most = LEAST_SETTLED.max(left / SETTLED_SHARE);
    assert!(
        frames.len() > 4 && frames.iter().all(|&gone| gone <= most),
        "{frames:?}"
    );
    while !scheduler.unsettled.is_empty() {
        assert!(scheduler.settle_some().is_empty());
    }
    make_all(&mut scheduler, 100);
    assert_as_planned(&scheduler);
}

#[test]
fn of_two_plans_one_after_the_other_the_second_holds() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &without_bodies(wish_with_rings(0, 2)));
    make_all(&mut scheduler, 7);
    for x in [4, 9, 1, 0, 6] {
        scheduler.wish(&without_bodies(wish_with_rings(x, 2)));
        let planned = scheduler.next_plan().unwrap().plan(&scheduler.field);
        scheduler.planned(planned);
        // The first frames of a plan, and then there is another already.
        for _ in 0..3 {
            scheduler.settle_some();
            for make in std::iter::from_fn(|| scheduler.next_load(2)).collect::<Vec<_>>() {
                scheduler.loaded(make, 0);
                assert!(widest_step(&scheduler) <= 1);
            }
        }
    }
    while !scheduler.unsettled.is_empty() {
        scheduler.settle_some();
    }
    make_all(&mut scheduler, 7);
    assert_as_planned(&scheduler);
    let targets = &scheduler.plan.targets;
    assert!(
        scheduler
            .resident
            .keys()
            .all(|coord| targets.contains_key(coord))
    );
}

#[test]
fn walking_to_and_fro_over_a_border_makes_nothing_again() {
    let mut scheduler = scheduler(&[]);
    let there = wish_with_rings(0, 2);
    let beyond = Wish {
        centre: ChartPoint::a(there.centre.pos + DVec3::X * 17.0),
        bodies: vec![Reach::around(
            ChartPoint::a(there.centre.pos + DVec3::X * 17.0),
            10.0,
        )],
        ..there.clone()
    };
    for wished in [&there, &beyond] {
        wish(&mut scheduler, wished);
        make_all(&mut scheduler, 5);
    }
    for wished in [&there, &beyond, &there, &beyond] {
        assert!(wish(&mut scheduler, wished).is_empty());
        assert_eq!(make_all(&mut scheduler, 5).0, 0);
    }
}

#[test]
fn what_waits_for_a_chunk_goes_on_when_that_is_there_no_more() {
    let mut scheduler = scheduler(&[]);
    wish(&mut scheduler, &without_bodies(wish_with_rings(-10, 2)));
    make_all(&mut scheduler, 5);
    // All is to be coarse now, but the chunks at x = -9 cannot be made, and hold up those beside
    // them. One load is never done, so that nobody goes on because all wait for each other.
    let coarse = without_bodies(wish_with_rings(0, 2));
    wish(&mut scheduler, &coarse);
    let unfinished = scheduler.next_load(1).unwrap().coord;
    assert!(unfinished.index.x > -8, "{unfinished:?}");
    while let Some(make) = scheduler.next_load(usize::MAX) {
        if make.coord.index.x == -9 {
            scheduler.give_up(make.coord);
        } else {
            scheduler.loaded(make, 0);
        }
    }
    let beside: Vec<_> = scheduler.resident.keys().copied().collect();
    let is_held = |coord: &ChunkCoord| {
        let west = chunk(-9, coord.index.y, coord.index.z);
        coord.index.x == -8 && scheduler.resident.contains_key(&west)
    };
    let held: Vec<_> = beside.into_iter().filter(is_held).collect();
    assert!(held.iter().any(|coord| scheduler.blocked.contains(coord)));

    let rings = Rings { x: 0, width: 2 };
    let detail: Arc<dyn Detail> = Arc::new(Vanishing { rings, gone: -9 });
    let gone = wish(
        &mut scheduler,
        &Wish {
            detail: Some(detail),
            ..coarse
        },
    );
    assert!(gone.iter().any(|coord| coord.index.x == -9));
    while let Some(make) = scheduler.next_load(usize::MAX) {
        scheduler.loaded(make, 0);
    }
    for coord in held {
        let target = scheduler.plan.targets[&coord];
        assert_eq!(scheduler.level(coord), Some(target.level), "{coord:?}");
    }
}

#[test]
fn air_around_a_body_is_known_to_be_ready_from_the_plan_until_something_is_built_there() {
    let mut scheduler = scheduler(&[]);
    let high = |x: f64| {
        let centre = ChartPoint::a(DVec3::new(x, 80.0, 16.0));
        Wish {
            bodies: vec![Reach::around(centre, 20.0)],
            ..Wish::new(centre, DVec3::X, 4)
        }
    };
    let mut most = 0;
    for step in 0..40 {
        let wished = high(16.0 + 32.0 * f64::from(step));
        wish(&mut scheduler, &wished);
        let under = ChunkCoord::containing(wished.centre);
        assert!(scheduler.plan.bare.contains(&under) && scheduler.is_ready(under));
        assert!(!scheduler.plan.bare.contains(&chunk(step, 0, 0)), "ground");
        most = most.max(scheduler.plan.bare.len());
    }
    assert!(most <= 64, "{most} chunks are remembered");
    let under = ChunkCoord::containing(high(16.0 + 32.0 * 39.0).centre);
    scheduler.batch_ended(&[under], &[under], 1);
    assert!(!scheduler.is_ready(under), "something is built there");
}
