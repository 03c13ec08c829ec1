//! Several views of one content: each has its own picture, and none changes another's.

use std::sync::Arc;

use crate::common::{GEOMETRIES, Studio, difference, frame, land, space, standing};

use antipode_frame::{Figure, Frame, ModelId, View};
use antipode_geometry::{ChartId, Geometry, Projection};
use antipode_render::ShadowQuality;
use glam::{DMat4, DVec3, DVec4};
use image::{Rgba, RgbaImage, imageops};

const SIZE: (u32, u32) = (160, 90);
const SMALL: (u32, u32) = (96, 54);
const ASPECT: f64 = 16.0 / 9.0;

/// Land, and a figure two metres before an eye and another behind it.
fn before_and_behind(geometry: Geometry) -> Frame {
    let space = space(geometry);
    let point = standing(&space, ChartId::FIRST, 5.0, 3.0);
    let figure = |ahead_m: f64, model| {
        let feet = point.moved(DVec3::new(ahead_m, -1.6, 0.0));
        Figure::standing(model, feet, 0.4)
    };
    frame(&space, point, ASPECT).with_content(|it| {
        it.land = land(&space, point, 1);
        it.figures = vec![
            figure(2.0, ModelId::Astronaut),
            figure(-2.5, ModelId::CarBody),
        ];
    })
}

/// The view to the other side, of another field.
fn back(frame: &Frame) -> View {
    let mut view = frame.view.clone();
    view.eye.yaw += std::f64::consts::PI;
    view.eye.pitch = -0.2;
    view.projection = Projection::new(1.0, ASPECT, 0.02);
    view
}

#[test]
fn another_view_in_the_same_submission_changes_no_bit_of_the_first_and_is_not_changed_by_it() {
    for geometry in GEOMETRIES {
        for quality in [ShadowQuality::Off, ShadowQuality::Low] {
            let Some(mut studio) = Studio::shadowed(SIZE, quality) else {
                return;
            };
            let frame = before_and_behind(geometry);
            let alone = studio.picture(&frame);
            let further = [(back(&frame), SMALL), (frame.view.clone(), SIZE)];
            let (first, others) = studio.views(&frame, &further);
            assert!(first == alone, "{geometry} {quality:?}");
            // The same once more from the same eye: what it throws no shadows of its own for, the first does.
            let (_, mean) = difference(&others[1], &alone);
            assert!(mean < 0.01, "{geometry} {quality:?}: {mean}");

            let own = Studio::shadowed(SMALL, quality)
                .map(|mut studio| studio.picture(&frame.seen_by(back(&frame))))
                .unwrap();
            let (_, mean) = difference(&others[0], &own);
            assert!(mean < 0.6, "{geometry} {quality:?}: {mean}");
        }
    }
}

#[test]
fn views_come_and_go_and_change_their_size_from_frame_to_frame() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let frame = before_and_behind(Geometry::Hyperbolic);
    let alone = studio.picture(&frame);
    let view = back(&frame);
    let small = studio.views(&frame, &[(view.clone(), SMALL)]).1;
    for further in [
        vec![],
        vec![(view.clone(), (48, 27)), (view.clone(), SMALL)],
        vec![(view.clone(), SMALL)],
    ] {
        let (first, others) = studio.views(&frame, &further);
        assert!(first == alone);
        for ((_, size), other) in further.iter().zip(&others) {
            assert_eq!(other.dimensions(), *size);
            assert!(*size != SMALL || *other == small[0]);
        }
    }
}

#[test]
fn two_renderers_draw_one_content_alike() {
    let frame = before_and_behind(Geometry::Spherical);
    let draw = || Some(Studio::shadowed(SIZE, ShadowQuality::Low)?.picture(&frame));
    let (Some(one), Some(other)) = (draw(), draw()) else {
        return;
    };
    assert!(one == other);
}

/// The half of a picture that begins at a column.
fn half(picture: &RgbaImage, from: u32) -> RgbaImage {
    imageops::crop_imm(picture, from, 0, SIZE.0 / 2, SIZE.1).to_image()
}

