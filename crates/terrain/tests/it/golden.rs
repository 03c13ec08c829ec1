//! Worlds that were begun with an older generator are made bit for bit as they were.

use std::sync::Arc;

use antipode_geometry::{ChartId, ChunkCoord, Geometry, Strategy, strategy};
use antipode_terrain::{Field, Generator, march};
use glam::IVec3;

/// FNV-1a.
fn hash(hash: u64, bytes: &[u8]) -> u64 {
    let mix = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3);
    bytes.iter().fold(hash, mix)
}

/// All the samples and coloured vertices of two chunks.
fn land(field: &Field) -> u64 {
    let mut found = 0xcbf2_9ce4_8422_2325;
    for index in [IVec3::ZERO, IVec3::new(-1, 0, 0)] {
        let coord = ChunkCoord {
            chart: ChartId::SECOND,
            index,
        };
        let samples = field.samples(coord);
        for value in samples.values() {
            found = hash(found, &value.to_bits().to_le_bytes());
        }
        for vertex in march(&samples, field, coord).vertices {
            found = hash(found, format!("{:?}", vertex.position()).as_bytes());
            found = hash(found, &vertex.colour);
        }
    }
    found
}

fn spaces() -> [Arc<dyn Strategy>; 3] {
    [
        strategy(Geometry::Euclidean, 20.0),
        strategy(Geometry::Hyperbolic, 20.0),
        strategy(Geometry::Spherical, 32.0),
    ]
}

#[test]
fn land_of_one_biome_is_what_it_was_bit_for_bit() {
    const GOLDEN: [[u64; 3]; 5] = [
        [
            0x74c6_7631_1d71_f1ee,
            0x74c6_7631_1d71_f1ee,
            0x348d_55b5_2139_752a,
        ],
        [
            0x4452_8ac5_81ac_5693,
            0x4452_8ac5_81ac_5693,
            0x434b_db1e_7390_ccec,
        ],
        [
            0x17bb_44c5_a8de_97ad,
            0x17bb_44c5_a8de_97ad,
            0xfdc0_3c67_bd8e_4d07,
        ],
        [
            0xfdc4_efc6_eed5_7ac7,
            0xfdc4_efc6_eed5_7ac7,
            0x1434_8290_92c3_e28a,
        ],
        [
            0x6b24_700b_011b_d1f1,
            0x6b24_700b_011b_d1f1,
            0xb176_7180_7185_e764,
        ],
    ];
    for (seed, expected) in (10..).zip(GOLDEN) {
        let found = spaces().map(|space| land(&Field::made_by(Generator::OneBiome, seed, space)));
        assert_eq!(found, expected, "{seed}");
    }
}
