//! An open room: what is worked out of it, and who is in it.

use std::sync::Arc;

use antipode_deformation::{Place, Solids, Space, Triangles, Walker};
use antipode_frame::Hand;
use antipode_frame::hand::HandMotion;
use antipode_frame::motion::Motion;
use antipode_rooms::aberration::Sides;
use antipode_rooms::bounds::FARTHEST_M;
use antipode_rooms::mesh::SolidMesh;
use antipode_rooms::{Assets, Loaded, Room, RoomError, What, poses};
use antipode_workshop::{Document, Plan, Said};
use glam::{DAffine3, DVec3};
use thiserror::Error;

use crate::bodies::{Bodies, LooseSolids};
use crate::handling::Grasp;
use crate::hands::Hands;
use crate::held::RoomViewing;
use crate::hints::RoomHint;
use crate::righting::Righting;
use crate::solids::{Known, Remade};
use crate::sounds::RoomSound;
use crate::things::Things;
use crate::tuning::{PITCH_LIMIT_RAD, SHAPE};
use crate::walk::{Jumps, Look};

/// A room in which nothing has walls that the game makes. Everything stands at its place among the objects.
fn without_walls(room: &Room) -> Room {
    let mut room = room.clone();
    for object in &mut room.objects {
        if matches!(&object.what, What::Aberration(it) if it.sides == Sides::Walls) {
            Arc::make_mut(object).what = What::Group;
        }
    }
    room
}

/// A place that is not in any room.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("({}, {}, {}) is farther than {FARTHEST_M} m from the room's origin", .0.x, .0.y, .0.z)]
pub struct NoSuchPlace(pub DVec3);

/// An open room. A copy of it is kept nowhere.
#[derive(Clone, Debug)]
pub struct RoomScene {
    pub(crate) document: Document,
    pub(crate) assets: Assets,
    /// All files that were read since the room was opened.
    read: Assets,
    pub(crate) space: Space,
    /// The object of each aberration of the space.
    pub(crate) boxes: Vec<usize>,
    /// The object of each portal of the space.
    pub(crate) portals: Vec<usize>,
    pub(crate) meshes: Vec<SolidMesh>,
    pub(crate) solids: Solids,
    /// What was made so far, to be used again.
    known: Known,
    /// What is loose, and its meshes in the same order.
    pub(crate) bodies: Bodies,
    pub(crate) loose_meshes: Vec<SolidMesh>,
    /// Where the surfaces of what is loose are now.
    pub(crate) loose: Triangles,
    pub(crate) walker: Walker,
    pub(crate) jumps: Jumps,
    pub(crate) look: Look,
    /// Where one looked before the last step.
    pub(crate) looked: Look,
    pub(crate) hands: Hands,
    pub(crate) things: Things,
    pub(crate) grasp: Grasp,
    pub(crate) time_s: f64,
    /// When something loose was heard last, as `time_s`.
    pub(crate) knocked_s: f64,
    pub(crate) motion: Motion,
    pub(crate) hand: HandMotion,
    /// What was in the hand before the last step.
    pub(crate) hand_before: Option<Hand>,
    pub(crate) viewing: RoomViewing,
    pub(crate) third_person: bool,
    pub(crate) righting: Righting,
    pub(crate) sounds: Vec<RoomSound>,
    pub(crate) hints: Vec<RoomHint>,
    /// How high the lowest of all that stands in the room is, metres against gravity.
    pub(crate) lowest_m: f64,
    /// Of the room's objects, in their order.
    pub(crate) poses: Vec<DAffine3>,
    revision: u64,
    /// Whether what is hidden in the document is left out of solids and pictures.
    leaves_out: bool,
    /// Whether aberrations with walls of their own are left out of space.
    leaves_out_walls: bool,
}

impl RoomScene {
    /// Opens a room; one stands where it says that one begins.
    pub fn open(loaded: Loaded) -> Self {
        Self::of(Document::new(loaded.room), loaded.assets)
    }

