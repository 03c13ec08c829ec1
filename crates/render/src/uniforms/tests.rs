//! What the shaders read is laid out as it is written.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]
use std::mem::{offset_of, size_of};

use antipode_geometry::SquareFrame;
use antipode_geometry::shader::FLAT;
use naga::{Binding, Module, TypeInner};

use super::*;
use crate::charts::ChartUniform;
use crate::pressers::PresserUniform;
use crate::shaders::tests::parse;
use crate::shaders::{FIGURE, MARKER, OUTLINES, TERRAIN};
use crate::shadow::{CasterUniform, MapUniform};

fn members(module: &Module, name: &str) -> (Vec<(String, usize)>, usize) {
    let (_, ty) = module
        .types
        .iter()
        .find(|(_, t)| t.name.as_deref() == Some(name))
        .unwrap();
    let TypeInner::Struct { members, span } = &ty.inner else {
        panic!("{name} is no struct")
    };
    (
        members
            .iter()
            .map(|m| (m.name.clone().unwrap(), m.offset as usize))
            .collect(),
        *span as usize,
    )
}

#[test]
fn the_scene_is_laid_out_as_the_shaders_read_it() {
    let (found, span) = members(&parse(TERRAIN, &FLAT), "Scene");
    let ours = [
        ("space", offset_of!(SceneUniform, space)),
        ("right", offset_of!(SceneUniform, right)),
        ("time_s", offset_of!(SceneUniform, time_s)),
        ("up", offset_of!(SceneUniform, up)),
        (
            "contour_strength",
            offset_of!(SceneUniform, contour_strength),
        ),
        ("front", offset_of!(SceneUniform, front)),
        ("fog_distance_m", offset_of!(SceneUniform, fog_distance_m)),
        ("top", offset_of!(SceneUniform, top)),
        ("star_strength", offset_of!(SceneUniform, star_strength)),
        ("horizon", offset_of!(SceneUniform, horizon)),
        ("star_sine", offset_of!(SceneUniform, star_sine)),
        ("glare", offset_of!(SceneUniform, glare)),
        ("star_cosine", offset_of!(SceneUniform, star_cosine)),
        ("sun", offset_of!(SceneUniform, sun)),
        ("cloud_drift", offset_of!(SceneUniform, cloud_drift)),
        ("moon", offset_of!(SceneUniform, moon)),
        ("cloud_cover", offset_of!(SceneUniform, cloud_cover)),
        ("key_direction", offset_of!(SceneUniform, key_direction)),
        ("pixel_width", offset_of!(SceneUniform, pixel_width)),
        ("key_colour", offset_of!(SceneUniform, key_colour)),
        ("pixel_height", offset_of!(SceneUniform, pixel_height)),
        ("ambient_sky", offset_of!(SceneUniform, ambient_sky)),
        ("orb_radius", offset_of!(SceneUniform, orb_radius)),
        ("ambient_ground", offset_of!(SceneUniform, ambient_ground)),
        ("ring_edges", offset_of!(SceneUniform, ring_edges)),
        ("moon_colour", offset_of!(SceneUniform, moon_colour)),
        ("covered", offset_of!(SceneUniform, covered)),
        ("sun_place", offset_of!(SceneUniform, sun_place)),
        ("moon_place", offset_of!(SceneUniform, moon_place)),
        ("ring_centre", offset_of!(SceneUniform, ring_centre)),
        ("ring_light", offset_of!(SceneUniform, ring_light)),
        ("ring_radius_m", offset_of!(SceneUniform, ring_radius_m)),
        ("ring_x", offset_of!(SceneUniform, ring_axes)),
        ("ring_y", offset_of!(SceneUniform, ring_axes) + 16),
        ("ring_z", offset_of!(SceneUniform, ring_axes) + 32),
        ("wind", offset_of!(SceneUniform, wind)),
        ("ring_ground", offset_of!(SceneUniform, ring_ground)),
        ("cuts", offset_of!(SceneUniform, cuts)),
        ("figure_cut", offset_of!(SceneUniform, figure_cut)),
        ("shades", offset_of!(SceneUniform, shades)),
        ("lamps", offset_of!(SceneUniform, lamps)),
        ("beams", offset_of!(SceneUniform, beams)),
        ("shadows", offset_of!(SceneUniform, shadows)),
    ];
    assert_eq!(found, ours.map(|(name, at)| (name.to_owned(), at)).to_vec());
    assert_eq!(span, size_of::<SceneUniform>());
}

#[test]
fn a_chart_is_laid_out_as_the_shaders_read_it() {
    let (found, span) = members(&parse(TERRAIN, &FLAT), "Chart");
    let ours = [
        ("view", offset_of!(ChartUniform, view)),
        ("home", offset_of!(ChartUniform, home)),
        ("fraction", offset_of!(ChartUniform, fraction)),
        ("joins", offset_of!(ChartUniform, joins)),
        ("domain_low", offset_of!(ChartUniform, domain_low)),
        ("domain_high", offset_of!(ChartUniform, domain_high)),
        ("origin", offset_of!(ChartUniform, origin)),
        ("north", offset_of!(ChartUniform, north)),
        ("pressers", offset_of!(ChartUniform, pressers)),
    ];
    assert_eq!(found, ours.map(|(name, at)| (name.to_owned(), at)).to_vec());
    assert_eq!(span, size_of::<ChartUniform>());
}

