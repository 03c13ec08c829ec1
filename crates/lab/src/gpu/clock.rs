//! By which clock frames are timed, and until when.

use std::time::Instant;

use antipode_render::Gpu;

use crate::LabError;
use crate::compute::failed;
use crate::speed::clock::worked_s;
use crate::speed::stage::Drawn;

/// What tells how long a frame takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// The adapter's timestamps around a frame's passes.
    Timestamps,
    /// The time that the program's threads were at work, of which a software adapter's are some.
    Threads,
    /// The wall clock, from submission to the last pixel.
    Wall,
}

impl Clock {
    /// What single frames are timed by. A software adapter stamps a pass when it is queued, not when its threads are
    /// done, so there the wall clock has to do.
    pub fn of_frames(gpu: &Gpu) -> Self {
        let stamps = gpu
            .device
            .features()
            .contains(wgpu::Features::TIMESTAMP_QUERY);
        if stamps && !gpu.is_software() {
            Self::Timestamps
        } else {
            Self::Wall
        }
    }

    /// What costs are timed by: on a software adapter what its threads worked, which other programs do not add to, where
    /// the system tells.
    pub fn of_costs(gpu: &Gpu) -> Self {
        if gpu.is_software() && worked_s().is_some() {
            Self::Threads
        } else {
            Self::of_frames(gpu)
        }
    }

    /// The clock in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Timestamps => "the adapter's own timestamps",
            Self::Threads => "the time that all threads of the program worked",
            Self::Wall => "the wall clock, from submission to the last pixel",
        }
    }

    /// Milliseconds of a frame; those by timestamps are of the frame drawn before on the same stage, and of none where
    /// that was the first.
    pub fn ms(self, drawn: &Drawn) -> Option<f64> {
        match self {
            Self::Timestamps => drawn.stats.gpu_ms.map(f64::from),
            Self::Threads => drawn.worked_ms,
            Self::Wall => Some(drawn.wall_ms - drawn.recorded_ms),
        }
    }

    /// The failure of an adapter that has the clock and tells nothing by it.
    pub fn silent(self, gpu: &Gpu) -> LabError {
        let why = format!("it told no time by {}", self.words());
        failed(gpu, &why)
    }
}

/// Until when a part may go on.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    began: Instant,
    seconds: f64,
}

impl Limit {
    /// So many seconds from now on.
    pub fn of(seconds: f64) -> Self {
        Self {
            began: Instant::now(),
            seconds,
        }
    }

    /// Whether it has passed.
    pub fn is_over(&self) -> bool {
        self.began.elapsed().as_secs_f64() >= self.seconds
    }
}
