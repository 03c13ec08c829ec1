//! Shadows of the key light: where geometry says they are, and nowhere else, in every space.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::common::{GEOMETRIES, Studio, difference, frame, one_chunk, seen_at, space};
use antipode_frame::{ChunkChange, Figure, Frame, ModelId};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Eye, Geometry};
use antipode_render::ShadowQuality;
use antipode_terrain::{ChunkMesh, Vertex};
use glam::{DVec3, IVec3, Vec3};
use image::RgbaImage;

pub const SIZE: (u32, u32) = (640, 360);
const ASPECT: f64 = 16.0 / 9.0;
/// Height of the floor, high enough for a closed world, and where a pillar stands on it.
pub const FLOOR_M: f64 = 8.0;
const PILLAR: [DVec3; 2] = [
    DVec3::new(15.0, FLOOR_M, 15.0),
    DVec3::new(16.0, FLOOR_M + 3.0, 16.0),
];
/// A texel of the finest map of low quality under a sky, metres.
const TEXEL_M: f64 = 24.0 / 1024.0;

/// Squares of a metre over a rectangle of whole metres from `corner` along `a` and `b`, seen from where both turn
/// against the clock.
fn rectangle(mesh: &mut ChunkMesh, corner: Vec3, a: Vec3, b: Vec3) {
    let normal = a.cross(b).normalize();
    let (wide, long) = (a.length().round() as u32, b.length().round() as u32);
    let first = mesh.vertices.len() as u32;
    for (i, j) in (0..=long).flat_map(|i| (0..=wide).map(move |j| (i, j))) {
        let at = corner + a * (j as f32 / wide as f32) + b * (i as f32 / long as f32);
        mesh.vertices.push(Vertex::new(at, normal, [200, 200, 200]));
    }
    for (i, j) in (0..long).flat_map(|i| (0..wide).map(move |j| (i, j))) {
        let at = first + i * (wide + 1) + j;
        let up = at + wide + 1;
        mesh.indices.extend([at, at + 1, up + 1, at, up + 1, up]);
    }
}

/// A floor of 32 m with a pillar on it.
fn floor_and_pillar() -> Arc<ChunkMesh> {
    let mut mesh = ChunkMesh::default();
    let (x, y, z) = (Vec3::X, Vec3::Y, Vec3::Z);
    rectangle(&mut mesh, y * FLOOR_M as f32, z * 32.0, x * 32.0);
    let [low, high] = PILLAR.map(DVec3::as_vec3);
    let up = y * (high - low).y;
    rectangle(&mut mesh, low, up, x);
    rectangle(&mut mesh, low + x + z, up, -x);
    rectangle(&mut mesh, low + z, up, -z);
    rectangle(&mut mesh, low + x, up, z);
    rectangle(&mut mesh, low + up, z, x);
    Arc::new(mesh)
}

pub fn scene(geometry: Geometry) -> Frame {
    let space = space(geometry);
    let mut scene = frame(
        &space,
        ChartPoint::a(DVec3::new(10.0, FLOOR_M + 6.0, 10.0)),
        ASPECT,
    );
    let coord = ChunkCoord::new(ChartId::FIRST, IVec3::ZERO);
    scene.change_land([ChunkChange::Put(coord, floor_and_pillar())]);
    scene.view.eye.yaw = std::f64::consts::FRAC_PI_4;
    scene.view.eye.pitch = -0.75;
    scene.view.fog_distance_m = 1e4;
    if let Some(orbs) = scene.content.sky.orbs {
        // Lower than at its noon, so that the pillar throws a shadow to the side.
        let sun = ChartPoint::a(orbs.sun.pos + DVec3::new(-5.0, 0.0, 34.0));
        scene.content_mut().sky.orbs = Some(antipode_frame::Orbs { sun, ..orbs });
    }
    scene
}

fn studio(shadows: ShadowQuality, size: (u32, u32)) -> Option<Studio> {
    Studio::shadowed(size, shadows)
}

/// Pictures with and without shadows.
pub fn both(frame: &Frame, size: (u32, u32)) -> Option<[RgbaImage; 2]> {
    compared(frame, size, ShadowQuality::Low)
}

