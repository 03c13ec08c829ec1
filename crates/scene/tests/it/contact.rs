//! What stands on the ground is drawn on it, and seen from behind down to its legs.

use crate::common::{LIMIT, setup, steps};
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_scene::frame::{Frame, ModelId};
use antipode_scene::{Actions, CameraMode, NpcMode, Scene, WorldSetup};
use antipode_terrain::Field;
use glam::DVec3;

/// What stands is drawn no farther than this off the ground, metres.
const NEAR_M: f64 = 0.03;

fn opened(geometry: Geometry, seed: u64) -> Scene {
    let setup = WorldSetup {
        seed,
        ..setup(geometry)
    };
    let mut scene = Scene::open(setup, None).unwrap();
    assert!(scene.settle(LIMIT));
    scene.set_npcs(NpcMode::Still);
    scene
}

/// Height of the drawn ground in a point's column that is nearest to it.
fn drawn_ground_m(frame: &Frame, at: ChartPoint) -> f64 {
    let mut heights = Vec::new();
    for (coord, mesh) in frame.content.land.meshes() {
        let here = at.pos - coord.origin();
        let inside = (-0.1..32.1).contains(&here.x) && (-0.1..32.1).contains(&here.z);
        if coord.chart != at.chart || !inside {
            continue;
        }
        let positions = mesh.positions();
        for corners in mesh.triangles() {
            let [a, b, c] = corners.map(|corner| {
                let [x, y, z] = positions[corner as usize];
                DVec3::new(x.into(), y.into(), z.into())
            });
            let normal = (b - a).cross(c - a);
            let y = a.y - ((here - a).with_y(0.0)).dot(normal) / normal.y;
            let on = here.with_y(y);
            let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).cross(on - p).dot(normal));
            if normal.y.abs() > 1e-9 && sides.iter().all(|side| *side >= -1e-9) {
                heights.push(y + coord.origin().y);
            }
        }
    }
    let away = |height: &f64| (height - at.pos.y).abs();
    heights.sort_by(|a, b| away(a).total_cmp(&away(b)));
    *heights.first().expect("there is ground in the column")
}

fn turn_camera(scene: &mut Scene) {
    let toggle = Actions {
        toggle_camera: true,
        ..Actions::default()
    };
    steps(scene, 1, &toggle);
}

#[test]
fn figures_are_drawn_with_their_soles_on_the_ground_and_parked_cars_with_their_wheels() {
    for geometry in Geometry::ALL {
        for seed in 0..6 {
            let mut scene = opened(geometry, seed);
            let feet = scene.feet();
            for x in [-6.0, -3.0, 3.0, 6.0] {
                scene.spawn_bot(feet.moved(DVec3::new(x, 3.0, x)), 0.0, false);
            }
            assert!(scene.spawn_car(feet.moved(DVec3::new(0.0, 2.0, 6.0)), 0.0));
            turn_camera(&mut scene);
            steps(&mut scene, 240, &Actions::default());
            let frame = scene.frame(1.3, 1.7, 1);
            let over_m = |at: ChartPoint| at.pos.y - drawn_ground_m(&frame, at);
            let figures = &frame.content.figures;
            let suits = [ModelId::Astronaut, ModelId::AstronautTeal];
            let stand: Vec<_> = figures
                .iter()
                .filter(|it| suits.contains(&it.model))
                .collect();
            assert!(stand.len() > 4, "{geometry} {seed}: {}", stand.len());
            for figure in stand {
                let gap_m = over_m(figure.point);
                assert!(gap_m.abs() < NEAR_M, "{geometry} {seed}: {gap_m} m");
            }
            for car in scene.cars() {
                let contacts = car.wheels.iter().filter(|wheel| wheel.contact).count();
                assert!(contacts > 2, "{geometry} {seed}: {contacts} wheels");
                for wheel in car.wheels.iter().filter(|wheel| wheel.contact) {
                    let gap_m = over_m(car.place(wheel.hub - DVec3::Y * 0.36));
                    assert!(gap_m.abs() < NEAR_M, "{geometry} {seed}: wheel {gap_m} m");
                }
            }
        }
    }
}

/// Whether ground hides the shins from the picture's eye.
fn hides_shins(scene: &Scene, field: &Field) -> bool {
    let (eye, shins) = (scene.eye().point.pos, scene.feet().pos + DVec3::Y * 0.35);
    (1..200).any(|part| {
        let at = eye.lerp(shins, f64::from(part) / 200.0);
        // What the mesh leaves out of the field.
        field.sample(ChartPoint::a(at)) < -0.15
    })
}

#[test]
fn from_behind_the_legs_are_seen_over_the_ground_and_over_the_hotbar() {
    let (mut hidden, mut looks, mut framed) = (0, 0, 0);
    for seed in 0..4 {
        let mut scene = opened(Geometry::Euclidean, seed);
        turn_camera(&mut scene);
        assert_eq!(scene.camera_mode(), CameraMode::Third);
        let made_by = setup(Geometry::Euclidean).generator;
        let field = Field::made_by(made_by, seed, scene.strategy().clone());
        for spot in 0..8 {
            let way = f64::from(spot) * 2.4;
            let away_m = 7.0 * f64::from(spot);
            let (x, z) = (away_m * way.cos(), away_m * way.sin());
            let y = field.surface_height(ChartId::FIRST, x, z) + 0.5;
            scene.teleport(ChartPoint::a(DVec3::new(x, y, z)));
            steps(&mut scene, 60, &Actions::default());
            for step in 0..72 {
                let (yaw, pitch) = (
                    f64::from(step / 3) * 0.262,
                    [-0.3, 0.0, 0.15][step as usize % 3],
                );
                scene.aim(yaw, pitch);
                hidden += u32::from(hides_shins(&scene, &field));
                looks += 1;
                let (eye, head) = (scene.eye(), scene.head());
                let away = eye.point.pos - head.point.pos;
                let back_m = -away.dot(head.front());
                // Where nothing is in its way, and it need not rise either.
                if (away.y - away.dot(head.front()) * head.front().y - 0.45).abs() < 0.02
                    && back_m > 5.0
                {
                    let seen = eye.to_view(scene.feet().pos - eye.point.pos);
                    let down = -seen.y / -seen.z / (0.5 * 75f64.to_radians()).tan();
                    assert!(down < 0.6, "{seed} {spot} {step}: {down}");
                    framed += 1;
                }
            }
        }
    }
    assert!(4 * framed > looks, "{framed} of {looks}");
    // Without the rise it is seven in a thousand.
    assert!(hidden * 1000 <= looks, "{hidden} of {looks}");
}
