//! A moment: the poses of everything that moves, after a step, and the picture that is made of them.

use std::sync::Arc;

use antipode_geometry::{ChartPoint, Doorway, Eye, Map, Projection, Strategy};
use antipode_items::Item;
use antipode_terrain::Kind;
use glam::DVec3;

use crate::actors::ActorId;
use crate::aimed::{Aim, ViewParams};
use crate::brush::Choice;
use crate::camera::{CameraMode, CameraPose};
use crate::car::mirror::rear_view;
use crate::day;
use crate::frame::{
    BeamLight, Content, Dust, FallingThing, Figure, Frame, Hand, LampLight, Lights, Marker,
    MarkerShape, Opening, View,
};
use crate::lens::Lens;
use crate::light::lights;
use crate::particles::contact;
use crate::photo::Viewpoint;
use crate::pick::over;
use crate::scene::Scene;
use crate::shown::figures_seen_by;
use crate::tuning::{DOOR_FOG_M, NEAR_M, STEP_S};
use crate::world::World;
use crate::{door, falling, fixture, hand, planting, pressing};

/// Identifies a figure or a light, so that it can be found again after the next step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Who {
    Player {
        drives: Option<ActorId>,
        dead: bool,
    },
    Bot {
        id: u32,
        dead: bool,
    },
    /// What was put down.
    Fixture(Item, ActorId),
    /// What is in hand, as it would stand.
    Foreseen,
    Bullet(ActorId),
    Drop(ActorId),
    Car(ActorId),
    Wheel(ActorId, usize),
    /// Of a car, and whether it is on the right.
    CarLight(ActorId, bool),
    Shot,
    InHand,
    /// Light that has come by a door.
    Beyond,
}

/// By which camera a picture is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Taker {
    Player {
        mode: CameraMode,
        drives: Option<ActorId>,
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
    pub falling: Vec<FallingThing>,
    pub lit: Lit,
    pub hand: Option<Hand>,
    pub mark: Option<Mark>,
    pub time_of_day_s: f64,
    pub simulated_s: f64,
}

impl Scene {
    /// What moves in the player's picture.
    pub(crate) fn moment(&self) -> Moment {
        let now = self.now();
        let camera = self.camera_pose();
        let mode = now.player.gaze.camera;
        let taker = Taker::Player {
            mode,
            drives: now.actors.cars.driven(),
            dead: now.player.is_dead(),
        };
        let marker = self.marker().filter(Marker::is_shown);
        let marker = marker.or_else(|| fixture::marker(now));
        let marker = marker.or_else(|| planting::marker(now));
        let still = self.shown.viewing.reduced_motion;
        let mut moment = self.moment_of(taker, camera, self.lens(), mode != CameraMode::First);
        let foreseen = fixture::foreseen(now).map(|it| (Who::Foreseen, it));
        moment.figures.extend(foreseen);
        Moment {
            hand: hand::seen(now, &self.shown.hand, still),
            mark: marker
                .map(|marker| Mark::seen_by(&camera.eye, &**self.lens().strategy(), marker)),
            ..moment
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
            figures: figures_seen_by(self, &camera.eye, sees_player),
            falling: falling::shown(&self.sim.actors),
            lit: lights(self, &camera.eye),
            hand: None,
            mark: None,
            time_of_day_s: self.sim.world.time_of_day_s,
            simulated_s: self.sim.world.simulated_s,
        }
    }

    /// The snapshot to draw. Taking one changes nothing.
    pub fn frame(&self, fov_y_rad: f64, aspect: f64, world_id: u64) -> Frame {
        let moment = self.moment();
        self.frame_of(moment, fov_y_rad, aspect, world_id)
    }

    /// The snapshot to draw from a viewpoint.
    pub fn frame_from(
        &self,
        view: &Viewpoint,
        fov_y_rad: f64,
        aspect: f64,
        world_id: u64,
    ) -> Frame {
        let moment = self.moment_from(view);
        self.frame_of(moment, fov_y_rad, aspect, world_id)
    }

