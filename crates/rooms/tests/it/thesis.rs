//! The rooms of the thesis by both rules, measured. docs/deformation.md has the table that is made here; when the two differ the
//! test prints the one there should be.

use antipode_deformation::{
    Aberration, End, Exit, PictureCorners, Place, SceneHit, SceneQuery, Sides, Space, Trace,
    Traveller, trace,
};
use antipode_rooms::shipped;
use glam::{DMat3, DVec3};

/// The picture: as high as the game's, and 16:9.
const HEIGHT_RAD: f64 = 75.0 / 180.0 * std::f64::consts::PI;
const ASPECT: f64 = 16.0 / 9.0;
/// Rays across and down it.
const RAYS: (i32, i32) = (160, 90);
/// How far behind the box the plane stands on which the picture is looked at, metres.
const BEHIND_M: f64 = 60.0;
/// How high an eye is, metres.
const EYE_M: f64 = 1.62;

/// A plane across z.
struct Plane(f64);

impl SceneQuery for Plane {
    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let time = (self.0 - x.z) / v.z;
        (0.0..=longest).contains(&time).then_some(SceneHit {
            time,
            object: 0,
            part: 0,
            normal: DVec3::Z,
        })
    }

    fn near(&self, _: DVec3, _: DVec3, _: &mut dyn FnMut([DVec3; 3])) {}
}

/// A camera that looks along -z at yaw 0.
struct Camera {
    turn: DMat3,
    light: Traveller,
}

fn direction(turn: DMat3, x: f64, y: f64) -> DVec3 {
    let up = (0.5 * HEIGHT_RAD).tan();
    (turn * DVec3::new(x * up * ASPECT, y * up, -1.0)).normalize()
}

impl Camera {
    fn at(yaw_deg: f64) -> Self {
        let turn = DMat3::from_rotation_y(-yaw_deg.to_radians());
        let corners = PictureCorners::new(direction(turn, -1.0, -1.0), direction(turn, 1.0, 1.0));
        Self {
            turn,
            light: Traveller::Light(corners),
        }
    }

    /// The directions of all rays.
    fn rays(&self) -> impl Iterator<Item = DVec3> {
        let (across, down) = RAYS;
        let share = |i: i32, of: i32| 2.0 * (f64::from(i) + 0.5) / f64::from(of) - 1.0;
        (0..across * down).map(move |i| {
            direction(
                self.turn,
                share(i % across, across),
                share(i / across, down),
            )
        })
    }
}

/// One aberration of a room of the thesis, alone, by one of the rules.
struct Case {
    space: Space,
    it: Aberration,
}

impl Case {
    fn of(room: &str, name: &str, sides: Option<Sides>) -> Self {
        let room = shipped::find(room).unwrap().room().unwrap();
        let all = antipode_rooms::aberrations(&room);
        let mut it = all.into_iter().find(|(_, it)| it.name == name).unwrap().1;
        it.sides = sides.unwrap_or(it.sides);
        Self {
            space: Space::new(vec![it.clone()]).unwrap(),
            it,
        }
    }

    /// A place at the middle of the entrance, so far before it.
    fn entrance(&self, before_m: f64) -> DVec3 {
        let z = self.it.centre.z + self.it.half.z + before_m;
        DVec3::new(self.it.centre.x, EYE_M, z)
    }

    fn go(&self, from: DVec3, w: DVec3, who: &Traveller) -> Trace {
        let plane = Plane(self.it.centre.z - self.it.half.z - BEHIND_M);
        trace(
            &self.space,
            &Place::at(&self.space, from),
            w,
            2000.0,
            &plane,
            who,
        )
    }

    /// The same for so many felt metres, past whatever stands behind.
    fn go_for(&self, from: DVec3, w: DVec3, who: &Traveller, length: f64) -> Trace {
        trace(
            &self.space,
            &Place::at(&self.space, from),
            w,
            length,
            &Plane(-1e9),
            who,
        )
    }

    /// The rays of who looks at the entrance from 2 m that come to it, each with what it needs to be just behind it.
    fn through_the_entrance(&self, camera: &Camera) -> impl Iterator<Item = (DVec3, f64)> {
        let (from, it) = (self.entrance(2.0), self.it.clone());
        let ahead = camera.rays().filter(|w| w.z < 0.0);
        ahead.filter_map(move |w| {
            let off = ((from + w * (-2.0 / w.z) - it.centre) / it.half).abs();
            (off.x < 1.0 && off.y < 1.0).then_some((w, 2.0 / -w.z + 1e-6))
        })
    }

    /// By how much light that comes along the tunnel is turned by its entrance, degrees.
    fn bend_deg(&self, yaw_deg: f64) -> f64 {
        let light = Camera::at(yaw_deg).light;
        let inside = self.go_for(self.entrance(1.0), DVec3::NEG_Z, &light, 1.0 + 1e-6);
        inside.w.angle_between(DVec3::NEG_Z).to_degrees()
    }

    /// The same of all light that comes to the entrance and is not turned back: the median.
    fn median_bend_deg(&self, yaw_deg: f64) -> f64 {
        let camera = Camera::at(yaw_deg);
        median(
            self.through_the_entrance(&camera)
                .filter_map(|(w, length)| {
                    let inside = self.go_for(self.entrance(2.0), w, &camera.light, length);
                    let bend = inside.w.angle_between(w).to_degrees();
                    (!inside.place.stack.is_empty()).then_some(bend)
                }),
        )
    }

