//! Bushes and grass bend away from what goes through them, and nothing else does.

use std::sync::Arc;

use antipode_frame::{ChunkChange, Frame, Presser};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Geometry};
use antipode_plants::{Age, Growth, Species};
use antipode_terrain::{ChunkMesh, Thing, Tuft};
use glam::{DVec3, Vec3};
use image::RgbaImage;

use crate::common::{GEOMETRIES, Studio, frame, plates, space};

const SIZE: (u32, u32) = (480, 270);
/// Height of the floor in its chunk, metres.
const FLOOR_M: f32 = 6.0;
/// How far ahead of the eye things stand, metres.
const AHEAD_M: f64 = 4.0;

/// What a car presses that stands at a place and looks along +x.
fn car_at(point: ChartPoint) -> Presser {
    Presser {
        point,
        along: DVec3::X * 1.2,
        up: DVec3::Y,
        reach_m: 1.7,
        height_m: 2.6,
        strength: 1.0,
    }
}

/// A floor with a thing or a tuft of grass in the middle of its chunk, looked at from before it along +x; and where it stands.
fn planted(geometry: Geometry, coord: ChunkCoord, what: Option<Species>) -> (Frame, ChartPoint) {
    let root = Vec3::new(16.0, FLOOR_M, 16.0);
    let corner = |x: f32, z: f32| Vec3::new(x, FLOOR_M, z);
    let floor = [
        corner(0.5, 0.5),
        corner(0.5, 31.5),
        corner(31.5, 31.5),
        corner(31.5, 0.5),
    ];
    let mut mesh = ChunkMesh::clone(&plates(&[floor]));
    match what {
        Some(species) => mesh.things.push(Thing {
            root,
            slot: 0,
            species: species.byte(),
            age: Age::Grown.byte(),
            turn_rad: 0.3,
            scale: 1.0,
        }),
        None => mesh.tufts.push(Tuft {
            root,
            growth: Growth::Grass.byte(),
            turn: 0,
            size: 255,
            rank: 0,
            ground: [60, 160, 60, 6],
        }),
    }
    let at = ChartPoint::new(coord.chart, coord.origin() + root.as_dvec3());
    let away_m = if what.is_some() { AHEAD_M } else { 1.2 };
    let eye = at.moved(DVec3::new(-away_m, 1.0, 0.0));
    let mut frame = frame(&space(geometry), eye, 16.0 / 9.0);
    frame.view.eye.pitch = -(0.7 / away_m).atan();
    frame.change_land([ChunkChange::Put(coord, Arc::new(mesh))]);
    (frame, at)
}

fn first() -> ChunkCoord {
    ChunkCoord::new(ChartId::FIRST, glam::IVec3::ZERO)
}

fn with(frame: &Frame, pressers: Vec<Presser>) -> Frame {
    frame.clone().with_content(|it| it.pressers = pressers)
}

/// The green pixels of a picture on a red floor: how many, their middle to the right, and the highest row.
fn green(picture: &RgbaImage) -> (usize, f64, u32) {
    let is_green = |pixel: &image::Rgba<u8>| {
        let [r, g, b, _] = pixel.0.map(i32::from);
        g > r + 6 && g > b + 6
    };
    let all = picture.enumerate_pixels().filter(|(.., it)| is_green(it));
    let (count, sum, top) = all.fold((0, 0.0, u32::MAX), |(count, sum, top), (x, y, _)| {
        (count + 1, sum + f64::from(x), top.min(y))
    });
    (count, sum / count.max(1) as f64, top)
}

fn changed(a: &RgbaImage, b: &RgbaImage) -> usize {
    a.pixels().zip(b.pixels()).filter(|(a, b)| a != b).count()
}

