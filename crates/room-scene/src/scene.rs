//! An open room: what is worked out of it, and who is in it.

use antipode_deformation::{Place, Space, Triangles, Walker};
use antipode_frame::Hand;
use antipode_frame::hand::HandMotion;
use antipode_frame::motion::Motion;
use antipode_rooms::bounds::FARTHEST_M;
use antipode_rooms::mesh::SolidMesh;
use antipode_rooms::{Assets, Editor, Loaded, Room, RoomError, aberrations, space_so_far};
use glam::DVec3;
use thiserror::Error;

use crate::bodies::{Bodies, LooseSolids};
use crate::handling::Grasp;
use crate::hands::Hands;
use crate::held::RoomViewing;
use crate::hints::RoomHint;
use crate::righting::Righting;
use crate::solids::{parted, standing, triangles};
use crate::sounds::RoomSound;
use crate::things::Things;
use crate::tuning::{PITCH_LIMIT_RAD, SHAPE};
use crate::walk::{Jumps, Look};

/// A place that is not in any room.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("({}, {}, {}) is farther than {FARTHEST_M} m from the room's origin", .0.x, .0.y, .0.z)]
pub struct NoSuchPlace(pub DVec3);

/// An open room.
#[derive(Clone, Debug)]
pub struct RoomScene {
    pub(crate) editor: Editor,
    pub(crate) assets: Assets,
    pub(crate) space: Space,
    /// The object of each aberration of the space.
    pub(crate) boxes: Vec<usize>,
    /// The object of each portal of the space.
    pub(crate) portals: Vec<usize>,
    pub(crate) meshes: Vec<SolidMesh>,
    pub(crate) solids: Triangles,
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
    revision: u64,
}

impl RoomScene {
    /// Opens a room; one stands where it says that one begins.
    ///
    /// # Errors
    /// [`RoomError::Unsound`] if its aberrations lie as they may not; rooms that were read do not.
    pub fn open(loaded: Loaded) -> Result<Self, RoomError> {
        let mut scene = Self {
            editor: Editor::new(loaded.room),
            assets: loaded.assets,
            space: Space::default(),
            boxes: Vec::new(),
            portals: Vec::new(),
            meshes: Vec::new(),
            solids: Triangles::default(),
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
            revision: 0,
        };
        scene.work_out()?;
        scene.begin_anew();
        Ok(scene)
    }

    /// The room as it is now.
    pub fn room(&self) -> &Room {
        self.editor.room()
    }

    /// Counts changes of what the room looks like.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Changes the room by the words of a command, as [`Editor::apply`] takes them. `read` gives the files of a room that
    /// names other ones than before. Who walks stays, unless what is strange there has changed: then they begin to feel it.
    ///
    /// # Errors
    /// What is wrong with the command, with the room that it would leave or with a file that it names. The room is as it was.
    pub fn edit(
        &mut self,
        words: &[&str],
        read: impl FnOnce(&Room) -> Result<Assets, RoomError>,
    ) -> Result<(), RoomError> {
        let mut changed = self.clone();
        changed.editor.apply(words)?;
        changed.assets = read(changed.room())?;
        changed.work_out()?;
        *self = changed;
        Ok(())
    }

    /// Lets what falls fall otherwise, m/s^2.
    ///
    /// # Errors
    /// If no room has such gravity.
    pub fn set_gravity(&mut self, gravity: DVec3) -> Result<(), RoomError> {
        let room = self.room().clone();
        self.editor.step(Room { gravity, ..room })?;
        self.work_out()
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
        self.editor.step(room)
    }

    fn work_out(&mut self) -> Result<(), RoomError> {
        let room = self.editor.room();
        (self.space, self.portals) = space_so_far(room).map_err(RoomError::Unsound)?;
        self.boxes = aberrations(room).iter().map(|(index, _)| *index).collect();
        (self.meshes, self.loose_meshes) = parted(room, standing(room, &self.assets));
        self.solids = triangles(&self.meshes);
        self.grasp = Grasp::default();
        self.bodies.changed(room, &self.space);
        self.loose = self.bodies.solids(&self.space);
        self.lowest_m = self.lowest();
        let place = &mut self.walker.body.place;
        *place = Place {
            scale: place.scale,
            ..Place::at(&self.space, place.point)
        };
        self.walker.stay();
        self.things.wake(&self.space);
        self.revision += 1;
        Ok(())
    }

    /// What is solid: what stands, and what is loose where it is now.
    pub(crate) fn all_solids(&self) -> LooseSolids<'_> {
        LooseSolids {
            standing: &self.solids,
            loose: &self.loose,
        }
    }

    fn lowest(&self) -> f64 {
        let room = self.editor.room();
        let up = self.up();
        let of_solids = self
            .meshes
            .iter()
            .chain(&self.loose_meshes)
            .flat_map(|mesh| {
                let corners = mesh.shape.positions.iter();
                corners.map(|it| mesh.pose.transform_point3(*it))
            });
        // One may stand in boxes that nothing stands in.
        let of_boxes = aberrations(room).into_iter().flat_map(|(_, it)| {
            let reach = DVec3::splat(it.half.length());
            [it.centre - reach, it.centre + reach]
        });
        let all = of_solids.chain(of_boxes).chain([room.spawn.at]);
        all.map(|it| it.dot(up)).fold(f64::INFINITY, f64::min)
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
