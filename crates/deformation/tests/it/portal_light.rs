//! Sun and lamps through portals.

use antipode_deformation::{Place, Portal, Space, Triangles, Void, lamp_paths, sun_ways};
use antipode_testing::rooms;
use glam::{DQuat, DVec2, DVec3};

use crate::common::{portal, v};

/// A portal at the origin that looks along +x, and its partner, which looks up at (50, 0, 0).
fn window() -> Space {
    let here = portal("here", DVec3::ZERO, 0.0, 1);
    let mut there = portal("there", v(50.0, 0.0, 0.0), 0.0, 0);
    there.turn = DQuat::from_rotation_z(90f64.to_radians());
    Space::with_portals(Vec::new(), vec![here, there]).unwrap()
}

#[test]
fn the_sun_falls_straight_and_through_a_turned_portal_by_its_beam() {
    let space = window();
    let sun = v(0.1, 1.0, 0.0).normalize();
    let ways = |at: DVec3, scene: &dyn antipode_deformation::SceneQuery| {
        sun_ways(&space, &Place::at(&space, at), sun, 500.0, scene)
    };
    // Straight up, and out of the portal: it lies before it, and behind it is the sky over the partner.
    let both = ways(v(2.0, 0.0, 0.0), &Void);
    assert_eq!(both.len(), 2, "{both:?}");
    assert!((both[0] - sun).length() < 1e-12);
    assert!(both[1].x < -0.9, "{both:?}");
    // Beside the opening, and behind it, there is no beam.
    assert_eq!(ways(v(2.0, 0.0, 3.0), &Void).len(), 1);
    assert_eq!(ways(v(-2.0, 0.0, 0.0), &Void).len(), 1);
    // A lid over the partner takes the beam only.
    let lid = rooms::cuboid(v(50.0, 4.0, 0.0), DQuat::IDENTITY, v(5.0, 0.1, 5.0), 1);
    let lidded = ways(v(2.0, 0.0, 0.0), &Triangles::new(lid));
    assert_eq!(lidded.len(), 1);
    assert!((lidded[0] - sun).length() < 1e-12);
    // Straight up through a portal that is turned is not to the sun.
    let under = v(50.0, 3.0, 0.0);
    let mut down = portal("down", under, 0.0, 1);
    down.turn = DQuat::from_rotation_z(-90f64.to_radians());
    let out = portal("out", v(0.0, 0.0, 90.0), 0.0, 0);
    let roofed = Space::with_portals(Vec::new(), vec![down, out]).unwrap();
    let place = Place::at(&roofed, under - DVec3::Y);
    assert!(sun_ways(&roofed, &place, sun, 500.0, &Void).is_empty());
}

#[test]
fn a_lamp_shines_through_a_portal_and_falls_off_by_its_own_metres() {
    for scale in [1.0, 3.0] {
        let here = portal("here", DVec3::ZERO, 0.0, 1);
        let mut there = portal("there", v(50.0, 0.0, 0.0), 90.0, 0);
        there.polygon = Portal::rectangle(DVec2::splat(2.0 * scale));
        let space = Space::with_portals(Vec::new(), vec![here, there]).unwrap();
        // The partner looks along +z.
        let lamp = Place::at(&space, v(50.0, 0.0, 3.0 * scale));
        let from = Place::at(&space, v(2.0, 0.0, 0.0));
        let paths = lamp_paths(&space, &from, &lamp);
        let clear: Vec<_> = paths
            .iter()
            .filter(|it| it.is_clear(&space, &from, &lamp, &Void))
            .collect();
        assert_eq!(clear.len(), 2, "straight and through: {paths:?}");
        let through = clear.iter().find(|it| it.w.x < -0.99).unwrap();
        assert!((through.length - 5.0 * scale).abs() < 1e-9, "{through:?}");
        let aside = Place::at(&space, v(2.0, 0.0, 6.0));
        let clear = |it: &antipode_deformation::LampPath| it.is_clear(&space, &aside, &lamp, &Void);
        assert_eq!(
            lamp_paths(&space, &aside, &lamp)
                .iter()
                .filter(|it| clear(it))
                .count(),
            1
        );
    }
}