fn compared(frame: &Frame, size: (u32, u32), quality: ShadowQuality) -> Option<[RgbaImage; 2]> {
    let on = studio(quality, size)?.picture(frame);
    Some([on, studio(ShadowQuality::Off, size)?.picture(frame)])
}

fn is_in_pillar(p: DVec3, margin_m: f64) -> bool {
    let inside = |i: usize| PILLAR[0][i] - margin_m < p[i] && p[i] < PILLAR[1][i] + margin_m;
    inside(0) && inside(2) && p.y < PILLAR[1].y + margin_m
}

/// Whether the pillar, thicker by a margin, stands between a point of the floor and the light.
fn is_shaded(frame: &Frame, point: DVec3, margin_m: f64) -> bool {
    is_shaded_by(frame, point, |p| is_in_pillar(p, margin_m))
}

/// Whether something that is where `is_in` says stands between a point of the floor and the light.
pub fn is_shaded_by(frame: &Frame, point: DVec3, is_in: impl Fn(DVec3) -> bool) -> bool {
    let steps = (1..2000).map(|i| f64::from(i) * 0.01);
    if let Some(orbs) = frame.content.sky.orbs {
        let radius_m = frame.view.strategy.radius_m();
        let unit = |p| {
            let v = frame.view.strategy.view_point(&frame.view.eye, p);
            (v.truncate() / radius_m).extend(v.w)
        };
        let (from, sun) = (unit(ChartPoint::a(point)), unit(orbs.sun));
        let way = (sun - from * from.dot(sun)).normalize();
        return steps.take_while(|m| *m < 12.0).any(|metres| {
            let (sin, cos) = (metres / radius_m).sin_cos();
            let x = from * cos + way * sin;
            let view = (x.truncate() * radius_m).extend(x.w);
            let there = frame.view.strategy.chart_point(&frame.view.eye, view);
            there.chart == ChartId::FIRST && is_in(there.pos)
        });
    }
    let toward = DVec3::from(frame.content.sky.key_direction.map(f64::from));
    steps.map(|m| point + toward * m).any(is_in)
}

/// Whether the eye sees a point past the pillar.
fn is_seen(frame: &Frame, point: DVec3) -> bool {
    let eye = frame.view.eye.point.pos;
    // Straight lines of the picture are nearly those of the chart this close; the margin is for that.
    (1..400).all(|i| !is_in_pillar(eye.lerp(point, f64::from(i) / 400.0), 0.6))
}

pub fn brightness(picture: &RgbaImage, (x, y): (f64, f64)) -> Option<i32> {
    let inside = |v: f64, most: u32| (2.0..f64::from(most) - 2.0).contains(&v);
    if !inside(x, picture.width()) || !inside(y, picture.height()) {
        return None;
    }
    let [r, g, b, _] = picture.get_pixel(x as u32, y as u32).0.map(i32::from);
    Some(r + g + b)
}

#[test]
fn a_pillar_shades_what_lies_behind_it_and_nothing_else_in_every_space() {
    let qualities = [ShadowQuality::Low, ShadowQuality::High];
    for (geometry, quality) in GEOMETRIES
        .into_iter()
        .flat_map(|g| qualities.map(|q| (g, q)))
    {
        let frame = scene(geometry);
        let Some([on, off]) = compared(&frame, SIZE, quality) else {
            return;
        };
        let mut found = [0; 2];
        for (i, j) in (0..100).flat_map(|i| (0..100).map(move |j| (i, j))) {
            let point = DVec3::new(
                10.0 + f64::from(i) * 0.1,
                FLOOR_M,
                10.0 + f64::from(j) * 0.1,
            );
            let shaded = is_shaded(&frame, point, -0.2);
            let lit = !is_shaded(&frame, point, 0.2);
            if (!shaded && !lit) || !is_seen(&frame, point) || is_in_pillar(point, 0.2) {
                continue;
            }
            let at = seen_at(&frame, ChartPoint::a(point), SIZE);
            let (Some(with), Some(without)) = (brightness(&on, at), brightness(&off, at)) else {
                continue;
            };
            found[usize::from(lit)] += 1;
            if lit {
                assert!(
                    (with - without).abs() <= 6,
                    "{geometry}: {point} lit: {with} {without}"
                );
            } else {
                assert!(
                    without - with > 60,
                    "{geometry}: {point} shaded: {with} {without}"
                );
            }
        }
        assert!(found[0] > 30 && found[1] > 1000, "{geometry}: {found:?}");
    }
}