/// Names, offsets and size of a uniform's members, as Rust has them.
macro_rules! laid_out {
    ($uniform:ty: $($member:ident),+) => {
        (
            vec![$((stringify!($member).to_owned(), offset_of!($uniform, $member))),+],
            size_of::<$uniform>(),
        )
    };
}

#[test]
fn the_space_is_laid_out_as_the_shaders_read_it() {
    let ours = laid_out!(SpaceUniform: view, focal_x, focal_y, near_m, radius_m, kappa, lift, lift_sine, lift_cosine,
        level_m, upright_m, k_per_m, padding, origin);
    assert_eq!(members(&parse(TERRAIN, &FLAT), "Space"), ours);
}

#[test]
fn lights_shadows_and_pressers_are_laid_out_as_the_shaders_read_them() {
    let module = parse(TERRAIN, &FLAT);
    let cases = [
        ("Lamp", laid_out!(LampUniform: place, colour, fades_per_m2)),
        (
            "Beam",
            laid_out!(BeamUniform: place, axis, colour, fades_per_m2, full_cosine, dark_cosine, behind),
        ),
        (
            "Presser",
            laid_out!(PresserUniform: place, reach_m, along, height_m, up, strength),
        ),
        (
            "ShadowMap",
            laid_out!(MapUniform: clip, layer, texel_depth, weight, hand),
        ),
        (
            "Shadows",
            laid_out!(ShadowUniform: maps, strength, side_texels, texel, by_moon),
        ),
        (
            "Caster",
            laid_out!(CasterUniform: clip, curvature_per_m, rim_m),
        ),
    ];
    for (name, ours) in cases {
        assert_eq!(members(&module, name), ours, "{name}");
    }
}

/// Locations and widths (in bytes) that a vertex stage reads.
fn inputs(module: &Module) -> Vec<(u32, u64)> {
    let (_, ty) = module
        .types
        .iter()
        .find(|(_, t)| t.name.as_deref() == Some("VertexIn"))
        .unwrap();
    let TypeInner::Struct { members, .. } = &ty.inner else {
        panic!("VertexIn is no struct")
    };
    members
        .iter()
        .filter_map(|m| match m.binding {
            Some(Binding::Location { location, .. }) => Some((
                location,
                u64::from(module.types[m.ty].inner.size(module.to_ctx())),
            )),
            _ => None,
        })
        .collect()
}

/// Instance attributes are full-width, so the buffer and the shader must agree byte for byte.
#[test]
fn instances_are_laid_out_as_the_shaders_read_them() {
    let cases = [
        (
            inputs(&parse(TERRAIN, &FLAT)),
            ChunkInstance::ATTRIBUTES.to_vec(),
            size_of::<ChunkInstance>(),
        ),
        (
            inputs(&parse(FIGURE, &FLAT)),
            FigureInstance::ATTRIBUTES.to_vec(),
            size_of::<FigureInstance>(),
        ),
        (
            inputs(&parse(MARKER, &FLAT)),
            MarkerInstance::ATTRIBUTES.to_vec(),
            size_of::<MarkerInstance>(),
        ),
        (
            inputs(&parse(OUTLINES, &FLAT)),
            OutlineInstance::ATTRIBUTES.to_vec(),
            size_of::<OutlineInstance>(),
        ),
    ];
    for (read, attributes, size) in cases {
        let first = attributes[0].shader_location;
        let ours: Vec<_> = attributes
            .iter()
            .map(|a| (a.shader_location, a.format.size()))
            .collect();
        // Those of the instance lie side by side; of a vertex there may be some on either side.
        let of_instance = first..first + ours.len() as u32;
        assert_eq!(
            read.into_iter()
                .filter(|(at, _)| of_instance.contains(at))
                .collect::<Vec<_>>(),
            ours
        );
        assert_eq!(
            attributes.iter().map(|a| a.format.size()).sum::<u64>() as usize,
            size
        );
    }
}

#[test]
fn chunks_far_away_keep_their_place_and_grain() {
    let origin = DVec3::new(1_000_000.0 * 32.0, -32.0, 96.0);
    let noise = NoiseFrame::Square(SquareFrame::default());
    let instance =
        ChunkInstance::new(origin, origin - DVec3::new(0.25, 1.5, 3.0)).grained(origin, noise);
    assert_eq!(instance.offset, [0.25, 1.5, 3.0]);
    assert_eq!(instance.flags, 0);
    assert_eq!(instance.shaded(0b101, false).flags, 0b1010);
    assert_eq!(instance.shaded(0b101, true).flags, 0b1011);
    assert_eq!(instance.world, [0.0, -32.0, 96.0]);
    assert_eq!(wrap_m(128.0), -128.0);
}
