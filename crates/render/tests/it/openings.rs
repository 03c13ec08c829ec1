//! What is seen through doors.

use std::sync::Arc;

use crate::common::{GEOMETRIES, Studio, difference, frame, land, space, standing};

use antipode_frame::{Cut, Figure, Frame, ModelId, Opening, Presence};
use antipode_geometry::{ChartId, ChartPoint, Doorway, Geometry, Leaf};
use antipode_render::ShadowQuality;
use glam::DVec3;

const SIZE: (u32, u32) = (160, 90);
const ASPECT: f64 = 16.0 / 9.0;

/// Land, an eye that looks along +x, and an astronaut four metres before it.
fn before_an_astronaut(geometry: Geometry) -> Frame {
    let space = space(geometry);
    let point = standing(&space, ChartId::FIRST, 5.0, 3.0);
    let feet = point.moved(DVec3::new(4.0, -1.6, 0.3));
    frame(&space, point, ASPECT).with_content(|it| {
        it.land = land(&space, point, 1);
        it.figures = vec![Figure::standing(ModelId::Astronaut, feet, 0.4)];
    })
}

fn leaf(frame: &Frame, ahead_m: f64, yaw: f64) -> Leaf {
    let eye = frame.view.eye;
    let foot = eye.point.moved(DVec3::new(ahead_m, -1.6, 0.0));
    Leaf::at(&*frame.view.strategy, foot, eye.yaw + yaw)
}

fn with_doors(frame: &Frame, leaves: [Leaf; 2]) -> Frame {
    let mut frame = frame.clone();
    frame.openings = Opening::all(&frame.view, &Doorway { leaves }).to_vec();
    frame
}

/// Through a door that turns nothing the sky is as without it, and so is who stands as far behind the other one. The light on
/// them is that of their place, which on a globe is another.
#[test]
fn who_stands_behind_the_far_door_is_seen_as_if_standing_behind_the_near_one() {
    for geometry in [Geometry::Euclidean, Geometry::Hyperbolic] {
        for (samples, near_m) in [(1, 2.0), (4, 2.0), (1, 0.05), (1, 0.01)] {
            let Some(mut studio) = Studio::sampled(SIZE, ShadowQuality::Low, samples) else {
                return;
            };
            let mut frame = before_an_astronaut(geometry);
            frame.content_mut().land = Arc::default();
            let plain = studio.picture(&frame);
            let near = leaf(&frame, near_m, 0.0);
            let far = Leaf {
                foot: near.foot.moved(DVec3::new(31.0, 3.0, -12.0)),
                ..near
            };
            let doors = Doorway {
                leaves: [near, far],
            };
            let feet = frame.content.figures[0].point;
            let there = doors.carry(&*frame.view.strategy, 0, feet).unwrap();
            frame.content_mut().figures[0].point = there.point;
            let seen = studio.picture(&with_doors(&frame, doors.leaves));
            let (most, mean) = difference(&seen, &plain);
            assert!(
                mean < 0.5,
                "{geometry} {samples} {near_m}: {mean}, at most {most}"
            );
        }
    }
}

#[test]
fn what_stands_behind_the_far_door_is_seen_in_the_near_one_and_what_stands_behind_that_is_not() {
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let mut frame = before_an_astronaut(geometry);
        // Land there might hide who stands behind the door.
        frame.content_mut().land = Arc::default();
        // The far one stands aside and behind the eye, and looks across.
        let foot = frame.view.eye.point.moved(DVec3::new(-6.0, -1.6, 9.0));
        let far = Leaf::at(&*frame.view.strategy, foot, 2.0);
        let leaves = [leaf(&frame, 2.0, 0.0), far];
        let doors = Doorway { leaves };
        let without = |frame: &Frame| frame.clone().with_content(|it| it.figures.clear());
        let shown = |frame: &Frame, studio: &mut Studio| {
            let bare = studio.picture(&with_doors(&without(frame), leaves));
            let full = studio.picture(&with_doors(frame, leaves));
            difference(&full, &bare).1
        };
        let hidden = shown(&frame, &mut studio);
        assert!(hidden < 0.02, "{geometry}: behind the near one {hidden}");
        let feet: ChartPoint = frame.content.figures[0].point;
        let there = doors.carry(&*frame.view.strategy, 0, feet);
        let there = there.unwrap().point;
        frame.content_mut().figures[0].point = there;
        let seen = shown(&frame, &mut studio);
        assert!(seen > 0.1, "{geometry}: behind the far one {seen}");
        // Before the far leaf it is cut off, however near.
        for before_m in [1.0, 0.6, 0.45] {
            frame.content_mut().figures[0].point = far.place(DVec3::new(-before_m, 0.0, 0.0));
            let cut = shown(&frame, &mut studio);
            assert!(
                cut < 0.02,
                "{geometry}: {before_m} m before the far one {cut}"
            );
        }
    }
}

