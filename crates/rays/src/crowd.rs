//! Trees over the boxes that can be entered from one place, where those are many: a path asks a few of them, and not all.
//!
//! A tree lies in a list of whole numbers as shaders/rays/trace.wgsl reads it: its nodes one after another, each before those
//! below it, so that a path goes through them without a stack. A node that is missed is followed by the one after all below it.

use antipode_deformation::Placed;
use bytemuck::{Pod, Zeroable};
use glam::{DMat3, DVec3, Vec3};

use crate::tree::NOTHING;

/// As few boxes as this are asked one after another: their numbers are the bytes of two words.
const FEW: usize = 8;
/// Words of a node: its least corner, the word after all below it, its greatest corner, and its box or [`NOTHING`].
const NODE_WORDS: usize = 8;
/// How far a node reaches beyond its boxes, as a share of its numbers: more than 32 bits round off.
const ROUNDING: f64 = 1e-5;

/// The boxes that can be entered from one place, as space.wgsl has them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Near {
    /// The numbers of a few, one a byte.
    few: [u32; 2],
    few_count: u32,
    /// Where the tree of many begins in the list, or [`NOTHING`].
    crowd: u32,
}

impl Near {
    /// Of the boxes of those numbers; where they are many, appends their tree to `words`.
    pub fn new(words: &mut Vec<u32>, placed: &[Placed], numbers: &[u8]) -> Self {
        let mut few = [0; FEW];
        if !is_crowd(numbers) {
            few[..numbers.len()].copy_from_slice(numbers);
            return Self {
                few: bytemuck::cast(few),
                few_count: numbers.len() as u32,
                crowd: NOTHING,
            };
        }
        let crowd = words.len() as u32;
        let mut boxes: Vec<_> = numbers.iter().map(|it| bounds(placed, *it)).collect();
        node(words, &mut boxes);
        Self {
            few: bytemuck::cast(few),
            few_count: 0,
            crowd,
        }
    }
}

/// Whether boxes are so many that there is a tree of them.
pub fn is_crowd(numbers: &[u8]) -> bool {
    numbers.len() > FEW
}

/// A box's number and its bounds along the scene's axes.
#[derive(Clone, Copy)]
struct Bounds {
    number: u8,
    low: DVec3,
    high: DVec3,
}

/// Of a turned box with half sizes h along its axes R, the half sizes along the scene's are |R| h.
fn bounds(placed: &[Placed], number: u8) -> Bounds {
    let it = &placed[usize::from(number)];
    let axes = DMat3::from_cols(
        it.axes.x_axis.abs(),
        it.axes.y_axis.abs(),
        it.axes.z_axis.abs(),
    );
    let reach = axes * it.aberration.half;
    Bounds {
        number,
        low: it.aberration.centre - reach,
        high: it.aberration.centre + reach,
    }
}

/// Appends a node and all below it: halves of the boxes, parted across the longest side of their middles.
fn node(words: &mut Vec<u32>, boxes: &mut [Bounds]) {
    let low = (boxes.iter().map(|it| it.low)).fold(DVec3::INFINITY, DVec3::min);
    let high = (boxes.iter().map(|it| it.high)).fold(DVec3::NEG_INFINITY, DVec3::max);
    let slack = ROUNDING * (1.0 + low.abs().max(high.abs()).max_element());
    let at = words.len();
    words.resize(at + NODE_WORDS, NOTHING);
    write(&mut words[at..], (low - slack).as_vec3());
    write(&mut words[at + 4..], (high + slack).as_vec3());
    match boxes {
        [one] => words[at + 7] = u32::from(one.number),
        more => {
            let middle = |it: &Bounds| it.low + it.high;
            let least = more.iter().map(middle).fold(DVec3::INFINITY, DVec3::min);
            let most = more
                .iter()
                .map(middle)
                .fold(DVec3::NEG_INFINITY, DVec3::max);
            let axis = (most - least).max_position();
            more.sort_by(|a, b| middle(a)[axis].total_cmp(&middle(b)[axis]));
            let (left, right) = more.split_at_mut(more.len() / 2);
            node(words, left);
            node(words, right);
        }
    }
    words[at + 3] = words.len() as u32;
}

fn write(words: &mut [u32], corner: Vec3) {
    for (word, number) in words.iter_mut().zip(corner.to_array()) {
        *word = number.to_bits();
    }
}
