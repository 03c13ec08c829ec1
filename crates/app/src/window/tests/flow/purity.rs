//! The world knows nothing of frames: the same keys at the same steps give the same probes at 20 to 240 frames a second,
//! whatever the field of view and the size of the pictures between them.
//!
//! `ANTIPODE_TEST_LONG=1` plays ten minutes in place of one round.

use antipode_scene::Probe;
use antipode_settings::MouseButton;

use super::*;

/// Steps of a round of play, and steps after which every rate has a frame.
const ROUND: u64 = 22 * 60;
const FRAMED: u64 = 6;

const DIGS: Input = Input::Mouse(MouseButton::Left);
const BUILDS: Input = Input::Mouse(MouseButton::Right);

/// How often, how wide and how large the world is seen.
#[derive(Clone, Copy, Debug)]
struct Seen {
    rate: u32,
    fov_y_deg: f64,
    size: (u32, u32),
}

const USUAL: Seen = Seen {
    rate: 60,
    fov_y_deg: 75.0,
    size: (1280, 720),
};

fn ways() -> Vec<Seen> {
    let seen = |rate, fov_y_deg, size| Seen {
        rate,
        fov_y_deg,
        size,
    };
    let short = vec![seen(20, 110.0, (3840, 2160)), seen(144, 40.0, (320, 200))];
    let each = [30, 50, 120, 240].map(|rate| Seen { rate, ..USUAL });
    let more = if is_long() { &each[..] } else { &[] };
    short.into_iter().chain(more.iter().copied()).collect()
}

fn is_long() -> bool {
    std::env::var("ANTIPODE_TEST_LONG").is_ok_and(|it| it == "1")
}

impl Film {
    fn seen(geometry: Geometry, seen: &Seen) -> Self {
        let mut film = Self::new(geometry);
        film.game.options.config.settings.field_of_view_deg = seen.fov_y_deg;
        let settings = film.game.options.config.settings.clone();
        crate::options::fit(film.scene(), &settings);
        film.game.play.awaits_land = true;
        // From here on time is counted anew, and ahead by less than any frame.
        film.game.play.pace.rest();
        film.now += Duration::from_micros(1);
        film
    }

    fn tap(&mut self, key: &'static str) {
        input(&mut self.game, Input::Key(key), true);
        input(&mut self.game, Input::Key(key), false);
    }

    fn beside(&mut self, (dx, dz): (f64, f64)) -> ChartPoint {
        let scene = self.scene();
        let field = scene.field().clone();
        let mut point = scene.feet().moved(DVec3::new(dx, 0.0, dz));
        point.pos.y = field.surface_height(point.chart, point.pos.x, point.pos.z) + 0.3;
        point
    }

    /// Does what is due before a step: digs, builds and jumps; fights; drives; and crosses the equator where there is one.
    fn act(&mut self, step: u64) {
        match step % ROUND {
            0 | 654 => input(&mut self.game, AHEAD, true),
            60 => {
                input(&mut self.game, AHEAD, false);
                self.tap("Digit3");
                self.game.motion(0.0, 300.0);
            }
            66 => input(&mut self.game, DIGS, true),
            180 | 780 => input(&mut self.game, Input::Key("KeyD"), true),
            240 => {
                input(&mut self.game, DIGS, false);
                input(&mut self.game, Input::Key("KeyD"), false);
                input(&mut self.game, BUILDS, true);
            }
            300 => input(&mut self.game, BUILDS, false),
            306 | 330 => self.tap("Space"),
            342 => {
                self.game.motion(0.0, -300.0);
                self.tap("Digit1");
                let at = self.beside((8.0, -3.0));
                self.scene().spawn_bot(at, 2.0, true);
            }
            at @ 348..582 => {
                input(&mut self.game, DIGS, at % 12 == 0);
                self.game.motion(13.0, 0.0);
            }
            582 => {
                input(&mut self.game, DIGS, false);
                self.go_to_car();
            }
            642 => {
                let way = self.scene().cars()[0].point.pos - self.scene().feet().pos;
                self.scene().aim(way.z.atan2(way.x), -0.2);
                self.tap("KeyC");
            }
            900 => {
                input(&mut self.game, AHEAD, false);
                input(&mut self.game, Input::Key("KeyD"), false);
                input(&mut self.game, Input::Key("Space"), true);
            }
            1020 => input(&mut self.game, Input::Key("Space"), false),
            1026 => self.tap("KeyL"),
            1080 => {
                if let Some(rim_m) = self.scene().strategy().domain(ChartId::FIRST).radius_m() {
                    let at = ChartPoint::a(DVec3::new(rim_m - 3.0, 0.0, 0.0));
                    let off = at.pos - self.scene().feet().pos;
                    let at = self.beside((off.x, off.z));
                    let at = ChartPoint::a(at.pos);
                    self.scene().teleport(at);
                    self.scene().aim(0.0, -0.2);
                }
                input(&mut self.game, AHEAD, true);
            }
            1200 => input(&mut self.game, AHEAD, false),
            _ => {}
        }
        assert!(self.scene().wait_for_step(LIMIT));
    }

