//! A sprint over new hyperbolic land at five frames a second, by what the window calls for a frame: time passes in the
//! game, which fills a frame that is drawn, and the display tells of it.

mod pictures;
mod waiting;

use antipode_render::{AdapterChoice, Gpu, Offscreen, Options, Renderer, Shaders, ShadowQuality};
use antipode_scene::Scene;
use antipode_scene::frame::Frame;
use antipode_testing::needed;
use antipode_testing::pictures::striped_land;

use super::super::stage::world::Pictured;
use super::*;

/// Far more than any test needs; it only ends a test that would hang.
const LIMIT: Duration = Duration::from_mins(5);
/// From one frame to the next: more than a frame has steps for.
const FRAME: Duration = Duration::from_millis(200);
const SEED: u64 = 4;
const DIAL: f64 = 20.0;

/// What draws, and what is drawn on.
struct Easel {
    gpu: Gpu,
    renderer: Renderer,
    offscreen: Offscreen,
    size: (u32, u32),
}

impl Easel {
    /// None where there is no adapter.
    fn new(size: (u32, u32)) -> Option<Self> {
        let gpu = needed("a graphics adapter", Gpu::headless(AdapterChoice::Auto))?;
        let options = Options {
            samples: 1,
            scale: 1.0,
            output_format: wgpu::TextureFormat::Rgba8Unorm,
            shadows: ShadowQuality::Off,
            preset: antipode_render::Preset::Software,
        };
        let land = antipode_render::TERRAIN;
        let text = striped_land(land.own).leak();
        let shaders = Shaders::with(land.name, text);
        let mut renderer = Renderer::with_shaders(&gpu, options, shaders).unwrap();
        renderer.resize(size.0, size.1);
        let offscreen = Offscreen::new(&gpu, size.0, size.1, options.output_format);
        Some(Self {
            gpu,
            renderer,
            offscreen,
            size,
        })
    }

    fn aspect(&self) -> f64 {
        f64::from(self.size.0) / f64::from(self.size.1)
    }

    /// Has the adapter begin with the picture that `paint` records.
    fn submit(
        &mut self,
        paint: impl FnOnce(&mut Renderer, &mut wgpu::CommandEncoder, &wgpu::TextureView),
    ) {
        let descriptor = wgpu::CommandEncoderDescriptor::default();
        let mut encoder = self.gpu.device.create_command_encoder(&descriptor);
        let target = self.offscreen.view();
        paint(&mut self.renderer, &mut encoder, target);
        self.gpu.queue.submit([encoder.finish()]);
        assert_eq!(self.renderer.fault(), None);
    }
}

/// A player who sprints, in the window of a game.
struct Run {
    game: Game,
    now: Instant,
    easel: Easel,
    pictured: Pictured,
    _dir: TempDir,
}

impl Run {
    /// The player stands in a world that has just begun. None where there is no adapter.
    fn begin(size: (u32, u32)) -> Option<Self> {
        let easel = Easel::new(size)?;
        let dir = tempfile::tempdir().unwrap();
        let request = Request::New(NewWorld {
            geometry: Geometry::Hyperbolic,
            name: Some("x".to_owned()),
            seed: Some(SEED),
            radius_m: None,
            generator: Some(antipode_scene::Generator::OneBiome),
            mode: antipode_scene::Mode::default(),
            start: Beginning::View,
        });
        let path = dir.path().to_str().unwrap();
        let words = ["antipode", "--saves-dir", path, "--quality", "balanced"];
        let worlds = Worlds::new(&Cli::try_parse_from(words).unwrap().common);
        let mut game = Game::new(worlds, None, Some(request));
        tick_until(&mut game, Game::is_playing);
        input(&mut game, Input::Key("F4"), true);
        let mut run = Self {
            game,
            now: Instant::now() + Duration::from_secs(1),
            easel,
            pictured: Pictured::default(),
            _dir: dir,
        };
        assert_eq!(run.scene().quality(), Quality::Balanced);
        assert!(run.scene().set_curvature(DIAL));
        run.pass();
        Some(run)
    }

    fn scene(&mut self) -> &mut Scene {
        &mut self.game.play.phase.session_mut().unwrap().scene
    }

    /// Looks down by 0.3 radians, and sprints from now on.
    fn sprint(&mut self) {
        let settings = &self.game.options.config.settings;
        let down_px = 0.3 / settings.mouse_sensitivity_deg_per_px.to_radians();
        self.game.motion(0.0, down_px);
        for key in ["KeyW", "ShiftLeft"] {
            input(&mut self.game, Input::Key(key), true);
        }
    }

    fn pass(&mut self) {
        self.now += FRAME;
        self.game.tick(self.now);
    }

    fn frame(&mut self) -> Frame {
        let frame = self.game.frame(self.easel.aspect(), self.easel.size.1);
        frame.unwrap()
    }

    fn paint(&mut self, frame: &Frame) {
        let pictured = &mut self.pictured;
        self.easel.submit(|renderer, encoder, target| {
            let stats = renderer.draw(frame, encoder, target);
            assert!(pictured.note(&stats, frame.view.quality));
        });
        let is_whole = !self.easel.renderer.is_land_coming();
        self.game.play.drawn(is_whole);
    }
}
