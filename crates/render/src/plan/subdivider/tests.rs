//! Tests of halving: no crack, no overlap, true bounds.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use std::collections::HashMap;

use antipode_frame::{Content, Frame, View};
use antipode_geometry::{
    ChartPoint, ChunkCoord, Eye, Geometry, HyperbolicMap, Projection, picture,
};
use antipode_terrain::Level;
use glam::{DVec3, IVec3};

use super::super::ChunkLand;
use super::super::bounds::{Bounds, PictureScale};
use super::super::refine::unhalved_error_px;
use super::*;

/// A rolling meadow of one chunk, two triangles to a cell of 1 m, with its corner at `corner`.
fn meadow(corner: DVec3) -> ChunkMesh {
    let mut mesh = ChunkMesh::default();
    let side = 33;
    for i in 0..side * side {
        let (x, z) = ((i % side) as f32, (i / side) as f32);
        let world = corner + DVec3::new(f64::from(x), 0.0, f64::from(z));
        let y = 10.0 + ((world.x * 0.3).sin() * (world.z * 0.2).cos()) as f32;
        let place = Vec3::new(x, y, z);
        mesh.vertices
            .push(Vertex::new(place, Vec3::Y, [90, 140, 60]));
        if x < 32.0 && z < 32.0 {
            mesh.indices
                .extend([i, i + side, i + 1, i + 1, i + side, i + side + 1]);
        }
    }
    mesh
}

fn frame() -> Frame {
    let strategy = picture(Geometry::Hyperbolic, 20.0, HyperbolicMap::Raised, false);
    let eye = Eye {
        point: ChartPoint::a(DVec3::new(30.2, 12.0, 7.4)),
        dial: 20.0,
        ..Eye::default()
    };
    let content = Content {
        loaded_world: 1,
        ..Content::default()
    };
    let view = View {
        fog_distance_m: 100.0,
        ..View::new(eye, Projection::new(1.3, 1.7, 0.02), strategy)
    };
    Frame::new(content, view)
}

fn bounds(frame: &Frame) -> Bounds {
    Bounds::measure(frame, PictureScale::new(&frame.view.projection, 720))
}

fn land(x: i32) -> (ChunkLand, ChunkMesh) {
    let middle = DVec3::new(f64::from(32 * x) + 1.0, 1.0, 1.0);
    let coord = ChunkCoord::containing(ChartPoint::a(middle));
    let mesh = meadow(coord.origin());
    (ChunkLand::of(coord, &mesh), mesh)
}

/// The halved meadow, and the rules it was halved by.
fn refine_meadow(x: i32) -> (ChunkLand, Refined, RefineRules) {
    let frame = frame();
    let (land, mesh) = land(x);
    let rules = RefineRules::new(&frame, &bounds(&frame), DVec3::ZERO);
    let eyes = rules.eyes_from(&frame, &land);
    let refined = Subdivider::default().refine(&rules, &eyes, &mesh);
    (land, refined, rules)
}

/// The corners of each triangle, in metres from the chunk's corner.
fn triangles(refined: &Refined) -> Vec<[Vec3; 3]> {
    let of = |part: &Part| -> Vec<[Vec3; 3]> {
        let at = |i: u16| part.vertices[usize::from(i)].position();
        let corners = part.indices.as_chunks::<3>().0;
        corners.iter().map(|c| c.map(at)).collect()
    };
    refined.parts.iter().flat_map(of).collect()
}

/// Edges by the places of their ends, in 1/32768 m, and how often each is used.
fn edges(refined: &Refined, origin: DVec3) -> HashMap<[IVec3; 2], u32> {
    let place = |p: Vec3| ((p.as_dvec3() + origin) * 32768.0).round().as_ivec3();
    let mut uses = HashMap::new();
    for corners in triangles(refined) {
        for i in 0..3 {
            let mut ends = [place(corners[i]), place(corners[(i + 1) % 3])];
            ends.sort_by_key(IVec3::to_array);
            *uses.entry(ends).or_insert(0) += 1;
        }
    }
    uses
}

