//! Pictures of land in tiles, for people to look at.

use std::fmt::Write as _;
use std::fs;
use std::sync::Arc;

use antipode_geometry::tiling::{Frame, equiangular_chart};
use antipode_geometry::{Atlas, ChartId, ChartPoint, HyperbolicWorld, Metric};
use glam::{DVec2, DVec4};

use super::tests::perlin;
use crate::field::Field;
use crate::fractal::AXIS_FREQUENCY;

const SIDE: usize = 460;

/// Where in the conformal disc about the root a pixel is: the chart and the place in it; none outside.
fn place(world: &HyperbolicWorld, radius_m: f64, at: DVec2, rim: f64) -> Option<ChartPoint> {
    let u = at * rim;
    let square = u.length_squared();
    if at.length() > 1.0 {
        return None;
    }
    let level = u * (2.0 / (1.0 - square));
    let point = DVec4::new(level.x, 0.0, level.y, (1.0 + square) / (1.0 - square));
    let place = Frame::ROOT.place(point).ok()?;
    let chart = ChartId::new(place.frame.path().ok()?.number());
    let pos = equiangular_chart(place.point) * radius_m;
    world
        .has_chart(chart)
        .then(|| ChartPoint::new(chart, pos.with_y(0.0)))
}

/// In the conformal disc about the root, to `2 ANTIPODE_RIM` radii: shaded colours, biomes, shaded heights, and an octave.
#[test]
#[ignore = "draws pictures to the folder of ANTIPODE_PICTURES"]
fn draw_land_in_tiles() {
    let folder = std::env::var("ANTIPODE_PICTURES").unwrap();
    let rim: f64 = std::env::var("ANTIPODE_RIM").map_or(1.545, |it| it.parse().unwrap());
    for (n, seed) in [(1, 4_u64), (1, 11), (0, 4), (2, 4)] {
        let world = Arc::new(HyperbolicWorld::new(HyperbolicWorld::RADII_M[n]));
        let radius_m = world.radius_m();
        let field = Field::new(seed, world.clone());
        let rim = (rim).tanh();
        let mut heights = vec![None; SIDE * SIDE];
        let at = |n: usize| {
            let [x, y] = [n % SIDE, n / SIDE].map(|c| (c as f64 + 0.5) * 2.0 / SIDE as f64 - 1.0);
            DVec2::new(x, y)
        };
        for (n, height) in heights.iter_mut().enumerate() {
            if let Some(point) = place(&world, radius_m, at(n), rim) {
                let land_m = field.land_height_at(point.chart, point.pos.x, point.pos.z);
                *height = Some((point, land_m));
            }
        }
        let mut panels = vec![vec![[0_u8; 3]; SIDE * SIDE]; 4];
        for n in 0..SIDE * SIDE - SIDE - 1 {
            let (Some((point, here)), Some((_, right)), Some((_, down))) =
                (heights[n], heights[n + 1], heights[n + SIDE])
            else {
                continue;
            };
            let pixel_m =
                radius_m * rim * (2.0 / SIDE as f64) * 2.0 / (1.0 - (at(n) * rim).length_squared());
            let slope = (here - right + here - down) / pixel_m;
            let shade = (0.65 + 0.7 * slope).clamp(0.1, 1.2);
            let lit = |c: u8, shade: f64| (f64::from(c) * shade).clamp(0.0, 255.0) as u8;
            let colour = field.ground_colours(point)[1];
            let biome = field.biome_at(point).ground_colours()[1];
            panels[0][n] = colour.map(|c| lit(c, shade));
            panels[1][n] = biome;
            panels[2][n] = [lit(200, shade); 3];
            let spot = field.spot(point.chart, point.pos.x, point.pos.z).unwrap();
            let octave = spot.blended(0.0, |at| perlin(field.lattice(), at * AXIS_FREQUENCY * 0.1));
            let grey = (128.0 + 250.0 * octave).clamp(0.0, 255.0) as u8;
            panels[3][n] = [grey; 3];
        }
        fs::write(
            format!("{folder}/land-{n}-{seed}.ppm"),
            beside_each_other(&panels),
        )
        .unwrap();
    }
}

/// A portable pixmap of pictures.
fn beside_each_other(panels: &[Vec<[u8; 3]>]) -> String {
    let mut text = format!("P3 {} {SIDE} 255\n", panels.len() * SIDE);
    for row in 0..SIDE {
        for panel in panels {
            for [r, g, b] in &panel[row * SIDE..][..SIDE] {
                let _ = write!(text, "{r} {g} {b} ");
            }
        }
    }
    text
}