#[test]
fn a_half_turn_about_the_line_of_sight_turns_the_picture_and_another_turns_it_back() {
    let turn = DMat4::from_diagonal(DVec4::new(-1.0, -1.0, 1.0, 1.0));
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::shadowed(SIZE, ShadowQuality::Low) else {
            return;
        };
        let frame = before_and_behind(geometry);
        let upright = studio.picture(&frame);
        let turned = frame.clone().with_view(|it| it.isometry = turn);
        let turned = imageops::rotate180(&studio.picture(&turned));
        let (_, mean) = difference(&turned, &upright);
        assert!(mean < 0.7, "{geometry}: {mean}");
        let back = frame.with_view(|it| it.isometry = turn * turn);
        assert!(studio.picture(&back) == upright, "{geometry}");
    }
}

#[test]
fn a_sheet_through_the_eye_cuts_off_just_the_half_of_the_picture_on_its_far_side() {
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let frame = before_and_behind(geometry);
        let whole = studio.picture(&frame);
        let cut = frame.with_view(|it| it.cuts[1] = DVec4::X);
        let picture = studio.picture(&cut);
        let middle = SIZE.0 / 2;
        assert!(half(&picture, middle) == half(&whole, middle), "{geometry}");
        let empty = cut.with_content(|it| {
            it.land = Arc::default();
            it.figures.clear();
            it.loaded_world += 1000;
        });
        let empty = studio.picture(&empty);
        assert!(half(&picture, 0) == half(&empty, 0), "{geometry}");
        assert!(half(&whole, 0) != half(&empty, 0), "{geometry}");
    }
}

#[test]
fn a_sheet_before_the_eye_cuts_off_what_stands_nearer() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let frame = before_and_behind(Geometry::Euclidean).with_content(|it| it.land = Arc::default());
    let without = frame.clone().with_content(|it| it.figures.clear());
    let without = studio.picture(&without);
    let mut changed = |beyond_m: f64| {
        let cut = DVec4::new(0.0, 0.0, -1.0, -beyond_m);
        let cut = frame.clone().with_view(|it| it.cuts[3] = cut);
        difference(&studio.picture(&cut), &without).1
    };
    assert!(changed(0.5) > 1.0);
    assert!(changed(4.0) == 0.0);
}

#[test]
fn a_mirror_shows_what_is_behind_with_its_sides_swapped_and_leaves_the_rest_of_the_picture() {
    let (corner, size) = ((40, 4), (80, 20));
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let mut frame = before_and_behind(geometry);
        let eye = frame.view.eye.point;
        // On the right of a viewer who looks ahead.
        let feet = eye.moved(DVec3::new(-4.0, -1.6, 1.0));
        let behind = Figure::standing(ModelId::AstronautTeal, feet, 0.0);
        frame.content_mut().figures = vec![behind];
        let mut view = back(&frame);
        view.eye.pitch = 0.0;
        view.projection = Projection::new(0.5, 4.0, 0.02);
        let alone = studio.picture(&frame);
        let rear = studio.views(&frame, &[(view.clone(), size)]).1;
        let mirrored = studio.with_mirror(&frame, &view, corner, size);
        let part = |picture: &RgbaImage| {
            imageops::crop_imm(picture, corner.0, corner.1, size.0, size.1).to_image()
        };
        let swapped = imageops::flip_horizontal(&rear[0]);
        let (most, mean) = difference(&part(&mirrored), &swapped);
        assert!(most <= 1 && mean < 0.5, "{geometry}: {most} {mean}");
        let mut rest = mirrored.clone();
        imageops::replace(&mut rest, &part(&alone), corner.0.into(), corner.1.into());
        assert!(rest == alone, "{geometry}");

        let without = frame.clone().with_content(|it| it.figures.clear());
        let without = studio.with_mirror(&without, &view, corner, size);
        let changed = |left: bool| {
            let pixels = part(&mirrored);
            let bare = part(&without);
            let pairs = pixels.enumerate_pixels().zip(bare.pixels());
            let is_there = |((x, _, p), q): &((u32, u32, &Rgba<u8>), &Rgba<u8>)| {
                let apart = (0..3).any(|c| p.0[c].abs_diff(q.0[c]) > 12);
                apart && (*x < size.0 / 2) == left
            };
            pairs.filter(is_there).count()
        };
        assert!(changed(false) > 20, "{geometry}: {}", changed(false));
        assert_eq!(changed(true), 0, "{geometry}");
    }
}
