//! Shadows in the hyperbolic world.

use std::sync::Arc;

use crate::common::{Studio, frame, seen_at};
use crate::squares::{ASPECT, HALF_M, SIZE, keep, level, plain, world};
use antipode_frame::{ChunkChange, Land};
use antipode_geometry::{ChartPoint, ChunkCoord, Eye, Strategy};
use antipode_render::ShadowQuality;
use antipode_terrain::ChunkMesh;
use glam::{DVec3, DVec4, Vec3};
use image::RgbaImage;

/// The point so many metres from one, in view coordinates, towards the ideal point that the eye sees in a direction.
fn toward(radius_m: f64, from: DVec4, sun: DVec3, metres: f64) -> DVec4 {
    let at = (from.truncate() / radius_m).extend(from.w);
    let null = sun.extend(1.0);
    let inner = at.truncate().dot(sun) - at.w;
    let way = null / -inner - at;
    let t = metres / radius_m;
    let to = at * t.cosh() + way * t.sinh();
    (to.truncate() * radius_m).extend(to.w)
}

/// A spot of the ground before an eye, the chunk in which a plate hangs over it towards a sun that the eye sees in such a direction,
/// and where in that.
fn hung_over(
    world: &dyn Strategy,
    eye: &Eye,
    seen: DVec3,
) -> Option<(ChartPoint, ChunkCoord, Vec3)> {
    (0..12).map(f64::from).find_map(|i| {
        let middle = world.along(eye, DVec3::NEG_Z, 3.9 + 0.3 * i);
        let spot = ChartPoint::new(middle.chart, middle.pos.with_y(0.0));
        let hung = toward(
            world.radius_m(),
            world.view_point(eye, spot),
            seen,
            13.0 - 0.6 * i,
        );
        let plate = world.chart_point(eye, hung);
        let coord = ChunkCoord::containing(plate);
        let inside = (plate.pos - coord.origin()).as_vec3();
        let fits = inside.min_element() > 1.0 && inside.max_element() < 31.0;
        fits.then_some((spot, coord, inside))
    })
}

/// The mean place of the pixels that differ, and how many they are.
fn middle_of_difference(a: &RgbaImage, b: &RgbaImage) -> (f64, f64, f64) {
    let (mut sum, mut count) = ((0.0, 0.0), 0.0);
    for ((x, y, p), q) in a.enumerate_pixels().zip(b.pixels()) {
        if (0..3).any(|i| p.0[i].abs_diff(q.0[i]) > 12) {
            sum = (sum.0 + f64::from(x) + 0.5, sum.1 + f64::from(y) + 0.5);
            count += 1.0;
        }
    }
    (sum.0 / count, sum.1 / count, count)
}

/// A plate over the ground throws its shadow along geodesics, whichever of the squares about a corner it hangs in and whichever
/// the shadow falls on.
#[test]
fn shadows_fall_along_geodesics_over_edges() {
    let world = world();
    let at = ChartPoint::a(DVec3::new(HALF_M - 0.7, 2.5, HALF_M - 0.4));
    let ground = plain(&*world, at, 110.0);
    let mut crossed = 0;
    for quality in [ShadowQuality::Low, ShadowQuality::High] {
        let Some(mut studio) = Studio::shadowed(SIZE, quality) else {
            return;
        };
        for turn in 0..5 {
            let mut frame = frame(&world, at, ASPECT);
            frame.view.eye.yaw = 0.4 + 1.26 * f64::from(turn);
            frame.view.eye.pitch = -0.45;
            // From behind over the right shoulder.
            let seen = DVec3::new(0.5, 0.55, 0.67).normalize();
            let sun = frame.view.eye.to_chart(seen);
            let axes = DVec3::AXES.map(|axis| world.in_sky_axes(at, axis));
            let sky = axes[0] * sun.x + axes[1] * sun.y + axes[2] * sun.z;
            frame.content_mut().sky.key_direction = sky.as_vec3().into();
            let eye = frame.view.eye;
            let hung = hung_over(&*world, &eye, seen);
            let (spot, coord, inside) = hung.expect("a place for the plate");
            crossed += u32::from(coord.chart != spot.chart);
            let corner = |x: f32, z: f32| inside + 0.35 * Vec3::new(x, 0.0, z);
            let round = [
                corner(-1.0, -1.0),
                corner(-1.0, 1.0),
                corner(1.0, 1.0),
                corner(1.0, -1.0),
            ];
            let mesh = crate::common::plates(&[round]);
            let mut both = ChunkMesh::clone(&level([90, 120, 60]));
            let first = both.vertices.len() as u32;
            both.vertices.extend_from_slice(&mesh.vertices);
            both.indices.extend(mesh.indices.iter().map(|i| i + first));
            let mut with = Land::clone(&ground);
            with.change(ChunkChange::Put(coord, Arc::new(both)));
            frame.content_mut().land = Arc::clone(&ground);
            let bare = studio.picture(&frame);
            let shaded = frame.clone().with_content(|it| {
                it.loaded_world += 1 << 40;
                it.land = Arc::new(with);
            });
            let picture = studio.picture(&shaded);
            keep(&picture, &format!("shadow-{quality:?}-{turn}"));
            let (mean_x, mean_y, count) = middle_of_difference(&picture, &bare);
            let (x, y) = seen_at(&frame, spot, SIZE);
            let off = (mean_x - x).hypot(mean_y - y);
            println!("{quality:?} {turn}: {count} pixels, {off} off");
            assert!(
                count > 60.0 && off < 3.0,
                "{quality:?} {turn}: {count} pixels, {off} off"
            );
        }
    }
    assert!(crossed > 1, "some lie over an edge");
}