    /// The snapshot of a moment.
    pub(crate) fn frame_of(
        &self,
        moment: Moment,
        fov_y_rad: f64,
        aspect: f64,
        world_id: u64,
    ) -> Frame {
        let (eye, strategy) = (moment.camera.eye, moment.strategy);
        let bonnet = bonnet_of(moment.taker);
        let own_car = moment.figures.iter().find(|(who, _)| Some(*who) == bonnet);
        let own_car = own_car.map(|(_, car)| *car);
        let dust = self.dust(&moment.figures, &eye, moment.simulated_s);
        let pressers = pressing::seen(&self.sim.world, moment.taker, &eye, &moment.figures);
        let content = Content {
            sky: day::sky(moment.time_of_day_s, &*strategy, &eye),
            land: Arc::clone(self.sim.world.ground.land()),
            figures: moment
                .figures
                .into_iter()
                .map(|(_, it)| self.under_sky(&it))
                .collect(),
            falling: moment.falling,
            pressers,
            lights: Lights {
                lamps: moment.lit.lamps.into_iter().map(|(_, it)| it).collect(),
                beams: moment.lit.beams.into_iter().map(|(_, it)| it).collect(),
            },
            marker: moment.mark.map(|mark| mark.marker),
            hit_shapes: Vec::new(),
            dust,
            time_s: moment.simulated_s as f32,
            loaded_world: world_id,
        };
        let marker = content.marker;
        let view = View {
            hand: moment.hand,
            fog_distance_m: fog_distance_m(&self.sim.world, &eye, &*strategy),
            covered: 1.0 - self.field().sky_left(eye.point),
            contour_bands: self.shown.viewing.contour_bands,
            wind: self.shown.viewing.sways().then(|| wind(moment.simulated_s)),
            quality: self.shown.quality,
            ..View::new(eye, Projection::new(fov_y_rad, aspect, NEAR_M), strategy)
        };
        let mut frame = Frame {
            content: Arc::new(content),
            mirror: own_car.map(|car| rear_view(&view, &car)),
            openings: self.openings(&view),
            view,
        };
        if let Some((doors, marker)) = self.sim.world.doors.as_ref().zip(marker) {
            lead_ring_on(&mut frame, doors, &marker);
        }
        frame
    }

    /// A figure with as much of the sky as is left over its middle.
    fn under_sky(&self, figure: &Figure) -> Figure {
        let middle = figure.point.moved(DVec3::Y);
        Figure {
            sky: self.field().sky_left(middle),
            ..*figure
        }
    }

    /// What of the ground is in the air at a time, simulated seconds, and the marks on it.
    fn dust(&self, figures: &[(Who, Figure)], eye: &Eye, at_s: f64) -> Dust {
        let (world, particles) = (&self.sim.world, &self.shown.particles);
        let before_s = (world.simulated_s - at_s).clamp(0.0, STEP_S);
        let mut marks: Vec<_> = particles.prints(at_s).collect();
        contact::add(world, eye.point, figures, &mut marks);
        Dust {
            particles: particles.seen(&*world.strategy, before_s),
            marks,
        }
    }

    /// The doors in a picture. Where only the land about a far door is loaded, the fog is complete before that ends.
    fn openings(&self, view: &View) -> Vec<Opening> {
        let Some(doors) = &self.sim.world.doors else {
            return Vec::new();
        };
        let mut all = Opening::all(view, doors).to_vec();
        for (opening, sill_m) in all.iter_mut().zip(self.shown.sills.of(doors)) {
            opening.sill_m = sill_m;
        }
        if !view.strategy.is_closed() {
            let strategy = &*view.strategy;
            for (opening, far) in all.iter_mut().zip(doors.leaves.iter().rev()) {
                let apart_m = over(strategy, view.eye.point, far.foot)
                    .pos
                    .distance(view.eye.point.pos);
                let own_m = view.fog_distance_m - apart_m as f32;
                let fog_m = own_m.max(DOOR_FOG_M).min(view.fog_distance_m);
                opening.view.fog_distance_m = fog_m;
            }
        }
        all
    }

    /// What a picture of the last step is taken with.
    pub fn seen(&self) -> Seen {
        Seen {
            eye: self.eye(),
            bots: Vec::new(),
        }
    }

    /// Where the brush of a tool in hand would work.
    pub fn marker(&self) -> Option<Marker> {
        let mark = self.sim.player.tool?;
        Some(Marker {
            point: mark.point,
            radius_m: self.sim.player.brush_radius_m,
            active: mark.active,
            shape: if self.shown.viewing.safe_marker {
                MarkerShape::SafeRing
            } else {
                MarkerShape::Ring
            },
            ground: self.ground_offered(),
        })
    }

