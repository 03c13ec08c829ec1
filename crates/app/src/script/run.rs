//! Runs a script's orders in simulated time: the same script gives the same probes.

use std::path::PathBuf;
use std::time::Duration;

use antipode_geometry::{ChartPoint, Hemisphere, Strategy};
use antipode_scene::tuning::STEP_S;
use antipode_scene::{Actions, Scene};
use glam::DVec3;

use super::parse::{Line, Order, Setting};
use super::{Shooting, say};
use crate::bindings::{Command, Input};
use crate::cli::{Adapter, Common};
use crate::controls::Controls;
use crate::drawn::Drawn;
use crate::failure::Failure;
use crate::hud;
use crate::picture::Studio;
use crate::session::{NewWorld, Session, Worlds};

/// Longest time a step may wait for the chunk workers before the script is stopped.
const PATIENCE: Duration = Duration::from_mins(1);
/// How far past its rim a hemisphere's chart may still be named, in metres.
const RIM_SLACK_M: f64 = 1.0;

/// A running script.
#[derive(Debug)]
pub struct Runner {
    pub(super) common: Common,
    worlds: Worlds,
    shooting: Shooting,
    pub(super) controls: Controls,
    pub(super) session: Option<Session>,
    pub(super) studio: Option<Studio>,
    pub(super) worlds_opened: u64,
    /// Median time of a measured frame, and of the adapter's share in it.
    pub(super) frame_ms: Option<f64>,
    pub(super) gpu_ms: Option<f64>,
    /// What the last picture of the open world was drawn with.
    pub(super) drawn: Option<Drawn>,
    display_hidden: bool,
    figures_shown: bool,
}

impl Runner {
    /// A script that has not begun.
    pub fn new(common: Common, shooting: Shooting) -> Self {
        let worlds = Worlds::new(&common);
        Self {
            common,
            worlds,
            shooting,
            controls: Controls::default(),
            session: None,
            studio: None,
            worlds_opened: 0,
            frame_ms: None,
            gpu_ms: None,
            drawn: None,
            display_hidden: false,
            figures_shown: false,
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
            self.obey(order).map_err(|failure| match failure {
                Failure::Usage(what) | Failure::Script(what) => {
                    Failure::Script(format!("line {number}: {what}"))
                }
                other => Failure::Runtime(format!("line {number}: {other}")),
            })?;
        }
        Ok(())
    }

    /// Commits and closes the open world.
    ///
    /// # Errors
    /// When the last commit failed.
    pub fn close(&mut self) -> Result<(), Failure> {
        match self.session.take() {
            Some(session) => session
                .close()
                .map_err(|unclosed| Failure::Streaming(unclosed.error)),
            None => Ok(()),
        }
    }

    fn obey(&mut self, order: &Order) -> Result<(), Failure> {
        match order {
            Order::New(world) => self.enter_new(world),
            Order::Load(name) => self.enter_saved(name),
            Order::Save => self.save(),
            Order::Delete(name) => self.delete(name),
            Order::List => say::list(&self.worlds.list()?),
            Order::Quit => Ok(()),
            Order::Hold(input, time_s) => {
                self.press(*input);
                self.pass(*time_s)?;
                self.controls.input(*input, false);
                Ok(())
            }
            Order::Press(input, down) => {
                if *down {
                    self.press(*input);
                } else {
                    self.controls.input(*input, false);
                }
                Ok(())
            }
            Order::Tap(input) => {
                self.press(*input);
                self.step()?;
                self.controls.input(*input, false);
                Ok(())
            }
            Order::Look(dx, dy) => {
                self.controls.motion(*dx, *dy);
                self.step()
            }
            Order::Aim(yaw, pitch) => {
                self.scene()?.aim(yaw.to_radians(), pitch.to_radians());
                Ok(())
            }
            Order::Scroll(notches) => {
                let has_dial = self.scene()?.lens().range().is_some();
                self.controls.wheel(*notches, has_dial);
                self.step()
            }
            Order::Wait(time_s) => self.pass(*time_s),
            Order::Settle(limit_s) => self.settle(*limit_s),
            Order::Probe => self.probe(),
            Order::Shot(file) => self.shoot(file),
            Order::Set(setting) => self.set(*setting),
            Order::Give(item, count) => {
                if self.scene()?.inventory_mut().give(*item, *count) {
                    Ok(())
                } else {
                    Err(Failure::Usage("there is no free slot".to_owned()))
                }
            }
            Order::Teleport(place, hemisphere) => {
                self.teleport(ChartPoint::new(*hemisphere, DVec3::from_array(*place)))
            }
            Order::Perf(time_s) => self.perf(*time_s),
        }
    }

