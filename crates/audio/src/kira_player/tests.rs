//! What comes out at the end: the very samples that a device would get.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "tests fail by panicking"
)]

use std::sync::Mutex;

use kira::backend::Renderer;

use super::*;
use crate::director::Director;
use crate::studio::{Heard, PlayState};
use crate::volumes::Volumes;
use antipode_scene::{SoundEvent, Surroundings};
use antipode_terrain::Cover;

const RATE_HZ: u32 = 48_000;

/// Gives the renderer out, so that a test can draw samples from it.
struct Tap;

type Drain = Arc<Mutex<Option<Renderer>>>;

impl Backend for Tap {
    type Settings = Drain;
    type Error = String;

    fn setup(drain: Drain, _: usize) -> Result<(Self, u32), String> {
        DRAINS.with_borrow_mut(|waiting| waiting.push(drain));
        Ok((Self, RATE_HZ))
    }

    fn start(&mut self, renderer: Renderer) -> Result<(), String> {
        let drain = DRAINS.with_borrow_mut(Vec::pop).ok_or("no drain")?;
        *drain.lock().unwrap() = Some(renderer);
        Ok(())
    }
}

thread_local! {
    /// From `setup` to `start`, which kira calls one after the other.
    static DRAINS: std::cell::RefCell<Vec<Drain>> = const { std::cell::RefCell::new(Vec::new()) };
}

struct Bench {
    player: KiraPlayer<Tap>,
    director: Director,
    drain: Drain,
}

impl Bench {
    fn new(volumes: Volumes) -> Self {
        let drain = Drain::default();
        let mut player = KiraPlayer::<Tap>::new(Arc::clone(&drain), Arc::default()).unwrap();
        let mut director = Director::new(volumes);
        director.brief(&mut player);
        let mut bench = Self {
            player,
            director,
            drain,
        };
        // Volumes glide to where they are to be.
        bench.draw(0.5);
        bench
    }

    fn tell(&mut self, play_state: PlayState, surroundings: Surroundings, events: &[SoundEvent]) {
        let heard = Heard {
            play_state,
            surroundings: Some(surroundings),
            events: events.to_vec(),
        };
        self.director.hear(&heard, &mut self.player);
    }

    /// Root mean square and peak of the next moments.
    fn draw(&mut self, seconds: f64) -> (f32, f32) {
        let mut renderer = self.drain.lock().unwrap();
        let renderer = renderer.as_mut().expect("kira has started");
        let (mut squares, mut peak, mut count) = (0.0f64, 0.0f32, 0u32);
        for _ in 0..(seconds * f64::from(RATE_HZ) / 480.0) as u32 {
            let mut block = [0.0; 960];
            renderer.on_start_processing();
            renderer.process(&mut block, 2);
            for x in block {
                squares += f64::from(x * x);
                peak = peak.max(x.abs());
                count += 1;
            }
        }
        ((squares / f64::from(count)).sqrt() as f32, peak)
    }
}

fn full() -> Volumes {
    Volumes {
        master: 1.0,
        effects: 1.0,
        ambience: 1.0,
        music: 1.0,
        interface: 1.0,
    }
}

fn noon() -> Surroundings {
    Surroundings {
        day: 1.0,
        height_m: 5.0,
        relief_m: 30.0,
        speed_m_s: 0.0,
        drive: None,
    }
}

const STEP: SoundEvent = SoundEvent::Step {
    cover: Cover::Rock,
    speed_m_s: 5.0,
};

#[test]
fn a_step_is_heard_and_then_it_is_quiet_again() {
    let mut bench = Bench::new(full());
    assert_eq!(bench.draw(0.2).1, 0.0, "silence before");
    bench.tell(PlayState::Menu, noon(), &[STEP]);
    let (_, peak) = bench.draw(0.3);
    assert!((0.1..1.0).contains(&peak), "peak {peak}");
    assert_eq!(bench.draw(0.2).1, 0.0, "silence after");
}

#[test]
fn beds_go_on_for_longer_than_their_loops_and_do_not_drown_steps() {
    let mut bench = Bench::new(full());
    bench.tell(PlayState::World, noon(), &[]);
    bench.draw(0.5);
    let first = bench.draw(5.0).0;
    bench.draw(30.0);
    let later = bench.draw(5.0).0;
    assert!(
        first > 0.003 && later > 0.5 * first && later < 2.0 * first,
        "{first} {later}"
    );
    bench.tell(PlayState::World, noon(), &[STEP]);
    let step = bench.draw(0.08).0;
    assert!(step > 2.0 * later, "step {step}, bed {later}");
}

#[test]
fn each_slider_silences_its_own_group_and_muting_all() {
    let quiet = Volumes {
        effects: 0.0,
        ..full()
    };
    let mut bench = Bench::new(quiet);
    bench.tell(PlayState::Menu, noon(), &[STEP]);
    assert_eq!(bench.draw(0.3).1, 0.0);
    bench.tell(PlayState::Menu, noon(), &[SoundEvent::SlotChanged]);
    assert!(
        bench.draw(0.3).1 > 0.05,
        "the interface has a slider of its own"
    );
    bench.tell(PlayState::World, noon(), &[]);
    bench.draw(0.5);
    bench.director.set_muted(true, &mut bench.player);
    bench.draw(0.5);
    assert_eq!(bench.draw(0.5).1, 0.0);
    bench.director.set_muted(false, &mut bench.player);
    bench.draw(0.5);
    assert!(bench.draw(0.5).0 > 0.003);
}

#[test]
fn everything_at_once_stays_in_bounds() {
    let mut bench = Bench::new(full());
    let storm = Surroundings {
        height_m: 40.0,
        speed_m_s: 60.0,
        ..noon()
    };
    for _ in 0..200 {
        let landed = SoundEvent::Landed {
            cover: Cover::Rock,
            speed_m_s: 30.0,
        };
        bench.tell(
            PlayState::World,
            storm,
            &[STEP, landed, SoundEvent::Built, SoundEvent::Built],
        );
        bench.director.advance(0.02, &mut bench.player);
        let (_, peak) = bench.draw(0.02);
        assert!(peak <= 1.0 && peak.is_finite());
    }
}
