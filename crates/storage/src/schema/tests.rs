//! Old shapes are brought up to today's, and what is none is refused.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests fail by panicking"
)]

use super::*;
use proptest::prelude::*;

/// A value whose first version counted in whole seconds and whose second in milliseconds.
#[derive(Debug, PartialEq)]
struct Clock {
    millis: u64,
}

impl Versioned for Clock {
    const KIND: Kind = Kind::State;
    const VERSION: u16 = 2;

    fn upgrade(version: u16, body: &[u8]) -> Result<Self, SchemaFault> {
        let value: u64 = decode(body)?;
        Ok(Self {
            millis: if version == 1 { value * 1000 } else { value },
        })
    }
}

fn sealed(version: u16, value: u64) -> Vec<u8> {
    codec::seal(
        version,
        Kind::State,
        b"clock",
        1,
        &codec::encode(&value).unwrap(),
    )
}

#[test]
fn older_versions_are_migrated() {
    assert_eq!(
        read::<Clock>(&sealed(1, 7), b"clock"),
        Ok(Clock { millis: 7000 })
    );
    assert_eq!(
        read::<Clock>(&sealed(2, 7), b"clock"),
        Ok(Clock { millis: 7 })
    );
}

#[test]
fn newer_versions_are_refused_as_such() {
    assert_eq!(
        read::<Clock>(&sealed(3, 7), b"clock"),
        Err(SchemaFault::Newer(3))
    );
    assert_eq!(
        read::<Clock>(&sealed(u16::MAX, 7), b"clock"),
        Err(SchemaFault::Newer(u16::MAX))
    );
}

#[test]
fn version_zero_and_foreign_places_are_damage() {
    let cases = [
        read::<Clock>(&sealed(0, 7), b"clock"),
        read::<Clock>(&sealed(1, 7), b"other"),
        read::<Clock>(&codec::seal(1, Kind::Meta, b"clock", 1, &[7]), b"clock"),
        read::<Clock>(&codec::seal(1, Kind::State, b"clock", 1, &[]), b"clock"),
        read::<Clock>(&codec::seal(1, Kind::State, b"clock", 1, &[7, 7]), b"clock"),
    ];
    for case in cases {
        assert!(matches!(case, Err(SchemaFault::Damaged(_))), "{case:?}");
    }
}

#[test]
fn a_flipped_version_bit_is_damage_and_not_a_newer_game() {
    let mut bytes = sealed(1, 7);
    bytes[1] ^= 1;
    assert!(matches!(
        read::<Clock>(&bytes, b"clock"),
        Err(SchemaFault::Damaged(_))
    ));
}

#[test]
fn the_bytes_of_version_1_are_frozen() {
    let meta = WorldMeta {
        name: "Aé".to_owned(),
        seed: 300,
        geometry: "spherical".to_owned(),
        radius_m: 32.0,
        biome: String::new(),
        created_unix_s: 1,
        last_played_unix_s: 2,
        played_s: 0.5,
        cheated: false,
        generator: 1,
        gathering: false,
    };
    let today = codec::encode(&meta).unwrap();
    // What versions after it have put to the end: whether one has cheated, the generator, and whether one gathers.
    let (body, later) = today.split_at(today.len() - 3);
    assert_eq!(later, [0, 1, 0]);
    let mut expected = vec![3, b'A', 0xc3, 0xa9, 251, 44, 1, 9];
    expected.extend(b"spherical");
    expected.extend(32.0_f64.to_le_bytes());
    expected.extend([0, 1, 2]);
    expected.extend(0.5_f64.to_le_bytes());
    assert_eq!(body, expected);
    for version in [1, 2] {
        assert_eq!(WorldMeta::upgrade(version, body), Ok(meta.clone()));
        assert!(WorldMeta::upgrade(version, &today).is_err());
    }
    for (versions, less) in [(3..=8, 2), (9..=9, 1)] {
        for version in versions {
            let of_version = &today[..today.len() - less];
            assert_eq!(WorldMeta::upgrade(version, of_version), Ok(meta.clone()));
            assert!(WorldMeta::upgrade(version, &today).is_err());
        }
    }
    assert!(WorldMeta::upgrade(3, body).is_err());
}

