//! Runs a script's orders in simulated time, so that the same script gives the same probes.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_scene::tuning::STEP_S;
use antipode_scene::{Actions, Scene};
use antipode_settings::{Config, Language, Value};
use image::RgbaImage;

use super::host::{Host, obey};
use super::parse::{Line, Order};
use super::{Shooting, say};
use crate::bindings::{Action, Input};
use crate::common::{Adapter, Common};
use crate::controls::Controls;
use crate::drawn::Drawn;
use crate::ending::Ending;
use crate::failure::Failure;
use crate::hud;
use crate::navigator::{Navigator, SurveyOrder, WHOLE_MAP, extent_of};
use crate::options;
use crate::picture::Studio;
use crate::rooms::Rooms;
use crate::session::{NewWorld, Session, Worlds};

/// Longest time a step may wait for the chunk workers before the script is stopped.
const PATIENCE: Duration = Duration::from_mins(1);
/// How long a wait for all chunk work goes on before a look at other things.
const SETTLE_SLICE: Duration = Duration::from_millis(100);

/// A running script.
#[derive(Debug)]
pub struct Runner {
    pub(super) common: Common,
    worlds: Worlds,
    shooting: Shooting,
    pub(super) controls: Controls,
    /// The settings that hold; a script changes no file.
    pub(super) config: Config,
    pub(super) session: Option<Session>,
    pub(super) rooms: Rooms,
    ending: Ending,
    pub(super) studio: Option<Studio>,
    /// English unless a file of settings says otherwise: the same script makes the same pictures everywhere.
    texts: Texts,
    pub(super) worlds_opened: u64,
    /// Median time of a measured frame, and of the adapter's share in it.
    pub(super) frame_ms: Option<f64>,
    pub(super) gpu_ms: Option<f64>,
    /// What the last picture of the open world was drawn with.
    pub(super) drawn: Option<Drawn>,
    display_hidden: bool,
    figures_shown: bool,
    large_map_shown: bool,
    hit_shapes_shown: bool,
    navigator: Navigator,
}

impl Runner {
    /// A script that has not begun.
    pub fn new(common: Common, shooting: Shooting, ending: Ending, config: &Config) -> Self {
        let mut worlds = Worlds::new(&common);
        worlds.set_quality(
            common
                .quality
                .unwrap_or_else(|| options::quality(&config.settings)),
        );
        worlds.set_map(options::map(&config.settings));
        if common.config.is_some() && common.view_distance.is_none() {
            // What a script sees is the same on every machine.
            worlds.set_view_distance(config.settings.view_distance(true));
        }
        let mut controls = Controls::default();
        controls.set_config(config);
        let texts = match config.settings.language {
            Language::System => Texts::default(),
            _ => options::texts(&config.settings),
        };
        let rooms = Rooms::new(&common);
        Self {
            rooms,
            common,
            worlds,
            shooting,
            controls,
            config: config.clone(),
            session: None,
            ending,
            studio: None,
            texts,
            worlds_opened: 0,
            frame_ms: None,
            gpu_ms: None,
            drawn: None,
            display_hidden: false,
            figures_shown: false,
            large_map_shown: false,
            hit_shapes_shown: false,
            navigator: Navigator::default(),
        }
    }

    /// Runs orders until the end or `quit`.
    ///
    /// # Errors
    /// The first that fails; orders that ask for what is not there name their line.
    pub fn run(&mut self, lines: &[Line]) -> Result<(), Failure> {
        for Line { number, order } in lines {
            if *order == Order::Quit {
                break;
            }
            self.ending.check()?;
            obey(self, order).map_err(|failure| match failure {
                Failure::Usage(what) | Failure::Script(what) => {
                    Failure::Script(format!("line {number}: {what}"))
                }
                Failure::Stopped(signal) => Failure::Stopped(signal),
                other => Failure::Runtime(format!("line {number}: {other}")),
            })?;
        }
        Ok(())
    }

    /// Commits and closes the open world, or leaves the open room.
    ///
    /// # Errors
    /// When the last commit failed.
    pub fn close(&mut self) -> Result<(), Failure> {
        self.rooms.close();
        match self.session.take() {
            Some(session) => session
                .close()
                .map_err(|unclosed| Failure::Streaming(unclosed.error)),
            None => Ok(()),
        }
    }

    fn enter_new(&mut self, wanted: &NewWorld) -> Result<(), Failure> {
        self.close()?;
        let session = self.worlds.create(wanted)?;
        self.enter(session)
    }

    fn enter_saved(&mut self, name: &str) -> Result<(), Failure> {
        self.close()?;
        let session = self.worlds.load(name)?;
        self.enter(session)
    }

    fn enter(&mut self, mut session: Session) -> Result<(), Failure> {
        session.scene.set_picture_height_px(self.common.size.1);
        options::fit(&mut session.scene, &self.config.settings);
        self.worlds_opened += 1;
        self.controls.release_all();
        self.session = Some(session);
        self.drawn = None;
        self.await_workers()?;
        self.tell_notices();
        let scene = self.scene()?;
        scene.refresh_marker();
        Ok(())
    }

