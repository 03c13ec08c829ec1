//! Lets one hear everything: `cargo run --release -p antipode-audio --example listen`.

use std::thread::sleep;
use std::time::Duration;

use antipode_audio::{Audio, Cue, Heard, PlayState, Status, Volumes};
use antipode_scene::{SoundEvent, Surroundings};
use antipode_terrain::Cover;

fn main() {
    let mut audio = Audio::start(Volumes::default());
    while audio.status() == &Status::Opening {
        sleep(Duration::from_millis(20));
    }
    println!("{}", audio.status());
    for cover in Cover::ALL {
        println!("{}", cover.name());
        let step = SoundEvent::Step {
            cover,
            speed_m_s: 4.3,
        };
        for _ in 0..6 {
            happen(&audio, 1.0, &[step]);
            sleep(Duration::from_millis(210));
        }
        happen(&audio, 1.0, &[SoundEvent::Dug { cover }]);
        sleep(Duration::from_millis(500));
        let speed_m_s = 12.0;
        happen(&audio, 1.0, &[SoundEvent::Landed { cover, speed_m_s }]);
        sleep(Duration::from_millis(700));
    }
    for (name, events) in [
        ("building", SoundEvent::Built),
        ("a slot", SoundEvent::SlotChanged),
    ] {
        println!("{name}");
        happen(&audio, 1.0, &[events]);
        sleep(Duration::from_millis(700));
    }
    for cue in [Cue::Moved, Cue::Pressed] {
        println!("{cue:?}");
        audio.cue(cue);
        sleep(Duration::from_millis(500));
    }
    println!("night, and music; {}", audio.status());
    happen(&audio, 0.0, &[]);
    sleep(Duration::from_secs(12));
    println!("{}", audio.status());
}

fn happen(audio: &Audio, day: f64, events: &[SoundEvent]) {
    audio.hear(Heard {
        play_state: PlayState::World,
        surroundings: Some(Surroundings {
            day,
            height_m: 10.0,
            relief_m: 30.0,
            speed_m_s: 0.0,
            drive: None,
        }),
        events: events.to_vec(),
    });
}
