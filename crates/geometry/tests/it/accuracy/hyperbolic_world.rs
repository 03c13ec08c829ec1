//! What of the hyperbolic world and of bodies' charts is excused from golden rows: see coverage.rs. Points and matrices come from
//! the tiling, whose rows hold them.

/// Sources of `src/hyperbolic_world`, and of bodies' charts, by module name.
pub const SOURCES: &[(&str, &str)] = &[
    ("BodyChart", include_str!("../../../src/body_chart.rs")),
    ("BodyFrame", include_str!("../../../src/body_frame.rs")),
    ("Foot", include_str!("../../../src/spherical/foot.rs")),
    (
        "cache",
        include_str!("../../../src/hyperbolic_world/cache.rs"),
    ),
    (
        "SquareChart",
        include_str!("../../../src/hyperbolic_world/chart.rs"),
    ),
    (
        "world_optics",
        include_str!("../../../src/hyperbolic_world/optics.rs"),
    ),
    (
        "world_plan",
        include_str!("../../../src/hyperbolic_world/plan.rs"),
    ),
    (
        "world_tiles",
        include_str!("../../../src/hyperbolic_world/tiles.rs"),
    ),
    (
        "HyperbolicWorld",
        include_str!("../../../src/hyperbolic_world/near.rs"),
    ),
    (
        "HyperbolicWorld",
        include_str!("../../../src/hyperbolic_world/world.rs"),
    ),
];

/// Without golden rows, and why.
pub const EXCUSED: &[(&str, &str)] = &[
    (
        "HyperbolicWorld::level",
        "SquareChart::point on the level: tests/it/hyperbolic_world/near.rs",
    ),
    (
        "tiled::as_seen_from",
        "Atlas::carry, or Tiled::level_way_m where that has none",
    ),
    (
        "tile_part::parts",
        "which chunks are near: tests/it/hyperbolic_world/near.rs",
    ),
    ("BodyChart::new", "no arithmetic"),
    ("BodyChart::level_stretch", "a cosine of scalar"),
    ("BodyChart::stretch_across", "a sine of scalar"),
    (
        "BodyChart::pos",
        "the inverse of point, to 1e-11 m: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyChart::point",
        "the cylindrical kernel as seen by an eye: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyChart::arrival",
        "held to what frames at both ends see: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyChart::step",
        "held to great circles, geodesics and speeds: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::of",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::way",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::step",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::level_share",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::chart_box",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::in_chart",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::normal",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::arrival",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    (
        "BodyFrame::plane_place",
        "held to BodyChart, and to its own inverse: tests/it/hyperbolic_world/bodies.rs",
    ),
    ("SquareChart::is_written", "a comparison"),
    (
        "SquareChart::point",
        "equiangular_point: tests/it/hyperbolic_world/picture.rs has the law of pictures",
    ),
    ("SquareChart::pos", "equiangular_chart"),
    (
        "SquareChart::frame",
        "held to slopes of the chart: tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "SquareChart::turn_rad",
        "held to steps that are carried: tests/it/hyperbolic_world/atlas.rs",
    ),
    (
        "SquareChart::in_frame",
        "held to slopes of the chart: tests/it/hyperbolic_world/picture.rs",
    ),
    ("SquareChart::in_chart", "its inverse, to 1e-12"),
    (
        "SquareChart::normal",
        "upright on what it stood on: tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "SquareChart::most_stretch",
        "a bound: tests/it/space/atlas.rs and the balls of tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "world_plan::plan",
        "must hold what is seen: tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "HyperbolicWorld::new",
        "a radius of whole chunks: tests/it/hyperbolic_world/atlas.rs",
    ),
    (
        "HyperbolicWorld::pose",
        "an orthonormal matrix: tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "HyperbolicWorld::sight",
        "an orthonormal matrix: tests/it/hyperbolic_world/picture.rs",
    ),
];
