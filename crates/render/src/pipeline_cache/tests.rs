//! Requests for pipelines, and when the thread makes them; the tests hold it back.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender};
use std::time::Duration;

use antipode_geometry::shader::{FLAT, HORIZON, RAISED, SPHERE};

use super::*;

/// Longest wait for the thread; a deadline for a hung one, not a measure of speed.
const PATIENCE: Duration = Duration::from_mins(1);

/// So long is held what nobody lets go.
const HELD: Duration = Duration::from_secs(20);

/// A map by its place among those of the game.
fn numbered(place: usize) -> Key {
    Key::whole([&FLAT, &RAISED, &SPHERE, &HORIZON][place])
}

/// A way of making that tells what it begins with and waits to be let go on.
fn slow() -> (Make<Key>, Receiver<Key>, Sender<()>) {
    let (tell, begun) = channel();
    let (go, wait) = channel::<()>();
    let wait = Mutex::new(wait);
    let make = move |key| {
        let _ = tell.send(key);
        let _ = wait.lock().unwrap().recv_timeout(HELD);
        Ok(key)
    };
    (Box::new(make), begun, go)
}

fn wait_until_made(pipeline_cache: &PipelineCache<Key>, key: Key) {
    let began = std::time::Instant::now();
    while !pipeline_cache.is_made(key) {
        assert!(began.elapsed() < PATIENCE, "{key:?} is never made");
        std::thread::sleep(Duration::from_millis(1));
    }
}

#[test]
fn who_asks_while_the_thread_is_at_work_is_answered_at_once_and_served_next() {
    let (make, begun, go) = slow();
    let mut pipeline_cache = PipelineCache::new(make);
    pipeline_cache.order_all();
    assert_eq!(begun.recv_timeout(PATIENCE), Ok(numbered(0)));
    // Were any of these to wait for the thread, what they tell would be made.
    assert_eq!(
        (
            pipeline_cache.get(numbered(0)),
            pipeline_cache.is_made(numbered(0))
        ),
        (None, false)
    );
    pipeline_cache.want(numbered(3));
    pipeline_cache.want(numbered(3));
    assert_eq!(pipeline_cache.get(numbered(3)), None);
    go.send(()).unwrap();
    assert_eq!(
        begun.recv_timeout(PATIENCE),
        Ok(numbered(3)),
        "what is wanted goes first"
    );
    wait_until_made(&pipeline_cache, numbered(0));
    assert_eq!(pipeline_cache.get(numbered(0)), Some(&numbered(0)));
    drop(go);
    wait_until_made(&pipeline_cache, numbered(3));
    assert_eq!(pipeline_cache.get(numbered(3)), Some(&numbered(3)));
}

#[test]
fn what_is_there_serves_until_what_comes_in_its_place_is_made() {
    let mut pipeline_cache = PipelineCache::new(Box::new(Ok));
    pipeline_cache.finish(numbered(1));
    let (make, begun, go) = slow();
    pipeline_cache.renew(make);
    pipeline_cache.want(numbered(1));
    assert_eq!(begun.recv_timeout(PATIENCE), Ok(numbered(1)));
    assert!(!pipeline_cache.turn(numbered(1)) && pipeline_cache.is_renewing());
    assert_eq!(pipeline_cache.get(numbered(1)), Some(&numbered(1)));
    drop(go);
    let began = std::time::Instant::now();
    while !pipeline_cache.turn(numbered(1)) {
        assert!(began.elapsed() < PATIENCE);
        std::thread::sleep(Duration::from_millis(1));
    }
    assert!(!pipeline_cache.is_renewing());
    assert_eq!(pipeline_cache.get(numbered(1)), Some(&numbered(1)));
    assert_eq!(
        pipeline_cache.get(numbered(0)),
        None,
        "those before are gone"
    );
}

#[test]
fn one_that_goes_no_new_way_after_all_makes_the_rest_as_before() {
    let mut pipeline_cache = PipelineCache::new(Box::new(Ok));
    pipeline_cache.order(numbered(0));
    wait_until_made(&pipeline_cache, numbered(0));
    pipeline_cache.renew(Box::new(|_| Err("refused".to_owned())));
    pipeline_cache.keep();
    pipeline_cache.want(numbered(2));
    wait_until_made(&pipeline_cache, numbered(2));
    assert_eq!(
        (pipeline_cache.get(numbered(2)), pipeline_cache.refused()),
        (Some(&numbered(2)), None)
    );
}

#[test]
fn where_the_thread_has_broken_off_the_asker_makes_it() {
    let made_here = std::thread::current().id();
    let make = move |key| {
        assert_eq!(std::thread::current().id(), made_here, "on purpose");
        Ok(key)
    };
    let mut pipeline_cache = PipelineCache::new(Box::new(make));
    pipeline_cache.order(numbered(0));
    let began = std::time::Instant::now();
    while !pipeline_cache.is_made(numbered(2)) {
        assert!(began.elapsed() < PATIENCE);
        pipeline_cache.want(numbered(2));
    }
    assert_eq!(pipeline_cache.get(numbered(2)), Some(&numbered(2)));
}

#[test]
fn one_map_cut_and_whole_is_two_and_the_name_tells_them_from_others() {
    static ANOTHER: MapShader = MapShader {
        name: "another",
        ..FLAT_AGAIN
    };
    const FLAT_AGAIN: MapShader = MapShader {
        name: "flat",
        text: "",
        daylight: &antipode_geometry::shader::OPEN,
        bends_depth: false,
        turns_to: None,
    };
    let pipeline_cache = PipelineCache::new(Box::new(Ok));
    let cut = Key {
        is_cut: true,
        ..numbered(0)
    };
    for (count, key) in [cut, numbered(0), Key::whole(&ANOTHER)]
        .into_iter()
        .enumerate()
    {
        assert!(!pipeline_cache.is_made(key));
        pipeline_cache.finish(key);
        assert_eq!(pipeline_cache.get(key), Some(&key));
        assert_eq!(pipeline_cache.list.slots().count(), count + 1);
    }
    assert!(pipeline_cache.is_made(cut));
}
