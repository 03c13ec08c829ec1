//! Packs a world or a room into one file, to keep or to give away, and unpacks it.
//!
//! Layout, little-endian: eight bytes of the kind (`ANTIPODE` for worlds), container version u16, number of files
//! u8; per file: length of its name u8, name, length u64, blocks of at most 1 MiB,
//! each: length u32, packed length u32, CRC-32 of the packed bytes, LZ4 block. Then the
//! mark `END.`. Only the file names that the kind has are believed, so an archive
//! cannot write anywhere else.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read, Write};
use std::path::Path;

use crate::error::StorageError;
use crate::regular::{self, Entry};
use crate::{MAX_THUMBNAIL_BYTES, THUMBNAIL_FILE, WORLD_FILE};

const CONTAINER_VERSION: u16 = 1;
const END: [u8; 4] = *b"END.";
const BLOCK_BYTES: usize = 1 << 20;

/// What archives of one kind hold, and how much of it.
#[derive(Debug, Clone, Copy)]
pub struct ArchiveKind {
    /// The first bytes of each.
    pub magic: [u8; 8],
    /// What is in one, in a word.
    pub noun: &'static str,
    /// The longest archive, bytes.
    pub most_bytes: u64,
    /// How long a file of this name may be; nothing if there is no such file. Folders are parted by `/`; a name that is
    /// taken here is made below the folder that an archive is unpacked into, so it may not lead out of it.
    pub most_file_bytes: fn(&str) -> Option<u64>,
    /// How much an archive of so many bytes may unpack to.
    pub most_unpacked_bytes: fn(u64) -> u64,
}

/// Worlds.
pub(crate) const WORLDS: ArchiveKind = ArchiveKind {
    magic: *b"ANTIPODE",
    noun: "world",
    most_bytes: u64::MAX,
    most_file_bytes: |name| {
        FILES
            .into_iter()
            .find(|(file, _)| *file == name)
            .map(|(_, most)| most)
    },
    most_unpacked_bytes: |length| {
        MOST_EXPANSION
            .saturating_mul(length)
            .saturating_add(FREE_EXPANSION_BYTES)
    },
};
/// The files of a world and how long each may be; more than the longest world keeps a
/// small archive from filling the disk with zeros.
const FILES: [(&str, u64); 2] = [(WORLD_FILE, 1 << 36), (THUMBNAIL_FILE, MAX_THUMBNAIL_BYTES)];
/// Their names.
pub(crate) const WORLD_FILES: [&str; 2] = [WORLD_FILE, THUMBNAIL_FILE];

/// How much an archive may unpack to: this, and [`MOST_EXPANSION`] times its own length.
/// A store of a single edit is mostly empty pages, one of many is not; LZ4 alone would
/// let a megabyte of nothing become a quarter of a gigabyte.
const FREE_EXPANSION_BYTES: u64 = 64 << 20;
/// See [`FREE_EXPANSION_BYTES`]. Stores of densely edited chunks pack about 1.5 to 1.
const MOST_EXPANSION: u64 = 32;

/// Writes those of the files `names` that are in `dir`, which nobody else may be writing to, into `archive`,
/// which must not exist. A failure leaves no archive.
///
/// # Errors
/// [`StorageError::Archive`] for more files or bytes than the kind allows, failures of the file system.
pub fn pack(
    kind: &ArchiveKind,
    dir: &Path,
    names: &[&str],
    archive: &Path,
) -> Result<(), StorageError> {
    let out = StorageError::at("Making", archive, File::create_new(archive))?;
    let packed = pack_into(kind, dir, names, archive, out);
    if packed.is_err() {
        let _ = std::fs::remove_file(archive);
    }
    packed
}

