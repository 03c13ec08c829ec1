//! What the player asks for in the workshop, done.

use antipode_language::Texts;
use antipode_room_scene::RoomScene;
use antipode_room_scene::workshop::{Facing, FreeCamera};
use antipode_rooms::{Assets, Room, RoomsDir};
use antipode_ui::workshop::{FieldValue, ViewSide, WorkshopWish};
use antipode_workshop::{Array, Edit, WorkshopError};
use glam::{DVec2, DVec3};

use super::hand::{Deed, nudge};
use super::kits::Site;
use super::rows::free_name;
use super::{Workshop, chosen, names, parts, set};
use crate::window::reading::{Asked, Reading};

/// How far about the place of a finding one looks, metres.
const FINDING_M: f64 = 2.0;
/// What is seen smaller than this is looked at from nearer, half heights of the view.
const SPECK: f64 = 0.12;
/// Of what reaches farther a part is looked at, metres: all of a floor would be seen edge-on from far off.
const FARTHEST_REACH_M: f64 = 25.0;
/// Who would look from lower over the ground than this, metres, looks down by so much, degrees.
const OVER_GROUND_M: f64 = 0.2;
const OVER_GROUND_DEG: f64 = -20.0;

/// What is left for the game to do.
#[derive(Debug, PartialEq)]
pub enum Outcome {
    /// The room is walked through.
    Play,
    /// What was built is kept at once.
    Keep,
    /// The menu comes up.
    Leave,
    /// Something could not be done, for that reason.
    Refused(String),
}

/// The room, and where its files are.
pub struct Bench<'a> {
    /// The room.
    pub scene: &'a mut RoomScene,
    /// Where rooms are.
    pub dir: &'a RoomsDir,
    /// The room's own folder.
    pub slug: &'a str,
    /// What waits for the disk.
    pub reading: &'a mut Reading,
    /// The player's language.
    pub texts: &'a Texts,
}

impl Bench<'_> {
    /// Makes an edit as one step.
    pub fn make(&mut self, edit: &Edit) -> Result<(), WorkshopError> {
        self.scene.document_mut().end_drag();
        let plan = self.scene.document().plan(edit)?;
        if self.scene.lacks_files(&plan) {
            self.reading.ask(Asked::Edit(edit.clone()));
            return Ok(());
        }
        self.commit(plan)?;
        if edit.puts_in() {
            self.scene.document_mut().select_made();
        }
        Ok(())
    }

    /// Makes an edit that is a moment of a drag.
    pub fn drag(&mut self, edit: &Edit) -> Result<(), WorkshopError> {
        if !self.scene.document().is_dragging() {
            self.scene.document_mut().begin_drag();
        }
        let plan = self.scene.document().plan_drag(edit)?;
        self.commit(plan)
    }

    fn folder(&self) -> std::path::PathBuf {
        self.dir.path().join(self.slug)
    }

    fn commit(&mut self, plan: antipode_workshop::Plan) -> Result<(), WorkshopError> {
        // What names other files does not come here before they are read.
        let known = |_: &Room| Ok(Assets::default());
        self.scene.make(plan, known).map_err(WorkshopError::Room)
    }
}

impl Workshop {
    /// Does what is asked for. Returns what is left for the game to do.
    pub fn follow(&mut self, bench: &mut Bench<'_>, wish: WorkshopWish) -> Option<Outcome> {
        match wish {
            WorkshopWish::Play => return Some(Outcome::Play),
            WorkshopWish::Keep => return Some(Outcome::Keep),
            WorkshopWish::Leave => return Some(Outcome::Leave),
            WorkshopWish::Set {
                value: FieldValue::Misread(text),
                ..
            } => {
                let values = [("text", text.as_str().into())];
                let words = bench.texts.say_with("workshop-misread", &values);
                return Some(Outcome::Refused(words));
            }
            _ => {}
        }
        let is_choice = matches!(
            wish,
            WorkshopWish::Choose { .. } | WorkshopWish::ChooseTo(_) | WorkshopWish::ChooseAll(_)
        );
        if is_choice {
            self.forget_chain();
        }
        let done = self.done(bench, wish);
        done.err().map(|why| Outcome::Refused(why.to_string()))
    }

