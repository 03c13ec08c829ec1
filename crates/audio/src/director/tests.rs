//! What is heard of what.

use super::*;
use crate::player::Recorder;

fn noon() -> Surroundings {
    Surroundings {
        day: 1.0,
        height_m: 10.0,
        relief_m: 30.0,
        speed_m_s: 0.0,
        drive: None,
    }
}

fn heard(play_state: PlayState, surroundings: Surroundings, events: &[SoundEvent]) -> Heard {
    Heard {
        play_state,
        surroundings: Some(surroundings),
        events: events.to_vec(),
    }
}

fn voices(events: &[SoundEvent]) -> Vec<Voice> {
    let (mut director, mut player) = (Director::new(Volumes::default()), Recorder::default());
    director.hear(&heard(PlayState::World, noon(), events), &mut player);
    player.voices
}

fn beds(play_state: PlayState, surroundings: Surroundings) -> [(f32, f32); BEDS] {
    let (mut director, mut player) = (Director::new(Volumes::default()), Recorder::default());
    director.hear(&heard(play_state, surroundings, &[]), &mut player);
    player.beds
}

fn step(cover: Cover, speed_m_s: f64) -> SoundEvent {
    SoundEvent::Step { cover, speed_m_s }
}

#[test]
fn each_ground_has_its_own_steps_and_no_step_is_the_one_before() {
    let events: Vec<_> = Cover::ALL
        .into_iter()
        .flat_map(|cover| [step(cover, 4.0), step(cover, 4.0), step(cover, 4.0)])
        .collect();
    let voices = voices(&events);
    for (of_cover, cover) in voices.chunks(3).zip(Cover::ALL) {
        for voice in of_cover {
            assert!(
                voice.sample.name().contains(cover.name()),
                "{cover:?}: {voice:?}"
            );
            assert_eq!(voice.group, Group::Effects);
        }
        assert_ne!(of_cover[0].sample, of_cover[1].sample);
        assert_ne!(of_cover[1].rate, of_cover[2].rate);
    }
}

#[test]
fn faster_steps_and_longer_falls_are_louder_and_a_hard_landing_sounds_so() {
    let landed = |speed_m_s| SoundEvent::Landed {
        cover: Cover::Soil,
        speed_m_s,
    };
    let heard = voices(&[
        step(Cover::Sand, 1.0),
        step(Cover::Sand, 7.0),
        landed(4.0),
        landed(14.0),
    ]);
    assert!(heard[1].gain > heard[0].gain && heard[3].gain > heard[2].gain);
    assert_eq!(
        (heard[2].sample.name(), heard[3].sample.name()),
        ("land-soft", "land-hard")
    );
    let absurd = voices(&[step(Cover::Sand, f64::NAN), landed(f64::INFINITY)]);
    assert!(
        absurd.iter().all(|voice| (0.0..=1.0).contains(&voice.gain)),
        "{absurd:?}"
    );
}

#[test]
fn what_is_taken_up_again_sounds_higher_than_what_is_put_down_and_no_two_shots_are_alike() {
    let item = antipode_scene::Item::ALL[0];
    let heard = voices(&[
        SoundEvent::PutDown(item),
        SoundEvent::TakenUp(item),
        SoundEvent::Shot,
        SoundEvent::Shot,
    ]);
    assert_eq!(heard[0].sample, heard[1].sample);
    assert!(heard[1].rate > 1.2 * heard[0].rate && heard[0].rate == 1.0);
    assert_ne!(heard[2].rate, heard[3].rate);
    assert_eq!(heard[2].gain, heard[3].gain);
}

#[test]
fn day_fades_over_into_night_at_the_same_power() {
    for tenth in 0..=10 {
        let day = f64::from(tenth) / 10.0;
        let [_, (light, _), (dark, _), ..] = beds(PlayState::World, Surroundings { day, ..noon() });
        let power = light * light + dark * dark;
        // Changes too small to hear are not passed on.
        assert!(
            (power - Sound::Day.gain(1.0).powi(2)).abs() < 1e-3,
            "{day}: {light} {dark}"
        );
        assert!(
            (light > dark) == (day > 0.5) || tenth == 5,
            "{day}: {light} {dark}"
        );
    }
}

