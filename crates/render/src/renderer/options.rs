//! Options for drawing pictures, and statistics of drawing one.

use wgpu::TextureFormat;

use crate::draw_list::DrawCount;
use crate::error::RenderError;
use crate::plan::PlanStats;
use crate::shadow::{ShadowQuality, ShadowStats};

/// How pictures are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Samples a pixel: 4, or 1 where fill is dear, as on software adapters.
    pub samples: u32,
    /// Share of the target's resolution that is drawn along each side, 0.1 to 1; scaled up to the target.
    pub scale: f32,
    /// Format of the targets.
    pub output_format: TextureFormat,
    /// How shadows of the key light are drawn.
    pub shadows: ShadowQuality,
    /// Whether land shows the surfaces of its kinds and is lit by pixel; else it has their colours alone.
    pub surfaces: bool,
}

/// What a target shows after a frame was drawn into it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Picture {
    /// The frame.
    #[default]
    New,
    /// The last frame of the same world: what this one is drawn with is not made yet.
    Last,
    /// What was there before, and so it is to be cleared: nothing is made yet.
    None,
}

/// What drawing a frame took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DrawStats {
    /// What is shown.
    pub picture: Picture,
    /// Triangles sent.
    pub triangles: usize,
    /// Calls to the adapter that draw something; one may draw many chunks.
    pub draws: usize,
    /// Chunks with land that were left out.
    pub culled: usize,
    /// Bytes of the buffers that the land's meshes lie in.
    pub land_bytes: u64,
    /// What the planner chose, and the error that causes.
    pub plan: PlanStats,
    /// What drawing the shadow maps took.
    pub shadows: ShadowStats,
    /// The adapter's own time of a frame shortly before this one, milliseconds, where it can tell.
    pub gpu_ms: Option<f32>,
}

impl DrawStats {
    /// Of a view that was not drawn.
    pub(super) fn nothing() -> Self {
        Self {
            picture: Picture::None,
            ..Self::default()
        }
    }

    pub(super) fn add(&mut self, drawn: DrawCount) {
        self.triangles += drawn.triangles;
        self.draws += drawn.draws;
    }
}

/// # Errors
/// When they are out of range, in words.
pub(super) fn check(options: &Options) -> Result<(), RenderError> {
    if !matches!(options.samples, 1 | 4) {
        return Err(RenderError::Options(format!(
            "{} samples a pixel were asked for, and only 1 or 4 work",
            options.samples
        )));
    }
    if !(0.1..=1.0).contains(&options.scale) {
        return Err(RenderError::Options(format!(
            "a scale of {} was asked for, and only 0.1 to 1 work",
            options.scale
        )));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_out_of_range_are_refused_in_words() {
        let good = Options {
            samples: 4,
            scale: 0.5,
            output_format: TextureFormat::Bgra8UnormSrgb,
            shadows: ShadowQuality::Off,
            surfaces: false,
        };
        assert_eq!(check(&good), Ok(()));
        for bad in [
            Options { samples: 2, ..good },
            Options { scale: 0.0, ..good },
            Options {
                scale: f32::NAN,
                ..good
            },
        ] {
            let words = check(&bad).err().map(|e| e.to_string()).unwrap_or_default();
            assert!(
                words.starts_with("The renderer cannot be set up"),
                "{words}"
            );
        }
    }
}
