//! The edits of one chunk in few bytes.
//!
//! Edits are zero almost everywhere and smooth where they are not (sums of
//! Gaussian brush strokes, flat where they saturate). So: predict each sample from
//! its neighbour along x, keep the residual zigzagged (small magnitudes of either
//! sign become small numbers), and put all low bytes before all high bytes. The
//! high plane is then almost all zeros, and LZ4 makes little of both. Where kinds of ground
//! were laid, their bytes follow as a third plane; where none were, there is none.

use crate::codec::Fault;
use crate::schema::StoredGround;

/// Samples of a chunk: 32 along each axis.
pub const CHUNK_SAMPLES: usize = 32 * 32 * 32;

/// Packs the edits of a chunk, in the caller's order (neighbours along the
/// innermost axis side by side packs best).
///
/// # Errors
/// A sentence, if there are not exactly [`CHUNK_SAMPLES`].
pub fn pack_chunk(samples: &[i16]) -> Result<Vec<u8>, String> {
    pack_ground(samples, &[])
}

/// As [`pack_chunk`], with a byte for each sample that tells of its kind of ground, or no bytes at all.
///
/// # Errors
/// A sentence, if there are not exactly [`CHUNK_SAMPLES`] of either.
pub fn pack_ground(samples: &[i16], kinds: &[u8]) -> Result<Vec<u8>, String> {
    let wrong = [samples.len(), kinds.len()]
        .into_iter()
        .zip([CHUNK_SAMPLES, 0])
        .find(|(count, other)| count != other && *count != CHUNK_SAMPLES);
    if let Some((count, _)) = wrong {
        return Err(format!("a chunk has {CHUNK_SAMPLES} samples, not {count}"));
    }
    let mut planes = vec![0; 2 * CHUNK_SAMPLES];
    let (low, high) = planes.split_at_mut(CHUNK_SAMPLES);
    let mut previous = 0_i16;
    for ((&sample, low), high) in samples.iter().zip(low).zip(high) {
        let residual = sample.wrapping_sub(previous);
        previous = sample;
        [*low, *high] = (((residual << 1) ^ (residual >> 15)) as u16).to_le_bytes();
    }
    if kinds.iter().any(|kind| *kind != 0) {
        planes.extend(kinds);
    }
    Ok(lz4_flex::block::compress(&planes))
}

/// The inverse of [`pack_chunk`]: [`CHUNK_SAMPLES`] samples.
///
/// # Errors
/// A sentence, if `packed` is not what [`pack_chunk`] makes.
pub fn unpack_chunk(packed: &[u8]) -> Result<Vec<i16>, String> {
    match unpack_ground(packed)? {
        (samples, kinds) if kinds.is_empty() => Ok(samples),
        _ => Err(Fault::Length.to_string()),
    }
}

/// The inverse of [`pack_ground`]: [`CHUNK_SAMPLES`] samples, and as many bytes of kinds or none.
///
/// # Errors
/// A sentence, if `packed` is not what [`pack_ground`] makes.
pub fn unpack_ground(packed: &[u8]) -> Result<StoredGround, String> {
    let mut planes = vec![0; 3 * CHUNK_SAMPLES];
    let length = lz4_flex::block::decompress_into(packed, &mut planes)
        .map_err(|_| Fault::Contents.to_string())?;
    if length % CHUNK_SAMPLES != 0 || length < 2 * CHUNK_SAMPLES {
        return Err(Fault::Length.to_string());
    }
    planes.truncate(length);
    let kinds = planes.split_off(2 * CHUNK_SAMPLES);
    let (low, high) = planes.split_at(CHUNK_SAMPLES);
    let mut previous = 0_i16;
    let samples = low.iter().zip(high).map(|(&low, &high)| {
        let zigzag = u16::from_le_bytes([low, high]);
        let residual = (zigzag >> 1) as i16 ^ -((zigzag & 1) as i16);
        previous = previous.wrapping_add(residual);
        previous
    });
    Ok((samples.collect(), kinds))
}

