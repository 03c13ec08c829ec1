//! Draws stills of generated land in every space into a folder, and says how long frames take.
//!
//! `cargo run --release -p antipode-render --example still -- FOLDER [SEED] [SCALE] [SPACE] [HOUR] [FRAMES]`
//! where HOUR is one of morning, day, evening, dusk, night, and SPACE may be `all`.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use antipode_frame::{
    ChunkChange, Clip, Figure, Frame, Lights, Marker, MarkerShape, ModelId, Posture, Quality,
};
use antipode_geometry::{
    CHUNK_CELLS, ChartPoint, ChunkCoord, DEFAULT_HYPERBOLIC_RADIUS_M, DEFAULT_SPHERE_RADIUS_M, Eye,
    Geometry, Hemisphere, Projection, Strategy, strategy,
};
use antipode_render::{AdapterChoice, Gpu, Offscreen, Options, RenderError, Renderer};
use antipode_scene::day::sky;
use antipode_terrain::{Content, Field, march};
use glam::{DVec3, IVec3};

const SIZE: (u32, u32) = (1280, 720);
const VIEW_CHUNKS: i32 = 4;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

struct Wanted {
    folder: PathBuf,
    seed: u64,
    scale: f32,
    space: Option<Geometry>,
    hour: String,
    frames: usize,
}

fn wanted() -> Wanted {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let word = |i: usize| words.get(i).map(String::as_str).unwrap_or_default();
    Wanted {
        folder: words.first().map_or_else(std::env::temp_dir, PathBuf::from),
        seed: word(1).parse().unwrap_or(2),
        scale: word(2).parse().unwrap_or(1.0),
        space: word(3).parse().ok(),
        hour: word(4).to_owned(),
        frames: word(5).parse().unwrap_or(40),
    }
}

/// Time of day, seconds after sunrise.
fn time_of_day_s(hour: &str) -> f64 {
    match hour {
        "morning" => 12.0,
        "evening" => 285.0,
        "dusk" => 312.0,
        "night" => 430.0,
        _ => 70.0,
    }
}

/// Every chunk with land within the view distance; all of a closed world.
fn land(field: &Field, space: &dyn Strategy, centre: ChartPoint) -> Vec<ChunkChange> {
    let mut changes = Vec::new();
    let middle = ChunkCoord::containing(centre).index;
    let (hemispheres, reach, middle) = match space.rim_m() {
        Some(rim_m) => {
            let reach = (rim_m / f64::from(CHUNK_CELLS)).ceil() as i32 + 1;
            (vec![Hemisphere::A, Hemisphere::B], reach, IVec3::ZERO)
        }
        None => (vec![Hemisphere::A], VIEW_CHUNKS, middle),
    };
    for hemisphere in hemispheres {
        for x in -reach..=reach {
            for y in -reach..=reach {
                for z in -reach..=reach {
                    let coord = ChunkCoord {
                        hemisphere,
                        index: middle + IVec3::new(x, y, z),
                    };
                    if field.content(coord) == Content::Surface {
                        let mesh = march(&field.samples(coord), field, coord);
                        changes.push(ChunkChange::Put(coord, Arc::new(mesh)));
                    }
                }
            }
        }
    }
    changes
}

