//! Reads the sounds that are built in: WAV files, mono, 16 bit, PCM (Microsoft and IBM, 1991).

use thiserror::Error;

/// A sound in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// Samples a second.
    pub rate_hz: u32,
    /// Amplitudes within -1 to 1.
    pub samples: Vec<f32>,
}

/// Why a file is no sound that the game plays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum WavError {
    /// It is no WAV file at all, or ends too soon.
    #[error("the WAV file is incomplete")]
    Broken,
    /// It is one of another kind.
    #[error("the WAV file is not mono PCM with 16 bits")]
    Kind,
}

/// Reads a file.
///
/// # Errors
/// [`WavError`] when it is cut short or of another kind.
pub fn read(bytes: &[u8]) -> Result<Clip, WavError> {
    if bytes.get(..4) != Some(b"RIFF") || bytes.get(8..12) != Some(b"WAVE") {
        return Err(WavError::Broken);
    }
    let mut rate_hz = None;
    let mut rest = &bytes[12..];
    while let Some((head, body)) = rest.split_at_checked(8) {
        let size = word(head, 4)? as usize;
        let content = body.get(..size).ok_or(WavError::Broken)?;
        match &head[..4] {
            b"fmt " => {
                let kind = [half(content, 0)?, half(content, 2)?, half(content, 14)?];
                if kind != [1, 1, 16] {
                    return Err(WavError::Kind);
                }
                rate_hz = Some(word(content, 4)?).filter(|rate| *rate > 0);
            }
            b"data" => {
                let (pairs, _) = content.as_chunks::<2>();
                let samples = pairs
                    .iter()
                    .map(|pair| f32::from(i16::from_le_bytes(*pair)) / 32768.0);
                return Ok(Clip {
                    rate_hz: rate_hz.ok_or(WavError::Kind)?,
                    samples: samples.collect(),
                });
            }
            _ => {}
        }
        // Chunks of odd length are followed by a byte of padding.
        rest = body.get(size + size % 2..).ok_or(WavError::Broken)?;
    }
    Err(WavError::Broken)
}

fn half(bytes: &[u8], at: usize) -> Result<u16, WavError> {
    let found = bytes.get(at..).and_then(|rest| rest.first_chunk());
    found
        .map(|pair| u16::from_le_bytes(*pair))
        .ok_or(WavError::Broken)
}

fn word(bytes: &[u8], at: usize) -> Result<u32, WavError> {
    let found = bytes.get(at..).and_then(|rest| rest.first_chunk());
    found
        .map(|four| u32::from_le_bytes(*four))
        .ok_or(WavError::Broken)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two samples at 8 kHz after a chunk of odd length that nobody knows.
    fn file(channels: u8) -> Vec<u8> {
        let mut file = b"RIFF\0\0\0\0WAVEabcd\x03\0\0\0xyz\0fmt \x10\0\0\0\x01\0".to_vec();
        file.extend([channels, 0, 0x40, 0x1F, 0, 0, 0x80, 0x3E, 0, 0, 2, 0, 16, 0]);
        file.extend(b"data\x04\0\0\0\0\x40\0\x80");
        file
    }

    #[test]
    fn samples_and_rate_are_read_and_unknown_chunks_passed_over() {
        let clip = Clip {
            rate_hz: 8000,
            samples: vec![0.5, -1.0],
        };
        assert_eq!(read(&file(1)), Ok(clip));
    }

    #[test]
    fn what_is_cut_short_or_of_another_kind_is_refused() {
        assert_eq!(read(&file(2)), Err(WavError::Kind));
        let whole = file(1);
        for length in 0..whole.len() {
            assert_eq!(
                read(&whole[..length]),
                Err(WavError::Broken),
                "{length} bytes"
            );
        }
    }
}