#[test]
fn wind_grows_with_height_and_with_speed() {
    let wind = |height_m, speed_m_s| {
        let at = Surroundings {
            height_m,
            speed_m_s,
            ..noon()
        };
        beds(PlayState::World, at)[0].0
    };
    assert!(wind(28.0, 0.0) > 2.0 * wind(3.0, 0.0));
    assert!(wind(3.0, 30.0) > 2.0 * wind(3.0, 4.0));
    assert!(wind(1e9, 1e9) <= 1.0);
}

#[test]
fn an_engine_is_heard_in_a_car_alone_by_its_speed_and_pedal_and_tyres_where_they_slide() {
    let at = |drive: Option<Drive>| {
        let [.., engine, tyres] = beds(PlayState::World, Surroundings { drive, ..noon() });
        (engine, tyres)
    };
    let car = |throttle, speed_m_s, slide_m_s| {
        at(Some(Drive {
            throttle,
            speed_m_s,
            slide_m_s,
        }))
    };
    let (silent, still) = at(None);
    assert_eq!((silent.0, still.0), (0.0, 0.0));
    let (idle, quiet) = car(0.0, 0.0, 0.0);
    let (fast, _) = car(1.0, 28.0, 0.0);
    let (back, _) = car(-1.0, -9.0, 0.0);
    assert!(idle.0 > 0.05 && quiet.0 == 0.0, "{idle:?} {quiet:?}");
    assert!(
        fast.0 > 2.0 * idle.0 && fast.1 > 2.0 * idle.1,
        "{fast:?} {idle:?}"
    );
    assert!(back.1 > idle.1 && back.1 < fast.1, "{back:?}");
    let (_, squeals) = car(0.0, 20.0, 8.0);
    assert!(squeals.0 > 0.2, "{squeals:?}");
    let (absurd, tyres) = car(f64::NAN, f64::INFINITY, 1e9);
    assert!(absurd.0 <= 1.0 && absurd.1.is_finite() && tyres.0 <= 1.0);
}

#[test]
fn deep_pits_hear_no_birds() {
    let pit = Surroundings {
        height_m: -20.0,
        ..noon()
    };
    assert_eq!(beds(PlayState::World, pit)[1].0, 0.0);
}

#[test]
fn the_world_is_hushed_behind_the_pause_menu_and_silent_in_the_main_menu() {
    let (mut director, mut player) = (Director::new(Volumes::default()), Recorder::default());
    director.hear(&heard(PlayState::World, noon(), &[]), &mut player);
    let loud = player.beds[1].0;
    director.hear(&heard(PlayState::Paused, noon(), &[]), &mut player);
    let hushed = player.beds[1].0;
    director.hear(&heard(PlayState::Menu, noon(), &[]), &mut player);
    assert!(0.0 < hushed && hushed < 0.5 * loud);
    assert!(
        player.beds.iter().all(|(gain, _)| *gain == 0.0),
        "{:?}",
        player.beds
    );
}

#[test]
fn muting_silences_all_and_the_volumes_come_back() {
    let (mut director, mut player) = (Director::new(Volumes::default()), Recorder::default());
    director.brief(&mut player);
    let before = player.clone();
    director.set_muted(true, &mut player);
    assert_eq!(player.master, 0.0);
    // A slider that is moved while nobody is to hear anything does not end that.
    director.set_volumes(Volumes::default(), &mut player);
    assert_eq!(player.master, 0.0);
    director.set_muted(false, &mut player);
    assert_eq!(player, before);
    assert!(before.master > 0.0);
}

#[test]
fn who_plays_anew_is_told_everything_that_lasts() {
    let (mut director, mut first) = (Director::new(Volumes::default()), Recorder::default());
    director.brief(&mut first);
    director.hear(&heard(PlayState::World, noon(), &[]), &mut first);
    let mut second = Recorder::default();
    director.brief(&mut second);
    assert_eq!(second, first);
    assert!(second.beds[1].0 > 0.0);
}

#[test]
fn music_plays_in_the_menu_too() {
    let (mut director, mut player) = (Director::new(Volumes::default()), Recorder::default());
    for _ in 0..200 {
        director.advance(0.05, &mut player);
    }
    assert!(
        player
            .voices
            .iter()
            .any(|voice| voice.group == Group::Music)
    );
}