    /// Opens the room of a document, which is changed here from now on.
    pub fn of(document: Document, assets: Assets) -> Self {
        let mut scene = Self {
            document,
            read: assets.clone(),
            assets,
            space: Space::default(),
            boxes: Vec::new(),
            portals: Vec::new(),
            meshes: Vec::new(),
            solids: Solids::default(),
            known: Known::default(),
            bodies: Bodies::default(),
            loose_meshes: Vec::new(),
            loose: Triangles::default(),
            walker: Walker::new(Place::default(), SHAPE),
            jumps: Jumps::default(),
            look: Look::default(),
            looked: Look::default(),
            hands: Hands::default(),
            things: Things::default(),
            grasp: Grasp::default(),
            time_s: 0.0,
            knocked_s: 0.0,
            motion: Motion::default(),
            hand: HandMotion::default(),
            hand_before: None,
            viewing: RoomViewing::default(),
            third_person: false,
            righting: Righting::default(),
            sounds: Vec::new(),
            hints: Vec::new(),
            lowest_m: 0.0,
            poses: Vec::new(),
            revision: 0,
            leaves_out: false,
            leaves_out_walls: false,
        };
        scene.work_out();
        scene.begin_anew();
        scene
    }

    /// The room as it is now.
    pub fn room(&self) -> &Room {
        self.document.room()
    }

    /// The document whose room this is.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The same, to select in, to keep and to begin drags. What changes the room goes by [`Self::make`].
    pub fn document_mut(&mut self) -> &mut Document {
        &mut self.document
    }

    /// The files that the room names.
    pub fn assets(&self) -> &Assets {
        &self.assets
    }

    /// Files that were read for what is about to be made of the room, so that it need not be waited for.
    pub fn learn(&mut self, assets: &Assets) {
        self.read.add(assets);
    }

    /// Whether what was planned names files that nobody has read.
    pub fn lacks_files(&self, plan: &Plan) -> bool {
        plan.names_other_files(&self.document) && self.read.of(plan.room()).is_none()
    }

    /// The pose of every object of the room, as [`antipode_rooms::poses`] works it out.
    pub fn poses(&self) -> &[DAffine3] {
        &self.poses
    }

    /// Counts changes of what the room looks like.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Changes the room by the words of a command, as [`Document::plan_words`] takes them. `read` gives the files of a room that
    /// names other ones than before. Who walks stays, unless what is strange there has changed: then they begin to feel it.
    ///
    /// # Errors
    /// What is wrong with the command, with the room that it would leave or with a file that it names. The room is as it was.
    pub fn edit(
        &mut self,
        words: &[&str],
        read: impl FnOnce(&Room) -> Result<Assets, RoomError>,
    ) -> Result<(), RoomError> {
        self.document.end_drag();
        let plan = self.document.plan_words(words)?;
        self.make(plan, read)
    }

    /// Makes what was planned of the document, as [`Self::edit`] does.
    ///
    /// # Errors
    /// What is wrong with a file that the room names then; if the document has changed since. The room is as it was.
    pub fn make(
        &mut self,
        plan: Plan,
        read: impl FnOnce(&Room) -> Result<Assets, RoomError>,
    ) -> Result<(), RoomError> {
        if plan.names_other_files(&self.document) {
            // What was read before, as when a step is taken back, is not read again.
            let assets = match self.read.of(plan.room()) {
                Some(assets) => assets,
                None => read(plan.room())?,
            };
            self.document.commit(plan)?;
            self.read.add(&assets);
            self.assets = assets;
        } else {
            self.document.commit(plan)?;
        }
        self.work_out();
        Ok(())
    }

    /// Lets what falls fall otherwise, m/s^2.
    ///
    /// # Errors
    /// If no room has such gravity.
    pub fn set_gravity(&mut self, gravity: DVec3) -> Result<(), RoomError> {
        let room = self.room().clone();
        let plan = (self.document).plan_room(Room { gravity, ..room }, Said::new("room"))?;
        self.document.commit(plan)?;
        self.work_out();
        Ok(())
    }

    /// Goes on with the document of another folder, whose room names the same files.
    pub fn take_document(&mut self, document: Document) -> Document {
        let before = std::mem::replace(&mut self.document, document);
        self.work_out();
        before
    }

    /// Gives the room another name.
    ///
    /// # Errors
    /// If no room can be called so.
    pub fn rename(&mut self, name: &str) -> Result<(), RoomError> {
        let room = Room {
            name: name.trim().to_owned(),
            ..self.room().clone()
        };
        let plan = self.document.plan_room(room, Said::new("room"))?;
        Ok(self.document.commit(plan)?)
    }

