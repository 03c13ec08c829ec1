//! Halving of edges near the eye, so that straight drawn edges follow the bent ones of the chart.
//!
//! Whether an edge is halved depends on nothing but the edge, so that triangles on both sides of it agree, in
//! two chunks too, and no crack opens. A triangle with one, two or three halved edges becomes two, three or
//! four.

use antipode_terrain::{ChunkMesh, Vertex};
use glam::Vec3;

use super::refine::RefineRules;
use crate::parts::{Part, SECTIONS, parts, sections};

mod blocks;

/// A chunk's mesh with edges halved, ready to be put into pages.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined {
    /// The mesh, its surface in blocks; no parts where no edge needed halving.
    pub parts: Vec<Part>,
    /// How many edges were halved.
    pub halved: usize,
    /// The largest stray of an edge near the eye that stayed as it is, pixels.
    pub error_px: f64,
}

/// Halves the edges of one mesh after another, with the same memory.
#[derive(Debug, Default)]
pub struct Subdivider {
    vertices: Vec<Vertex>,
    positions: Vec<Vec3>,
    middles: EdgeTable,
    open: Vec<[u32; 3]>,
    next: Vec<[u32; 3]>,
    done: Vec<[u32; 3]>,
    halved: usize,
    /// The largest stray of an edge that stays, in tolerances.
    worst: f32,
}

impl Subdivider {
    /// The mesh with its edges near the eyes halved, which are metres from the chunk's corner.
    pub fn refine(&mut self, rules: &RefineRules, eyes: &[Vec3], mesh: &ChunkMesh) -> Refined {
        self.begin(mesh);
        let far_m = rules.reach_m() + 1.733 * mesh.level.step_m() as f32;
        let near = |p: &Vec3| {
            let near_to = |eye: &Vec3| p.distance_squared(*eye) < far_m * far_m;
            eyes.iter().any(near_to)
        };
        let near: Vec<bool> = self.positions.iter().map(near).collect();
        let mut starts = [0; SECTIONS + 1];
        for (number, section) in sections(mesh).into_iter().enumerate() {
            for corners in section.as_chunks::<3>().0 {
                if corners.iter().any(|&i| near[i as usize]) {
                    self.open.push(*corners);
                } else {
                    self.done.push(*corners);
                }
            }
            self.divide_all(rules, eyes);
            starts[number + 1] = self.done.len();
        }
        Refined {
            parts: if self.halved > 0 {
                self.parts(&starts)
            } else {
                Vec::new()
            },
            halved: self.halved,
            error_px: f64::from(self.worst) * rules.shape_px(),
        }
    }

    /// What was done, the surface in blocks; each section's first triangle is given.
    fn parts(&mut self, starts: &[usize; SECTIONS + 1]) -> Vec<Part> {
        let blocks = blocks::arrange(&mut self.done[..starts[1]], &self.positions);
        let done = self.done.as_flattened();
        let section = |n: usize| &done[3 * starts[n]..3 * starts[n + 1]];
        parts(&self.vertices, std::array::from_fn(section), &blocks)
    }

    fn begin(&mut self, mesh: &ChunkMesh) {
        self.vertices.clone_from(&mesh.vertices);
        self.positions.clear();
        self.positions
            .extend(mesh.vertices.iter().map(Vertex::position));
        self.middles.clear();
        self.open.clear();
        self.done.clear();
        self.halved = 0;
        self.worst = 0.0;
    }

