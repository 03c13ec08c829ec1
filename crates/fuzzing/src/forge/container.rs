//! Archives of worlds: packing what need not be a world, and giving changed blocks their
//! checksums again.

use std::ops::Range;

const MAGIC: &[u8; 8] = b"ANTIPODE";
const END: &[u8; 4] = b"END.";
const BLOCK: usize = 1 << 20;
/// Magic, version and number of files.
const HEAD: usize = 11;
/// Of a block: its length, its packed length, its checksum.
const BLOCK_HEAD: usize = 12;

/// An archive of these files.
pub fn pack(files: &[(&str, &[u8])]) -> Vec<u8> {
    let mut bytes = [MAGIC.as_slice(), &[1, 0, files.len() as u8]].concat();
    for (name, contents) in files {
        bytes.push(name.len() as u8);
        bytes.extend(name.as_bytes());
        bytes.extend((contents.len() as u64).to_le_bytes());
        for block in contents.chunks(BLOCK) {
            let packed = lz4_flex::block::compress(block);
            for number in [
                block.len() as u32,
                packed.len() as u32,
                crc32fast::hash(&packed),
            ] {
                bytes.extend(number.to_le_bytes());
            }
            bytes.extend(packed);
        }
    }
    bytes.extend(END);
    bytes
}

/// What stands in an archive besides packed bytes, as far as it can be followed; whether
/// that is to its end.
fn walk(bytes: &[u8]) -> (Vec<Range<usize>>, Vec<Range<usize>>, bool) {
    let mut heads: Vec<_> = std::iter::once(0..HEAD.min(bytes.len())).collect();
    let mut blocks = Vec::new();
    let mut at = HEAD;
    let whole = (|| {
        for _ in 0..*bytes.get(HEAD - 1)? {
            let length_at = at + 1 + usize::from(*bytes.get(at)?);
            let mut left = u64::from_le_bytes(*bytes.get(length_at..)?.first_chunk()?);
            heads.push(at..length_at + 8);
            at = length_at + 8;
            while left > 0 {
                let number = |at: usize| Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?));
                let packed = at + BLOCK_HEAD..at + BLOCK_HEAD + number(at + 4)? as usize;
                left = left.checked_sub(u64::from(number(at)?).max(1))?;
                bytes.get(packed.clone())?;
                heads.push(at..at + BLOCK_HEAD);
                at = packed.end;
                blocks.push(packed);
            }
        }
        heads.push(at..at + END.len());
        (bytes.get(at..)? == END).then_some(())
    })();
    (heads, blocks, whole.is_some())
}

/// Places of an archive that are no packed bytes.
pub fn heads(bytes: &[u8]) -> Vec<Range<usize>> {
    let (mut heads, _, _) = walk(bytes);
    heads.retain(|head| head.end <= bytes.len());
    heads
}

/// Gives every block its checksum.
pub fn seal(bytes: &mut [u8]) {
    for block in walk(bytes).1 {
        let sum = crc32fast::hash(&bytes[block.clone()]).to_le_bytes();
        bytes[block.start - 4..block.start].copy_from_slice(&sum);
    }
}

/// Whether an archive can be followed to its end and every block has its checksum.
pub fn is_sealed(bytes: &[u8]) -> bool {
    let (_, blocks, whole) = walk(bytes);
    whole
        && blocks.into_iter().all(|block| {
            let sum = crc32fast::hash(&bytes[block.clone()]).to_le_bytes();
            bytes[block.start - 4..block.start] == sum
        })
}