fn pack_into(
    kind: &ArchiveKind,
    dir: &Path,
    names: &[&str],
    archive: &Path,
    out: File,
) -> Result<(), StorageError> {
    let refuse = |reason: String| StorageError::Archive {
        path: archive.to_path_buf(),
        reason,
    };
    let mut out = BufWriter::new(out);
    let present: Vec<_> = names
        .iter()
        .filter_map(|name| Some((*name, (kind.most_file_bytes)(name)?)))
        .filter(|(file, most)| {
            matches!(Entry::at(&dir.join(file)), Ok(Entry::File { bytes }) if bytes <= *most)
        })
        .collect();
    let count = u8::try_from(present.len())
        .map_err(|_| refuse("it would hold more than 255 files".to_owned()))?;
    let writing = |result: io::Result<()>| StorageError::at("Writing", archive, result);
    writing(out.write_all(&kind.magic))?;
    writing(out.write_all(&CONTAINER_VERSION.to_le_bytes()))?;
    writing(out.write_all(&[count]))?;
    for (name, most) in present {
        let path = dir.join(name);
        let (file, length) = StorageError::at("Reading", &path, regular::open(&path))?;
        if length > most {
            return Err(StorageError::unreadable(&path, "it grew while it was read"));
        }
        writing(pack_file(&mut out, name, length, BufReader::new(file)))?;
    }
    writing(out.write_all(&END))?;
    writing(out.flush())?;
    writing(out.get_ref().sync_all())?;
    let length = StorageError::at("Writing", archive, out.get_ref().metadata())?.len();
    if length > kind.most_bytes {
        return Err(refuse(format!(
            "it would have {length} bytes, and a {} has at most {}",
            kind.noun, kind.most_bytes
        )));
    }
    Ok(())
}

/// Packs one file of `length` bytes; [`io::ErrorKind::UnexpectedEof`] if there are fewer.
fn pack_file(out: &mut impl Write, name: &str, length: u64, mut file: impl Read) -> io::Result<()> {
    out.write_all(&[name.len() as u8])?;
    out.write_all(name.as_bytes())?;
    out.write_all(&length.to_le_bytes())?;
    let mut block = vec![0; BLOCK_BYTES];
    let mut left = length;
    while left > 0 {
        let block = &mut block[..left.min(BLOCK_BYTES as u64) as usize];
        file.read_exact(block)?;
        left -= block.len() as u64;
        let packed = lz4_flex::block::compress(block);
        for number in [
            block.len() as u32,
            packed.len() as u32,
            crc32fast::hash(&packed),
        ] {
            out.write_all(&number.to_le_bytes())?;
        }
        out.write_all(&packed)?;
    }
    Ok(())
}

/// Unpacks `archive` into the empty directory `dir`, and tells the names of the files.
///
/// # Errors
/// [`StorageError::Archive`] with what is wrong with it, failures of the file system.
pub fn unpack(kind: &ArchiveKind, archive: &Path, dir: &Path) -> Result<Vec<String>, StorageError> {
    let mut input = Input::open(kind, archive)?;
    if input.bytes::<8>()? != kind.magic {
        return Err(input.refuse(&format!("it is no exported {}", kind.noun)));
    }
    let version = u16::from_le_bytes(input.bytes()?);
    if version == 0 {
        return Err(input.refuse("its format 0 was never used, so it is damaged"));
    }
    if version != CONTAINER_VERSION {
        return Err(input.refuse(&format!(
            "it was exported by a newer version of the game (format {version}); update the game first"
        )));
    }
    let [count] = input.bytes()?;
    let mut seen: Vec<String> = Vec::new();
    for _ in 0..count {
        let (name, most) = input.name()?;
        // Letters of both cases are one on some systems.
        if seen.iter().any(|other| other.eq_ignore_ascii_case(&name)) {
            return Err(input.refuse(&format!("it holds the file \"{name}\" twice")));
        }
        let path = dir.join(&name);
        let beside = path.parent().unwrap_or(dir);
        StorageError::at("Making", beside, std::fs::create_dir_all(beside))?;
        let out = StorageError::at("Making", &path, File::create_new(&path))?;
        input.file(&path, most, out)?;
        seen.push(name);
    }
    if input.bytes::<4>()? != END || input.reader.read(&mut [0]).unwrap_or(1) != 0 {
        return Err(input.refuse("it does not end where it should"));
    }
    Ok(seen)
}

/// An archive being read.
struct Input<'a> {
    kind: &'a ArchiveKind,
    archive: &'a Path,
    reader: BufReader<File>,
    /// Bytes that may still be unpacked.
    budget: u64,
}

