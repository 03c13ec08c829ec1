//! Patches of noise: all that reach to a place, what each weighs there, and whose a place on an edge is.

use std::collections::HashSet;

use antipode_geometry::tiling::quilt::{
    MOST_PATCHES, Owner, PATCH_COSH, PATCHES, Patch, Quilt, Surroundings, tangents_in_patch,
};
use antipode_geometry::tiling::{EDGE_TANH, Frame, Side, cylindrical_chart, rings};
use glam::{DVec2, DVec3, DVec4};

use super::common::outward;

/// The root, tiles about it, and one far out.
fn frames() -> Vec<Frame> {
    let near = rings(&Frame::ROOT, 3, 100).unwrap();
    let far = outward(&[0, 1, 3, 3, 0].map(Side::new), 60.0);
    near.into_iter().flatten().chain([far]).collect()
}

fn point(at: DVec2) -> DVec4 {
    let w = (1.0 - at.length_squared()).sqrt();
    DVec4::new(at.x / w, 0.0, at.y / w, 1.0 / w)
}

/// X/W and Z/W of places all over a tile, its edges and corners with it.
fn places() -> impl Iterator<Item = DVec2> {
    let at = |n: i32| f64::from(n) / 8.0 * EDGE_TANH;
    (-8..=8).flat_map(move |i| (-8..=8).map(move |k| DVec2::new(at(i), at(k))))
}

#[test]
fn every_tile_whose_patch_reaches_a_place_is_among_those_of_its_tile() {
    let mut most = 0;
    for frame in frames() {
        let quilt = Quilt::new(&frame).unwrap();
        assert_eq!((quilt.patches().len(), quilt.around().len()), (PATCHES, 17));
        let others = rings(&frame, 4, 200).unwrap();
        for at in places() {
            let mut found = HashSet::new();
            quilt.each(at, |n, place, weight| {
                let patch = &quilt.patches()[n];
                assert!(weight > 0.0 && weight <= 1.0 / 1.1, "{weight}");
                assert_eq!(patch.place(at), place);
                let there = patch.frame().between(&frame).unwrap().lorentz() * point(at);
                // The way out from the centre, nearly.
                let level = cylindrical_chart(there);
                let level = DVec2::new(level.x, level.z);
                let off = place.distance(level);
                assert!(off < 0.014 * level.length() + 1e-12, "{place} {level}");
                let back = tangents_in_patch(place);
                let exact = DVec2::new(there.x, there.z) / there.w;
                assert!(back.distance(exact) < 1e-12, "{back} {exact}");
                found.insert(patch.frame().tile());
            });
            most = most.max(found.len());
            for other in others.iter().flatten() {
                let there = other.between(&frame).unwrap().lorentz() * point(at);
                let off = there.w - PATCH_COSH;
                let is_in = found.contains(&other.tile());
                assert!(off.abs() < 1e-9 || (off < 0.0) == is_in, "{at} {off}");
            }
        }
    }
    assert!(most <= MOST_PATCHES, "{most}");
}

/// Whose a place is, after all steps, and where it lies there.
fn owner(frame: &Frame, at: DVec2) -> (Frame, DVec2) {
    let (mut frame, mut at) = (*frame, at);
    for _ in 0..8 {
        let quilt = Quilt::new(&frame).unwrap();
        match quilt.owner(at) {
            Owner::This(there) => return (frame, there),
            Owner::Other(over, there) => {
                (frame, at) = (*quilt.around()[over].frame(), there);
            }
        }
    }
    panic!("no owner: {at}");
}

#[test]
fn all_who_share_a_place_name_one_owner_and_one_place_to_the_bit() {
    let mut others = 0;
    for frame in frames() {
        for side in Side::ALL {
            let over = frame.neighbour(side).unwrap();
            let turned = |at: DVec2, side: Side| {
                (0..side.number()).fold(at, |at, _| DVec2::new(-at.y, at.x))
            };
            for n in -8..=8 {
                let along = f64::from(n) / 8.0 * EDGE_TANH;
                let here = turned(DVec2::new(EDGE_TANH, along), side);
                let there = turned(DVec2::new(EDGE_TANH, -along), over.back);
                let (one, two) = (owner(&frame, here), owner(&over.frame, there));
                assert_eq!(one, two, "{along}");
                let lorentz = one.0.between(&frame).unwrap().lorentz() * point(here);
                let exact = DVec2::new(lorentz.x, lorentz.z) / lorentz.w;
                assert!(one.1.distance(exact) < 1e-12);
                others += usize::from(one.0 != frame);
            }
            // From past the edge to the rounding.
            let past = turned(DVec2::new(EDGE_TANH + 0.05, 0.31 * EDGE_TANH), side);
            let (home, at) = owner(&frame, past);
            let exact = home.between(&frame).unwrap().lorentz() * point(past);
            assert_eq!(home, over.frame);
            assert!(at.distance(DVec2::new(exact.x, exact.z) / exact.w) < 1e-12);
        }
        assert_eq!(
            owner(&frame, DVec2::new(0.2, -0.3)),
            (frame, DVec2::new(0.2, -0.3))
        );
    }
    assert!(others > 500, "{others}");
}

#[test]
fn tiles_have_keys_of_their_own_and_know_those_about_them() {
    let mut keys = HashSet::new();
    for frame in rings(&Frame::ROOT, 8, 4000).unwrap().iter().flatten() {
        keys.insert(Quilt::new(frame).unwrap().patches()[0].key());
    }
    assert_eq!(keys.len(), 3169);
    let surroundings = Surroundings::new(2, 3.0, 17).unwrap();
    assert_eq!(surroundings.centres().len(), PATCHES);
    assert_eq!(surroundings.centres()[0], DVec3::Z);
    for frame in frames() {
        let quilt = Quilt::new(&frame).unwrap();
        let own: HashSet<u64> = quilt.patches().iter().map(Patch::key).collect();
        let about: HashSet<u64> = quilt.patches()[0].keys_around(&surroundings).collect();
        assert_eq!(own, about);
    }
}
