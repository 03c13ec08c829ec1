//! Sizes against the flat space's own, and what makes them be taken anew.
#![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

use antipode_geometry::{ChartId, Geometry, HyperbolicMap, picture};
use glam::IVec3;

use super::*;
use crate::tuning::FOV_Y_RAD;

const SHARP: Sharpness = Sharpness {
    pixels_per_rad: 700.0,
    tolerance_px: 0.5,
};

fn eye(dial: f64) -> Eye {
    Eye {
        point: ChartPoint::a(DVec3::new(16.0, 16.0, 16.0)),
        dial,
        ..Eye::default()
    }
}

fn space(geometry: Geometry) -> Arc<dyn Strategy> {
    let radius_m = if geometry == Geometry::Spherical {
        64.0
    } else {
        20.0
    };
    picture(geometry, radius_m, HyperbolicMap::default(), false)
}

fn chunk(x: i32, y: i32, z: i32) -> ChunkCoord {
    ChunkCoord {
        chart: ChartId::FIRST,
        index: IVec3::new(x, y, z),
    }
}

#[test]
fn in_flat_space_a_metre_is_as_large_as_its_distance_says() {
    let sight = Sight::new(&space(Geometry::Euclidean), &eye(0.0), SHARP);
    for x in [4, 9, 15] {
        let nearest_m = f64::from(x) * 32.0 - ROAM_M - 16.0;
        let want = 700.0 / nearest_m;
        let found = sight.pixels_per_metre(chunk(x, 0, 0));
        assert!(
            found >= 0.98 * want && found <= 1.13 * want,
            "{found} {want}"
        );
    }
    assert_eq!(sight.pixels_per_metre(chunk(0, 0, 0)), f64::INFINITY);
}

#[test]
fn a_bent_picture_ends_sooner_and_shows_nothing_larger_than_the_flat_one() {
    let hyperbolic = picture(Geometry::Hyperbolic, 20.0, HyperbolicMap::Horizon, false);
    let flat = Sight::new(&hyperbolic, &eye(0.0), SHARP);
    let bent = Sight::new(&hyperbolic, &eye(20.0), SHARP);
    // The map keeps azimuths: what lies across stays as wide as its distance in the chart says.
    let sizes = [&flat, &bent].map(|sight| sight.pixels_per_metre(chunk(2, 0, 0)));
    assert!(sizes[1] <= 1.1 * sizes[0], "{sizes:?}");
    assert!(flat.span_px(chunk(12, 0, 0)) > 1.0 && bent.span_px(chunk(12, 0, 0)) == 0.0);
}

#[test]
fn beyond_the_sight_limit_there_is_nothing_to_see() {
    let hyperbolic = space(Geometry::Hyperbolic);
    let eye = eye(20.0);
    let sight = Sight::new(&hyperbolic, &eye, SHARP);
    let far = (1..400).map(|x| chunk(x, 0, 0)).find(|coord| {
        let nearest = ChartPoint::a(coord.origin());
        hyperbolic.distance_m(eye.point, nearest, &eye) > hyperbolic.sight_limit_m(&eye)
    });
    let beyond = far.map(|coord| chunk(coord.index.x + 2, 0, 0)).unwrap();
    assert_eq!(sight.span_px(beyond), 0.0);
}

#[test]
fn on_a_sphere_land_grows_again_towards_the_antipode() {
    let sphere = space(Geometry::Spherical);
    let eye = Eye {
        point: ChartPoint::a(DVec3::new(0.0, 20.0, 0.0)),
        ..Eye::default()
    };
    let sight = Sight::new(&sphere, &eye, SHARP);
    let rim_m = sphere.domain(ChartId::FIRST).radius_m().unwrap();
    let middle = sight.pixels_per_metre(chunk((rim_m / 32.0) as i32 - 1, 0, 0));
    let antipode = ChunkCoord {
        chart: ChartId::SECOND,
        index: IVec3::ZERO,
    };
    assert!(sight.pixels_per_metre(antipode) > 1.5 * middle);
}

#[test]
fn sizes_hold_while_the_eye_roams_and_the_dial_glides_a_little() {
    let hyperbolic = space(Geometry::Hyperbolic);
    let sight = Sight::new(&hyperbolic, &eye(5.0), SHARP);
    let holds = |eye: &Eye| sight.holds(&*hyperbolic, eye, SHARP);
    let moved = |m: f64| Eye {
        point: ChartPoint::a(DVec3::new(16.0 + m, 16.0, 16.0)),
        ..eye(5.0)
    };
    assert!(holds(&eye(5.0)) && holds(&moved(7.9)) && !holds(&moved(8.1)));
    let turned = Eye {
        yaw: 2.0,
        ..eye(5.0)
    };
    assert!(holds(&turned));
    assert!(holds(&eye(5.05)) && !holds(&eye(9.0)));
    let other = Sharpness {
        tolerance_px: 1.0,
        ..SHARP
    };
    assert!(!sight.holds(&*hyperbolic, &eye(5.0), other));
}

#[test]
fn what_the_eye_may_roam_to_is_within_what_was_told() {
    for geometry in Geometry::ALL {
        let space = space(geometry);
        let told = Sight::new(&space, &eye(8.0), SHARP);
        for way in [DVec3::X, DVec3::NEG_Z, DVec3::Y] {
            let moved = Eye {
                point: ChartPoint::a(eye(8.0).point.pos + way * (ROAM_M - 0.1)),
                ..eye(8.0)
            };
            for coord in [chunk(2, 0, 0), chunk(-3, 0, 1), chunk(1, 1, -2)] {
                let nearest = moved.point.pos.clamp(coord.min(), coord.max());
                let point = ChartPoint::new(coord.chart, nearest);
                let there = size_rad(&*space.viewer(&moved), point) * 700.0;
                let most = told.pixels_per_metre(coord);
                assert!(
                    there <= 1.15 * most,
                    "{geometry:?} {coord:?} {there} {most}"
                );
            }
        }
    }
}

#[test]
fn exact_pictures_let_nothing_pass() {
    assert_eq!(Sharpness::of(Quality::Exact, 720, FOV_Y_RAD), None);
    let [fast, balanced] = [Quality::Fast, Quality::Balanced]
        .map(|quality| Sharpness::of(quality, 720, FOV_Y_RAD).unwrap());
    assert_eq!((fast.tolerance_px, balanced.tolerance_px), (1.0, 0.5));
    assert!((fast.pixels_per_rad - 469.2).abs() < 0.1);
}
