//! Runs a script's orders in simulated time: the same script gives the same probes.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use antipode_geometry::ChartPoint;
use antipode_scene::tuning::STEP_S;
use antipode_scene::{Actions, Scene};
use glam::DVec3;

use super::parse::{Line, Order, Setting};
use super::{Shooting, say};
use crate::bindings::{Command, Input};
use crate::cli::{Adapter, Common};
use crate::controls::Controls;
use crate::failure::Failure;
use crate::hud;
use crate::perf::{Report, Times};
use crate::picture::Studio;
use crate::session::{NewWorld, Session, Worlds};

/// Longest time a step may wait for the chunk workers before the script is stopped.
const PATIENCE: Duration = Duration::from_mins(1);

/// A running script.
#[derive(Debug)]
pub struct Runner {
    common: Common,
    worlds: Worlds,
    shooting: Shooting,
    controls: Controls,
    session: Option<Session>,
    studio: Option<Studio>,
    worlds_opened: u64,
    fps: Option<f64>,
    display_hidden: bool,
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
            fps: None,
            display_hidden: false,
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
            Some(session) => Ok(session.scene.close()?),
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
                let has_dial = self.scene()?.dial().range().is_some();
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
        if self.controls.input(input, true) == Some(Command::HideDisplay) {
            self.display_hidden = !self.display_hidden;
        }
    }

    fn scene(&mut self) -> Result<&mut Scene, Failure> {
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

    fn enter(&mut self, session: Session) -> Result<(), Failure> {
        self.worlds_opened += 1;
        self.controls.release_all();
        self.session = Some(session);
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

    fn await_workers(&mut self) -> Result<(), Failure> {
        if self.scene()?.wait_for_step(PATIENCE) {
            Ok(())
        } else {
            Err(Failure::Runtime(
                "The land around the player was not made within a minute.".to_owned(),
            ))
        }
    }

    fn tell_notices(&mut self) {
        if let Ok(scene) = self.scene() {
            for notice in scene.take_notices() {
                tracing::warn!("{notice}");
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
        say::probe(&probe, self.fps, adapter)
    }

    fn set(&mut self, setting: Setting) -> Result<(), Failure> {
        let scene = self.scene()?;
        match setting {
            Setting::Time(time_s) => scene.set_time_of_day_s(time_s),
            Setting::Curvature(value) => {
                if !scene.dial_mut().set(value) {
                    return Err(Failure::Usage(
                        "this space has no curvature dial".to_owned(),
                    ));
                }
                scene.refresh_marker();
            }
            Setting::ViewDistance(chunks) => scene.set_view_distance(chunks),
            Setting::Health(health) => scene.set_health(health),
            Setting::Fly(on) => scene.set_flying(on),
        }
        Ok(())
    }

    fn teleport(&mut self, point: ChartPoint) -> Result<(), Failure> {
        let scene = self.scene()?;
        let inside = match scene.strategy().rim_m() {
            Some(rim) => point.pos.x.hypot(point.pos.z) <= rim + 1.0,
            None => point.hemisphere == antipode_geometry::Hemisphere::A,
        };
        if !inside {
            return Err(Failure::Usage(
                "that point does not lie in this world".to_owned(),
            ));
        }
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
        let display = hud::model(&session.scene, self.fps.unwrap_or(0.0) as f32, None);
        let picture = studio.shoot(&frame, (!self.display_hidden).then_some(&display))?;
        picture.save(&path).map_err(|e| {
            Failure::Runtime(format!(
                "The picture {} could not be written: {e}",
                path.display()
            ))
        })
    }

    fn open_studio(&mut self) -> Result<(), Failure> {
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

    fn perf(&mut self, time_s: f64) -> Result<(), Failure> {
        let draws = self.common.adapter != Adapter::None;
        if draws {
            self.open_studio()?;
        }
        let mut times = PerfTimes::default();
        for _ in 0..steps_in(time_s).max(1) {
            self.perf_frame(&mut times)?;
        }
        self.fps = times.frame.percentiles().map(|p| 1000.0 / p.p50);
        say::line(&times.report(draws))
    }

    /// One step and, where there is an adapter, one picture, each timed by what the main thread does.
    fn perf_frame(&mut self, times: &mut PerfTimes) -> Result<(), Failure> {
        let id = self.worlds_opened;
        let actions = self.controls.take();
        let began = Instant::now();
        self.scene()?.step(&actions);
        let stepped = began.elapsed();
        let waiting = Instant::now();
        self.await_workers()?;
        let waited = waiting.elapsed();
        let building = Instant::now();
        let aspect = self.studio.as_ref().map_or(16.0 / 9.0, Studio::aspect);
        let frame = self
            .scene()?
            .frame(antipode_scene::tuning::FOV_Y_RAD, aspect, id);
        let built = building.elapsed();
        times.step.push(stepped);
        if self.scene()?.marker().is_some_and(|marker| marker.active) {
            times.edit.push(stepped + waited);
        }
        times.wait.push(waited);
        times.main.push(stepped + built);
        if let Some(studio) = self.studio.as_mut() {
            let drawing = Instant::now();
            let stats = studio.draw(&frame)?;
            times.frame.push(stepped + built + drawing.elapsed());
            times.triangles = stats.triangles as u64;
            times.draws = stats.draws as u64;
            if let Some(ms) = stats.gpu_ms {
                times.gpu.push_ms(f64::from(ms));
            }
        }
        Ok(())
    }
}

#[derive(Debug, Default)]
struct PerfTimes {
    frame: Times,
    step: Times,
    main: Times,
    gpu: Times,
    wait: Times,
    edit: Times,
    triangles: u64,
    draws: u64,
}

impl PerfTimes {
    fn report(&self, drawn: bool) -> Report {
        Report {
            frame_ms: if drawn {
                self.frame.percentiles()
            } else {
                None
            },
            step_ms: self.step.percentiles(),
            main_ms: self.main.percentiles(),
            gpu_ms: self.gpu.percentiles(),
            wait_ms: self.wait.percentiles(),
            triangles: self.triangles,
            draws: self.draws,
            edit_latency_ms: self.edit.percentiles(),
        }
    }
}

fn steps_in(time_s: f64) -> u64 {
    (time_s / STEP_S).round() as u64
}