#[test]
fn a_shadow_ends_where_the_suns_elevation_says() {
    let size = (1280, 720);
    let mut frame = scene(Geometry::Euclidean);
    let toward = Vec3::new(-0.6, 0.64, 0.0).normalize();
    frame.content_mut().sky.key_direction = toward.into();
    let reach_m = (PILLAR[1].y - FLOOR_M) * f64::from(toward.x.abs() / toward.y);
    let tip = DVec3::new(PILLAR[1].x + reach_m, FLOOR_M, 15.5);
    frame.view.eye = Eye {
        point: ChartPoint::a(tip + DVec3::new(-0.5, 2.0, 0.0)),
        pitch: -1.3,
        yaw: 0.0,
        ..frame.view.eye
    };
    let Some([on, off]) = both(&frame, size) else {
        return;
    };
    let share = |x: f64| {
        let at = seen_at(&frame, ChartPoint::a(DVec3::new(x, FLOOR_M, 15.5)), size);
        f64::from(brightness(&on, at).unwrap()) / f64::from(brightness(&off, at).unwrap())
    };
    let dark = share(tip.x - 0.4);
    assert!(dark < 0.85 && share(tip.x + 0.4) > 0.99, "{dark}");
    let half = 0.5 * (1.0 + dark);
    let end = (0..800)
        .map(|i| tip.x - 0.4 + f64::from(i) * 0.001)
        .find(|x| share(*x) > half)
        .unwrap();
    assert!((end - tip.x).abs() < 2.0 * TEXEL_M, "{end} and {}", tip.x);
}

/// What a figure or a hill behind the eye throws into view is there, and turning the eye draws nothing anew.
#[test]
fn turning_the_eye_leaves_the_maps_alone() {
    let Some(mut studio) = studio(ShadowQuality::Low, SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        let mut frame = scene(geometry);
        frame.content_mut().loaded_world = geometry as u64 + 1;
        studio.draw(&frame);
        for turn in 0..6 {
            frame.view.eye.yaw += f64::from(turn);
            let stats = studio.draw_in_motion(&frame).1;
            assert_eq!(stats.shadows.passes, 0, "{geometry} {turn}");
        }
        frame.view.eye.point = frame.view.eye.point.moved(DVec3::new(8.0, 0.0, 0.0));
        assert!(
            studio.draw_in_motion(&frame).1.shadows.passes > 0,
            "{geometry}"
        );
    }
}

#[test]
fn a_pillar_behind_the_eye_shades_the_ground_before_it() {
    let mut frame = scene(Geometry::Hyperbolic);
    let toward = Vec3::new(-0.8, 0.35, 0.0).normalize();
    frame.content_mut().sky.key_direction = toward.into();
    frame.view.eye.point = ChartPoint::a(DVec3::new(18.0, FLOOR_M + 1.7, 15.5));
    frame.view.eye.yaw = 0.0;
    frame.view.eye.pitch = -0.7;
    let Some([on, off]) = both(&frame, SIZE) else {
        return;
    };
    let at = seen_at(&frame, ChartPoint::a(DVec3::new(20.0, FLOOR_M, 15.5)), SIZE);
    let (with, without) = (brightness(&on, at).unwrap(), brightness(&off, at).unwrap());
    assert!(without - with > 60, "{with} {without}");
}

#[test]
fn a_night_without_a_moon_has_no_shadows() {
    let mut frame = scene(Geometry::Euclidean);
    frame.content_mut().sky.key_colour = [0.0; 3];
    frame.content_mut().sky.key_shadow = 0.0;
    let Some([on, off]) = both(&frame, SIZE) else {
        return;
    };
    assert!(difference(&on, &off).0 <= 1, "{:?}", difference(&on, &off));
}

