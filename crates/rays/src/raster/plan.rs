//! The views of a picture: what is seen from the eye, through doors, and through doors behind these.
//!
//! A ray of felt direction w is at o + t K w after t felt metres, with o and K the same for all rays of a view. At the first, o is
//! the eye. At a door the place is kept while K becomes K': with f on the door's plane, f = o + t K w and o' = f - t K' w give
//!
//! > o' = f - K' K^-1 (f - o)
//!
//! which is the same for all f of the plane where K' K^-1 moves nothing along it: where the stretches along the door are 1. So
//! each view is a camera in coordinates of the scene, at o, whose picture of x is that of K^-1 (x - o).

use antipode_deformation::{Space, Stack, Traveller};
use glam::{DMat3, DVec2, DVec3};

use super::tidy::clearance;
use crate::scene::Eye;

/// Least distance along the view's direction that is drawn, felt metres.
pub const NEAR_M: f64 = 2e-4;

/// How much is drawn by a raster.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Doors in a row, and one.
    pub levels: usize,
    /// Views; at most 255.
    pub views: usize,
}

/// A view.
#[derive(Clone, Debug)]
pub struct View {
    /// Boxes that one looks about in.
    pub stack: Stack,
    /// K of these.
    pub k: DMat3,
    /// From where it is seen, metres of the scene.
    pub origin: DVec3,
    /// What has n.x < d is before the door: n and d.
    pub cut: Option<(DVec3, f64)>,
    /// How many doors are before it.
    pub level: usize,
    /// The part of the picture in which its door lies: least and greatest x and y, from -1 at the left and the bottom to 1.
    pub extent: (DVec2, DVec2),
    /// Picks x, y and depth of the picture, each as a product with x - o.
    pub rows: [DVec3; 3],
}

/// What a face of a box is in a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Opaque.
    Wall,
    /// A door to the view of that number.
    Door(usize),
    /// Only rays know what is seen in it.
    Rays,
}

/// A face of a box in a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The number of the view.
    pub view: usize,
    /// The number of the box.
    pub number: usize,
    /// Across which axis it is, 0 to 2.
    pub axis: usize,
    /// Whether it is the one towards which the axis points.
    pub is_far: bool,
    /// What it is.
    pub kind: Kind,
}

/// All views of a picture, and the faces in them.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// The first is that of the eye.
    pub views: Vec<View>,
    /// Faces.
    pub faces: Vec<Face>,
}

impl Plan {
    /// One view in coordinates of the scene, with all walls that there are.
    pub fn plain(space: &Space, eye: &Eye, aspect: f64) -> Self {
        let lens = lens(eye, aspect);
        let mut plan = Self::default();
        plan.views.push(View {
            stack: Stack::default(),
            k: DMat3::IDENTITY,
            origin: eye.place.point,
            cut: None,
            level: 0,
            extent: (DVec2::NEG_ONE, DVec2::ONE),
            rows: lens,
        });
        for (number, placed) in space.placed().iter().enumerate() {
            let walls = sides().filter(|(axis, _)| placed.aberration.is_wall(*axis));
            plan.faces.extend(walls.map(|(axis, is_far)| Face {
                view: 0,
                number,
                axis,
                is_far,
                kind: Kind::Wall,
            }));
        }
        plan
    }

    /// The views through the doors of tidy tunnels.
    pub fn doors(space: &Space, tidy: &[bool], eye: &Eye, aspect: f64, limits: Limits) -> Self {
        let stack = eye.place.stack;
        let mut maker = Maker {
            space,
            tidy,
            lens: lens(eye, aspect),
            limits,
            plan: Self::default(),
        };
        let k = maker.squeeze(&stack);
        let first = View {
            stack,
            k,
            origin: eye.place.point,
            cut: None,
            level: 0,
            extent: (DVec2::NEG_ONE, DVec2::ONE),
            rows: maker.rows(k),
        };
        maker.plan.views.push(first);
        let mut at = 0;
        while let Some(view) = maker.plan.views.get(at).cloned() {
            maker.look_about(at, &view);
            at += 1;
        }
        maker.plan
    }

    /// Whether there is nothing in it that only rays know.
    pub fn sees_all(&self) -> bool {
        self.faces.iter().all(|face| face.kind != Kind::Rays)
    }

    /// Levels that it has.
    pub fn levels(&self) -> usize {
        self.views
            .iter()
            .map(|view| view.level + 1)
            .max()
            .unwrap_or(0)
    }
}

/// Picks x, y and depth of the picture, each as a product with a felt displacement from the eye.
fn lens(eye: &Eye, aspect: f64) -> [DVec3; 3] {
    let half = (0.5 * eye.fov_y_rad).tan();
    [eye.right / (half * aspect), eye.up / half, eye.front]
}

