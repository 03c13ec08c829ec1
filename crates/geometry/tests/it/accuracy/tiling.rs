//! What of the tiling is held to `tests/reference/tiling.json`, and what is excused: see coverage.rs.

/// Sources of `src/tiling` by module name.
pub const SOURCES: &[(&str, &str)] = &[
    ("error", include_str!("../../../src/tiling/error.rs")),
    ("Golden", include_str!("../../../src/tiling/golden.rs")),
    ("Wide", include_str!("../../../src/tiling/wide.rs")),
    ("Side", include_str!("../../../src/tiling/side.rs")),
    ("Isometry", include_str!("../../../src/tiling/isometry.rs")),
    ("Tile", include_str!("../../../src/tiling/tile.rs")),
    ("Frame", include_str!("../../../src/tiling/frame.rs")),
    ("disc", include_str!("../../../src/tiling/disc.rs")),
    ("place", include_str!("../../../src/tiling/place.rs")),
    ("TilePath", include_str!("../../../src/tiling/path.rs")),
    ("number", include_str!("../../../src/tiling/number.rs")),
    ("tile_chart", include_str!("../../../src/tiling/chart.rs")),
    ("Quilt", include_str!("../../../src/tiling/quilt.rs")),
];

/// Held by the rows of tiling.json, in tests/it/tiling/reference.rs.
pub const HELD: &[&str] = &[
    "Golden::plus",
    "Golden::minus",
    "Golden::times",
    "Golden::dot",
    "Isometry::times",
    "Frame::between",
    "tile_chart::equiangular_point",
    "tile_chart::equiangular_chart",
    "tile_chart::cylindrical_chart",
];

/// Without golden rows, and why.
pub const EXCUSED: &[(&str, &str)] = &[
    ("Wide::plus", "exact; every row of between goes through it"),
    ("Wide::minus", "exact; src/tiling/wide.rs"),
    (
        "Side::quarters_from",
        "a whole number; every frame goes by it",
    ),
    ("place::place", "a decision: tests/it/tiling/places.rs"),
    ("Quilt::new", "a bound of a list: tests/it/tiling/quilt.rs"),
    (
        "Quilt::each",
        "that all who share a place find the same is what counts: tests/it/tiling/quilt.rs",
    ),
];
