//! What figures look like: bent by their joints, with things in their hands, lying, shining; and the player's own hand.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::common::{GEOMETRIES, Studio, frame, plates, seen_at, space, standing};
use antipode_frame::{
    ChunkChange, Clip, Figure, Frame, Hand, LampLight, ModelId, Posture, Quality,
};
use antipode_geometry::{ChartId, ChartPoint, ChunkCoord, Eye, Geometry};
use antipode_items::Item;
use glam::{DVec3, Vec3};
use image::RgbaImage;

const SIZE: (u32, u32) = (320, 180);
const ASPECT: f64 = 16.0 / 9.0;

/// A figure three metres before an eye at half its height, and nothing else.
fn alone(figure: &Figure) -> Frame {
    let space = space(Geometry::Euclidean);
    let eye = ChartPoint::a(DVec3::new(0.0, 1.0, 0.0));
    let point = ChartPoint::a(DVec3::new(3.0, 0.0, 0.0));
    frame(&space, eye, ASPECT).with_content(|it| it.figures = vec![Figure { point, ..*figure }])
}

fn astronaut(posture: Posture, yaw: f64) -> Figure {
    Figure {
        posture,
        ..Figure::standing(ModelId::Astronaut, ChartPoint::a(DVec3::ZERO), yaw)
    }
}

fn count(picture: &RgbaImage, like: impl Fn([u8; 3]) -> bool) -> usize {
    let like = |p: &&image::Rgba<u8>| like([p.0[0], p.0[1], p.0[2]]);
    picture.pixels().filter(like).count()
}

/// Where two pictures differ to the eye.
pub fn changed(a: &RgbaImage, b: &RgbaImage) -> Vec<(u32, u32)> {
    let apart = |x: u32, y: u32| {
        let (p, q) = (a.get_pixel(x, y).0, b.get_pixel(x, y).0);
        p.iter().zip(q).any(|(p, q)| p.abs_diff(q) > 12)
    };
    let places = (0..a.height()).flat_map(|y| (0..a.width()).map(move |x| (x, y)));
    places.filter(|(x, y)| apart(*x, *y)).collect()
}

#[test]
fn an_astronaut_is_white_and_orange_with_a_dark_visor_in_front() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let facing = studio.picture(&alone(&astronaut(Posture::default(), PI)));
    let white = count(&facing, |[r, g, b]| {
        r > 190 && r.abs_diff(g) < 24 && g.abs_diff(b) < 34
    });
    let orange = count(&facing, |[r, g, b]| {
        r > 150 && r.saturating_sub(g) > 50 && g.saturating_sub(b) > 20
    });
    assert!(white > 400 && orange > 60, "{white} {orange}");
    let away = alone(&astronaut(Posture::default(), 0.0));
    let head = seen_at(&away, ChartPoint::a(DVec3::new(3.0, 1.575, 0.0)), SIZE);
    let dark = |picture: &RgbaImage| {
        let crop = image::imageops::crop_imm(picture, head.0 as u32 - 8, head.1 as u32 - 8, 16, 16);
        count(&crop.to_image(), |[r, g, b]| {
            u16::from(r) + u16::from(g) + u16::from(b) < 420
        })
    };
    let back = dark(&studio.picture(&away));
    let front = dark(&facing);
    assert!(
        front > 100 && front > 2 * back,
        "visor in front: {front} {back}"
    );
}

#[test]
fn limbs_move_with_the_gait_and_the_second_outfit_is_another() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let walks = |cycle: f32| alone(&astronaut(Posture::of(Clip::Walk, cycle), FRAC_PI_2));
    let mut at = |cycle: f32| studio.picture(&walks(cycle));
    let (strides, passes) = (at(0.0), at(0.25));
    assert!(changed(&strides, &passes).len() > 300, "limbs swing");
    assert!(changed(&strides, &at(1.0)).len() < 20, "and come back");
    let mut teal = walks(0.0);
    teal.content_mut().figures[0].model = ModelId::AstronautTeal;
    assert!(changed(&strides, &studio.picture(&teal)).len() > 300);
}