fn frame(wanted: &Wanted, geometry: Geometry) -> Frame {
    let radius_m = match geometry {
        Geometry::Spherical => DEFAULT_SPHERE_RADIUS_M,
        _ => DEFAULT_HYPERBOLIC_RADIUS_M,
    };
    let space = strategy(geometry, radius_m);
    let field = Field::new(wanted.seed, Arc::clone(&space));
    let on_ground =
        |x: f64, z: f64| ChartPoint::a(DVec3::new(x, field.surface_height(Hemisphere::A, x, z), z));
    let stand = on_ground(4.0, 4.0);
    let eye_point = ChartPoint::a(stand.pos + DVec3::Y * 1.65);
    let eye = Eye {
        point: eye_point,
        yaw: -0.35,
        pitch: -0.08,
        roll: 0.0,
        dial: 10.0,
        lift_m: 1.65,
    };
    let aspect = f64::from(SIZE.0) / f64::from(SIZE.1);
    let projection = Projection::new(75f64.to_radians(), aspect, 0.02);
    let figure = |ahead: f64, aside: f64, yaw: f64, cycle: f32| {
        let at = stand.pos + eye.front() * ahead + eye.right() * aside;
        Figure {
            posture: Posture::of(Clip::Walk, cycle),
            ..Figure::standing(ModelId::Astronaut, on_ground(at.x, at.z), yaw)
        }
    };
    let figures = vec![
        figure(4.0, -1.3, 2.2, 0.15),
        figure(9.0, 2.4, -0.2, 0.2),
        figure(24.0, -5.0, 1.0, 0.1),
    ];
    let marker = on_ground(stand.pos.x + 10.0, stand.pos.z - 3.0);
    let reach_m = f64::from(VIEW_CHUNKS * CHUNK_CELLS);
    Frame {
        hit_shapes: Vec::new(),
        eye,
        projection,
        sky: sky(time_of_day_s(&wanted.hour), space.as_ref(), &eye),
        chunk_changes: land(&field, space.as_ref(), eye_point),
        figures,
        hand: None,
        lights: Lights::default(),
        marker: Some(Marker {
            point: marker,
            radius_m: 3.0,
            active: true,
            shape: MarkerShape::Ring,
        }),
        fog_distance_m: space.rim_m().map_or(reach_m - 8.0, |rim_m| rim_m * 3.0) as f32,
        contour_bands: true,
        time_s: 1.0,
        quality: Quality::default(),
        loaded_world: geometry as u64,
        strategy: space,
    }
}

struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

impl Studio {
    fn new(scale: f32) -> Result<Self, RenderError> {
        let gpu = Gpu::headless(AdapterChoice::Auto)?;
        let samples = if gpu.is_software() { 1 } else { 4 };
        let mut renderer = Renderer::new(
            &gpu,
            Options {
                samples,
                scale,
                output_format: FORMAT,
                shadows: antipode_render::ShadowQuality::Off,
            },
        )?;
        renderer.resize(SIZE.0, SIZE.1);
        let offscreen = Offscreen::new(&gpu, SIZE.0, SIZE.1, FORMAT);
        println!("{}", gpu.name());
        Ok(Self {
            gpu,
            renderer,
            offscreen,
        })
    }

    fn draw(&mut self, frame: &Frame) -> Result<antipode_render::DrawStats, RenderError> {
        let mut encoder = self
            .gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let stats = self
            .renderer
            .draw(frame, &mut encoder, self.offscreen.view());
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.wait()?;
        match self.gpu.take_error() {
            Some(words) => Err(RenderError::Readback(words)),
            None => Ok(stats),
        }
    }

    fn time(&mut self, frame: &Frame, frames: usize) -> Result<(), RenderError> {
        let mut times = Vec::new();
        let mut stats = antipode_render::DrawStats::default();
        for _ in 0..frames {
            let begin = Instant::now();
            stats = self.draw(frame)?;
            times.push(begin.elapsed().as_secs_f64() * 1e3);
        }
        times.sort_by(f64::total_cmp);
        if let (Some(median), Some(p95)) = (times.get(frames / 2), times.get(frames * 95 / 100)) {
            println!("  median {median:.1} ms, p95 {p95:.1} ms, {stats:?}");
        }
        Ok(())
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let wanted = wanted();
    let mut studio = Studio::new(wanted.scale)?;
    for geometry in [
        Geometry::Euclidean,
        Geometry::Hyperbolic,
        Geometry::Spherical,
    ] {
        if wanted.space.is_some_and(|space| space != geometry) {
            continue;
        }
        let mut frame = frame(&wanted, geometry);
        for (name, turn, pitch) in [
            ("ahead", 0.0, -0.08),
            ("down", 0.0, -0.9),
            ("up", 0.0, 0.75),
            ("behind", 2.4, -0.05),
        ] {
            let yaw = -0.35 + turn;
            frame.eye = Eye {
                yaw,
                pitch,
                ..frame.eye
            };
            studio.draw(&frame)?;
            frame.chunk_changes.clear();
            let path = wanted
                .folder
                .join(format!("{geometry}-{name}{}.png", wanted.hour));
            studio.offscreen.read(&studio.gpu)?.save(&path)?;
            println!("{}", path.display());
            studio.time(&frame, wanted.frames)?;
        }
    }
    Ok(())
}
