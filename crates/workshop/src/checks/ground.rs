//! Standing and walking, coarsely: by rays of [`trace`] at the heights of a knee and a chest, which go through faces and portals
//! as who walks does. It is quick rather than exact: who walks in earnest is [`antipode_deformation::Walker`].

use antipode_deformation::{
    End, EventKind, Hit, Place, SceneQuery, Solids, Space, Trace, Traveller, Void, WalkerShape,
    felt_gravity, trace,
};
use glam::DVec3;

/// Above the floor, felt metres: over every step that is climbed, and in the middle of a chest.
const KNEE_OVER_STEP_M: f64 = 0.1;
const CHEST_M: f64 = 1.2;
/// The deepest fall after which one goes on, felt metres; beyond is nothing.
const DEEPEST_M: f64 = 3000.0;
/// What is stepped over is looked at so often, felt metres. No round number, so that places do not come to lie in the planes of
/// portals and at the rims of floors, which are at round places.
pub(crate) const STRIDE_M: f64 = 0.2437;

/// Where one may walk.
pub(crate) struct Ground<'a> {
    pub space: &'a Space,
    pub solids: &'a Solids,
    /// Gravity of the room, m/s^2.
    pub gravity: DVec3,
    /// Who walks.
    pub shape: WalkerShape,
}

/// What is under a place.
pub(crate) enum Under {
    /// A floor, so many felt metres below.
    Floor(f64, Hit),
    /// Nothing.
    Void,
    /// A fall that has no end, through these portals.
    Endless(Vec<usize>),
}

/// What becomes of a stride.
pub(crate) enum Stride {
    /// There is no way.
    Blocked,
    /// One stands there then; the portals that were gone through.
    To(Place, Vec<usize>),
    /// One falls out of the room there.
    Void(DVec3),
    /// One falls without end, through these portals. Who falls can steer, so one comes to what is before them.
    Falls(Vec<usize>),
}

