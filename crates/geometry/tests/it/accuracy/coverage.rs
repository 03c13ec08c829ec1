//! Every public function that takes numbers is held to a golden table, or excused with a reason.

use super::golden::{FUNCTIONS, KERNELS};
use super::{functions, hyperbolic_world, kernels, tiling};

/// Sources of the crate by module name.
pub const SOURCES: &[(&str, &str)] = &[
    ("scalar", include_str!("../../../src/scalar.rs")),
    ("charts", include_str!("../../../src/charts.rs")),
    ("library", include_str!("../../../src/kernel/library.rs")),
    ("series", include_str!("../../../src/kernel/series.rs")),
    ("linear", include_str!("../../../src/kernel/linear.rs")),
    ("parts", include_str!("../../../src/kernel/parts.rs")),
    (
        "exponential",
        include_str!("../../../src/kernel/exponential.rs"),
    ),
    (
        "cylindrical",
        include_str!("../../../src/kernel/cylindrical.rs"),
    ),
    ("raised", include_str!("../../../src/kernel/raised.rs")),
    ("horizon", include_str!("../../../src/kernel/horizon.rs")),
    ("sphere", include_str!("../../../src/kernel/sphere.rs")),
    ("depth", include_str!("../../../src/kernel/depth.rs")),
    ("distance", include_str!("../../../src/kernel/distance.rs")),
    (
        "translation",
        include_str!("../../../src/kernel/translation.rs"),
    ),
    ("frame", include_str!("../../../src/kernel/frame.rs")),
    (
        "Horizon",
        include_str!("../../../src/hyperbolic/horizon.rs"),
    ),
    ("Raised", include_str!("../../../src/hyperbolic/raised.rs")),
    (
        "Spherical",
        include_str!("../../../src/spherical/sphere.rs"),
    ),
    ("Euclidean", include_str!("../../../src/flat/euclidean.rs")),
    ("Strategy", include_str!("../../../src/strategy.rs")),
    ("Atlas", include_str!("../../../src/atlas.rs")),
    ("Globe", include_str!("../../../src/spherical/globe.rs")),
    ("Map", include_str!("../../../src/map.rs")),
    ("ViewMode", include_str!("../../../src/view_mode.rs")),
    ("Metric", include_str!("../../../src/metric.rs")),
    ("pace", include_str!("../../../src/pace.rs")),
    ("Optics", include_str!("../../../src/optics.rs")),
    ("Projection", include_str!("../../../src/projection.rs")),
    ("Eye", include_str!("../../../src/eye.rs")),
    ("SightCell", include_str!("../../../src/sight.rs")),
    ("Frustum", include_str!("../../../src/frustum.rs")),
    ("SpaceUniform", include_str!("../../../src/uniform.rs")),
    ("shader", include_str!("../../../src/shader.rs")),
    ("ChartPoint", include_str!("../../../src/point.rs")),
    ("ChunkCoord", include_str!("../../../src/chunk.rs")),
    ("ChunkCube", include_str!("../../../src/chunk_cube.rs")),
    (
        "tile_part",
        include_str!("../../../src/chunk_cube/tile_part.rs"),
    ),
    ("tiled", include_str!("../../../src/tiled.rs")),
    ("LevelMap", include_str!("../../../src/level_map.rs")),
    ("Geometry", include_str!("../../../src/kind.rs")),
    ("ChartId", include_str!("../../../src/chart.rs")),
    ("real", include_str!("../../../src/real.rs")),
    ("triangle", include_str!("../../../src/triangle.rs")),
    ("doorway", include_str!("../../../src/doorway.rs")),
];

/// Held by the rows of strategies.json, in tests/it/space/golden.rs: seen, un-seen, lit, measured.
const STRATEGIES: &[&str] = &[
    "Map::view_point",
    "Map::chart_point",
    "Metric::distance_m",
    "Metric::eye_distance_m",
    "Map::port_normal",
    "Optics::clip_from_view",
    "Geometry::picture",
    "Geometry::strategy",
    "Projection::new",
    "Projection::clip",
    "Horizon::kappa",
    "Horizon::hyperbolic",
    "Raised::new",
    "Spherical::new",
    "Eye::to_view",
    "Eye::to_chart",
];