/// Axes and sides of a box's faces.
fn sides() -> impl Iterator<Item = (usize, bool)> {
    (0..6).map(|side| (side / 2, side % 2 == 1))
}

struct Maker<'a> {
    space: &'a Space,
    tidy: &'a [bool],
    lens: [DVec3; 3],
    limits: Limits,
    plan: Plan,
}

impl Maker<'_> {
    fn squeeze(&self, stack: &Stack) -> DMat3 {
        // Whichever way: tidy boxes are felt both ways.
        self.space.squeeze(stack, DVec3::Z, &Traveller::Body)
    }

    /// The lens of a view: p.(K^-1 x) = (K^-T p).x.
    fn rows(&self, k: DMat3) -> [DVec3; 3] {
        let to_scene = k.inverse().transpose();
        self.lens.map(|row| to_scene * row)
    }

    /// Lists the faces that a view shows, and opens views behind its doors.
    fn look_about(&mut self, number: usize, view: &View) {
        if let Some(own) = view.stack.innermost() {
            sides().for_each(|side| self.look_at((number, view), own, side, true));
        }
        for entrance in self.space.entrances(&view.stack) {
            let other = usize::from(*entrance);
            if !view.stack.contains(other) {
                sides().for_each(|side| self.look_at((number, view), other, side, false));
            }
        }
    }

    /// Lists a face through which one would leave a box, or enter it, if it is seen from that side.
    fn look_at(
        &mut self,
        (of, view): (usize, &View),
        number: usize,
        (axis, is_far): (usize, bool),
        leaves: bool,
    ) {
        let placed = &self.space.placed()[number];
        let half = placed.aberration.half;
        let outward = placed.axes.col(axis) * if is_far { 1.0 } else { -1.0 };
        let centre = placed.aberration.centre + outward * half[axis];
        let before = outward.dot(view.origin - centre);
        let is_seen = if leaves { before < 0.0 } else { before > 0.0 };
        let (along, across) = ((axis + 1) % 3, (axis + 2) % 3);
        let edges = [along, across].map(|i| placed.axes.col(i) * half[i]);
        // What reaches farthest behind the door that one looks through.
        let is_beyond = view.cut.is_none_or(|(n, d)| {
            let reach: f64 = edges.iter().map(|edge| n.dot(*edge).abs()).sum();
            n.dot(centre) + reach > d + clearance(placed)
        });
        if !is_seen || !is_beyond {
            return;
        }
        let kind = if !self.tidy[number] {
            Kind::Rays
        } else if placed.aberration.is_wall(axis) {
            Kind::Wall
        } else {
            let onward = if leaves { outward } else { -outward };
            let hair_m = 0.5 * clearance(placed);
            self.open((of, view), (centre, edges), onward, hair_m)
        };
        self.plan.faces.push(Face {
            view: of,
            number,
            axis,
            is_far,
            kind,
        });
    }

    /// The view through a door in direction `onward`, if there may be one more.
    fn open(
        &mut self,
        (of, view): (usize, &View),
        (centre, edges): (DVec3, [DVec3; 2]),
        onward: DVec3,
        hair_m: f64,
    ) -> Kind {
        let number = self.plan.views.len();
        let level = view.level + 1;
        let has_room = level < self.limits.levels && number < self.limits.views;
        let extent = extent(view, centre, edges).filter(|_| has_room);
        let stack = self.space.stack_at(centre + onward * hair_m);
        let is_next = stack.len().abs_diff(self.plan.views[of].stack.len()) == 1;
        let Some(extent) = extent.filter(|_| is_next) else {
            return Kind::Rays;
        };
        let k = self.squeeze(&stack);
        self.plan.views.push(View {
            stack,
            k,
            origin: centre - k * (view.k.inverse() * (centre - view.origin)),
            cut: Some((onward, onward.dot(centre))),
            level,
            extent,
            rows: self.rows(k),
        });
        Kind::Door(number)
    }
}

