//! What shapes promise, of every species, age and size.

use glam::Vec3;

use super::{Material, Shape, Size, shape};
use crate::species::{Age, Species};

/// Every plant.
fn plants() -> impl Iterator<Item = (Species, Age)> {
    Species::ALL
        .into_iter()
        .flat_map(|species| Age::ALL.map(|age| (species, age)))
}

#[test]
fn triangles_stay_within_their_budgets() {
    for (species, age) in plants() {
        let budgets = [40..=620, 15..=84, 12..=36, 5..=12];
        for (size, budget) in Size::ALL.into_iter().zip(budgets) {
            let count = shape(species, age, size).triangles.len();
            assert!(
                budget.contains(&count),
                "{species:?} {age:?} {size:?}: {count}"
            );
        }
    }
}

#[test]
fn shapes_are_sound() {
    for (species, age) in plants() {
        for size in Size::ALL {
            let shape = shape(species, age, size);
            for corner in &shape.corners {
                assert!(
                    corner.place.is_finite() && (corner.normal.length() - 1.0).abs() < 1e-3,
                    "{corner:?}"
                );
                assert!(
                    (0.0..=1.0).contains(&corner.sway) && corner.place.y <= 26.0,
                    "{corner:?}"
                );
                assert!(corner.place.x.hypot(corner.place.z) <= 14.0, "{corner:?}");
            }
            let outward = shape.triangles.iter().filter(|triangle| {
                let [a, b, c] = triangle.map(|corner| shape.corners[corner as usize]);
                let face = (b.place - a.place).cross(c.place - a.place);
                face.dot(a.normal + b.normal + c.normal) > 0.0
            });
            let part = outward.count() as f32 / shape.triangles.len() as f32;
            assert!(
                part >= 0.9,
                "{species:?} {age:?} {size:?}: {part} of the faces turn outward"
            );
        }
    }
}

/// How far a shape reaches from the upright line through its root.
fn reach(shape: &Shape) -> f32 {
    shape
        .corners
        .iter()
        .map(|corner| corner.place.x.hypot(corner.place.z))
        .fold(0.0, f32::max)
}

#[test]
fn no_edge_close_by_is_long_upward() {
    for (species, age) in plants() {
        let shape = shape(species, age, Size::Near);
        for triangle in &shape.triangles {
            let heights = triangle.map(|corner| shape.corners[corner as usize].place.y);
            let [low, high] = [
                heights.into_iter().fold(f32::MAX, f32::min),
                heights.into_iter().fold(f32::MIN, f32::max),
            ];
            assert!(high - low <= 1.95, "{species:?} {age:?}: {}", high - low);
        }
    }
}

#[test]
fn lengths_agree_with_shapes() {
    for (species, age) in plants() {
        let shape = shape(species, age, Size::Near);
        let pairs = [
            (shape.limits()[1].y, species.height_m(age)),
            (reach(shape), species.radius_m(age)),
        ];
        for (is, said) in pairs {
            let ratio = is / said as f32;
            assert!(
                (0.85..=1.15).contains(&ratio),
                "{species:?} {age:?}: {is} for {said}"
            );
        }
    }
}

#[test]
fn simpler_shapes_reach_as_far() {
    for (species, age) in plants() {
        let extent = |size| {
            let [low, high] = shape(species, age, size).limits();
            // What is under the ground does not count.
            high - low.max(Vec3::new(f32::MIN, 0.0, f32::MIN))
        };
        let near = extent(Size::Near);
        for size in [Size::Middle, Size::Coarse, Size::Far] {
            let ratio = extent(size) / near;
            // The turn about the upright line is free, so that the two ways sideways count as one.
            let sideways = (ratio.x * ratio.z).sqrt();
            assert!(
                (0.8..=1.2).contains(&ratio.y),
                "{species:?} {age:?} {size:?}: {ratio}"
            );
            assert!(
                (0.8..=1.2).contains(&sideways),
                "{species:?} {age:?} {size:?}: {ratio}"
            );
        }
    }
}

/// Where triangles cut a height: the mean distance of those places of wood from their middle.
fn girth(shape: &Shape, height: f32) -> f32 {
    let mut cuts = Vec::new();
    for triangle in &shape.triangles {
        let corners = triangle.map(|corner| shape.corners[corner as usize]);
        for i in 0..3 {
            let (a, b) = (corners[i], corners[(i + 1) % 3]);
            if a.material == Material::Wood && (a.place.y - height) * (b.place.y - height) < 0.0 {
                cuts.push(
                    a.place
                        .lerp(b.place, (height - a.place.y) / (b.place.y - a.place.y)),
                );
            }
        }
    }
    let middle = cuts.iter().sum::<Vec3>() / cuts.len() as f32;
    cuts.iter().map(|cut| cut.distance(middle)).sum::<f32>() / cuts.len() as f32
}

#[test]
fn trunks_are_as_stout_as_told() {
    for (species, age) in plants().filter(|(species, _)| species.is_tree()) {
        let trunk = species.trunk(age).expect("a tree has a trunk");
        let height = (0.12 * species.height_m(age)).max(2.7 * trunk.radius_m);
        let ratio = girth(shape(species, age, Size::Near), height as f32) / trunk.radius_m as f32;
        assert!(
            (0.8..=1.2).contains(&ratio),
            "{species:?} {age:?}: {ratio} at {height} m"
        );
    }
}

/// How many places a silhouette has on a side.
const GRID: usize = 64;

/// What a shape hides, seen along z, where its height fills the grid.
fn silhouette(shape: &Shape) -> Vec<bool> {
    let mut hidden = vec![false; GRID * GRID];
    let scale = GRID as f32 / shape.limits()[1].y;
    for triangle in &shape.triangles {
        let corners = triangle.map(|corner| shape.corners[corner as usize].place);
        let [a, b, c] = corners.map(|place| [place.x * scale + GRID as f32 / 2.0, place.y * scale]);
        let side = |p: [f32; 2], q: [f32; 2], r: [f32; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        for (i, hidden) in hidden.iter_mut().enumerate() {
            let at = [(i % GRID) as f32 + 0.5, (i / GRID) as f32 + 0.5];
            let sides = [side(a, b, at), side(b, c, at), side(c, a, at)];
            *hidden |= sides.iter().all(|&s| s >= 0.0) || sides.iter().all(|&s| s <= 0.0);
        }
    }
    hidden
}

#[test]
fn trees_are_told_apart_by_their_silhouettes() {
    let trees = &Species::ALL[..9];
    let masks: Vec<_> = trees
        .iter()
        .map(|&tree| silhouette(shape(tree, Age::Grown, Size::Near)))
        .collect();
    for (i, one) in masks.iter().enumerate() {
        for (j, other) in masks.iter().enumerate().skip(i + 1) {
            let count = |both: fn(bool, bool) -> bool| {
                one.iter().zip(other).filter(|&(&a, &b)| both(a, b)).count()
            };
            let overlap = count(|a, b| a && b) as f32 / count(|a, b| a || b) as f32;
            assert!(
                overlap <= 0.7,
                "{:?} and {:?}: {overlap}",
                trees[i],
                trees[j]
            );
        }
    }
}

#[test]
fn numbers_find_their_species_and_ages() {
    assert!(
        Species::ALL
            .into_iter()
            .all(|species| Species::of_byte(species.byte()) == Some(species))
    );
    assert!(
        Age::ALL
            .into_iter()
            .all(|age| Age::of_byte(age.byte()) == Some(age))
    );
    assert_eq!((Species::of_byte(0), Age::of_byte(3)), (None, None));
}
