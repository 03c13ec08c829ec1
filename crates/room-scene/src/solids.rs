//! What one meets in a room, as it is known to whoever looks at rooms. After a change only what is another than before is made anew.

use std::collections::HashMap;
use std::mem::take;
use std::sync::Arc;

use antipode_deformation::{Aberration, Form, Solids, Space, Standing};
use antipode_rooms::mesh::{Shape, Shapes, SolidMesh};
use antipode_rooms::solids::standing_again;
use antipode_rooms::{Assets, Room, SpaceParts};
use glam::{DAffine3, DVec3};

/// What was made for a room so far, to be used again.
#[derive(Clone, Debug, Default)]
pub struct Known {
    shapes: Shapes,
    forms: Forms,
    parts: SpaceParts,
    spaces: usize,
}

/// Shapes as forms, by where they lie in memory; each is kept there, so that no other comes to lie there.
#[derive(Clone, Debug, Default)]
struct Forms {
    known: HashMap<usize, (Arc<Shape>, Arc<Form>)>,
    used: HashMap<usize, (Arc<Shape>, Arc<Form>)>,
    made: usize,
}

/// How often something was made anew since the room was opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Remade {
    /// Shapes of solids, each a list of triangles.
    pub shapes: usize,
    /// Hierarchies of such lists.
    pub forms: usize,
    /// Spaces of all aberrations and portals.
    pub spaces: usize,
}

impl Known {
    /// Makes the space of a room that has changed, and tells the objects of its aberrations and portals; it is left as it is
    /// where none of them has changed.
    pub fn renew_space(
        &mut self,
        room: &Room,
        (space, boxes, portals): (&mut Space, &mut Vec<usize>, &mut Vec<usize>),
    ) {
        let parts = SpaceParts::of(room);
        if self.spaces > 0 && parts.make_the_space_of(&self.parts) {
            for index in boxes.iter_mut().chain(portals) {
                *index = parts.now_of(&self.parts, *index).unwrap_or(*index);
            }
        } else {
            self.spaces += 1;
            let so_far = parts.space();
            (*space, *boxes, *portals) = (so_far.space, so_far.boxes, so_far.portals);
        }
        self.parts = parts;
    }

    /// All aberrations of the room, those that do not fit among them.
    pub fn boxes(&self) -> impl Iterator<Item = &Aberration> {
        self.parts.boxes()
    }

    /// Meshes of what stands, and of what is loose, in a room whose objects have these poses.
    pub fn meshes(
        &mut self,
        (room, poses): (&Room, &[DAffine3]),
        assets: &Assets,
    ) -> (Vec<SolidMesh>, Vec<SolidMesh>) {
        let stands = |mesh: &SolidMesh| room.objects[mesh.object].mass.is_none();
        let all = standing_again((room, poses), assets, &mut self.shapes);
        all.into_iter().partition(stands)
    }

    /// What is met of meshes that stand, and the lowest of those that are loose, metres along `up`.
    pub fn solids(
        &mut self,
        standing: &[SolidMesh],
        loose: &[SolidMesh],
        up: DVec3,
    ) -> (Solids, f64) {
        let stands = standing.iter().map(|it| self.forms.stand(it)).collect();
        let lowest = |mesh: &SolidMesh| self.forms.of(&mesh.shape).lowest(&mesh.pose, up);
        let lowest = loose.iter().map(lowest).fold(f64::INFINITY, f64::min);
        self.forms.end_round();
        (Solids::new(stands), lowest)
    }

    /// How often what was made anew.
    pub fn remade(&self) -> Remade {
        Remade {
            shapes: self.shapes.made(),
            forms: self.forms.made,
            spaces: self.spaces,
        }
    }
}

impl Forms {
    fn of(&mut self, shape: &Arc<Shape>) -> Arc<Form> {
        let key = Arc::as_ptr(shape).addr();
        if let Some((_, form)) = self.used.get(&key) {
            return form.clone();
        }
        let known = self.known.remove(&key).unwrap_or_else(|| {
            self.made += 1;
            let form = Form::new(shape.positions.clone(), shape.triangles.clone());
            (shape.clone(), Arc::new(form))
        });
        let form = known.1.clone();
        self.used.insert(key, known);
        form
    }

    fn stand(&mut self, mesh: &SolidMesh) -> Standing {
        Standing {
            form: self.of(&mesh.shape),
            pose: mesh.pose,
            object: mesh.object as u32,
        }
    }

    /// What this round over all meshes has not asked for is forgotten.
    fn end_round(&mut self) {
        self.known = take(&mut self.used);
    }
}
