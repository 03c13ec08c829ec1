//! How vertices of the land are laid out and rounded.

use std::mem::offset_of;

use antipode_geometry::{ChartId, Geometry, HyperbolicMap, picture};
use glam::{IVec3, Vec3};

use super::*;
use crate::plan::testing;

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

#[test]
fn land_that_streams_in_beside_an_edit_is_no_part_of_it() {
    let Some(gpu) = Gpu::for_test() else {
        return;
    };
    let mesh = |height: f32| {
        let corners = [[3.0, height, 3.0], [9.0, height, 3.0], [3.0, height, 9.0]];
        let vertices = corners.map(|at| Vertex::new(Vec3::from(at), Vec3::Y, [90; 3]));
        ChunkMesh {
            vertices: vertices.to_vec(),
            indices: vec![0, 1, 2],
            ..ChunkMesh::default()
        }
    };
    let put = |x: i32, height: f32| {
        let coord = ChunkCoord::new(ChartId::FIRST, IVec3::new(x, 0, 0));
        ChunkChange::Put(coord, Arc::new(mesh(height)))
    };
    let mut frame = testing::frame(&picture(
        Geometry::Euclidean,
        1.0,
        HyperbolicMap::Raised,
        false,
    ));
    let mut store = ChunkStore::new(&gpu);
    frame.change_land([put(0, 4.0)]);
    store.apply(&frame);
    store.take_touched();
    // Somebody builds from chunk 0 up into the empty one beside it while a far one comes.
    frame.change_land([put(0, 5.0), put(1, 5.0), put(6, 5.0)]);
    store.apply(&frame);
    let mut edited: Vec<_> = store.take_touched();
    edited.retain(|it| it.is_edited);
    let farthest = edited.iter().map(|it| it.of.max.x).fold(0.0, f64::max);
    assert!(
        edited.len() >= 2 && farthest < 64.0,
        "{farthest} m: {edited:?}"
    );
    assert_eq!(store.casters().count(), 3, "all of it is shown at once");
}
