//! The menu's lists of worlds and of rooms, and everything that the player can do with them there. Work that may wait for
//! the disk runs on a thread, one job after the other. The menu takes the results when it asks for them.

mod folder;
mod news;
mod pictures;
mod shelf;
#[cfg(test)]
mod tests;
mod words;
mod work;

use std::collections::{HashMap, VecDeque};
use std::path::{Path, PathBuf};

use antipode_language::Texts;
use antipode_storage::{NameError, SavesDir};
use antipode_ui::{ArchiveRow, ToastKind, WorldFiles, WorldRow, WorldsIntent, legible};

use self::folder::FolderProblem;
use self::news::News;
use self::pictures::Pictures;
pub use self::shelf::{Kept, ROOM_PICTURE, RoomShelf, Shelf, room_of};
pub use self::words::size;
use self::work::{Details, FoundFiles, Job, Locations, Outcome};
use super::background::{Progress, Task};
use crate::session::Worlds;

/// The list of worlds.
pub type WorldList = PlaceList<Worlds>;
/// The list of rooms.
pub type RoomList = PlaceList<RoomShelf>;

/// Places of one kind as last read.
#[derive(Debug)]
pub struct PlaceList<S: Shelf> {
    locations: Locations<S>,
    known: Vec<S::Kept>,
    /// The work under way, and what it is.
    task: Option<(Job, Task<Outcome<S::Kept>>)>,
    waiting: VecDeque<Job>,
    /// The list is to be read anew when nothing else waits.
    again: bool,
    /// What a closer look has told, by directory.
    details: HashMap<String, Details>,
    /// Files that exports were to go to and have not, as the player wrote them, by directory.
    unwritten: HashMap<String, String>,
    found: FoundFiles,
    pictures: Pictures,
    folders: Vec<Task<Option<FolderProblem>>>,
    news: VecDeque<News>,
}

impl<S: Shelf> PlaceList<S> {
    /// Nothing read yet.
    pub fn new(shelf: S) -> Self {
        Self {
            locations: Locations::new(shelf),
            known: Vec::new(),
            task: None,
            waiting: VecDeque::new(),
            again: false,
            details: HashMap::new(),
            unwritten: HashMap::new(),
            found: FoundFiles::default(),
            pictures: Pictures::default(),
            folders: Vec::new(),
            news: VecDeque::new(),
        }
    }

    /// Whether nothing is under way.
    pub fn is_idle(&self) -> bool {
        self.task.is_none() && self.folders.is_empty() && self.pictures.is_idle()
    }

    /// Asks for the list to be read anew.
    pub fn refresh(&mut self) {
        self.again = true;
        self.go_on();
    }

    /// Deletes one and reads the list anew. One that cannot be deleted comes back with it.
    pub fn delete(&mut self, slug: String) {
        self.known.retain(|place| place.slug() != slug);
        self.enqueue(Job::Delete { slug });
    }

    /// Does what was asked for.
    pub fn follow(&mut self, intent: WorldsIntent) {
        match intent {
            WorldsIntent::LookAt { slug } => self.enqueue(Job::LookAt { slug }),
            WorldsIntent::Rename { slug, name } => {
                let then = Job::LookAt { slug: slug.clone() };
                self.enqueue(Job::Rename { slug, name });
                self.enqueue(then);
            }
            WorldsIntent::Duplicate { slug } => self.enqueue(Job::Duplicate { slug }),
            WorldsIntent::Export { slug, file } => {
                let then = Job::LookAt { slug: slug.clone() };
                self.unwritten.insert(slug.clone(), file.clone());
                self.enqueue(Job::Export { slug, file });
                self.enqueue(then);
            }
            WorldsIntent::Import { file } => self.enqueue(Job::Import { file }),
            // Where one has looked last, as for the folder of an export.
            WorldsIntent::FindArchives => self.enqueue(Job::FindArchives {
                folder: self.found.folder.clone(),
            }),
            WorldsIntent::FindIn { folder } => {
                let folder = Some(PathBuf::from(folder));
                self.enqueue(Job::FindArchives { folder });
            }
            WorldsIntent::OpenFolder { slug } => {
                let dir = self.locations.dir_of(&slug);
                self.folders
                    .push(Task::start("folder", move || folder::open(&dir).err()));
            }
        }
    }

