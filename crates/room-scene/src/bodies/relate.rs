//! Which bodies are near each other, by which ways, and the charts in which they are laid out together.

use std::collections::{BTreeSet, VecDeque};

use antipode_deformation::{PlacedPortal, Space, crossing_out};
use glam::DVec3;

use super::frame::Frame;
use super::{Around, Bodies, Body, Owner};

/// What is nearer to each other than this, metres of the chart, may meet in a step, besides what speed makes of it.
const NEAR_M: f64 = 0.04;

/// Two bodies that are near each other.
struct Tie {
    from: usize,
    to: usize,
    /// From the chart of the first to that of the second.
    frame: Frame,
}

impl Bodies {
    /// Lays all bodies out for the next `time` seconds, and shows rapier where they are and what is solid there; who may meet.
    pub fn lay_out(&mut self, around: &Around<'_>, time: f64) -> BTreeSet<(usize, usize)> {
        let ties = ties(&self.all, around, time);
        self.clear_hands(&ties);
        let frames = frames(self.all.len(), &ties);
        for (number, frame) in frames.iter().enumerate() {
            let body = &mut self.all[number];
            if body.frame != *frame {
                (body.frame, body.laid) = (*frame, None);
            }
            if body.laid.is_none() {
                self.solver.resize(number, body.place.scale * frame.scale);
                let motion = frame.motion(&body.motion());
                self.solver.set_motion(number, &motion);
                body.laid = self.solver.motion(number).map(|it| it.place);
                body.rests = false;
            }
            if !body.rests && body.owner != Owner::Walker {
                body.tread(number, around, &mut self.solver, time);
            }
        }
        let meet = |tie: &&Tie| frames[tie.to].after(&tie.frame).is_like(&frames[tie.from]);
        let pair = |tie: &Tie| (tie.from.min(tie.to), tie.from.max(tie.to));
        // Who holds something is not in its way, nor in that of what leaves their hands.
        let is_walker = |it: usize| self.all[it].owner == Owner::Walker;
        let in_hand = |it: usize| self.all[it].held || self.all[it].leaves;
        let free = |tie: &&Tie| {
            !(in_hand(tie.from) && is_walker(tie.to) || in_hand(tie.to) && is_walker(tie.from))
        };
        ties.iter().filter(meet).filter(free).map(pair).collect()
    }

    /// What has left the hands of who walks, and is no longer near them, may meet them again.
    fn clear_hands(&mut self, ties: &[Tie]) {
        let Some(walker) = self.all.iter().position(|it| it.owner == Owner::Walker) else {
            return;
        };
        for number in 0..self.all.len() {
            let near = |it: &Tie| {
                (it.from, it.to) == (number, walker) || (it.to, it.from) == (number, walker)
            };
            if self.all[number].leaves && !ties.iter().any(near) {
                self.all[number].leaves = false;
            }
        }
    }
}

/// For each body the frame from its chart to that of the first body that it is tied to, by however many ties. Where all are in
/// one chart nothing is moved.
fn frames(count: usize, ties: &[Tie]) -> Vec<Frame> {
    let mut known: Vec<Option<Frame>> = vec![None; count];
    for root in 0..count {
        if known[root].is_some() {
            continue;
        }
        known[root] = Some(Frame::default());
        let mut next = VecDeque::from([root]);
        while let Some(at) = next.pop_front() {
            let here = known[at].unwrap_or_default();
            for tie in ties {
                let (other, frame) = if tie.from == at {
                    (tie.to, here.after(&tie.frame.inverse()))
                } else if tie.to == at {
                    (tie.from, here.after(&tie.frame))
                } else {
                    continue;
                };
                if known[other].is_none() {
                    known[other] = Some(frame);
                    next.push_back(other);
                }
            }
        }
    }
    known.into_iter().map(Option::unwrap_or_default).collect()
}

/// How far a body reaches in its chart within a step.
fn reach(body: &Body, around: &Around<'_>, time: f64) -> f64 {
    let goes = (body.velocity.length() + around.g.length() * time) * time;
    (body.reach_m + goes) * body.place.scale + 0.5 * NEAR_M
}

