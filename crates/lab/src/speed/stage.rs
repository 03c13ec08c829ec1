//! An adapter with a renderer, and the timing of frames against each other.

use std::time::Instant;

use antipode_render::{DrawStats, FurtherView, Gpu, Offscreen, Options, Renderer, ShadowQuality};
use antipode_scene::frame::Frame;

use crate::speed::clock::{median, worked_s};
use crate::{Effort, LabError};

/// Format of pictures in memory.
pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// A renderer and a picture of fixed size.
pub struct Stage<'g> {
    gpu: &'g Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl<'g> Stage<'g> {
    /// A stage for pictures of that size without shadows, with the samples per pixel that the game takes on this adapter.
    ///
    /// # Errors
    /// When the renderer cannot be set up.
    pub fn new(gpu: &'g Gpu, size: (u32, u32)) -> Result<Self, LabError> {
        Self::shadowed(gpu, size, ShadowQuality::Off)
    }

    /// The same, with shadows of a quality.
    ///
    /// # Errors
    /// As [`Stage::new`].
    pub fn shadowed(
        gpu: &'g Gpu,
        (width, height): (u32, u32),
        shadows: ShadowQuality,
    ) -> Result<Self, LabError> {
        let samples = if gpu.is_software() { 1 } else { 4 };
        let options = Options {
            samples,
            scale: 1.0,
            output_format: FORMAT,
            shadows,
            surfaces: false,
        };
        let mut renderer = Renderer::new(gpu, options)?;
        renderer.resize(width, height);
        let offscreen = Offscreen::new(gpu, width, height, FORMAT);
        Ok(Self {
            gpu,
            renderer,
            offscreen,
        })
    }

    /// Lets the next frame be complete, however long that takes.
    pub fn complete_next(&mut self) {
        self.renderer.complete_next();
    }

    /// Draws a frame and waits for it.
    ///
    /// # Errors
    /// When the adapter fails.
    pub fn draw(&mut self, frame: &Frame) -> Result<Drawn, LabError> {
        self.draw_with(frame, &[])
    }

    /// Draws a frame and further views of what it shows, and waits for all of them. The triangles told are those of all.
    ///
    /// # Errors
    /// When the adapter fails.
    pub fn draw_with(
        &mut self,
        frame: &Frame,
        further: &[FurtherView<'_>],
    ) -> Result<Drawn, LabError> {
        let worked_s = self.worked_s();
        let began = Instant::now();
        let mut encoder = self.gpu.encoder();
        let target = self.offscreen.view();
        let (mut stats, others) = self
            .renderer
            .draw_views(frame, further, &mut encoder, target);
        stats.triangles += others.iter().map(|it| it.triangles).sum::<usize>();
        let recorded_ms = began.elapsed().as_secs_f64() * 1e3;
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.wait()?;
        let wall_ms = began.elapsed().as_secs_f64() * 1e3;
        match self.gpu.take_error() {
            Some(why) => Err(LabError::Compute {
                adapter: self.gpu.name().to_owned(),
                why,
            }),
            None => Ok(Drawn {
                stats,
                recorded_ms,
                wall_ms,
                worked_ms: self
                    .worked_s()
                    .zip(worked_s)
                    .map(|(after, before)| (after - before) * 1e3),
            }),
        }
    }

    /// The threads' time so far, where it is that of the adapter too.
    fn worked_s(&self) -> Option<f64> {
        if self.gpu.is_software() {
            worked_s()
        } else {
            None
        }
    }

    /// The picture last drawn, rows of red, green, blue and opacity.
    ///
    /// # Errors
    /// When the adapter fails.
    pub fn picture(&self) -> Result<Vec<[u8; 4]>, LabError> {
        let picture = self.offscreen.read(self.gpu)?;
        Ok(picture.pixels().map(|p| p.0).collect())
    }
}

/// One frame drawn.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    /// What was drawn.
    pub stats: DrawStats,
    /// Milliseconds that the main thread planned and recorded.
    pub recorded_ms: f64,
    /// Milliseconds from then on to the last pixel, and those.
    pub wall_ms: f64,
    /// Milliseconds that the threads of a software adapter worked, where the system tells.
    pub worked_ms: Option<f64>,
}

/// What one of several frames took.
#[derive(Clone, Copy, Debug, Default)]
pub struct Taken {
    /// What it cost, milliseconds: a graphics card's own time, the threads' time of a software adapter, or where
    /// neither can be told the wall clock's.
    pub cost_ms: f64,
    /// Milliseconds by the wall clock, from the first command to the last pixel.
    pub wall_ms: f64,
    /// Those of them in which the main thread planned and recorded.
    pub recorded_ms: f64,
    /// What was drawn.
    pub stats: DrawStats,
}

/// Times of one round of a rival.
#[derive(Clone, Debug, Default)]
struct Times {
    own: Vec<f64>,
    wall: Vec<f64>,
    recorded: Vec<f64>,
}

/// Draws the frames in turns, each on a stage of its own, so that nobody's meshes are exchanged for another's. Meshes
/// are sent before anything is timed. Returns the stages, each with its last picture, and for each the least of the
/// rounds' medians.
///
/// # Errors
/// When the adapter fails.
pub fn race(
    gpu: &Gpu,
    size: (u32, u32),
    mut frames: Vec<Frame>,
    effort: Effort,
) -> Result<(Vec<Stage<'_>>, Vec<Taken>), LabError> {
    let (rounds, turns) = if effort.quick { (2, 3) } else { (4, 6) };
    let mut stages = Vec::new();
    let mut taken = Vec::new();
    for frame in &mut frames {
        let mut stage = Stage::new(gpu, size)?;
        // All meshes, with their edges halved, and the figures of that state.
        stage.renderer.complete_next();
        stage.draw(frame)?;
        stage.renderer.complete_next();
        let stats = stage.draw(frame)?.stats;
        let no = f64::INFINITY;
        taken.push(Taken {
            cost_ms: no,
            wall_ms: no,
            recorded_ms: no,
            stats,
        });
        stages.push(stage);
    }
    for _ in 0..rounds {
        let times = round(&mut stages, &frames, turns)?;
        for (taken, mut times) in taken.iter_mut().zip(times) {
            taken.wall_ms = taken.wall_ms.min(median(&mut times.wall));
            taken.recorded_ms = taken.recorded_ms.min(median(&mut times.recorded));
            taken.cost_ms = taken.cost_ms.min(median(&mut times.own));
        }
    }
    for taken in &mut taken {
        if !taken.cost_ms.is_finite() {
            taken.cost_ms = taken.wall_ms;
        }
    }
    Ok((stages, taken))
}

/// Every frame drawn in turn, to and fro, so that nobody always comes after the same one.
fn round(stages: &mut [Stage<'_>], frames: &[Frame], turns: usize) -> Result<Vec<Times>, LabError> {
    let mut times = vec![Times::default(); frames.len()];
    for turn in 0..turns {
        for step in 0..frames.len() {
            let index = if turn % 2 == 0 {
                step
            } else {
                frames.len() - 1 - step
            };
            let drawn = stages[index].draw(&frames[index])?;
            times[index].wall.push(drawn.wall_ms);
            times[index].recorded.push(drawn.recorded_ms);
            times[index].own.extend(drawn.worked_ms);
            // A graphics card tells its time of the frame before, which was the same one.
            let told = drawn
                .stats
                .gpu_ms
                .filter(|_| !stages[index].gpu.is_software());
            times[index].own.extend(told.map(f64::from));
        }
    }
    Ok(times)
}
