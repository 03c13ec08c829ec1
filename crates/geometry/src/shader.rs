//! What of the shaders is a map's own: the text of each map, and of how the light of the day falls in its worlds.

/// The functions that the text of every map defines; what they are for, `shaders/geometry.wgsl` says.
pub const MAP_FUNCTIONS: [&str; 6] = [
    "port",
    "port_normal",
    "frame_vector",
    "depth_of",
    "eye_distance",
    "curvature_of",
];

/// The functions that the text of every kind of daylight defines; what they are for, `shaders/lights.wgsl` says.
pub const DAYLIGHT_FUNCTIONS: [&str; 22] = [
    "in_common_axes",
    "in_sky_axes",
    "grain_point",
    "grain_at",
    "grain_up",
    "tilted",
    "haze_before",
    "daylight_on",
    "wants_model_normal",
    "land_light",
    "land_sky",
    "daylit",
    "is_land_unlit",
    "seen_normal",
    "from_ring",
    "is_unlit",
    "caster_point",
    "shadow_place",
    "shaded_at",
    "shadow_away",
    "on_map",
    "land_shadow",
];

/// How the light of the day falls in a world.
#[derive(Debug, PartialEq, Eq)]
pub struct Daylight {
    /// Its file's name without the ending.
    pub name: &'static str,
    /// WGSL that defines [`DAYLIGHT_FUNCTIONS`].
    pub text: &'static str,
    /// Whether much land lies where no shadow map shows it and where charts end, so that it is worth pipelines of its
    /// own.
    pub is_round: bool,
    /// Whether charts have axes in common, in which places near the eye are told; else they are told in view coordinates.
    pub has_axes: bool,
}

/// A map as the shaders know it.
#[derive(Debug, PartialEq, Eq)]
pub struct MapShader {
    /// Its name, which is that of its file without the ending. What is compiled for it is known by that.
    pub name: &'static str,
    /// WGSL that defines [`MAP_FUNCTIONS`].
    pub text: &'static str,
    /// The light of its worlds.
    pub daylight: &'static Daylight,
    /// Whether depth bends inside a triangle, so that near the eye fragments need their own.
    pub bends_depth: bool,
    /// The map that the player may turn to from this one.
    pub turns_to: Option<&'static MapShader>,
}

/// Under a sky.
pub static OPEN: Daylight = Daylight {
    name: "open",
    text: concat!(
        include_str!("../../../shaders/worlds/under_sky.wgsl"),
        include_str!("../../../shaders/worlds/open.wgsl")
    ),
    is_round: false,
    has_axes: true,
};

/// Under a sky, where directions turn from place to place.
pub static TURNING: Daylight = Daylight {
    name: "turning",
    text: concat!(
        include_str!("../../../shaders/worlds/under_sky.wgsl"),
        include_str!("../../../shaders/worlds/turning.wgsl")
    ),
    is_round: false,
    has_axes: false,
};

/// In a closed world.
pub static CLOSED: Daylight = Daylight {
    name: "closed",
    text: include_str!("../../../shaders/worlds/closed.wgsl"),
    is_round: true,
    has_axes: false,
};

/// Flat space.
pub static FLAT: MapShader = MapShader {
    name: "flat",
    text: include_str!("../../../shaders/spaces/flat.wgsl"),
    daylight: &OPEN,
    bends_depth: false,
    turns_to: Some(&HORIZON),
};

/// The raised map of hyperbolic space.
pub static RAISED: MapShader = MapShader {
    name: "raised",
    text: include_str!("../../../shaders/spaces/raised.wgsl"),
    daylight: &OPEN,
    bends_depth: true,
    turns_to: Some(&HORIZON),
};

/// The sphere.
pub static SPHERE: MapShader = MapShader {
    name: "sphere",
    text: include_str!("../../../shaders/spaces/sphere.wgsl"),
    daylight: &CLOSED,
    bends_depth: false,
    turns_to: None,
};

/// The horizon map.
pub static HORIZON: MapShader = MapShader {
    name: "horizon",
    text: include_str!("../../../shaders/spaces/horizon.wgsl"),
    daylight: &OPEN,
    bends_depth: true,
    turns_to: None,
};

/// The hyperbolic world in squares.
pub static SQUARES: MapShader = MapShader {
    name: "squares",
    text: include_str!("../../../shaders/spaces/squares.wgsl"),
    daylight: &TURNING,
    bends_depth: false,
    turns_to: None,
};

/// The maps of the game.
pub static MAPS: [&MapShader; 5] = [&FLAT, &RAISED, &SPHERE, &HORIZON, &SQUARES];

/// The first of some functions that a text does not define.
fn lacking(text: &str, functions: &[&'static str]) -> Option<&'static str> {
    let defines = |name: &str| {
        let head = format!("fn {name}(");
        text.lines().any(|line| line.starts_with(&head))
    };
    functions.iter().copied().find(|name| !defines(name))
}

impl MapShader {
    /// A function that the map's text or that of its daylight should define and does not, and which of the two.
    pub fn lacks(&self) -> Option<(&'static str, &'static str)> {
        let own = lacking(self.text, &MAP_FUNCTIONS).map(|function| (self.name, function));
        let light = &self.daylight;
        own.or_else(|| {
            lacking(light.text, &DAYLIGHT_FUNCTIONS).map(|function| (light.name, function))
        })
    }

    /// The text for whoever wants the geometry alone: [`crate::WGSL`] and the map's own.
    pub fn geometry(&self) -> String {
        [crate::WGSL, self.text].join("\n")
    }
}
