//! Who asks for pipelines, and when they are made, with a thread that is held back.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender};
use std::time::Duration;

use super::*;

/// Longest wait for the thread; a deadline for a hung one, not a measure of speed.
const PATIENCE: Duration = Duration::from_mins(1);

/// So long is held what nobody lets go.
const HELD: Duration = Duration::from_secs(20);

/// A way of making that tells what it begins with and waits to be let go on.
fn slow() -> (Make<u32>, Receiver<u32>, Sender<()>) {
    let (tell, begun) = channel();
    let (go, wait) = channel::<()>();
    let wait = Mutex::new(wait);
    let make = move |map| {
        let _ = tell.send(map);
        let _ = wait.lock().unwrap().recv_timeout(HELD);
        Ok(map)
    };
    (Box::new(make), begun, go)
}

fn wait_until_made(workshop: &Workshop<u32>, map: u32) {
    let began = std::time::Instant::now();
    while !workshop.is_made(map) {
        assert!(began.elapsed() < PATIENCE, "map {map} is never made");
        std::thread::sleep(Duration::from_millis(1));
    }
}

#[test]
fn who_asks_while_the_thread_is_at_work_is_answered_at_once_and_served_next() {
    let (make, begun, go) = slow();
    let mut workshop = Workshop::new(make);
    workshop.order_all();
    assert_eq!(begun.recv_timeout(PATIENCE), Ok(0));
    // Were any of these to wait for the thread, what they tell would be made.
    assert_eq!((workshop.get(0), workshop.is_made(0)), (None, false));
    workshop.want(3);
    workshop.want(3);
    assert_eq!(workshop.get(3), None);
    go.send(()).unwrap();
    assert_eq!(
        begun.recv_timeout(PATIENCE),
        Ok(3),
        "what is wanted goes first"
    );
    wait_until_made(&workshop, 0);
    assert_eq!(workshop.get(0), Some(&0));
    drop(go);
    wait_until_made(&workshop, 3);
    assert_eq!(workshop.get(3), Some(&3));
}

#[test]
fn what_is_there_serves_until_what_comes_in_its_place_is_made() {
    let mut workshop = Workshop::new(Box::new(Ok));
    workshop.finish(1);
    let (make, begun, go) = slow();
    workshop.renew(make);
    workshop.want(1);
    assert_eq!(begun.recv_timeout(PATIENCE), Ok(1));
    assert!(!workshop.turn(1) && workshop.is_renewing());
    assert_eq!(workshop.get(1), Some(&1));
    drop(go);
    let began = std::time::Instant::now();
    while !workshop.turn(1) {
        assert!(began.elapsed() < PATIENCE);
        std::thread::sleep(Duration::from_millis(1));
    }
    assert!(!workshop.is_renewing());
    assert_eq!(workshop.get(1), Some(&1));
    assert_eq!(workshop.get(0), None, "those before are gone");
}

#[test]
fn one_that_goes_no_new_way_after_all_makes_the_rest_as_before() {
    let mut workshop = Workshop::new(Box::new(Ok));
    workshop.order(0);
    wait_until_made(&workshop, 0);
    workshop.renew(Box::new(|_| Err("refused".to_owned())));
    workshop.keep();
    workshop.want(2);
    wait_until_made(&workshop, 2);
    assert_eq!((workshop.get(2), workshop.refused()), (Some(&2), None));
}

#[test]
fn where_the_thread_has_broken_off_the_asker_makes_it() {
    let made_here = std::thread::current().id();
    let make = move |map| {
        assert_eq!(std::thread::current().id(), made_here, "on purpose");
        Ok(map)
    };
    let mut workshop = Workshop::new(Box::new(make));
    workshop.order(0);
    let began = std::time::Instant::now();
    while !workshop.is_made(2) {
        assert!(began.elapsed() < PATIENCE);
        workshop.want(2);
    }
    assert_eq!(workshop.get(2), Some(&2));
}
