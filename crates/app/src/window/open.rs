//! The game in its open window: what happens once a frame.

use std::time::{Duration, Instant};

use antipode_render::RenderError;
use antipode_settings::Settings;

use super::game::Game;
use super::hearing::Ears;
use super::pads::Pads;
use super::pointer::Pointer;
use super::press::Down;
use super::redraw::{REST, Redraw};
use super::shown::Shown;
use super::stage::{SceneShown, Showing, Stage};
use super::waits::Part;
use super::wheel::Wheel;
use crate::failure::Failure;

/// The window and the game in it.
pub struct Open {
    pub(super) stage: Stage,
    pub(super) game: Game,
    pub(super) ears: Ears,
    pub(super) pads: Pads,
    pub(super) pointer: Pointer,
    pub(super) wheel: Wheel,
    pub(super) occluded: bool,
    pub(super) minimised: bool,
    /// The settings that the stage goes by.
    pub(super) followed: Option<Settings>,
    pub(super) redraw: Redraw,
    pub(super) down: Down,
    pub(super) shown: Shown,
}

impl Open {
    /// A game on a stage.
    pub fn new(stage: Stage, game: Game) -> Self {
        let ears = Ears::new(&game.options.config.settings);
        Self {
            stage,
            game,
            ears,
            pads: Pads::new(crate::pad::system()),
            pointer: Pointer::default(),
            wheel: Wheel::default(),
            occluded: false,
            minimised: false,
            followed: None,
            redraw: Redraw::new(Instant::now()),
            down: Down::default(),
            shown: Shown::default(),
        }
    }

    /// Whether nobody can see the window.
    fn is_hidden(&self) -> bool {
        self.occluded || self.minimised
    }

    /// Whether to draw a frame now: not of a window that nobody sees, nor of what stands still.
    pub fn is_worth_drawing(&mut self, now: Instant) -> bool {
        let changed = self.game.menus.shell.take_changed();
        if changed || !self.game.is_still() || self.stage.is_busy() {
            self.redraw.touch(now);
        }
        self.redraw.is_due(now) && !self.is_hidden()
    }

    /// When to look again after no frame was worth drawing.
    pub fn next_look(&self, now: Instant) -> Instant {
        if self.is_hidden() {
            now + REST
        } else {
            self.redraw.next_look(now)
        }
    }

    /// Lets time pass in the game, the pads and the sounds.
    pub fn tick(&mut self, now: Instant) {
        let keys = self.pads.poll(&mut self.game, now);
        if !keys.is_empty() {
            self.redraw.touch(Instant::now());
        }
        self.stage.input.egui_input_mut().events.extend(keys);
        self.game.backdrop.held = !self.stage.are_maps_ready();
        self.game.tick(now);
        self.follow_settings();
        let game = &mut self.game;
        let (settings, elsewhere) = (&game.options.config.settings, game.devices.lost_focus());
        let heard = game.play.take_heard();
        game.menus.sound_trouble = self.ears.listen(settings, elsewhere, heard);
        if !self.game.is_playing() {
            self.pointer.free(&self.stage.window);
        } else if self.pointer.catch(&self.stage.window, self.stage.size()) {
            self.wheel = Wheel::default();
        }
    }

    /// Has the stage go by the settings, where they have changed.
    fn follow_settings(&mut self) {
        let settings = self.game.options.of_pictures();
        if self.followed.as_ref() == Some(&settings) {
            return;
        }
        self.redraw.touch(Instant::now());
        let followed = self.stage.follow(self.followed.insert(settings));
        if let Err(why) = followed {
            self.game.menus.tell_not_applied(&why);
        }
    }

