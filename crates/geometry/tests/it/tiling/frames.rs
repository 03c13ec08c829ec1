//! Tiles and their frames: the five about a corner, out and back, two ways to one tile, and where all ends.

use std::collections::HashSet;

use antipode_geometry::tiling::{
    Frame, Golden, Isometry, MOST_STEPS, Side, Tile, TilingError, rings,
};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::common::{distance, outward, sides};
use crate::space::common::cases;

#[test]
fn five_squares_are_about_a_corner() {
    let round = Isometry::STEP.times(&Isometry::QUARTER).unwrap();
    let mut turned = Isometry::IDENTITY;
    for corner in 1..=5 {
        turned = turned.times(&round).unwrap();
        assert_eq!(turned == Isometry::IDENTITY, corner == 5);
    }
    let steps = Isometry::IDENTITY.turned(3).stepped().unwrap();
    let product = Isometry::QUARTER
        .inverse()
        .unwrap()
        .times(&Isometry::STEP)
        .unwrap();
    assert_eq!(steps, product);
}

#[test]
fn so_many_tiles_are_so_many_steps_away() {
    let expected = [1, 4, 12, 28, 64, 148, 340, 780, 1792, 4116];
    // About the root, beside it, and far from it: the tiling looks alike everywhere.
    for about in [0.0, 1.0, 60.0] {
        let frame = match about {
            0.0 => Frame::ROOT,
            _ => outward(&[0, 1, 3, 3, 0].map(Side::new), about),
        };
        let found = rings(&frame, 9, 8000).unwrap();
        let counts: Vec<usize> = found.iter().map(Vec::len).collect();
        assert_eq!(counts, expected);
        let all: HashSet<Tile> = found.iter().flatten().map(Frame::tile).collect();
        assert_eq!(all.len(), expected.iter().sum::<usize>());
    }
    assert_eq!(
        rings(&Frame::ROOT, 9, 700),
        Err(TilingError::TooMany { most: 700 })
    );
    assert_eq!(
        rings(&Frame::ROOT, usize::MAX, 5000),
        Err(TilingError::TooMany { most: 5000 })
    );
}

/// By the definition: the neighbours' distances themselves, and the sides of the tie in their order.
#[test]
fn a_frame_has_its_back_to_the_neighbour_nearest_to_the_root() {
    let mut ties = 0;
    for (steps, ring) in rings(&Frame::ROOT, 8, 4000)
        .unwrap()
        .iter()
        .enumerate()
        .skip(1)
    {
        for frame in ring {
            let far = Side::ALL.map(|side| frame.neighbour(side).unwrap().frame.tile().centre()[2]);
            let least = *far.iter().min().unwrap();
            assert_eq!(far[2], least);
            // Side 1 would come before it; a tie is with side 3.
            assert!(far[0] > least && far[1] > least);
            ties += usize::from(far[3] == least);
            assert!(least < frame.tile().centre()[2]);
            // The nearest neighbour is on a shortest way, too.
            assert_eq!(frame.path().unwrap().len(), steps);
        }
    }
    println!("{ties} ties");
    assert!(ties >= 8);
}