#[test]
fn who_fights_is_red_and_nobody_else() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut frame = alone(&astronaut(Posture::default(), FRAC_PI_2));
    frame.content_mut().figures[0].model = ModelId::AstronautTeal;
    let red = |picture: &RgbaImage| count(picture, |[r, g, b]| r > 90 && r / 2 > g.max(b));
    let peaceful = red(&studio.picture(&frame));
    frame.content_mut().figures[0].hostile = true;
    let hostile = red(&studio.picture(&frame));
    assert!(hostile > 500 && peaceful < 20, "{hostile} {peaceful}");
}

/// Mean colour of a figure three metres ahead of an eye that looks along z, on a sphere by night.
fn colour_ahead(studio: &mut Studio, eye_z: f64, figure: ChartPoint, yaw: f64) -> [f64; 3] {
    let space = space(Geometry::Spherical);
    let eye = ChartPoint::a(DVec3::new(0.0, 1.0, eye_z));
    let mut frame = frame(&space, eye, ASPECT);
    frame.view.eye.yaw = FRAC_PI_2;
    // The sun stands over the middle of B, the moon over that of A.
    frame.content_mut().sky = antipode_scene::day::sky(450.0, &*space, &frame.view.eye);
    let without = studio.picture(&frame);
    frame.content_mut().figures = vec![Figure {
        hostile: true,
        ..Figure::standing(ModelId::AstronautTeal, figure, yaw)
    }];
    let picture = studio.picture(&frame);
    let places = changed(&without, &picture);
    assert!(places.len() > 500, "{} of it", places.len());
    let sum = |c: usize| {
        let channel = |(x, y): &(u32, u32)| f64::from(picture.get_pixel(*x, *y).0[c]);
        places.iter().map(channel).sum::<f64>()
    };
    [0, 1, 2].map(|c| sum(c) / places.len() as f64)
}

/// Compared with directions of this chart, the normals of the other one would show everyone there as a pale cut-out.
#[test]
fn beyond_the_equator_a_figure_is_lit_as_on_this_side() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let rim_m = space(Geometry::Spherical)
        .domain(ChartId::FIRST)
        .radius_m()
        .unwrap();
    let at = |chart, z: f64| ChartPoint::new(chart, DVec3::new(0.0, 0.0, z));
    let (near, far) = (rim_m - 4.5, rim_m - 1.5);
    let here = colour_ahead(&mut studio, near, at(ChartId::FIRST, far), 0.3);
    // Here the other chart is turned by half a turn.
    let there = colour_ahead(&mut studio, far, at(ChartId::SECOND, far), 0.3 + PI);
    for (here, there) in here.into_iter().zip(there) {
        assert!((here - there).abs() < 6.0, "{here} {there}");
    }
}

#[test]
fn the_dead_lie_on_the_ground() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut dead = alone(&astronaut(Posture::of(Clip::Die, 9.0), FRAC_PI_2));
    let lying = studio.picture(&dead);
    dead.content_mut().figures.clear();
    let shown = changed(&lying, &studio.picture(&dead));
    let knee = seen_at(&dead, ChartPoint::a(DVec3::new(3.0, 0.8, 0.0)), SIZE);
    assert!(shown.iter().all(|(_, y)| f64::from(*y) > knee.1));
    let (left, right) = (
        shown.iter().map(|(x, _)| *x).min().unwrap(),
        shown.iter().map(|(x, _)| *x).max().unwrap(),
    );
    let (top, low) = (
        shown.iter().map(|(_, y)| *y).min().unwrap(),
        shown.iter().map(|(_, y)| *y).max().unwrap(),
    );
    assert!(right - left > 2 * (low - top), "longer than high");
}

