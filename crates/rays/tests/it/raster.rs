//! A raster that begins pictures shows what rays show: through doors, of what moves, in mirrors and panes, sample by sample.

use std::f64::consts::FRAC_PI_2;
use std::ops::Range;
use std::sync::{Arc, PoisonError};

use antipode_deformation::{Aberration, Portal, Sides, Space};
use antipode_rays::{
    Eye, Lamp, Loaded, Material, Mover, Options, Picture, Pixel, RayScene, Seen, View,
};
use antipode_testing::rooms;
use glam::{Affine3A, DQuat, DVec2, DVec3, Mat3A, Quat, Vec3};

use crate::common::{Gpu, Light, looking, mesh, standing};
use crate::pictures::{boxed, yard};

const SIZE: (u32, u32) = (250, 140);
const WHOLE: Range<u32> = 0..SIZE.1;

fn drawn(
    gpu: &Gpu,
    (scene, loaded): (&RayScene, &mut Loaded),
    movers: &[Mover],
    eye: &Eye,
    options: Options,
    parts: &[Range<u32>],
) -> (Light, Vec<Pixel>) {
    let _held = gpu.drawing.lock().unwrap_or_else(PoisonError::into_inner);
    loaded.show(&gpu.queue, movers).unwrap();
    let picture = Picture::new(&gpu.device, SIZE);
    for rows in parts {
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let adapter = (&gpu.device, &gpu.queue);
        let what = (scene, &*loaded);
        let rows = rows.clone();
        gpu.rays
            .draw_rows(adapter, &mut encoder, what, (eye, &picture), options, rows);
        gpu.queue.submit([encoder.finish()]);
    }
    (
        picture.read_light(&gpu.device, &gpu.queue).unwrap(),
        picture.read_seen(&gpu.device, &gpu.queue).unwrap(),
    )
}

/// Draws by both and compares them: one pixel of a thousand may show another thing, and two of a hundred another light. Returns
/// what rays show.
fn compared(
    gpu: &Gpu,
    scene: &RayScene,
    movers: &[Mover],
    eye: &Eye,
    options: Options,
) -> Vec<Pixel> {
    let mut loaded = gpu.rays.upload(&gpu.device, &gpu.queue, scene).unwrap();
    let mut by = |raster| {
        let options = Options { raster, ..options };
        drawn(gpu, (scene, &mut loaded), movers, eye, options, &[WHOLE])
    };
    let (rays, raster) = (by(false), by(true));
    same(&rays, &raster);
    rays.1
}

fn same(rays: &(Light, Vec<Pixel>), raster: &(Light, Vec<Pixel>)) {
    let pairs = || rays.1.iter().zip(&raster.1);
    let others = pairs().filter(|(a, b)| a.seen != b.seen).count();
    assert!(others <= rays.1.len() / 1000, "{others} show another thing");
    let agree = pairs().filter(|(a, b)| a.seen == b.seen);
    let far = agree.filter(|(a, b)| (a.length_m - b.length_m).abs() > 1e-3 * a.length_m);
    assert_eq!(far.count(), 0, "pixels are elsewhere");
    let lights = rays.0.iter().zip(&raster.0);
    let unlike = lights.filter(|(a, b)| (0..3).any(|i| (a[i] - b[i]).abs() > 0.03));
    let unlike = unlike.count();
    assert!(unlike <= rays.0.len() / 50, "{unlike} have another light");
}

fn count(seen: &[Pixel], wanted: impl Fn(Seen) -> bool) -> usize {
    seen.iter().filter(|pixel| wanted(pixel.seen)).count()
}

fn with_raster(view: View) -> Options {
    Options {
        view,
        ..Options::default()
    }
}

/// A yard with a turned tunnel, a smaller one in it, and posts before, in and behind them.
fn tunnels() -> RayScene {
    let mut scene = yard();
    let turn = DQuat::from_rotation_y(0.3);
    let outer = Aberration::tunnel(1.6 * DVec3::Y, turn, DVec3::new(2.0, 1.55, 5.0), 2, 25.0);
    let centre = DVec3::new(-0.3, 1.2, 0.4);
    let inner = Aberration::tunnel(
        centre,
        DQuat::from_rotation_y(0.7),
        DVec3::new(0.6, 0.9, 1.1),
        2,
        0.9,
    );
    scene.aberrations = Space::new(vec![outer, inner]).unwrap();
    let places = [
        (1.3, 7.0),
        (0.9, 3.0),
        (-0.2, 0.3),
        (-1.0, -3.0),
        (-2.4, -8.0),
    ];
    for (number, (x, z)) in places.into_iter().enumerate() {
        let half = DVec3::new(0.12, 1.0, 0.12);
        let post = rooms::cuboid(DVec3::new(x, 1.0, z), DQuat::IDENTITY, half, 0);
        scene
            .instances
            .push(standing(scene.meshes.len(), 10 + number as u32, 0));
        scene.meshes.push(Arc::new(mesh(&post)));
    }
    scene.lamps.push(Lamp {
        place: antipode_deformation::Place::at(&scene.aberrations, DVec3::new(0.5, 2.6, 2.0)),
        colour: Vec3::splat(6.0),
        reach_m: 20.0,
        radius_m: 0.1,
    });
    scene
}

