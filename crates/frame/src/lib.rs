//! What a picture is made of: plain data that the simulation fills and the renderer draws.
//!
//! A [`Frame`] is a [`Content`], all that there is to be seen (land, figures, lights, sky), and a [`View`], from where
//! and how it is seen. Several views can share one content. This crate knows neither the simulation nor the renderer.
//!
//! Directions and positions are in chart coordinates, lengths in metres. Colours are linear light, not sRGB.

mod dust;
pub mod hand;
mod hit_shapes;
mod land;
mod model;
pub mod motion;
mod opening;
mod posture;
mod presser;
mod quality;
mod view;

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Leaf, LevelMap};
use antipode_terrain::{Kind, Thing};
use glam::{DQuat, DVec3};

pub use dust::{Dust, GroundMark, Look, MarkShape, Particle};
pub use hit_shapes::{HitForm, HitShape};
pub use land::{ChunkChange, Land, LandCursor, LandNews};
pub use model::{ModelId, ModelShape};
pub use opening::{Opening, sheet_behind};
pub use posture::{Clip, Posture};
pub use presser::Presser;
pub use quality::{ParseQualityError, Quality};
pub use view::{Hand, View};

/// What a world looks like at a moment, whoever looks. The default is an empty one without light.
#[derive(Clone, Debug, Default)]
pub struct Content {
    /// Sky and light of the moment, about the eye of the picture that it was made for.
    pub sky: Sky,
    /// The land as it is now.
    pub land: Arc<Land>,
    /// Figures standing in the world.
    pub figures: Vec<Figure>,
    /// Things that fall.
    pub falling: Vec<FallingThing>,
    /// What bends leaves and grass; a picture shows what the eight nearest to the eye do.
    pub pressers: Vec<Presser>,
    /// Lamps and beams.
    pub lights: Lights,
    /// Where a tool digs or builds, or where a lamp in hand would hang.
    pub marker: Option<Marker>,
    /// Shapes of bodies and things, where their outlines are to be drawn.
    pub hit_shapes: Vec<HitShape>,
    /// Dust and chips in the air, and marks on the ground.
    pub dust: Dust,
    /// Simulated time since the world was made, in seconds.
    pub time_s: f32,
    /// Identifies the world; when it differs from the last content's, every chunk of the old one is dropped first.
    pub loaded_world: u64,
}

/// Everything needed to draw one picture: a content that several pictures may share, and a view of it.
#[derive(Clone, Debug)]
pub struct Frame {
    /// What there is to be seen.
    pub content: Arc<Content>,
    /// From where and how it is seen.
    pub view: View,
    /// What the rear mirror of the car that is driven shows, seen from its bonnet; left and right not yet swapped, and of a
    /// picture as wide as high.
    pub mirror: Option<View>,
    /// Doors, and what is seen through each.
    pub openings: Vec<Opening>,
}

impl Frame {
    /// A picture without a mirror.
    pub fn new(content: Content, view: View) -> Self {
        Self {
            content: Arc::new(content),
            view,
            mirror: None,
            openings: Vec::new(),
        }
    }

    /// The content, to be changed for this picture alone.
    pub fn content_mut(&mut self) -> &mut Content {
        Arc::make_mut(&mut self.content)
    }

    /// The same after a change to its content.
    #[must_use]
    pub fn with_content(mut self, change: impl FnOnce(&mut Content)) -> Self {
        change(self.content_mut());
        self
    }

    /// The same after a change to its view.
    #[must_use]
    pub fn with_view(mut self, change: impl FnOnce(&mut View)) -> Self {
        change(&mut self.view);
        self
    }

    /// The marker, if there is one to be drawn.
    pub fn marker(&self) -> Option<Marker> {
        let marker = self.content.marker.filter(|_| self.view.shows_marks)?;
        let point = self.view.mark.unwrap_or(marker.point);
        Some(Marker { point, ..marker })
    }

