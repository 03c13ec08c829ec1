//! Pictures between the steps of the world, at the frame rates of good screens: what moves does so evenly, what is
//! turned is seen at once, and the world knows nothing of it.

mod moments;
mod purity;

use std::sync::Arc;

use antipode_geometry::{ChartId, ChartPoint, Eye, Strategy};
use antipode_scene::frame::{Frame, ModelId};
use antipode_scene::tuning::STEP_S;
use antipode_scene::{Actions, CameraMode, Scene};
use glam::{DVec3, DVec4};

use super::*;

const RATES: [u32; 3] = [120, 144, 240];
/// Far more than any test needs; it only ends a test that would hang.
const LIMIT: Duration = Duration::from_mins(2);
const AHEAD: Input = Input::Key("KeyW");
const RADIUS_M: f64 = 32.0;

/// A game whose frames come at an even rate.
struct Film {
    game: Game,
    now: Instant,
    frame: Duration,
    _dir: TempDir,
}

impl Film {
    fn new(geometry: Geometry) -> Self {
        let dir = tempfile::tempdir().unwrap();
        let request = Request::New(NewWorld {
            geometry,
            name: None,
            seed: Some(3),
            radius_m: (geometry == Geometry::Spherical).then_some(RADIUS_M),
            generator: Some(antipode_scene::Generator::OneBiome),
            mode: antipode_scene::Mode::default(),
            start: Beginning::Middle,
        });
        let mut game = Game::new(worlds(dir.path()), None, Some(request));
        tick_until(&mut game, Game::is_playing);
        let mut film = Self {
            game,
            now: Instant::now() + Duration::from_secs(1),
            frame: Duration::ZERO,
            _dir: dir,
        };
        film.at(60);
        film.scene().settle(LIMIT);
        film.shoot(30);
        film
    }

    fn at(&mut self, rate: u32) {
        self.frame = Duration::from_secs(1) / rate;
    }

    fn scene(&mut self) -> &mut Scene {
        &mut self.game.play.phase.session_mut().unwrap().scene
    }

    /// Lets the time of a frame pass, without a picture. Returns whether the world made a step.
    fn pass(&mut self) -> bool {
        self.now += self.frame;
        let before_s = self.scene().simulated_s();
        self.game.tick(self.now);
        assert!(self.scene().wait_for_step(LIMIT));
        self.scene().simulated_s() > before_s
    }

    fn picture(&mut self) -> Frame {
        self.game.frame(1.5, 720).unwrap()
    }

    /// So many frames one after the other.
    fn shoot(&mut self, count: u32) -> Vec<Frame> {
        let frame = |_| {
            self.pass();
            self.picture()
        };
        (0..count).map(frame).collect()
    }

    /// So many seconds: where something is in each frame, with the steps so far, and where it is after each step.
    fn follow(
        &mut self,
        rate: u32,
        seconds: f64,
        of_frame: impl Fn(&Frame) -> ChartPoint,
        of_scene: impl Fn(&Scene) -> ChartPoint,
    ) -> (Vec<(DVec4, usize)>, Vec<DVec4>) {
        self.at(rate);
        let space = Arc::clone(self.scene().strategy());
        let (mut frames, mut steps) = (Vec::new(), Vec::new());
        for _ in 0..(f64::from(rate) * seconds) as u32 {
            if self.pass() {
                steps.push(place(&*space, of_scene(self.scene())));
            }
            frames.push((place(&*space, of_frame(&self.picture())), steps.len()));
        }
        (frames, steps)
    }

    /// Puts the player near the equator of a closed world, looking across it.
    fn go_to_equator(&mut self, before_m: f64) {
        let scene = self.scene();
        let field = scene.field().clone();
        let x = scene.strategy().domain(ChartId::FIRST).radius_m().unwrap() - before_m;
        let y = field.surface_height(ChartId::FIRST, x, 0.0) + 0.2;
        scene.teleport(ChartPoint::a(DVec3::new(x, y, 0.0)));
        scene.aim(0.1, -0.1);
        assert!(scene.wait_for_step(LIMIT));
        self.shoot(30);
    }

    fn is_over(&mut self) -> bool {
        self.scene().feet().chart == ChartId::SECOND
    }

    fn drive(&mut self) {
        let feet = self.scene().feet();
        assert!(
            self.scene()
                .spawn_car(feet.moved(DVec3::new(3.0, 0.3, 0.0)), 0.1)
        );
        assert!(self.scene().wait_for_step(LIMIT));
        self.shoot(90);
        self.scene().aim(0.0, -0.2);
        self.scene().step(&Actions {
            enter_car: true,
            ..Actions::default()
        });
        assert!(self.scene().is_driving());
        self.shoot(30);
    }
}

/// A place as one of a space without charts, metres.
fn place(space: &dyn Strategy, point: ChartPoint) -> DVec4 {
    if space.is_closed() {
        space.curved(&Eye::default(), point) * space.radius_m()
    } else {
        point.pos.extend(0.0)
    }
}

/// The change of velocity from each of these places to the next but one, m/s.
fn jolts(places: &[DVec4], apart_s: f64) -> Vec<f64> {
    let jolt = |it: &[DVec4]| (it[2] - 2.0 * it[1] + it[0]).length() / apart_s;
    places.windows(3).map(jolt).collect()
}

