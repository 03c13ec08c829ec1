//! The workshop: a room of one's own is built in, in place of being walked through. It has a free camera, what is taken hold of,
//! and the panes; the room and its history are the document's.

mod bent;
mod bringing;
mod changes;
mod choosing;
mod chosen;
mod dragging;
mod examples;
mod fields;
mod findings;
mod game;
mod hand;
mod keeping;
mod kits;
mod lesson;
mod lines;
mod link;
mod names;
mod older;
mod part_pictures;
mod parts;
mod rows;
mod set;
mod told;
mod wishes;

use antipode_rays::{Options, Outlines, View};
use antipode_room_scene::RoomScene;
use antipode_room_scene::workshop::{FreeCamera, Handle, Handles, Snap, Through, Tool, Viewpoint};
use antipode_ui::workshop::{BarModel, ToolChoice, WorkshopPanes};
use glam::DVec2;

use super::background::Task;
use super::visit::Visit;
use crate::room_picture::{RoomView, Tile};
use crate::rooms::RoomNote;
use bringing::Bringing;
use choosing::Choosing;
use dragging::Dragging;
use findings::Findings;
pub(in crate::window) use findings::note;
use hand::Meant;
use keeping::Keeping;
pub use lesson::Lesson;
use older::OlderList;
pub(in crate::window) use told::Told;

/// Turns that are held while one drags, degrees.
const TURN_STEP_DEG: f64 = 15.0;
/// How near to a handle the pointer takes hold of it, points.
const GRIP_POINTS: f64 = 9.0;
/// The grid at first, metres.
const GRID_M: f64 = 0.25;

/// What a room is built with.
pub struct Workshop {
    panes: Option<WorkshopPanes>,
    camera: FreeCamera,
    /// Where the picture is in the window, pixels, and its height in points.
    tile: Option<(Tile, f64)>,
    bar: BarModel,
    /// Where what is chosen is seen, and through what; as it was chosen or has been found since.
    seen: Option<Seen>,
    hover: Option<Handle>,
    /// Where the pointer was last without a button held.
    pointer: Option<DVec2>,
    dragging: Option<Dragging>,
    meant: Option<Meant>,
    /// Two corners of a frame that is being drawn about what is to be chosen.
    frame: Option<[DVec2; 2]>,
    /// A line that is dragged from a portal to its partner.
    linking: Option<link::Linking>,
    /// The field that is being dragged.
    field: Option<String>,
    keeping: Keeping,
    /// Why the room's file waits, as it was told last.
    unsaved: Option<String>,
    findings: Findings,
    older: OlderList,
    bringing: Bringing,
    /// A file that is being chosen, and where the last one was.
    choosing: Option<Choosing>,
    last_folder: Option<std::path::PathBuf>,
    told: Told,
    pictures: examples::Pictures,
    part_pictures: part_pictures::PartPictures,
    /// Whether a menu or a list is down.
    is_dropped: bool,
}

/// Through what the chosen things are seen, and where.
#[derive(Clone, Debug)]
struct Seen {
    chain: antipode_deformation::Chain,
    at: DVec2,
}

impl std::fmt::Debug for Workshop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Workshop")
            .field("camera", &self.camera)
            .finish_non_exhaustive()
    }
}

impl Workshop {
    /// It looks at a room as who is in it does. `notes`: what there is to tell of how the room was found.
    pub fn new(scene: &RoomScene, notes: Vec<RoomNote>) -> Self {
        Self {
            panes: None,
            camera: FreeCamera::of(&scene.eye()),
            tile: None,
            bar: BarModel {
                snaps: true,
                grid_m: GRID_M,
                raster: true,
                ..BarModel::default()
            },
            seen: None,
            hover: None,
            pointer: None,
            dragging: None,
            meant: None,
            frame: None,
            linking: None,
            field: None,
            keeping: Keeping::of(scene),
            unsaved: None,
            findings: Findings::begin(notes),
            older: OlderList::default(),
            bringing: Bringing::default(),
            choosing: None,
            last_folder: None,
            told: Told::default(),
            pictures: examples::Pictures::default(),
            part_pictures: part_pictures::PartPictures::default(),
            is_dropped: false,
        }
    }

    /// Width over height of the picture.
    fn aspect(&self) -> f64 {
        self.tile.map_or(16.0 / 9.0, |(tile, _)| {
            f64::from(tile.size.0) / f64::from(tile.size.1.max(1))
        })
    }

    fn viewpoint(&self, scene: &RoomScene) -> Viewpoint {
        scene.viewpoint(&self.camera, self.aspect())
    }