    fn press(&mut self, input: Input) {
        match self.controls.input(input, true) {
            Some(Command::HideDisplay) => self.display_hidden = !self.display_hidden,
            Some(Command::FrameFigures) => self.figures_shown = !self.figures_shown,
            _ => {}
        }
    }

    pub(super) fn scene(&mut self) -> Result<&mut Scene, Failure> {
        self.session
            .as_mut()
            .map(|session| &mut session.scene)
            .ok_or_else(|| Failure::Usage("no world is open; begin with new or load".to_owned()))
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
        let why = scene
            .save_problem()
            .unwrap_or_else(|| "the disk did not answer in time".to_owned());
        Err(Failure::Runtime(why))
    }

    fn delete(&mut self, name: &str) -> Result<(), Failure> {
        let slug = self.worlds.saves().find(name)?.slug;
        if self
            .session
            .as_ref()
            .is_some_and(|session| session.slug == slug)
        {
            return Err(Failure::Usage(format!(
                "\"{name}\" is open and cannot be deleted"
            )));
        }
        Ok(self.worlds.saves().delete(&slug)?)
    }

    /// One step of the simulation, and all the work it caused.
    fn step(&mut self) -> Result<(), Failure> {
        let actions = self.controls.take();
        self.step_with(&actions)
    }

    fn step_with(&mut self, actions: &Actions) -> Result<(), Failure> {
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
        self.scene()?;
        for _ in 0..steps_in(time_s) {
            self.step()?;
        }
        Ok(())
    }

    fn settle(&mut self, limit_s: f64) -> Result<(), Failure> {
        let limit = Duration::from_secs_f64(limit_s);
        if self.scene()?.settle(limit) {
            Ok(())
        } else {
            Err(Failure::Runtime(format!(
                "Chunk work was still pending after {limit_s} s."
            )))
        }
    }

    fn probe(&mut self) -> Result<(), Failure> {
        let probe = self.scene()?.probe();
        let adapter = self
            .studio
            .as_ref()
            .map_or("none", |studio| studio.adapter_name());
        let fps = self.frame_ms.map(|ms| 1000.0 / ms);
        say::probe(&probe, fps, adapter, self.drawn.as_ref())
    }

    fn set(&mut self, setting: Setting) -> Result<(), Failure> {
        let scene = self.scene()?;
        match setting {
            Setting::Time(time_s) => scene.set_time_of_day_s(time_s),
            Setting::Curvature(value) => {
                possible(
                    scene.set_curvature(value),
                    "this space has no curvature dial",
                )?;
            }
            Setting::Map(map) => possible(scene.set_map(map), "this space has no other map")?,
            Setting::Bend(value) => {
                possible(scene.set_bend(value), "only a flat world can be bent")?;
            }
            Setting::Quality(quality) => {
                scene.set_quality(quality);
                self.worlds.set_quality(quality);
            }
            Setting::ViewDistance(chunks) => scene.set_view_distance(chunks),
            Setting::Health(health) => scene.set_health(health),
            Setting::Fly(on) => scene.set_flying(on),
        }
        Ok(())
    }

    fn teleport(&mut self, point: ChartPoint) -> Result<(), Failure> {
        let scene = self.scene()?;
        check_place(&**scene.strategy(), point).map_err(Failure::Usage)?;
        scene.teleport(point);
        self.await_workers()?;
        self.scene()?.refresh_marker();
        Ok(())
    }

