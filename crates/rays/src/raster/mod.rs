//! What a raster finds out in place of rays: which triangle, wall or door is seen at each pixel.
//!
//! A picture is made in two steps. The raster draws numbers only, in the scene's coordinates, level by level: the first is what
//! the eye sees without going through a door, the next what is seen through the doors of the one before, cut at their planes
//! and only where they are seen. Then the compute pass that traces rays goes over all pixels; it takes from the raster what
//! the eye's ray meets, works out by one product where, and goes on from there as it does otherwise, so that shading, shadows,
//! mirrors and panes are one text and one answer. What a raster cannot know (what is behind a face that bends, or behind more
//! doors than there are levels) is a number of its own, and these pixels are traced from the eye.

mod choice;
mod draws;
mod pass;
mod plan;
mod target;
mod tidy;

pub use choice::{Sight, Way, way};
pub use draws::{Chunk, Moved};
pub use pass::{MOST_VIEWS, Raster, Region};
pub use plan::{Limits, Plan};
pub use target::Visible;
pub use tidy::tidy;
