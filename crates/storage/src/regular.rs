//! What stands at a path, asked before anything is opened: opening a pipe waits for
//! ever, and a device has no end. Links are followed.

use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// What stands at a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Entry {
    /// Nothing.
    Missing,
    /// A regular file.
    File {
        /// Its length.
        bytes: u64,
    },
    /// Something else, in words with their article.
    Other(&'static str),
}

impl Entry {
    /// Looks without opening.
    pub(crate) fn at(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(data) if data.is_file() => Ok(Self::File { bytes: data.len() }),
            Ok(data) if data.is_dir() => Ok(Self::Other("a directory")),
            Ok(_) => Ok(Self::Other("a pipe, a socket or a device")),
            Err(_) if fs::symlink_metadata(path).is_ok_and(|data| data.is_symlink()) => {
                Ok(Self::Other("a link that leads nowhere"))
            }
            Err(error) if is_absent(&error) => Ok(Self::Missing),
            Err(error) => Err(error),
        }
    }
}

/// Whether an error says that there is nothing of that name.
pub(crate) fn is_absent(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory)
}

/// Opens a regular file for reading; its length comes with it. Anything else is
/// [`ErrorKind::InvalidInput`], in words.
pub(crate) fn open(path: &Path) -> io::Result<(File, u64)> {
    match Entry::at(path)? {
        Entry::File { .. } => {
            let file = File::open(path)?;
            let bytes = file.metadata()?.len();
            Ok((file, bytes))
        }
        Entry::Missing => Err(ErrorKind::NotFound.into()),
        Entry::Other(kind) => Err(io::Error::new(
            ErrorKind::InvalidInput,
            format!("it is {kind}, not a file"),
        )),
    }
}

/// Reads a regular file as [`read`] does, but not through a link.
pub(crate) fn read_own(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let named = fs::symlink_metadata(path)?;
    let (file, length) = open(path)?;
    // Compared after opening, since what stands there may change in between.
    if named.is_symlink() || FileId::of(&named) != FileId::of(&file.metadata()?) {
        return Err(io::Error::new(
            ErrorKind::InvalidInput,
            "it is a link, not a file",
        ));
    }
    read_from(file, length, limit)
}

/// Reads a regular file of at most `limit` bytes as a whole; a longer one is
/// [`ErrorKind::InvalidData`], in words.
pub(crate) fn read(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    let (file, length) = open(path)?;
    read_from(file, length, limit)
}

fn read_from(file: File, length: u64, limit: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    if length <= limit {
        file.take(limit + 1).read_to_end(&mut bytes)?;
    }
    let length = length.max(bytes.len() as u64);
    if length <= limit {
        Ok(bytes)
    } else {
        Err(io::Error::new(
            ErrorKind::InvalidData,
            format!("it has {length} bytes, and at most {limit} make sense"),
        ))
    }
}

/// Which file it is, whatever it is called: device and inode, where there are such.
/// Elsewhere all files are alike, and only their being there can be compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct FileId {
    #[cfg(unix)]
    device: u64,
    #[cfg(unix)]
    inode: u64,
}

impl FileId {
    /// The file that these metadata are of.
    #[cfg(unix)]
    pub(crate) fn of(data: &Metadata) -> Self {
        use std::os::unix::fs::MetadataExt;
        Self {
            device: data.dev(),
            inode: data.ino(),
        }
    }

    /// The file that these metadata are of.
    #[cfg(not(unix))]
    pub(crate) fn of(_: &Metadata) -> Self {
        Self {}
    }

    /// The file at `path`; `None` if there is none.
    pub(crate) fn at(path: &Path) -> io::Result<Option<Self>> {
        match fs::metadata(path) {
            Ok(data) => Ok(data.is_file().then(|| Self::of(&data))),
            Err(error) if is_absent(&error) => Ok(None),
            Err(error) => Err(error),
        }
    }
}

/// Whether an open file is what stands at `path` now.
pub(crate) fn is_named(file: &File, path: &Path) -> bool {
    let same = || io::Result::Ok(FileId::at(path)? == Some(FileId::of(&file.metadata()?)));
    same().unwrap_or(false)
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

    #[test]
    fn entries_are_told_apart_without_being_opened() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join("file");
        fs::write(&file, b"12345").unwrap();
        let at = |path: &Path| Entry::at(path).unwrap();
        assert_eq!(at(&file), Entry::File { bytes: 5 });
        assert_eq!(at(dir.path()), Entry::Other("a directory"));
        assert_eq!(at(&dir.path().join("none")), Entry::Missing);
        assert_eq!(at(&file.join("below")), Entry::Missing);
        assert!(open(dir.path()).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_devices_refused() {
        let dir = tempfile::tempdir().unwrap();
        let link = |name: &str, to: &str| {
            let path = dir.path().join(name);
            std::os::unix::fs::symlink(to, &path).unwrap();
            path
        };
        fs::write(dir.path().join("file"), b"12").unwrap();
        assert_eq!(
            Entry::at(&link("a", "file")).unwrap(),
            Entry::File { bytes: 2 }
        );
        assert_eq!(
            Entry::at(&link("b", "none")).unwrap(),
            Entry::Other("a link that leads nowhere")
        );
        let refusal = read(&link("c", "/dev/zero"), 9).unwrap_err().to_string();
        assert_eq!(refusal, "it is a pipe, a socket or a device, not a file");
        assert_eq!(
            FileId::at(&dir.path().join("a")).unwrap(),
            FileId::at(&dir.path().join("file")).unwrap()
        );
    }

    #[test]
    fn files_longer_than_the_limit_are_not_read() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("file");
        fs::write(&path, b"12345").unwrap();
        assert_eq!(read(&path, 5).unwrap(), b"12345");
        let refusal = read(&path, 4).unwrap_err();
        assert_eq!(refusal.kind(), ErrorKind::InvalidData);
        // As long as no memory has: reading it would show.
        File::create(&path).unwrap().set_len(1 << 40).unwrap();
        assert!(read(&path, 4).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn a_file_in_the_place_of_another_is_another() {
        let dir = tempfile::tempdir().unwrap();
        let [path, other] = ["a", "b"].map(|name| dir.path().join(name));
        fs::write(&path, b"x").unwrap();
        fs::write(&other, b"x").unwrap();
        let first = FileId::at(&path).unwrap();
        assert_eq!(FileId::at(&path).unwrap(), first);
        fs::rename(&other, &path).unwrap();
        assert_ne!(FileId::at(&path).unwrap(), first);
        fs::remove_file(&path).unwrap();
        assert_eq!(FileId::at(&path).unwrap(), None);
    }
}