#[test]
fn the_root_and_its_neighbours_see_each_other() {
    for side in Side::ALL {
        let next = Frame::ROOT.neighbour(side).unwrap();
        assert_eq!(next.back, Side::PARENT);
        let back = next.frame.parent().unwrap();
        assert_eq!((back.frame, back.back), (Frame::ROOT, side));
    }
    assert_eq!(Frame::ROOT.parent(), None);
    assert_eq!(Tile::ROOT.frame(), Ok(Frame::ROOT));
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn who_goes_back_by_the_same_edges_is_back(start in sides(20), out in sides(200)) {
        let start = outward(&start, 20.0);
        let mut frame = start;
        let mut back = Vec::new();
        for side in out {
            // At the end of the world they turn back.
            let (next, side) = match frame.neighbour(side) {
                Ok(next) => (next, side),
                Err(_) => (frame.neighbour(Side::PARENT).unwrap(), Side::PARENT),
            };
            // The way from the neighbour's frame is the one that the two sides say.
            let way = frame.between(&next.frame).unwrap();
            prop_assert_eq!(way, Isometry::crossing(side, next.back).unwrap());
            let home = next.frame.neighbour(next.back).unwrap();
            prop_assert_eq!((home.frame, home.back), (frame, side));
            back.push(next.back);
            frame = next.frame;
        }
        prop_assert_eq!(frame.tile().frame(), Ok(frame));
        for side in back.into_iter().rev() {
            frame = frame.neighbour(side).unwrap().frame;
        }
        prop_assert_eq!(frame, start);
    }

    #[test]
    fn either_way_about_a_corner_leads_to_one_tile_and_frame(drawn in sides(60), side in 0_u8..4) {
        let start = outward(&drawn, 70.0);
        // Two edges to one side of the corner, three to the other.
        let about = |first: Side, turn: u8, edges: usize| {
            let (mut frame, mut side) = (start, first);
            for _ in 0..edges {
                let next = frame.neighbour(side).unwrap();
                // The other edge at that corner.
                (frame, side) = (next.frame, next.back.turned(turn));
            }
            frame
        };
        let side = Side::new(side);
        let [short, long] = [about(side, 3, 2), about(side.turned(1), 1, 3)];
        prop_assert_eq!(short, long);
        prop_assert_eq!(short.path().unwrap(), long.path().unwrap());
        prop_assert_eq!(about(side, 3, 5), start);
    }

    /// Each number of the matrix of two neighbours 50 radii out is right, as one product of exact numbers: there is no
    /// trace of the 1e21 that both frames are made of.
    #[test]
    fn ways_between_neighbours_far_from_the_root_have_all_their_digits(drawn in sides(60), side in 0_u8..4) {
        let frame = outward(&drawn, 50.0);
        prop_assert!(distance(&frame) > 50.0);
        let next = frame.neighbour(Side::new(side)).unwrap();
        let way = frame.between(&next.frame).unwrap().lorentz();
        let near = Frame::ROOT.neighbour(Side::new(side)).unwrap();
        let turns = next.back.quarters_from(near.back);
        let expected = Isometry::crossing(Side::new(side), near.back).unwrap().turned(4 - turns).lorentz();
        for (ours, exact) in way.to_cols_array().into_iter().zip(expected.to_cols_array()) {
            prop_assert!((ours - exact).abs() <= 1e-13, "{} {}", ours, exact);
        }
        let product = way * next.frame.between(&frame).unwrap().lorentz();
        prop_assert!(product.abs_diff_eq(glam::DMat4::IDENTITY, 1e-13));
    }

    #[test]
    fn moves_are_a_group_and_keep_the_form(one in sides(40), other in sides(40)) {
        let [a, b] = [outward(&one, 25.0), outward(&other, 25.0)];
        let way = a.between(&b).unwrap();
        prop_assert_eq!(way.inverse().unwrap(), b.between(&a).unwrap());
        prop_assert_eq!(a.to_root().times(&way).unwrap(), *b.to_root());
        prop_assert_eq!(way.times(&way.inverse().unwrap()).unwrap(), Isometry::IDENTITY);
        let [x, z, w] = b.tile().centre();
        prop_assert_eq!(a.to_root().inverse().unwrap().moved([x, z, w]).unwrap(), way.columns()[2]);
        prop_assert_eq!(Tile::new(x, z, w), Ok(b.tile()));
    }
}