    fn enqueue(&mut self, job: Job) {
        self.waiting.push_back(job);
        self.go_on();
    }

    /// Starts what is waiting, one piece of work at a time.
    fn go_on(&mut self) {
        if self.task.is_some() {
            return;
        }
        let list = std::mem::take(&mut self.again).then_some(Job::List);
        // What the player asked for goes first; it brings the list with it where it changes that.
        let Some(job) = self.waiting.pop_front().or(list.clone()) else {
            return;
        };
        self.again = list.is_some() && job != Job::List && !job.brings_list();
        let (locations, work) = (self.locations.clone(), job.clone());
        self.task = Some((job, Task::start("saves", move || work.run(&locations))));
    }

    /// Takes finished work in. Never blocks.
    pub fn poll(&mut self) {
        self.pictures.poll();
        let news = &mut self.news;
        self.folders.retain(|task| match task.poll() {
            Progress::Running => true,
            Progress::Done(problem) => {
                news.extend(problem.map(News::Folder));
                false
            }
            Progress::Died => {
                news.push_back(News::WorkDied);
                false
            }
        });
        let Some((job, task)) = &self.task else {
            return;
        };
        match task.poll() {
            Progress::Running => return,
            Progress::Done(outcome) => {
                match (job, &outcome.news) {
                    (Job::Export { slug, .. }, Some(News::Exported(_))) => {
                        self.unwritten.remove(slug);
                    }
                    (Job::Rename { slug, name }, Some(News::Renamed(_))) => {
                        let (slug, name) = (slug.clone(), name.clone());
                        self.call_export(&slug, &name);
                    }
                    _ => {}
                }
                self.take(outcome);
            }
            Progress::Died if *job == Job::List => self.news.push_back(News::ListDied),
            Progress::Died => {
                self.again = true;
                self.news.push_back(News::WorkDied);
            }
        }
        self.task = None;
        self.go_on();
    }

    /// A file that is still to be written goes by the new name, unless the player called it otherwise.
    fn call_export(&mut self, slug: &str, name: &str) {
        let known = self.known.iter().find(|place| place.slug() == slug);
        let offered = known.map(|place| self.locations.export_to(place.name()));
        let free = self.details.get(slug).map(|it| it.export_to.clone());
        let Some(file) = self.unwritten.get_mut(slug) else {
            return;
        };
        let called =
            |offered: &String| Path::new(offered).file_name() == Path::new(&*file).file_name();
        if offered.iter().chain(&free).any(called) {
            let new = PathBuf::from(self.locations.export_to(name));
            let new = new.file_name().unwrap_or_default();
            *file = Path::new(&*file).with_file_name(new).display().to_string();
        }
    }

    fn take(&mut self, outcome: Outcome<S::Kept>) {
        self.news.extend(outcome.news);
        if let Some((slug, details)) = outcome.details {
            self.details.insert(slug, details);
        }
        if let Some(found) = outcome.found {
            self.found = found;
        }
        match outcome.list {
            Some(Ok(mut places)) => {
                places.retain(|place| !self.is_doomed(&place.slug()));
                let is_there = |slug: &String| places.iter().any(|place| place.slug() == *slug);
                self.details.retain(|slug, _| is_there(slug));
                self.unwritten.retain(|slug, _| is_there(slug));
                let shelf = self.locations.shelf();
                let wanted = places.iter();
                let wanted = wanted.map(|place| (place.slug(), shelf.picture(place)));
                self.pictures.want(wanted);
                self.known = places;
            }
            Some(Err(failure)) => self.news.push_back(News::Failed(failure)),
            None => {}
        }
    }

