//! Turns settings into options for the parts of the game, and keeps their file.

use std::fs;
use std::path::Path;
use std::time::Duration;

use antipode_geometry::HyperbolicMap;
use antipode_language::{Language, Texts};
use antipode_render::{Preset, ShadowQuality};
use antipode_scene::frame::{Frame, Quality};
use antipode_scene::{Scene, Viewing};
use antipode_settings::{Config, Map, Settings, Shadows, config_path};

use crate::failure::Failure;
use crate::text::read_short;

/// Longest a cap can be overrun so that a screen of the same rate is never missed by a hair, as a share.
const SLACK: f64 = 0.996;

/// The settings of a script: those of the file that the command line names, else the defaults. Never the player's
/// own, and nothing is written.
///
/// # Errors
/// When the file is named and cannot be read, or says what no setting takes.
pub fn for_script(file: Option<&Path>) -> Result<Config, Failure> {
    let Some(file) = file else {
        return Ok(Config::default());
    };
    let refused = |why: String| {
        Failure::Usage(format!(
            "The settings {} will not do: {why}",
            file.display()
        ))
    };
    let data = fs::metadata(file).map_err(|error| refused(error.to_string()))?;
    if !data.is_file() {
        return Err(refused("it is not a file".to_owned()));
    }
    let bytes = fs::File::open(file).and_then(read_short);
    let bytes = bytes.map_err(|error| refused(error.to_string()))?;
    let reading = antipode_settings::read(&bytes);
    if reading.condition == antipode_settings::Condition::Damaged {
        return Err(refused("it is damaged".to_owned()));
    }
    match reading.notices.first() {
        Some(notice) => Err(refused(notice.to_string())),
        None => Ok(reading.config),
    }
}

/// The player's own settings, or those of the file that the command line names.
pub fn for_player(file: Option<&Path>) -> antipode_settings::Opened {
    let opened = antipode_settings::open(config_path(file));
    for notice in &opened.notices {
        tracing::warn!("{notice}");
    }
    opened
}

/// How the world is to be seen.
pub fn viewing(settings: &Settings) -> Viewing {
    Viewing {
        fov_y_rad: settings.field_of_view_deg.to_radians(),
        contour_bands: settings.contour_bands,
        head_dip: settings.head_dip,
        wind: settings.wind,
        reduced_motion: settings.reduced_motion,
        safe_marker: settings.safe_marker,
    }
}

/// Gives a world what the player has chosen for all of them.
pub fn fit(scene: &mut Scene, settings: &Settings) {
    let viewing = viewing(settings);
    if scene.viewing() != viewing {
        scene.set_viewing(viewing);
    }
    scene.set_straight_shots(settings.straight_shots);
}

/// How much exactness pictures trade for speed.
pub fn quality(settings: &Settings) -> Quality {
    match settings.quality {
        antipode_settings::Quality::Fast => Quality::Fast,
        antipode_settings::Quality::Balanced => Quality::Balanced,
        antipode_settings::Quality::Exact => Quality::Exact,
    }
}

/// For what pictures are made; `software`: whether the processor draws.
pub fn preset(settings: &Settings, software: bool) -> Preset {
    if settings.preset.is_software(software) {
        Preset::Software
    } else {
        Preset::Card
    }
}

/// How shadows are drawn; `software`: whether pictures are made for the processor.
pub fn shadows(settings: &Settings, software: bool) -> ShadowQuality {
    match settings.shadows.resolved(software) {
        Shadows::Off => ShadowQuality::Off,
        Shadows::Auto | Shadows::Low => ShadowQuality::Low,
        Shadows::High => ShadowQuality::High,
    }
}

/// Takes the mirror out of a picture that is to have none; `software`: whether the processor draws.
pub fn fit_mirror(frame: &mut Frame, settings: &Settings, software: bool) {
    if !settings
        .rear_mirror
        .is_on(settings.preset.is_software(software))
    {
        frame.mirror = None;
    }
}

/// The map that new hyperbolic worlds begin with.
pub fn map(settings: &Settings) -> HyperbolicMap {
    match settings.hyperbolic_map {
        Map::Raised => HyperbolicMap::Raised,
        Map::Horizon => HyperbolicMap::Horizon,
    }
}

/// The texts in the language of the settings.
pub fn texts(settings: &Settings) -> Texts {
    let chosen = Language::from_id(settings.language.id());
    Texts::new(chosen.unwrap_or_else(Language::of_system))
}

/// Shortest time from frame to frame.
pub fn frame_time(settings: &Settings) -> Duration {
    let cap = settings.frame_cap.frames_per_s();
    cap.map_or(Duration::ZERO, |frames_per_s| {
        Duration::from_secs_f64(SLACK / f64::from(frames_per_s.max(1)))
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_scene::tuning::{FOV_Y_RAD, VIEW_DISTANCE_CHUNKS};
    use antipode_settings::{FrameCap, field};

    use super::*;

    #[test]
    fn the_defaults_are_what_the_game_is_made_for() {
        let settings = Settings::default();
        assert_eq!(viewing(&settings), Viewing::default());
        assert!((viewing(&settings).fov_y_rad - FOV_Y_RAD).abs() < 1e-15);
        assert_eq!(quality(&settings), Quality::default());
        assert_eq!(map(&settings), HyperbolicMap::default());
        let (least, most, usual) = VIEW_DISTANCE_CHUNKS;
        assert_eq!(settings.view_distance(true), usual);
        let range = field("view-distance").map(|field| field.kind);
        assert!(
            matches!(range, Some(antipode_settings::Kind::Slider { min, max, .. })
                if min < f64::from(least) && max == f64::from(most))
        );
        assert_eq!(frame_time(&settings), Duration::from_micros(16_600));
    }

    #[test]
    fn every_language_of_the_settings_is_spoken() {
        for language in Language::ALL {
            let mut settings = Settings::default();
            settings.set_word("language", language.id()).unwrap();
            assert_eq!(texts(&settings).language(), language);
        }
        assert_eq!(
            antipode_settings::Language::IDS.len(),
            Language::ALL.len() + 1
        );
    }

    #[test]
    fn without_a_limit_no_frame_waits() {
        let settings = Settings {
            frame_cap: FrameCap::None,
            ..Settings::default()
        };
        assert_eq!(frame_time(&settings), Duration::ZERO);
    }

    #[test]
    fn a_script_takes_the_file_it_is_given_and_no_other() {
        assert_eq!(for_script(None).unwrap(), Config::default());
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("x.ron");
        assert!(for_script(Some(&file)).is_err());
        fs::write(&file, "(schema: 1, settings: {\"field-of-view\": 90})").unwrap();
        let config = for_script(Some(&file)).unwrap();
        assert_eq!(config.settings.field_of_view_deg, 90.0);
        for (text, says) in [
            ("damage", "damaged"),
            ("(schema: 1, settings: {\"fog\": 1})", "fog"),
        ] {
            fs::write(&file, text).unwrap();
            let said = for_script(Some(&file)).unwrap_err().to_string();
            assert!(said.contains(says), "{said}");
            assert_eq!(
                fs::read_to_string(&file).unwrap(),
                text,
                "nothing is written"
            );
        }
        assert!(for_script(Some(dir.path())).is_err());
    }
}