#[cfg(test)]
mod tests {
    #![allow(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        reason = "tests fail by panicking"
    )]

    use super::*;
    use proptest::prelude::*;

    /// What strokes of a brush leave: `amount exp(-0.1 d^2)` within `radius`, in steps of 1/256.
    fn brushed(strokes: &[[f64; 3]], radius: f64, amount: f64) -> Vec<i16> {
        let mut samples = vec![0_i16; CHUNK_SAMPLES];
        for (index, sample) in samples.iter_mut().enumerate() {
            let p = [index % 32, index / 32 % 32, index / 1024].map(|i| i as f64);
            for centre in strokes {
                let d2: f64 = p.iter().zip(centre).map(|(a, b)| (a - b) * (a - b)).sum();
                if d2 <= radius * radius {
                    *sample += (amount * (-0.1 * d2).exp() * 256.0).round() as i16;
                }
            }
        }
        samples
    }

    #[test]
    fn a_brush_edit_fits_in_four_kilobytes_and_an_empty_chunk_in_a_third_of_one() {
        let one = pack_chunk(&brushed(&[[15.3, 16.8, 14.1]], 5.0, 8.0)).unwrap();
        assert!(one.len() <= 2048, "one stroke: {} bytes", one.len());
        let strokes: Vec<_> = (0..6)
            .map(|i| [8.1 + 3.0 * f64::from(i), 14.7, 16.2])
            .collect();
        let tunnel = pack_chunk(&brushed(&strokes, 5.0, 8.0)).unwrap();
        assert!(tunnel.len() <= 4096, "a tunnel: {} bytes", tunnel.len());
        let empty = pack_chunk(&vec![0; CHUNK_SAMPLES]).unwrap();
        assert!(empty.len() <= 300, "nothing: {} bytes", empty.len());
    }

    #[test]
    fn extremes_come_back() {
        let samples: Vec<i16> = (0..CHUNK_SAMPLES)
            .map(|i| [i16::MIN, i16::MAX, 0, -1, 1][i * i % 5])
            .collect();
        assert_eq!(
            unpack_chunk(&pack_chunk(&samples).unwrap()).unwrap(),
            samples
        );
    }

    #[test]
    fn kinds_come_back_cost_nothing_where_there_are_none_and_little_where_there_are() {
        let samples = brushed(&[[15.3, 16.8, 14.1], [20.0, 16.0, 17.0]], 5.0, -8.0);
        let alone = pack_chunk(&samples).unwrap();
        assert_eq!(
            pack_ground(&samples, &vec![0; CHUNK_SAMPLES]).unwrap(),
            alone
        );
        let kinds: Vec<u8> = samples
            .iter()
            .map(|&edit| if edit < -500 { 9 } else { 0 })
            .collect();
        let both = pack_ground(&samples, &kinds).unwrap();
        let more = both.len() - alone.len();
        assert!((100..=1024).contains(&more), "{more} bytes");
        assert_eq!(unpack_ground(&both).unwrap(), (samples.clone(), kinds));
        assert_eq!(
            unpack_ground(&alone).unwrap(),
            (samples.clone(), Vec::new())
        );
        assert!(unpack_chunk(&both).is_err(), "kinds are not lost unsaid");
        assert!(
            pack_ground(&samples, &[1; 7])
                .unwrap_err()
                .contains("not 7")
        );
    }

    #[test]
    fn wrong_lengths_are_refused() {
        assert!(pack_chunk(&[0; 5]).unwrap_err().contains("not 5"));
        assert!(unpack_chunk(&lz4_flex::block::compress(&[0; 100])).is_err());
        assert!(unpack_chunk(&lz4_flex::block::compress(&vec![0; 70_000])).is_err());
        assert!(unpack_ground(&lz4_flex::block::compress(&vec![0; 32_768])).is_err());
        assert!(unpack_chunk(&[]).is_err());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn any_samples_come_back(values in prop::collection::vec(any::<i16>(), 1..400)) {
            let samples: Vec<i16> = values.iter().copied().cycle().take(CHUNK_SAMPLES).collect();
            prop_assert_eq!(unpack_chunk(&pack_chunk(&samples).unwrap()).unwrap(), samples);
        }

        #[test]
        fn any_bytes_are_refused_without_a_panic(bytes in prop::collection::vec(any::<u8>(), 0..500)) {
            prop_assert!(unpack_chunk(&bytes).is_err());
        }
    }
}
