//! The table of settings: for each its name, its values, and how to get and set it by name.

use std::fmt;

use thiserror::Error;

use crate::choice::{
    FrameCap, Language, Map, Msaa, Preset, Quality, RearMirror, RenderScale, Shadows, words,
};
use crate::settings::Settings;

words! {
    /// The heading a setting stands under, by the key of its text.
    Group {
        /// Mouse and view.
        Look = "settings-group-look",
        /// How the picture is made.
        Picture = "settings-group-picture",
        /// What is shown of the world's space.
        World = "settings-group-world",
        /// How loud it is.
        Sound = "settings-group-sound",
        /// Gamepads.
        Pad = "settings-group-pad",
        /// What helps to see, read and bear it.
        Comfort = "settings-group-comfort",
    }
}

/// What values a setting takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// On or off.
    Toggle,
    /// A number.
    Slider {
        /// Smallest.
        min: f64,
        /// Largest.
        max: f64,
        /// What a slider moves by. Values between are allowed but for whole numbers.
        step: f64,
        /// Key of the unit's text, which is given the number as `$value`.
        unit_key: &'static str,
        /// Whether only whole numbers will do.
        whole: bool,
    },
    /// One of some words.
    Choice {
        /// The words of the file and of commands.
        options: &'static [&'static str],
    },
}

/// The value of a setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Of a toggle.
    Switch(bool),
    /// Of a slider.
    Number(f64),
    /// Of a choice.
    Choice(&'static str),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Switch(true) => f.pad("on"),
            Self::Switch(false) => f.pad("off"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Choice(word) => f.pad(word),
        }
    }
}

/// A value that somebody hands in and that is still to be checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given<'a> {
    /// For a toggle.
    Switch(bool),
    /// For a slider.
    Number(f64),
    /// For a choice.
    Word(&'a str),
}

impl From<Value> for Given<'static> {
    fn from(value: Value) -> Self {
        match value {
            Value::Switch(on) => Self::Switch(on),
            Value::Number(number) => Self::Number(number),
            Value::Choice(word) => Self::Word(word),
        }
    }
}

/// Why a setting does not take a value.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SetError {
    /// There is no such setting.
    #[error("there is no setting \"{id}\"")]
    Unknown {
        /// The name that was asked for.
        id: String,
    },
    /// A number out of range.
    #[error("{id} takes numbers from {min} to {max}, not {given}")]
    OutOfRange {
        /// The setting.
        id: &'static str,
        /// Smallest.
        min: f64,
        /// Largest.
        max: f64,
        /// What was given.
        given: f64,
    },
    /// Something else than the setting takes.
    #[error("{id} takes {takes}")]
    WrongKind {
        /// The setting.
        id: &'static str,
        /// What it takes, in words.
        takes: String,
    },
}

/// One setting of the table.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Its name in the file and in commands.
    pub id: &'static str,
    /// The heading it stands under.
    pub group: Group,
    /// What values it takes.
    pub kind: Kind,
    get: fn(&Settings) -> Value,
    /// Takes only what [`Field::checked`] lets through.
    put: fn(&mut Settings, Value),
}

impl Field {
    /// Key of the text that names it.
    pub fn label_key(&self) -> String {
        format!("setting-{}", self.id)
    }

    /// Key of the text that describes it.
    pub fn about_key(&self) -> String {
        format!("setting-{}-about", self.id)
    }

    /// Key of the text of one of its options.
    pub fn option_key(&self, option: &str) -> String {
        format!("setting-{}-{option}", self.id)
    }

    /// Its value.
    pub fn value(&self, settings: &Settings) -> Value {
        (self.get)(settings)
    }

    /// The value it has before anybody touches it.
    pub fn default_value(&self) -> Value {
        self.value(&Settings::default())
    }

    /// Gives it a value.
    ///
    /// # Errors
    /// [`SetError`] when it is of the wrong kind or out of range; nothing is changed then.
    pub fn assign(&self, settings: &mut Settings, given: Given<'_>) -> Result<(), SetError> {
        let value = self.checked(given)?;
        (self.put)(settings, value);
        Ok(())
    }

    pub(crate) fn assign_default(&self, settings: &mut Settings) {
        (self.put)(settings, self.default_value());
    }

    fn checked(&self, given: Given<'_>) -> Result<Value, SetError> {
        match (self.kind, given) {
            (Kind::Toggle, Given::Switch(on)) => Ok(Value::Switch(on)),
            (
                Kind::Slider {
                    min, max, whole, ..
                },
                Given::Number(number),
            ) => {
                if !(min..=max).contains(&number) {
                    return Err(SetError::OutOfRange {
                        id: self.id,
                        min,
                        max,
                        given: number,
                    });
                }
                if whole && number.fract() != 0.0 {
                    return Err(self.wrong_kind());
                }
                Ok(Value::Number(number))
            }
            (Kind::Choice { options }, Given::Word(word)) => options
                .iter()
                .find(|option| **option == word)
                .map(|option| Value::Choice(option))
                .ok_or_else(|| self.wrong_kind()),
            _ => Err(self.wrong_kind()),
        }
    }

    pub(crate) fn read_word<'a>(&self, word: &'a str) -> Result<Given<'a>, SetError> {
        match (self.kind, word) {
            (Kind::Toggle, "on" | "true") => Ok(Given::Switch(true)),
            (Kind::Toggle, "off" | "false") => Ok(Given::Switch(false)),
            (Kind::Toggle, _) => Err(self.wrong_kind()),
            (Kind::Slider { .. }, _) => word
                .parse()
                .map(Given::Number)
                .map_err(|_| self.wrong_kind()),
            (Kind::Choice { .. }, _) => Ok(Given::Word(word)),
        }
    }

    fn wrong_kind(&self) -> SetError {
        let takes = match self.kind {
            Kind::Toggle => "on or off".to_owned(),
            Kind::Slider {
                min, max, whole, ..
            } => {
                let numbers = if whole { "whole numbers" } else { "numbers" };
                format!("{numbers} from {min} to {max}")
            }
            Kind::Choice { options } => format!("one of {}", options.join(", ")),
        };
        SetError::WrongKind { id: self.id, takes }
    }
}

