//! The log's files: one is written until it is full, and the last few are kept.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Bytes after which another file is begun: half an hour of a failure in every frame.
const MOST_BYTES: u64 = 4 << 20;
/// Full files that are kept beside the one that is written.
const KEPT: u32 = 3;
const NAME: &str = "antipode";

/// Where logs and reports of crashes are kept; nothing where the platform has no such place.
pub fn folder() -> Option<PathBuf> {
    let folders = directories::ProjectDirs::from("", "", "antipode")?;
    let state = folders.state_dir().unwrap_or(folders.data_local_dir());
    Some(state.join("logs"))
}

/// A file that makes way for another when it is full. The older the file, the greater its number.
#[derive(Debug)]
pub struct RotatingFile {
    folder: PathBuf,
    file: File,
    bytes: u64,
    most_bytes: u64,
}

impl RotatingFile {
    /// Goes on with the newest file in a folder, which is made if need be.
    ///
    /// # Errors
    /// When the folder or the file cannot be made or opened.
    pub fn open(folder: &Path) -> io::Result<Self> {
        Self::with_size(folder, MOST_BYTES)
    }

    fn with_size(folder: &Path, most_bytes: u64) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        let (file, bytes) = newest(folder)?;
        Ok(Self {
            folder: folder.to_owned(),
            file,
            bytes,
            most_bytes,
        })
    }

    /// The file that is written now.
    pub fn path(folder: &Path) -> PathBuf {
        folder.join(format!("{NAME}.log"))
    }

    fn rotate(&mut self) -> io::Result<()> {
        let old = |number: u32| self.folder.join(format!("{NAME}.{number}.log"));
        for number in (1..KEPT).rev() {
            // Files that are not there yet cannot be moved on.
            let _ = fs::rename(old(number), old(number + 1));
        }
        fs::rename(Self::path(&self.folder), old(1))?;
        (self.file, self.bytes) = newest(&self.folder)?;
        Ok(())
    }
}

fn newest(folder: &Path) -> io::Result<(File, u64)> {
    let path = RotatingFile::path(folder);
    let file = OpenOptions::new().create(true).append(true).open(path)?;
    let bytes = file.metadata()?.len();
    Ok((file, bytes))
}

impl Write for RotatingFile {
    fn write(&mut self, line: &[u8]) -> io::Result<usize> {
        if self.bytes > 0 && self.bytes + line.len() as u64 > self.most_bytes {
            // A file that cannot make way is written on.
            let _ = self.rotate();
        }
        let written = self.file.write(line)?;
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn full_files_make_way_and_the_oldest_goes() {
        let folder = tempfile::tempdir().unwrap();
        let mut log = RotatingFile::with_size(folder.path(), 100).unwrap();
        for number in 0..60 {
            writeln!(log, "line {number:02} of nineteen").unwrap();
        }
        drop(log);
        let text = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(text("antipode.log").ends_with("line 59 of nineteen\n"));
        let files = fs::read_dir(folder.path()).unwrap().flatten();
        let sizes: Vec<u64> = files.map(|f| f.metadata().unwrap().len()).collect();
        assert_eq!(sizes.len(), 1 + KEPT as usize);
        assert!(sizes.iter().all(|&bytes| bytes <= 100), "{sizes:?}");
        // What comes later goes on where it stopped.
        let mut log = RotatingFile::with_size(folder.path(), 1000).unwrap();
        writeln!(log, "another day").unwrap();
        assert!(text("antipode.log").contains("line 59 of nineteen\nanother day\n"));
        assert!(text("antipode.1.log") < text("antipode.log"));
    }
}
