//! The shader of the land that tells what shadows do there instead of showing it.

use antipode_render::{Shaders, TERRAIN};

/// Red is what the maps let through of the light, by the curve of tonemap.wgsl; green is what turns away.
pub fn told() -> Shaders {
    let shown = "fn land_colour(";
    assert_eq!(TERRAIN.own.matches(shown).count(), 1);
    let own =
        "fn land_colour(in: VertexOut, point: Shaded, steps: Steps, offered: f32) -> vec4<f32> {
        let unlit = is_turned(in);
        let through = key_through(point, in.clip.xy, unlit, false);
        return vec4<f32>(through, select(0.0, 1.0, unlit), 0.0, 1.0);
    }";
    let text = TERRAIN.own.replace(shown, "fn land_colour_shown(") + own;
    Shaders::with("terrain", Box::leak(text.into_boxed_str()))
}