    fn done(&mut self, bench: &mut Bench<'_>, wish: WorkshopWish) -> Result<(), WorkshopError> {
        match wish {
            WorkshopWish::View(event) => {
                return match self.view_event(bench.scene, event) {
                    // Where it may not stand it does not go.
                    Some(Deed::Moment(edit)) => bench.drag(&edit),
                    Some(Deed::Step(edit)) => bench.make(&edit),
                    None => Ok(()),
                };
            }
            WorkshopWish::Set { key, value, done } => {
                return self.set(bench, &key, &value, done);
            }
            _ => {}
        }
        self.field = None;
        let names = bench.scene.document().selection().to_vec();
        if let Some(edit) = self.edit_of(bench, &names, &wish) {
            bench.make(&edit)?;
            if edit.puts_in() {
                self.choose_made(bench.scene);
            }
            return Ok(());
        }
        let document = bench.scene.document_mut();
        match wish {
            WorkshopWish::Undo | WorkshopWish::Redo | WorkshopWish::GoTo(_) => {
                return go_in_history(bench, &wish);
            }
            WorkshopWish::Copy if !names.is_empty() => {
                document.copy();
            }
            WorkshopWish::Cut if !names.is_empty() => {
                document.copy();
                bench.make(&Edit::Remove(names))?;
            }
            WorkshopWish::Hide(name, hidden) => {
                document.hide(&name, hidden);
                bench.scene.look_again();
            }
            WorkshopWish::HideWalls(hides) => {
                self.forget_chain();
                bench.scene.leave_out_walls(hides);
            }
            WorkshopWish::Lock(name, locked) => document.lock(&name, locked),
            WorkshopWish::Choose { name, adds: true } => document.toggle(&name),
            WorkshopWish::Choose { name, adds: false } => document.select([name]),
            WorkshopWish::ChooseTo(name) => choose_to(bench.scene, &name),
            WorkshopWish::ChooseAll(all) => choose_all(bench.scene, all),
            WorkshopWish::ShowMessage(number) => self.show_finding(bench.scene, number),
            WorkshopWish::ShowOlder(shows) => self.older.show(bench.folder(), shows),
            WorkshopWish::OpenOlder(when_s) => self.older.read(bench.folder(), when_s),
            WorkshopWish::ChooseFile => self.choose_file(),
            WorkshopWish::Chooser(wish) => self.follow_choosing(&wish),
            wish => self.arrange(bench.scene, &wish),
        }
        Ok(())
    }

    /// What was put last is chosen, and looked at where it is out of sight: it may have had to stand elsewhere.
    fn choose_made(&mut self, scene: &mut RoomScene) {
        scene.document_mut().select_made();
        self.forget_chain();
        self.bring_into_view(scene, &chosen::indices(scene));
    }

    /// The edit that is asked for, if it is one.
    fn edit_of(&self, bench: &Bench<'_>, names: &[String], wish: &WorkshopWish) -> Option<Edit> {
        let (scene, texts) = (&*bench.scene, bench.texts);
        let room = scene.room();
        let all = || (!names.is_empty()).then(|| names.to_vec());
        let step = self.bar.grid_m.max(0.25);
        let aside = DVec3::new(step, 0.0, step);
        Some(match wish {
            WorkshopWish::Rename(from, to) => Edit::rename(from, to),
            WorkshopWish::Carry(name, group) => Edit::Carry {
                group: group.clone(),
                members: carried(names, name, group.as_deref()),
            },
            WorkshopWish::Reset(key) => set::reset(room, &chosen::indices(scene), key)?,
            WorkshopWish::Put(id) => {
                let snap = self.snap(false);
                let (point, normal) = self.before_camera(scene);
                let site = Site {
                    point,
                    normal,
                    front: self.camera.axes().0,
                    snap: &|metres| snap.length(metres),
                    ground: &|point| scene.ground_below(point),
                };
                names::in_language(parts::put(room, id, &site)?, room, texts)
            }
            WorkshopWish::Paste if !scene.document().clipboard().is_empty() => {
                let clip = scene.document().clipboard().clone();
                let by = chosen::free_aside(room, &clip, step).unwrap_or(aside);
                Edit::Paste {
                    clip,
                    by,
                    is_part: false,
                }
            }
            WorkshopWish::Duplicate => Edit::Duplicate {
                names: all()?,
                by: chosen::width_m(scene, step).map_or(aside, |it| DVec3::X * it),
            },
            WorkshopWish::Array(form) => {
                let reach_m = chosen::extent_m(scene, form.axis)? + form.gap_m;
                Edit::Array(Array {
                    names: all()?,
                    count: form.count,
                    step: DVec3::AXES[form.axis] * (reach_m * 1e3).round() / 1e3,
                    turn_deg: form.turn_deg,
                    about: None,
                })
            }
            WorkshopWish::Group => Edit::Group {
                name: free_name(room, &names::word(texts, "group")),
                at: chosen::middle(scene, &chosen::indices(scene))?,
                members: all()?,
            },
            WorkshopWish::Ungroup => Edit::Ungroup(all()?),
            WorkshopWish::Delete => Edit::Remove(all()?),
            WorkshopWish::Nudge(by) => nudge(scene, self, *by)?,
            _ => return None,
        })
    }