    /// Draws and shows the picture of this moment. A lost adapter is opened anew first, unless it cannot.
    ///
    /// # Errors
    /// When the adapter is lost for good, or refuses to draw.
    pub fn draw(&mut self, can_recover: bool) -> Result<(), Failure> {
        if let Some(why) = self.stage.lost() {
            self.recover(&why, can_recover)?;
        }
        self.game.waits.spent_on(Part::Input);
        // Without something to draw on, the chunks that a frame brings stay where they are.
        let Some(texture) = self.stage.next_texture() else {
            return Ok(());
        };
        self.game.waits.spent_on(Part::Drawing);
        self.take_pictures();
        self.game.waits.spent_on(Part::Input);
        let frame = self.game.frame(self.stage.aspect(), self.stage.height_px());
        let room = self.game.room_view(self.stage.aspect());
        self.game.waits.spent_on(Part::Scene);
        let output = self.interface();
        self.game.waits.spent_on(Part::Interface);
        // After what may have changed the room: it is made ready to be drawn while this frame is.
        self.prepare_room();
        self.game.waits.spent_on(Part::Scene);
        let repaint = output.viewport_output.get(&egui::ViewportId::ROOT);
        let wait = repaint.map_or(Duration::MAX, |viewport| viewport.repaint_delay);
        let showing = Showing {
            thumbnail: match (&frame, &room) {
                (Some(frame), _) => self.game.portrait(frame),
                (None, Some(room)) => self.game.room_portrait(room),
                (None, None) => None,
            },
            scene: match (&frame, &room) {
                (Some(frame), _) => SceneShown::World(frame),
                (None, Some(room)) => SceneShown::Room(room),
                (None, None) => SceneShown::Nothing,
            },
            interface: output,
            keeps: self.game.shots.begin(),
        };
        let is_room_drawn = self.stage.show(texture, showing, &mut self.game.waits)?;
        if is_room_drawn {
            let elsewhere = self.game.devices.lost_focus();
            self.game.play.room_drawn(&mut self.game.menus, elsewhere);
            self.game.play.room_is_late(self.stage.is_room_late());
        }
        self.game
            .play
            .drawn(frame.is_some() && !self.stage.is_land_coming());
        self.shown.tell(&self.game);
        let now = Instant::now();
        self.redraw.drawn(now, wait);
        self.game.display.fps.shown(now);
        self.game.waits.spent_on(Part::Drawing);
        self.game.waits.shown();
        Ok(())
    }

    /// Has the open room drawn, or leaves one that cannot be.
    fn prepare_room(&mut self) {
        let Some((id, room, texts)) = self.game.room() else {
            return;
        };
        if let Some(why) = self.stage.prepare_room(id, room, texts) {
            self.game.play.room_refused(&why, &mut self.game.menus);
        }
    }

    /// Opens an adapter anew, and says so.
    fn recover(&mut self, why: &str, can_recover: bool) -> Result<(), Failure> {
        tracing::warn!("the graphics adapter was lost ({why}) and is opened anew");
        if !can_recover {
            return Err(RenderError::Lost(why.to_owned()).into());
        }
        self.stage.recover(why)?;
        // What it draws with may be another, and be followed otherwise.
        self.followed = None;
        self.follow_settings();
        self.game.menus.tell_reopened(self.stage.software());
        tracing::warn!("drawing goes on with {}", self.stage.adapter_name());
        Ok(())
    }

    /// Takes over the pictures that have been drawn, and begins the next tile of a larger one.
    fn take_pictures(&mut self) {
        while let Some(picture) = self.stage.finished_screenshot() {
            self.game.shots.keep(picture, &mut self.game.menus);
        }
        if let Some((world, picture)) = self.stage.finished_thumbnail() {
            self.game.play.keep_picture(world, picture);
        } else if !self.stage.makes_thumbnail() {
            self.game.play.portrait.miss();
        }
        let (size, largest_px) = (self.stage.size(), self.stage.largest_side());
        let photo = &mut self.game.overlays.photo;
        photo.set_canvas(size, largest_px);
        if let Some(tile) = self.stage.finished_tile() {
            photo.keep_tile(tile, &mut self.game.shots, &mut self.game.menus);
        }
        if let Some((frame, tile, size)) = photo.next_tile() {
            self.stage.begin_tile(frame, tile, size);
        }
    }

    /// One pass of the interface.
    fn interface(&mut self) -> egui::FullOutput {
        let input = self.stage.take_input();
        let game = &mut self.game;
        let drawn = self.stage.drawn();
        let mut output = self
            .stage
            .overlay
            .context()
            .run_pass(input, |context| game.interface(context, drawn));
        if self.game.options.config.settings.high_contrast {
            antipode_ui::heighten_contrast(&mut output.shapes);
        }
        let platform = std::mem::take(&mut output.platform_output);
        if !self.game.is_playing() {
            self.ears.interface(&platform.events);
            self.stage
                .input
                .handle_platform_output(&self.stage.window, platform);
        }
        output
    }
}