    /// Works out what the room is made of, after it has changed.
    fn work_out(&mut self) {
        let room = self.document.room();
        self.poses = poses(room);
        let unwalled = self.leaves_out_walls.then(|| without_walls(room));
        let space = (&mut self.space, &mut self.boxes, &mut self.portals);
        self.known
            .renew_space(unwalled.as_ref().unwrap_or(room), space);
        (self.meshes, self.loose_meshes) = self.known.meshes((room, &self.poses), &self.assets);
        if self.leaves_out {
            let marked = self.document.marked();
            let is_shown = |mesh: &SolidMesh| !marked.is_hidden(&room.objects[mesh.object]);
            self.meshes.retain(is_shown);
            self.loose_meshes.retain(is_shown);
        }
        let up = -room.gravity.normalize_or(DVec3::NEG_Y);
        let (solids, loose_m) = self.known.solids(&self.meshes, &self.loose_meshes, up);
        // One may stand in boxes that nothing stands in.
        let of_boxes = self.known.boxes().flat_map(|it| {
            let reach = DVec3::splat(it.half.length());
            [it.centre - reach, it.centre + reach]
        });
        let all = of_boxes.chain([room.spawn.at]).map(|it| it.dot(up));
        self.lowest_m = all.fold(solids.lowest(up).min(loose_m), f64::min);
        self.solids = solids;
        self.grasp = Grasp::default();
        self.bodies.changed((room, &self.poses), &self.space);
        self.loose = self.bodies.solids(&self.space);
        let place = &mut self.walker.body.place;
        *place = Place {
            scale: place.scale,
            ..Place::at(&self.space, place.point)
        };
        self.walker.stay();
        self.things.wake(&self.space);
        self.revision += 1;
    }

    /// Whether what is hidden in the document is left out: it is while one builds, and not while one walks.
    pub fn leave_out_hidden(&mut self, leaves_out: bool) {
        let marked = self.document.marked();
        let mut objects = self.room().objects.iter();
        let changes = self.leaves_out != leaves_out && objects.any(|it| marked.is_hidden(it));
        self.leaves_out = leaves_out;
        if changes {
            self.work_out();
        }
    }

    /// Whether aberrations with walls of their own are left out of space, so that one sees and works in them as they lie in the
    /// scene.
    pub fn leave_out_walls(&mut self, leaves_out: bool) {
        if std::mem::replace(&mut self.leaves_out_walls, leaves_out) != leaves_out {
            self.work_out();
        }
    }

    /// Whether they are.
    pub fn leaves_out_walls(&self) -> bool {
        self.leaves_out_walls
    }

    /// Something was hidden in the document, or shown again.
    pub fn look_again(&mut self) {
        self.work_out();
    }

    /// The drag that goes on in the document is given up.
    pub fn cancel_drag(&mut self) {
        if self.document.is_dragging() {
            self.document.cancel_drag();
            self.work_out();
        }
    }

    /// What is solid: what stands, and what is loose where it is now.
    pub(crate) fn all_solids(&self) -> LooseSolids<'_> {
        LooseSolids {
            standing: &self.solids,
            loose: &self.loose,
        }
    }

    /// How often what was made anew.
    pub fn remade(&self) -> Remade {
        self.known.remade()
    }

    /// Looks there, degrees; pitch is held short of the vertical.
    pub fn aim(&mut self, yaw_deg: f64, pitch_deg: f64) {
        self.look = Look {
            yaw_rad: yaw_deg.to_radians(),
            pitch_rad: pitch_deg
                .to_radians()
                .clamp(-PITCH_LIMIT_RAD, PITCH_LIMIT_RAD),
        };
        self.looked = self.look;
    }

    /// Puts the feet of who walks there, at rest.
    ///
    /// # Errors
    /// If it is farther off than anything in a room.
    pub fn teleport(&mut self, feet: DVec3) -> Result<(), NoSuchPlace> {
        if !feet.abs().cmple(DVec3::splat(FARTHEST_M)).all() {
            return Err(NoSuchPlace(feet));
        }
        self.stand_at(feet);
        Ok(())
    }
}