#[test]
fn a_raster_sees_through_tunnels_in_tunnels_as_rays_do() {
    let Some(gpu) = Gpu::shared() else { return };
    let scene = tunnels();
    let places = [
        DVec3::new(2.9, 1.5, 9.5),
        DVec3::new(1.2, 1.4, 4.0),
        DVec3::new(-0.35, 1.3, 0.5),
        DVec3::new(-7.0, 2.0, 4.0),
    ];
    let mut walls = 0;
    for from in places {
        let eye = looking(&scene, from, DVec3::new(-0.8, 1.2, -2.5));
        for view in [View::Exact, View::Plain] {
            let seen = compared(gpu, &scene, &[], &eye, with_raster(view));
            walls += count(&seen, |it| matches!(it, Seen::Wall(_)));
        }
    }
    assert!(walls > 20_000, "{walls}");
    // Within the outer one, before the inner one's door, one sees the post in there and the one behind both.
    let from = DVec3::new(1.63, 1.2, 2.69);
    let eye = looking(&scene, from, DVec3::new(-0.3, 1.2, 0.4));
    let seen = compared(gpu, &scene, &[], &eye, with_raster(View::Exact));
    assert!(count(&seen, |it| it == Seen::Object(12)) > 100);
}

#[test]
fn what_bends_is_seen_by_rays_within_the_same_picture() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = tunnels();
    let mut all: Vec<_> = scene
        .aberrations
        .placed()
        .iter()
        .map(|it| it.aberration.clone())
        .collect();
    all.push(Aberration {
        centre: DVec3::new(7.0, 2.0, -1.0),
        ..boxed(DVec3::new(2.0, 1.0, 3.0), Sides::Soft)
    });
    scene.aberrations = Space::new(all).unwrap();
    for from in [DVec3::new(4.0, 1.5, 10.0), DVec3::new(7.0, 1.5, 0.0)] {
        let eye = looking(&scene, from, DVec3::new(3.5, 1.0, -2.0));
        compared(gpu, &scene, &[], &eye, with_raster(View::Exact));
    }
}

#[test]
fn a_raster_shows_what_moves_where_it_is() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = yard();
    let block = rooms::cuboid(DVec3::ZERO, DQuat::IDENTITY, DVec3::new(0.5, 0.8, 0.3), 0);
    scene.movables = vec![Arc::new(mesh(&block))];
    let mover = |x: f32, object, unseen_by_eye| Mover {
        mesh: 0,
        pose: Affine3A {
            matrix3: Mat3A::from_quat(Quat::from_rotation_y(x))
                * Mat3A::from_diagonal(Vec3::new(1.0, 0.6, 2.0)),
            translation: Vec3::new(x, 1.1, -1.0).into(),
        },
        object,
        materials: 0,
        unseen_by_eye,
        held: false,
        cut: None,
    };
    let movers = [
        mover(-1.5, 20, false),
        mover(1.9, 21, false),
        mover(0.2, 22, true),
    ];
    let eye = looking(
        &scene,
        DVec3::new(0.5, 2.2, 5.0),
        DVec3::new(0.2, 1.0, -1.0),
    );
    for view in [View::Exact, View::Plain] {
        let seen = compared(gpu, &scene, &movers, &eye, with_raster(view));
        assert!(count(&seen, |it| it == Seen::Object(20)) > 300);
        assert!(count(&seen, |it| it == Seen::Object(21)) > 300);
        assert_eq!(
            count(&seen, |it| it == Seen::Object(22)),
            0,
            "the eye is in it"
        );
    }
}

/// A portal to another one, its front towards `yaw` from +x.
fn portal(at: DVec3, yaw: f64, size: DVec2, to: usize) -> Portal {
    Portal {
        name: format!("to {to}"),
        at,
        turn: DQuat::from_rotation_y(yaw),
        polygon: Portal::rectangle(size),
        to,
        two_sided: false,
    }
}

#[test]
fn a_raster_sees_through_portals_that_turn_scale_and_see_themselves() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = tunnels();
    let boxes = scene.aberrations.placed().iter();
    let boxes: Vec<_> = boxes.map(|it| it.aberration.clone()).collect();
    let size = DVec2::new(1.6, 2.0);
    let portals = vec![
        portal(DVec3::new(2.6, 1.2, 7.5), -FRAC_PI_2, size, 1),
        portal(DVec3::new(-6.0, 1.8, 1.0), 0.4, 1.5 * size, 0),
        portal(DVec3::new(4.6, 1.2, 7.5), -FRAC_PI_2, size, 3),
        portal(DVec3::new(4.6, 1.2, 13.5), FRAC_PI_2, size, 2),
    ];
    scene.aberrations = Space::with_portals(boxes, portals).unwrap();
    let block = rooms::cuboid(DVec3::ZERO, DQuat::IDENTITY, DVec3::new(0.2, 0.7, 0.2), 0);
    scene.movables = vec![Arc::new(mesh(&block))];
    let who = Mover {
        mesh: 0,
        pose: Affine3A::from_translation(Vec3::new(3.9, 0.9, 11.6)),
        object: 22,
        materials: 0,
        unseen_by_eye: true,
        held: false,
        cut: None,
    };
    let from = DVec3::new(3.9, 1.5, 11.5);
    let eye = looking(&scene, from, DVec3::new(3.5, 1.2, 7.0));
    let seen = compared(gpu, &scene, &[who], &eye, with_raster(View::Exact));
    assert!(
        count(&seen, |it| it == Seen::Object(22)) > 50,
        "who looks, from behind"
    );
    let eye = looking(&scene, from, DVec3::new(2.4, 1.2, 7.0));
    compared(gpu, &scene, &[who], &eye, with_raster(View::Exact));
}