/// Where the ground is higher on the other side an opening begins at that: below is this side, and no hole under the ground.
#[test]
fn below_the_sill_of_an_opening_one_sees_this_side() {
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let frame = before_an_astronaut(geometry);
        let foot = frame.view.eye.point.moved(DVec3::new(-6.0, -1.6, 9.0));
        let far = Leaf::at(&*frame.view.strategy, foot, 2.0);
        let with = with_doors(&frame, [leaf(&frame, 2.0, 0.0), far]);
        let with_sill = |sill_m: f64| {
            let mut frame = with.clone();
            for opening in &mut frame.openings {
                opening.sill_m = [sill_m; Opening::SILLS];
            }
            frame
        };
        let plain = studio.picture(&frame);
        let mut off = |sill_m: f64| {
            let seen = studio.picture(&with_sill(sill_m));
            difference(&seen, &plain).1
        };
        let [open, half, closed] = [-1.1, 1.0, 2.2].map(&mut off);
        assert!(open > 1.0, "{geometry}: {open}");
        assert!(
            half < 0.8 * open && half > 0.1 * open,
            "{geometry}: {half} of {open}"
        );
        assert!(closed < 0.01, "{geometry}: {closed}");
    }
}

#[test]
fn a_picture_without_doors_is_the_same_after_one_with_doors() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let frame = before_an_astronaut(Geometry::Hyperbolic);
    let alone = studio.picture(&frame);
    let leaves = [leaf(&frame, 2.0, 0.0), leaf(&frame, -3.0, 1.0)];
    let with = studio.picture(&with_doors(&frame, leaves));
    assert!(with != alone);
    assert!(studio.picture(&frame) == alone);
}

/// A figure that stands in a door is drawn on either side of it, each time as far as the leaf: both parts are the whole.
#[test]
fn both_parts_of_a_figure_that_is_cut_are_the_whole_and_each_is_less() {
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let whole = before_an_astronaut(geometry);
        let own = whole.content.figures[0];
        let part = |side: f64| Figure {
            cut: Some(Cut {
                heading_rad: if side > 0.0 {
                    1.7
                } else {
                    1.7 - std::f64::consts::PI
                },
                from_m: side * 0.05,
            }),
            ..own
        };
        let shown = |figures: &[Figure], studio: &mut Studio| {
            let frame = whole.clone();
            studio.picture(&frame.with_content(|it| it.figures = figures.to_vec()))
        };
        let (all, none) = (studio.picture(&whole), shown(&[], &mut studio));
        let total = difference(&all, &none).1;
        for side in [1.0, -1.0] {
            let one = shown(&[part(side)], &mut studio);
            let (less, more) = (difference(&one, &none).1, difference(&one, &all).1);
            assert!(
                less > 0.2 * total && more > 0.2 * total,
                "{geometry}: {less} {more} of {total}"
            );
        }
        let both = shown(&[part(1.0), part(-1.0)], &mut studio);
        let off = difference(&both, &all).1;
        assert!(off < 0.05 * total, "{geometry}: {off} of {total}");
    }
}