/// Every setting, in the order in which they are shown.
pub fn fields() -> &'static [Field] {
    &FIELDS
}

/// The setting of that name.
pub fn field(id: &str) -> Option<&'static Field> {
    FIELDS.iter().find(|field| field.id == id)
}

const fn slider(min: f64, max: f64, step: f64, unit_key: &'static str) -> Kind {
    Kind::Slider {
        min,
        max,
        step,
        unit_key,
        whole: false,
    }
}

/// A field that is on or off.
macro_rules! toggle {
    ($id:literal, $group:ident, $name:ident) => {
        Field {
            id: $id,
            group: Group::$group,
            kind: Kind::Toggle,
            get: |settings| Value::Switch(settings.$name),
            put: |settings, value| {
                if let Value::Switch(on) = value {
                    settings.$name = on;
                }
            },
        }
    };
}

/// A field that is a number.
macro_rules! number {
    ($id:literal, $group:ident, $name:ident, $kind:expr) => {
        Field {
            id: $id,
            group: Group::$group,
            kind: $kind,
            get: |settings| Value::Number(settings.$name),
            put: |settings, value| {
                if let Value::Number(number) = value {
                    settings.$name = number;
                }
            },
        }
    };
}

/// A field that is one of the words of an enumeration.
macro_rules! choice_of {
    ($id:literal, $group:ident, $name:ident, $words:ident) => {
        Field {
            id: $id,
            group: Group::$group,
            kind: Kind::Choice {
                options: $words::IDS,
            },
            get: |settings| Value::Choice(settings.$name.id()),
            put: |settings, value| {
                if let Value::Choice(word) = value
                    && let Some(chosen) = $words::from_id(word)
                {
                    settings.$name = chosen;
                }
            },
        }
    };
}

const PERCENT: Kind = slider(0.0, 100.0, 5.0, "unit-percent");

static FIELDS: [Field; 36] = [
    number!(
        "mouse-sensitivity",
        Look,
        mouse_sensitivity_deg_per_px,
        slider(0.01, 1.0, 0.01, "unit-degrees-per-pixel")
    ),
    toggle!("invert-look", Look, invert_look),
    number!(
        "field-of-view",
        Look,
        field_of_view_deg,
        slider(40.0, 110.0, 1.0, "unit-degrees")
    ),
    choice_of!("preset", Picture, preset, Preset),
    choice_of!("quality", Picture, quality, Quality),
    Field {
        id: "view-distance",
        group: Group::Picture,
        kind: Kind::Slider {
            min: 0.0,
            max: 16.0,
            step: 1.0,
            unit_key: "unit-chunks",
            whole: true,
        },
        get: |settings| Value::Number(f64::from(settings.view_distance_chunks)),
        put: |settings, value| {
            if let Value::Number(chunks) = value {
                settings.view_distance_chunks = chunks as u32;
            }
        },
    },
    choice_of!("render-scale", Picture, render_scale, RenderScale),
    choice_of!("msaa", Picture, msaa, Msaa),
    choice_of!("shadows", Picture, shadows, Shadows),
    choice_of!("frame-cap", Picture, frame_cap, FrameCap),
    toggle!("vsync", Picture, vsync),
    toggle!("fullscreen", Picture, fullscreen),
    number!(
        "curvature-step",
        World,
        curvature_step,
        slider(0.1, 5.0, 0.1, "unit-notch")
    ),
    choice_of!("hyperbolic-map", World, hyperbolic_map, Map),
    toggle!("contour-bands", World, contour_bands),
    toggle!("compass", World, compass),
    toggle!("minimap", World, minimap),
    choice_of!("rear-mirror", World, rear_mirror, RearMirror),
    toggle!("straight-shots", World, straight_shots),
    number!("volume-master", Sound, volume_master_pc, PERCENT),
    number!("volume-effects", Sound, volume_effects_pc, PERCENT),
    number!("volume-ambience", Sound, volume_ambience_pc, PERCENT),
    number!("volume-music", Sound, volume_music_pc, PERCENT),
    number!("volume-interface", Sound, volume_interface_pc, PERCENT),
    toggle!("mute-elsewhere", Sound, mute_elsewhere),
    number!(
        "pad-look-speed",
        Pad,
        pad_look_speed_deg_per_s,
        slider(30.0, 400.0, 10.0, "unit-degrees-per-second")
    ),
    toggle!("pad-invert-look", Pad, pad_invert_look),
    number!(
        "pad-dead-zone",
        Pad,
        pad_dead_zone_pc,
        slider(0.0, 50.0, 1.0, "unit-percent")
    ),
    choice_of!("language", Comfort, language, Language),
    number!(
        "ui-scale",
        Comfort,
        ui_scale,
        slider(0.5, 3.0, 0.1, "unit-times")
    ),
    toggle!("high-contrast", Comfort, high_contrast),
    toggle!("safe-marker", Comfort, safe_marker),
    toggle!("reduced-motion", Comfort, reduced_motion),
    toggle!("head-dip", Comfort, head_dip),
    toggle!("wind", Comfort, wind),
    toggle!("hints", Comfort, hints),
];

#[cfg(test)]
mod tests;