#[test]
fn mirrors_and_panes_go_on_by_rays() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = tunnels();
    scene.materials.push(Material {
        mirror: 0.8,
        ..scene.materials[0]
    });
    scene.materials.push(Material {
        glass: Some(1.3),
        ..scene.materials[0]
    });
    for (number, x) in [(1, 3.2), (2, 1.2)] {
        let half = DVec3::new(0.7, 0.9, 0.05);
        let pane = rooms::cuboid(
            DVec3::new(x, 1.0, 6.4),
            DQuat::from_rotation_y(0.4),
            half,
            0,
        );
        scene
            .instances
            .push(standing(scene.meshes.len(), 30 + number, number as usize));
        scene.meshes.push(Arc::new(mesh(&pane)));
    }
    let eye = looking(
        &scene,
        DVec3::new(3.4, 1.6, 10.0),
        DVec3::new(1.6, 1.0, 5.0),
    );
    for bounces in [0, 3] {
        let options = Options {
            bounces,
            ..Options::default()
        };
        let seen = compared(gpu, &scene, &[], &eye, options);
        assert!(count(&seen, |it| it == Seen::Object(31)) > 300);
        assert!(count(&seen, |it| it == Seen::Object(32)) > 300);
    }
}

#[test]
fn several_samples_and_parts_of_a_picture_agree_too() {
    let Some(gpu) = Gpu::shared() else { return };
    let scene = tunnels();
    let eye = looking(
        &scene,
        DVec3::new(2.9, 1.5, 9.5),
        DVec3::new(-0.8, 1.2, -2.5),
    );
    let options = Options {
        samples: 4,
        ..Options::default()
    };
    compared(gpu, &scene, &[], &eye, options);
    let mut loaded = gpu.rays.upload(&gpu.device, &gpu.queue, &scene).unwrap();
    let options = Options {
        raster: true,
        ..Options::default()
    };
    let mut by =
        |parts: &[Range<u32>]| drawn(gpu, (&scene, &mut loaded), &[], &eye, options, parts);
    let whole = by(&[WHOLE]);
    let bit_by_bit = by(&[0..41, 41..100, 100..SIZE.1]);
    assert_eq!(whole.1, bit_by_bit.1);
}

#[test]
fn what_is_cut_is_full_by_rays_and_by_a_raster() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = yard();
    scene.cuts = true;
    let half = DVec3::new(0.5, 0.8, 0.6);
    let block =
        |half: DVec3, at: DVec3| Arc::new(mesh(&rooms::cuboid(at, DQuat::IDENTITY, half, 0)));
    // The second is what is left of the first.
    let rest = DVec3::new(0.5, 0.8, 0.3);
    scene.movables = vec![
        block(half, DVec3::ZERO),
        block(rest, DVec3::new(0.0, 0.0, -0.3)),
    ];
    let pose = Affine3A {
        matrix3: Mat3A::from_quat(Quat::from_rotation_y(0.5))
            * Mat3A::from_diagonal(Vec3::new(1.0, 0.6, 2.0)),
        translation: Vec3::new(0.3, 1.1, 1.6).into(),
    };
    let normal = -(pose.matrix3 * Vec3::Z).normalize();
    let plane = normal.extend(-normal.dot(pose.translation.into()));
    let mover = |mesh, cut| Mover {
        mesh,
        pose,
        object: 20,
        materials: 0,
        unseen_by_eye: false,
        held: false,
        cut,
    };
    // From before the cut, and from behind it.
    for from in [DVec3::new(1.5, 2.2, 6.0), DVec3::new(-1.5, 3.2, -2.0)] {
        let eye = looking(&scene, from, DVec3::new(0.3, 1.0, 1.6));
        let options = with_raster(View::Exact);
        let mut loaded = gpu.rays.upload(&gpu.device, &gpu.queue, &scene).unwrap();
        let mut by = |raster, mesh, cut| {
            let options = Options { raster, ..options };
            let what = (&scene, &mut loaded);
            drawn(gpu, what, &[mover(mesh, cut)], &eye, options, &[WHOLE])
        };
        let left = by(false, 1, None);
        assert!(count(&left.1, |it| it == Seen::Object(20)) > 500);
        same(&left, &by(false, 0, Some(plane)));
        same(&left, &by(true, 0, Some(plane)));
    }
}