#[test]
fn the_world_ends_where_all_is_still_exact() {
    // The farthest along a straight line, and along the way of the slowest tiles.
    for drawn in [vec![0], vec![0, 3], vec![1, 3]] {
        let drawn: Vec<Side> = drawn.into_iter().map(Side::new).collect();
        let mut frame = outward(&drawn, 74.0);
        let mut ended = None;
        for side in drawn.iter().cycle().take(40) {
            match frame.neighbour(*side) {
                Ok(next) if next.back == Side::PARENT => frame = next.frame,
                Ok(_) => frame = frame.neighbour(Side::new(0)).map_or(frame, |it| it.frame),
                Err(error) => {
                    ended = Some(error);
                    break;
                }
            }
        }
        assert_eq!(ended, Some(TilingError::OutOfReach));
        assert!(
            distance(&frame) > 76.0 && distance(&frame) < 77.75,
            "{}",
            distance(&frame)
        );
        assert_eq!(frame.tile().frame(), Ok(frame));
        assert!(frame.path().unwrap().len() <= MOST_STEPS);
        assert_eq!(frame.path().unwrap().frame(), Ok(frame));
        assert_eq!(frame.between(&frame), Ok(Isometry::IDENTITY));
        // On the other side of the world there is no way in numbers of this size, and that is said.
        let across = outward(&[Side::new(2), Side::new(0), Side::new(0)], 74.0);
        let way = across.between(&frame).map(|way| way.distance());
        assert!(
            way.map_or_else(|error| error == TilingError::OutOfReach, |far| far < 87.0),
            "{way:?}"
        );
        // The ring about it is what there is of it.
        let there = rings(&frame, 2, 100).unwrap();
        assert!(there[1].len() < 4 && there[0] == [frame]);
    }
}

#[test]
fn what_is_no_tile_is_refused() {
    let number = |whole, phis| Golden::new(whole, phis).unwrap();
    let [x, z, w] = Frame::ROOT
        .neighbour(Side::new(1))
        .unwrap()
        .frame
        .tile()
        .centre();
    assert!(Tile::new(x, z, w).is_ok());
    assert_eq!(Tile::new(x, z, w.negated()), Err(TilingError::NoTile));
    assert_eq!(Tile::new(x, z, number(1, 1)), Err(TilingError::NoTile));
    let far = number(Tile::REACH, Tile::REACH + 1);
    assert_eq!(Tile::new(x, z, far), Err(TilingError::OutOfReach));
    // Of the points of small whole numbers on the axis only centres are on the sheet.
    let small = |most: i128| (-most..=most).flat_map(move |a| (-most..=most).map(move |b| [a, b]));
    let mut found = 0;
    for [a, b] in small(10) {
        for [c, d] in small(12) {
            let on_axis = Tile::new(number(a, b), Golden::ZERO, number(c, d));
            assert!(on_axis.is_ok() || on_axis == Err(TilingError::NoTile));
            if let Ok(tile) = on_axis {
                assert_eq!(tile.frame().unwrap().tile(), tile);
                found += 1;
            }
        }
    }
    // The root, and to either side its neighbour and the next ones of the straight row.
    assert_eq!(found, 7);
}

#[test]
fn numbers_end_in_errors_and_are_ordered_by_value() {
    let number = |whole, phis| Golden::new(whole, phis).unwrap();
    let most = number(Golden::LIMIT, Golden::LIMIT);
    let out = Err(TilingError::OutOfReach);
    assert_eq!(Golden::new(Golden::LIMIT + 1, 0), out);
    assert_eq!(Golden::new(0, i128::MIN), out);
    assert_eq!(most.plus(Golden::ONE), out);
    assert_eq!(most.times(most), out);
    assert_eq!(most.times_phi(), out);
    assert_eq!(
        most.negated().over_phi().unwrap().parts(),
        [0, -Golden::LIMIT]
    );
    assert_eq!(most.minus(most), Ok(Golden::ZERO));
    assert_eq!(
        Golden::PHI.times(Golden::PHI),
        Golden::PHI.plus(Golden::ONE)
    );
    assert_eq!(
        number(5, -3).times_phi().unwrap().over_phi(),
        Ok(number(5, -3))
    );
    // The product is in range though what it is made of is not: of Fibonacci numbers, phi^-170 times phi^170.
    let (mut up, mut down) = (Golden::ONE, Golden::ONE);
    for _ in 0..170 {
        (up, down) = (up.times_phi().unwrap(), down.over_phi().unwrap());
    }
    assert_eq!(up.times(down), Ok(Golden::ONE));
    assert!(down > Golden::ZERO && down < Golden::ONE && up > number(1 << 100, 0));
    let sorted = [
        number(-3, 0),
        number(2, -3),
        number(-1, 0),
        down,
        number(-3, 2),
        number(1, 0),
        number(0, 1),
    ];
    let values: Vec<f64> = sorted.iter().map(|it| it.to_f64()).collect();
    assert!(values.is_sorted() && sorted.is_sorted());
}
