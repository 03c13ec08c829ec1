//! What a world on the tiling has to show to who walks and measures in it.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use antipode_geometry::tiling::{APOTHEM, EDGE_TANH, Frame, Side, TILE_AREA, TilingError, rings};

use super::common::{Hiker, outward};

/// Radii for tiles 32, 64 and 128 m wide at their middle.
const RADII_M: [f64; 3] = [30.152, 60.305, 120.61];

/// How far from the start four equal sides with right angles end, on the plane.
fn missed_m(side_m: f64, radius_m: f64, corners: usize) -> f64 {
    // Far out, that the numbers be put to the test.
    let start = Hiker::at(&outward(&[0, 1, 3].map(Side::new), 30.0));
    let mut hiker = start;
    for _ in 0..corners {
        hiker.walk(side_m / radius_m);
        hiker.turn(FRAC_PI_2);
    }
    start.distance(&hiker) * radius_m
}

#[test]
fn tiles_are_as_wide_as_said() {
    for (radius_m, width_m) in RADII_M.into_iter().zip([32.0, 64.0, 128.0]) {
        assert!((2.0 * APOTHEM * radius_m / width_m - 1.0).abs() < 2e-5);
    }
}

#[test]
fn four_sides_do_not_close_and_five_may() {
    for (radius_m, ends) in [
        (60.305, [(20.0, 1.599), (30.0, 5.581), (64.0, 64.0)]),
        (30.152, [(20.0, 6.922), (30.0, 25.934), (64.0, 177.218)]),
    ] {
        for (side_m, end_m) in ends {
            let missed = missed_m(side_m, radius_m, 4);
            println!("R {radius_m}, {side_m} m: {missed:.4} m");
            assert!(
                (missed - end_m).abs() < 2e-3,
                "{side_m} {radius_m}: {missed}"
            );
        }
    }
    assert!(missed_m(2.0 * APOTHEM * 60.305, 60.305, 5) < 1e-9);
    // Nearly flat, they nearly close.
    assert!(missed_m(1.0, 1e4, 4) < 1e-6);
}

#[test]
fn higher_up_the_same_sides_are_shorter_on_the_plane() {
    for (height_m, end_m) in [(10.0, 62.07), (30.0, 48.87)] {
        let stretch = (height_m / 60.305_f64).cosh();
        let missed = missed_m(64.0 / stretch, 60.305, 4);
        println!(
            "at {height_m} m: {missed:.3} on the plane, {:.3} there",
            missed * stretch
        );
        let nearest = [missed, missed * stretch].map(|it| (it - end_m).abs());
        assert!(nearest[0].min(nearest[1]) < 0.01, "{missed}");
    }
}

/// The angle between two others as somebody sees them.
fn angle_rad(eye: &Hiker, one: &Hiker, other: &Hiker) -> f64 {
    let [a, b] = [eye.sight(one), eye.sight(other)];
    (a.x * b.z - a.z * b.x).atan2(a.x * b.x + a.z * b.z).abs()
}

#[test]
fn three_poles_64_m_apart_have_less_than_two_right_angles() {
    for (radius_m, sum_deg) in [(60.305, 155.48), (30.152, 108.0)] {
        let side = 64.0 / radius_m;
        let first = Hiker::at(&outward(&[3, 0].map(Side::new), 20.0));
        let mut second = first;
        second.walk(side);
        // The third by trying: the turn at the second after which it is as far from the first.
        let third = |turn: f64| {
            let mut hiker = second;
            hiker.turn(turn);
            hiker.walk(side);
            hiker
        };
        let (mut near, mut far) = (PI, FRAC_PI_2);
        for _ in 0..50 {
            let turn = 0.5 * (near + far);
            if third(turn).distance(&first) < side {
                near = turn;
            } else {
                far = turn;
            }
        }
        let poles = [first, second, third(near)];
        let sum: f64 = (0..3)
            .map(|i| angle_rad(&poles[i], &poles[(i + 1) % 3], &poles[(i + 2) % 3]))
            .sum();
        println!("R {radius_m}: {:.4} degrees", sum.to_degrees());
        assert!((sum.to_degrees() - sum_deg).abs() < 0.005);
        let law = antipode_geometry::equilateral_angle_sum_rad(-radius_m.powi(-2), 64.0);
        assert!((sum - law).abs() < 1e-7);
    }
}

/// The part of a tile within so many radii of a point, in square radii, by 64 by 64 samples.
///
/// With u = X/W and v = Z/W the area is `du dv / (1 - u^2 - v^2)^(3/2)`.
fn area_within(tile: &Frame, from: &Frame, radii: f64) -> f64 {
    // How far a point (X, Z, W) of the tile is, as a cosine, is the last row times it.
    let row = from.between(tile).unwrap().lorentz().row(3);
    let step = 2.0 * EDGE_TANH / 64.0;
    let along = |i: i32| (f64::from(i) + 0.5) * step - EDGE_TANH;
    let mut area = 0.0;
    for u in (0..64).map(along) {
        for v in (0..64).map(along) {
            let rest: f64 = 1.0 - u * u - v * v;
            if (row.x * u + row.z * v + row.w) / rest.sqrt() <= radii.cosh() {
                area += step * step / (rest * rest.sqrt());
            }
        }
    }
    area
}

#[test]
fn there_is_so_much_more_land_within_250_m() {
    let whole = area_within(&Frame::ROOT, &Frame::ROOT, 5.0);
    assert!((whole / TILE_AREA - 1.0).abs() < 2e-4, "{whole}");
    for (radius_m, ratio) in RADII_M.into_iter().zip([58.0, 3.56, 1.41]) {
        let radii = 250.0 / radius_m;
        let mut land = 0.0;
        let mut tiles = 0;
        // Children are farther from the root than their parents.
        let mut waiting = vec![Frame::ROOT];
        while let Some(frame) = waiting.pop() {
            let away = frame.to_root().distance();
            if away > radii + 0.85 {
                continue;
            }
            let over = Side::ALL.map(|side| frame.neighbour(side).unwrap());
            let children = over
                .iter()
                .filter(|it| it.back == Side::PARENT && it.frame != Frame::ROOT);
            waiting.extend(children.map(|it| it.frame));
            if away < radii - 0.85 {
                land += TILE_AREA;
            } else {
                land += area_within(&frame, &Frame::ROOT, radii);
            }
            tiles += usize::from(away < radii);
        }
        let exact = TAU * (radii.cosh() - 1.0);
        let flat = PI * radii * radii;
        println!("R {radius_m}: {tiles} tiles, {:.3} times", land / flat);
        assert!((land / exact - 1.0).abs() < 2e-3, "{land} {exact}");
        assert!((land / flat / ratio - 1.0).abs() < 5e-3);
    }
    // The number of tiles is bounded whatever is asked.
    assert_eq!(
        rings(&Frame::ROOT, 40, 1000),
        Err(TilingError::TooMany { most: 1000 })
    );
}
