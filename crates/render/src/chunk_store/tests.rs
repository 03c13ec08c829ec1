//! How vertices of the land are laid out and rounded.

use std::mem::offset_of;

use glam::Vec3;

use super::*;

#[test]
fn terrain_vertices_are_laid_out_as_the_pipeline_reads_them() {
    let ours = [
        offset_of!(Vertex, units),
        offset_of!(Vertex, octahedral),
        offset_of!(Vertex, colour),
    ];
    assert_eq!(VERTEX_ATTRIBUTES.map(|a| a.offset as usize), ours);
    assert_eq!(VERTEX_BYTES, 16);
}

/// Vertices lie on the edges of the grid, so that one coordinate is rounded, and the others are whole metres.
#[test]
fn rounded_positions_are_off_by_less_than_a_tenth_of_a_pixel_where_the_eye_can_be() {
    let focal_px = 360.0 / (0.5 * antipode_scene::tuning::FOV_Y_RAD).tan();
    let mut worst_m: f64 = 0.0;
    for i in 0..20_000 {
        let exact = 7.0 + f64::from(i) * 1e-4 / 2.0;
        let vertex = Vertex::new(Vec3::new(3.0, exact as f32, 31.0), Vec3::Y, [0; 3]);
        let drawn = vertex.position().as_dvec3();
        assert_eq!((drawn.x, drawn.z), (3.0, 31.0));
        worst_m = worst_m.max((drawn.y - exact).abs());
    }
    assert!(worst_m > 1e-5, "{worst_m}");
    // As near as the camera gets to ground; and where a standing player's eye is over level ground.
    assert!(worst_m / 0.18 * focal_px < 0.1);
    assert!(worst_m / 1.62 * focal_px < 0.01);
}
