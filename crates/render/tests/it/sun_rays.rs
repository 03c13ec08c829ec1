//! The picture's shadows of land against rays of the key light that are cast at the same triangles.

use crate::common::Studio;
use crate::common::sun_rays::Rays;
use crate::common::told::told;
use crate::common::triangles::{Surface, triangles};
use crate::common::worlds::World;
use antipode_frame::Dust;
use antipode_geometry::{ChartPoint, Geometry};
use antipode_render::ShadowQuality;
use image::{Rgba, RgbaImage};

/// Pixels this far from an edge of the rays' shadow are not judged.
const EDGE_PX: i32 = 2;

/// What the display makes of half of the light, by the curve of tonemap.wgsl.
const HALF: u8 = 197;

/// Share of the pixels judged that may be wrong.
const MOST_WRONG: f64 = 0.005;

#[derive(Default, Debug)]
struct Found {
    judged: usize,
    /// The picture has shadow where rays arrive.
    acne: usize,
    /// The picture has light where none arrive.
    leaks: usize,
    /// As before, where the triangle itself turns away.
    turned: usize,
}

impl Found {
    fn off(&self) -> usize {
        self.acne + self.leaks + self.turned
    }
}

fn compare(name: &str, world: &mut World, shadows: ShadowQuality) -> Option<Found> {
    let mut frame = world.frame();
    // What building has raised hides land, and is none.
    frame.content_mut().dust = Dust::default();
    judge(name, &frame, world.size(), shadows)
}

fn judge(
    name: &str,
    frame: &antipode_frame::Frame,
    size: (u32, u32),
    shadows: ShadowQuality,
) -> Option<Found> {
    let picture = Studio::with_shaders(size, shadows, told())?.picture(frame);
    let triangles = triangles(&frame.content.land);
    let surface = Surface::of(frame, &triangles, size);
    let rays = Rays::new(frame, &triangles);
    let lit: Vec<Option<bool>> = surface
        .pixels
        .iter()
        .map(|seen| {
            let seen = seen.as_ref()?;
            let triangle = &triangles[seen.triangle as usize];
            let point = ChartPoint::new(triangle.chart, triangle.at(seen.weights));
            Some(rays.is_faced(seen.triangle) && rays.hit(point, seen.triangle).is_none())
        })
        .collect();
    let mut found = Found::default();
    let mut shown = RgbaImage::new(size.0, size.1);
    for (x, y) in (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y))) {
        let pixel = picture.get_pixel(x, y).0;
        let (says_lit, unlit) = (pixel[0] >= HALF, pixel[1] >= HALF);
        let own = lit[(y * size.0 + x) as usize];
        let base = if own == Some(true) { 200 } else { 90 };
        let grey = |v: u8| [v, v, v, 255];
        let colour = match own {
            None => [40, 40, 60, 255],
            Some(_) if unlit => grey(base / 2),
            Some(_) if is_edge(&lit, size, (x, y)) => [base, base, 0, 255],
            Some(own) => {
                found.judged += 1;
                let triangle = surface.get(x, y).unwrap().triangle;
                match (own, says_lit) {
                    (true, false) => {
                        found.acne += 1;
                        [255, 0, 0, 255]
                    }
                    (false, true) if rays.is_faced(triangle) => {
                        found.leaks += 1;
                        [0, 0, 255, 255]
                    }
                    (false, true) => {
                        found.turned += 1;
                        [0, 200, 255, 255]
                    }
                    _ => grey(base),
                }
            }
        };
        shown.put_pixel(x, y, Rgba(colour));
    }
    if let Ok(dir) = std::env::var("ANTIPODE_TEST_PICTURES") {
        shown.save(format!("{dir}/{name}-rays.png")).unwrap();
        picture.save(format!("{dir}/{name}-told.png")).unwrap();
        let plain = Studio::shadowed(size, shadows)?.picture(frame);
        plain.save(format!("{dir}/{name}.png")).unwrap();
    }
    let all = found.judged as f64 / 100.0;
    let share = |n: usize| n as f64 / all.max(1e-9);
    eprintln!(
        "{name}: judged {}, acne {:.2} %, leaks {:.2} %, turned {:.2} %",
        found.judged,
        share(found.acne),
        share(found.leaks),
        share(found.turned),
    );
    Some(found)
}

