//! The photo mode in the game: the world stands still, the camera flies, and pictures larger than the window are
//! made tile by tile, a frame each.

use std::f64::consts::PI;
use std::time::Duration;

use antipode_geometry::HyperbolicMap;
use antipode_language::Texts;
use antipode_render::{RenderError, Tile};
use antipode_scene::day::local_time_s;
use antipode_scene::frame::Frame;
use antipode_scene::tuning::DAY_S;
use antipode_scene::{Shutter, Viewpoint};
use antipode_settings::Config;
use antipode_ui::{DialKind, PhotoModel, PhotoValues, PhotoWishes, first_input_label, show_photo};
use glam::DVec3;
use image::{RgbaImage, imageops};

use super::devices::Devices;
use super::menus::Menus;
use super::play::{CHUNK_BUDGET, Play};
use super::press::{Press, Taken, is_key};
use super::shots::Shots;
use crate::bindings::Action;
use crate::hud::clock;
use crate::screenshots::Album;
use crate::session::Session;

/// Most times that a picture is as large as the window, along each side.
const MOST_TIMES: u32 = 4;
/// Speed of the camera, and with the key for sprinting, metres of the chart per second.
const SPEED_M_S: (f64, f64) = (6.0, 24.0);
/// Longest time that the camera flies in one frame, seconds: a slow moment is no leap.
const LONGEST_S: f64 = 0.1;
/// What flies the camera; all other keys are for the panel, which names the first of these.
const FLYING: [Action; 7] = [
    Action::Forward,
    Action::Left,
    Action::Backward,
    Action::Right,
    Action::Jump,
    Action::Sink,
    Action::Sprint,
];

/// How many of them the panel names: all ways to fly.
const NAMED: usize = 6;

/// The photo mode, entered or not.
#[derive(Debug, Default)]
pub struct Photographer {
    photo: Option<Photo>,
    /// Size of the window, pixels.
    size: (u32, u32),
    /// Longest side of a picture that the adapter draws, pixels.
    largest_px: u32,
}

/// What is being photographed.
#[derive(Debug)]
struct Photo {
    view: Viewpoint,
    values: PhotoValues,
    /// Its panel has not been seen yet.
    fresh: bool,
    saving: Option<Saving>,
}

/// A picture that is being made.
#[derive(Debug)]
struct Saving {
    frame: Frame,
    stem: String,
    size: (u32, u32),
    tiles: Vec<Tile>,
    done: Vec<RgbaImage>,
    /// The next tile is being drawn.
    under_way: bool,
}

impl Photographer {
    /// Whether the photo mode is on.
    pub fn is_on(&self) -> bool {
        self.photo.is_some()
    }

    /// The window has this size in pixels, and the adapter draws pictures with sides up to `largest_px`.
    pub fn set_canvas(&mut self, size: (u32, u32), largest_px: u32) {
        self.size = size;
        self.largest_px = largest_px;
    }

    /// Enters the photo mode from the picture that is shown.
    pub fn enter(&mut self, session: &mut Session, shutter: Shutter) {
        let scene = &session.scene;
        let view = session.between.viewpoint(scene, shutter);
        self.photo = Some(Photo {
            values: PhotoValues {
                field_of_view_deg: scene.viewing().fov_y_rad.to_degrees(),
                time_of_day_s: view.time_of_day_s,
                dial: view.lens.value(),
                hide_figures: false,
                thirds: false,
                times: 1,
            },
            view,
            fresh: true,
            saving: None,
        });
    }

    /// Back into the world, where everything is as it was.
    pub fn leave(&mut self, devices: &mut Devices, play: &mut Play, menus: &mut Menus) {
        let Some(photo) = self.photo.take() else {
            return;
        };
        if photo.saving.is_some() {
            let reason = menus.texts.say("photo-left");
            menus.tell_no_picture(&reason);
        }
        devices.release_all();
        if let Some(session) = play.phase.session_mut() {
            session.scene.watch_from(None);
        }
    }

    /// The layer of the photo mode: keys of the camera are nothing for the panel.
    pub fn press(
        &mut self,
        press: &Press,
        devices: &mut Devices,
        play: &mut Play,
        menus: &mut Menus,
    ) -> Taken {
        let Some(input) = press.by_hand().filter(|it| self.is_on() && is_key(*it)) else {
            return Taken::Not;
        };
        let does = |action| devices.controls.does(input, action);
        if does(Action::Menu) || does(Action::PhotoMode) {
            if press.down && !press.repeats {
                self.leave(devices, play, menus);
            }
            return Taken::Wholly;
        }
        let flies = FLYING.iter().any(|action| does(*action));
        if flies && !press.repeats {
            devices.controls.input(input, press.down);
        }
        Taken::if_true(flies)
    }

    /// A moment of the photo mode.
    pub fn fly(&mut self, session: &mut Session, devices: &mut Devices, passed: Duration) {
        let actions = devices.controls.take_keys();
        let Some(photo) = self.photo.as_mut().filter(|photo| photo.saving.is_none()) else {
            return;
        };
        let (slow, fast) = SPEED_M_S;
        let speed = if actions.sprint { fast } else { slow };
        let up = f64::from(i8::from(actions.jump) - i8::from(actions.sink));
        let way = DVec3::new(actions.strafe, up, actions.forward).clamp_length_max(1.0);
        let by = way * speed * passed.as_secs_f64().min(LONGEST_S);
        session.scene.fly_view(&mut photo.view, by);
        session.scene.watch_from(Some(photo.view.eye));
        // While tiles are drawn the land stays as it is, so that they fit together.
        session.scene.pump(CHUNK_BUDGET);
    }

