//! Paths from the root: bytes, numbers, and the kinds of tiles that both go by.

use antipode_geometry::tiling::{Frame, MOST_STEPS, Side, TilePath, TilingError, rings};
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};

use super::common::{distance, outward, sides};
use crate::space::common::cases;

/// Whether a child of a tile lies over a side, by the geometry.
fn is_child(frame: &Frame, side: Side) -> bool {
    let next = frame.neighbour(side).unwrap();
    next.back == Side::PARENT && next.frame != Frame::ROOT
}

#[test]
fn kinds_say_where_children_are() {
    let mut count = 0;
    for frame in rings(&Frame::ROOT, 9, 8000).unwrap().iter().flatten() {
        let path = frame.path().unwrap();
        for side in Side::ALL {
            let longer = TilePath::new(path.sides().chain([side]));
            assert_eq!(longer.is_ok(), is_child(frame, side), "{path:?} {side:?}");
        }
        count += 1;
    }
    assert_eq!(count, 7285);
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn kinds_say_where_children_are_however_far(drawn in sides(80), radii in 10.0..74.0_f64) {
        let frame = outward(&drawn, radii);
        let path = frame.path().unwrap();
        for side in Side::ALL {
            let longer = TilePath::new(path.sides().chain([side]));
            prop_assert_eq!(longer.is_ok(), is_child(&frame, side));
        }
        prop_assert_eq!(path.frame(), Ok(frame));
        prop_assert_eq!(TilePath::from_bytes(&path.to_bytes()), Ok(path));
        prop_assert_eq!(TilePath::from_number(path.number()), Ok(path));
        prop_assert!(path.len() as f64 * 0.734 < distance(&frame) + 1e-9);
    }

    #[test]
    fn every_number_is_a_path_or_none(high in any::<u64>(), low in any::<u64>(), shift in 0..128_u32) {
        let number = (u128::from(high) << 64 | u128::from(low)) >> shift;
        match TilePath::from_number(number) {
            Ok(path) => {
                prop_assert_eq!(path.number(), number);
                prop_assert!(path.len() <= MOST_STEPS);
                prop_assert!(path.frame().is_ok() || path.frame() == Err(TilingError::OutOfReach));
            }
            Err(error) => prop_assert!(error == TilingError::NoPath && number >> 120 == 255),
        }
    }

    #[test]
    fn bytes_are_a_path_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..40)) {
        if let Ok(path) = TilePath::from_bytes(&bytes) {
            prop_assert_eq!(path.to_bytes(), bytes);
        }
    }
}

#[test]
fn numbers_follow_each_other_through_the_rings() {
    let mut number = 0;
    for ring in rings(&Frame::ROOT, 7, 2000).unwrap() {
        let mut found: Vec<u128> = ring
            .iter()
            .map(|frame| frame.path().unwrap().number())
            .collect();
        found.sort_unstable();
        assert!(found.into_iter().eq(number..number + ring.len() as u128));
        number += ring.len() as u128;
    }
    assert_eq!(TilePath::from_number(u128::MAX), Err(TilingError::NoPath));
}

#[test]
fn bytes_that_are_no_path_are_refused() {
    assert_eq!(TilePath::ROOT.to_bytes(), [0]);
    assert!(TilePath::ROOT.is_empty() && TilePath::ROOT.number() == 0);
    let path = TilePath::new([2, 0, 1, 0, 3].map(Side::new)).unwrap();
    let good = path.to_bytes();
    assert_eq!(good.len(), 3);
    assert_eq!(TilePath::from_bytes(&good), Ok(path));
    let no = Err(TilingError::NoPath);
    assert_eq!(TilePath::from_bytes(&[]), no);
    assert_eq!(TilePath::from_bytes(&good[..2]), no);
    assert_eq!(TilePath::from_bytes(&[&good[..], &[0]].concat()), no);
    assert_eq!(
        TilePath::from_bytes(&[good[0], good[1], good[2] | 0x80]),
        no
    );
    // Back again is no way to a child, and so many steps are too many.
    assert_eq!(TilePath::new([1, 2].map(Side::new)), no);
    assert!(TilePath::new(vec![Side::new(0); MOST_STEPS]).is_ok());
    assert_eq!(TilePath::new(vec![Side::new(0); MOST_STEPS + 1]), no);
    let longest = TilePath::new(vec![Side::new(0); MOST_STEPS]).unwrap();
    assert_eq!(longest.to_bytes().len(), 28);
    assert_eq!(longest.frame(), Err(TilingError::OutOfReach));
}