    fn shoot(&mut self, file: &str) -> Result<(), Failure> {
        let path = match &self.shooting {
            Shooting::Here => PathBuf::from(file),
            Shooting::Into(dir) => dir.join(file),
        };
        self.open_studio()?;
        let id = self.worlds_opened;
        let (Some(studio), Some(session)) = (self.studio.as_mut(), self.session.as_mut()) else {
            return Err(Failure::Usage(
                "no world is open; begin with new or load".to_owned(),
            ));
        };
        let frame = session
            .scene
            .frame(antipode_scene::tuning::FOV_Y_RAD, studio.aspect(), id);
        let scene = &session.scene;
        let drawn = &mut self.drawn;
        let (frame_ms, gpu_ms) = (self.frame_ms, self.gpu_ms);
        let fps = frame_ms.map_or(0.0, |ms| 1000.0 / ms) as f32;
        let picture = studio.shoot(&frame, |stats| {
            let drawn = drawn.insert(Drawn::new(stats, frame.quality));
            let figures = self
                .figures_shown
                .then(|| drawn.figures(scene, frame_ms, gpu_ms));
            (!self.display_hidden).then(|| hud::model(scene, fps, figures))
        })?;
        picture.save(&path).map_err(|e| {
            Failure::Runtime(format!(
                "The picture {} could not be written: {e}",
                path.display()
            ))
        })
    }

    pub(super) fn open_studio(&mut self) -> Result<(), Failure> {
        if self.studio.is_none() {
            if self.common.adapter == Adapter::None {
                return Err(Failure::Usage(
                    "there are no pictures with --adapter none".to_owned(),
                ));
            }
            self.studio = Some(Studio::new(&self.common)?);
        }
        Ok(())
    }
}

/// Whether a player can stand there; a sentence when not.
fn check_place(strategy: &dyn Strategy, point: ChartPoint) -> Result<(), String> {
    match strategy.rim_m() {
        Some(rim_m) => {
            let from_centre_m = point.pos.x.hypot(point.pos.z);
            if from_centre_m > rim_m + RIM_SLACK_M {
                return Err(format!(
                    "that point lies {from_centre_m:.1} m from the hemisphere's centre, beyond its rim at {rim_m:.1} m"
                ));
            }
        }
        None if point.hemisphere == Hemisphere::B => {
            return Err("this space has no hemisphere B".to_owned());
        }
        None => {}
    }
    match strategy.limits() {
        Some(limits) if !(limits.bedrock_m..=limits.ceiling_m).contains(&point.pos.y) => {
            Err(format!(
                "the height {} m is out of this world's range ({:.1} to {:.1} m)",
                point.pos.y, limits.bedrock_m, limits.ceiling_m
            ))
        }
        _ => Ok(()),
    }
}

/// What a setting came to: a mistake of the script where the world has no such thing.
fn possible(done: bool, otherwise: &str) -> Result<(), Failure> {
    if done {
        Ok(())
    } else {
        Err(Failure::Usage(otherwise.to_owned()))
    }
}

/// Whole steps of a time.
pub(super) fn steps_in(time_s: f64) -> u64 {
    (time_s / STEP_S).round() as u64
}

#[cfg(test)]
mod tests {
    use antipode_geometry::{Geometry, strategy};

    use super::*;

    #[test]
    fn nobody_is_sent_out_of_the_world() {
        let sphere = strategy(Geometry::Spherical, 32.0);
        let at = |x: f64, y: f64, hemisphere| {
            check_place(&*sphere, ChartPoint::new(hemisphere, DVec3::new(x, y, 0.0)))
        };
        assert_eq!(at(0.0, 20.0, Hemisphere::B), Ok(()));
        assert_eq!(at(50.0, 20.0, Hemisphere::A), Ok(()));
        assert!(at(60.0, 20.0, Hemisphere::A).is_err_and(|said| said.contains("rim")));
        for y in [0.0, 60.0, 1e8] {
            assert!(at(0.0, y, Hemisphere::A).is_err_and(|said| said.contains("height")));
        }
        let flat = strategy(Geometry::Euclidean, f64::INFINITY);
        let far = DVec3::new(1e8, 1e8, -1e8);
        assert_eq!(check_place(&*flat, ChartPoint::a(far)), Ok(()));
        assert!(check_place(&*flat, ChartPoint::new(Hemisphere::B, far)).is_err());
    }
}
