//! Shaders that are compiled ahead: what a picture asks for, and that what is there already draws the same.

use antipode_deformation::Aberration;
use antipode_rays::{Options, Outlines, RayScene, View};
use antipode_testing::rooms;
use glam::{DQuat, DVec3};

use crate::common::{Gpu, draw, looking, scene_of};

/// A block behind a tunnel.
fn scene() -> RayScene {
    let at = DVec3::new(0.0, 0.0, -8.0);
    let mut scene = scene_of(&rooms::cuboid(at, DQuat::IDENTITY, DVec3::ONE, 0));
    let half = DVec3::new(1.0, 1.0, 2.0);
    let tunnel = Aberration::tunnel(DVec3::new(0.0, 0.0, -4.0), DQuat::IDENTITY, half, 2, 12.0);
    scene.aberrations = antipode_deformation::Space::new(vec![tunnel]).unwrap();
    scene
}

fn options(view: View, outlines: Outlines, raster: bool) -> Options {
    Options {
        view,
        outlines,
        raster,
        as_compiled: true,
        ..Options::default()
    }
}

#[test]
fn what_is_prepared_suffices_for_every_way_to_look() {
    let Some(gpu) = Gpu::shared() else { return };
    let gpu = gpu.anew();
    let scene = scene();
    let loaded = gpu.rays.upload(&gpu.device, &gpu.queue, &scene).unwrap();
    let eye = looking(&scene, DVec3::new(0.3, 0.2, 0.0), DVec3::NEG_Z);
    let all = gpu.rays.all_shaders(&loaded);
    let mut asked = 0;
    for view in [View::Exact, View::Thesis, View::Split, View::Plain] {
        for outlines in [Outlines::Hidden, Outlines::All] {
            for raster in [false, true] {
                let options = options(view, outlines, raster);
                let wanted = gpu.rays.shaders((&scene, &loaded), &eye, options);
                assert!(wanted.iter().all(|it| all.contains(it)), "{options:?}");
                asked += wanted
                    .iter()
                    .filter(|it| !gpu.rays.is_compiled(**it))
                    .count();
            }
        }
    }
    assert!(
        asked > 8,
        "nothing is compiled before it is asked for: {asked}"
    );
}

#[test]
fn a_picture_asks_for_one_shader_and_is_the_same_by_what_is_there() {
    let Some(gpu) = Gpu::shared() else { return };
    let gpu = gpu.anew();
    let scene = scene();
    let loaded = gpu.rays.upload(&gpu.device, &gpu.queue, &scene).unwrap();
    let eye = looking(&scene, DVec3::new(0.3, 0.2, 0.0), DVec3::NEG_Z);
    let by_rays = options(View::Exact, Outlines::Hidden, false);
    let by_raster = options(View::Exact, Outlines::Hidden, true);
    let of = |options| gpu.rays.shaders((&scene, &loaded), &eye, options);
    let (rays, raster) = (of(by_rays), of(by_raster));
    assert_ne!(rays, raster);
    assert_eq!((rays.len(), raster.len()), (1, 1));
    gpu.rays.compile(&gpu.device, rays[0]).unwrap();
    assert!(gpu.rays.is_compiled(rays[0]) && !gpu.rays.is_compiled(raster[0]));
    assert_eq!(of(by_raster), rays, "what is there does");
    let (seen, light) = (
        draw(&gpu, &scene, &eye, by_rays),
        draw(&gpu, &scene, &eye, by_raster),
    );
    assert_eq!(seen.0, light.0);
    assert!(
        !gpu.rays.is_compiled(raster[0]),
        "a picture has waited for it"
    );
    gpu.rays.prepare(&gpu.device, &loaded).unwrap();
    assert_eq!(of(by_raster), raster);
}