impl<'a> Input<'a> {
    fn open(kind: &'a ArchiveKind, archive: &'a Path) -> Result<Self, StorageError> {
        let refuse = |reason: &str| StorageError::Archive {
            path: archive.to_path_buf(),
            reason: reason.to_owned(),
        };
        let (file, length) = regular::open(archive).map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => refuse("there is no such file"),
            io::ErrorKind::InvalidInput => refuse(&error.to_string()),
            _ => StorageError::io("Reading", archive, error),
        })?;
        if length > kind.most_bytes {
            let noun = kind.noun;
            return Err(refuse(&format!(
                "it has {length} bytes, and a {noun} has at most {}",
                kind.most_bytes
            )));
        }
        Ok(Self {
            kind,
            archive,
            reader: BufReader::new(file),
            budget: (kind.most_unpacked_bytes)(length),
        })
    }

    fn refuse(&self, reason: &str) -> StorageError {
        StorageError::Archive {
            path: self.archive.to_path_buf(),
            reason: reason.to_owned(),
        }
    }

    fn fill(&mut self, bytes: &mut [u8]) -> Result<(), StorageError> {
        self.reader
            .read_exact(bytes)
            .map_err(|error| match error.kind() {
                io::ErrorKind::UnexpectedEof => {
                    self.refuse("a part of it is missing; copy or download it again")
                }
                _ => StorageError::io("Reading", self.archive, error),
            })
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], StorageError> {
        let mut bytes = [0; N];
        self.fill(&mut bytes)?;
        Ok(bytes)
    }

    /// The name of the next file, and how long it may be.
    fn name(&mut self) -> Result<(String, u64), StorageError> {
        let [length] = self.bytes()?;
        let mut name = vec![0; length as usize];
        self.fill(&mut name)?;
        let name = String::from_utf8_lossy(&name).into_owned();
        if let Some(most) = (self.kind.most_file_bytes)(&name) {
            return Ok((name, most));
        }
        let (name, noun) = (name.escape_debug(), self.kind.noun);
        Err(self.refuse(&format!("it holds a file \"{name}\", which no {noun} has")))
    }

    fn file(&mut self, path: &Path, most: u64, out: File) -> Result<(), StorageError> {
        let mut out = BufWriter::new(out);
        let mut left = u64::from_le_bytes(self.bytes()?);
        if left > most {
            return Err(self.refuse(&format!(
                "a file in it has {left} bytes, and at most {most} make sense"
            )));
        }
        self.budget = self.budget.checked_sub(left).ok_or_else(|| {
            self.refuse(&format!(
                "{left} bytes are said to be packed into it, which no {} of this game does",
                self.kind.noun
            ))
        })?;
        while left > 0 {
            let block = self.block()?;
            left = left
                .checked_sub(block.len() as u64)
                .ok_or_else(|| self.damaged())?;
            StorageError::at("Writing", path, out.write_all(&block))?;
        }
        StorageError::at("Writing", path, out.flush())?;
        StorageError::at("Writing", path, out.get_ref().sync_all())
    }

    fn block(&mut self) -> Result<Vec<u8>, StorageError> {
        let [length, packed_length] = [self.bytes::<4>()?, self.bytes::<4>()?]
            .map(|bytes| u32::from_le_bytes(bytes) as usize);
        let sum = u32::from_le_bytes(self.bytes()?);
        let most = lz4_flex::block::get_maximum_output_size(BLOCK_BYTES);
        if length == 0 || length > BLOCK_BYTES || packed_length > most {
            return Err(self.damaged());
        }
        let mut packed = vec![0; packed_length];
        self.fill(&mut packed)?;
        let mut block = vec![0; length];
        let unpacked = lz4_flex::block::decompress_into(&packed, &mut block).ok();
        if unpacked != Some(length) || crc32fast::hash(&packed) != sum {
            return Err(self.damaged());
        }
        Ok(block)
    }

    fn damaged(&self) -> StorageError {
        self.refuse("it is damaged; copy or download it again")
    }
}

#[cfg(test)]
mod tests;