    /// Whether one is still to be deleted; it is not shown any more.
    fn is_doomed(&self, slug: &str) -> bool {
        self.waiting
            .iter()
            .any(|job| matches!(job, Job::Delete { slug: doomed } if doomed == slug))
    }

    /// What has come of the work, in words; each is told once.
    pub fn take_news(&mut self, texts: &Texts) -> Option<(String, ToastKind)> {
        self.news
            .pop_front()
            .map(|news| words::news::<S>(texts, &news, &self.known))
    }

    /// Hands pictures that have been read over to the interface, a few at a time.
    pub fn show_pictures(&mut self, context: &egui::Context) {
        self.pictures.upload(context);
    }

    /// What is being done with one, in words; while it lasts nobody can enter it.
    pub fn work_on(&self, texts: &Texts, slug: &str) -> Option<String> {
        let (job, _) = self.task.as_ref()?;
        if job.slug() == Some(slug) {
            words::work(texts, S::WORDS, job)
        } else {
            None
        }
    }

    /// The rows the menu shows; `running` is the slug of the open one.
    pub fn rows(&self, texts: &Texts, running: Option<&str>) -> Vec<WorldRow> {
        self.known
            .iter()
            .map(|place| {
                let slug = place.slug();
                let mut row = place.row(texts);
                row.running = running == Some(slug.as_str());
                row.picture = self.pictures.of(&slug);
                row.path = self.locations.dir_of(&slug).display().to_string();
                row.export_to = self.locations.export_to(place.name());
                if let Some(details) = self.details.get(&slug) {
                    row.edits = details.edits.or(row.edits);
                    row.export_to.clone_from(&details.export_to);
                }
                if let Some(file) = self.unwritten.get(&slug) {
                    row.export_to.clone_from(file);
                }
                row
            })
            .collect()
    }

    /// What the menu shows of archives, and of the work under way.
    pub fn files(&self, texts: &Texts) -> WorldFiles {
        let archives = self.found.archives.iter().map(|file| ArchiveRow {
            file: file.path.display().to_string(),
            name: file.path.file_name().map_or_else(String::new, |name| {
                legible(&name.to_string_lossy()).into_owned()
            }),
            size: size(texts, file.size_bytes),
        });
        WorldFiles {
            dir: match &self.found.folder {
                Some(folder) => folder.display().to_string(),
                None => self.locations.exports().display().to_string(),
            },
            archives: archives.collect(),
            folders: self.found.folders(),
            problem: self.found.unread.as_ref().map(|why| {
                let folder = self.found.folder.as_deref().unwrap_or(Path::new(""));
                let values = [
                    ("dir", folder.display().to_string().into()),
                    ("reason", why.as_str().into()),
                ];
                texts.say_with("worlds-folder-unread", &values)
            }),
            work: self
                .task
                .as_ref()
                .and_then(|(job, _)| words::work(texts, S::WORDS, job)),
        }
    }

    /// Whether a new one may have this name, as a sentence when not.
    ///
    /// # Errors
    /// The reason in words.
    pub fn check_name(&self, texts: &Texts, name: &str) -> Result<(), String> {
        let all = self.known.iter();
        self.said(texts, SavesDir::check_name_among(name, all.map(Kept::name)))
    }

    /// All of them as last read.
    pub fn known(&self) -> &[S::Kept] {
        &self.known
    }

    /// The names of all of them.
    pub fn names(&self) -> Vec<String> {
        let names = self.known.iter().map(|place| place.name().to_owned());
        names.collect()
    }

    /// Whether one that is there may have this name from now on, as a sentence when not.
    ///
    /// # Errors
    /// The reason in words.
    pub fn check_rename(&self, texts: &Texts, slug: &str, name: &str) -> Result<(), String> {
        let others = self.known.iter().filter(|place| place.slug() != slug);
        self.said(
            texts,
            SavesDir::check_name_among(name, others.map(Kept::name)),
        )
    }

    fn said(&self, texts: &Texts, checked: Result<(), NameError>) -> Result<(), String> {
        checked.map_err(|error| S::name_words(texts, &error, &self.known))
    }
}
