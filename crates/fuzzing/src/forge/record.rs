//! Sealed records: finding them, and giving them their checksum again.

use std::ops::Range;

/// Bytes before the key.
pub const HEADER: usize = 22;
const SUM: Range<usize> = 18..22;
/// Where the number of the commit stands.
pub const SEQUENCE: Range<usize> = 10..18;
const LONGEST_BODY: usize = 1 << 20;

/// How long the record says it is, if it begins like one and fits.
pub fn length(bytes: &[u8]) -> Option<usize> {
    let header = bytes.get(..HEADER)?;
    if header[2..4] != *b"Ap" {
        return None;
    }
    let body = u32::from_le_bytes([header[6], header[7], header[8], header[9]]) as usize;
    let length = HEADER + usize::from(header[5]) + body;
    (body <= LONGEST_BODY && length <= bytes.len()).then_some(length)
}

/// The checksum that a record should have.
fn sum(record: &[u8]) -> [u8; 4] {
    let mut crc = crc32fast::Hasher::new();
    crc.update(&record[..SUM.start]);
    crc.update(&record[SUM.end..]);
    crc.finalize().to_le_bytes()
}

/// Gives the record that `bytes` begin with its checksum; whether there is one.
pub fn seal(bytes: &mut [u8]) -> bool {
    let Some(length) = length(bytes) else {
        return false;
    };
    let sum = sum(&bytes[..length]);
    bytes[SUM].copy_from_slice(&sum);
    true
}

/// Whether `bytes` begin with a record that has its checksum.
pub fn is_sealed(bytes: &[u8]) -> bool {
    length(bytes).is_some_and(|length| bytes[SUM] == sum(&bytes[..length]))
}

/// Where every sealed record of a file stands.
pub fn records(bytes: &[u8]) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(offset) = bytes
        .get(at + 2..)
        .and_then(|rest| rest.windows(2).position(|pair| pair == b"Ap"))
    {
        let start = at + offset;
        match length(&bytes[start..]).filter(|_| is_sealed(&bytes[start..])) {
            Some(length) => {
                found.push(start..start + length);
                at = start + length;
            }
            None => at = start + 1,
        }
    }
    found
}
