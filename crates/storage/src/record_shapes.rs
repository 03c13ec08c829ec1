//! What is stored of each actor, and of what the world has one of. Each kind has versions of its own: see
//! [`crate::record`]. The shapes of actors are those of the one state of version 6 too, so to change one is to copy it
//! to `schema_history.rs` first.

use serde::{Deserialize, Serialize};

use crate::schema::chart;

/// The player's body.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlayerRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Feet, chart metres.
    pub pos: [f64; 3],
    /// Velocity, metres per second.
    pub vel: [f64; 3],
    /// Heading, radians.
    pub yaw: f64,
    /// Elevation of the view, radians.
    pub pitch: f64,
    /// Health, 0 to 100.
    pub health: f64,
    /// Whether the view is from behind.
    pub third_person: bool,
    /// Whether the spectator's flight is on.
    pub flying: bool,
    /// Whether the feet stood on something.
    pub grounded: bool,
}

/// One filled slot of the inventory.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct SlotRecord {
    /// Which slot, 0 is the first.
    pub slot: u8,
    /// The item's identifier, such as `pickaxe-iron`.
    pub item: String,
    /// How many.
    pub count: u32,
}

/// A lamp that was put down.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct LampRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Its foot, chart metres.
    pub pos: [f64; 3],
}

/// A flag that was planted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FlagRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Its foot, chart metres.
    pub pos: [f64; 3],
    /// Where its cloth points from the pole, radians.
    pub yaw: f64,
    /// Its name; may be empty.
    pub name: String,
}

/// Something else that was put down and stands.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FixtureRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Its foot, chart metres.
    pub pos: [f64; 3],
    /// Its heading, radians.
    pub yaw: f64,
    /// Its name; may be empty.
    pub name: String,
    /// The item's identifier.
    pub item: String,
}

/// A stack that lies about.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct DropRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Its middle, chart metres.
    pub pos: [f64; 3],
    /// The item's identifier.
    pub item: String,
    /// How many.
    pub count: u32,
}

/// A figure that nobody plays.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct BotRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Feet, chart metres.
    pub pos: [f64; 3],
    /// Heading, radians.
    pub yaw: f64,
    /// Its health.
    pub health: f64,
    /// Whether it fights the player.
    pub hostile: bool,
    /// For how long yet a peaceful one that was provoked fights, seconds.
    pub provoked_s: f64,
    /// Whether it came by itself, and may go so.
    pub native: bool,
}

/// A car.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct CarRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// The ground below its middle when it stands on level ground, chart metres.
    pub pos: [f64; 3],
    /// How it is turned from facing along +x, a unit quaternion x, y, z, w of the chart.
    pub turn: [f64; 4],
    /// Velocity, metres per second.
    pub vel: [f64; 3],
    /// Angular velocity, radians per second.
    pub spin: [f64; 3],
    /// Whether its lights are on.
    pub lights: bool,
    /// How far its front wheels are turned to the right, radians.
    pub steer: f64,
    /// How far each spring is pushed in, metres; zero in the air.
    pub springs: [f64; 4],
    /// Whether it has come to rest.
    pub rests: bool,
}

/// A place.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlaceRecord {
    /// The number of its chart; on a globe 0 and 1 are the hemispheres A and B.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Chart metres.
    pub pos: [f64; 3],
}

/// A player: the body, and what belongs to it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlayerKept {
    /// The body.
    pub body: PlayerRecord,
    /// The slot in the hand.
    pub item_slot: u8,
    /// The filled slots.
    pub inventory: Vec<SlotRecord>,
    /// Radius of the brush, metres.
    pub brush_radius_m: f64,
    /// Whether the flashlight is on.
    pub flashlight: bool,
    /// Number of the car that the player drives, as in its record's key.
    pub driving: Option<u32>,
    /// Where the player stands up again from death; none where the land alone decides.
    pub start: Option<PlaceRecord>,
    /// Whether the player was told of having gone once round the world.
    pub been_round: bool,
}

/// What the world has one of and what changes with time.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct CourseRecord {
    /// Time of day, seconds.
    pub time_of_day_s: f64,
    /// Simulated time since the world was made, seconds.
    pub simulated_s: f64,
    /// Whether the world has been given its first car, which it may have lost since.
    pub car_given: bool,
}

/// Ground that the player has gathered.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct EarthRecord {
    /// Numbers of kinds of ground, and how much there is of each, cubic metres; of ores it may be less than zero.
    pub kinds: Vec<(u8, f64)>,
}

/// What grew on a column of chunks and was felled.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FelledRecord {
    /// The number of the chart.
    #[serde(with = "chart")]
    pub chart: u128,
    /// Index of the column along x, in chunks.
    pub x: i32,
    /// Index along z.
    pub z: i32,
    /// A bit for each slot of the column, the first 64 first.
    pub slots: [u64; 2],
}

/// A tree that somebody planted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PlantedRecord {
    /// Its root.
    pub place: PlaceRecord,
    /// The number of its kind.
    pub species: u8,
    /// When it was planted, simulated seconds since the world was made.
    pub since_s: f64,
    /// When it was felled, and a stump was left; none while it stands.
    pub felled_s: Option<f64>,
}

/// How the player looks at the world.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ViewRecord {
    /// The map of a hyperbolic world, `raised` or `horizon`; without meaning elsewhere.
    pub map: String,
    /// Dial of the raised map, metres; without meaning but in hyperbolic worlds.
    pub curvature: f64,
    /// Dial of the horizon map; without meaning but in hyperbolic worlds.
    pub curvature_horizon: f64,
    /// Whether the picture of a flat world is bent.
    pub bent: bool,
    /// Dial of the bend, positive where hyperbolic; kept while the picture is flat.
    pub bend: f64,
    /// View distance, chunks.
    pub view_distance: u32,
}
