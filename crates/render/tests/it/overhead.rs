//! The far side of a closed world: things there look larger the farther off they are, and the land has no holes.

use std::f64::consts::PI;

use crate::common::told::told;
use crate::common::worlds::World;
use crate::common::{Studio, frame, space};
use antipode_frame::{Figure, ModelId};
use antipode_geometry::{ChartPoint, Geometry, Projection};
use antipode_items::Item;
use antipode_render::ShadowQuality;
use glam::DVec3;

const SIZE: (u32, u32) = (320, 320);
/// Half way to the antipode a lamp of 0.3 m fills about a quarter of such a picture at a radius of 32 m.
const FOV_Y_RAD: f64 = 0.03;

#[test]
fn a_lamp_three_quarters_of_the_way_to_the_antipode_is_drawn_larger_than_one_half_way() {
    let Some(mut studio) = Studio::new(SIZE) else {
        return;
    };
    let sphere = space(Geometry::Spherical);
    let mut bare = frame(&sphere, ChartPoint::a(DVec3::ZERO), 1.0);
    bare.view.eye.yaw = 0.4;
    bare.view.eye.pitch = 0.0;
    bare.view.projection = Projection::new(FOV_Y_RAD, 1.0, 0.05);
    let nothing = studio.picture(&bare);
    // Pixels of a lamp on the way ahead, and the area that two small steps across the view span there in the picture.
    let mut drawn = |share: f64| {
        let away_m = share * PI * sphere.radius_m();
        let place = sphere.along(&bare.view.eye, DVec3::NEG_Z, away_m);
        assert!(
            (sphere.distance_m(bare.view.eye.point, place, &bare.view.eye) - away_m).abs() < 1e-6
        );
        let mut lit = bare.clone();
        lit.content_mut().figures = vec![Figure::standing(ModelId::Item(Item::Lamp), place, 0.0)];
        let picture = studio.picture(&lit);
        let pairs = picture.pixels().zip(nothing.pixels());
        let changed = pairs.filter(|(a, b)| a.0.iter().zip(b.0).any(|(p, q)| p.abs_diff(q) > 12));
        let seen = |step: DVec3| {
            let view = sphere.view_point(&bare.view.eye, place.moved(step));
            (view.truncate() / -view.z).truncate()
        };
        let radial = place.pos.with_y(0.0).normalize();
        let steps = [DVec3::Y, DVec3::Y.cross(radial)].map(|way| way * 1e-3);
        let [up, aside] = steps.map(|step| seen(step) - seen(-step));
        (changed.count() as f64, up.perp_dot(aside).abs())
    };
    let (half, far) = (drawn(0.5), drawn(0.75));
    assert!(half.0 > 300.0, "{half:?}");
    assert!(far.0 > 1.5 * half.0, "{far:?} {half:?}");
    let (pixels, area) = (far.0 / half.0, far.1 / half.1);
    assert!(
        (pixels / area - 1.0).abs() < 0.1,
        "{pixels} times the pixels, {area} times the area"
    );
}

/// Where the two charts of a closed world meet, each leaves what is past the equator to the other: far off, where both
/// are coarse, no sky may show between them.
#[test]
fn no_sky_shows_through_the_land_where_the_two_halves_meet() {
    for (seed, radius_m, lines) in [(5, 100.0, 720), (1, 100.0, 360), (3, 32.0, 720)] {
        let mut world = World::new(Geometry::Spherical, seed, radius_m, 6).of_lines(lines);
        let Some(mut studio) = Studio::with_shaders(world.size(), ShadowQuality::Off, told())
        else {
            return;
        };
        let mut holes = 0;
        for yaw_deg in [0.0, 60.0, 120.0, 180.0, 240.0, 300.0] {
            world.aim(yaw_deg, 15.0);
            let mut frame = world.frame();
            frame.content_mut().figures.clear();
            let picture = studio.picture(&frame);
            // The land is drawn without blue, but for the glow of the sun before it.
            let blue = |x: u32, y: u32| picture.get_pixel(x, y).0[2];
            let inside = |size: u32| 1..size - 1;
            let (wide, high) = world.size();
            let all = inside(high).flat_map(|y| inside(wide).map(move |x| (x, y)));
            let is_hole = |(x, y): &(u32, u32)| {
                let about = (y - 1..=y + 1).flat_map(|j| (x - 1..=x + 1).map(move |i| (i, j)));
                blue(*x, *y) > 90 && about.filter(|(i, j)| blue(*i, *j) < 30).count() >= 6
            };
            holes += all.filter(is_hole).count();
        }
        assert_eq!(holes, 0, "seed {seed}, {radius_m} m");
    }
}
