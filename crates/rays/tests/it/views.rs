//! Ways to look: exact, by the thesis's rule, half by each, and in coordinates of the scene.

use antipode_deformation::{Exit, Sides, Space};
use antipode_rays::{Options, Outlines, Seen, View};
use glam::DVec3;

use crate::common::{Gpu, Light, SIZE, draw, looking, shown};
use crate::pictures::{boxed, greatest_gap, yard};

fn column(light: &Light, x: u32) -> Vec<[f32; 3]> {
    (0..SIZE.1)
        .map(|y| light[(y * SIZE.0 + x) as usize])
        .collect()
}

#[test]
fn each_way_to_look_shows_its_own_rule() {
    let Some(gpu) = Gpu::shared() else { return };
    let stretch = DVec3::new(1.0, 2.0, 3.0);
    let with = |sides| {
        let mut scene = yard();
        scene.aberrations = Space::new(vec![boxed(stretch, sides)]).unwrap();
        scene
    };
    let scene = with(Sides::Soft);
    let eye = looking(
        &scene,
        DVec3::new(-2.0, 2.5, 6.0),
        DVec3::new(0.0, 0.5, -2.0),
    );
    let by = |view| {
        let options = Options {
            view,
            ..Options::default()
        };
        draw(gpu, &scene, &eye, options)
    };
    let (exact, thesis, plain) = (by(View::Exact), by(View::Thesis), by(View::Plain));
    assert!(greatest_gap(&exact.0, &thesis.0) > 0.05);
    let legacy = shown(gpu, &with(Sides::Legacy(Exit::Original)), &eye);
    assert_eq!(thesis.1, legacy.1, "all aberrations by the thesis's rule");
    let bare = shown(gpu, &yard(), &eye);
    let apart = plain.1.iter().zip(&bare.1);
    let apart = apart.filter(|(a, b)| a.seen != b.seen || (a.length_m - b.length_m).abs() > 1e-3);
    assert_eq!(apart.count(), 0, "as if there were none");
    let split = by(View::Split).0;
    let middle = SIZE.0 / 2;
    for x in 0..SIZE.0 {
        let wanted = match x.cmp(&middle) {
            std::cmp::Ordering::Less => &thesis.0,
            std::cmp::Ordering::Greater => &exact.0,
            std::cmp::Ordering::Equal => {
                assert!(
                    column(&split, x).iter().flatten().all(|it| *it > 1.0),
                    "the line"
                );
                continue;
            }
        };
        assert_eq!(column(&split, x), column(wanted, x), "{x}");
    }
}

#[test]
fn walls_of_a_tunnel_are_seen_in_coordinates_of_the_scene_and_not_by_the_thesis_s_rule() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = yard();
    scene.aberrations = Space::new(vec![boxed(DVec3::new(1.0, 1.0, 3.0), Sides::Walls)]).unwrap();
    let eye = looking(
        &scene,
        DVec3::new(-8.0, 3.5, 6.0),
        DVec3::new(0.0, 0.5, -1.0),
    );
    let walls = |view| {
        let options = Options {
            view,
            ..Options::default()
        };
        let seen = draw(gpu, &scene, &eye, options).1;
        seen.iter().filter(|it| it.seen == Seen::Wall(0)).count()
    };
    assert!(walls(View::Exact) > 50);
    assert_eq!(
        walls(View::Plain),
        walls(View::Exact),
        "from outside they look alike"
    );
    assert_eq!(walls(View::Thesis), 0);
}

#[test]
fn outlines_have_a_switch_for_all() {
    let Some(gpu) = Gpu::shared() else { return };
    let mut scene = yard();
    scene.aberrations = Space::new(vec![boxed(DVec3::ONE, Sides::Soft)]).unwrap();
    let eye = looking(
        &scene,
        DVec3::new(-6.0, 4.0, 8.0),
        DVec3::new(0.0, 0.5, -1.0),
    );
    let without = shown(gpu, &scene, &eye).0;
    scene.outlined = vec![true];
    let with = |outlines| {
        let options = Options {
            outlines,
            ..Options::default()
        };
        draw(gpu, &scene, &eye, options).0
    };
    let chosen = with(Outlines::Chosen);
    assert!(greatest_gap(&chosen, &without) > 0.1);
    assert!(greatest_gap(&with(Outlines::Hidden), &without) < 1e-3);
    scene.outlined = vec![false];
    let with = |outlines| {
        let options = Options {
            outlines,
            ..Options::default()
        };
        draw(gpu, &scene, &eye, options).0
    };
    assert!(greatest_gap(&with(Outlines::Chosen), &without) < 1e-3);
    assert!(greatest_gap(&with(Outlines::All), &chosen) < 1e-3);
}
