//! Marks on the ground and what flies over it: where they are, how dark or bright, and that nothing is drawn where there are none.

use std::sync::Arc;

use antipode_frame::{Frame, GroundMark, Look, MarkShape, Particle};
use antipode_geometry::{ChartId, ChartPoint, Strategy};
use antipode_terrain::Field;
use glam::{DVec3, Vec3};
use image::RgbaImage;

use crate::common::{GEOMETRIES, Studio, frame, land, seen_at, space, standing};

const SIZE: (u32, u32) = (320, 180);
const ASPECT: f64 = 16.0 / 9.0;
/// How far before the eye the ground is looked at, metres.
const AHEAD_M: f64 = 2.2;

/// Marks lie so high over the field's ground, of which the mesh is told to some centimetres, metres.
const LIFT_M: f64 = 0.08;

/// Land before an eye that looks down a little, and the ground at the middle of what is looked at, with its normal.
fn before_the_eye(space: &Arc<dyn Strategy>) -> (Frame, ChartPoint, DVec3) {
    let eye = standing(space, ChartId::FIRST, 3.0, 2.0);
    let mut frame = frame(space, eye, ASPECT);
    frame.view.eye.pitch = -0.65;
    frame.content_mut().land = land(space, eye, 1);
    let front = frame.view.eye.front();
    let flat = DVec3::new(front.x, 0.0, front.z).normalize();
    let field = Field::new(2, space.clone());
    let ground = |at: DVec3| at.with_y(field.surface_height(ChartId::FIRST, at.x, at.z));
    let at = ground(eye.pos + flat * AHEAD_M);
    let slope = |way: DVec3| ground(at + way * 0.3) - ground(at - way * 0.3);
    let up = slope(DVec3::Z).cross(slope(DVec3::X)).normalize();
    (frame, ChartPoint::new(ChartId::FIRST, at), up)
}

fn brightness(picture: &RgbaImage, (x, y): (f64, f64)) -> f64 {
    let mut sum = 0.0;
    for (dx, dy) in (-2..=2).flat_map(|dx| (-2..=2).map(move |dy| (dx, dy))) {
        let p = picture.get_pixel((x as i32 + dx) as u32, (y as i32 + dy) as u32);
        sum += p.0[..3].iter().map(|c| f64::from(*c)).sum::<f64>();
    }
    sum / 75.0
}

/// The least share of its brightness that is left near a place: slopes may hide a part of a mark.
fn least_share(marked: &RgbaImage, bare: &RgbaImage, (x, y): (f64, f64)) -> f64 {
    let near = (-4..=4).flat_map(|i| (-4..=4).map(move |j| (f64::from(i), f64::from(j))));
    let shares = near.map(|(i, j)| {
        let at = (x + 4.0 * i, y + 4.0 * j);
        brightness(marked, at) / brightness(bare, at)
    });
    shares.fold(f64::INFINITY, f64::min)
}

fn mark(at: ChartPoint, up: DVec3, shape: MarkShape, strength: f32) -> GroundMark {
    let (a, b) = up.any_orthonormal_pair();
    let corner = |x: f64, y: f64| at.pos + (a * x + b * y) * 0.35 + up * LIFT_M;
    GroundMark {
        chart: at.chart,
        corners: [
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(-1.0, 1.0),
            corner(1.0, 1.0),
        ],
        shape,
        strength: [strength; 2],
        along_m: [0.0, 0.7],
    }
}

#[test]
fn a_mark_darkens_the_ground_that_it_lies_on_and_no_other() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        let space = space(geometry);
        let (mut frame, at, up) = before_the_eye(&space);
        let bare = studio.draw(&frame).0;
        let place = seen_at(&frame, at, SIZE);
        let beside = (place.0 + 110.0, place.1);
        for (shape, most) in [(MarkShape::Contact, 0.85), (MarkShape::Print, 0.95)] {
            frame.content_mut().dust.marks = vec![mark(at, up, shape, 0.8)];
            let marked = studio.draw(&frame).0;
            let share = least_share(&marked, &bare, place);
            assert!(
                (0.3..most).contains(&share),
                "{geometry:?} {shape:?}: {share}"
            );
            let other = brightness(&marked, beside) / brightness(&bare, beside);
            assert!((other - 1.0).abs() < 0.01, "{geometry:?}: {other} beside");
        }
    }
}

#[test]
fn a_particle_is_seen_where_it_is_in_its_colour_and_nothing_where_there_is_none() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        let space = space(geometry);
        let (mut frame, at, up) = before_the_eye(&space);
        let (bare, before) = studio.draw(&frame);
        for look in [Look::Dust, Look::Spray, Look::Chip] {
            let point = at.moved(up * 0.4);
            frame.content_mut().dust.particles = vec![Particle {
                point,
                look,
                radius_m: 0.3,
                turn_rad: 0.6,
                shape: 0.4,
                colour: [0.9, 0.02, 0.02],
                opacity: 1.0,
                sky: 1.0,
                up: up.as_vec3(),
                height_m: 0.4,
            }];
            let (picture, stats) = studio.draw(&frame);
            let (x, y) = seen_at(&frame, point, SIZE);
            let [r, g, _, _] = picture.get_pixel(x as u32, y as u32).0;
            assert!(
                r > 90 && f64::from(r) > 1.6 * f64::from(g),
                "{geometry:?} {look:?}: {r} {g}"
            );
            assert_eq!(stats.draws, before.draws + 1);
        }
        // What is under ground is hidden.
        let particles = &mut frame.content_mut().dust.particles;
        particles[0].point = at.moved(up * -1.0);
        particles[0].look = Look::Chip;
        particles[0].up = Vec3::Y;
        assert_eq!(studio.draw(&frame).0, bare, "{geometry:?}");
    }
}