/// In which part of the picture a door lies, as far as the view shows it; none if it does not.
fn extent(view: &View, centre: DVec3, [one, other]: [DVec3; 2]) -> Option<(DVec2, DVec2)> {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(u, v)| {
        let away = centre + one * u + other * v - view.origin;
        DVec3::from_array(view.rows.map(|row| row.dot(away)))
    });
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let mut reach = |p: DVec3| {
        let place = p.truncate() / p.z;
        (low, high) = (low.min(place), high.max(place));
    };
    for (at, corner) in corners.into_iter().enumerate() {
        let next = corners[(at + 1) % 4];
        if corner.z >= NEAR_M {
            reach(corner);
        }
        if (corner.z >= NEAR_M) != (next.z >= NEAR_M) {
            let share = (NEAR_M - corner.z) / (next.z - corner.z);
            reach(corner.lerp(next, share));
        }
    }
    let (low, high) = (low.max(view.extent.0), high.min(view.extent.1));
    low.cmple(high).all().then_some((low, high))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use antipode_deformation::{Aberration, Place, Void, trace};
    use glam::DQuat;

    use super::*;
    use crate::raster::tidy;

    const LIMITS: Limits = Limits {
        levels: 5,
        views: 40,
    };

    /// A turned tunnel along z about the origin, and one more in it.
    fn nested() -> Space {
        let turn = DQuat::from_rotation_y(0.2);
        let outer = Aberration::tunnel(DVec3::ZERO, turn, DVec3::new(2.0, 2.0, 6.0), 2, 30.0);
        let turn = DQuat::from_rotation_y(0.5);
        let inner = Aberration::tunnel(0.5 * DVec3::Z, turn, DVec3::new(0.7, 0.8, 1.5), 2, 1.0);
        Space::new(vec![outer, inner]).unwrap()
    }

    fn plan(space: &Space, eye: &Eye, limits: Limits) -> Plan {
        Plan::doors(space, &tidy(space), eye, 1.6, limits)
    }

    fn looking(space: &Space, from: DVec3, to: DVec3) -> Eye {
        Eye::looking(Place::at(space, from), to - from, DVec3::Y, 1.2)
    }

    #[test]
    fn rays_go_where_the_views_say() {
        let space = nested();
        let far = DVec3::new(3.2, 0.3, 14.0);
        let places = [far, DVec3::new(0.9, 0.1, 4.4), DVec3::new(0.1, 0.0, 0.4)];
        for (from, least) in places.into_iter().zip([4, 3, 3]) {
            let eye = looking(&space, from, DVec3::ZERO);
            let plan = plan(&space, &eye, LIMITS);
            let mut seen = 0;
            for view in &plan.views {
                // The middle of its door.
                let middle = 0.5 * (view.extent.0 + view.extent.1);
                let w = eye.direction(middle.x, middle.y, 1.6);
                let felt_m = just_behind(view, w);
                let path = trace(&space, &eye.place, w, felt_m, &Void, &Traveller::Body);
                let is_whole = (path.length - felt_m).abs() < 1e-9;
                let is_there = path.place.stack == view.stack && path.events.len() == view.level;
                if !(is_whole && is_there) {
                    continue;
                }
                let there = view.origin + felt_m * (view.k * w);
                assert!(there.distance(path.place.point) < 1e-9, "{view:?}");
                let [x, y, depth] = view.rows.map(|row| row.dot(there - view.origin));
                assert!((x / depth - middle.x).abs() < 1e-9 && (y / depth - middle.y).abs() < 1e-9);
                seen += 1;
            }
            assert!(seen >= least, "{seen} of {}", plan.views.len());
        }
    }

    /// Felt metres to just behind the door of a view.
    fn just_behind(view: &View, w: DVec3) -> f64 {
        view.cut.map_or(1e-3, |(n, d)| {
            (d - n.dot(view.origin)) / n.dot(view.k * w) + 1e-3
        })
    }

    #[test]
    fn what_is_behind_the_last_level_is_for_rays() {
        let space = nested();
        let eye = looking(&space, 14.0 * DVec3::Z, DVec3::ZERO);
        let kinds = |levels| {
            let limits = Limits { levels, ..LIMITS };
            let plan = plan(&space, &eye, limits);
            assert_eq!(plan.levels(), levels);
            let count = |wanted: fn(&Kind) -> bool| {
                plan.faces.iter().filter(|face| wanted(&face.kind)).count()
            };
            (
                count(|kind| matches!(kind, Kind::Door(_))),
                count(|kind| *kind == Kind::Rays),
            )
        };
        assert_eq!(kinds(1), (0, 1));
        assert_eq!(kinds(2).0, 1);
        assert!(kinds(2).1 >= 2);
    }

    #[test]
    fn a_door_behind_the_eye_opens_no_view() {
        let space = nested();
        let eye = looking(&space, 14.0 * DVec3::Z, 20.0 * DVec3::Z);
        assert_eq!(plan(&space, &eye, LIMITS).views.len(), 1);
    }

    #[test]
    fn in_coordinates_of_the_scene_there_are_walls_only() {
        let space = nested();
        let eye = looking(&space, 14.0 * DVec3::Z, DVec3::ZERO);
        let plan = Plan::plain(&space, &eye, 1.6);
        assert_eq!(plan.faces.len(), 8);
        assert!(plan.faces.iter().all(|face| face.kind == Kind::Wall));
    }
}
