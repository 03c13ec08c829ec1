//! A small studio for the tests: an adapter, a renderer, a picture, and plain frames.
#![allow(
    dead_code,
    reason = "what measures normals of triangles is not asked at present"
)]
pub mod silhouettes;
pub mod sun_rays;
pub mod told;
pub mod triangles;
pub mod worlds;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use antipode_frame::{ChunkChange, Frame, Land, Sky, View};
use antipode_geometry::{
    ChartId, ChartPoint, ChunkCoord, DEFAULT_HYPERBOLIC_RADIUS_M, DEFAULT_SPHERE_RADIUS_M, Eye,
    Geometry, Projection, Strategy, strategy,
};
use antipode_render::{
    AdapterChoice, DrawStats, FurtherView, Gpu, Offscreen, Options, Picture, Preset, Renderer,
    Shaders, ShadowQuality, ViewTarget,
};
use antipode_terrain::{ChunkMesh, Content, Field, Vertex, march};
use glam::{DVec3, IVec3, Vec3};
use image::RgbaImage;

/// The number of the next world.
static WORLDS: AtomicU64 = AtomicU64::new(1);

pub const GEOMETRIES: [Geometry; 3] = [
    Geometry::Euclidean,
    Geometry::Hyperbolic,
    Geometry::Spherical,
];
pub const PLAIN: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

pub struct Studio {
    pub gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
}

/// An adapter, or none with a loud word; none is a failure where `ANTIPODE_REQUIRE_GPU=1`.
pub fn adapter() -> Option<Gpu> {
    antipode_testing::needed("a graphics adapter", Gpu::headless(AdapterChoice::Auto))
}

impl Studio {
    pub fn new(size: (u32, u32)) -> Option<Self> {
        Self::with(size, PLAIN, 1.0, 1)
    }

    pub fn with(
        size: (u32, u32),
        format: wgpu::TextureFormat,
        scale: f32,
        samples: u32,
    ) -> Option<Self> {
        Self::made(
            size,
            Options {
                samples,
                scale,
                output_format: format,
                shadows: ShadowQuality::Off,
                preset: Preset::Software,
            },
        )
    }

    /// As pictures are made for graphics cards.
    pub fn for_card(size: (u32, u32)) -> Option<Self> {
        let options = Options {
            samples: 1,
            scale: 1.0,
            output_format: PLAIN,
            shadows: ShadowQuality::Off,
            preset: Preset::Card,
        };
        Self::made(size, options)
    }

    /// With shadows of a quality.
    pub fn shadowed(size: (u32, u32), shadows: ShadowQuality) -> Option<Self> {
        Self::sampled(size, shadows, 1)
    }

    /// With shadows of a quality, and so many samples of a pixel.
    pub fn sampled(size: (u32, u32), shadows: ShadowQuality, samples: u32) -> Option<Self> {
        Self::made(
            size,
            Options {
                samples,
                scale: 1.0,
                output_format: PLAIN,
                shadows,
                preset: Preset::Software,
            },
        )
    }

    fn made(size: (u32, u32), options: Options) -> Option<Self> {
        Self::made_with(size, options, Shaders::default())
    }

    /// With shadows of a quality, and another shader.
    pub fn with_shaders(
        size: (u32, u32),
        shadows: ShadowQuality,
        shaders: Shaders,
    ) -> Option<Self> {
        let options = Options {
            samples: 1,
            scale: 1.0,
            output_format: PLAIN,
            shadows,
            preset: Preset::Software,
        };
        Self::made_with(size, options, shaders)
    }

    fn made_with(size: (u32, u32), options: Options, shaders: Shaders) -> Option<Self> {
        let gpu = adapter()?;
        let mut renderer = Renderer::with_shaders(&gpu, options, shaders).unwrap();
        renderer.resize(size.0, size.1);
        let offscreen = Offscreen::new(&gpu, size.0, size.1, options.output_format);
        Some(Self {
            gpu,
            renderer,
            offscreen,
        })
    }

    /// A single picture, complete.
    pub fn draw(&mut self, frame: &Frame) -> (RgbaImage, DrawStats) {
        self.renderer.complete_next();
        self.draw_in_motion(frame)
    }

    pub fn renderer(&mut self) -> &mut Renderer {
        &mut self.renderer
    }

    /// One frame of many.
    pub fn draw_in_motion(&mut self, frame: &Frame) -> (RgbaImage, DrawStats) {
        let mut encoder = self.gpu.encoder();
        let stats = self
            .renderer
            .draw(frame, &mut encoder, self.offscreen.view());
        self.gpu.queue.submit([encoder.finish()]);
        let picture = self.offscreen.read(&self.gpu).unwrap();
        assert_eq!(self.gpu.take_error(), None);
        (picture, stats)
    }