    fn save(&mut self) -> Result<(), Failure> {
        let scene = self.scene()?;
        if scene.setup().name.is_empty() || !scene.is_kept() {
            return Err(Failure::Usage(
                "this world has no name, so it is not kept; make it with name=...".to_owned(),
            ));
        }
        scene.save();
        if scene.wait_saved(PATIENCE) && scene.save_problem().is_none() {
            return Ok(());
        }
        let why = scene.save_problem().map_or_else(
            || "the disk did not answer in time".to_owned(),
            |why| why.to_string(),
        );
        Err(Failure::Runtime(why))
    }

    /// One step of the simulation, and all the work it caused.
    fn step_with(&mut self, actions: &Actions) -> Result<(), Failure> {
        self.ending.check()?;
        if let Some(room) = self.rooms.open_room() {
            room.step(actions);
            return Ok(());
        }
        self.scene()?.step(actions);
        self.await_workers()?;
        self.tell_notices();
        Ok(())
    }

    pub(super) fn await_workers(&mut self) -> Result<(), Failure> {
        if self.scene()?.wait_for_step(PATIENCE) {
            Ok(())
        } else {
            Err(Failure::Runtime(
                "The land around the player was not made within a minute.".to_owned(),
            ))
        }
    }

    /// What the scene has to tell, a damaged place in a save among it, is told at the level that scripts show.
    fn tell_notices(&mut self) {
        if let Ok(scene) = self.scene() {
            for notice in scene.take_notices() {
                tracing::error!("{notice}");
            }
            for hint in scene.take_hints() {
                tracing::info!("{hint}");
            }
        }
    }

    fn pass(&mut self, time_s: f64) -> Result<(), Failure> {
        if self.rooms.scene().is_none() {
            self.scene()?;
        }
        for _ in 0..steps_in(time_s) {
            self.step()?;
        }
        Ok(())
    }

    fn settle(&mut self, limit_s: f64) -> Result<(), Failure> {
        if self.rooms.scene().is_some() {
            return Ok(());
        }
        let limit = Duration::from_secs_f64(limit_s);
        let began = Instant::now();
        // In slices, so that a wish to end is not kept waiting.
        loop {
            let left = limit.saturating_sub(began.elapsed());
            if self.scene()?.settle(left.min(SETTLE_SLICE)) {
                return Ok(());
            }
            self.ending.check()?;
            if left.is_zero() {
                return Err(Failure::Runtime(format!(
                    "Chunk work was still pending after {limit_s} s."
                )));
            }
        }
    }

    fn probe(&mut self) -> Result<(), Failure> {
        let adapter = self
            .studio
            .as_ref()
            .map_or("none", |studio| studio.adapter_name());
        if let Some(room) = self.rooms.scene() {
            return crate::output::line(&say::room_probe_text(&room.probe(), adapter)?);
        }
        let adapter = adapter.to_owned();
        let probe = self.scene()?.probe();
        let fps = self.frame_ms.map(|ms| 1000.0 / ms);
        say::probe(&probe, fps, &adapter, self.drawn.as_ref())
    }

    fn shoot(&mut self, file: &str) -> Result<(), Failure> {
        let path = match &self.shooting {
            Shooting::Here => PathBuf::from(file),
            Shooting::Into(dir) => dir.join(file),
        };
        self.open_studio()?;
        if self.rooms.scene().is_some() {
            return self.shoot_room(&path);
        }
        let id = self.worlds_opened;
        let (Some(studio), Some(session)) = (self.studio.as_mut(), self.session.as_mut()) else {
            return Err(Failure::Usage(
                "no world is open; begin with new or load".to_owned(),
            ));
        };
        let fov_y_rad = session.scene.viewing().fov_y_rad;
        let mut frame = session.scene.frame(fov_y_rad, studio.aspect(), id);
        options::fit_mirror(&mut frame, &self.config.settings, studio.is_software());
        let has_mirror = frame.mirror.is_some() && !self.display_hidden;
        if self.display_hidden {
            frame.mirror = None;
            frame.view.hand = None;
            frame.content_mut().marker = None;
        }
        if self.hit_shapes_shown {
            frame.content_mut().hit_shapes = session.scene.hit_shapes();
        }
        let scene = &session.scene;
        let (drawn, texts) = (&mut self.drawn, &self.texts);
        let (frame_ms, gpu_ms) = (self.frame_ms, self.gpu_ms);
        let fps = frame_ms.map_or(0.0, |ms| 1000.0 / ms) as f32;
        let (navigator, settings) = (&mut self.navigator, &self.config.settings);
        let large_map = self.large_map_shown;
        let picture = studio.shoot(&frame, texts, |stats| {
            let drawn = drawn.insert(Drawn::new(stats, frame.view.quality));
            let figures = self
                .figures_shown
                .then(|| drawn.figures(texts, scene, frame_ms, gpu_ms, 0.0));
            (!self.display_hidden).then(|| {
                let seen = scene.seen();
                let mut model = hud::model(texts, scene, &seen, fps, figures);
                model.mirror = has_mirror;
                let order = SurveyOrder {
                    world: id,
                    extent: extent_of(large_map),
                    columns: WHOLE_MAP,
                };
                navigator.add_to(&mut model, scene, &seen, texts, settings, order);
                model
            })
        })?;
        write_picture(&picture, &path)
    }

