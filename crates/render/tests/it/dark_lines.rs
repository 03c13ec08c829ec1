//! Dots and narrow lines on land that are darker than the land about them where the sun shines and no edge is.

use crate::common::Studio;
use crate::common::silhouettes::Silhouettes;
use crate::common::sun_rays::Rays;
use crate::common::told::told;
use crate::common::triangles::{Surface, Triangle, triangles};
use crate::common::worlds::World;
use antipode_geometry::{ChartId, ChartPoint, Geometry};
use antipode_render::ShadowQuality;
use image::{Rgba, RgbaImage};

/// So much darker than all of its neighbours is a dot, 255ths.
const DOT: i32 = 40;
/// Where maps let so much less through than on both sides there is a line, 255ths of the display: a quarter of the
/// light, by the curve of tonemap.wgsl.
const LINE: i32 = 11;
/// Share of all pixels that may lie on lines: where the sun grazes, they fade out and are not gone. At low quality
/// texels are twice as wide, and four are compared in place of 36.
const MOST_ON_LINES: [(ShadowQuality, f64); 2] =
    [(ShadowQuality::High, 0.0005), (ShadowQuality::Low, 0.001)];
/// On both sides of a line there is lighter land within so many pixels.
const REACH: i32 = 3;

type At = (i32, i32);

/// A picture's light, and what maps let through, 255ths.
struct View {
    width: u32,
    light: Vec<i32>,
    through: Vec<i32>,
}

impl View {
    fn new(picture: &RgbaImage, told: &RgbaImage) -> Self {
        let light = |p: &Rgba<u8>| i32::from(p.0[..3].iter().copied().max().unwrap());
        Self {
            width: picture.width(),
            light: picture.pixels().map(light).collect(),
            through: told.pixels().map(|p| i32::from(p.0[0])).collect(),
        }
    }

    fn is_dot(&self, (x, y): At) -> bool {
        let light = |i, j| self.light[((y + j) as u32 * self.width + (x + i) as u32) as usize];
        around((0, 0), 1)
            .filter(|step| *step != (0, 0))
            .all(|(i, j)| light(i, j) - light(0, 0) >= DOT)
    }

    fn is_line(&self, (x, y): At) -> bool {
        let through = |i, j| self.through[((y + j) as u32 * self.width + (x + i) as u32) as usize];
        let lighter = |i, j| through(i, j) - through(0, 0) >= LINE;
        let ends = |i, j| (1..=REACH).any(|n| lighter(i * n, j * n));
        [(1, 0), (0, 1), (1, 1), (1, -1)]
            .into_iter()
            .any(|(i, j)| ends(i, j) && ends(-i, -j))
    }
}

fn around((x, y): At, reach: i32) -> impl Iterator<Item = At> {
    (-reach..=reach).flat_map(move |j| (-reach..=reach).map(move |i| (x + i, y + j)))
}

/// Whether light arrives where a pixel looks; a seam is no surface, and to be as the land beside it.
fn is_lit(rays: &Rays<'_>, surface: &Surface, triangles: &[Triangle], (x, y): At) -> bool {
    let Some(seen) = surface.get(x as u32, y as u32) else {
        return false;
    };
    let triangle = &triangles[seen.triangle as usize];
    let point = ChartPoint::new(triangle.chart, triangle.at(seen.weights));
    triangle.is_seam || rays.is_faced(seen.triangle) && rays.hit(point, seen.triangle).is_none()
}

/// Pixels that are dark without a cause.
#[derive(Default, Debug)]
struct Found {
    looked_at: usize,
    dots: usize,
    on_lines: usize,
}