/// What moves neither stands nor jerks more than in the steps of that moment, of which each frame tells the last.
fn is_even(frames: &[(DVec4, usize)], steps: &[DVec4], rate: u32, what: &str) {
    let places: Vec<DVec4> = frames.iter().map(|(place, _)| *place).collect();
    assert!(
        places.windows(2).all(|it| it[0] != it[1]),
        "{what} at {rate} stands"
    );
    let of_steps = jolts(steps, STEP_S);
    let mut seen = 0;
    for (jolt, (_, step)) in jolts(&places, 1.0 / f64::from(rate))
        .iter()
        .zip(&frames[2..])
    {
        let near = of_steps.get(step.saturating_sub(5)..step - 1);
        let Some(near) = near.filter(|_| *step > 5) else {
            continue;
        };
        let most = near.iter().copied().fold(1e-6, f64::max);
        assert!(
            *jolt <= 1.2 * most,
            "{what} at {rate}: {jolt} m/s, of steps {most}"
        );
        seen += 1;
    }
    assert!(seen > 100, "{what} at {rate}: {seen}");
}

#[test]
fn over_the_equator_a_camera_moves_evenly_on_foot_and_from_behind() {
    for mode in [CameraMode::First, CameraMode::Third] {
        let mut film = Film::new(Geometry::Spherical);
        if mode == CameraMode::Third {
            input(&mut film.game, Input::Key("Tab"), true);
        }
        for rate in RATES {
            film.at(60);
            film.go_to_equator(5.0);
            assert_eq!(film.scene().camera_mode(), mode);
            input(&mut film.game, AHEAD, true);
            film.shoot(10);
            let (frames, steps) =
                film.follow(rate, 1.8, |it| it.view.eye.point, |it| it.eye().point);
            is_even(&frames, &steps, rate, mode.id());
            assert!(film.is_over(), "{mode:?}: it was walked over");
            input(&mut film.game, AHEAD, false);
        }
    }
}

#[test]
fn over_the_equator_a_car_its_driver_and_the_camera_behind_it_move_evenly() {
    let shown = |frame: &Frame, model: ModelId| {
        let figures = frame.content.figures.iter();
        figures.rev().find(|it| it.model == model).unwrap().point
    };
    for rate in RATES {
        for what in ["camera", "car", "driver"] {
            // In a world of its own: no car that was left over the equator is in the way.
            let mut film = Film::new(Geometry::Spherical);
            film.go_to_equator(22.0);
            film.drive();
            input(&mut film.game, AHEAD, true);
            film.shoot(40);
            let (frames, steps) = match what {
                "camera" => film.follow(rate, 3.0, |it| it.view.eye.point, |it| it.eye().point),
                "car" => {
                    let car = |it: &Scene| it.driven_car().unwrap().point;
                    film.follow(rate, 3.0, |it| shown(it, ModelId::CarBody), car)
                }
                _ => film.follow(rate, 3.0, |it| shown(it, ModelId::Astronaut), Scene::feet),
            };
            is_even(&frames, &steps, rate, what);
            assert!(film.is_over(), "it was driven over");
        }
    }
}

/// The most level strip of land near the middle of a flat world: where it begins, along +x.
fn level_strip(film: &mut Film, length_m: f64) -> DVec3 {
    let scene = film.scene();
    let field = scene.field().clone();
    let mut best = (f64::MAX, DVec3::ZERO);
    for cell in 0..40 * 40 {
        let (x, z) = (f64::from(cell % 40) - 20.0, f64::from(cell / 40) - 20.0);
        let heights: Vec<f64> = (0..=20)
            .map(|part| x + length_m * f64::from(part) / 20.0)
            .map(|x| field.surface_height(ChartId::FIRST, x, z))
            .collect();
        let low = heights.iter().copied().fold(f64::MAX, f64::min);
        let high = heights.iter().copied().fold(f64::MIN, f64::max);
        if high - low < best.0 {
            best = (high - low, DVec3::new(x, heights[0], z));
        }
    }
    best.1
}

#[test]
fn on_level_ground_every_frame_covers_its_share_of_the_way() {
    let mut film = Film::new(Geometry::Euclidean);
    let strip = level_strip(&mut film, 7.0);
    for rate in RATES {
        film.at(60);
        film.scene().teleport(ChartPoint::a(strip + DVec3::Y * 0.1));
        film.scene().aim(0.0, 0.0);
        assert!(film.scene().wait_for_step(LIMIT));
        film.shoot(30);
        input(&mut film.game, AHEAD, true);
        film.shoot(20);
        let (frames, steps) = film.follow(rate, 0.8, |it| it.view.eye.point, |it| it.eye().point);
        input(&mut film.game, AHEAD, false);
        let level = |a: DVec4, b: DVec4| (b - a).truncate().with_y(0.0).length();
        let ways = steps.windows(2).map(|it| level(it[0], it[1]));
        let mut ways: Vec<f64> = ways.collect();
        ways.sort_by(f64::total_cmp);
        let speed_m_s = ways[ways.len() / 2] / STEP_S;
        let due_m = speed_m_s * film.frame.as_secs_f64();
        assert!(speed_m_s > 4.0, "{speed_m_s} m/s");
        // The first may end a step that was made at another rate.
        for it in frames[2..].windows(2) {
            let way_m = level(it[0].0, it[1].0);
            let share = way_m / due_m;
            assert!(
                (share - 1.0).abs() < 0.01,
                "at {rate}: {share} of {due_m} m"
            );
        }
    }
}
