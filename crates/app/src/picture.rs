//! Pictures without a window: the frame as the player sees it, display included, into memory.

use std::time::{Duration, Instant};

use antipode_language::Texts;
use antipode_render::{
    AdapterChoice, DrawStats, Gpu, Offscreen, Options, Preset, Renderer, Shaders,
};
use antipode_scene::frame::{Frame, Quality};
use antipode_settings::Settings;
use antipode_ui::HudModel;
use image::RgbaImage;

use crate::common::{Adapter, Common};
use crate::failure::Failure;
use crate::mirror::Mirror;
use crate::options;
use crate::overlay::Overlay;
use crate::room_picture::{RoomPictures, RoomView};
use crate::rooms::OpenRoom;

/// Format of pictures in memory.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// An adapter, a renderer and a picture of fixed size.
#[derive(Debug)]
pub struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    overlay: Overlay,
    offscreen: Offscreen,
    options: Options,
    size: (u32, u32),
    /// Made for the first picture of a room.
    rooms: Option<RoomPictures>,
}

/// How pictures are made by the settings; `software`: whether the processor draws.
fn asked(settings: &Settings, software: bool) -> Options {
    let preset = options::preset(settings, software);
    let is_cheap = preset == Preset::Software;
    Options {
        samples: settings.msaa.samples(is_cheap),
        scale: 1.0,
        output_format: FORMAT,
        shadows: options::shadows(settings, is_cheap),
        preset,
    }
}

/// The renderer's choice of adapter for the command line's.
pub fn adapter_choice(adapter: Adapter) -> AdapterChoice {
    match adapter {
        Adapter::Gpu => AdapterChoice::Gpu,
        Adapter::Software => AdapterChoice::Software,
        Adapter::Auto | Adapter::None => AdapterChoice::Auto,
    }
}

impl Studio {
    /// Opens an adapter and makes ready for pictures of the size the command line asks for, as the settings say.
    ///
    /// # Errors
    /// When there is no adapter of the kind asked for.
    pub fn new(common: &Common, settings: &Settings) -> Result<Self, Failure> {
        Self::with_shaders(common, settings, Shaders::default())
    }

    fn with_shaders(
        common: &Common,
        settings: &Settings,
        shaders: Shaders,
    ) -> Result<Self, Failure> {
        let gpu = Gpu::headless(adapter_choice(common.adapter))?;
        let options = asked(settings, gpu.is_software());
        let mut renderer = Renderer::with_shaders(&gpu, options, shaders)?;
        renderer.resize(common.size.0, common.size.1);
        let overlay = Overlay::new(&gpu, FORMAT);
        let offscreen = Offscreen::new(&gpu, common.size.0, common.size.1, FORMAT);
        Ok(Self {
            gpu,
            renderer,
            overlay,
            offscreen,
            options,
            size: common.size,
            rooms: None,
        })
    }

    /// Draws as the settings say from the next frame on.
    ///
    /// # Errors
    /// When the renderer refuses; it goes on as before then.
    pub fn follow(&mut self, settings: &Settings) -> Result<(), Failure> {
        let options = asked(settings, self.gpu.is_software());
        if options != self.options {
            self.renderer.set_options(options)?;
            self.options = options;
            self.renderer.resize(self.size.0, self.size.1);
        }
        Ok(())
    }

    /// The adapter's name.
    pub fn adapter_name(&self) -> &str {
        self.gpu.name()
    }