    /// The picture to draw in the photo mode.
    pub fn frame(&self, play: &mut Play, aspect: f64) -> Option<Frame> {
        let photo = self.photo.as_ref()?;
        let fov_y_rad = photo.values.field_of_view_deg.to_radians();
        let (share, id) = (play.pace.share(), play.opened);
        let session = play.phase.session_mut()?;
        let (between, scene) = (&session.between, &mut session.scene);
        Some(between.frame_from(scene, share, &photo.view, fov_y_rad, aspect, id))
    }

    /// Draws the panel. Returns what is asked for there besides the view.
    pub fn show(
        &mut self,
        context: &egui::Context,
        texts: &Texts,
        config: &Config,
    ) -> Option<PhotoWishes> {
        let most_times = self.most_times();
        let photo = self.photo.as_mut()?;
        let lens = &photo.view.lens;
        let kind = match lens.map() {
            Some(HyperbolicMap::Raised) => DialKind::Raised,
            Some(HyperbolicMap::Horizon) => DialKind::Horizon,
            None => DialKind::Bend,
        };
        let (pictured, place) = (lens.strategy(), photo.view.eye.point);
        let clock_there = |time_s: f64| clock(local_time_s(time_s, &**pictured, place));
        let keys = FLYING.iter().take(NAMED);
        let keys = keys.map(|way| first_input_label(texts, &config.profiles, *way));
        let saving = photo.saving.as_ref();
        let model = PhotoModel {
            texts,
            dial: lens.range().map(|(min, max)| (kind, min, max)),
            day_s: Some(DAY_S),
            clock: &clock_there,
            size: self.size,
            most_times,
            keys: keys.collect::<Vec<_>>().join(" "),
            saving: saving.map(|it| it.done.len() as f32 / it.tiles.len().max(1) as f32),
        };
        let fresh = std::mem::take(&mut photo.fresh);
        let wishes = show_photo(context, &model, &mut photo.values, fresh);
        let values = photo.values;
        let view = &mut photo.view;
        view.time_of_day_s = values.time_of_day_s;
        view.figures = !values.hide_figures;
        let dial = view.lens.range().map(|_| view.lens.value());
        if dial != Some(values.dial) {
            view.set_dial(values.dial);
        }
        // The view follows the mouse as it does in play: across the picture's height by the field of view.
        let per_point =
            values.field_of_view_deg / 180.0 * PI / f64::from(context.content_rect().height());
        let [right, up] = [wishes.look.x, -wishes.look.y].map(|way| f64::from(way) * per_point);
        let inverted = config.settings.invert_look;
        view.turn(right, if inverted { -up } else { up });
        Some(wishes)
    }

    fn most_times(&self) -> u32 {
        let side = self.size.0.max(self.size.1).max(1);
        (self.largest_px / side).clamp(1, MOST_TIMES)
    }

    /// Begins to make the picture that is seen, as large as was chosen.
    pub fn begin(&mut self, play: &mut Play) {
        let (size, most_times) = (self.size, self.most_times());
        let aspect = f64::from(size.0) / f64::from(size.1.max(1));
        let Some(frame) = self.frame(play, aspect) else {
            return;
        };
        if let Some(photo) = self.photo.as_mut().filter(|photo| photo.saving.is_none()) {
            photo.saving = Some(Saving {
                frame,
                stem: Album::stem(play.phase.slug()),
                size,
                tiles: Tile::grid(size, photo.values.times.clamp(1, most_times)).collect(),
                done: Vec::new(),
                under_way: false,
            });
        }
    }

    /// As [`Photographer::begin`], so many times as large as the window.
    #[cfg(test)]
    pub fn begin_of(&mut self, play: &mut Play, times: u32) {
        if let Some(photo) = &mut self.photo {
            photo.values.times = times;
        }
        self.begin(play);
    }

    /// The tile to draw now: its frame, its place, and its size in pixels. One at a time.
    pub fn next_tile(&mut self) -> Option<(&Frame, Tile, (u32, u32))> {
        let saving = self.photo.as_mut()?.saving.as_mut()?;
        if saving.under_way {
            return None;
        }
        let tile = *saving.tiles.get(saving.done.len())?;
        saving.under_way = true;
        Some((&saving.frame, tile, saving.size))
    }

    /// The tile that was asked for is drawn, or could not be; after the last one the picture is written.
    pub fn keep_tile(
        &mut self,
        tile: Result<RgbaImage, RenderError>,
        shots: &mut Shots,
        menus: &mut Menus,
    ) {
        let Some(photo) = &mut self.photo else {
            return;
        };
        let Some(mut saving) = photo.saving.take() else {
            return;
        };
        match tile {
            Ok(tile) => saving.done.push(tile),
            Err(error) => return menus.tell_no_picture(&error.to_string()),
        }
        saving.under_way = false;
        if saving.done.len() < saving.tiles.len() {
            photo.saving = Some(saving);
        } else {
            let Saving { tiles, done, .. } = saving;
            shots.write(saving.stem, move || joined(&tiles, done));
        }
    }
}

/// One picture of its tiles; each is let go as soon as it is in its place.
fn joined(tiles: &[Tile], done: Vec<RgbaImage>) -> RgbaImage {
    let (width, height) = tiles.first().map_or((1, 1), |tile| tile.whole);
    let mut whole = RgbaImage::new(width, height);
    for (tile, picture) in tiles.iter().zip(done) {
        let (x, y) = tile.corner;
        imageops::replace(&mut whole, &picture, i64::from(x), i64::from(y));
    }
    whole
}
