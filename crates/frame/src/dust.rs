//! What flies off the ground and what is pressed into it: dust, spray and chips, tyre prints, and the dark where things stand.

use antipode_geometry::{ChartId, ChartPoint};
use glam::{DVec3, Vec3};

/// What is in the air above the ground, and what lies on it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dust {
    /// Particles; a picture shows 512.
    pub particles: Vec<Particle>,
    /// Marks on the ground; a picture shows 2048.
    pub marks: Vec<GroundMark>,
}

/// How a particle is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// A soft cloud that ends where the ground is.
    Dust,
    /// A soft small clod.
    Spray,
    /// A hard bit with facets.
    Chip,
}

/// A bit of ground in the air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Its middle.
    pub point: ChartPoint,
    /// How it is drawn.
    pub look: Look,
    /// Its radius, metres.
    pub radius_m: f32,
    /// How it is turned in the picture, radians.
    pub turn_rad: f32,
    /// A number from 0 to 1 by which particles differ in shape.
    pub shape: f32,
    /// Its own colour in linear light.
    pub colour: [f32; 3],
    /// How much of what is behind it is hidden, 0 to 1.
    pub opacity: f32,
    /// How much of the sky is left where it came from, 0 to 1.
    pub sky: f32,
    /// Unit normal of the ground below it, in its chart.
    pub up: Vec3,
    /// How high its middle is over that ground, metres.
    pub height_m: f32,
}

/// What a mark on the ground looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkShape {
    /// A piece of a tyre's print, with its tread.
    Print,
    /// A soft round dark, as light from all around leaves under what stands there.
    Contact,
}

/// A piece of ground that is darker: four corners close above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundMark {
    /// The chart of its corners.
    pub chart: ChartId,
    /// Left and right where it begins, left and right where it ends, metres.
    pub corners: [DVec3; 4],
    /// What it looks like.
    pub shape: MarkShape,
    /// Which share of the light it takes where it begins and where it ends, 0 to 1.
    pub strength: [f32; 2],
    /// How far along its track that is, metres.
    pub along_m: [f32; 2],
}
