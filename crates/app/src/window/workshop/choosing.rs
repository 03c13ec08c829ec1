//! A file chosen from the disk: folders are read on a thread, and only what the workshop can take in is shown.
//!
//! It is our own since no library fits: `rfd` shows nothing where there is neither a portal nor zenity, and egui-file-dialog 0.15 is
//! for another egui than ours.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use antipode_language::{Texts, Value};
use antipode_ui::legible;
use antipode_ui::workshop::{ChooserEntry, ChooserModel, ChooserWish};

use crate::window::background::{Progress, Task};
use crate::window::placelist::size;

/// What rooms can take in, by the endings of names.
const ENDINGS: [&str; 7] = ["glb", "gltf", "fbx", "obj", "png", "jpg", "jpeg"];
/// Most lines that are shown of a folder.
const MOST: usize = 500;

/// A folder or a file in a folder.
#[derive(Clone, Debug, PartialEq)]
struct Entry {
    name: OsString,
    /// Its size, if it is a file.
    bytes: Option<u64>,
}

/// What a path leads to.
#[derive(Debug, PartialEq)]
enum Found {
    /// A folder, what of it is shown, and how much there is.
    Folder(PathBuf, Vec<Entry>, usize),
    /// A file that can be taken in.
    File(PathBuf),
    /// A file that cannot.
    OtherFile(PathBuf),
    /// Nothing that could be read, for that reason.
    Nothing(PathBuf, String),
}

/// A file that is being chosen.
#[derive(Debug)]
pub struct Choosing {
    folder: PathBuf,
    entries: Vec<Entry>,
    task: Option<Task<Found>>,
    /// What the last look found that is no folder.
    problem: Option<Found>,
    count: usize,
    home: Option<PathBuf>,
    /// What is shown, until something changes.
    shown: Option<ChooserModel>,
}

impl Choosing {
    /// Begins in a folder.
    pub fn begin(folder: PathBuf) -> Self {
        let home = directories::UserDirs::new().map(|user| user.home_dir().to_path_buf());
        let mut choosing = Self {
            folder: folder.clone(),
            entries: Vec::new(),
            task: None,
            problem: None,
            count: 0,
            home,
            shown: None,
        };
        choosing.look(folder);
        choosing
    }

    /// Where one chooses first: where the player keeps documents, or lives.
    pub fn usual_folder() -> PathBuf {
        let user = directories::UserDirs::new();
        let documents = user.as_ref().and_then(|user| user.document_dir());
        let documents = documents.filter(|it| it.is_dir());
        let home = user.as_ref().map(|user| user.home_dir().to_path_buf());
        let found = documents.map(Path::to_path_buf).or(home);
        found.unwrap_or_else(|| PathBuf::from("/"))
    }

    /// Whether nothing is being read.
    pub fn rests(&self) -> bool {
        self.task.is_none()
    }

    /// The folder that is shown.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Does what is asked for. Returns whether it is over.
    pub fn follow(&mut self, wish: &ChooserWish) -> bool {
        match wish {
            ChooserWish::Open(name) => {
                let entry = self.entries.iter().find(|it| said(&it.name) == *name);
                if let Some(path) = entry.map(|it| self.folder.join(&it.name)) {
                    self.look(path);
                }
            }
            ChooserWish::Go(typed) => {
                let path = self.meant(typed);
                self.look(path);
            }
            ChooserWish::Up => {
                if let Some(up) = self.folder.parent().map(Path::to_path_buf) {
                    self.look(up);
                }
            }
            ChooserWish::Home => {
                if let Some(home) = self.home.clone() {
                    self.look(home);
                }
            }
            ChooserWish::Close => return true,
        }
        false
    }

    /// The path that is meant by what was typed: quotes do not count, `~` is home, and the rest begins in the folder that is shown.
    fn meant(&self, typed: &str) -> PathBuf {
        let typed = typed.trim();
        let bare = ['"', '\'']
            .into_iter()
            .find_map(|mark| typed.strip_prefix(mark)?.strip_suffix(mark));
        let path = Path::new(bare.unwrap_or(typed));
        match (path.strip_prefix("~"), &self.home) {
            (Ok(rest), Some(home)) => home.join(rest),
            _ => self.folder.join(path),
        }
    }

    /// Has a thread look where a path leads.
    fn look(&mut self, path: PathBuf) {
        self.shown = None;
        self.task = Some(Task::start("choose", move || look(path)));
    }

    /// Takes in what was found. Returns a file that was chosen.
    pub fn pass(&mut self) -> Option<PathBuf> {
        let found = match self.task.as_ref()?.poll() {
            Progress::Running => return None,
            Progress::Done(found) => Some(found),
            Progress::Died => None,
        };
        (self.task, self.shown, self.problem) = (None, None, None);
        match found? {
            Found::File(path) => return Some(path),
            Found::Folder(folder, entries, count) => {
                (self.folder, self.entries, self.count) = (folder, entries, count);
            }
            problem => self.problem = Some(problem),
        }
        None
    }

    /// What the page shows.
    pub fn model(&mut self, texts: &Texts) -> &ChooserModel {
        if self.shown.is_none() {
            self.shown = Some(self.made(texts));
        }
        self.shown.get_or_insert_default()
    }

    fn made(&self, texts: &Texts) -> ChooserModel {
        let entry = |it: &Entry| ChooserEntry {
            name: said(&it.name),
            is_folder: it.bytes.is_none(),
            about: match it.bytes {
                Some(bytes) => size(texts, bytes),
                None => texts.say("workshop-chooser-folder"),
            },
        };
        ChooserModel {
            folder: self.folder.display().to_string(),
            entries: self.entries.iter().map(entry).collect(),
            problem: problem(texts, self.problem.as_ref(), self.count),
            is_reading: self.task.is_some(),
        }
    }
}