    /// Sets a field; all of a drag of a number is one step.
    fn set(
        &mut self,
        bench: &mut Bench<'_>,
        key: &str,
        value: &FieldValue,
        done: bool,
    ) -> Result<(), WorkshopError> {
        let goes_on = self.field.as_deref() == Some(key) && bench.scene.document().is_dragging();
        let chosen = chosen::indices(bench.scene);
        if done && !goes_on {
            return match set::edit(bench.scene.room(), &chosen, key, value) {
                Some(edit) => bench.make(&edit),
                None => Ok(()),
            };
        }
        if !goes_on {
            bench.scene.document_mut().begin_drag();
            self.field = Some(key.to_owned());
        }
        let edit = set::edit(
            bench.scene.document().room_before_drag(),
            &chosen,
            key,
            value,
        );
        let made = match edit {
            Some(edit) => bench.drag(&edit),
            None => Ok(()),
        };
        if done {
            self.field = None;
            bench.scene.document_mut().end_drag();
        }
        made
    }

    /// What concerns how one looks and takes hold.
    fn arrange(&mut self, scene: &RoomScene, wish: &WorkshopWish) {
        match wish {
            WorkshopWish::Tool(tool) => self.bar.tool = *tool,
            WorkshopWish::OwnAxes(own) => self.bar.own_axes = *own,
            WorkshopWish::Snaps(snaps) => self.bar.snaps = *snaps,
            WorkshopWish::Grid(metres) => self.bar.grid_m = *metres,
            WorkshopWish::OnSurfaces(on) => self.bar.on_surfaces = *on,
            WorkshopWish::Raster(raster) => self.bar.raster = *raster,
            WorkshopWish::Flies(flies) => self.bar.flies = *flies,
            WorkshopWish::Parallel(parallel) => {
                self.camera.parallel = parallel.then(|| scene.radius_m());
                self.forget_chain();
            }
            WorkshopWish::Face(side) => {
                let facing = match side {
                    ViewSide::Top => Some(Facing::Top),
                    ViewSide::Front => Some(Facing::Front),
                    ViewSide::Side => Some(Facing::Side),
                    ViewSide::Start => None,
                };
                if let Some(facing) = facing {
                    self.camera.face(scene.space(), facing);
                    self.camera.parallel = Some(scene.radius_m());
                } else {
                    self.camera = FreeCamera::at_start(scene.room());
                }
                self.forget_chain();
            }
            WorkshopWish::Focus => self.look_at(scene, &chosen::indices(scene)),
            _ => {}
        }
    }

    /// Chooses what a finding is about, and looks at it.
    fn show_finding(&mut self, scene: &mut RoomScene, number: usize) {
        let Some(finding) = self.findings.take(number) else {
            return;
        };
        self.forget_chain();
        scene.document_mut().select(finding.objects);
        self.focus_over_ground(scene, finding.at, FINDING_M);
    }

