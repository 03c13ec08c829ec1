//! What one can sit on, told by the shape that is seen: a stone is lower at its edge than in its middle.

use antipode_terrain::Thing;
use glam::{Vec2, Vec3};

use crate::shape::{Size, shape};
use crate::species::{Age, Species};

/// How high what is seen of a thing is over its root at a place of the plan, metres from the root; none beside it.
pub fn top_m(thing: &Thing, from_root: Vec2) -> Option<f32> {
    let (species, age) = (Species::of_byte(thing.species)?, Age::of_byte(thing.age)?);
    // As pictures turn it.
    let (sin, cos) = thing.turn_rad.sin_cos();
    let at = Vec2::new(
        from_root.x * cos + from_root.y * sin,
        from_root.y * cos - from_root.x * sin,
    ) / thing.scale;
    let shape = shape(species, age, Size::Near);
    let tops = shape.triangles.iter().filter_map(|corners| {
        let corners = corners.map(|corner| shape.corners.get(usize::from(corner)));
        let [a, b, c] = corners.map(|corner| corner.map(|corner| corner.place));
        height_over([a?, b?, c?], at)
    });
    tops.reduce(f32::max).map(|top_m| top_m * thing.scale)
}

/// How high a triangle lies over a place of the plan that it covers.
fn height_over([a, b, c]: [Vec3; 3], at: Vec2) -> Option<f32> {
    let [a2, b2, c2] = [a, b, c].map(|corner| Vec2::new(corner.x, corner.z));
    let twice_area = (b2 - a2).perp_dot(c2 - a2);
    if twice_area.abs() < 1e-9 {
        return None;
    }
    let of_a = (b2 - at).perp_dot(c2 - at) / twice_area;
    let of_b = (c2 - at).perp_dot(a2 - at) / twice_area;
    let of_c = 1.0 - of_a - of_b;
    let covers = of_a.min(of_b).min(of_c) >= -1e-4;
    covers.then_some(of_a * a.y + of_b * b.y + of_c * c.y)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used, reason = "tests fail by panicking")]
    use super::*;

    fn thing(species: Species, age: Age) -> Thing {
        Thing {
            root: Vec3::new(3.0, 8.0, 5.0),
            slot: 0,
            species: species.byte(),
            age: age.byte(),
            turn_rad: 0.7,
            scale: 1.1,
        }
    }

    #[test]
    fn a_stump_is_level_and_a_stone_falls_off_to_its_edge_and_there_is_nothing_beside_them() {
        let stump = thing(Species::Stump, Age::Grown);
        for at in [Vec2::new(0.1, 0.1), Vec2::new(-0.2, 0.0)] {
            let top_m = top_m(&stump, at).expect("wood is there");
            assert!((top_m - 0.495).abs() < 1e-3, "{top_m}");
        }
        let stone = thing(Species::Boulder, Age::Young);
        let [middle, edge] = [0.05, 0.4].map(|x| {
            let around = (0..8).map(|n| Vec2::from_angle(n as f32 * 0.785) * x);
            let tops = around.filter_map(|at| top_m(&stone, at));
            let tops: Vec<f32> = tops.collect();
            tops.iter().sum::<f32>() / tops.len().max(1) as f32
        });
        println!("{middle} m in the middle, {edge} m at the edge");
        assert!((0.4..0.6).contains(&middle) && edge < middle - 0.05);
        assert_eq!(top_m(&stone, Vec2::new(0.9, 0.0)), None);
    }

    #[test]
    fn the_shape_is_turned_as_pictures_turn_it() {
        let turned = thing(Species::Boulder, Age::Young);
        let plain = Thing {
            turn_rad: 0.0,
            ..turned
        };
        let (sin, cos) = 0.7_f32.sin_cos();
        for at in [Vec2::new(0.3, 0.05), Vec2::new(-0.1, 0.25)] {
            // `Baked::add` of the renderer.
            let there = Vec2::new(at.x * cos - at.y * sin, at.x * sin + at.y * cos);
            let [a, b] = [top_m(&plain, at), top_m(&turned, there)].map(|it| it.expect("stone"));
            assert!((a - b).abs() < 1e-3, "{a} and {b}");
        }
    }
}