fn is_edge(lit: &[Option<bool>], size: (u32, u32), (x, y): (u32, u32)) -> bool {
    let own = lit[(y * size.0 + x) as usize];
    let reach = -EDGE_PX..=EDGE_PX;
    reach
        .clone()
        .flat_map(|j| reach.clone().map(move |i| (i, j)))
        .any(|(i, j)| {
            let (x, y) = (x as i32 + i, y as i32 + j);
            let inside = (0..size.0 as i32).contains(&x) && (0..size.1 as i32).contains(&y);
            inside && {
                let other = lit[(y as u32 * size.0 + x as u32) as usize];
                other.is_some() && other != own
            }
        })
}

/// Where to look: the space, its seed and radius, the time of day, and the view.
type Place = (Geometry, u64, f64, f64, [f64; 2]);

/// Those of every run; the rest where `ANTIPODE_TEST_RAYS` is set.
const SHORT: usize = 6;

fn places() -> Vec<Place> {
    use Geometry::{Hyperbolic, Spherical};
    let mut places = vec![
        (Spherical, 3, 100.0, 190.0, [30.0, 6.0]),
        (Hyperbolic, 4, 32.0, 35.0, [30.0, -5.0]),
        (Spherical, 1, 100.0, 440.0, [30.0, 14.0]),
    ];
    for n in 0..10_u32 {
        let turn = f64::from(n);
        let time_s = [40.0, 75.0, 150.0, 230.0, 262.0][n as usize % 5];
        let view = [36.0 * turn, -8.0 + turn];
        for space in Geometry::ALL {
            places.push((space, u64::from(n), 32.0, time_s, view));
        }
    }
    places
}

#[test]
fn the_pictures_shadows_are_those_of_rays_cast_at_the_same_triangles() {
    let all = std::env::var("ANTIPODE_TEST_RAYS").is_ok();
    let count = if all { usize::MAX } else { SHORT };
    let mut wrong = Vec::new();
    for (n, (geometry, seed, radius_m, time_s, [yaw, pitch])) in
        places().into_iter().take(count).enumerate()
    {
        let mut world = World::new(geometry, seed, radius_m, 3).of_lines(180);
        world.scene.set_time_of_day_s(time_s);
        world.aim(yaw, pitch);
        for quality in [ShadowQuality::Low, ShadowQuality::High] {
            let name = format!("{n}-{geometry}-{quality:?}");
            let Some(found) = compare(&name, &mut world, quality) else {
                return;
            };
            if found.off() as f64 > MOST_WRONG * found.judged as f64 {
                wrong.push((name, found));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

/// Builds a pillar some metres ahead, higher and higher, and looks at it.
fn before_a_pillar(geometry: Geometry, time_s: f64) -> World {
    let mut world = World::new(geometry, 1, 100.0, 3).of_lines(180);
    for pitch in [-15.0, -5.0, 5.0, 15.0] {
        world.aim(0.0, pitch);
        world.use_pickaxe(true, 60);
        world.settle();
    }
    world.scene.set_time_of_day_s(time_s);
    world.aim(0.0, 0.0);
    world
}

/// Digs down until so many metres are overhead, and looks at the wall by noon.
fn down_a_shaft(geometry: Geometry, depth_m: f64) -> World {
    let mut world = World::new(geometry, 1, 100.0, 3).of_lines(180);
    let height_m = |world: &World| world.scene.feet().pos.y;
    let top_m = height_m(&world);
    world.aim(0.0, -89.9);
    while top_m - height_m(&world) < depth_m {
        world.use_pickaxe(false, 60);
    }
    world.settle();
    world.scene.set_time_of_day_s(150.0);
    world.aim(40.0, -20.0);
    world
}

#[test]
fn pillars_and_shafts_have_the_shadows_of_rays() {
    let all = std::env::var("ANTIPODE_TEST_RAYS").is_ok();
    let mut times = vec![60.0, 232.0];
    let mut worlds = Vec::new();
    if all {
        times.extend([35.0, 150.0]);
        worlds.push(("shaft", down_a_shaft(Geometry::Euclidean, 240.0)));
    }
    for geometry in Geometry::ALL {
        worlds.extend(
            times
                .iter()
                .map(|time_s| ("pillar", before_a_pillar(geometry, *time_s))),
        );
    }
    let mut wrong = Vec::new();
    for (n, (made, mut world)) in worlds.into_iter().enumerate() {
        for quality in [ShadowQuality::Low, ShadowQuality::High] {
            let name = format!("{made}-{n}-{quality:?}");
            let Some(found) = compare(&name, &mut world, quality) else {
                return;
            };
            if found.off() as f64 > MOST_WRONG * found.judged as f64 {
                wrong.push((name, found));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}