#[test]
fn what_is_held_is_seen_in_the_right_hand() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let holds = Posture::default().with(Clip::Hold, 1.0, 0.0);
    // It faces to our right, with its right-hand side towards us.
    let mut frame = alone(&astronaut(holds, FRAC_PI_2));
    let empty = studio.picture(&frame);
    for model in [
        ModelId::Item(Item::Gun),
        ModelId::Item(Item::PickaxeIron),
        ModelId::Item(Item::Lamp),
    ] {
        frame.content_mut().figures[0].held = Some(model);
        let held = changed(&empty, &studio.picture(&frame));
        assert!(held.len() > 40, "{model:?}: {}", held.len());
        let ahead = held.iter().filter(|(x, _)| *x > SIZE.0 / 2).count();
        assert!(
            ahead * 10 > held.len() * 9,
            "{model:?}: {ahead} of {}",
            held.len()
        );
    }
    by_night(&mut frame);
    frame.content_mut().figures[0].held = Some(ModelId::Item(Item::Gun));
    let gun = studio.picture(&frame);
    frame.content_mut().figures[0].flashes = true;
    assert!(changed(&gun, &studio.picture(&frame)).len() > 10);
}

/// More than share one batch of joints, each in a posture of its own, in whatever order.
#[test]
fn everyone_of_a_crowd_has_a_posture_of_its_own() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut crowd = alone(&astronaut(Posture::default(), 0.0));
    crowd.content_mut().figures = (0..40)
        .map(|i| {
            let (row, column) = (f64::from(i / 8), f64::from(i % 8));
            let place = DVec3::new(6.0 + 3.0 * row, 0.0, 2.0 * column - 7.0);
            let posture = match i % 3 {
                0 => Posture::of(Clip::Die, 9.0),
                1 => Posture::of(Clip::Run, i as f32 / 40.0),
                _ => Posture::of(Clip::Fall, i as f32 / 40.0),
            };
            Figure {
                point: ChartPoint::a(place),
                ..astronaut(posture, FRAC_PI_2)
            }
        })
        .collect();
    for quality in [Quality::Balanced, Quality::Exact] {
        crowd.view.quality = quality;
        let there = studio.picture(&crowd);
        crowd.content_mut().figures.reverse();
        assert!(
            changed(&there, &studio.picture(&crowd)).len() < 8,
            "{quality}"
        );
        let falling = crowd
            .content
            .figures
            .iter()
            .position(|f| f.posture.share(Clip::Fall) > 0.0);
        let mut fewer = crowd.clone();
        fewer.content_mut().figures.remove(falling.unwrap());
        assert!(
            changed(&there, &studio.picture(&fewer)).len() > 20,
            "{quality}"
        );
    }
}

#[test]
fn every_model_is_seen_in_every_space() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for geometry in GEOMETRIES {
        let space = space(geometry);
        let stand = standing(&space, ChartId::FIRST, 4.0, 4.0);
        let mut frame = frame(&space, stand, ASPECT);
        for quality in [Quality::Balanced, Quality::Exact] {
            frame.view.quality = quality;
            frame.content_mut().figures.clear();
            let empty = studio.picture(&frame);
            for model in ModelId::ALL {
                // What is smaller than a hand is looked at from close by.
                let near = if model == ModelId::Item(Item::Seed) {
                    0.4
                } else {
                    1.0
                };
                let point = stand.moved(near * DVec3::new(2.5, -0.6, 0.3));
                frame.content_mut().figures = vec![Figure::standing(model, point, 2.0)];
                let seen = changed(&empty, &studio.picture(&frame)).len();
                assert!(seen > 8, "{geometry} {quality} {model:?}: {seen}");
            }
        }
    }
}

fn by_night(frame: &mut Frame) {
    let sky = &mut frame.content_mut().sky;
    for colour in [
        &mut sky.top,
        &mut sky.horizon,
        &mut sky.glare,
        &mut sky.key_colour,
        &mut sky.ambient_sky,
        &mut sky.ambient_ground,
    ] {
        *colour = [0.01; 3];
    }
}

#[test]
fn a_lamp_shines_by_night() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut frame = alone(&Figure::standing(
        ModelId::Item(Item::Lamp),
        ChartPoint::a(DVec3::ZERO),
        0.0,
    ));
    frame.content_mut().figures[0].point.pos = DVec3::new(2.0, 0.7, 0.0);
    by_night(&mut frame);
    let picture = studio.picture(&frame);
    let bright = count(&picture, |[r, g, b]| r > 200 && g > 150 && r >= b);
    assert!(bright > 100, "{bright}");
}

