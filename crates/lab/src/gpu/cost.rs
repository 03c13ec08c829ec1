//! What a million triangles and a million pixels cost in each space, apart: frames of many triangles and few pixels,
//! frames of few triangles and many pixels, and the [fit](super::fit) through both.
//!
//! *Triangles.* All land in view, hidden or not (quality *exact*), in views of 64 by 36 pixels; some frames have more of
//! the same view than others, and so more of the same triangles. Narrower views would not do: of what they send most is
//! outside, and costs less. *Pixels.* The ground at one's feet, some thousand triangles (quality *fast*, which divides
//! none), in pictures of up to some million pixels, with as many further views of 64 by 36 pixels as tell what a view costs.

use antipode_render::{FurtherView, Gpu, Offscreen, ViewTarget};
use antipode_scene::frame::{Frame, Quality, View};

use super::amount::{Amount, Size};
use super::clock::{Clock, Limit};
use super::fit::{Fit, Load};
use super::worlds::World;
use crate::LabError;
use crate::speed::clock::median;
use crate::speed::stage::{Drawn, FORMAT, Stage};

/// Pictures of next to no pixels.
const TINY: Size = (64, 36);
/// In how many parts the views are added in which triangles are counted.
const PARTS: usize = 4;
/// Elevation from which nothing but the ground nearby is seen, radians.
const DOWN_RAD: f64 = -1.25;
/// Frames drawn one after the other before it is another's turn. The first is not timed: what timestamps tell in it is
/// of the frame before.
const GROUP: usize = 4;

/// What was found in one space.
#[derive(Clone, Debug)]
pub struct Found {
    /// The space.
    pub space: &'static str,
    /// The frames, those of many triangles first, each with the least of its groups' medians.
    pub loads: Vec<Load>,
    /// The costs; none where the frames do not tell them apart.
    pub fit: Option<Fit>,
    /// Rounds through the frames.
    pub rounds: usize,
}

/// Where the frames are drawn: one stage for tiny pictures, and one for each size of the others.
struct Rig<'g> {
    gpu: &'g Gpu,
    clock: Clock,
    amount: &'g Amount,
    tiny: Stage<'g>,
    large: Vec<(Size, Stage<'g>)>,
    /// What the further views are drawn into.
    aside: Offscreen,
}

/// A frame to be timed.
struct Rival {
    frame: Frame,
    /// Which of the rig's large stages it is drawn on; the tiny one where none.
    large: Option<usize>,
    views: usize,
    pixels: usize,
    triangles: usize,
    least_ms: f64,
}

/// Measures every world.
///
/// # Errors
/// When the adapter fails, or tells no times.
pub fn measured(gpu: &Gpu, worlds: &[World], amount: &Amount) -> Result<Vec<Found>, LabError> {
    let large = amount
        .pixel_sizes
        .iter()
        .map(|&size| Ok((size, Stage::new(gpu, size)?)));
    let mut rig = Rig {
        gpu,
        clock: Clock::of_costs(gpu),
        amount,
        tiny: Stage::new(gpu, TINY)?,
        large: large.collect::<Result<_, LabError>>()?,
        aside: Offscreen::new(gpu, TINY.0, TINY.1, FORMAT),
    };
    worlds.iter().map(|world| rig.costs(world)).collect()
}

/// The frame without fog, in that quality.
fn bare(frame: &Frame, quality: Quality) -> Frame {
    frame.clone().with_view(|view| {
        view.quality = quality;
        view.fog_distance_m = View::NO_FOG_M;
    })
}

fn pixels((width, height): Size) -> usize {
    width as usize * height as usize
}

impl Rig<'_> {
    fn rivals(&self, world: &World) -> Vec<Rival> {
        let rival = |frame, large, (views, size)| Rival {
            frame,
            large,
            views,
            pixels: (views - 1) * pixels(TINY) + pixels(size),
            triangles: 0,
            least_ms: f64::INFINITY,
        };
        let most = self.amount.views;
        let many_triangles = (1..=PARTS).map(|part| {
            let views = (most * part / PARTS).max(1);
            rival(bare(&world.frame, Quality::Exact), None, (views, TINY))
        });
        let down = || {
            let frame = bare(&world.frame, Quality::Fast);
            frame.with_view(|view| view.eye.pitch = DOWN_RAD)
        };
        let sizes = self.large.iter().map(|(size, _)| *size).enumerate();
        let many_pixels = sizes.map(|(place, size)| rival(down(), Some(place), (most, size)));
        many_triangles.chain(many_pixels).collect()
    }

    fn costs(&mut self, world: &World) -> Result<Found, LabError> {
        let mut rivals = self.rivals(world);
        for rival in &mut rivals {
            // Land and shaders are made, and edges halved, before anything is timed.
            self.draw(rival, true)?;
            rival.triangles = self.draw(rival, true)?.stats.triangles;
        }
        let limit = Limit::of(self.amount.cost_s);
        let mut rounds = 0;
        while rounds < self.amount.rounds && !(rounds > 0 && limit.is_over()) {
            let forth = rounds % 2 == 0;
            for step in 0..rivals.len() {
                let place = if forth { step } else { rivals.len() - 1 - step };
                self.group(&mut rivals[place])?;
            }
            rounds += 1;
        }
        let loads: Vec<Load> = rivals.iter().map(Rival::load).collect();
        Ok(Found {
            space: world.name(),
            fit: Fit::of(&loads),
            loads,
            rounds,
        })
    }

    /// Draws a rival several times, and keeps the median if it is the least so far.
    fn group(&mut self, rival: &mut Rival) -> Result<(), LabError> {
        let mut times = Vec::new();
        for turn in 0..GROUP {
            let drawn = self.draw(rival, false)?;
            if turn > 0 {
                times.extend(self.clock.ms(&drawn));
                rival.triangles = drawn.stats.triangles;
            }
        }
        if times.is_empty() {
            return Err(self.clock.silent(self.gpu));
        }
        rival.least_ms = rival.least_ms.min(median(&mut times));
        Ok(())
    }

    fn draw(&mut self, rival: &Rival, complete: bool) -> Result<Drawn, LabError> {
        let further = FurtherView {
            view: &rival.frame.view,
            size: TINY,
            target: ViewTarget::Texture(self.aside.view()),
        };
        let stage = match rival.large.and_then(|place| self.large.get_mut(place)) {
            Some((_, stage)) => stage,
            None => &mut self.tiny,
        };
        if complete {
            stage.complete_next();
        }
        stage.draw_with(&rival.frame, &vec![further; rival.views - 1])
    }
}

impl Rival {
    fn load(&self) -> Load {
        Load {
            views: self.views,
            triangles_m: self.triangles as f64 * 1e-6,
            pixels_m: self.pixels as f64 * 1e-6,
            ms: self.least_ms,
        }
    }
}
