//! What pictures show through portals, and what light comes through them.

use std::sync::Arc;

use antipode_deformation::{Place, Portal, Space};
use antipode_rays::{Eye, Lamp, RayScene};
use antipode_testing::rooms;
use glam::{DQuat, DVec2, DVec3, Vec3};

use crate::common::{Gpu, looking, mesh, middle, scene_of, shown, standing};
use crate::pictures::yard;

fn portal(at: DVec3, turn: DQuat, size: f64, to: usize) -> Portal {
    Portal {
        name: format!("to {to}"),
        at,
        turn,
        polygon: Portal::rectangle(DVec2::splat(size)),
        to,
        two_sided: false,
    }
}

#[test]
fn through_a_portal_one_sees_what_is_seen_from_where_g_takes_the_eye() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    for scale in [1.0, 0.5] {
        let mut scene = yard();
        let here = portal(
            DVec3::new(0.0, 50.0, 0.0),
            DQuat::from_rotation_y(0.4),
            8.0,
            1,
        );
        let turned = DQuat::from_rotation_y(2.4) * DQuat::from_rotation_z(-0.3);
        let there = portal(DVec3::new(6.0, 6.0, 3.0), turned, 8.0 * scale, 0);
        scene.aberrations = Space::with_portals(Vec::new(), vec![here, there]).unwrap();
        let portal = &scene.aberrations.portals()[0];
        let from = portal.portal.at + portal.normal;
        let eye = looking(&scene, from, portal.portal.at);
        let beyond = Eye {
            place: Place {
                scale: portal.scale,
                ..Place::at(&scene.aberrations, portal.map.transform_point3(from))
            },
            front: portal.turn * eye.front,
            right: portal.turn * eye.right,
            up: portal.turn * eye.up,
            ..eye
        };
        let (light, seen) = shown(gpu, &scene, &eye);
        let (expected, expected_seen) = shown(gpu, &scene, &beyond);
        let other = seen.iter().zip(&expected_seen);
        let other = other.filter(|(a, b)| {
            a.seen != b.seen || (a.length_m - b.length_m).abs() > 1e-3 * b.length_m
        });
        let other = other.count();
        let gaps = light.iter().zip(&expected);
        let gaps = gaps.filter(|(a, b)| (Vec3::from(**a) - Vec3::from(**b)).length() > 0.02);
        let gaps = gaps.count();
        assert!(other <= 4 && gaps <= 12, "{scale}: {other} {gaps}");
        let objects = expected_seen.iter().filter(|it| it.length_m < 40.0).count();
        assert!(objects > 500, "{objects}");
    }
}

/// A wall that looks towards a portal under a roof; the portal's partner lies on its back in the open.
fn shaded(lid: bool) -> RayScene {
    let block = |at: DVec3, half: DVec3, object| rooms::cuboid(at, DQuat::IDENTITY, half, object);
    let mut solids = block(DVec3::new(0.0, 2.0, 4.1), DVec3::new(3.0, 3.0, 0.1), 0);
    solids.extend(block(
        DVec3::new(0.0, 7.0, 0.0),
        DVec3::new(9.0, 0.1, 9.0),
        1,
    ));
    let mut scene = scene_of(&solids);
    if lid {
        let over = block(DVec3::new(50.0, 4.0, 0.0), DVec3::new(9.0, 0.1, 9.0), 2);
        scene.instances.push(standing(scene.meshes.len(), 2, 0));
        scene.meshes.push(Arc::new(mesh(&over)));
    }
    let here = portal(
        DVec3::new(0.0, 2.0, -3.0),
        DQuat::from_rotation_y(-90f64.to_radians()),
        3.0,
        1,
    );
    let there = portal(
        DVec3::new(50.0, 0.5, 0.0),
        DQuat::from_rotation_z(90f64.to_radians()),
        3.0,
        0,
    );
    scene.aberrations = Space::with_portals(Vec::new(), vec![here, there]).unwrap();
    scene
}

fn on_wall(gpu: &Gpu, scene: &RayScene, aside: f64) -> f32 {
    let from = DVec3::new(aside, 2.0, 0.0);
    middle(&shown(gpu, scene, &looking(scene, from, from + DVec3::Z)).0)[1]
}

#[test]
fn the_sun_s_beam_comes_out_of_a_portal_that_turns_it() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let lit = |lid: bool, aside: f64| {
        let mut scene = shaded(lid);
        scene.sun = yard().sun.map(|sun| antipode_rays::Sun {
            direction: DVec3::new(0.05, 1.0, -0.1).normalize(),
            ..sun
        });
        on_wall(gpu, &scene, aside)
    };
    let (beam, none, beside) = (lit(false, 0.0), lit(true, 0.0), lit(false, 2.7));
    assert!(beam > none + 0.4, "{beam} {none}");
    assert!((beside - none).abs() < 0.01, "{beside} {none}");
}

#[test]
fn a_lamp_lights_what_is_before_the_other_portal() {
    let Some(gpu) = Gpu::shared() else {
        return;
    };
    let lit = |lid: bool| {
        let mut scene = shaded(lid);
        scene.lamps = vec![Lamp {
            place: Place::at(&scene.aberrations, DVec3::new(50.0, 5.5, 0.0)),
            colour: Vec3::splat(8.0),
            reach_m: 60.0,
            radius_m: 0.1,
        }];
        on_wall(gpu, &scene, 0.0)
    };
    let (through, none) = (lit(false), lit(true));
    // 7 m to the one and 5 from the other, of a material of 0.6.
    let expected = 0.6 * 8.0 / (1.0 + 0.24 * 144.0);
    let got = through - none;
    assert!((got - expected).abs() < 0.1 * expected, "{got} {expected}");
}
