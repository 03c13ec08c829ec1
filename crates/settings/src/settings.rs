//! The settings as typed values. Ranges and words are in the table of [`crate::fields`].

use crate::choice::{
    FrameCap, Language, Map, Msaa, Preset, Quality, RearMirror, RenderScale, Shadows,
};
use crate::field::{Field, Given, SetError, Value, field};

/// What the player has chosen. Every value here is within the range of its field.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Turn of the view for a pixel of mouse motion, degrees.
    pub mouse_sensitivity_deg_per_px: f64,
    /// Whether moving the mouse away looks down.
    pub invert_look: bool,
    /// Vertical field of view, degrees.
    pub field_of_view_deg: f64,
    /// How far land is loaded, in chunks of 32 m; 0 leaves it to [`Settings::view_distance`].
    pub view_distance_chunks: u32,
    /// For what pictures are made.
    pub preset: Preset,
    /// How much exactness pictures trade for speed.
    pub quality: Quality,
    /// Most frames a second.
    pub frame_cap: FrameCap,
    /// Whether pictures wait for the screen.
    pub vsync: bool,
    /// How edges are smoothed.
    pub msaa: Msaa,
    /// How shadows of the sun and the moon are drawn.
    pub shadows: Shadows,
    /// Share of the window's resolution that is drawn.
    pub render_scale: RenderScale,
    /// Size of texts and buttons, 1 being the system's.
    pub ui_scale: f64,
    /// Whether the window fills the screen.
    pub fullscreen: bool,
    /// Change of the curvature dial for a notch of the wheel.
    pub curvature_step: f64,
    /// The map that new hyperbolic worlds are seen through.
    pub hyperbolic_map: Map,
    /// Whether lines of equal height are drawn on the land.
    pub contour_bands: bool,
    /// Whether the display has a compass.
    pub compass: bool,
    /// Whether the display has a map of the land about the player.
    pub minimap: bool,
    /// Whether there is a mirror over the view from a car's bonnet.
    pub rear_mirror: RearMirror,
    /// Whether bullets follow the space's geodesics instead of falling.
    pub straight_shots: bool,
    /// Volume of everything together, percent.
    pub volume_master_pc: f64,
    /// Volume of steps, landings and tools, percent.
    pub volume_effects_pc: f64,
    /// Volume of wind, day and night, percent.
    pub volume_ambience_pc: f64,
    /// Volume of the music, percent.
    pub volume_music_pc: f64,
    /// Volume of menus and the hotbar, percent.
    pub volume_interface_pc: f64,
    /// Whether it is silent while another window has the keyboard.
    pub mute_elsewhere: bool,
    /// Turn of the view with a stick of a gamepad all the way over, degrees a second.
    pub pad_look_speed_deg_per_s: f64,
    /// Whether moving that stick away looks down.
    pub pad_invert_look: bool,
    /// Share of a stick's way around its middle that counts as rest, percent.
    pub pad_dead_zone_pc: f64,
    /// Whether the view dips on landing.
    pub head_dip: bool,
    /// Whether leaves and grass sway in the wind.
    pub wind: bool,
    /// Whether gliding and swaying are left out.
    pub reduced_motion: bool,
    /// Whether the brush marker is told by lightness and not by hue.
    pub safe_marker: bool,
    /// Whether the interface is drawn in strong contrast.
    pub high_contrast: bool,
    /// Whether newcomers are told, one after another, what they can do.
    pub hints: bool,
    /// The language of all texts.
    pub language: Language,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            mouse_sensitivity_deg_per_px: 0.12,
            invert_look: false,
            field_of_view_deg: 75.0,
            view_distance_chunks: 0,
            preset: Preset::default(),
            quality: Quality::default(),
            frame_cap: FrameCap::default(),
            vsync: true,
            msaa: Msaa::default(),
            shadows: Shadows::default(),
            render_scale: RenderScale::default(),
            ui_scale: 1.0,
            fullscreen: false,
            curvature_step: 1.0,
            hyperbolic_map: Map::default(),
            contour_bands: false,
            compass: true,
            minimap: true,
            rear_mirror: RearMirror::default(),
            straight_shots: false,
            volume_master_pc: 80.0,
            volume_effects_pc: 80.0,
            volume_ambience_pc: 70.0,
            volume_music_pc: 50.0,
            volume_interface_pc: 60.0,
            mute_elsewhere: true,
            pad_look_speed_deg_per_s: 180.0,
            pad_invert_look: false,
            pad_dead_zone_pc: 15.0,
            head_dip: true,
            wind: true,
            reduced_motion: false,
            safe_marker: false,
            high_contrast: false,
            hints: true,
            language: Language::default(),
        }
    }
}

/// How far land reaches by itself, chunks: where the processor draws, and where a card does, more than 300 m.
const VIEW_DISTANCE_CHUNKS: (u32, u32) = (4, 10);

impl Settings {
    /// How far land reaches, chunks; `software`: whether the processor draws.
    pub fn view_distance(&self, software: bool) -> u32 {
        let (near, far) = VIEW_DISTANCE_CHUNKS;
        match self.view_distance_chunks {
            0 if self.preset.is_software(software) => near,
            0 => far,
            chunks => chunks,
        }
    }

    /// The value of a field.
    pub fn get(&self, field: &Field) -> Value {
        field.value(self)
    }

    /// Sets a field by its id.
    ///
    /// # Errors
    /// [`SetError`] for an unknown id, a value of the wrong kind or one out of range; nothing is changed then.
    pub fn set(&mut self, id: &str, given: Given<'_>) -> Result<(), SetError> {
        let field = field(id).ok_or_else(|| SetError::Unknown { id: id.to_owned() })?;
        field.assign(self, given)
    }

    /// Sets a field by its id from a word, as in a command: `on`, `off`, a number or one of the field's options.
    ///
    /// # Errors
    /// As [`Settings::set`].
    pub fn set_word(&mut self, id: &str, word: &str) -> Result<(), SetError> {
        let field = field(id).ok_or_else(|| SetError::Unknown { id: id.to_owned() })?;
        field.assign(self, field.read_word(word)?)
    }

    /// Gives a field its default again. Returns false when there is no such field.
    pub fn reset(&mut self, id: &str) -> bool {
        let Some(field) = field(id) else { return false };
        field.assign_default(self);
        true
    }

    /// Whether a field has its default value.
    pub fn is_default(&self, field: &Field) -> bool {
        field.value(self) == field.default_value()
    }
}
