//! The tiling against `tests/reference/tiling.json`, made with whole numbers of any size by another route.

use antipode_geometry::charts::cylindrical;
use antipode_geometry::tiling::{
    Frame, Golden, Isometry, Side, Tile, TilePath, cylindrical_chart, equiangular_chart,
    equiangular_point,
};
use glam::{DVec3, DVec4};

use crate::accuracy::golden::{TILING, rows};

/// Rows of whole numbers, of a table that has nothing else.
fn whole(table: &str) -> Vec<Vec<i128>> {
    let start = format!("\"{table}\": [\n");
    let from = TILING.find(&start).unwrap() + start.len();
    let lines = TILING[from..].lines();
    let lines = lines.take_while(|line| *line != "]," && *line != "]");
    let numbers = |line: &str| {
        let inner = line.trim_end_matches(',').trim_matches(['[', ']']);
        inner.split(", ").map(|it| it.parse().unwrap()).collect()
    };
    lines.map(numbers).collect()
}

fn centre(tile: Tile) -> [i128; 4] {
    let [x, z, _] = tile.centre().map(Golden::parts);
    [x[0], x[1], z[0], z[1]]
}

/// The walk of the script, with numbers of 128 bits, additions only, and frames compared by two numbers.
#[test]
fn a_million_steps_lead_to_the_same_tiles() {
    let mut expected = whole("walk").into_iter();
    let (mut frame, mut home, mut mixed) = (Frame::ROOT, 0_u64, 0xcbf2_9ce4_8422_2325_u64);
    let mut state = 20_u64;
    let (mut farthest, mut visits) = (Tile::ROOT, 0);
    for step in 1..=1_000_000 {
        state = state.wrapping_mul(6_364_136_223_846_793_005);
        state = state.wrapping_add(1_442_695_040_888_963_407);
        let drawn = state >> 33;
        let side = if home > 0 {
            Side::PARENT
        } else {
            Side::new((drawn & 3) as u8)
        };
        home = home.saturating_sub(1);
        let next = frame.neighbour(side).unwrap();
        frame = next.frame;
        let tile = frame.tile();
        for number in centre(tile).into_iter().chain([next.back.number().into()]) {
            for word in [number as u64, (number >> 64) as u64] {
                mixed = (mixed ^ word).wrapping_mul(0x100_0000_01b3);
            }
        }
        if home == 0 && tile.centre()[2].parts()[1] > 1 << 106 {
            home = (drawn >> 2) % 128;
        }
        farthest = farthest.max(tile);
        visits += usize::from(tile == Tile::ROOT);
        if step % 10_000 == 0 {
            let row = expected.next().unwrap();
            let ours: Vec<i128> = [step]
                .into_iter()
                .chain(centre(tile))
                .chain([mixed.into()])
                .collect();
            assert_eq!(row, ours);
            assert_eq!(tile.frame().unwrap(), frame);
        }
    }
    assert!(expected.next().is_none());
    let most = farthest.frame().unwrap().to_root().distance();
    println!("{visits} times at the root, at most {most} radii from it");
    assert!(most > 74.0);
}

#[test]
fn tiles_are_numbered_as_the_tree_grows() {
    let expected = whole("numbers");
    assert_eq!(expected.len(), 1 + 4 + 12 + 28 + 64 + 148);
    for row in expected {
        let path = TilePath::from_number(row[0] as u128).unwrap();
        assert_eq!(path.number(), row[0] as u128);
        assert_eq!(centre(path.frame().unwrap().tile())[..], row[1..]);
    }
}

/// A path as two numbers of digits to base 4, each behind a 1.
fn path(halves: &[i128]) -> TilePath {
    let sides = halves.iter().flat_map(|digits| {
        let places = (127 - digits.leading_zeros()) / 2;
        (0..places)
            .rev()
            .map(move |at| Side::new((digits >> (2 * at)) as u8 & 3))
    });
    TilePath::new(sides).unwrap()
}

#[test]
fn ways_between_tiles_have_the_nine_numbers() {
    let expected = whole("between");
    let mut farthest: f64 = 0.0;
    for row in &expected {
        let [one, other] = [
            path(&row[..2]).frame().unwrap(),
            path(&row[2..4]).frame().unwrap(),
        ];
        let way: Isometry = one.between(&other).unwrap();
        let ours = way.columns().into_iter().flatten().flat_map(Golden::parts);
        assert!(ours.eq(row[4..].iter().copied()), "{row:?}");
        farthest = farthest.max(one.to_root().distance());
    }
    assert!(expected.len() == 120 && farthest > 40.0, "{farthest}");
}

#[test]
fn numbers_have_their_sign_and_value() {
    for row in whole("signs") {
        let number = Golden::new(row[0], row[1]).unwrap();
        assert_eq!(number.sign() as i128, row[2], "{row:?}");
        assert_eq!(number.cmp(&Golden::ZERO) as i128, row[2]);
        assert_eq!(number.negated().sign() as i128, -row[2]);
    }
    let mut worst: f64 = 0.0;
    for (numbers, row) in whole("signs").iter().zip(rows(TILING, "values")) {
        let ours = Golden::new(numbers[0], numbers[1]).unwrap().to_f64();
        let gap = (ours - row[2]).abs();
        worst = worst.max(if gap > 0.0 { gap / row[2].abs() } else { 0.0 });
    }
    println!("values within {worst} of themselves");
    assert!(worst < 8e-16, "{worst}");
}

#[test]
fn charts_lead_to_the_points_and_back() {
    let mut worst = [0.0_f64; 4];
    let relative = |ours: &[f64], exact: &[f64]| {
        let gaps = ours.iter().zip(exact);
        gaps.map(|(a, b)| ((a - b) / b).abs()).fold(0.0, f64::max)
    };
    for row in rows(TILING, "equiangular") {
        let chart = DVec3::from_slice(&row);
        let point = equiangular_point(chart).unwrap();
        worst[0] = worst[0].max(relative(&point.to_array(), &row[3..]));
        let back = equiangular_chart(DVec4::from_slice(&row[3..]));
        worst[1] = worst[1].max(relative(&back.to_array(), &row[..3]));
    }
    for row in rows(TILING, "cylindrical") {
        let point = cylindrical(-1.0, DVec3::from_slice(&row));
        worst[2] = worst[2].max(relative(&point.to_array(), &row[3..]));
        let back = cylindrical_chart(DVec4::from_slice(&row[3..]));
        worst[3] = worst[3].max(relative(&back.to_array(), &row[..3]));
    }
    println!("relative errors of the charts: {worst:?}");
    assert!(worst.into_iter().all(|it| it < 1.5e-15), "{worst:?}");
}