/// What is wrong, in a sentence.
fn problem(texts: &Texts, found: Option<&Found>, count: usize) -> Option<String> {
    let path = |path: &Path| Value::from(path.display().to_string());
    match found {
        Some(Found::Nothing(at, why)) => {
            let values = [("path", path(at)), ("reason", why.as_str().into())];
            Some(texts.say_with("workshop-chooser-unread", &values))
        }
        Some(Found::OtherFile(at)) => {
            Some(texts.say_with("workshop-chooser-unfit", &[("path", path(at))]))
        }
        _ if count > MOST => {
            let values = [("shown", MOST.into()), ("count", count.into())];
            Some(texts.say_with("workshop-chooser-many", &values))
        }
        _ => None,
    }
}

fn said(name: &std::ffi::OsStr) -> String {
    legible(&name.to_string_lossy()).into_owned()
}

fn fits(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    ENDINGS.iter().any(|it| ending == *it)
}

/// Looks where a path leads. Waits for the disk.
fn look(path: PathBuf) -> Found {
    let told = match fs::metadata(&path) {
        Ok(told) => told,
        Err(why) => return Found::Nothing(path, why.to_string()),
    };
    if !told.is_dir() {
        return if fits(&path) {
            Found::File(path)
        } else {
            Found::OtherFile(path)
        };
    }
    let all = match fs::read_dir(&path) {
        Ok(all) => all,
        Err(why) => return Found::Nothing(path, why.to_string()),
    };
    let mut entries: Vec<_> = all.flatten().filter_map(|it| entry(&it)).collect();
    entries.sort_by_cached_key(|it| (it.bytes.is_some(), said(&it.name).to_lowercase()));
    let count = entries.len();
    entries.truncate(MOST);
    let path = path.canonicalize().unwrap_or(path);
    Found::Folder(path, entries, count)
}

/// A line of a folder; none where it is hidden or does not fit.
fn entry(it: &fs::DirEntry) -> Option<Entry> {
    let name = it.file_name();
    if name.to_string_lossy().starts_with('.') {
        return None;
    }
    // A link is what it leads to.
    let told = fs::metadata(it.path()).ok()?;
    let is_shown = told.is_dir() || fits(&it.path());
    is_shown.then_some(Entry {
        name,
        bytes: (!told.is_dir()).then_some(told.len()),
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    fn settle(choosing: &mut Choosing) -> Option<PathBuf> {
        let found = choosing.task.take().unwrap().finish().unwrap();
        choosing.task = Some(Task::start("test", move || found));
        loop {
            let chosen = choosing.pass();
            if chosen.is_some() || choosing.rests() {
                return chosen;
            }
            std::thread::yield_now();
        }
    }

    fn names(choosing: &mut Choosing) -> Vec<String> {
        let model = choosing.model(&Texts::default());
        model.entries.iter().map(|it| it.name.clone()).collect()
    }

    #[test]
    fn folders_come_first_and_only_files_that_fit_and_the_way_leads_in_out_and_to_a_file() {
        let dir = tempfile::tempdir().unwrap();
        let place = dir.path().canonicalize().unwrap();
        for folder in ["zoo", ".hidden"] {
            fs::create_dir(place.join(folder)).unwrap();
        }
        for file in ["b.PNG", "a.glb", "notes.txt", ".x.png", "zoo/chair.obj"] {
            fs::write(place.join(file), "x").unwrap();
        }
        let mut choosing = Choosing::begin(place.clone());
        assert_eq!(settle(&mut choosing), None);
        assert_eq!(names(&mut choosing), ["zoo", "a.glb", "b.PNG"]);
        choosing.follow(&ChooserWish::Open("zoo".to_owned()));
        assert_eq!(settle(&mut choosing), None);
        assert_eq!(names(&mut choosing), ["chair.obj"]);
        choosing.follow(&ChooserWish::Up);
        assert_eq!(settle(&mut choosing), None);
        assert_eq!(choosing.folder(), place);
        choosing.follow(&ChooserWish::Go("'zoo/chair.obj'".to_owned()));
        assert_eq!(settle(&mut choosing), Some(place.join("zoo/chair.obj")));
        assert!(choosing.follow(&ChooserWish::Close));
    }

    #[test]
    fn what_cannot_be_read_or_taken_is_said_and_the_folder_stays() {
        let dir = tempfile::tempdir().unwrap();
        let place = dir.path().canonicalize().unwrap();
        fs::write(place.join("a.png"), "x").unwrap();
        fs::write(place.join("notes.txt"), "x").unwrap();
        let mut choosing = Choosing::begin(place);
        settle(&mut choosing);
        for (typed, wanted) in [("nowhere", "nowhere"), ("notes.txt", "glb")] {
            choosing.follow(&ChooserWish::Go(typed.to_owned()));
            assert_eq!(settle(&mut choosing), None);
            let said = choosing.model(&Texts::default()).problem.clone().unwrap();
            assert!(said.contains(wanted), "{said}");
            assert_eq!(names(&mut choosing), ["a.png"]);
        }
    }

    #[test]
    fn of_a_large_folder_so_many_are_shown_and_it_says_so() {
        let dir = tempfile::tempdir().unwrap();
        for number in 0..=MOST {
            fs::write(dir.path().join(format!("{number}.png")), "x").unwrap();
        }
        let mut choosing = Choosing::begin(dir.path().to_path_buf());
        settle(&mut choosing);
        assert_eq!(names(&mut choosing).len(), MOST);
        let said = choosing.model(&Texts::default()).problem.clone().unwrap();
        assert!(said.contains("501"), "{said}");
    }
}
