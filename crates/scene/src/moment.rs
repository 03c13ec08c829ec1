//! What moves in a picture, as it is after a step, and the picture that is made of it.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Eye, Projection, Strategy};
use glam::DVec3;

use crate::actors::ActorId;
use crate::camera::{CameraMode, CameraPose};
use crate::day;
use crate::frame::{BeamLight, Figure, Frame, Hand, LampLight, Lights, Marker};
use crate::lens::Lens;
use crate::photo::Viewpoint;
use crate::scene::Scene;
use crate::tuning::NEAR_M;

/// Who or what a figure or a light is, so that it is found again after the next step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Who {
    Player {
        drives: Option<usize>,
        dead: bool,
    },
    Bot {
        id: u32,
        dead: bool,
    },
    Lamp(ActorId),
    Bullet(ActorId),
    Drop(ActorId),
    Car(usize),
    Wheel(usize, usize),
    /// Of a car, and whether it is on the right.
    CarLight(usize, bool),
    Shot,
    InHand,
}

/// By which camera a picture is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Taker {
    Player {
        mode: CameraMode,
        drives: Option<usize>,
        dead: bool,
    },
    Photographer,
}

/// Lamps and beams, those that matter most first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lit {
    pub lamps: Vec<(Who, LampLight)>,
    pub beams: Vec<(Who, BeamLight)>,
}

/// Where a marker is in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mark {
    pub marker: Marker,
    /// The way from the eye, a unit vector in view coordinates, and how far along it, metres of the space.
    pub way: DVec3,
    pub away_m: f64,
}

/// What moves in a picture.
#[derive(Clone, Debug)]
pub(crate) struct Moment {
    pub taker: Taker,
    pub camera: CameraPose,
    pub strategy: Arc<dyn Strategy>,
    pub lens: Lens,
    pub figures: Vec<(Who, Figure)>,
    pub lit: Lit,
    pub hand: Option<Hand>,
    pub mark: Option<Mark>,
    pub time_of_day_s: f64,
    pub simulated_s: f64,
}

impl Scene {
    /// What moves in the player's picture.
    pub(crate) fn moment(&self) -> Moment {
        let camera = self.camera_pose();
        let taker = Taker::Player {
            mode: self.shown.camera,
            drives: self.driven_number(),
            dead: self.is_dead(),
        };
        let marker = self.shown.marker.filter(|marker| marker.active);
        let marker = marker.or_else(|| self.lamp_marker());
        Moment {
            hand: self.hand_seen(),
            mark: marker
                .map(|marker| Mark::seen_by(&camera.eye, &**self.lens().strategy(), marker)),
            ..self.moment_of(
                taker,
                camera,
                self.lens(),
                self.shown.camera != CameraMode::First,
            )
        }
    }

    /// What moves in a picture from elsewhere.
    pub(crate) fn moment_from(&self, view: &Viewpoint) -> Moment {
        let camera = CameraPose::within(view.eye);
        let mut moment = self.moment_of(Taker::Photographer, camera, &view.lens, true);
        moment.time_of_day_s = view.time_of_day_s;
        if !view.figures {
            moment.figures.clear();
        }
        moment
    }

    fn moment_of(
        &self,
        taker: Taker,
        camera: CameraPose,
        lens: &Lens,
        sees_player: bool,
    ) -> Moment {
        Moment {
            taker,
            camera,
            strategy: Arc::clone(lens.strategy()),
            lens: lens.clone(),
            figures: self.figures_seen_by(&camera.eye, sees_player),
            lit: self.lights(&camera.eye),
            hand: None,
            mark: None,
            time_of_day_s: self.world.time_of_day_s,
            simulated_s: self.world.simulated_s,
        }
    }

    /// The snapshot to draw. Terrain changes are handed over once.
    pub fn frame(&mut self, fov_y_rad: f64, aspect: f64, world_id: u64) -> Frame {
        let moment = self.moment();
        self.frame_of(moment, fov_y_rad, aspect, world_id)
    }

    /// The snapshot of a moment. Terrain changes are handed over once.
    pub(crate) fn frame_of(
        &mut self,
        moment: Moment,
        fov_y_rad: f64,
        aspect: f64,
        world_id: u64,
    ) -> Frame {
        let (eye, strategy) = (moment.camera.eye, moment.strategy);
        let without_who = |(_, figure)| figure;
        Frame {
            eye,
            projection: Projection::new(fov_y_rad, aspect, NEAR_M),
            sky: day::sky(moment.time_of_day_s, &*strategy, &eye),
            chunk_changes: self.world.ground.take_changes(),
            figures: moment.figures.into_iter().map(without_who).collect(),
            hand: moment.hand,
            lights: Lights {
                lamps: moment.lit.lamps.into_iter().map(|(_, it)| it).collect(),
                beams: moment.lit.beams.into_iter().map(|(_, it)| it).collect(),
            },
            marker: moment.mark.map(|mark| mark.marker),
            hit_shapes: Vec::new(),
            fog_distance_m: self.fog_distance_m(&eye, &*strategy),
            contour_bands: self.shown.viewing.contour_bands,
            time_s: moment.simulated_s as f32,
            quality: self.shown.quality,
            loaded_world: world_id,
            strategy,
        }
    }

    /// Where nothing further is resident the fog must be complete; a closed space is wholly resident and
    /// only hazes towards the antipode. Nor may anything be seen at the farthest that a curved space can draw.
    fn fog_distance_m(&self, eye: &Eye, pictured: &dyn Strategy) -> f32 {
        let far_m = pictured.sight_limit_m(eye);
        match self.world.strategy.rim_m() {
            Some(rim) => (rim * 3.0) as f32,
            None => ((f64::from(self.world.setup.view_distance) - 0.25) * 32.0).min(far_m) as f32,
        }
    }
}

impl Mark {
    fn seen_by(eye: &Eye, pictured: &dyn Strategy, marker: Marker) -> Self {
        let view = pictured.view_point(eye, marker.point);
        Self {
            marker,
            way: view.truncate().normalize_or(DVec3::NEG_Z),
            away_m: pictured.eye_distance_m(eye, view),
        }
    }

    /// Puts the marker where it is in another eye's picture.
    pub fn put_before(&mut self, eye: &Eye, pictured: &dyn Strategy) {
        self.marker.point = pictured.along(eye, self.way, self.away_m);
    }
}

/// What a picture was taken with, for what is laid over it.
#[derive(Clone, Debug)]
pub struct Seen {
    /// The eye.
    pub eye: Eye,
    /// Where figures that nobody plays are, by their numbers.
    bots: Vec<(u32, ChartPoint)>,
}

impl Seen {
    pub(crate) fn of(moment: &Moment) -> Self {
        let bot = |(who, figure): &(Who, Figure)| match who {
            Who::Bot { id, .. } => Some((*id, figure.point)),
            _ => None,
        };
        Self {
            eye: moment.camera.eye,
            bots: moment.figures.iter().filter_map(bot).collect(),
        }
    }

    /// Where the figure with that number is; else where it is said to be.
    pub(crate) fn place(&self, id: u32, otherwise: ChartPoint) -> ChartPoint {
        let found = self.bots.iter().find(|(other, _)| *other == id);
        found.map_or(otherwise, |(_, point)| *point)
    }
}

impl Scene {
    /// What a picture of the last step is taken with.
    pub fn seen(&self) -> Seen {
        Seen {
            eye: self.eye(),
            bots: Vec::new(),
        }
    }
}