/// Of who stands in a door so that nothing of him is on this side, no shade lies on the ground here either.
#[test]
fn a_figure_whose_feet_are_cut_off_leaves_no_shade_on_the_ground() {
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new(SIZE) else {
            return;
        };
        let frame = before_an_astronaut(geometry);
        let none = studio.picture(&frame.clone().with_content(|it| it.figures.clear()));
        let mut cut = |from_m: f64| {
            let mut figure = frame.content.figures[0];
            figure.cut = Some(Cut {
                heading_rad: 1.7,
                from_m,
            });
            let seen = studio.picture(&frame.clone().with_content(|it| it.figures = vec![figure]));
            difference(&seen, &none).1
        };
        let [whole, gone] = [-1.5, 1.5].map(&mut cut);
        assert!(whole > 0.1, "{geometry}: {whole}");
        assert!(gone < 0.001, "{geometry}: {gone}");
    }
}

/// What only could be put there is seen through, and is another colour where it cannot be.
#[test]
fn what_is_foreseen_is_seen_through_and_red_where_it_is_barred() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let real = before_an_astronaut(Geometry::Euclidean);
    let shown = |presence: Option<Presence>, studio: &mut Studio| {
        let frame = real.clone();
        studio.picture(&frame.with_content(|it| match presence {
            Some(presence) => it.figures[0].presence = presence,
            None => it.figures.clear(),
        }))
    };
    let none = shown(None, &mut studio);
    let [possible, barred] =
        [Presence::Possible, Presence::Barred].map(|it| shown(Some(it), &mut studio));
    let changed = |picture: &[u8]| {
        let pixels = picture.chunks(4).zip(none.chunks(4));
        pixels
            .filter(|(a, b)| a != b)
            .map(|(a, _)| [a[0], a[1]])
            .collect::<Vec<_>>()
    };
    let own = changed(&shown(Some(Presence::Real), &mut studio)).len();
    for (picture, is_red) in [(&possible, false), (&barred, true)] {
        let pixels = changed(picture);
        let redder = pixels.iter().filter(|[red, green]| red > green).count();
        assert!(
            5 * pixels.len() < 4 * own && 4 * pixels.len() > own,
            "{} of {own}",
            pixels.len()
        );
        let of_that_hue = if is_red {
            redder
        } else {
            pixels.len() - redder
        };
        assert!(
            10 * of_that_hue > 9 * pixels.len(),
            "{of_that_hue} of {}",
            pixels.len()
        );
    }
}

/// Between two doors that look at each other one sees a row of oneself: who stands there is seen through the door, and once more through
/// the door that is seen in that.
#[test]
fn a_door_that_is_seen_through_a_door_is_looked_through_once_more() {
    for geometry in GEOMETRIES {
        let Some(mut studio) = Studio::new((2 * SIZE.0, 2 * SIZE.1)) else {
            return;
        };
        let mut frame = before_an_astronaut(geometry);
        frame.content_mut().land = Arc::default();
        // The other one stands behind the eye and looks the same way: who goes into the one comes from behind.
        let leaves = [leaf(&frame, 3.0, 0.0), leaf(&frame, -3.0, 0.0)];
        let shown = |frame: &Frame, studio: &mut Studio| {
            let mut seen = with_doors(frame, leaves);
            let twice = studio.picture(&seen);
            for opening in &mut seen.openings {
                opening.again = None;
            }
            (twice, studio.picture(&seen))
        };
        // Beside the eye, and before the door: in the picture twice, and a third time through both.
        let at = frame.view.eye.point.moved(DVec3::new(1.6, -1.6, -0.55));
        frame.content_mut().figures[0].point = at;
        let (twice, once) = shown(&frame, &mut studio);
        let bare = frame.clone().with_content(|it| it.figures.clear());
        let (bare_twice, bare_once) = shown(&bare, &mut studio);
        // The third one is far off: it has pixels of its own, some tens at this size.
        let differs = |a: &[u8], b: &[u8]| {
            let pixels = a.chunks(4).zip(b.chunks(4));
            pixels.map(|(a, b)| a != b).collect::<Vec<_>>()
        };
        let (with, without) = (differs(&twice, &bare_twice), differs(&once, &bare_once));
        let pixels = with.iter().zip(&without);
        let own = pixels.filter(|(with, without)| **with && !**without);
        let own = own.count();
        assert!(own >= 10, "{geometry}: the third one has {own} pixels");
    }
}
