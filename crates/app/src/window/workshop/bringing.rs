//! Models and pictures that are dropped onto the window while one builds, or chosen from the disk: copied into the room's folder and read on a thread, and put
//! into the room then.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use antipode_rooms::folder::assets;
use antipode_rooms::import::{Imported, import};
use antipode_rooms::room::Texture;
use antipode_rooms::{Assets, Colour, Object, Room, RoomsDir, What};
use antipode_ui::ToastKind;
use antipode_ui::workshop::ChooserWish;
use antipode_workshop::{Edit, Field};
use glam::DVec3;

use super::choosing::Choosing;
use super::rows::free_name;
use super::wishes::Bench;
use super::{Workshop, names};
use crate::window::background::{Progress, Task};
use crate::window::game::Game;
use crate::window::phase::Phase;

/// Side of a picture on what it is dropped for, metres.
const PICTURE_M: f64 = 1.0;

/// A file of the room, and all files that the room has with it.
type Brought = Result<(Imported, Assets), String>;

/// Files on their way into the room.
#[derive(Debug, Default)]
pub struct Bringing {
    waiting: Vec<PathBuf>,
    task: Option<Task<Brought>>,
}

impl Bringing {
    /// Whether there are none.
    pub fn rests(&self) -> bool {
        self.waiting.is_empty() && self.task.is_none()
    }

    /// Begins with the next, and returns one that is there.
    fn pass(&mut self, folder: &Path, room: &Arc<Room>) -> Option<Brought> {
        if self.task.is_none() && !self.waiting.is_empty() {
            let (from, folder, room) = (self.waiting.remove(0), folder.to_owned(), room.clone());
            let work = move || bring(&folder, &from, Room::clone(&room));
            self.task = Some(Task::start("import", work));
        }
        let brought = match self.task.as_ref()?.poll() {
            Progress::Running => return None,
            Progress::Done(brought) => Some(brought),
            Progress::Died => None,
        };
        self.task = None;
        brought
    }
}

/// Copies a file into a room's folder, and reads what the room has with it.
fn bring(folder: &Path, from: &Path, mut room: Room) -> Brought {
    let brought = import(folder, from)?;
    let mut with = Object::new("it", DVec3::ZERO, What::Group);
    match &brought {
        Imported::Model(file) => {
            let (file, scale) = (file.clone(), 1.0);
            with.what = What::Model { file, scale };
        }
        Imported::Texture(file) => {
            let (file, size) = (file.clone(), PICTURE_M);
            with.surface.texture = Some(Texture { file, size });
        }
    }
    room.push(with);
    let files = assets(folder, &room).map_err(|why| why.to_string())?;
    Ok((brought, files))
}

impl Workshop {
    /// Puts a file into the room: a model before the camera, a picture onto what is chosen.
    fn put_in(&self, bench: &mut Bench<'_>, brought: Imported) -> Result<(), String> {
        let edit = match brought {
            Imported::Model(file) => {
                let room = bench.scene.room();
                let (at, _) = self.before_camera(bench.scene);
                let at = at.map(|one| (one * 1e3).round() / 1e3 + 0.0);
                let what = What::Model { file, scale: 1.0 };
                let name = free_name(room, &names::word(bench.texts, "model"));
                Edit::Insert(Object::new(&name, at, what))
            }
            Imported::Texture(file) => {
                let names = bench.scene.document().selection().to_vec();
                let texture = Field::new("texture", format!("{file},{PICTURE_M}"));
                // On white the first picture has the colours of its file.
                let white = Field::colour("colour", Colour::WHITE);
                let room = bench.scene.room();
                let edits = names.into_iter().map(|name| {
                    let found = room.find(&name);
                    let is_bare = found.is_some_and(|(_, it)| it.surface.texture.is_none());
                    let white = is_bare.then(|| white.clone());
                    Edit::Change(name, white.into_iter().chain([texture.clone()]).collect())
                });
                Edit::Several(edits.collect())
            }
        };
        bench.make(&edit).map_err(|why| why.to_string())
    }
}

impl Workshop {
    /// A file is chosen from the folder of the last one.
    pub(super) fn choose_file(&mut self) {
        let folder = self.last_folder.clone();
        let folder = folder.unwrap_or_else(Choosing::usual_folder);
        self.choosing = Some(Choosing::begin(folder));
    }

    /// What is asked for while it is.
    pub(super) fn follow_choosing(&mut self, wish: &ChooserWish) {
        if self.choosing.as_mut().is_some_and(|it| it.follow(wish)) {
            self.choosing = None;
        }
    }
}

impl Game {
    /// A file was dropped onto the window.
    pub(in crate::window) fn dropped(&mut self, path: &Path) {
        let Phase::InRoom(visit) = &mut self.play.phase else {
            self.menus
                .toast(ToastKind::State, "workshop-drop-elsewhere", &[]);
            return;
        };
        let Some(workshop) = &mut visit.workshop else {
            self.menus
                .toast(ToastKind::State, "workshop-drop-elsewhere", &[]);
            return;
        };
        let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
        let is_picture = ["png", "jpg", "jpeg"].iter().any(|it| ending == *it);
        if is_picture && visit.room.scene.document().selection().is_empty() {
            self.menus
                .toast(ToastKind::State, "workshop-drop-choose", &[]);
            return;
        }
        workshop.bringing.waiting.push(path.to_owned());
    }

    /// Takes in a file that has been chosen from the disk.
    pub(super) fn take_chosen(&mut self) {
        let workshop = self
            .play
            .phase
            .visit_mut()
            .and_then(|it| it.workshop.as_mut());
        let chosen = workshop.and_then(|workshop| {
            let choosing = workshop.choosing.as_mut()?;
            let chosen = choosing.pass()?;
            workshop.last_folder = Some(choosing.folder().to_owned());
            workshop.choosing = None;
            Some(chosen)
        });
        if let Some(path) = chosen {
            self.dropped(&path);
        }
    }

    /// Goes on with files that were dropped.
    pub(super) fn bring_in(&mut self) {
        let Phase::InRoom(visit) = &mut self.play.phase else {
            return;
        };
        let (dir, slug) = (RoomsDir::new(visit.dir.clone()), visit.own_slug());
        let Some(mut workshop) = visit.workshop.take() else {
            return;
        };
        let scene = &mut visit.room.scene;
        let room = scene.document().room_shared();
        let brought = workshop.bringing.pass(&dir.path().join(&slug), &room);
        let done = brought.map(|brought| {
            let (brought, files) = brought?;
            scene.learn(&files);
            let mut bench = Bench {
                scene,
                dir: &dir,
                slug: &slug,
                reading: &mut visit.reading,
                texts: &self.menus.texts,
            };
            workshop.put_in(&mut bench, brought)
        });
        if done.is_some() {
            workshop.told.forget();
        }
        visit.workshop = Some(workshop);
        if let Some(Err(why)) = done {
            self.menus.shell.toast(why, ToastKind::Problem);
        }
    }
}