/// Without golden rows, and why.
const EXCUSED: &[(&str, &str)] = &[
    (
        "Metric::in_frame",
        "the scale along each axis of the frame: src/pace.rs has speeds through doors",
    ),
    ("Metric::in_chart", "its inverse: src/pace.rs"),
    (
        "world_optics::plan_corners",
        "corners of cells, which must hold what is seen: tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "LevelMap::at",
        "Metric::in_chart as a matrix: src/level_map.rs measures lengths that go by it",
    ),
    ("LevelMap::in_chart", "a product with that"),
    ("LevelMap::in_space", "a product with its inverse"),
    ("LevelMap::half_box", "a bound of it"),
    ("pace::share", "a ratio of lengths of the same: src/pace.rs"),
    (
        "triangle::equilateral_angle_sum_rad",
        "told in words to a tenth of a degree; beside it are its values of 40 digits",
    ),
    (
        "triangle::square_gap_m",
        "told in words to a tenth of a metre; beside it are the golden tiling's exact gaps",
    ),
    (
        "Atlas::reaches",
        "compares Atlas::least_outside_m; src/chunk_cube.rs has the chunks on either side",
    ),
    (
        "ChunkCube::about",
        "which chunks are near; beside it is what it holds over an edge",
    ),
    (
        "Atlas::side_chunks",
        "a half width in whole chunks, rounded up; src/chunk_cube.rs counts chunks by it",
    ),
    (
        "linear::dot",
        "one sum of products; every kernel's rows go through it",
    ),
    (
        "linear::inner",
        "one sum of products; every distance's rows go through it",
    ),
    ("linear::space", "drops a coordinate"),
    (
        "linear::along",
        "one sum of products; every normal's rows go through it",
    ),
    (
        "linear::scaled",
        "one product; every normal's rows go through it",
    ),
    (
        "linear::drawn_in",
        "a scaling that points inside the range never meet; the fuzz tests it",
    ),
    (
        "frame::product",
        "sums of products; the composed moves of extremes.rs go through it",
    ),
    (
        "linear::lacks",
        "an exact identity: extremes.rs holds it to 1e-9 in both precisions",
    ),
    ("library::length_rest", "a length and nothing: extremes.rs"),
    (
        "series::length_rest",
        "an exact identity: extremes.rs holds it to 2^-32 of the length",
    ),
    (
        "parts::product",
        "sums of products; the charts' rows go through it",
    ),
    (
        "parts::cosine_less_one",
        "sums of products; the horizon map's rows go through it",
    ),
    ("charts::inner", "one sum of products"),
    (
        "exponential::bend",
        "a choice between two tested forms; the normals' rows go through it",
    ),
    (
        "cylindrical::level_normal",
        "the part of the normals' rows that two maps share",
    ),
    (
        "Metric::of_radius",
        "1 over a radius; the rows of distances go through it",
    ),
    ("Metric::of_kappa", "1 over the root of a tested curvature"),
    (
        "Metric::curvature_at",
        "Horizon::kappa, which the rows of distances go through",
    ),
    ("Metric::radius_at_m", "Metric::curvature_at's radius"),
    (
        "Map::along",
        "the inverse of eye_distance_m and chart_point: tests/it/space/picking.rs",
    ),
    ("Map::curved", "the charts' own rows, at the point"),
    (
        "Atlas::cross",
        "an exact turn, a million times over: tests/it/space/crossing.rs",
    ),
    (
        "Atlas::carry",
        "an exact turn, both charts give one point: tests/it/space/crossing.rs",
    ),
    (
        "Atlas::carry_near",
        "as carry, by the shorter side: tests/it/space/cone.rs",
    ),
    (
        "Atlas::images",
        "the same function: tests/it/space/crossing.rs",
    ),
    (
        "Atlas::way_m",
        "a difference of what Atlas::carry_near writes, or Tiled::level_way_m",
    ),
    ("Atlas::spread_m", "a bound: tests/it/space/crossing.rs"),
    ("Globe::new", "a radius"),
    (
        "Globe::from_middle_m",
        "Atlas::noise_point, and beside it the circle over the poles",
    ),
    (
        "Globe::over_poles",
        "exact where it is: beside it, all round",
    ),
    (
        "Globe::along_poles",
        "exact where it is: beside it, all round",
    ),
    (
        "Globe::reach_in_chart_m",
        "a bound: what a pick may follow in scene/src/reach.rs",
    ),
    (
        "ViewMode::saved",
        "a choice: what a save tells, in scene/src/lens/tests.rs",
    ),
    (
        "ViewMode::of",
        "a radius over a share, for the rows of pictures",
    ),
    ("ChartPoint::within", "takes over what it is given"),
    (
        "Atlas::turned",
        "exact quarter turns: tests/it/space/atlas.rs",
    ),
    (
        "Atlas::turned_back",
        "exact quarter turns: tests/it/space/atlas.rs",
    ),
    (
        "Atlas::in_common_axes",
        "exact quarter turns: tests/it/space/atlas.rs",
    ),
    (
        "Atlas::in_sky_axes",
        "the same from all charts: tests/it/hyperbolic_world/north.rs",
    ),
    ("Atlas::placed", "a turn and a sum: tests/it/space/atlas.rs"),
    ("Atlas::taken", "a turn and a sum: tests/it/space/atlas.rs"),
    (
        "Atlas::noise_point",
        "continuity over the equator is what counts: tests/it/space/crossing.rs",
    ),
    ("Atlas::tangent", "a tangent of a ratio"),
    ("Optics::reference", "the eye or a middle"),
    ("Optics::sight_limit_m", "a constant times the radius"),
    ("Optics::trims", "a comparison: tests/it/space/horizon.rs"),
    (
        "Optics::sight_cell",
        "must hold what is seen, not equal it: tests/it/space/culling.rs",
    ),
    (
        "Optics::sight_cell_of",
        "must hold the cells of what is inside: tests/it/space/culling.rs",
    ),
    (
        "Map::viewer",
        "view_point, bit for bit: tests/it/space/golden.rs",
    ),
    (
        "Optics::frustum",
        "planes of the projection: tests/it/space/culling.rs",
    ),
    ("Optics::ball_rises_m", "a bound: tests/it/space/culling.rs"),
    (
        "Optics::view_matrix",
        "goes into the uniform: the shader's rows on the adapter go through it",
    ),
    (
        "Optics::chart_matrix",
        "a product: the shader's rows on the adapter go through it",
    ),
    (
        "Optics::light_matrix",
        "a product: tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "Optics::port_origin",
        "the law of pictures goes through it: tests/it/hyperbolic_world/picture.rs",
    ),
    (
        "Optics::uniform",
        "casts; the shader's rows on the adapter go through it",
    ),
    (
        "Metric::distance_between_views_m",
        "Metric::distance_m's rows go through it",
    ),
    ("Projection::screen", "a division"),
    (
        "SightCell::holds",
        "must hold what is seen: tests/it/space/culling.rs",
    ),
    (
        "SightCell::turn",
        "brings an angle to a half turn: tests/it/space/culling.rs",
    ),
    ("SightCell::square", "a sum: tests/it/space/culling.rs"),
    ("SightCell::of_box", "a bound: tests/it/space/culling.rs"),
    (
        "SightCell::new",
        "constants of an axis: tests/it/space/culling.rs",
    ),
    ("SightCell::cell", "a bound: tests/it/space/culling.rs"),
    (
        "SightCell::cell_of_box",
        "a bound: tests/it/space/culling.rs",
    ),
    (
        "doorway::at",
        "takes LevelMap::at: an_opening_is_as_large in src/doorway.rs measures it",
    ),
    (
        "doorway::local",
        "of products alone; held by there_and_back in src/doorway.rs",
    ),
    (
        "doorway::place",
        "of products alone; held by there_and_back in src/doorway.rs",
    ),
    (
        "doorway::met",
        "a decision: a_way_goes_through in src/doorway.rs",
    ),
    (
        "doorway::carry",
        "there_and_back in src/doorway.rs, to 1e-12 of the coordinates",
    ),
    (
        "doorway::pass",
        "there_and_back in src/doorway.rs, to 1e-12 of the coordinates",
    ),
    ("doorway::pictured", "who_looks_through in src/doorway.rs"),
    ("doorway::eye", "who_looks_through in src/doorway.rs"),
    (
        "Frustum::new",
        "planes of the projection: tests/it/space/culling.rs",
    ),
    (
        "Frustum::cell_seen",
        "a decision: tests/it/space/culling.rs",
    ),
    (
        "SpaceUniform::new",
        "casts; the shader's rows on the adapter go through it",
    ),
    (
        "SpaceUniform::level",
        "casts; the shader's rows on the adapter go through it",
    ),
    (
        "SpaceUniform::within",
        "a cast; the edge of a chart in pictures: antipode-render, spaces",
    ),
    ("Euclidean::rotation", "the eye's axes: Eye::to_view"),
    (
        "ChunkCoord::containing",
        "a whole number: its own unit tests",
    ),
    ("ChartPoint::new", "no arithmetic"),
    ("ChartPoint::a", "no arithmetic"),
    ("ChartPoint::moved", "one sum"),
    (
        "ChartPoint::turn_vector",
        "a rotation: tests/it/space/crossing.rs",
    ),
];