    fn go_to_car(&mut self) {
        let car = self.scene().cars()[0];
        let left = (car.turn * DVec3::NEG_Z).with_y(0.0).normalize();
        let at = car.point.moved(left * 2.0 + DVec3::Y * 0.3);
        self.scene().teleport(at);
    }

    fn probe(&mut self) -> Probe {
        let mut probe = self.scene().probe();
        (probe.chunks.resident, probe.chunks.pending) = (0, 0);
        probe.chunks.triangles = 0;
        probe
    }
}

/// The probes of every tenth of a second.
fn play(geometry: Geometry, seen: &Seen) -> Vec<Probe> {
    let mut film = Film::seen(geometry, seen);
    let (start, began_s) = (film.now, film.scene().simulated_s());
    let steps = if is_long() { 600 * 60 } else { ROUND };
    let aspect = f64::from(seen.size.0) / f64::from(seen.size.1);
    let (mut probes, mut drove) = (Vec::new(), false);
    for frame in 0..u64::from(seen.rate) * steps / 60 {
        let made = ((film.scene().simulated_s() - began_s) / STEP_S).round() as u64;
        if made == probes.len() as u64 * FRAMED {
            probes.push(film.probe());
            film.act(made);
        }
        let due = (frame + 1) * 1_000_000_000 / u64::from(seen.rate);
        film.now = start + Duration::from_nanos(due);
        film.game.tick(film.now);
        assert!(film.scene().wait_for_step(LIMIT));
        film.game.frame(aspect, seen.size.1).unwrap();
        drove |= film.scene().is_driving();
    }
    assert!(drove, "{geometry} {seen:?}: nobody drove");
    assert_eq!(probes.len() as u64, steps / FRAMED, "{geometry} {seen:?}");
    probes
}

fn is_the_same_at_every_rate(geometry: Geometry) {
    let before = play(geometry, &USUAL);
    for seen in ways() {
        for (one, other) in before.iter().zip(play(geometry, &seen)) {
            // The shortest text of a number is of that number alone.
            let (told, tells) = (format!("{one:#?}"), format!("{other:#?}"));
            let mut lines = told.lines().zip(tells.lines());
            let differs = lines.find(|(before, now)| before != now);
            let alike = (differs, told.len()) == (None, tells.len());
            assert!(alike, "{geometry} {seen:?} at {} s: {differs:?}", one.t);
        }
    }
}

#[test]
fn a_flat_world_is_the_same_at_20_to_240_frames_a_second() {
    is_the_same_at_every_rate(Geometry::Euclidean);
}

#[test]
fn a_hyperbolic_world_is_the_same_at_20_to_240_frames_a_second() {
    is_the_same_at_every_rate(Geometry::Hyperbolic);
}

#[test]
fn a_closed_world_is_the_same_at_20_to_240_frames_a_second() {
    is_the_same_at_every_rate(Geometry::Spherical);
}
