//! Land looks in a chart for each square of 64 m, each turned its own way, as it does in the one chart of flat land: ground
//! near and far, what was dug of it, figures, a car, lamps, shadows, the ring and the ball of the tools.

use std::sync::Arc;
use std::time::Duration;

use antipode_geometry::{Atlas, ChartId, ChartPoint, Geometry};
use antipode_render::{AdapterChoice, Gpu, Offscreen, Options, Renderer, ShadowQuality};
use antipode_scene::frame::Dust;
use antipode_scene::tuning::FOV_Y_RAD;
use antipode_scene::{Actions, NpcMode, Scene, WorldSetup};
use antipode_terrain::{Field, Generator};
use antipode_testing::tiled::TiledFlat;
use glam::DVec3;
use image::RgbaImage;

/// The places are those of its land.
const GENERATOR: Generator = Generator::OneBiome;
const LIMIT: Duration = Duration::from_mins(2);
const SIZE: (u32, u32) = (480, 270);
/// Channels are alike that are no farther apart, of 255.
const ALIKE: u8 = 1;
/// The share of the pixels that may be others: edges, whose last digits fall on either side of a pixel's middle.
const OTHERS: f64 = 1e-4;

/// The same world in one chart and in many.
struct Twins {
    one: Scene,
    many: Scene,
}

impl Twins {
    fn new() -> Self {
        let setup = WorldSetup {
            name: "Twins".to_owned(),
            seed: 3,
            geometry: Geometry::Euclidean,
            radius_m: 20.0,
            generator: GENERATOR,
            mode: antipode_scene::Mode::default(),
            view_distance: 3,
        };
        let twins = Self {
            one: Scene::open(setup.clone(), None).unwrap(),
            many: Scene::open_in(Arc::new(TiledFlat), setup, None, 2).unwrap(),
        };
        twins.each(|scene, _| {
            scene.set_npcs(NpcMode::Off);
            assert!(scene.settle(LIMIT));
        })
    }

    /// Does the same to both: the second time in the coordinates of many charts.
    fn each(mut self, deed: impl Fn(&mut Scene, &dyn Fn(DVec3) -> ChartPoint)) -> Self {
        deed(&mut self.one, &ChartPoint::a);
        deed(&mut self.many, &TiledFlat::at);
        self
    }

    /// Stands both at a place over the ground, looking so.
    fn stand(self, [x, z]: [f64; 2], yaw_rad: f64, pitch_rad: f64) -> Self {
        let field = Field::made_by(GENERATOR, 3, self.one.strategy().clone());
        let ground_m = field.surface_height(ChartId::FIRST, x, z);
        self.each(|scene, at| {
            let point = at(DVec3::new(x, ground_m + 0.3, z));
            let turn = TiledFlat.carry(ChartPoint::default(), point.chart).unwrap();
            scene.set_flying(true);
            scene.teleport(point);
            assert!(scene.settle(LIMIT));
            scene.aim(yaw_rad - turn.turn_rad, pitch_rad);
            step(scene, &Actions::default());
        })
    }

    /// Whatever stands about, on the ground of some places.
    fn furnished(self) -> Self {
        let field = Field::made_by(GENERATOR, 3, self.one.strategy().clone());
        self.each(|scene, at| {
            let on = |x: f64, z: f64, up_m: f64| {
                let ground_m = field.surface_height(ChartId::FIRST, x, z);
                at(DVec3::new(x, ground_m + up_m, z))
            };
            let yaw = |point: ChartPoint, yaw: f64| {
                yaw - TiledFlat
                    .carry(ChartPoint::default(), point.chart)
                    .unwrap()
                    .turn_rad
            };
            for (x, z) in [(30.5, 30.0), (31.0, 32.2)] {
                let point = on(x, z, 0.2);
                scene.spawn_bot(point, yaw(point, 0.7), x > 30.7);
            }
            let car = on(34.5, 34.5, 0.8);
            assert!(scene.spawn_car(car, yaw(car, 2.0)));
            for (x, z) in [(32.3, 31.0), (29.4, 32.0)] {
                assert!(scene.spawn_lamp(on(x, z, 0.4)));
            }
            step(scene, &Actions::default());
        })
    }
}

fn step(scene: &mut Scene, actions: &Actions) {
    scene.step(actions);
    assert!(scene.wait_for_step(LIMIT));
}

/// What draws, and the number of the next world that it draws.
struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
    worlds: u64,
}