#[test]
fn a_figure_throws_a_shadow_in_every_space() {
    for geometry in GEOMETRIES {
        let mut frame = scene(geometry);
        frame.content_mut().sky.key_direction = Vec3::new(0.5, 0.7, 0.2).normalize().into();
        frame.content_mut().sky.sun_direction = frame.content.sky.key_direction;
        let feet = DVec3::new(13.5, FLOOR_M, 12.0);
        let figure = Figure::standing(ModelId::Astronaut, ChartPoint::a(feet), 0.0);
        frame.content_mut().figures = vec![figure];
        let Some([on, off]) = both(&frame, SIZE) else {
            return;
        };
        let is_in_body = |p: DVec3, radius_m: f64, top_m: f64| {
            let off = p - feet;
            off.x.hypot(off.z) < radius_m && (0.1..top_m).contains(&off.y)
        };
        let eye = frame.view.eye.point.pos;
        let hides = |point: DVec3| {
            let line = (1..400).map(|i| eye.lerp(point, f64::from(i) / 400.0));
            line.into_iter().any(|p| is_in_body(p, 0.6, 2.1))
        };
        // The off picture has the soft shade under the figure, too, and no shadow of the key.
        let (mut dark, mut seen) = (0, 0);
        for (i, j) in (-40..40).flat_map(|i| (-40..40).map(move |j| (i, j))) {
            let point = feet + DVec3::new(f64::from(i), 0.0, f64::from(j)) * 0.05;
            let is_due = is_shaded_by(&frame, point, |p| is_in_body(p, 0.1, 1.5));
            if !is_due || hides(point) {
                continue;
            }
            let at = seen_at(&frame, ChartPoint::a(point), SIZE);
            if let (Some(a), Some(b)) = (brightness(&on, at), brightness(&off, at)) {
                seen += 1;
                dark += i32::from(b - a > 25);
            }
        }
        assert!(seen > 12, "{geometry}: only {seen} places");
        assert!(
            dark * 10 > seen * 8,
            "{geometry}: {dark} of {seen} are dark"
        );
    }
}

#[test]
fn land_far_below_a_figure_is_dark_under_it_alone() {
    for (geometry, above_m) in [
        (Geometry::Euclidean, 24.0),
        (Geometry::Hyperbolic, 24.0),
        (Geometry::Euclidean, 60.0),
    ] {
        let mut frame = scene(geometry);
        frame.content_mut().sky.key_direction = Vec3::new(0.2, 1.0, 0.1).normalize().into();
        frame.content_mut().sky.sun_direction = frame.content.sky.key_direction;
        let below = DVec3::new(13.5, FLOOR_M, 12.0);
        let feet = below + DVec3::new(0.2, 1.0, 0.1) * above_m;
        frame.content_mut().figures = vec![Figure::standing(
            ModelId::Astronaut,
            ChartPoint::a(feet),
            0.0,
        )];
        let Some([on, off]) = both(&frame, SIZE) else {
            return;
        };
        let (mut dark, mut seen) = (0, 0);
        for (i, j) in (-30..30).flat_map(|i| (-30..30).map(move |j| (i, j))) {
            let point = below + DVec3::new(f64::from(i), 0.0, f64::from(j)) * 0.1;
            let at = seen_at(&frame, ChartPoint::a(point), SIZE);
            let levels = brightness(&on, at).zip(brightness(&off, at));
            if let Some((a, b)) = levels.filter(|_| !is_shaded(&frame, point, 0.5)) {
                seen += 1;
                dark += i32::from(b - a > 20);
            }
        }
        assert!(seen > 2000, "{geometry}: {seen}");
        assert!(
            dark < 150,
            "{geometry}, {above_m} m: {dark} of {seen} are dark"
        );
    }
}

