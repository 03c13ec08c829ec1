//! What faces do: refraction, and the thesis's rule with its faults.

use antipode_deformation::{
    End, EventKind, Exit, PictureCorners, Place, Sides, Traveller, Void, trace,
};
use glam::{DMat3, DVec3};

use crate::common::{boxed, go, space, v};

#[test]
fn light_leaves_a_stretched_box_by_the_side_up_to_its_critical_angle() {
    let stretched = boxed(
        "glass",
        DVec3::ZERO,
        v(1.0, 9.0, 90.0),
        v(1.0, 1.0, 5.0),
        Sides::Snell,
    );
    let space = space([stretched]);
    let start = Place::at(&space, DVec3::ZERO);
    let leaves = |degrees: f64| {
        let angle = degrees.to_radians();
        let w = v(angle.cos(), 0.0, angle.sin());
        (w, go(&space, &start, w, 3.0))
    };
    let critical = 0.2_f64.asin().to_degrees();
    assert!((critical - 11.5).abs() < 0.05);
    let (w, through) = leaves(critical - 0.01);
    assert_eq!(through.events[0].kind, EventKind::Left);
    assert!(
        (through.w.z - 5.0 * w.z).abs() < 1e-12,
        "the covector's part along the face is kept"
    );
    let (w, back) = leaves(critical + 0.01);
    assert_eq!(back.events[0].kind, EventKind::Reflected);
    assert!((back.w - v(-w.x, 0.0, w.z)).length() < 1e-12);
    assert!(back.place.stack.contains(0));
}

#[test]
fn doors_are_the_same_for_all_three_rules() {
    for sides in [Sides::Walls, Sides::Soft, Sides::Snell] {
        let tunnel = boxed(
            "tunnel",
            DVec3::ZERO,
            v(1.0, 1.0, 5.0),
            v(1.0, 1.0, 5.0),
            sides,
        );
        let space = space([tunnel]);
        let w = v(0.01, 0.005, 1.0).normalize();
        let path = go(&space, &Place::at(&space, v(0.0, 0.0, -7.0)), w, 60.0);
        assert!((path.w - w).length() < 1e-14, "{sides:?}");
        assert_eq!(path.events.len(), 2);
    }
}

#[test]
fn refraction_takes_the_way_of_least_felt_length() {
    // Fermat: of all ways from a to b through a point of the face the one that the rule takes is the shortest.
    let slab = boxed(
        "slab",
        v(5.0, 0.0, 0.0),
        v(5.0, 50.0, 50.0),
        v(1.3, 0.7, 2.0),
        Sides::Snell,
    );
    let space = space([slab]);
    let start = v(-2.0, 0.3, -0.4);
    let path = go(
        &space,
        &Place::at(&space, start),
        v(0.9, 0.3, 0.2).normalize(),
        6.0,
    );
    let (on_face, end) = (path.events[0].point, path.place.point);
    let length = |face: DVec3| (face - start).length() + ((end - face) * v(1.3, 0.7, 2.0)).length();
    assert!((length(on_face) - 6.0).abs() < 1e-12);
    for step in [v(0.0, 1e-3, 0.0), v(0.0, 0.0, 1e-3)] {
        assert!(length(on_face + step) > 6.0 && length(on_face - step) > 6.0);
    }
}

/// A camera at a yaw that looks along -z at 0: where its picture's corners and its middle look.
fn camera(yaw: f64, fov_y: f64, aspect: f64) -> (PictureCorners, DVec3) {
    let turn = DMat3::from_rotation_y(-yaw);
    let up = (0.5 * fov_y).tan();
    let corner = |side: f64| (turn * v(side * up * aspect, side * up, -1.0)).normalize();
    (
        PictureCorners::new(corner(-1.0), corner(1.0)),
        turn * DVec3::NEG_Z,
    )
}

/// By how much light along -z is bent for d = 1 along x, degrees.
fn bend_of_axis(yaw: f64, fov_y_rad: f64, aspect: f64) -> f64 {
    let (corners, _) = camera(yaw.to_radians(), fov_y_rad, aspect);
    let bent = corners.bend(DVec3::NEG_Z, DVec3::X);
    bent.angle_between(DVec3::NEG_Z).to_degrees()
}

#[test]
fn the_thesis_bends_light_by_where_the_camera_looks() {
    // Golden: f = 2 smoothstep(m, M, 0) - 1 with m, M = sin 25 -+ cos 25 tan(1/2) 16/9, both over one length.
    let wide = 16.0 / 9.0;
    assert!(bend_of_axis(0.0, 1.0, wide) < 1e-12);
    let views = [(1.0, wide, 33.62), (1.4, wide, 24.32), (1.0, 1.0, 44.11)];
    for (fov, aspect, expected) in views {
        let bend = bend_of_axis(25.0, fov, aspect);
        assert!((bend - expected).abs() < 0.01, "{fov} {aspect}: {bend}");
    }
}

#[test]
fn the_thesis_bends_once_and_has_three_ways_out() {
    let (corners, _) = camera(0.05, 1.0, 1.0);
    let w = v(0.15, 0.1, -1.0).normalize();
    let d = v(1.0, 0.0, 0.0);
    let out = |exit: Exit| {
        let tunnel = boxed(
            "tunnel",
            DVec3::ZERO,
            v(9.0, 9.0, 5.0),
            v(0.5, 1.0, 1.0),
            Sides::Legacy(exit),
        );
        let space = space([tunnel]);
        let light = Traveller::Light(corners);
        let path = trace(
            &space,
            &Place::at(&space, v(0.0, 0.0, 7.0)),
            w,
            40.0,
            &Void,
            &light,
        );
        assert_eq!(path.end, End::Spent);
        path.w
    };
    let bent = corners.bend(w, d);
    assert!((bent - w).length() > 0.05);
    assert_eq!(out(Exit::Original), w);
    assert_eq!(out(Exit::None), bent);
    assert_eq!(out(Exit::Inverse), corners.bend(bent, -d));
}

#[test]
fn our_light_does_not_depend_on_the_picture_and_the_thesis_s_does() {
    let see = |sides: Sides, yaw: f64, fov: f64, aspect: f64| {
        let space = space([boxed(
            "box",
            DVec3::ZERO,
            v(9.0, 9.0, 5.0),
            v(0.5, 1.0, 1.0),
            sides,
        )]);
        let light = Traveller::Light(camera(yaw, fov, aspect).0);
        let w = v(0.1, 0.1, -1.0).normalize();
        trace(
            &space,
            &Place::at(&space, v(0.0, 0.0, 7.0)),
            w,
            40.0,
            &Void,
            &light,
        )
        .place
        .point
    };
    let views = [
        (0.0, 1.0, 1.0),
        (0.3, 1.0, 1.0),
        (0.0, 1.4, 1.0),
        (0.0, 1.0, 1.8),
    ];
    for (yaw, fov, aspect) in views {
        assert_eq!(
            see(Sides::Soft, yaw, fov, aspect),
            see(Sides::Soft, 0.0, 1.0, 1.0)
        );
    }
    for (yaw, fov, aspect) in &views[1..] {
        let legacy = Sides::Legacy(Exit::Original);
        let apart = (see(legacy, *yaw, *fov, *aspect) - see(legacy, 0.0, 1.0, 1.0)).length();
        assert!(apart > 0.1, "{yaw} {fov} {aspect}: {apart}");
    }
}