    /// Width over height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.size.0) / f64::from(self.size.1)
    }

    /// Draws a frame and waits until the adapter has finished it. Returns with the statistics the time that the
    /// main thread took before it waited.
    ///
    /// # Errors
    /// When the adapter fails or refuses a shader.
    pub fn draw(&mut self, frame: &Frame) -> Result<(DrawStats, Duration), Failure> {
        let began = Instant::now();
        let mut encoder = self.gpu.encoder();
        let stats = self.record(frame, &mut encoder);
        self.gpu.queue.submit([encoder.finish()]);
        let recorded = began.elapsed();
        self.gpu.wait()?;
        self.drawn_in_full()?;
        Ok((stats, recorded))
    }

    /// Takes a picture, with the display over it if there is one for what the renderer did.
    ///
    /// # Errors
    /// When the adapter fails or refuses a shader.
    pub fn shoot(
        &mut self,
        frame: &Frame,
        texts: &Texts,
        display: impl FnOnce(&DrawStats) -> Option<HudModel>,
    ) -> Result<RgbaImage, Failure> {
        self.renderer.complete_next();
        let mut encoder = self.gpu.encoder();
        let stats = self.record(frame, &mut encoder);
        if let Some(display) = display(&stats) {
            let output = self.display(texts, &display);
            self.overlay.paint(
                &self.gpu,
                &mut encoder,
                &[self.offscreen.view()],
                self.size,
                output,
            );
        }
        self.gpu.queue.submit([encoder.finish()]);
        self.drawn_in_full()?;
        Ok(self.offscreen.read(&self.gpu)?)
    }

    /// Takes a picture of a room, without a display. Its signs are in the language of `texts`; `with_hand`: whether it
    /// shows what is held.
    ///
    /// # Errors
    /// When the adapter cannot trace rays, the room is too large for it, or it fails.
    pub fn shoot_room(
        &mut self,
        (room, texts): (&OpenRoom, &Texts),
        id: (u64, u64),
        quality: Quality,
        with_hand: bool,
    ) -> Result<RgbaImage, Failure> {
        let view = RoomView {
            tile: None,
            id,
            moment: room.shown(room.scene.now(), with_hand),
            options: room.picture_options(quality, self.options.samples),
        };
        let pictures = match &mut self.rooms {
            Some(pictures) => pictures,
            none => none.insert(RoomPictures::new(&self.gpu, &self.options, self.size)?),
        };
        let shown = (&room.scene, texts);
        pictures.shoot(&self.gpu, &self.offscreen, shown, &view)
    }

    fn record(&mut self, frame: &Frame, encoder: &mut wgpu::CommandEncoder) -> DrawStats {
        let mirror = Mirror::of(frame, self.size);
        let further: Vec<_> = mirror.iter().map(Mirror::further).collect();
        let target = self.offscreen.view();
        self.renderer.draw_views(frame, &further, encoder, target).0
    }

    /// Whether the processor draws.
    pub fn is_software(&self) -> bool {
        self.gpu.is_software()
    }

    /// What a refused shader was to draw is missing in the picture.
    fn drawn_in_full(&self) -> Result<(), Failure> {
        self.renderer
            .fault()
            .map_or(Ok(()), |fault| Err(fault.into()))
    }

    fn display(&self, texts: &Texts, model: &HudModel) -> egui::FullOutput {
        let scale = display_scale(self.size.1);
        let size = egui::vec2(self.size.0 as f32, self.size.1 as f32) / scale;
        let mut input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
            ..Default::default()
        };
        if let Some(viewport) = input.viewports.get_mut(&egui::ViewportId::ROOT) {
            viewport.native_pixels_per_point = Some(scale);
        }
        self.overlay.context().run_pass(input, |context| {
            antipode_ui::show_hud(context, texts, model);
        })
    }
}

/// Pixels per point of the display on a picture of this height: it keeps its share of small pictures.
fn display_scale(height: u32) -> f32 {
    (height as f32 / 720.0).clamp(0.5, 3.0)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use antipode_geometry::Geometry;
    use antipode_scene::{Scene, WorldSetup};
    use antipode_settings::Msaa;
    use clap::Parser as _;

    use super::*;
    use crate::cli::Cli;

    fn common() -> Common {
        Cli::parse_from(["antipode", "--adapter", "software", "--size", "96x72"]).common
    }

    fn scene() -> Scene {
        let setup = WorldSetup {
            name: "Picture".to_owned(),
            seed: 1,
            geometry: Geometry::Euclidean,
            radius_m: 32.0,
            generator: antipode_scene::Generator::OneBiome,
            mode: antipode_scene::Mode::default(),
            view_distance: 2,
        };
        Scene::open(setup, None).unwrap()
    }

    #[test]
    fn edges_are_smoothed_as_the_settings_say() {
        let texts = Texts::default();
        let mut scene = scene();
        assert!(scene.settle(Duration::from_mins(1)));
        let frame = scene.frame(1.2, 4.0 / 3.0, 1);
        let shot = |studio: &mut Studio| studio.shoot(&frame, &texts, |_| None).unwrap();
        let smooth = Settings {
            msaa: Msaa::Four,
            ..Settings::default()
        };
        let mut studio = Studio::new(&common(), &Settings::default()).unwrap();
        let plain = shot(&mut studio);
        let smoothed = shot(&mut Studio::new(&common(), &smooth).unwrap());
        assert_ne!(plain, smoothed);
        studio.follow(&smooth).unwrap();
        assert_eq!(shot(&mut studio), smoothed);
    }

    #[test]
    fn a_picture_that_lacks_what_a_shader_was_to_draw_is_refused() {
        let common = common();
        let (settings, texts) = (Settings::default(), Texts::default());
        let frame = scene().frame(1.2, 4.0 / 3.0, 1);
        let take = |shaders| {
            let mut studio = Studio::with_shaders(&common, &settings, shaders)?;
            studio.draw(&frame)?;
            studio.shoot(&frame, &texts, |_| None)
        };
        assert!(take(Shaders::default()).is_ok());
        let refused = take(Shaders::with("terrain", "fn vertex( { nothing }"));
        let words = refused.unwrap_err().to_string();
        assert!(words.contains("refuses a shader"), "{words}");
    }
}