fn look(name: &str, world: &mut World, [plain, told]: [&mut Studio; 2]) -> Found {
    let frame = world.frame();
    let size = world.size();
    let (picture, told) = (plain.picture(&frame), told.picture(&frame));
    let view = View::new(&picture, &told);
    let triangles = triangles(&frame.content.land);
    let surface = Surface::of(&frame, &triangles, size);
    let edges = Silhouettes::of(&frame, &triangles, &surface, REACH);
    let rays = Rays::new(&frame, &triangles);
    let span = |length: u32| REACH..length as i32 - REACH;
    let pixels = span(size.1).flat_map(|y| span(size.0).map(move |x| (x, y)));
    let found: Vec<At> = pixels
        .filter(|at| view.is_dot(*at) || view.is_line(*at))
        .filter(|(x, y)| !edges.is_near(*x as u32, *y as u32))
        .filter(|at| around(*at, REACH).all(|at| is_lit(&rays, &surface, &triangles, at)))
        .collect();
    if let Ok(dir) = std::env::var("ANTIPODE_TEST_PICTURES") {
        let mut shown = picture.clone();
        for (x, y) in &found {
            shown.put_pixel(*x as u32, *y as u32, Rgba([255, 0, 0, 255]));
        }
        shown.save(format!("{dir}/{name}-found.png")).unwrap();
        picture.save(format!("{dir}/{name}.png")).unwrap();
        told.save(format!("{dir}/{name}-told.png")).unwrap();
    }
    let dots = found.iter().filter(|at| view.is_dot(**at)).count();
    let found = Found {
        looked_at: (size.0 * size.1) as usize,
        dots,
        on_lines: found.len() - dots,
    };
    eprintln!("{name}: {found:?}");
    found
}

/// Where to stand, the time of day in seconds, and the view in degrees.
type Look = (Option<[f64; 2]>, f64, [f64; 2]);

/// A world and what is looked at in it: its space, seed, radius in metres and dial.
type Place = (Geometry, u64, f64, f64, Vec<Look>);

fn looks(seed: u64, count: u32) -> impl Iterator<Item = Look> {
    (0..count).map(move |n| {
        let turn = f64::from(n) + seed as f64;
        let time_s = [40.0, 75.0, 150.0, 230.0, 262.0][turn as usize % 5];
        let view = [52.0 * turn, -16.0 + 4.0 * f64::from(n % 5)];
        let away = 6.0 * f64::from(n / 2);
        let at = [(turn * 2.4).cos() * away, (turn * 2.4).sin() * away];
        ((n % 2 == 0).then_some(at), time_s, view)
    })
}

/// Those of every run: creases at feet of slopes, and slivers between levels of detail.
fn places() -> Vec<Place> {
    use Geometry::{Euclidean, Hyperbolic, Spherical};
    vec![
        (Euclidean, 5, 32.0, 0.0, looks(5, 2).collect()),
        (Hyperbolic, 4, 32.0, 20.0, vec![(None, 150.0, [30.0, 0.0])]),
        (
            Spherical,
            3,
            100.0,
            0.0,
            std::iter::once((None, 190.0, [30.0, 6.0]))
                .chain(looks(3, 4).skip(2))
                .collect(),
        ),
    ]
}

/// Twenty more of every space, where `ANTIPODE_TEST_RAYS` is set.
fn more_places() -> Vec<Place> {
    Geometry::ALL
        .into_iter()
        .flat_map(|space| {
            [4, 5, 6, 7].map(|seed| {
                let dial = [10.0, 20.0][seed as usize % 2];
                (space, seed, 32.0, dial, looks(seed, 5).collect())
            })
        })
        .collect()
}

#[test]
fn sunlit_land_has_no_dark_dots_and_lines() {
    for (quality, most) in MOST_ON_LINES {
        let Some(all) = looked_at(quality) else {
            return;
        };
        assert_eq!(all.dots, 0, "{quality:?}: {all:?}");
        let most = most * all.looked_at as f64;
        assert!(all.on_lines as f64 <= most, "{quality:?}: {all:?}");
    }
}

