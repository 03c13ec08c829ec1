//! The photo mode in the game: the world stands still, the camera flies, and pictures larger than the window are
//! made tile by tile, a frame each.

use std::f64::consts::PI;
use std::time::Duration;

use antipode_geometry::HyperbolicMap;
use antipode_render::{RenderError, Tile};
use antipode_scene::Viewpoint;
use antipode_scene::day::local_time_s;
use antipode_scene::frame::Frame;
use antipode_scene::tuning::DAY_S;
use antipode_settings::Lesson;
use antipode_ui::{DialKind, PhotoModel, PhotoValues, first_input_label, show_photo};
use glam::DVec3;
use image::{RgbaImage, imageops};

use super::background::Task;
use super::game::{CHUNK_BUDGET, Game};
use super::phase::Phase;
use crate::bindings::{Action, Input};
use crate::controls::Controls;
use crate::hud::clock;
use crate::screenshots::Album;
use crate::session::Session;

/// Most times that a picture is as large as the window, along each side.
const MOST_TIMES: u32 = 4;
/// Speed of the camera, and with the key for sprinting, metres of the chart per second.
const SPEED_M_S: (f64, f64) = (6.0, 24.0);
/// Longest time that the camera flies in one frame, seconds: a slow moment is no leap.
const LONGEST_S: f64 = 0.1;
/// What flies the camera; all other keys are for the panel.
const FLYING: [Action; 7] = [
    Action::Forward,
    Action::Backward,
    Action::Left,
    Action::Right,
    Action::Jump,
    Action::Sink,
    Action::Sprint,
];

/// The photo mode, entered or not.
#[derive(Debug)]
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

impl Default for Photographer {
    fn default() -> Self {
        Self {
            photo: None,
            size: (1, 1),
            largest_px: 1,
        }
    }
}

impl Photographer {
    fn most_times(&self) -> u32 {
        let side = self.size.0.max(self.size.1).max(1);
        (self.largest_px / side).clamp(1, MOST_TIMES)
    }
}

impl Saving {
    fn part(&self) -> f32 {
        self.done.len() as f32 / self.tiles.len().max(1) as f32
    }
}

impl Game {
    /// Whether the photo mode is on: the world stands still, keys fly the camera or belong to the panel.
    pub fn is_photographing(&self) -> bool {
        self.photographer.photo.is_some()
    }

    /// The window has this size in pixels, and the adapter draws pictures with sides up to `largest_px`.
    pub fn set_canvas(&mut self, size: (u32, u32), largest_px: u32) {
        self.photographer.size = size;
        self.photographer.largest_px = largest_px;
    }