fn ties(all: &[Body], around: &Around<'_>, time: f64) -> Vec<Tie> {
    let reaches: Vec<_> = all.iter().map(|it| reach(it, around, time)).collect();
    let charts: Vec<_> = all.iter().map(|it| it.motion().place).collect();
    let openings: Vec<_> = all.iter().map(|it| it.openings(around.space)).collect();
    let mut ties = Vec::new();
    for from in 0..all.len() {
        for to in from + 1..all.len() {
            let (a, b) = (&all[from], &all[to]);
            let parted = |opening: &(usize, bool)| b.side(around.space, opening.0) != opening.1;
            let parts = |opening: &(usize, bool)| a.side(around.space, opening.0) != opening.1;
            if openings[from].iter().any(parted) || openings[to].iter().any(parts) {
                continue;
            }
            let Some(frame) = a.to_chart_of(b, around.space) else {
                continue;
            };
            if frame.place(charts[from]).distance(charts[to]) < reaches[from] + reaches[to] {
                ties.push(Tie { from, to, frame });
            }
        }
    }
    for (from, (number, front)) in openings
        .iter()
        .enumerate()
        .flat_map(|(from, all)| all.iter().map(move |it| (from, *it)))
    {
        let portal = &around.space.portals()[number];
        let partner = &around.space.portals()[portal.portal.to];
        let frame = Frame::through(portal, partner);
        let image = frame.place(charts[from]);
        let seen = reaches[from] * frame.scale;
        let beyond = |to: &usize| {
            let other = &all[*to];
            *to != from
                && other.place.stack == partner.stack
                && other.side(around.space, portal.portal.to) == front
                && image.distance(charts[*to]) < seen + reaches[*to]
        };
        let found = (0..all.len()).filter(beyond);
        ties.extend(found.map(|to| Tie { from, to, frame }));
    }
    ties
}

impl Body {
    fn is_in_chart_of(&self, other: &Self) -> bool {
        self.place.stack == other.place.stack && self.squeeze == other.squeeze
    }

    /// Before the front of which portal it is.
    fn side(&self, space: &Space, number: usize) -> bool {
        let (place, portal) = (&self.place, &space.portals()[number]);
        portal.side(number, place.point, -portal.normal, place.passage)
    }

    /// The portals through which it reaches, and whether from before their front.
    pub fn openings(&self, space: &Space) -> Vec<(usize, bool)> {
        let out = self.out().abs();
        let reach = (out * DVec3::ONE).max_element() * self.reach_m;
        let all = space.portals().iter().enumerate();
        let near = all.filter(|(_, portal)| comes_to(portal, self.place.point, reach));
        let sides = near.map(|(number, portal)| (number, portal, self.side(space, number)));
        sides
            .filter(|(_, portal, front)| portal.is_open(*front))
            .map(|(number, _, front)| (number, front))
            .collect()
    }

    /// From its chart to that of another that it may meet without a portal between them; none where a wall parts them.
    fn to_chart_of(&self, other: &Self, space: &Space) -> Option<Frame> {
        if self.is_in_chart_of(other) {
            return Some(Frame::default());
        }
        let (here, there) = (&self.place, &other.place);
        let only_in = |a: &Self, b: &Self| -> Vec<usize> {
            a.place
                .stack
                .iter()
                .filter(|it| !b.place.stack.contains(*it))
                .collect()
        };
        let (mine, yours) = (only_in(self, other), only_in(other, self));
        let (inside, outside, number) = match (&mine[..], &yours[..]) {
            ([one], []) => (here.point, there.point, Some(*one)),
            ([], [one]) => (there.point, here.point, Some(*one)),
            _ => (here.point, there.point, None),
        };
        let mut face = 0.5 * (inside + outside);
        if let Some(placed) = number.map(|it| &space.placed()[it]) {
            let way = outside - inside;
            let u = placed.axes.transpose() * way;
            let (share, axis) = crossing_out(placed.local(inside), u, placed.aberration.half);
            if placed.aberration.is_wall(axis) {
                return None;
            }
            face = inside + way * share.min(1.0);
        }
        Some(Frame::across(&self.squeeze, &other.squeeze, face))
    }
}

/// Whether a ball in the scene reaches a portal.
fn comes_to(portal: &PlacedPortal, point: DVec3, reach: f64) -> bool {
    let local = portal.local(point);
    portal.before(point).abs() < reach
        && portal
            .edges
            .iter()
            .all(|edge| edge.truncate().dot(local) >= edge.z - reach)
}