impl Studio {
    fn new(shadows: ShadowQuality) -> Option<Self> {
        let gpu = Gpu::headless(AdapterChoice::Auto);
        let gpu = antipode_testing::needed("a graphics adapter", gpu)?;
        let options = Options {
            samples: 1,
            scale: 1.0,
            output_format: wgpu::TextureFormat::Rgba8Unorm,
            shadows,
            preset: antipode_render::Preset::Software,
        };
        let mut renderer = Renderer::new(&gpu, options).unwrap();
        renderer.resize(SIZE.0, SIZE.1);
        let offscreen = Offscreen::new(&gpu, SIZE.0, SIZE.1, options.output_format);
        Some(Self {
            gpu,
            renderer,
            offscreen,
            worlds: 0,
        })
    }

    fn picture(&mut self, scene: &Scene) -> RgbaImage {
        self.worlds += 1;
        let aspect = f64::from(SIZE.0) / f64::from(SIZE.1);
        let mut frame = scene.frame(FOV_Y_RAD, aspect, self.worlds);
        // What the ground throws up is thrown by chance along the axes of its chart, and marks are laid along them.
        frame.content_mut().dust = Dust::default();
        self.renderer.complete_next();
        let mut encoder = self.gpu.encoder();
        self.renderer
            .draw(&frame, &mut encoder, self.offscreen.view());
        self.gpu.queue.submit([encoder.finish()]);
        let picture = self.offscreen.read(&self.gpu).unwrap();
        assert_eq!(self.gpu.take_error(), None);
        picture
    }

    fn compare(&mut self, twins: &Twins, what: &str) {
        let [one, many] = [&twins.one, &twins.many].map(|scene| self.picture(scene));
        let colours = one.pixels().collect::<std::collections::HashSet<_>>().len();
        assert!(colours > 100, "{what}: {colours} colours");
        let differs = |(a, b): &(&image::Rgba<u8>, &image::Rgba<u8>)| {
            let mut channels = a.0.iter().zip(b.0);
            channels.any(|(a, b)| a.abs_diff(b) > ALIKE)
        };
        let others = one.pixels().zip(many.pixels()).filter(differs).count();
        if let Some(folder) = std::env::var_os("ANTIPODE_TEST_PICTURES") {
            let folder = std::path::Path::new(&folder);
            one.save(folder.join(format!("{what}-one.png"))).unwrap();
            many.save(folder.join(format!("{what}-many.png"))).unwrap();
        }
        let most = OTHERS * f64::from(SIZE.0 * SIZE.1);
        assert!(others as f64 <= most, "{what}: {others} pixels differ");
    }
}

/// Where four squares meet, on an edge, and inside of a square that is turned.
const PLACES: [([f64; 2], f64, f64); 4] = [
    ([31.0, 31.2], 0.7, -0.3),
    ([33.5, 33.0], -2.4, -1.1),
    ([-33.0, 5.0], 2.0, -0.1),
    ([96.0, -60.0], -0.9, -0.5),
];

#[test]
fn land_looks_alike_in_one_chart_and_in_many() {
    for shadows in [ShadowQuality::Low, ShadowQuality::High] {
        let Some(mut studio) = Studio::new(shadows) else {
            return;
        };
        let mut twins = Twins::new();
        for (hour, (place, yaw, pitch)) in [
            (9.0, PLACES[0]),
            (16.5, PLACES[1]),
            (7.0, PLACES[2]),
            (12.0, PLACES[3]),
        ] {
            twins = twins.stand(place, yaw, pitch).each(|scene, _| {
                scene.set_time_of_day_s(hour * 3600.0);
            });
            studio.compare(&twins, &format!("land-{hour}-{shadows:?}"));
        }
    }
}

#[test]
fn figures_a_car_and_lamps_look_alike_in_one_chart_and_in_many() {
    for shadows in [ShadowQuality::Low, ShadowQuality::High] {
        let Some(mut studio) = Studio::new(shadows) else {
            return;
        };
        let mut twins = Twins::new().stand([29.0, 29.5], 0.75, -0.3).furnished();
        for hour in [10.0, 23.0] {
            twins = twins.each(|scene, _| scene.set_time_of_day_s(hour * 3600.0));
            studio.compare(&twins, &format!("things-{hour}-{shadows:?}"));
        }
    }
}

#[test]
fn tools_and_what_they_dug_look_alike_in_one_chart_and_in_many() {
    let Some(mut studio) = Studio::new(ShadowQuality::Low) else {
        return;
    };
    let mut twins = Twins::new().stand([31.3, 31.4], 0.7, -1.2);
    for (what, slot, primary) in [("ring", 2, false), ("dug", 2, true), ("ball", 5, false)] {
        for count in 0..30 {
            let actions = Actions {
                slot: (count == 0).then_some(slot),
                primary,
                ..Actions::default()
            };
            twins = twins.each(|scene, _| step(scene, &actions));
        }
        twins = twins.each(|scene, _| assert!(scene.settle(LIMIT)));
        studio.compare(&twins, what);
    }
}