/// Types that carry numbers in a signature.
const NUMBERS: &[&str] = &[
    "f64",
    "f32",
    "T",
    "Self",
    "DVec3",
    "DVec4",
    "ChartPoint",
    "Eye",
];

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
}

/// Functions of a module that take numbers: name and arguments up to the closing bracket. Of the
/// traits, their methods too.
fn public_functions(module: &str, source: &str) -> Vec<String> {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    let mut out = Vec::new();
    for line_start in code.match_indices("fn ").map(|(at, _)| at) {
        let before = code[..line_start]
            .rsplit('\n')
            .next()
            .unwrap_or_default()
            .trim();
        let method = ["Atlas", "Map", "Metric", "Optics"].contains(&module)
            && before.is_empty()
            && code[line_start..].contains("&self");
        if !before.starts_with("pub") && !method {
            continue;
        }
        let rest = &code[line_start + 3..];
        let name = rest.split(['(', '<']).next().unwrap_or_default();
        let open = rest.find('(').unwrap();
        let close = open + rest[open..].find(") ").unwrap_or_default();
        let arguments = rest[open..close].replace("&self", "").replace("self", "");
        if words(&arguments).any(|word| NUMBERS.contains(&word)) && !name.contains(' ') {
            out.push(format!("{module}::{name}"));
        }
    }
    out
}