    /// The same content, looked at by somebody else.
    #[must_use]
    pub fn seen_by(&self, view: View) -> Self {
        Self {
            content: Arc::clone(&self.content),
            view,
            mirror: None,
            openings: Vec::new(),
        }
    }

    /// Changes the land of this picture alone.
    pub fn change_land(&mut self, changes: impl IntoIterator<Item = ChunkChange>) {
        let land = Arc::make_mut(&mut self.content_mut().land);
        changes.into_iter().for_each(|change| land.change(change));
    }
}

/// A thing that grew, on its way down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FallingThing {
    /// Where its root is.
    pub point: ChartPoint,
    /// What it is; where it stood on its chunk does not matter.
    pub thing: Thing,
    /// How it has turned about its root since it stood, in the chart.
    pub turn: DQuat,
}

/// Light that comes from places in the world. Colours are linear light.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lights {
    /// Lamps, those that matter most first; a picture shows 64.
    pub lamps: Vec<LampLight>,
    /// Beams, those that matter most first; a picture shows 16.
    pub beams: Vec<BeamLight>,
}

/// Light that goes all ways from a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LampLight {
    /// Where it is.
    pub point: ChartPoint,
    /// Colour times strength, as it is close by.
    pub colour: [f32; 3],
    /// Distance in the space at which it has faded away, metres.
    pub range_m: f64,
}

/// Light that goes one way from a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamLight {
    /// Where it is.
    pub point: ChartPoint,
    /// The way it goes, a unit vector of the chart there.
    pub direction: DVec3,
    /// Colour times strength, as it is close by.
    pub colour: [f32; 3],
    /// Distance in the space at which it has faded away, metres.
    pub range_m: f64,
    /// Angles from its middle within which it is full, and outside which there is none, radians.
    pub cone_rad: (f64, f64),
    /// A leaf behind which alone it lights, of light that has come by a door: on the side that its front looks to, or on the other.
    pub behind: Option<(Leaf, bool)>,
}

/// Sky and light of a moment. Colours are linear light; directions are unit vectors at the eye, in the axes of
/// [`View::in_common_axes`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// Colour straight up.
    pub top: [f32; 3],
    /// Colour at the horizon, and of the fog.
    pub horizon: [f32; 3],
    /// Colour of the sun's disc and glow.
    pub glare: [f32; 3],
    /// How visible the stars are, 0 to 1.
    pub stars: f32,
    /// Towards the sun.
    pub sun_direction: [f32; 3],
    /// Towards the moon.
    pub moon_direction: [f32; 3],
    /// Towards the key light, which is the sun or the moon.
    pub key_direction: [f32; 3],
    /// How dark the key's shadows are, 0 to 1: it goes to 0 where sun and moon take turns.
    pub key_shadow: f32,
    /// Key light's colour times strength; in a closed world the sun's.
    pub key_colour: [f32; 3],
    /// Colour times strength of the moon's light when it stands high and there is no other.
    pub moon_colour: [f32; 3],
    /// Ambient light from above.
    pub ambient_sky: [f32; 3],
    /// Ambient light from below.
    pub ambient_ground: [f32; 3],
    /// Whether there is a sky to draw at all; a spherical world has none.
    pub dome: bool,
    /// How much of the sky clouds cover, 0 to 1.
    pub clouds: f32,
    /// How far they have drifted, 0 to 1 over a day; then they are where they were.
    pub drift: f32,
    /// Sun and moon of a world without a sky.
    pub orbs: Option<Orbs>,
}

/// No light and nothing to be seen, with sun and moon overhead.
impl Default for Sky {
    fn default() -> Self {
        let (dark, up) = ([0.0; 3], [0.0, 1.0, 0.0]);
        Self {
            top: dark,
            horizon: dark,
            glare: dark,
            stars: 0.0,
            sun_direction: up,
            moon_direction: up,
            key_direction: up,
            key_shadow: 1.0,
            key_colour: dark,
            moon_colour: dark,
            ambient_sky: dark,
            ambient_ground: dark,
            dome: false,
            clouds: 0.0,
            drift: 0.0,
            orbs: None,
        }
    }
}