/// What is found in all places; nothing without an adapter.
fn looked_at(quality: ShadowQuality) -> Option<Found> {
    let mut places = places();
    if std::env::var("ANTIPODE_TEST_RAYS").is_ok() {
        places.extend(more_places());
    }
    let mut all = Found::default();
    for (geometry, seed, radius_m, dial, looks) in places {
        let mut world = World::new(geometry, seed, radius_m, 4).of_lines(360);
        world.scene.set_curvature(dial);
        let mut plain = Studio::shadowed(world.size(), quality)?;
        let mut told = Studio::with_shaders(world.size(), quality, told())?;
        for (n, (at, time_s, [yaw, pitch])) in looks.into_iter().enumerate() {
            world.scene.set_time_of_day_s(time_s);
            if let Some([x, z]) = at {
                world.stand(ChartId::FIRST, x, z);
            }
            world.aim(yaw, pitch);
            let name = format!("{quality:?}-{geometry}-{seed}-{n}");
            let found = look(&name, &mut world, [&mut plain, &mut told]);
            all.looked_at += found.looked_at;
            all.dots += found.dots;
            all.on_lines += found.on_lines;
        }
    }
    Some(all)
}

/// A sample at the edge of a triangle is shaded at the pixel's middle, which may lie past the edge.
#[test]
fn four_samples_of_a_pixel_draw_no_dark_edge_where_one_draws_none() {
    for (geometry, seed, radius_m, dial, looks) in places() {
        let mut world = World::new(geometry, seed, radius_m, 4).of_lines(360);
        world.scene.set_curvature(dial);
        if let Some((_, time_s, [yaw, pitch])) = looks.first() {
            world.scene.set_time_of_day_s(*time_s);
            world.aim(*yaw, *pitch);
            let frame = world.frame();
            let size = world.size();
            let [one, four] = [1, 4].map(|samples| {
                let studio = Studio::sampled(size, ShadowQuality::High, samples);
                studio.map(|mut studio| studio.picture(&frame))
            });
            let (Some(one), Some(four)) = (one, four) else {
                return;
            };
            let light = |picture: &RgbaImage, (x, y): At| {
                let pixel = picture.get_pixel(x as u32, y as u32).0;
                i32::from(pixel[..3].iter().copied().max().unwrap())
            };
            let inner = |length: u32| 1..length as i32 - 1;
            let all = inner(size.1).flat_map(|y| inner(size.0).map(move |x| (x, y)));
            let darker: Vec<At> = all
                .filter(|at| {
                    around(*at, 1).all(|near| light(&one, near) - light(&four, *at) >= DOT)
                })
                .collect();
            assert!(darker.is_empty(), "{geometry} {seed}: {darker:?}");
        }
    }
}

#[test]
fn a_dot_and_a_line_are_told_from_a_shadows_edge() {
    let grey = |value: u8| Rgba([value, value, value, 255]);
    let mut picture = RgbaImage::from_pixel(40, 20, grey(180));
    let mut told = RgbaImage::from_pixel(40, 20, grey(227));
    // A dot, a line of two pixels, and where a shadow begins.
    picture.put_pixel(8, 10, grey(180 - DOT as u8));
    told.put_pixel(18, 10, grey(227 - LINE as u8));
    told.put_pixel(19, 10, grey(227 - LINE as u8));
    for (x, y) in (30..40).flat_map(|x| (0..20).map(move |y| (x, y))) {
        told.put_pixel(x, y, grey(0));
        picture.put_pixel(x, y, grey(60));
    }
    let view = View::new(&picture, &told);
    let all = || (REACH..40 - REACH).flat_map(|x| (REACH..20 - REACH).map(move |y| (x, y)));
    let dots: Vec<At> = all().filter(|at| view.is_dot(*at)).collect();
    let on_lines: Vec<At> = all().filter(|at| view.is_line(*at)).collect();
    assert_eq!(dots, [(8, 10)]);
    assert_eq!(on_lines, [(18, 10), (19, 10)]);
}