#[test]
fn every_public_function_of_numbers_is_held_or_excused() {
    let tables = functions::checks().into_iter().chain(kernels::checks());
    let held = tables.flat_map(|check| check.covers.iter().copied());
    let whole = STRATEGIES.iter().chain(tiling::HELD).copied();
    let others = tiling::EXCUSED.iter().chain(hyperbolic_world::EXCUSED);
    let excused = EXCUSED.iter().chain(others).map(|(name, _)| *name);
    let listed: Vec<&str> = held.chain(whole).chain(excused).collect();
    let mut all = Vec::new();
    let others = tiling::SOURCES.iter().chain(hyperbolic_world::SOURCES);
    for (module, source) in SOURCES.iter().chain(others) {
        all.extend(public_functions(module, source));
    }
    let missing: Vec<&String> = all
        .iter()
        .filter(|name| !listed.contains(&name.as_str()))
        .collect();
    assert!(missing.is_empty(), "neither held nor excused: {missing:?}");
    // A list that names what is gone would excuse whatever takes the name next.
    let known = |name: &str| all.iter().any(|other| other == name);
    let gone: Vec<&str> = listed.into_iter().filter(|name| !known(name)).collect();
    assert!(gone.is_empty(), "listed, but not in the sources: {gone:?}");
}

#[test]
fn every_golden_table_is_read_by_a_check() {
    let names: Vec<&str> = functions::checks()
        .iter()
        .chain(&kernels::checks())
        .map(|check| check.table)
        .collect();
    for text in [FUNCTIONS, KERNELS] {
        for line in text.lines().filter(|line| line.ends_with(": [")) {
            let name = line.trim_end_matches(": [").trim_matches('"');
            assert!(names.contains(&name), "{name} is read by nothing");
        }
    }
}
