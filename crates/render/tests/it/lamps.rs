//! The light of a lamp: on a wall it does not depend on where in a closed world they stand, and under a sky it is there.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use crate::common::{Studio, difference, frame, noon, plates, space};
use antipode_frame::{ChunkChange, LampLight, Land, Lights, Sky};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Eye, Geometry, Strategy};
use antipode_terrain::{ChunkMesh, Vertex};
use glam::{DVec2, DVec3, DVec4};
use image::RgbaImage;

const SIZE: (u32, u32) = (160, 90);
const ASPECT: f64 = 16.0 / 9.0;
/// Distance of the wall, half its side, and the side of the squares it is made of, metres.
const WALL_M: f64 = 4.0;
const HALF_M: f64 = 2.5;
const SQUARE_M: f64 = 0.25;
/// The lamp from the eye, metres: to the right, up and ahead.
const LAMP_M: DVec3 = DVec3::new(0.6, 0.5, 2.4);

/// The point of view coordinates reached from the eye along `way`, metres, by a geodesic.
fn seen(space: &dyn Strategy, way: DVec3) -> DVec4 {
    let (radius_m, length) = (space.radius_m(), way.length());
    let (sin, cos) = (length / radius_m).sin_cos();
    (way / length * radius_m * sin).extend(cos)
}

/// A place of the flat wall straight ahead, `at` metres to the right and up of its middle.
fn on_wall(space: &dyn Strategy, eye: &Eye, at: DVec2) -> ChartPoint {
    let radius_m = space.radius_m();
    let middle = seen(space, DVec3::NEG_Z * WALL_M);
    let length = at.length().max(1e-9);
    let (sin, cos) = (length / radius_m).sin_cos();
    let aside = at.extend(0.0) / length * radius_m * sin;
    space.chart_point(
        eye,
        (middle.truncate() * cos + aside).extend(middle.w * cos),
    )
}

/// The same place in the given chart.
fn carried(space: &dyn Strategy, point: ChartPoint, chart: ChartId) -> DVec3 {
    space.carry(point, chart).unwrap().point.pos
}

/// The wall as meshes: in each chart whatever of it lies there, by chunks.
fn wall(space: &dyn Strategy, eye: &Eye) -> Land {
    let mut meshes: BTreeMap<ChunkCoord, ChunkMesh> = BTreeMap::new();
    let squares = (2.0 * HALF_M / SQUARE_M) as i32;
    let place =
        |i: i32, j: i32| DVec2::new(f64::from(i), f64::from(j)) * SQUARE_M - DVec2::splat(HALF_M);
    for (i, j) in (0..squares).flat_map(|i| (0..squares).map(move |j| (i, j))) {
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| place(i, j));
        let points = corners.map(|at| on_wall(space, eye, at));
        for chart in [ChartId::FIRST, ChartId::SECOND] {
            if points.iter().all(|point| point.chart != chart) {
                continue;
            }
            let place = |at: DVec2| carried(space, on_wall(space, eye, at), chart);
            let at = corners.map(place);
            let middle = at.iter().sum::<DVec3>() / 4.0;
            let coord = ChunkCoord::containing(ChartPoint::new(chart, middle));
            let mesh = meshes.entry(coord).or_default();
            let first = mesh.vertices.len() as u32;
            for (corner, pos) in corners.iter().zip(at) {
                // A covector of the chart: square to what leads along the wall there.
                let step = 1e-3;
                let right = place(*corner + DVec2::X * step) - pos;
                let up = place(*corner + DVec2::Y * step) - pos;
                let normal = right.cross(up).normalize();
                let local = (pos - coord.origin()).as_vec3();
                mesh.vertices
                    .push(Vertex::new(local, normal.as_vec3(), [200, 200, 200]));
            }
            mesh.indices
                .extend([0, 1, 2, 0, 2, 3].map(|index| first + index));
        }
    }
    meshes
        .into_iter()
        .map(|(coord, mesh)| ChunkChange::Put(coord, Arc::new(mesh)))
        .collect()
}