    /// The picture of a frame, and those of further views of its content of these sizes, all by one submission.
    pub fn views(
        &mut self,
        frame: &Frame,
        further: &[(View, (u32, u32))],
    ) -> (RgbaImage, Vec<RgbaImage>) {
        let target = |(_, (width, height)): &(View, (u32, u32))| {
            Offscreen::new(&self.gpu, *width, *height, PLAIN)
        };
        let targets: Vec<_> = further.iter().map(target).collect();
        let views = further.iter().zip(&targets);
        let views: Vec<_> = views
            .map(|((view, size), target)| FurtherView {
                view,
                size: *size,
                target: ViewTarget::Texture(target.view()),
            })
            .collect();
        self.renderer.complete_next();
        let mut encoder = self.gpu.encoder();
        let view = self.offscreen.view();
        let (_, stats) = self.renderer.draw_views(frame, &views, &mut encoder, view);
        self.gpu.queue.submit([encoder.finish()]);
        assert!(stats.iter().all(|it| it.picture == Picture::New));
        let read = |target: &Offscreen| target.read(&self.gpu).unwrap();
        let pictures = targets.iter().map(read).collect();
        let picture = self.offscreen.read(&self.gpu).unwrap();
        assert_eq!(self.gpu.take_error(), None);
        (picture, pictures)
    }

    /// The picture of a frame with a mirror of that size in it.
    pub fn with_mirror(
        &mut self,
        frame: &Frame,
        view: &View,
        corner: (u32, u32),
        size: (u32, u32),
    ) -> RgbaImage {
        let target = ViewTarget::Mirror(corner);
        let mirror = FurtherView { view, size, target };
        self.renderer.complete_next();
        let mut encoder = self.gpu.encoder();
        let picture = self.offscreen.view();
        self.renderer
            .draw_views(frame, &[mirror], &mut encoder, picture);
        self.gpu.queue.submit([encoder.finish()]);
        let picture = self.offscreen.read(&self.gpu).unwrap();
        assert_eq!(self.gpu.take_error(), None);
        picture
    }

    /// An encoder for [`Studio::record`], once the adapter has done all that it was given.
    pub fn idle_encoder(&self) -> wgpu::CommandEncoder {
        self.gpu
            .device
            .poll(wgpu::PollType::wait_indefinitely())
            .unwrap();
        let plain = wgpu::CommandEncoderDescriptor::default();
        self.gpu.device.create_command_encoder(&plain)
    }

    /// The main thread's share of a frame.
    pub fn record(&mut self, frame: &Frame, encoder: &mut wgpu::CommandEncoder) {
        self.renderer.draw(frame, encoder, self.offscreen.view());
    }

    pub fn picture(&mut self, frame: &Frame) -> RgbaImage {
        self.draw(frame).0
    }
}

pub fn space(geometry: Geometry) -> Arc<dyn Strategy> {
    match geometry {
        Geometry::Spherical => strategy(geometry, DEFAULT_SPHERE_RADIUS_M),
        _ => strategy(geometry, DEFAULT_HYPERBOLIC_RADIUS_M),
    }
}

pub fn noon() -> Sky {
    let sun = Vec3::new(0.4, 0.8, -0.3).normalize().to_array();
    Sky {
        top: [0.10, 0.28, 0.66],
        horizon: [0.50, 0.62, 0.74],
        glare: [1.0, 0.95, 0.85],
        stars: 0.0,
        sun_direction: sun,
        moon_direction: [0.0, -1.0, 0.0],
        key_direction: sun,
        key_shadow: 1.0,
        key_colour: [1.8, 1.7, 1.5],
        ambient_sky: [0.3, 0.4, 0.5],
        moon_colour: [0.3, 0.36, 0.52],
        ambient_ground: [0.2, 0.18, 0.16],
        dome: true,
        clouds: 0.0,
        drift: 0.0,
        orbs: None,
    }
}

/// An empty frame seen from `point` along +x.
pub fn frame(space: &Arc<dyn Strategy>, point: ChartPoint, aspect: f64) -> Frame {
    let eye = Eye {
        point,
        yaw: 0.0,
        pitch: 0.0,
        roll: 0.0,
        dial: 10.0,
        lift_m: 1.62,
    };
    let sky = match (space.has_sky(), point.chart) {
        (true, _) => noon(),
        (false, ChartId::SECOND) => antipode_scene::day::sky(450.0, &**space, &eye),
        (false, _) => antipode_scene::day::sky(150.0, &**space, &eye),
    };
    let content = antipode_frame::Content {
        sky,
        // Each picture made from nothing is of a world of its own.
        loaded_world: WORLDS.fetch_add(1, Ordering::Relaxed),
        ..antipode_frame::Content::default()
    };
    let projection = Projection::new(75f64.to_radians(), aspect, 0.02);
    let view = View {
        fog_distance_m: 150.0,
        ..View::new(eye, projection, Arc::clone(space))
    };
    Frame::new(content, view)
}