    /// The share of the light that comes to the entrance that is turned back, of 100.
    fn turned_back(&self, yaw_deg: f64) -> f64 {
        let camera = Camera::at(yaw_deg);
        let (mut entered, mut back) = (0, 0);
        for (w, length) in self.through_the_entrance(&camera) {
            entered += 1;
            let path = self.go_for(self.entrance(2.0), w, &camera.light, length);
            // It is at the entrance for ever, or goes where it came from.
            back += i32::from(path.end == End::TooManyEvents || path.w.z >= 0.0);
        }
        100.0 * f64::from(back) / f64::from(entered)
    }

    /// The angle between the way of sight and that of who walks along it, just behind the entrance, degrees: the median over
    /// the rays that come to it. Those that are turned back do not count.
    fn off_aim_deg(&self, yaw_deg: f64) -> f64 {
        let camera = Camera::at(yaw_deg);
        median(
            self.through_the_entrance(&camera)
                .filter_map(|(w, length)| {
                    let way = |who: &Traveller| {
                        let path = self.go_for(self.entrance(2.0), w, who, length);
                        let stack = &path.place.stack;
                        (!stack.is_empty()).then(|| self.space.velocity(stack, path.w, who))
                    };
                    let (seen, walked) = (way(&camera.light)?, way(&Traveller::Body)?);
                    Some(seen.angle_between(walked).to_degrees())
                }),
        )
    }

    /// How far what is seen on the plane jumps where the eye comes into the box: the median over the picture, metres. By the
    /// thesis's rule rays that begin inside were never bent at a face, so that nothing turns them back when they leave; our
    /// mode remembers their direction, and is asked for that here by the exit that turns nothing.
    fn jump_m(&self, after: &Self, yaw_deg: f64) -> f64 {
        let camera = Camera::at(yaw_deg);
        median(camera.rays().filter_map(|w| {
            let before = self.go(self.entrance(1e-6), w, &camera.light);
            let after = after.go(self.entrance(-1e-6), w, &camera.light);
            let met = before.hit().is_some() && after.hit().is_some();
            met.then(|| (before.place.point - after.place.point).length())
        }))
    }

    /// Felt metres from end to end for who walks through the middle.
    fn felt_m(&self) -> f64 {
        let path = self.go(self.entrance(0.0), DVec3::NEG_Z, &Traveller::Body);
        path.length - BEHIND_M
    }
}

const CASES: [(&str, &str, &str); 5] = [
    ("four-tunnels", "shorter", "d_z = +2"),
    ("four-tunnels", "longer", "d_z = -0.8"),
    ("four-tunnels", "narrower", "d_x = +0.7"),
    ("four-tunnels", "lower", "d_y = +0.8"),
    ("thesis-room", "room", "d_x = d_y = +1"),
];

fn median(all: impl Iterator<Item = f64>) -> f64 {
    let mut all: Vec<f64> = all.collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(0.0)
}

/// A row for a rule; `inside` is the rule for rays that begin inside.
fn row(what: &str, rule: &str, case: &Case, inside: &Case) -> String {
    let two = |of: &dyn Fn(f64) -> f64, digits: usize| {
        let [along, aside] = [0.0, 25.0].map(|yaw| of(yaw) + 0.0);
        format!("{along:.digits$}, {aside:.digits$}")
    };
    format!(
        "| {what} | {rule} | {:.1} | {} | {} | {} | {} | {} |",
        case.felt_m(),
        two(&|yaw| case.bend_deg(yaw), 1),
        two(&|yaw| case.median_bend_deg(yaw), 1),
        two(&|yaw| case.turned_back(yaw), 0),
        two(&|yaw| case.off_aim_deg(yaw), 1),
        two(&|yaw| case.jump_m(inside, yaw), 1),
    )
}

#[test]
fn the_table_of_the_thesis_s_rooms_is_what_is_measured() {
    let mut rows = Vec::new();
    for (room, name, d) in CASES {
        let of = |sides: Option<Sides>| Case::of(room, name, sides);
        let [original, none] = [Exit::Original, Exit::None].map(|it| of(Some(Sides::Legacy(it))));
        let what = format!("*{name}*, {d}");
        rows.push(row(&what, "the thesis", &original, &none));
        rows.push(row(&what, "exact", &of(None), &of(None)));
    }
    let text = include_str!("../../../../docs/deformation.md");
    assert!(text.contains(&rows.join("\n")), "\n{}\n", rows.join("\n"));
}

#[test]
fn by_our_rule_no_tunnel_of_the_thesis_bends_turns_back_or_jumps() {
    for (room, name, _) in CASES {
        let case = Case::of(room, name, None);
        for yaw in [0.0, 25.0, 60.0] {
            assert!(case.bend_deg(yaw) < 1e-9, "{name} {yaw}");
            assert!(case.median_bend_deg(yaw) < 1e-9, "{name} {yaw}");
            assert_eq!(case.turned_back(yaw), 0.0, "{name} {yaw}");
            assert!(case.off_aim_deg(yaw) < 1e-4, "{name} {yaw}");
            assert!(case.jump_m(&case, yaw) < 1e-3, "{name} {yaw}");
        }
    }
}