#[test]
fn a_state_of_version_1_shows_the_one_picture_it_knew() {
    let old = v1::WorldState {
        player: PlayerRecord::default(),
        item_slot: 3,
        inventory: Vec::new(),
        time_of_day_s: 60.0,
        curvature: 12.5,
        brush_radius_m: 4.0,
        simulated_s: 7.0,
        view_distance: 5,
    };
    let state = WorldState::upgrade(1, &codec::encode(&old).unwrap()).unwrap();
    assert_eq!((state.map.as_str(), state.curvature), ("raised", 12.5));
    assert_eq!((state.bent, state.bend), (false, 0.0));
    assert_eq!((state.brush_radius_m, state.view_distance), (4.0, 5));
    let today = codec::encode(&state).unwrap();
    assert_eq!(WorldState::upgrade(6, &today).as_ref(), Ok(&state));
    for version in [1, 2, 3, 4, 5] {
        assert!(WorldState::upgrade(version, &today).is_err());
    }
}

/// Those that are a byte, and those that are a number.
fn charts() -> impl Strategy<Value = u128> {
    prop_oneof![0..4_u128, any::<u128>()]
}

/// Each chart is stored in one way: the hemispheres have no name.
#[test]
fn a_chart_is_a_byte_or_a_name_of_sixteen_bytes_and_nothing_else() {
    let place = |chart| PlaceRecord {
        chart,
        ..PlaceRecord::default()
    };
    let zero = [0; 24];
    for (chart, stored) in [
        (0, vec![0]),
        (1, vec![1]),
        (0x0203, [&[16], &[0; 14][..], &[2, 3]].concat()),
    ] {
        let body = [&stored[..], &zero].concat();
        assert_eq!(codec::encode(&place(chart)).unwrap(), body);
        assert_eq!(codec::decode::<PlaceRecord>(&body), Ok(place(chart)));
    }
    let alias = [&[16], &[0; 15][..], &[1]].concat();
    for stored in [&[2][..], &[15], &alias, &[20; 21], &[255]] {
        let body = [stored, &zero].concat();
        assert!(codec::decode::<PlaceRecord>(&body).is_err(), "{stored:?}");
        let key = [stored, &zero[..12]].concat();
        assert_eq!(ChunkKey::from_bytes(&key), None, "{stored:?}");
    }
}

proptest! {
    #[test]
    fn chunk_keys_survive_and_keep_their_order(
        a in (charts(), any::<[i32; 3]>()),
        b in (charts(), any::<[i32; 3]>()),
    ) {
        let key = |(chart, [x, y, z]): (u128, [i32; 3])| ChunkKey { chart, x, y, z };
        let (a, b) = (key(a), key(b));
        for key in [a, b] {
            let bytes = key.to_bytes();
            prop_assert_eq!(ChunkKey::from_bytes(&bytes), Some(key));
            prop_assert_eq!(ChunkKey::is_of_named_chart(&bytes), key.chart > 1);
            prop_assert_eq!(codec::decode::<ChunkKey>(&codec::encode(&key).unwrap()), Ok(key));
        }
        prop_assert_eq!(a.cmp(&b), a.to_bytes().cmp(&b.to_bytes()));
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let read = read::<WorldState>(&bytes, b"state");
        prop_assert!(read.is_err());
        let _ = WorldState::upgrade(1, &bytes);
        let _ = WorldState::upgrade(2, &bytes);
        let _ = WorldState::upgrade(4, &bytes);
        let _ = WorldState::upgrade(5, &bytes);
        let _ = WorldState::upgrade(6, &bytes);
        let _ = WorldMeta::upgrade(2, &bytes);
        let _ = WorldMeta::upgrade(3, &bytes);
    }
}