    /// Looks at a point from as far off as shows so much about it, and not from below the ground that it is over.
    fn focus_over_ground(&mut self, scene: &RoomScene, point: DVec3, reach_m: f64) {
        let fov_y_rad = self.fov_y_rad(scene);
        self.camera.focus(scene.space(), point, reach_m, fov_y_rad);
        let ground = scene.ground_below(point);
        let is_below = ground.is_some_and(|it| self.camera.point.y < it.y + OVER_GROUND_M);
        if is_below && self.camera.parallel.is_none() {
            self.camera.aim_deg.y = OVER_GROUND_DEG;
            self.camera.focus(scene.space(), point, reach_m, fov_y_rad);
        }
    }

    /// Looks at things, if they are not in view already.
    pub fn bring_into_view(&mut self, scene: &RoomScene, all: &[usize]) {
        if !self.sees(scene, all) {
            self.look_at(scene, all);
        }
    }

    /// Whether the whole of some things is well in the view and no mere speck, as far as boxes about them tell.
    fn sees(&self, scene: &RoomScene, all: &[usize]) -> bool {
        let view = self.viewpoint(scene);
        all.iter().all(|index| {
            let own = chosen::own_spaces(scene.room(), *index);
            let ends = chosen::ends(scene, *index).into_iter();
            let seen = ends.map(|point| scene.way_to(&view, point, &own).map(|(_, at)| at));
            let seen: Option<Vec<DVec2>> = seen.collect();
            seen.is_some_and(|seen| {
                let is_within = seen.iter().all(|at| at.abs().max_element() < 0.9);
                is_within && view.apart(seen[0], seen[1]) > SPECK
            })
        })
    }

    fn look_at(&mut self, scene: &RoomScene, all: &[usize]) {
        let Some(middle) = chosen::middle(scene, all) else {
            return;
        };
        self.forget_chain();
        let reach_m = chosen::reach_m(scene, all, middle).min(FARTHEST_REACH_M);
        self.focus_over_ground(scene, middle, reach_m);
    }
}

/// All from the one that was chosen last to that one.
fn choose_to(scene: &mut RoomScene, name: &str) {
    let room = scene.room();
    let last = scene.document().selection().last().cloned();
    let place = |name: &str| room.find(name).map(|(index, _)| index);
    let (Some(from), Some(to)) = (last.as_deref().and_then(place), place(name)) else {
        scene.document_mut().select([name.to_owned()]);
        return;
    };
    let between = from.min(to)..=from.max(to);
    let mut names: Vec<_> = room.objects[between]
        .iter()
        .map(|it| it.name.clone())
        .collect();
    if from > to {
        names.reverse();
    }
    scene.document_mut().select(names);
}

fn choose_all(scene: &mut RoomScene, all: bool) {
    let marked = scene.document().marked();
    let objects = scene.room().objects.iter();
    let free = objects.filter(|it| all && !marked.is_locked(it));
    let names: Vec<_> = free.map(|it| it.name.clone()).collect();
    scene.document_mut().select(names);
}

/// Takes a step back, makes one again, or goes to one.
fn go_in_history(bench: &mut Bench<'_>, wish: &WorkshopWish) -> Result<(), WorkshopError> {
    let document = bench.scene.document_mut();
    document.end_drag();
    let plan = match wish {
        WorkshopWish::GoTo(step) => document.plan_jump(*step),
        WorkshopWish::Redo => document.plan_redo(1)?,
        _ => document.plan_undo(1)?,
    };
    if bench.scene.lacks_files(&plan) {
        bench.reading.ask(Asked::Step(wish.clone()));
        return Ok(());
    }
    bench.commit(plan)?;
    if matches!(wish, WorkshopWish::Redo) {
        bench.scene.document_mut().select_made();
    }
    Ok(())
}

/// What is carried to a group with an object: all that is chosen, if that is, but the group itself.
fn carried(chosen: &[String], name: &String, group: Option<&str>) -> Vec<String> {
    if !chosen.contains(name) {
        return vec![name.clone()];
    }
    let others = chosen.iter().filter(|it| Some(it.as_str()) != group);
    others.cloned().collect()
}