/// Sun and moon that stand in a closed world, among its land.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbs {
    /// The sun's middle.
    pub sun: ChartPoint,
    /// The moon's.
    pub moon: ChartPoint,
    /// Radius of each in metres.
    pub radius_m: f64,
}

/// A figure standing in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// The model.
    pub model: ModelId,
    /// Where its origin is; of astronauts, their feet.
    pub point: ChartPoint,
    /// How it is turned from looking along +x with its right-hand side at +z, in the chart.
    pub turn: DQuat,
    /// How its metres lie in the chart, of one that is rigid in the space; others are in metres of the chart.
    pub level: LevelMap,
    /// How its body is held, where it has one; without meaning else.
    pub posture: Posture,
    /// What is in its right hand, where it has one.
    pub held: Option<ModelId>,
    /// Whether what is held flashes.
    pub flashes: bool,
    /// Whether its suit is red: who fights the player is known from afar.
    pub hostile: bool,
    /// Whether a car's head and tail lights are on.
    pub lights: bool,
    /// Whether its brake lights are.
    pub brakes: bool,
    /// Whether it is there.
    pub presence: Presence,
    /// How much of the sky is left where it stands, 0 to 1: little of it in a cave.
    pub sky: f32,
    /// What of it is shown, of one that stands in a door.
    pub cut: Option<Cut>,
}

/// The part of a figure on one side of an upright plane of its chart: where the way along a heading from its origin is long enough.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The heading across the plane, radians from +x towards +z.
    pub heading_rad: f64,
    /// How far along it from the figure's origin the part begins, metres.
    pub from_m: f64,
}

impl Cut {
    /// The same plane, from an origin that lies so much farther.
    #[must_use]
    pub fn from_origin_moved(self, by: DVec3) -> Self {
        let along_m = by.x * self.heading_rad.cos() + by.z * self.heading_rad.sin();
        Self {
            from_m: self.from_m - along_m,
            ..self
        }
    }
}

/// Whether a figure is there, or only shown where it would be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Presence {
    /// It is there.
    #[default]
    Real,
    /// It can be put there: the figure is green and half of it is seen through. It throws no shadow.
    Possible,
    /// It cannot be put there: it is red.
    Barred,
}

impl Figure {
    /// A figure upright at `point`, facing along `yaw` radians: 0 along +x and a quarter turn along +z.
    pub fn standing(model: ModelId, point: ChartPoint, yaw: f64) -> Self {
        Self {
            model,
            point,
            turn: DQuat::from_rotation_y(-yaw),
            level: LevelMap::SAME,
            posture: Posture::default(),
            held: None,
            flashes: false,
            hostile: false,
            lights: false,
            brakes: false,
            presence: Presence::Real,
            sky: 1.0,
            cut: None,
        }
    }
}

/// How a marker is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkerShape {
    /// A thin ring on the land, told by its colour.
    Ring,
    /// The same, white between black edges, for eyes that see few colours.
    SafeRing,
    /// A small ball.
    Ball,
}

/// Where something is to happen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marker {
    /// Its middle; of a ring, that of the brush.
    pub point: ChartPoint,
    /// Its radius in metres; of a ring, that of the brush.
    pub radius_m: f64,
    /// Whether it is at work at the moment.
    pub active: bool,
    /// How it is drawn.
    pub shape: MarkerShape,
    /// As which kind the land within a ring is shown, if it is: of what would be built.
    pub ground: Option<Kind>,
}

impl Marker {
    /// Whether a brush is marked: while it digs or builds, and while it is chosen what it builds of.
    pub fn is_shown(&self) -> bool {
        self.active || self.ground.is_some()
    }
}
