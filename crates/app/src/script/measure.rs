//! `perf`: what a frame costs the main thread and the adapter.

use std::time::{Duration, Instant};

use super::host::Host;
use super::run::{Runner, steps_in};
use super::say;
use crate::common::Adapter;
use crate::drawn::Drawn;
use crate::failure::Failure;
use crate::options;
use crate::perf::{Report, Times};
use crate::picture::Studio;

/// Time a measured frame gives to finished chunks.
const CHUNK_BUDGET: Duration = Duration::from_millis(2);

impl Runner {
    /// Measures over some simulated seconds and prints the times.
    pub(super) fn perf(&mut self, time_s: f64) -> Result<(), Failure> {
        let draws = self.common.adapter != Adapter::None;
        if draws {
            self.open_studio()?;
        }
        let mut times = PerfTimes::default();
        for _ in 0..steps_in(time_s).max(1) {
            self.perf_frame(&mut times)?;
        }
        self.frame_ms = times.frame.percentiles().map(|p| p.p50);
        self.gpu_ms = times.gpu.percentiles().map(|p| p.p50);
        say::line(&times.report(draws))
    }

    /// One step and, where there is an adapter, one picture, each timed by what the main thread does.
    fn perf_frame(&mut self, times: &mut PerfTimes) -> Result<(), Failure> {
        let id = self.worlds_opened;
        let actions = self.controls.take();
        let began = Instant::now();
        let scene = self.scene()?;
        scene.step(&actions);
        let stepped = began.elapsed();
        // What is finished is taken in as the game in its window does; the rest is waited for.
        scene.pump(CHUNK_BUDGET);
        let mut main = began.elapsed();
        let waiting = Instant::now();
        self.await_workers()?;
        let waited = waiting.elapsed();
        let building = Instant::now();
        let aspect = self.studio.as_ref().map_or(16.0 / 9.0, Studio::aspect);
        let scene = self.scene()?;
        let fov_y_rad = scene.viewing().fov_y_rad;
        let mut frame = scene.frame(fov_y_rad, aspect, id);
        let software = self.studio.as_ref().is_some_and(Studio::is_software);
        options::fit_mirror(&mut frame, &self.config.settings, software);
        main += building.elapsed();
        times.step.push(stepped);
        if self.scene()?.marker().is_some_and(|marker| marker.active) {
            times.edit.push(began.elapsed());
        }
        times.wait.push(waited);
        if let Some(studio) = self.studio.as_mut() {
            let drawing = Instant::now();
            let (stats, recorded) = studio.draw(&frame)?;
            self.drawn = Some(Drawn::new(&stats, frame.view.quality));
            times.frame.push(main + drawing.elapsed());
            main += recorded;
            times.triangles = stats.triangles as u64;
            times.draws = stats.draws as u64;
            if let Some(ms) = stats.gpu_ms {
                times.gpu.push_ms(f64::from(ms));
            }
        }
        times.main.push(main);
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
