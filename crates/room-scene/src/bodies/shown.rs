//! What is seen and met of bodies: who stands astride a portal is on both sides of it, cut at the plane, and astride a door of an
//! aberration as large on either side as things are there.

use antipode_deformation::{Place, SceneHit, SceneQuery, Solids, Space, Triangle, Triangles, half};
use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::{Bodies, Body, Owner};

/// A body, or what of it is on the far side of a portal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// Whose it is.
    pub owner: Owner,
    /// From metres of its own size about its middle to the scene.
    pub pose: DAffine3,
    /// Only what is before this plane is there: n.x >= d.
    pub cut: Option<(DVec3, f64)>,
}

impl Bodies {
    /// All bodies as they are at a share of the way of the last step.
    pub fn shown(&self, space: &Space, share: f64) -> Vec<Solid> {
        self.loose()
            .flat_map(|body| body.shown(space, share))
            .collect()
    }

    /// What who walks and what flies meets of them now.
    pub fn solids(&self, space: &Space) -> Triangles {
        let of = |body: &Body| -> Vec<Triangle> {
            let parts = body.shown(space, 1.0);
            parts.iter().flat_map(|it| body.triangles(it)).collect()
        };
        Triangles::new(self.loose().flat_map(of).collect())
    }
}

impl Body {
    /// Where it is, and how turned, at a share of the way of the last step.
    pub fn between(&self, space: &Space, share: f64) -> (Place, DQuat) {
        let (was, turned) = &self.was;
        let place = Place::between(space, was, &self.place, share);
        let turn = if was.passage == self.place.passage {
            turned.slerp(self.turn, share)
        } else if place.passage == self.place.passage {
            self.turn
        } else {
            *turned
        };
        (place, turn)
    }

    fn shown(&self, space: &Space, share: f64) -> Vec<Solid> {
        let (place, turn) = self.between(space, share);
        let squeeze = if place.stack == self.place.stack {
            self.squeeze
        } else {
            let who = antipode_deformation::Traveller::Body;
            space.squeeze(&place.stack, self.velocity, &who)
        };
        let pose = DAffine3::from_mat3_translation(
            squeeze * place.scale * DMat3::from_quat(turn),
            place.point,
        ) * DAffine3::from_translation(-self.middle);
        let whole = Solid {
            owner: self.owner,
            pose,
            cut: None,
        };
        let mut solids = vec![whole];
        for (number, front) in self.openings(space) {
            let portal = &space.portals()[number];
            let partner = &space.portals()[portal.portal.to];
            let sign = if front { 1.0 } else { -1.0 };
            let behind = |it: &DVec3| sign * portal.before(pose.transform_point3(*it)) < 0.0;
            if !self.surface.iter().flatten().any(behind) {
                continue;
            }
            let plane = |normal: DVec3, at: DVec3| (normal, normal.dot(at));
            solids[0].cut = Some(plane(portal.normal * sign, portal.portal.at));
            solids.push(Solid {
                pose: portal.map * pose,
                cut: Some(plane(partner.normal * sign, partner.portal.at)),
                ..whole
            });
        }
        // What is thrown is small enough to change at its middle.
        if solids.len() == 1 && matches!(self.owner, Owner::Object(_)) {
            self.part_by_doors(space, &mut solids);
        }
        solids
    }

    /// Parts what stands astride a door of an aberration.
    fn part_by_doors(&self, space: &Space, solids: &mut Vec<Solid>) {
        let whole = solids[0];
        let corners = || self.surface.iter().flatten();
        for door in self.doors(space, self.reach_m) {
            let beyond = |it: &DVec3| door.before(whole.pose.transform_point3(*it)) < 0.0;
            if corners().any(beyond) {
                let least = door.normal.dot(door.at);
                solids[0].cut = Some((door.normal, least));
                solids.push(Solid {
                    pose: door.pose_beyond(&whole.pose, &self.squeeze),
                    cut: Some((-door.normal, -least)),
                    ..whole
                });
                return;
            }
        }
    }

    /// Whether it stands astride a portal, or a door of an aberration.
    pub fn is_astride(&self, space: &Space) -> bool {
        self.shown(space, 1.0).len() > 1
    }

    fn triangles(&self, solid: &Solid) -> Vec<Triangle> {
        let object = solid.owner.number();
        let placed = self
            .surface
            .iter()
            .map(|it| it.map(|corner| solid.pose.transform_point3(corner)));
        let Some((normal, least)) = solid.cut else {
            return placed.map(|corners| Triangle { corners, object }).collect();
        };
        let mut kept = Vec::new();
        for corners in placed {
            let piece = half(&corners, |it| normal.dot(it) - least);
            for pair in piece.windows(2).skip(1) {
                let corners = [piece[0], pair[0], pair[1]];
                kept.push(Triangle { corners, object });
            }
        }
        kept
    }
}

/// What stands, and what is loose.
#[derive(Clone, Copy)]
pub struct LooseSolids<'a> {
    pub standing: &'a Solids,
    pub loose: &'a Triangles,
}

impl SceneQuery for LooseSolids<'_> {
    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit> {
        let standing = self.standing.first(x, v, longest);
        let longest = standing.map_or(longest, |it| it.time);
        self.loose.first(x, v, longest).or(standing)
    }

    fn near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3])) {
        self.standing.near(low, high, show);
        self.loose.near(low, high, show);
    }
}