fn hand(model: ModelId) -> Hand {
    Hand {
        model,
        lowered: 0.0,
        bob_m: [0.0; 2],
        swing: -1.0,
        kick: 0.0,
        flashes: false,
    }
}

#[test]
fn the_players_hand_is_at_the_lower_right_and_no_wall_hides_it() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    for model in [
        ModelId::Item(Item::Gun),
        ModelId::Item(Item::PickaxeIron),
        ModelId::Item(Item::Lamp),
        ModelId::Item(Item::Bullet),
    ] {
        let mut frame = alone(&astronaut(Posture::default(), 0.0));
        frame.content_mut().figures.clear();
        let bare = studio.picture(&frame);
        frame.view.hand = Some(hand(model));
        let held = changed(&bare, &studio.picture(&frame));
        assert!(
            (150..12_000).contains(&held.len()),
            "{model:?}: {}",
            held.len()
        );
        let (width, height) = (SIZE.0 / 2, SIZE.1 / 2);
        let there = |(x, y): &&(u32, u32)| *x >= width && *y + 25 >= height;
        let lower_right = held.iter().filter(there).count();
        assert!(
            lower_right * 10 > held.len() * 9,
            "{model:?}: {lower_right}"
        );
        // A wall at the length of a forearm: nearer than what is held.
        let corner = ChunkCoord::containing(frame.view.eye.point);
        let wall = [[0.0, 8.0], [8.0, 8.0], [8.0, -8.0], [0.0, -8.0]];
        let wall = plates(&[wall.map(|[y, z]| Vec3::new(0.2, y, z))]);
        frame.change_land([ChunkChange::Put(corner, wall)]);
        frame.view.hand = None;
        let walled = studio.picture(&frame);
        frame.view.hand = Some(hand(model));
        let before_wall = changed(&walled, &studio.picture(&frame)).len();
        assert!(
            2 * before_wall > held.len(),
            "{model:?}: {before_wall} of {}",
            held.len()
        );
    }
}

#[test]
fn the_players_hand_is_the_same_in_every_space_and_moves_with_use() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut shown = Vec::new();
    for geometry in GEOMETRIES {
        let space = space(geometry);
        let stand = standing(&space, ChartId::FIRST, 4.0, 4.0);
        let mut frame = frame(&space, stand, ASPECT);
        frame.view.eye = Eye {
            yaw: 0.4,
            pitch: -0.2,
            ..frame.view.eye
        };
        let bare = studio.picture(&frame);
        frame.view.hand = Some(hand(ModelId::Item(Item::PickaxeWood)));
        let rest = studio.picture(&frame);
        frame.view.hand = Some(Hand {
            swing: 1.0,
            ..hand(ModelId::Item(Item::PickaxeWood))
        });
        assert!(
            changed(&rest, &studio.picture(&frame)).len() > 200,
            "{geometry}"
        );
        frame.view.hand = Some(Hand {
            flashes: true,
            kick: 1.0,
            ..hand(ModelId::Item(Item::Gun))
        });
        let shot = studio.picture(&frame);
        frame.view.hand = Some(hand(ModelId::Item(Item::Gun)));
        assert!(
            changed(&shot, &studio.picture(&frame)).len() > 60,
            "{geometry}"
        );
        shown.push(changed(&bare, &rest));
    }
    // The light of each space is its own; the shape is not.
    for other in &shown[1..] {
        let alone = shown[0]
            .iter()
            .filter(|place| !other.contains(place))
            .count();
        assert!(alone * 20 < shown[0].len(), "{alone} of {}", shown[0].len());
    }
}

#[test]
fn lamps_light_what_the_player_holds() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let mut frame = alone(&astronaut(Posture::default(), 0.0));
    frame.content_mut().figures.clear();
    frame.view.hand = Some(hand(ModelId::Item(Item::Gun)));
    let day = studio.picture(&frame);
    let beside = frame.view.eye.point.moved(DVec3::new(0.5, 0.6, 1.0));
    frame.content_mut().lights.lamps = vec![LampLight {
        point: beside,
        colour: [3.0, 2.0, 1.0],
        range_m: 8.0,
    }];
    assert!(changed(&day, &studio.picture(&frame)).len() > 100);
}