/// Generated land within `reach` chunks of `centre`; all of a closed world.
pub fn land(space: &Arc<dyn Strategy>, centre: ChartPoint, reach: i32) -> Arc<Land> {
    let field = Field::new(2, space.clone());
    let closed = space.is_closed();
    let (middle, reach) = if closed {
        (IVec3::ZERO, 3)
    } else {
        (ChunkCoord::containing(centre).index, reach)
    };
    let charts: &[ChartId] = if closed {
        &[ChartId::FIRST, ChartId::SECOND]
    } else {
        &[ChartId::FIRST]
    };
    let mut land = Land::default();
    let span = || -reach..=reach;
    for &chart in charts {
        for (x, y, z) in
            span().flat_map(|x| span().flat_map(move |y| span().map(move |z| (x, y, z))))
        {
            let coord = ChunkCoord {
                chart,
                index: middle + IVec3::new(x, y, z),
            };
            if field.content(coord) == Content::Surface {
                let mesh = march(&field.samples(coord), &field, coord);
                land.change(ChunkChange::Put(coord, Arc::new(mesh)));
            }
        }
    }
    Arc::new(land)
}

/// Land of one chunk.
pub fn one_chunk(coord: ChunkCoord, mesh: Arc<ChunkMesh>) -> Arc<Land> {
    Arc::new(Land::from_iter([ChunkChange::Put(coord, mesh)]))
}

/// A point 1.7 m above the generated ground.
pub fn standing(space: &Arc<dyn Strategy>, chart: ChartId, x: f64, z: f64) -> ChartPoint {
    let field = Field::new(2, space.clone());
    ChartPoint::new(
        chart,
        DVec3::new(x, field.surface_height(chart, x, z) + 1.7, z),
    )
}

/// A mesh of white plates, each four corners counter-clockwise seen from the front, cut into small squares.
pub fn plates(corners: &[[Vec3; 4]]) -> Arc<ChunkMesh> {
    const CUTS: u32 = 6;
    let mut mesh = ChunkMesh::default();
    for [a, b, c, d] in corners.iter().copied() {
        let normal = (b - a).cross(d - a);
        let first = mesh.vertices.len() as u32;
        for (i, j) in (0..=CUTS).flat_map(|i| (0..=CUTS).map(move |j| (i, j))) {
            let (u, v) = (i as f32 / CUTS as f32, j as f32 / CUTS as f32);
            let position = a.lerp(b, u).lerp(d.lerp(c, u), v);
            mesh.vertices
                .push(Vertex::new(position, normal, [255, 40, 40]));
        }
        for (i, j) in (0..CUTS).flat_map(|i| (0..CUTS).map(move |j| (i, j))) {
            let at = first + i * (CUTS + 1) + j;
            let across = at + CUTS + 1;
            mesh.indices
                .extend([at, across, across + 1, at, across + 1, at + 1]);
        }
    }
    Arc::new(mesh)
}

/// Largest difference of any channel, and the mean.
pub fn difference(a: &RgbaImage, b: &RgbaImage) -> (u8, f64) {
    let apart = || {
        a.as_raw()
            .iter()
            .zip(b.as_raw())
            .map(|(x, y)| x.abs_diff(*y))
    };
    (
        apart().max().unwrap(),
        apart().map(f64::from).sum::<f64>() / a.as_raw().len() as f64,
    )
}

/// Middle, in pixels, of the box around everything that differs.
pub fn middle_of_change(a: &RgbaImage, b: &RgbaImage) -> Option<(f64, f64)> {
    let changed = || {
        a.enumerate_pixels()
            .zip(b.pixels())
            .filter(|((.., p), q)| p != q)
            .map(|((x, y, _), _)| (x, y))
    };
    let (least, most) = changed().fold(((u32::MAX, u32::MAX), (0, 0)), |(least, most), (x, y)| {
        (
            (x.min(least.0), y.min(least.1)),
            (x.max(most.0), y.max(most.1)),
        )
    });
    let middle = |a: u32, b: u32| f64::from(a + b + 1) / 2.0;
    changed()
        .next()
        .map(|_| (middle(least.0, most.0), middle(least.1, most.1)))
}

/// Where a point is seen, in pixels of a picture of the given size.
pub fn seen_at(frame: &Frame, point: ChartPoint, size: (u32, u32)) -> (f64, f64) {
    let v = frame.view.strategy.view_point(&frame.view.eye, point);
    assert!(v.z < 0.0, "behind the eye");
    let x = frame.view.projection.sx * v.x / -v.z;
    let y = frame.view.projection.sy * v.y / -v.z;
    (
        (0.5 + 0.5 * x) * f64::from(size.0),
        (0.5 - 0.5 * y) * f64::from(size.1),
    )
}
