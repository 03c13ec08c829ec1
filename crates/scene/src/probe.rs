//! The probe: what a script may ask of the simulation, as plain data with stable names.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::inventory::Stack;

/// State of the world at one moment. SI units, chart coordinates.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Probe {
    /// Simulated time since the world was made, seconds.
    pub t: f64,
    /// The world's name.
    pub world: String,
    /// Its seed.
    pub seed: u64,
    /// The number of the generator that makes its land.
    pub generator: u16,
    /// `creative` or `gathering`.
    pub mode: &'static str,
    /// In a gathering world how much ground was gathered, by kind, cubic metres.
    pub stock: Option<BTreeMap<&'static str, f64>>,
    /// The biome where the player is, as `forest`.
    pub biome: &'static str,
    /// Its geometry: `euclidean`, `hyperbolic` or `spherical`.
    pub geometry: String,
    /// Radius of curvature in metres; null where space is flat.
    pub radius: Option<f64>,
    /// Hyperbolic map asked for, `raised` or `horizon`; null elsewhere.
    pub map: Option<&'static str>,
    /// Where the dial of that map is set, 0 to 20; null elsewhere.
    pub curvature: Option<f64>,
    /// Where a flat world's bend is set, -20 to 20; null elsewhere and while the picture is flat.
    pub bend: Option<f64>,
    /// How much exactness pictures trade for speed: `fast`, `balanced` or `exact`.
    pub quality: &'static str,
    /// Time of day in seconds, 0 to 600.
    pub time_of_day: f64,
    /// What the clock shows where the player is, hours from 0 to 24; null at the poles of a closed world's day.
    pub hour: Option<f64>,
    /// The player.
    pub player: PlayerProbe,
    /// The camera.
    pub camera: CameraProbe,
    /// Id of the item in hand; null for an empty hand.
    pub item: Option<&'static str>,
    /// Filled slots: 0 to 9 are the hotbar's, 10 to 39 the backpack's.
    pub inventory: Vec<SlotProbe>,
    /// The brush marker.
    pub marker: MarkerProbe,
    /// Whether the flashlight is on.
    pub flashlight: bool,
    /// The car that the player drives, else the nearest; null in a world without cars.
    pub car: Option<CarProbe>,
    /// All cars, in the order in which they came.
    pub cars: Vec<CarProbe>,
    /// Other figures, by their numbers.
    pub bots: Vec<BotProbe>,
    /// Bullets in flight, the oldest first.
    pub projectiles: Vec<ProjectileProbe>,
    /// Lamps that were put down.
    pub lamps: Vec<LampProbe>,
    /// Flags that were planted.
    pub flags: Vec<FlagProbe>,
    /// The doors, the older one first; left out where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub doors: Vec<DoorProbe>,
    /// What else was put down; left out where nothing was.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub fixtures: Vec<FixtureProbe>,
    /// What lies about.
    pub drops: Vec<DropProbe>,
    /// What of the ground is in the air.
    pub particles: ParticleProbe,
    /// Tyre prints on the ground.
    pub marks: MarkProbe,
    /// What grows and stands on the land; left out in worlds that were begun without.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plants: Option<PlantsProbe>,
    /// Terrain chunks.
    pub chunks: ChunkProbe,
    /// The ground under the player.
    pub terrain: TerrainProbe,
}

/// The player in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlayerProbe {
    /// Feet, metres.
    pub pos: [f64; 3],
    /// Velocity, metres of the space per second, along the axes of the chart's frame.
    pub vel: [f64; 3],
    /// Heading, degrees.
    pub yaw: f64,
    /// Elevation of the view, degrees.
    pub pitch: f64,
    /// Whether the feet stand on ground.
    pub grounded: bool,
    /// Health, 0 to 20.
    pub health: f64,
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
    /// Whether the player sits in a car.
    pub in_car: bool,
    /// What the figure is doing: `idle`, `walk`, `run`, `jump`, `fly`, `drive` or `die`.
    pub animation: &'static str,
}

/// What grows, in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlantsProbe {
    /// How many of each kind stand within 30 metres of the player in the chart, by name.
    pub near: BTreeMap<&'static str, usize>,
    /// How many stand where a picture of 16 by 9 shows their middle, whatever may hide them, as far as land is there.
    pub in_view: usize,
    /// The kind whose trunk is under the crosshair within reach; null for none.
    pub ahead: Option<&'static str>,
    /// How many were felled in this world.
    pub felled: u32,
    /// How many trees somebody planted, that stand.
    pub planted: usize,
    /// The height of the tallest of those within 30 metres, metres; 0 for none.
    pub planted_m: f64,
    /// How many trees fall at the moment.
    pub falling: usize,
}

/// The camera in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraProbe {
    /// Eye, metres.
    pub pos: [f64; 3],
    /// `first` or `third`.
    pub mode: &'static str,
    /// The eye as a point of the space's model, in units of the radius.
    pub curved: [f64; 4],
}

