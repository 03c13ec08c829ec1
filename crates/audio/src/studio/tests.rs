//! Devices that are not there, go and come back.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::cell::RefCell;
use std::rc::Rc;

use antipode_terrain::Cover;

use super::*;
use crate::player::{Bed, Voice};
use crate::volumes::Group;

/// A machine whose device can be pulled out.
#[derive(Clone, Default)]
struct Machine(Rc<RefCell<State>>);

#[derive(Default)]
struct State {
    plugged: bool,
    attempts: u32,
    heard: Recorder,
}

impl Player for Machine {
    fn play(&mut self, voice: Voice) {
        self.0.borrow_mut().heard.play(voice);
    }

    fn set_bed(&mut self, bed: Bed, gain: f32, rate: f32) {
        self.0.borrow_mut().heard.set_bed(bed, gain, rate);
    }

    fn set_group(&mut self, group: Group, gain: f32) {
        self.0.borrow_mut().heard.set_group(group, gain);
    }

    fn set_master(&mut self, gain: f32) {
        self.0.borrow_mut().heard.set_master(gain);
    }

    fn is_lost(&self) -> bool {
        !self.0.borrow().plugged
    }
}

impl Machine {
    fn plug(&self, plugged: bool) {
        let mut state = self.0.borrow_mut();
        state.plugged = plugged;
        // As loud as can be, until it is told how loud to be.
        state.heard = Recorder {
            master: 1.0,
            ..Recorder::default()
        };
    }

    fn studio(&self) -> Studio {
        let machine = self.clone();
        let open = move || -> Result<Box<dyn Player>, String> {
            let mut state = machine.0.borrow_mut();
            state.attempts += 1;
            if state.plugged {
                Ok(Box::new(machine.clone()))
            } else {
                Err("there is none".to_owned())
            }
        };
        Studio::new(Box::new(open), Volumes::default())
    }

    fn heard(&self) -> Recorder {
        self.0.borrow().heard.clone()
    }
}

fn step() -> Message {
    Message::Heard(Heard {
        play_state: PlayState::World,
        surroundings: Some(Surroundings {
            day: 1.0,
            height_m: 5.0,
            relief_m: 30.0,
            speed_m_s: 4.0,
            drive: None,
        }),
        events: vec![SoundEvent::Step {
            cover: Cover::Sand,
            speed_m_s: 4.0,
        }],
    })
}

#[test]
fn without_a_device_the_game_is_told_so_in_words_and_goes_on() {
    let machine = Machine::default();
    let mut studio = machine.studio();
    assert!(studio.advance(0.05));
    for _ in 0..100 {
        studio.take(step(), false);
        studio.advance(0.05);
    }
    assert!(
        studio.status().to_string().contains("there is none"),
        "{}",
        studio.status()
    );
    // Five seconds: at the start and once more.
    assert_eq!(machine.0.borrow().attempts, 2);
}

#[test]
fn a_device_that_comes_later_is_taken_and_told_what_lasts() {
    let machine = Machine::default();
    let mut studio = machine.studio();
    studio.advance(0.05);
    studio.take(step(), false);
    machine.plug(true);
    studio.advance(RETRY_S + 0.1);
    assert_eq!(studio.status(), &Status::Playing);
    let heard = machine.heard();
    assert!(heard.master > 0.0 && heard.beds[1].0 > 0.0, "{heard:?}");
    assert!(
        heard.voices.is_empty(),
        "what nobody could hear is not heard late"
    );
}

#[test]
fn a_device_that_goes_and_comes_back_plays_on() {
    let machine = Machine::default();
    machine.plug(true);
    let mut studio = machine.studio();
    studio.advance(0.05);
    studio.take(step(), false);
    assert_eq!(machine.heard().voices.len(), 1);
    machine.plug(false);
    studio.advance(0.05);
    assert_eq!(studio.status(), &Status::Lost);
    studio.take(step(), false);
    machine.plug(true);
    studio.advance(RETRY_S + 0.1);
    assert_eq!(studio.status(), &Status::Playing);
    assert!(machine.heard().beds[1].0 > 0.0);
    studio.take(step(), false);
    assert_eq!(machine.heard().voices.len(), 1);
}

#[test]
fn what_waited_while_a_device_was_opened_is_not_heard_all_at_once() {
    let machine = Machine::default();
    machine.plug(true);
    let mut studio = machine.studio();
    assert!(studio.advance(0.05));
    for _ in 0..50 {
        studio.take(step(), true);
        studio.take(Message::Cue(Cue::Pressed), true);
    }
    let heard = machine.heard();
    assert!(
        heard.voices.is_empty() && heard.beds[1].0 > 0.0,
        "{heard:?}"
    );
}

#[test]
fn muting_reaches_a_device_that_was_opened_after_it() {
    let machine = Machine::default();
    let mut studio = machine.studio();
    studio.advance(0.05);
    studio.take(Message::Muted(true), false);
    machine.plug(true);
    studio.advance(RETRY_S + 0.1);
    assert_eq!(machine.heard().master, 0.0);
}