/// Linear light of a level of the display, as the filmic curve and the sRGB curve make it; by bisection.
fn light(level: f64) -> f64 {
    let shown = |light: f64| {
        let x = light * 0.86;
        let filmic = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
        255.0 * (1.055 * filmic.max(0.003_130_8).powf(1.0 / 2.4) - 0.055)
    };
    let (mut low, mut high) = (0.0, 16.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if shown(middle) < level {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// How much brighter the lamp makes the middle of the wall, and how much what is about it.
fn brightening(studio: &mut Studio, space: &Arc<dyn Strategy>, eye: Eye) -> [f64; 2] {
    let empty = frame(space, eye.point, ASPECT);
    let dark = Sky {
        key_colour: [0.0; 3],
        ambient_sky: [1.4; 3],
        ambient_ground: [1.4; 3],
        orbs: None,
        ..noon()
    };
    let mut frame = empty
        .with_view(|it| {
            it.eye = eye;
            it.fog_distance_m = 1e6;
        })
        .with_content(|it| {
            it.sky = Sky {
                dome: false,
                ..dark
            };
            it.land = Arc::new(wall(&**space, &eye));
        });
    let bare = studio.picture(&frame);
    let way = DVec3::new(LAMP_M.x, LAMP_M.y, -LAMP_M.z);
    frame.content_mut().lights = Lights {
        lamps: vec![LampLight {
            point: space.chart_point(&eye, seen(&**space, way)),
            colour: [1.0; 3],
            range_m: 12.0,
        }],
        beams: Vec::new(),
    };
    let lit = studio.picture(&frame);
    let ratio = |columns: std::ops::Range<u32>| {
        let mut sum = 0.0;
        let pixels = || columns.clone().flat_map(|x| (35..55).map(move |y| (x, y)));
        let level = |picture: &RgbaImage, (x, y)| light(f64::from(picture.get_pixel(x, y).0[1]));
        for pixel in pixels() {
            sum += level(&lit, pixel) / level(&bare, pixel);
        }
        sum / pixels().count() as f64
    };
    [ratio(70..90), ratio(105..115)]
}

#[test]
fn a_lamp_lights_a_wall_alike_at_both_centres_and_over_the_equator() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let space = space(Geometry::Spherical);
    let (rim_m, height_m) = (
        space.domain(ChartId::FIRST).radius_m().unwrap(),
        0.3 * space.radius_m(),
    );
    let eye = |chart, angle: f64, level_m: f64, yaw: f64| Eye {
        point: ChartPoint::new(
            chart,
            DVec3::new(level_m * angle.cos(), height_m, level_m * angle.sin()),
        ),
        yaw,
        pitch: 0.0,
        roll: 0.0,
        dial: 0.0,
        lift_m: 0.0,
    };
    // The height shrinks ways on the ground, so the equator is a little nearer than it is in the chart.
    let ground = 0.3f64.cos();
    let places = [
        ("the centre of A", eye(ChartId::FIRST, 0.0, 0.0, 0.3)),
        ("the centre of B", eye(ChartId::SECOND, 0.0, 0.0, -1.2)),
        (
            "aslant over the equator",
            eye(ChartId::FIRST, 0.9, rim_m - 4.0 / ground, 0.9 + 0.5),
        ),
        (
            "the lamp in A, the wall in B",
            eye(ChartId::FIRST, -2.0, rim_m - 3.2 / ground, -2.0),
        ),
        (
            "along the equator",
            eye(ChartId::SECOND, 0.4, rim_m - 0.3, 0.4 + FRAC_PI_2),
        ),
    ];
    let found = places.map(|(name, eye)| (name, brightening(&mut studio, &space, eye)));
    let [middle, aside] = found[0].1;
    assert!(middle > 1.8 && aside > 1.05 && aside < middle, "{found:?}");
    for (name, [there, beside]) in &found {
        for (here, there) in [(middle, there), (aside, beside)] {
            let off = there / here - 1.0;
            assert!(off.abs() < 0.01, "{name}: {there} and not {here}");
        }
    }
}

/// Under a sky what no lamp lights is drawn by pipelines that know of none.
#[test]
fn a_lamp_lights_the_ground_under_a_sky() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let ground = [[4.0, 4.0], [4.0, 24.0], [24.0, 24.0], [24.0, 4.0]]
        .map(|[x, z]| glam::Vec3::new(x, 2.0, z));
    let chunk = ChunkCoord::containing(ChartPoint::a(DVec3::ONE));
    for geometry in [Geometry::Euclidean, Geometry::Hyperbolic] {
        let eye = ChartPoint::a(DVec3::new(8.0, 5.0, 14.0));
        let mut frame = frame(&space(geometry), eye, ASPECT);
        frame.view.eye.pitch = -0.5;
        frame.change_land([ChunkChange::Put(chunk, plates(&[ground]))]);
        let bare = studio.picture(&frame);
        frame.content_mut().lights.lamps = vec![LampLight {
            point: ChartPoint::a(DVec3::new(13.0, 3.5, 14.0)),
            colour: [3.0; 3],
            range_m: 12.0,
        }];
        let lit = studio.picture(&frame);
        let (changed, mean) = difference(&bare, &lit);
        assert!(mean > 1.0, "{geometry:?}: {changed} and {mean}");
    }
}
