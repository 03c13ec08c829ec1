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

    /// By how much light that comes along the tunnel is turned by its entrance, degrees.
    fn bend_deg(&self, yaw_deg: f64) -> f64 {
        let camera = Camera::at(yaw_deg);
        let from = self.entrance(1.0);
        let inside = trace(
            &self.space,
            &Place::at(&self.space, from),
            DVec3::NEG_Z,
            1.5,
            &Plane(-1e9),
            &camera.light,
        );
        inside.w.angle_between(DVec3::NEG_Z).to_degrees()
    }

    /// Of the rays that come to the entrance of who looks at it from 2 m, the share that it turns back, of 100.
    fn turned_back(&self, yaw_deg: f64) -> f64 {
        let camera = Camera::at(yaw_deg);
        let from = self.entrance(2.0);
        let (mut entered, mut back) = (0, 0);
        for w in camera.rays().filter(|w| w.z < 0.0) {
            let at = from + w * (-2.0 / w.z);
            let off = ((at - self.it.centre) / self.it.half).abs();
            if off.x >= 1.0 || off.y >= 1.0 {
                continue;
            }
            entered += 1;
            let just_inside = 2.0 / -w.z + 1e-6;
            let path = trace(
                &self.space,
                &Place::at(&self.space, from),
                w,
                just_inside,
                &Plane(-1e9),
                &camera.light,
            );
            // It is at the entrance for ever, or goes where it came from.
            back += i32::from(path.end == End::TooManyEvents || path.w.z >= 0.0);
        }
        100.0 * f64::from(back) / f64::from(entered)
    }

    /// How far from what one aims at a walker arrives, who goes on straight: the median over the picture, metres on the
    /// plane behind. Only rays that come to the plane count.
    fn off_aim_m(&self, yaw_deg: f64) -> Option<f64> {
        let camera = Camera::at(yaw_deg);
        let from = self.entrance(2.0);
        let mut off: Vec<f64> = camera
            .rays()
            .filter_map(|w| {
                let seen = self.go(from, w, &camera.light);
                let walked = self.go(from, w, &Traveller::Body);
                let met = seen.hit().is_some() && walked.hit().is_some() && !seen.events.is_empty();
                met.then(|| (seen.place.point - walked.place.point).length())
            })
            .collect();
        off.sort_by(f64::total_cmp);
        off.get(off.len() / 2).copied()
    }

    /// How far what is seen on the plane jumps where the eye comes into the box: the median over the picture, metres.
    fn jump_m(&self, yaw_deg: f64) -> f64 {
        let camera = Camera::at(yaw_deg);
        let mut jumps: Vec<f64> = camera
            .rays()
            .filter_map(|w| {
                let [before, after] =
                    [1e-6, -1e-6].map(|it| self.go(self.entrance(it), w, &camera.light));
                let met = before.hit().is_some() && after.hit().is_some();
                met.then(|| (before.place.point - after.place.point).length())
            })
            .collect();
        jumps.sort_by(f64::total_cmp);
        jumps.get(jumps.len() / 2).copied().unwrap_or(0.0)
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

fn row(what: &str, rule: &str, case: &Case) -> String {
    let off = case.off_aim_m(25.0);
    let off = off.map_or_else(|| "none arrives".to_owned(), |it| format!("{it:.1} m"));
    format!(
        "| {what} | {rule} | {:.1} | {:.1}, {:.1} | {:.0}, {:.0} of 100 | {off} | {:.1} m |",
        case.felt_m(),
        case.bend_deg(0.0) + 0.0,
        case.bend_deg(25.0) + 0.0,
        case.turned_back(0.0),
        case.turned_back(25.0),
        case.jump_m(25.0),
    )
}

#[test]
fn the_table_of_the_thesis_s_rooms_is_what_is_measured() {
    let legacy = Some(Sides::Legacy(Exit::Original));
    let rows: Vec<String> = CASES
        .iter()
        .flat_map(|(room, name, d)| {
            let what = format!("*{name}*, {d}");
            [("the thesis", legacy), ("exact", None)]
                .map(|(rule, sides)| row(&what, rule, &Case::of(room, name, sides)))
        })
        .collect();
    let text = include_str!("../../../../docs/deformation.md");
    assert!(text.contains(&rows.join("\n")), "\n{}\n", rows.join("\n"));
}

#[test]
fn by_our_rule_no_tunnel_of_the_thesis_bends_turns_back_or_jumps() {
    for (room, name, _) in CASES {
        let case = Case::of(room, name, None);
        for yaw in [0.0, 25.0, 60.0] {
            assert!(case.bend_deg(yaw) < 1e-9, "{name} {yaw}");
            assert_eq!(case.turned_back(yaw), 0.0, "{name} {yaw}");
            assert!(case.jump_m(yaw) < 1e-3, "{name} {yaw}");
            assert!(
                case.off_aim_m(yaw).is_none_or(|it| it < 1e-9),
                "{name} {yaw}"
            );
        }
    }
}