/// A car in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CarProbe {
    /// The ground below its middle, when it stands on level ground, metres.
    pub pos: [f64; 3],
    /// Velocity, metres of the chart per second.
    pub vel: [f64; 3],
    /// Heading, degrees.
    pub yaw: f64,
    /// How upright it is: 1 on its wheels, 0 on its side, -1 on its roof.
    pub upright: f64,
    /// Speed ahead, metres per second; backwards negative.
    pub speed: f64,
    /// How far the front wheels are turned to the right, degrees.
    pub steer: f64,
    /// Whether its lights are on.
    pub lights: bool,
    /// Whether its brake lights are.
    pub brakes: bool,
    /// Front left, front right, rear left, rear right.
    pub wheels: [WheelProbe; 4],
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
}

/// A wheel of a car in a probe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WheelProbe {
    /// Whether it is on the ground.
    pub contact: bool,
    /// How far its spring is pushed in, metres.
    pub compression: f64,
}

/// One filled slot in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SlotProbe {
    /// Slot, 0 to 39.
    pub slot: u8,
    /// The stack, as `item` and `count`.
    #[serde(flatten)]
    pub stack: Stack,
}

/// Another figure in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BotProbe {
    /// Its number.
    pub id: u32,
    /// Feet, metres.
    pub pos: [f64; 3],
    /// Its health.
    pub health: f64,
    /// Whether it fights the player, be it for good or until it has calmed down.
    pub hostile: bool,
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
    /// What it does: `idle`, `wander`, `watch`, `aside`, `sit`, `chase`, `fight`, `search`, `flee` or `dead`.
    pub state: &'static str,
}

/// A bullet in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProjectileProbe {
    /// Its number.
    pub id: u32,
    /// Centre, metres.
    pub pos: [f64; 3],
    /// Velocity, metres per second of the chart.
    pub vel: [f64; 3],
    /// Since it was fired, seconds.
    pub age: f64,
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
}

/// A lamp in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LampProbe {
    /// Foot, metres.
    pub pos: [f64; 3],
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
}

/// Something else that was put down in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FixtureProbe {
    /// The item.
    pub item: &'static str,
    /// Foot, metres.
    pub pos: [f64; 3],
    /// Heading, degrees.
    pub yaw: f64,
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
}

/// A door in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DoorProbe {
    /// Foot, metres.
    pub pos: [f64; 3],
    /// The way that its front looks, degrees.
    pub yaw: f64,
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
}

/// A flag in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FlagProbe {
    /// Foot, metres.
    pub pos: [f64; 3],
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
    /// Its name; empty where nobody gave it one.
    pub name: String,
}

/// Something that lies about in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DropProbe {
    /// The stack, as `item` and `count`.
    #[serde(flatten)]
    pub stack: Stack,
    /// Middle, metres.
    pub pos: [f64; 3],
    /// The chart: `A` or `B`, the hemispheres of a closed world; `A` in an open one of one chart.
    pub hemisphere: String,
}

/// The brush marker in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MarkerProbe {
    /// Centre, metres; null when no tool is in hand.
    pub pos: Option<[f64; 3]>,
    /// Brush radius, metres.
    pub radius: f64,
    /// The brush's shape, as `ball`.
    pub shape: &'static str,
    /// The kind of ground that is built, as `grass`; null for what untouched land has there.
    pub kind: Option<&'static str>,
}

/// What of the ground is in the air, or came to lie, in a probe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ParticleProbe {
    /// All of it.
    pub alive: usize,
    /// Clouds of dust.
    pub dust: usize,
    /// Soft clods.
    pub spray: usize,
    /// Hard bits.
    pub chips: usize,
}

/// Tyre prints in a probe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MarkProbe {
    /// Pieces that have not faded yet.
    pub alive: usize,
}

/// Terrain chunks in a probe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ChunkProbe {
    /// Chunks with a surface that are resident.
    pub resident: usize,
    /// Work not finished yet.
    pub pending: usize,
    /// Triangles of all resident chunks.
    pub triangles: usize,
    /// Chunks the player changed.
    pub edited: usize,
}

/// The ground under the player in a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TerrainProbe {
    /// Height of the first ground below the player's head, metres; null when there is none near.
    pub ground_height: Option<f64>,
    /// The kind of that ground, as `grass`; null when there is none near.
    pub kind: Option<&'static str>,
    /// The kind of what the crosshair is on within a tool's reach; null where that is no ground.
    pub kind_ahead: Option<&'static str>,
    /// Whether the player is in a cave that nobody dug.
    pub cave: bool,
    /// What the player has dug in this visit, cubic metres by kind; left out where that is nothing.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub dug: BTreeMap<&'static str, f64>,
    /// What the player has built in this visit, cubic metres by kind; left out where that is nothing.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub built: BTreeMap<&'static str, f64>,
}
