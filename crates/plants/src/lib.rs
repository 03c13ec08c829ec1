//! Plants and stones: which stand where in a world that nobody has touched, and what they look like.
//!
//! Places are a pure function of seed and field; shapes of the species, its age and how large it is in the picture. No
//! input or output, no GPU.

mod corner;
mod growth;
mod habitat;
mod noise;
mod placement;
mod seat;
mod shape;
mod solid;
mod species;
mod undergrowth;

pub use corner::stones_of_others;
pub use growth::Growth;
pub use placement::{placed, placed_near, tree_at};
pub use seat::top_m;
pub use shape::{Corner, Material, Shape, Size, low_shape, shape};
pub use solid::{add_solids, solid_of};
pub use species::{Age, Species, Trunk, left_of};
pub use undergrowth::undergrowth;