    /// Divides the open triangles until their edges keep to the tolerance, or were halved as often as they may be.
    fn divide_all(&mut self, rules: &RefineRules, eyes: &[Vec3]) {
        for _ in 0..rules.halvings() {
            let mut open = std::mem::take(&mut self.open);
            self.open = std::mem::take(&mut self.next);
            for corners in open.drain(..) {
                self.divide(rules, eyes, corners);
            }
            self.next = open;
        }
        for [a, b, c] in std::mem::take(&mut self.open) {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                self.worst = self.worst.max(self.strays(rules, eyes, a, b));
            }
            self.done.push([a, b, c]);
        }
    }

    /// Opens the triangles that a triangle becomes; one that needs no halving is done.
    fn divide(&mut self, rules: &RefineRules, eyes: &[Vec3], [a, b, c]: [u32; 3]) {
        let middles = [(a, b), (b, c), (c, a)].map(|(a, b)| self.middle(rules, eyes, a, b));
        let open = &mut self.open;
        match middles {
            [None, None, None] => self.done.push([a, b, c]),
            [Some(ab), Some(bc), Some(ca)] => {
                open.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
            }
            [Some(ab), None, None] => open.extend([[a, ab, c], [ab, b, c]]),
            [None, Some(bc), None] => open.extend([[b, bc, a], [bc, c, a]]),
            [None, None, Some(ca)] => open.extend([[c, ca, b], [ca, a, b]]),
            [Some(ab), Some(bc), None] => open.extend([[ab, b, bc], [a, ab, bc], [a, bc, c]]),
            [None, Some(bc), Some(ca)] => open.extend([[bc, c, ca], [b, bc, ca], [b, ca, a]]),
            [Some(ab), None, Some(ca)] => open.extend([[ca, a, ab], [c, ca, ab], [c, ab, b]]),
        }
    }

    /// By what multiple of the tolerance an edge strays from its true picture, at most.
    #[inline]
    fn strays(&self, rules: &RefineRules, eyes: &[Vec3], a: u32, b: u32) -> f32 {
        let [p, q] = [a, b].map(|i| self.positions[i as usize]);
        rules.strays(p.distance_squared(q), p.midpoint(q), eyes)
    }

    /// The middle of an edge that is to be halved.
    #[inline]
    fn middle(&mut self, rules: &RefineRules, eyes: &[Vec3], a: u32, b: u32) -> Option<u32> {
        let strays = self.strays(rules, eyes, a, b);
        if strays <= 1.0 {
            self.worst = self.worst.max(strays);
            return None;
        }
        let next = self.vertices.len() as u32;
        let index = self.middles.entry(a, b, next);
        if index == next {
            let [from, to] = [a, b].map(|i| &self.vertices[i as usize]);
            let middle = Vertex::between(from, to);
            self.positions.push(middle.position());
            self.vertices.push(middle);
            self.halved += 1;
        }
        Some(index)
    }
}

/// The middles of halved edges: a hash table with open addressing and linear probing, at most half full. The
/// library's table takes three times as long for keys that are as plain as these, and that is most of a halving.
#[derive(Debug, Default)]
struct EdgeTable {
    /// Both ends, the smaller in the high half, and the middle. A power of two of them.
    slots: Vec<(u64, u32)>,
    taken: usize,
}

/// Both ends of an edge are the same vertex: no edge.
const NO_EDGE: u64 = 0;
const FIRST_SLOTS: usize = 1 << 12;

impl EdgeTable {
    fn clear(&mut self) {
        self.slots.fill((NO_EDGE, 0));
        self.taken = 0;
    }

    /// The middle of the edge between two different vertices, which is `next` if it has none yet.
    #[inline]
    fn entry(&mut self, a: u32, b: u32, next: u32) -> u32 {
        if 2 * self.taken >= self.slots.len() {
            self.grow();
        }
        let key = u64::from(a.min(b)) << 32 | u64::from(a.max(b));
        let place = place(&self.slots, key);
        let slot = &mut self.slots[place];
        if slot.0 == NO_EDGE {
            *slot = (key, next);
            self.taken += 1;
        }
        slot.1
    }

    fn grow(&mut self) {
        let room = (2 * self.slots.len()).max(FIRST_SLOTS);
        let old = std::mem::replace(&mut self.slots, vec![(NO_EDGE, 0); room]);
        for slot in old.into_iter().filter(|slot| slot.0 != NO_EDGE) {
            let place = place(&self.slots, slot.0);
            self.slots[place] = slot;
        }
    }
}

/// Where an edge stands in the table, or where there is room for it.
#[inline]
fn place(slots: &[(u64, u32)], key: u64) -> usize {
    let mask = slots.len() - 1;
    // Fibonacci hashing; the high bits are the well mixed ones.
    let mut at = (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & mask;
    while slots[at].0 != NO_EDGE && slots[at].0 != key {
        at = (at + 1) & mask;
    }
    at
}

#[cfg(test)]
mod tests;