    /// The kind of ground that was chosen just now to build of, if one was.
    fn ground_offered(&self) -> Option<Kind> {
        let chosen = self.brush_chosen()?;
        let kind = || self.brush().kind.or_else(|| self.stock()?.most());
        (chosen == Choice::Kind).then(kind).flatten()
    }

    /// Through which picture the world is seen.
    pub fn lens(&self) -> &Lens {
        let own = &self.sim.player.gaze.lens;
        self.shown.jumped.as_ref().unwrap_or(own)
    }

    /// Keeps the picture's lens up with the simulation's, which glides: with reduced motion it is where that will be.
    pub(crate) fn renew_picture(&mut self) {
        let own = &self.sim.player.gaze.lens;
        let jumps = self.shown.viewing.reduced_motion && !own.rests();
        self.shown.jumped = jumps.then(|| {
            let mut lens = own.clone();
            lens.jump();
            lens
        });
    }

    /// What the player's picture is taken through.
    pub(crate) fn picturing(&self) -> ViewParams {
        let (lens, viewing) = (self.lens(), self.shown.viewing);
        ViewParams {
            strategy: Arc::clone(lens.strategy()),
            dial: lens.value(),
            straight_shots: self.sim.player.gaze.straight_shots,
            dips: viewing.dips(),
            reduced_motion: viewing.reduced_motion,
            own: lens.is_own(),
        }
    }

    /// The lens of the player's picture, to be told with the actions that are aimed by it.
    pub fn aim_of_picture(&self) -> Aim {
        let (view, value, share) = self.lens().at();
        Aim {
            view,
            value,
            share,
            straight_shots: self.sim.player.gaze.straight_shots,
            dips: self.shown.viewing.dips(),
        }
    }

    /// The eye the picture is taken from.
    pub fn eye(&self) -> Eye {
        self.camera_pose().eye
    }

    /// The camera that pictures are taken with.
    pub(crate) fn camera_pose(&self) -> CameraPose {
        self.now().camera_through(&self.picturing())
    }
}

/// Has each view of a picture show the ring about what is dug where it reaches through doors.
fn lead_ring_on(frame: &mut Frame, doors: &Doorway, marker: &Marker) {
    if marker.shape == MarkerShape::Ball {
        return;
    }
    let lead = |view: &mut View| {
        let space = Arc::clone(&view.strategy);
        let seen = door::ring_seen(&*space, doors, &view.eye, marker.point, marker.radius_m);
        view.mark = Some(seen);
    };
    lead(&mut frame.view);
    for opening in &mut frame.openings {
        lead(&mut opening.view);
        opening.again.as_deref_mut().into_iter().for_each(lead);
    }
}

/// Where nothing further is resident the fog must be complete; a closed space is wholly resident and
/// only hazes towards the antipode. Nor may anything be seen at the farthest that a curved space can draw.
fn fog_distance_m(world: &World, eye: &Eye, pictured: &dyn Strategy) -> f32 {
    let far_m = pictured.sight_limit_m(eye);
    let fog_m = match world.strategy.globe() {
        Some(globe) => 0.75 * globe.round_m(),
        None => ((f64::from(world.setup.view_distance) - 0.25) * 32.0).min(far_m),
    };
    fog_m as f32
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
    pub fn put_before(&mut self, eye: &Eye, pictured: &dyn Map) {
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
/// How fast gusts go by and how fast they flutter, radians a second.
const WIND_PER_S: [f64; 2] = [0.9, 5.3];

/// How far the waves of the wind have gone by, radians.
fn wind(simulated_s: f64) -> [f32; 2] {
    WIND_PER_S.map(|rate| (simulated_s * rate).rem_euclid(std::f64::consts::TAU) as f32)
}

/// The car over whose bonnet a picture looks.
fn bonnet_of(taker: Taker) -> Option<Who> {
    match taker {
        Taker::Player {
            mode: CameraMode::First,
            drives: Some(id),
            ..
        } => Some(Who::Car(id)),
        Taker::Player { .. } | Taker::Photographer => None,
    }
}