#[test]
fn land_past_the_equator_which_no_picture_shows_throws_no_shadow() {
    let frame = scene(Geometry::Spherical);
    let space = &frame.view.strategy;
    // Over the floor as the other chart would have it, far past its own end.
    let over = ChartPoint::a(DVec3::new(14.0, FLOOR_M + 3.0, 14.0));
    let wanted = space.curved(&frame.view.eye, over);
    let level = over.pos.with_y(0.0);
    let way = level.normalize() * (PI * space.radius_m() - level.length());
    let seen = |at: DVec3| space.curved(&frame.view.eye, ChartPoint::new(ChartId::SECOND, at));
    let past = [1.0, -1.0]
        .iter()
        .flat_map(|x| [1.0, -1.0].map(|z| DVec3::new(x * way.x, over.pos.y, z * way.z)))
        .min_by(|a, b| {
            (seen(*a) - wanted)
                .length()
                .total_cmp(&(seen(*b) - wanted).length())
        })
        .unwrap();
    assert!((seen(past) - wanted).length() < 1e-6);
    let coord = ChunkCoord::containing(ChartPoint::new(ChartId::SECOND, past));
    let corner = coord.index.as_dvec3() * 32.0;
    let mut mesh = ChunkMesh::default();
    let at = Vec3::Y * (past.y - corner.y) as f32;
    rectangle(&mut mesh, at, Vec3::Z * 32.0, Vec3::X * 32.0);
    let phantom = ChunkChange::Put(coord, Arc::new(mesh));
    let with = |more: Option<ChunkChange>| {
        let mut frame = frame.clone();
        frame.change_land(more);
        studio(ShadowQuality::Low, SIZE).map(|mut it| it.picture(&frame))
    };
    let (Some(alone), Some(haunted)) = (with(None), with(Some(phantom))) else {
        return;
    };
    assert_eq!(difference(&alone, &haunted).0, 0);
}

/// Height of a step, metres: a few pixels.
const STEP_M: f32 = 0.2;

/// A floor that is higher by a step beyond x and z of 14 m. The steps' normals are the floor's, as where a seam between
/// levels of detail closes a gap, or a thin triangle strays from the land.
fn floor_with_a_step() -> Arc<ChunkMesh> {
    let mut mesh = ChunkMesh::default();
    let (x, z) = (Vec3::X, Vec3::Z);
    let low = Vec3::Y * FLOOR_M as f32;
    let high = low + Vec3::new(14.0, STEP_M, 14.0);
    rectangle(&mut mesh, low, z * 32.0, x * 14.0);
    rectangle(&mut mesh, low + x * 14.0, z * 14.0, x * 18.0);
    rectangle(&mut mesh, high, z * 18.0, x * 18.0);
    for (along, turned) in [(x, true), (z, false)] {
        let first = mesh.vertices.len() as u32;
        for i in 0..=18_u8 {
            for down in [STEP_M, 0.0] {
                let at = high + along * f32::from(i) - Vec3::Y * down;
                mesh.vertices
                    .push(Vertex::new(at, Vec3::Y, [200, 200, 200]));
            }
        }
        for a in (0..18).map(|i| first + 2 * i) {
            let square = [a, a + 1, a + 3, a, a + 3, a + 2];
            let square = if turned {
                square
            } else {
                [a, a + 3, a + 1, a, a + 2, a + 3]
            };
            mesh.indices.extend(square);
        }
    }
    Arc::new(mesh)
}

#[test]
fn what_turns_away_though_its_normals_do_not_is_as_light_as_the_land_beside_it() {
    for geometry in GEOMETRIES {
        let coord = ChunkCoord::new(ChartId::FIRST, IVec3::ZERO);
        let frame =
            scene(geometry).with_content(|it| it.land = one_chunk(coord, floor_with_a_step()));
        for quality in [ShadowQuality::Low, ShadowQuality::High] {
            let Some([on, off]) = compared(&frame, SIZE, quality) else {
                return;
            };
            let along = |i: u8| 14.5 + 0.25 * f64::from(i);
            let middle_m = FLOOR_M + 0.5 * f64::from(STEP_M);
            let places = (0..16).flat_map(|i| {
                [(14.0, along(i)), (along(i), 14.0)].map(|(x, z)| DVec3::new(x, middle_m, z))
            });
            let mut looked_at = 0;
            for place in places {
                let at = seen_at(&frame, ChartPoint::a(place), SIZE);
                if let (Some(on), Some(off)) = (brightness(&on, at), brightness(&off, at)) {
                    looked_at += 1;
                    assert!(
                        10 * on >= 9 * off,
                        "{geometry} {quality:?} {place}: {on}, not {off}"
                    );
                }
            }
            assert!(looked_at > 20, "{geometry}: {looked_at}");
        }
    }
}