#[test]
fn no_crack_opens_inside_a_chunk_or_between_two() {
    let mut uses = HashMap::new();
    for x in 0..2 {
        let (land, refined, _) = refine_meadow(x);
        assert!(refined.halved > 100 && triangles(&refined).len() > land.triangles);
        assert!(refined.error_px <= 0.5, "{}", refined.error_px);
        for (edge, count) in edges(&refined, land.coord.origin()) {
            *uses.entry(edge).or_insert(0) += count;
        }
    }
    for ([a, b], count) in uses {
        let rim = |p: IVec3| p.x == 0 || p.z == 0 || p.x == 64 * 32768 || p.z == 32 * 32768;
        let expected = if rim(a) && rim(b) && (a.x == b.x || a.z == b.z) {
            1
        } else {
            2
        };
        assert_eq!(count, expected, "{a} {b}");
    }
}

#[test]
fn halving_keeps_the_ground_plan_and_the_side_that_is_up() {
    let (_, refined, _) = refine_meadow(0);
    let mut area = 0.0;
    for [a, b, c] in triangles(&refined) {
        let up = (b - a).cross(c - a).y;
        assert!(up > 0.0);
        area += f64::from(0.5 * up);
    }
    assert!((area - 1024.0).abs() < 1e-2, "{area}");
}

#[test]
fn seams_stay_sections_of_their_own_and_the_memory_of_one_mesh_leaves_no_trace_in_the_next() {
    let frame = frame();
    let (land, plain) = land(0);
    let rules = RefineRules::new(&frame, &bounds(&frame), DVec3::ZERO);
    let eyes = rules.eyes_from(&frame, &land);
    let mut subdivider = Subdivider::default();
    let first = subdivider.refine(&rules, &eyes, &plain);
    // The last row of cells as if it were a seam.
    let mut seamed = plain.clone();
    seamed.level = Level::ALL[1];
    let end = seamed.indices.len() as u32;
    seamed.seams[5] = end - 6 * 32..end;
    let split = subdivider.refine(&rules, &eyes, &seamed);
    let part = &split.parts[0];
    assert_eq!(part.sections[0].end, part.sections[6].start);
    assert!(part.sections[6].len() > 6 * 32);
    assert_eq!(triangles(&split).len(), triangles(&first).len());
    assert_eq!(subdivider.refine(&rules, &eyes, &plain), first);
}

/// The largest stray of the edges that are drawn, as a frame's own rules see it, in pixels.
fn truth_px(frame: &Frame, land: &ChunkLand, triangles: &[[Vec3; 3]]) -> f64 {
    let bounds = bounds(frame);
    let eye = (frame.view.eye.point.pos - land.coord.origin()).as_vec3();
    let edges = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let stray = |(a, b): (Vec3, Vec3)| {
        let toward = a.midpoint(b) - eye;
        let sine = f64::from(toward.y / toward.length());
        bounds.bend.between(toward.length().into(), [sine; 2]) * f64::from(a.distance_squared(b))
    };
    edges.map(stray).fold(0.0, f64::max)
}

#[test]
fn the_error_told_of_a_stale_halving_is_no_understatement() {
    for x in -1..2 {
        let (land, refined, rules) = refine_meadow(x);
        let drawn = triangles(&refined);
        let mut frame = frame();
        for (step, dial) in [
            (0.0, 20.0),
            (0.3, 20.0),
            (2.0, 20.0),
            (9.0, 19.0),
            (0.0, 26.0),
        ] {
            frame.view.eye.point = ChartPoint::a(DVec3::new(30.2 - step, 12.0, 7.4 + 0.5 * step));
            frame.view.eye.dial = dial;
            let now = bounds(&frame);
            let near_m = Bounds::nearest_chart_m(&frame, &land);
            let told = rules.stale_error_px(refined.error_px, &frame, &now, &land, near_m);
            let truth = truth_px(&frame, &land, &drawn);
            assert!(told >= truth, "{x} {step} {dial}: {told} {truth}");
            assert!(told <= unhalved_error_px(&frame, &now, &land) * 1.2);
            if step > 1.0 && x == 0 {
                assert!(truth > 0.5, "moving away from it would do no harm: {truth}");
            }
        }
    }
}
