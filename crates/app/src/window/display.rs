//! The display over the world or room that is played: what of it is shown, and what it tells.

use antipode_language::Texts;
use antipode_scene::Scene;
use antipode_scene::frame::Frame;
use antipode_settings::Config;
use antipode_ui::HudModel;

use super::framerate::FrameRate;
use super::phase::Phase;
use super::play::Play;
use super::room_hud;
use crate::drawn::Drawn;
use crate::hud;
use crate::navigator::{Navigator, SurveyOrder, columns_for, extent_of};

/// What the player looks at besides the world.
#[derive(Debug, Default)]
pub struct Display {
    pub(super) hidden: bool,
    pub(super) figures: bool,
    pub(super) hit_shapes: bool,
    /// Whether the map is the large one.
    pub(super) large_map: bool,
    /// Whether the last picture of the world has a rear mirror.
    has_mirror: bool,
    pub(super) fps: FrameRate,
    /// What the last frame was drawn with, and the adapter's own time in milliseconds where it can tell.
    pub(super) drawn: Option<(Drawn, Option<f64>)>,
    navigator: Navigator,
}

impl Display {
    /// What it shows of a world or room that is played.
    pub fn model(&mut self, texts: &Texts, config: &Config, play: &Play) -> Option<HudModel> {
        let settings = &config.settings;
        let fps = self.fps.value();
        let session = match &play.phase {
            Phase::Playing(session) if !self.hidden => session,
            Phase::InRoom(visit) if !self.hidden && visit.workshop.is_none() => {
                return Some(room_hud::model(texts, &config.profiles, visit, fps));
            }
            _ => return None,
        };
        let scene = &session.scene;
        let frame_ms = (fps > 0.0).then(|| 1000.0 / f64::from(fps));
        let figures = self.drawn.filter(|_| self.figures).map(|(drawn, gpu_ms)| {
            drawn.figures(texts, scene, frame_ms, gpu_ms, play.pace.dropped_s())
        });
        let seen = session.between.seen(scene);
        let mut model = hud::model(texts, scene, &seen, fps, figures);
        model.mirror = self.has_mirror;
        let extent = extent_of(self.large_map);
        let order = SurveyOrder {
            world: play.opened,
            extent,
            columns: columns_for(1e-3 * frame_ms.unwrap_or_default(), extent),
        };
        self.navigator
            .add_to(&mut model, scene, &seen, texts, settings, order);
        Some(model)
    }

    /// Adds to a picture of the world what is asked for, and leaves out what is hidden: the mirror behind the menu, too,
    /// where no display frames it.
    pub fn apply_to(&mut self, frame: &mut Frame, scene: &Scene, is_played: bool) {
        if self.hidden || !is_played {
            frame.mirror = None;
        }
        if self.hidden {
            frame.view.hand = None;
            frame.content_mut().marker = None;
        }
        if self.hit_shapes {
            frame.content_mut().hit_shapes = scene.hit_shapes();
        }
        self.has_mirror = frame.mirror.is_some();
    }
}