    /// The angle between top and bottom of its pictures where they are as an eye sees, rad.
    fn fov_y_rad(&self, scene: &RoomScene) -> f64 {
        let eye = self.viewpoint(scene).eye;
        let half = eye.parallel_m.map(|half_m| half_m / self.camera.pivot_m);
        half.map_or(eye.fov_y_rad, |half| 2.0 * half.atan())
    }

    /// A length in points of the picture, in its half heights.
    fn half_heights(&self, points: f64) -> f64 {
        let height = self.tile.map_or(720.0, |(_, height)| height);
        2.0 * points / height.max(1.0)
    }

    fn snap(&self, free: bool) -> Snap {
        if free || !self.bar.snaps {
            return Snap::default();
        }
        Snap {
            grid_m: self.bar.grid_m,
            turn_deg: TURN_STEP_DEG,
        }
    }

    fn tool(&self) -> Tool {
        match self.bar.tool {
            ToolChoice::Move => Tool::Move,
            ToolChoice::Turn => Tool::Turn,
            ToolChoice::Scale => Tool::Scale,
        }
    }

    /// The picture through what the chosen things are seen through: as they were chosen, or the straight way to them.
    fn through<'s>(
        &self,
        scene: &'s RoomScene,
        origin: glam::DVec3,
        beside: &[usize],
    ) -> Option<(Through<'s>, DVec2)> {
        let view = self.viewpoint(scene);
        if let Some(seen) = &self.seen {
            let through = scene.through(&view, seen.chain.clone());
            if let Some(at) = through.seen_at(origin, seen.at) {
                return Some((through, at));
            }
        }
        scene.way_to(&view, origin, beside)
    }

    /// The handles of what is chosen, and through what they are seen.
    fn handles<'s>(&self, scene: &'s RoomScene) -> Option<(Through<'s>, Handles)> {
        let held = chosen::held(scene, self.bar.own_axes || self.tool() == Tool::Scale)?;
        let last = chosen::last(scene);
        let own = last.map_or_else(Vec::new, |it| chosen::own_spaces(scene.room(), it));
        let (through, at) = self.through(scene, held.origin, &own)?;
        let handles = Handles::of(&through, at, held, self.tool())?;
        Some((through, handles))
    }
}

impl Visit {
    /// The room is built in from now on.
    pub fn build(&mut self) {
        self.room.look = View::Exact;
        let notes = std::mem::take(&mut self.room.notes);
        let mut workshop = Workshop::new(self.scene(), notes);
        workshop.panes = self.panes.take();
        workshop.bar = self.bar.take().unwrap_or(workshop.bar);
        self.workshop = Some(Box::new(workshop));
        self.room.scene.leave_out_hidden(true);
    }

    /// It is walked through again, from where it was looked at last.
    pub fn walk(&mut self) {
        let Some(mut workshop) = self.workshop.take() else {
            return;
        };
        self.room.notes = workshop.findings.unread();
        self.panes = workshop.panes.take();
        self.bar = Some(workshop.bar);
        self.room.scene.document_mut().end_drag();
        self.room.scene.leave_out_hidden(false);
        self.room.scene.leave_out_walls(false);
        self.room.scene.walk_from(&workshop.camera);
        // The thread of the checks is waited for elsewhere.
        Task::start("leave", move || drop(workshop));
    }

    /// How many messages there are about the room that is built in.
    #[cfg(test)]
    pub fn messages(&self) -> usize {
        self.workshop.as_ref().map_or(0, |it| it.findings.count())
    }

    /// Whether it is built in, and nothing moves until somebody does something.
    pub fn is_built_and_still(&self) -> bool {
        let workshop = self.workshop.as_ref();
        workshop.is_some_and(|it| {
            it.choosing.as_ref().is_none_or(Choosing::rests)
                && it.keeping.rests()
                && it.findings.rest()
                && it.older.rests()
                && it.bringing.rests()
                && self.reading.rests()
        })
    }

    /// What a picture of it is of while it is built in; of the whole window, of that width over height, where a menu lies over it.
    pub fn workshop_view(&self, whole: Option<f64>) -> Option<RoomView> {
        let workshop = self.workshop.as_ref()?;
        let scene = self.scene();
        let aspect = whole.unwrap_or_else(|| workshop.aspect());
        Some(RoomView {
            id: self.id(),
            moment: scene.still(&scene.viewpoint(&workshop.camera, aspect).eye),
            options: Options {
                outlines: Outlines::All,
                raster: workshop.bar.raster,
                ..Options::default()
            },
            tile: workshop
                .tile
                .map(|(tile, _)| tile)
                .filter(|_| whole.is_none()),
        })
    }
}