impl Ground<'_> {
    /// Height of the knee above the floor: that is where those who stand are told by.
    pub fn knee_m(&self) -> f64 {
        self.shape.step_m + KNEE_OVER_STEP_M
    }

    /// Felt up at a place, of length 1.
    pub fn up(&self, place: &Place) -> DVec3 {
        let k = self.space.carry(place, DVec3::ZERO, &Traveller::Body);
        -felt_gravity(k, self.gravity)
            .try_normalize()
            .unwrap_or(DVec3::NEG_Y)
    }

    /// Goes from a place in a felt direction.
    pub fn go(&self, from: &Place, w: DVec3, longest: f64) -> Trace {
        trace(self.space, from, w, longest, self.solids, &Traveller::Body)
    }

    /// Where that leads if no solid is in the way.
    pub fn beyond(&self, from: &Place, w: DVec3, length: f64) -> Place {
        trace(self.space, from, w, length, &Void, &Traveller::Body).place
    }

    /// The same, if nothing is in the way.
    fn free(&self, from: &Place, w: DVec3, longest: f64) -> Option<Trace> {
        let way = self.go(from, w, longest);
        matches!(way.end, End::Spent).then_some(way)
    }

    /// What is under a place.
    pub fn under(&self, place: &Place) -> Under {
        let way = self.go(place, -self.up(place), DEEPEST_M);
        match way.end {
            End::Hit(hit) => Under::Floor(way.length, hit),
            End::Spent => Under::Void,
            End::TooManyEvents => Under::Endless(portals(&way).collect()),
        }
    }

    /// Whether somebody can stand there, told by the knee.
    pub fn has_head_room(&self, knee: &Place) -> bool {
        let height = self.shape.height_m - self.knee_m();
        self.free(knee, self.up(knee), height).is_some()
    }

    /// Who stands on the floor below a place, or is in it up to the knee; none if there is no floor or no room for a head.
    pub fn standing_below(&self, place: &Place) -> Option<Place> {
        let Under::Floor(below, _) = self.under(place) else {
            return None;
        };
        let rise = self.knee_m() - below;
        let up = self.up(place) * rise.signum();
        let knee = self.free(place, up, rise.abs())?.place;
        self.has_head_room(&knee).then_some(knee)
    }

    /// Whether a hit surface carries who walks.
    fn carries(&self, hit: &Hit, up: DVec3) -> bool {
        hit.felt_normal.dot(up) >= self.shape.steepest_rad.cos()
    }

    /// A stride from where one stands, in a level felt direction.
    pub fn stride(&self, knee: &Place, w: DVec3) -> Stride {
        let up = self.up(knee);
        if let End::Hit(hit) = self.go(knee, w, STRIDE_M).end
            && !self.carries(&hit, up)
        {
            return Stride::Blocked;
        }
        let Some(chest) = self.free(knee, up, CHEST_M - self.knee_m()) else {
            return Stride::Blocked;
        };
        let wide = self.go(&chest.place, w, STRIDE_M + self.shape.radius_m);
        if let End::Hit(hit) = wide.end
            && !self.carries(&hit, up)
        {
            return Stride::Blocked;
        }
        let Some(there) = self.free(&chest.place, w, STRIDE_M) else {
            return Stride::Blocked;
        };
        self.come_down(&there, self.tallness(knee))
    }

    /// Felt metres of a metre of the scene upwards, at a place.
    fn tallness(&self, place: &Place) -> f64 {
        let k = self.space.carry(place, DVec3::ZERO, &Traveller::Body);
        (k.inverse() * self.gravity.normalize_or_zero()).length()
    }

    /// From chest height to where one stands, for who has come from where a metre upwards felt like that.
    fn come_down(&self, way: &Trace, tallness: f64) -> Stride {
        let mut passed: Vec<usize> = portals(way).collect();
        let mut chest = way.place;
        let ahead = chest.turn * way.w;
        chest.straighten();
        let up = self.up(&chest);
        let (below, hit) = match self.under(&chest) {
            Under::Floor(below, hit) => (below, hit),
            Under::Void if self.is_rim(&chest, ahead) => return Stride::Void(chest.point),
            Under::Void => return Stride::Blocked,
            Under::Endless(through) => {
                passed.extend(through);
                return Stride::Falls(passed);
            }
        };
        // A slope may rise faster than a step is high.
        let slope = STRIDE_M * self.shape.steepest_rad.tan();
        let is_sloped = hit.felt_normal.dot(up) < 0.999;
        let most_rise = self.shape.step_m + if is_sloped { slope } else { 0.0 };
        // At a face the floor goes on, and who crosses it is as high above it as before in the scene, not as it feels. A portal
        // takes along how it feels.
        let chest_m = if passed.is_empty() {
            CHEST_M * self.tallness(&chest) / tallness
        } else {
            CHEST_M
        };
        if chest_m - below > most_rise || !self.carries(&hit, up) {
            return Stride::Blocked;
        }
        let down = below - self.knee_m();
        let Some(fallen) = self.free(&chest, -up * down.signum(), down.abs()) else {
            return Stride::Blocked;
        };
        passed.extend(portals(&fallen));
        let mut knee = fallen.place;
        knee.straighten();
        if self.has_head_room(&knee) {
            Stride::To(knee, passed)
        } else {
            Stride::Blocked
        }
    }

    /// Whether there is no floor either where the rest of a body would be that goes on.
    fn is_rim(&self, chest: &Place, ahead: DVec3) -> bool {
        let on = self.free(chest, ahead, self.shape.radius_m);
        on.is_some_and(|it| matches!(self.under(&it.place), Under::Void))
    }

    /// Whether nothing is between two places, neither solid nor wall, face or portal.
    pub fn is_open_between(&self, a: &Place, b: &Place) -> bool {
        let way = b.point - a.point;
        let k = self.space.carry(a, DVec3::ZERO, &Traveller::Body);
        let felt = k.inverse() * way;
        if a.stack != b.stack || felt.length() < 1e-9 {
            return a.stack == b.stack;
        }
        let told = self.free(a, felt.normalize(), felt.length());
        told.is_some_and(|it| it.events.is_empty())
    }

    /// The objects within which a point is: an odd number of faces of each lies beyond it, whichever way one looks. Models need
    /// not be closed, and so are looked at three ways.
    pub fn solids_around(&self, point: DVec3) -> Vec<u32> {
        let ways = [
            DVec3::new(0.3, 1.0, 0.2),
            DVec3::new(-0.9, 0.1, 0.4),
            DVec3::new(0.2, -0.3, -1.0),
        ];
        let [first, others @ ..] = ways.map(|w| self.odd(point, w));
        first
            .into_iter()
            .filter(|it| others.iter().all(|all| all.contains(it)))
            .collect()
    }

    fn odd(&self, point: DVec3, w: DVec3) -> Vec<u32> {
        const MOST_FACES: usize = 200;
        let mut odd: Vec<u32> = Vec::new();
        let (mut from, mut left) = (point, 1e4);
        for _ in 0..MOST_FACES {
            let Some(hit) = self.solids.first(from, w, left) else {
                break;
            };
            match odd.iter().position(|it| *it == hit.object) {
                Some(index) => drop(odd.swap_remove(index)),
                None => odd.push(hit.object),
            }
            let step = hit.time + 1e-6;
            from += w * step;
            left -= step;
        }
        odd
    }
}

/// The portals that a path went into.
fn portals(way: &Trace) -> impl Iterator<Item = usize> + '_ {
    let passed = way.events.iter().filter(|it| it.kind == EventKind::Passed);
    passed.map(|it| it.number)
}