    fn shoot_room(&mut self, path: &Path) -> Result<(), Failure> {
        let (id, quality) = (self.rooms.look_id(), self.worlds.quality());
        let with_hand = !self.display_hidden;
        let (Some(studio), Some(room)) = (self.studio.as_mut(), self.rooms.open_room()) else {
            return Ok(());
        };
        room.fit(&self.config.settings);
        write_picture(
            &studio.shoot_room((room, &self.texts), id, quality, with_hand)?,
            path,
        )
    }

    pub(super) fn open_studio(&mut self) -> Result<(), Failure> {
        if self.studio.is_none() {
            if self.common.adapter == Adapter::None {
                return Err(Failure::Usage(
                    "there are no pictures with --adapter none".to_owned(),
                ));
            }
            self.studio = Some(Studio::new(&self.common, &self.config.settings)?);
        }
        match &mut self.studio {
            Some(studio) => studio.follow(&self.config.settings),
            None => Ok(()),
        }
    }
}

impl Host for Runner {
    fn scene(&mut self) -> Result<&mut Scene, Failure> {
        self.session
            .as_mut()
            .map(|session| &mut session.scene)
            .ok_or_else(|| Failure::Usage("no world is open; begin with new or load".to_owned()))
    }

    fn room(&mut self) -> Option<&mut RoomScene> {
        self.rooms.scene()
    }

    fn worlds(&mut self) -> &mut Worlds {
        &mut self.worlds
    }

    fn controls(&mut self) -> &mut Controls {
        &mut self.controls
    }

    fn open_slug(&self) -> Option<&str> {
        self.session.as_ref().map(|session| session.slug.as_str())
    }

    fn set_own(&mut self, id: &'static str, value: Value) {
        if let Err(error) = self.config.settings.set(id, value.into()) {
            tracing::warn!("{error}");
        }
        self.controls.set_config(&self.config);
        self.worlds.set_map(options::map(&self.config.settings));
        if id == "language" {
            self.texts = options::texts(&self.config.settings);
            self.rooms.reword();
        }
        if let Some(session) = &mut self.session {
            options::fit(&mut session.scene, &self.config.settings);
        }
    }

    fn press(&mut self, input: Input) {
        match self.controls.input(input, true) {
            Some(Action::HideDisplay) => self.display_hidden = !self.display_hidden,
            Some(Action::HitShapes) => match self.rooms.open_room() {
                Some(room) => room.outlines = room.outlines.next(),
                None => self.hit_shapes_shown = !self.hit_shapes_shown,
            },
            Some(Action::FrameFigures) => self.figures_shown = !self.figures_shown,
            Some(Action::LargeMap) => self.large_map_shown = !self.large_map_shown,
            _ => {}
        }
    }

    fn step(&mut self) -> Result<(), Failure> {
        let actions = self.controls.take();
        self.step_with(&actions)
    }

    fn arrive(&mut self) -> Result<(), Failure> {
        self.await_workers()
    }

    fn own(&mut self, order: &Order) -> Result<(), Failure> {
        match order {
            Order::New(world) => self.enter_new(world),
            Order::Load(name) => self.enter_saved(name),
            Order::Save => self.save(),
            Order::List => say::list(&self.worlds.list()?),
            Order::Hold(input, time_s) => {
                self.press(*input);
                self.pass(*time_s)?;
                self.controls.input(*input, false);
                Ok(())
            }
            Order::Wait(time_s) => self.pass(*time_s),
            Order::Settle(limit_s) => self.settle(*limit_s),
            Order::Probe => self.probe(),
            Order::Shot(file) => self.shoot(file),
            Order::Perf(time_s) => self.perf(*time_s),
            Order::Room(order) => self.order_room(order),
            Order::Edit(words) => self.edit_room(words),
            // `quit` ends the loop over the lines; the rest is carried out alike everywhere.
            _ => Ok(()),
        }
    }
}

fn write_picture(picture: &RgbaImage, path: &Path) -> Result<(), Failure> {
    picture.save(path).map_err(|e| {
        let file = path.display();
        Failure::Runtime(format!("The picture {file} could not be written: {e}"))
    })
}

/// Whole steps of a time.
pub(crate) fn steps_in(time_s: f64) -> u64 {
    (time_s / STEP_S).round() as u64
}