    pub(super) fn enter_photo_mode(&mut self) {
        self.has_done(Lesson::Photo);
        let shutter = self.shutter();
        let Phase::Playing(session) = &mut self.phase else {
            return;
        };
        let scene = &session.scene;
        let view = session.between.viewpoint(scene, shutter);
        self.photographer.photo = Some(Photo {
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
        self.controls.release_all();
    }

    /// Back into the world, where everything is as it was.
    pub(super) fn leave_photo_mode(&mut self) {
        let Some(photo) = self.photographer.photo.take() else {
            return;
        };
        if photo.saving.is_some() {
            let reason = self.menus.texts.say("photo-left");
            self.picture_failed(&reason);
        }
        self.controls.release_all();
        if let Some(session) = self.phase.session_mut() {
            session.scene.watch_from(None);
        }
    }

    /// A key or button in the photo mode. Returns whether it is the camera's, and nothing for the panel.
    pub fn photo_key(&mut self, input: Input, pressed: bool, repeats: bool) -> bool {
        let does = |controls: &Controls, action| controls.does(input, action);
        let controls = &mut self.controls;
        if does(controls, Action::Menu) || does(controls, Action::PhotoMode) {
            if pressed && !repeats {
                self.leave_photo_mode();
            }
            return true;
        }
        let flies = FLYING.iter().any(|action| does(controls, *action));
        if flies && !repeats {
            controls.input(input, pressed);
        }
        flies
    }

    /// A moment of the photo mode.
    pub(super) fn photographing(&mut self, mut session: Session, passed: Duration) -> Phase {
        let actions = self.controls.take_keys();
        if let Some(photo) = self
            .photographer
            .photo
            .as_mut()
            .filter(|photo| photo.saving.is_none())
        {
            let speed = if actions.sprint {
                SPEED_M_S.1
            } else {
                SPEED_M_S.0
            };
            let up = f64::from(i8::from(actions.jump) - i8::from(actions.sink));
            let way = DVec3::new(actions.strafe, up, actions.forward).clamp_length_max(1.0);
            let by = way * speed * passed.as_secs_f64().min(LONGEST_S);
            session.scene.fly_view(&mut photo.view, by);
            session.scene.watch_from(Some(photo.view.eye));
            // While tiles are drawn the land stays as it is, so that they fit together.
            session.scene.pump(CHUNK_BUDGET);
        }
        self.keep_saved(&mut session, passed, true);
        self.tell(&mut session);
        Phase::Playing(session)
    }

    /// The picture to draw in the photo mode.
    pub(super) fn photo_frame(&mut self, aspect: f64, id: u64) -> Option<Frame> {
        let photo = self.photographer.photo.as_ref()?;
        let fov_y_rad = photo.values.field_of_view_deg.to_radians();
        let (share, session) = (self.pace.share(), self.phase.session_mut()?);
        let (between, scene) = (&session.between, &mut session.scene);
        Some(between.frame_from(scene, share, &photo.view, fov_y_rad, aspect, id))
    }

    /// Draws the panel and does what is asked for there.
    pub(super) fn show_photo_panel(&mut self, context: &egui::Context) {
        let most_times = self.photographer.most_times();
        let size = self.photographer.size;
        let keys = self.flying_keys();
        let Some(photo) = self.photographer.photo.as_mut() else {
            return;
        };
        let lens = &photo.view.lens;
        let kind = match lens.map() {
            Some(HyperbolicMap::Raised) => DialKind::Raised,
            Some(HyperbolicMap::Horizon) => DialKind::Horizon,
            None => DialKind::Bend,
        };
        let (pictured, place) = (lens.strategy(), photo.view.eye.point);
        let clock_there = |time_s: f64| clock(local_time_s(time_s, &**pictured, place));
        let model = PhotoModel {
            texts: &self.menus.texts,
            dial: lens.range().map(|(min, max)| (kind, min, max)),
            day_s: Some(DAY_S),
            clock: &clock_there,
            size,
            most_times,
            keys,
            saving: photo.saving.as_ref().map(Saving::part),
        };
        let fresh = std::mem::take(&mut photo.fresh);
        let wishes = show_photo(context, &model, &mut photo.values, fresh);
        let values = photo.values;
        let view = &mut photo.view;
        view.time_of_day_s = values.time_of_day_s;
        view.figures = !values.hide_figures;
        if lens_dial(view) != Some(values.dial) {
            view.set_dial(values.dial);
        }
        // The view follows the mouse as it does in play: across the picture's height by the field of view.
        let per_point =
            values.field_of_view_deg / 180.0 * PI / f64::from(context.content_rect().height());
        let [right, up] = [wishes.look.x, -wishes.look.y].map(|way| f64::from(way) * per_point);
        view.turn(
            right,
            if self.config.settings.invert_look {
                -up
            } else {
                up
            },
        );
        if wishes.save {
            self.begin_photo();
        }
        if wishes.leave {
            self.leave_photo_mode();
        }
    }

    fn flying_keys(&self) -> String {
        let ways = [
            Action::Forward,
            Action::Left,
            Action::Backward,
            Action::Right,
            Action::Jump,
            Action::Sink,
        ];
        let labels =
            ways.map(|way| first_input_label(&self.menus.texts, &self.config.profiles, way));
        labels.join(" ")
    }

    /// Begins to make the picture that is seen, as large as was chosen.
    pub(super) fn begin_photo(&mut self) {
        let size = self.photographer.size;
        let most_times = self.photographer.most_times();
        let id = self.worlds_opened;
        let aspect = f64::from(size.0) / f64::from(size.1.max(1));
        let slug = self
            .phase
            .session()
            .map_or_else(String::new, |session| session.slug.clone());
        let Some(frame) = self.photo_frame(aspect, id) else {
            return;
        };
        let Some(photo) = self
            .photographer
            .photo
            .as_mut()
            .filter(|photo| photo.saving.is_none())
        else {
            return;
        };
        photo.saving = Some(Saving {
            frame,
            stem: Album::stem(&slug),
            size,
            tiles: Tile::grid(size, photo.values.times.clamp(1, most_times)).collect(),
            done: Vec::new(),
            under_way: false,
        });
    }

    /// As [`Game::begin_photo`], so many times as large as the window.
    #[cfg(test)]
    pub(super) fn begin_photo_of(&mut self, times: u32) {
        if let Some(photo) = &mut self.photographer.photo {
            photo.values.times = times;
        }
        self.begin_photo();
    }

    /// The tile to draw now: its frame, its place, and its size in pixels. One at a time.
    pub fn next_tile(&mut self) -> Option<(&Frame, Tile, (u32, u32))> {
        let saving = self.photographer.photo.as_mut()?.saving.as_mut()?;
        if saving.under_way {
            return None;
        }
        let tile = *saving.tiles.get(saving.done.len())?;
        saving.under_way = true;
        Some((&saving.frame, tile, saving.size))
    }

    /// The tile that was asked for is drawn, or could not be; after the last one the picture is written.
    pub fn keep_tile(&mut self, tile: Result<RgbaImage, RenderError>) {
        let Some(photo) = &mut self.photographer.photo else {
            return;
        };
        let Some(saving) = &mut photo.saving else {
            return;
        };
        saving.under_way = false;
        match tile {
            Ok(tile) => saving.done.push(tile),
            Err(error) => {
                photo.saving = None;
                self.picture_failed(&error.to_string());
                return;
            }
        }
        if saving.done.len() == saving.tiles.len()
            && let Some(Saving {
                stem, tiles, done, ..
            }) = photo.saving.take()
        {
            let album = self.shots.album.clone();
            let write = move || album.keep(&stem, &joined(&tiles, done));
            self.shots.wait_for(Task::start("photo", write));
        }
    }
}

fn lens_dial(view: &Viewpoint) -> Option<f64> {
    view.lens.range().map(|_| view.lens.value())
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