#[test]
fn a_bush_gives_way_to_what_is_beside_it_and_lies_flat_under_it() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        let (frame, root) = planted(geometry, first(), Some(Species::Bush));
        let mut drawn = |pressers| studio.picture(&with(&frame, pressers));
        let upright = drawn(Vec::new());
        let far = drawn(vec![car_at(root.moved(DVec3::Z * 9.0))]);
        assert!(
            upright == far,
            "{geometry:?}: what is far off bends nothing"
        );
        let (pixels, middle, top) = green(&upright);
        assert!(pixels > 800, "{geometry:?}: {pixels}");
        // To the right of who looks along +x is +z.
        let beside = drawn(vec![car_at(root.moved(DVec3::Z * -1.1))]);
        let (_, pushed, _) = green(&beside);
        assert!(pushed > middle + 6.0, "{geometry:?}: {middle} to {pushed}");
        let (_, flat, low) = green(&drawn(vec![car_at(root)]));
        assert!(low > top + 25, "{geometry:?}: from row {top} to {low}");
        assert!(
            (flat - middle).abs() < 12.0,
            "{geometry:?}: {middle} to {flat}"
        );
        let over = drawn(vec![car_at(root.moved(DVec3::Y * 3.0))]);
        assert!(
            upright == over,
            "{geometry:?}: what is over it bends nothing"
        );
    }
}

/// Each hemisphere has its own map to the view, by which depth has to go, too.
#[test]
fn what_grows_about_the_eye_is_seen_in_both_hemispheres() {
    let Some(mut studio) = Studio::for_card(SIZE) else {
        return;
    };
    let pixels = [ChartId::FIRST, ChartId::SECOND].map(|chart| {
        let coord = ChunkCoord::new(chart, glam::IVec3::ZERO);
        let (frame, _) = planted(Geometry::Spherical, coord, Some(Species::Bush));
        green(&studio.picture(&frame)).0
    });
    assert!(
        pixels[0] > 800 && pixels[0].abs_diff(pixels[1]) < 80,
        "{pixels:?}"
    );
}

#[test]
fn grass_bends_and_trunks_and_boulders_do_not() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        for (what, bends) in [
            (None, true),
            (Some(Species::Stump), false),
            (Some(Species::Boulder), false),
        ] {
            let (frame, root) = planted(geometry, first(), what);
            let bare = studio.picture(&frame);
            let pressed = with(&frame, vec![car_at(root.moved(DVec3::Z * 0.3))]);
            let pressed = studio.picture(&pressed);
            let moved = changed(&bare, &pressed);
            assert_eq!(moved > 60, bends, "{geometry:?} {what:?}: {moved} pixels");
            assert!(bends || moved == 0, "{geometry:?} {what:?}: {moved} pixels");
        }
    }
}

/// A globe's two charts are turned against each other: who comes over the line still presses the same leaves.
#[test]
fn a_bush_by_the_equator_is_bent_by_what_stands_in_the_other_chart() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let sphere = space(Geometry::Spherical);
    let rim_m = sphere.domain(ChartId::FIRST).radius_m().unwrap();
    let at = DVec3::new(0.0, 1.0, rim_m - 14.0);
    let coord = ChunkCoord::containing(ChartPoint::a(at));
    let (frame, root) = planted(Geometry::Spherical, coord, Some(Species::Bush));
    let here = car_at(root.moved(DVec3::new(0.0, 0.0, -1.1)));
    let there = sphere.carry(here.point, ChartId::SECOND).unwrap();
    assert!(there.point.chart != here.point.chart);
    let mut drawn = |pressers| studio.picture(&with(&frame, pressers));
    let (upright, bent) = (drawn(Vec::new()), drawn(vec![here]));
    let carried = drawn(vec![here.carried(&there)]);
    assert!(changed(&upright, &bent) > 500);
    let apart = changed(&bent, &carried);
    assert!(apart < 20, "{apart} pixels");
}

/// Of more than a picture has room for, the nearest to the eye bend.
#[test]
fn of_many_the_nearest_bend() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let (frame, root) = planted(Geometry::Euclidean, first(), Some(Species::Bush));
    let mut drawn = |pressers| studio.picture(&with(&frame, pressers));
    let alone = drawn(vec![car_at(root)]);
    let far = (0..12).map(|n| car_at(root.moved(DVec3::X * (20.0 + f64::from(n)))));
    let all: Vec<_> = far.chain([car_at(root)]).collect();
    assert!(drawn(all) == alone);
    assert!(drawn(Vec::new()) != alone);
}
