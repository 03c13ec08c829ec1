//! The .glb container: a header of 12 bytes, then chunks of length, kind and data (glTF 2.0, chapter 4).

use crate::error::Error;

const MAGIC: u32 = 0x4654_6C67;
const JSON: u32 = 0x4E4F_534A;
const BIN: u32 = 0x004E_4942;
/// Larger files are refused before anything is read, bytes.
pub const MOST_BYTES: usize = 64 << 20;

/// The file's description and its data, which may be empty.
pub fn split(bytes: &[u8]) -> Result<(&[u8], &[u8]), Error> {
    if bytes.len() > MOST_BYTES {
        return Err(Error::TooMany("bytes"));
    }
    if word(bytes, 0) != Some(MAGIC) {
        return Err(Error::NotGlb);
    }
    let version = word(bytes, 4).ok_or(Error::Truncated)?;
    if version != 2 {
        return Err(Error::Version(version));
    }
    let length = word(bytes, 8).ok_or(Error::Truncated)? as usize;
    let bytes = bytes.get(..length).ok_or(Error::Truncated)?;
    let (kind, json, rest) = chunk(bytes.get(12..).ok_or(Error::Truncated)?)?;
    if kind != JSON {
        return Err(Error::NotGlb);
    }
    if rest.is_empty() {
        return Ok((json, rest));
    }
    let (kind, data, _) = chunk(rest)?;
    Ok((json, if kind == BIN { data } else { &[] }))
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    let four = bytes.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes(four.try_into().ok()?))
}

fn chunk(bytes: &[u8]) -> Result<(u32, &[u8], &[u8]), Error> {
    let length = word(bytes, 0).ok_or(Error::Truncated)? as usize;
    let kind = word(bytes, 4).ok_or(Error::Truncated)?;
    let end = length.checked_add(8).ok_or(Error::Truncated)?;
    let data = bytes.get(8..end).ok_or(Error::Truncated)?;
    Ok((kind, data, bytes.get(end..).unwrap_or(&[])))
}
