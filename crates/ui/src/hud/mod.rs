//! The heads-up display over the world or the room, painted and never clickable.

mod brush;
mod compass;
mod damage;
mod figures;
mod gauges;
mod hint;
pub(crate) mod hotbar;
mod minimap;
mod mirror;
mod plate;
mod room;
mod speech;
mod wounds;

use antipode_items::Item;
use antipode_language::Texts;
use egui::{Align2, Context, FontId, LayerId, Painter, Pos2, Rect, Stroke, pos2, vec2};

use crate::dialog::percent;
use crate::layout::inset;
use crate::theme::{ACCENT, GRID, LINE, TEXT, mono, small};
use plate::{Lines, plate};

pub(crate) use brush::dot;
pub use brush::{BrushForm, BrushModel, BrushRow, HeapModel, Tint};
pub use compass::{CompassModel, FlagView, GuidePlace, GuideView};
pub use damage::DamageModel;
pub use figures::FigureModel;
pub use hint::HintModel;
pub use minimap::{MapMark, MapModel, MarkKind, Relief, ReliefNode, Tints, tints_of};
pub use mirror::mirror_place;
pub use room::RoomModel;
pub use speech::SpeechModel;
pub use wounds::WoundModel;

/// One slot of the hotbar.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SlotView {
    /// The item's name, shown while its slot is selected; may be empty.
    pub label: String,
    /// What lies in it.
    pub item: Option<Item>,
    /// How many, where that matters.
    pub count: Option<u32>,
}

/// What the dial under the wheel turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DialKind {
    /// The raised map of a hyperbolic world.
    Raised,
    /// The horizon map of a hyperbolic world.
    Horizon,
    /// The bend of a flat world's picture: hyperbolic above zero, spherical below.
    Bend,
}

/// The dial under the wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvatureView {
    /// What it turns.
    pub kind: DialKind,
    /// The present value.
    pub value: f64,
    /// The value at the dial's left end.
    pub min: f64,
    /// The value at the dial's right end.
    pub max: f64,
}

/// Everything the display shows in one frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HudModel {
    /// Frames per second, already smoothed; zero, as in a still picture, is not shown.
    pub fps: f32,
    /// Where the player is in the chart, in metres.
    pub chart: [f64; 3],
    /// The same place in the curved model, in units of its radius.
    pub curved: [f64; 4],
    /// Whether space is flat, so that the curved coordinates say nothing new.
    pub curved_is_flat: bool,
    /// The hotbar: ten slots, keys 1 to 9 and 0; none where it is not to be seen.
    pub slots: Vec<SlotView>,
    /// Index of the slot in hand, from 0.
    pub selected: usize,
    /// The dial, in hyperbolic worlds and in flat ones that are bent.
    pub curvature: Option<CurvatureView>,
    /// 'A' or 'B', in spherical worlds.
    pub hemisphere: Option<char>,
    /// The space in a word.
    pub geometry: String,
    /// What the land about is called, as "Forest"; empty where that is not known.
    pub land: String,
    /// Radius of the brush in metres, while a tool with one is in hand.
    pub brush_radius_m: Option<f64>,
    /// The rest of that brush.
    pub brush: BrushModel,
    /// Speed of the car that the player drives, km/h; in the brush's place.
    pub speed_km_h: Option<f64>,
    /// Whether the picture has a rear mirror: [`mirror_place`].
    pub mirror: bool,
    /// What is against what would be done where the crosshair points, in a few words.
    pub against: Option<String>,
    /// Whether to mark the middle of the screen.
    pub show_crosshair: bool,
    /// Share of the land around that is there, 0 to 1, while some is missing.
    pub loading: Option<f32>,
    /// Time of day in words, e.g. "12:40".
    pub time_label: String,
    /// Something to tell the player, as a sentence.
    pub notice: Option<String>,
    /// What a newcomer is told now.
    pub hint: Option<HintModel>,
    /// Whether a command that cheats was ever used in this world.
    pub cheated: bool,
    /// What drawing the frame took, while the player wants to know.
    pub figures: Option<FigureModel>,
    /// Which way the player looks, unless it is switched off.
    pub compass: Option<CompassModel>,
    /// What is found by looking from one flag to another.
    pub sighting: Option<String>,
    /// The land about the player, unless it is switched off.
    pub map: Option<MapModel>,
    /// The player's health as a share of all there can be; not shown where nothing is known of it or it is full.
    pub health: Option<f32>,
    /// Damage that the player has just taken.
    pub damage: Option<DamageModel>,
    /// Where those are who could shoot and are not to be seen in the picture, clockwise from straight ahead, radians.
    pub hidden_foes: Vec<f32>,
    /// Health of others who are hurt.
    pub wounds: Vec<WoundModel>,
    /// Of a room, what there is to say of it; then nothing else tells of the place.
    pub room: Option<RoomModel>,
    /// What somebody says to the player.
    pub speech: Option<SpeechModel>,
    /// Whether a shot of the player's has just struck someone.
    pub struck: bool,
}

/// Draws the display; call it before [`crate::Shell::show`]. Returns what the instruments at the right cover, which
/// messages keep off.
pub fn show_hud(ctx: &Context, texts: &Texts, model: &HudModel) -> Rect {
    let screen = inset(ctx.content_rect(), GRID);
    let painter = ctx.layer_painter(LayerId::background());
    about_the_aim(&painter, ctx.content_rect(), model);
    let position = if model.figures.is_some() && model.room.is_none() {
        position(&painter, screen, texts, model)
    } else {
        Rect::NOTHING
    };
    let lower = model.room.is_none().then(|| lower(&painter, screen, model));
    let named = lower.is_some_and(|(_, _, map)| map.is_some_and(|it| it.is_named));
    let land = if named { "" } else { &model.land };
    let figures = figures::show(&painter, screen, position, texts, model, land);
    let mirror = if model.mirror {
        mirror::show(&painter, ctx.content_rect())
    } else {
        Rect::NOTHING
    };
    let below = screen.with_min_y(screen.min.y.max(mirror.max.y + GRID));
    let has_room = !model.mirror || screen.height() >= mirror::COMPASS_FROM;
    let compass = model.compass.as_ref().filter(|_| has_room);
    let strip = compass.map_or(Rect::NOTHING, |compass| {
        compass::show(&painter, below, position, figures, texts, compass)
    });
    let lowest = [position, figures, mirror, strip].map(|it| it.max.y);
    let top = lowest.into_iter().fold(f32::NEG_INFINITY, f32::max) + GRID;
    if let (Some(map), Some((bar, bottom, None))) = (&model.map, lower) {
        let place = minimap::large_place(screen, top, bar.min.y - GRID);
        let place = place.or_else(|| minimap::place(screen, bottom));
        if let Some(place) = place.filter(|_| map.is_large) {
            minimap::show(&painter, place, texts, map, &model.land);
        }
    }
    notices(&painter, screen, top, texts, model);
    if let Some(room) = &model.room {
        room::show(&painter, screen, top, room);
    }
    let Some((bar, bottom, place)) = lower else {
        return Rect::NOTHING;
    };
    // Beside so much to read the instruments keep below it.
    let ceiling = if model.figures.is_some() {
        figures.max.y
    } else {
        screen.min.y
    };
    let mut room = screen.with_min_y(ceiling);
    if let (Some(map), Some(place)) = (&model.map, place) {
        minimap::show(&painter, place, texts, map, &model.land);
        if place.disc.max.y >= bottom {
            room.min.x = place.disc.max.x + GRID;
        }
    }
    let instruments = gauges::show(&painter, room, bottom, texts, model);
    if let Some(speech) = &model.speech {
        let mut room = screen.with_min_y(top).with_max_y(bar.min.y - GRID);
        if instruments.is_positive() {
            room.max.x = instruments.min.x - GRID;
        }
        speech::show(&painter, ctx.content_rect(), room, speech);
    }
    instruments
}

/// Draws the hotbar; returns what it covers with the brush's row, where the instruments beside it end, and where the map goes.
fn lower(painter: &Painter, screen: Rect, model: &HudModel) -> (Rect, f32, Option<minimap::Place>) {
    let bar = hotbar::show(painter, screen, model);
    let bar = brush::row(painter, screen, bar, &model.brush);
    let bottom = gauges::bottom(screen, bar);
    let is_small = model.map.as_ref().is_some_and(|map| !map.is_large);
    let place = minimap::place(screen, bottom).filter(|_| is_small);
    (bar, bottom, place)
}

/// Wounds, where damage comes from, and the crosshair.
fn about_the_aim(painter: &Painter, whole: Rect, model: &HudModel) {
    wounds::show(painter, whole, &model.wounds);
    if let Some(damage) = model.damage {
        damage::show(painter, whole, damage);
    }
    for from_rad in &model.hidden_foes {
        damage::hidden(painter, whole, *from_rad);
    }
    if model.show_crosshair {
        crosshair(painter, whole.center());
    }
    brush::heaps(painter, whole, whole.center(), &model.brush);
    if model.struck {
        damage::struck(painter, whole.center());
    }
}

/// A small cross with a gap, dark under light so it shows on snow and at night.
fn crosshair(painter: &Painter, centre: Pos2) {
    for (width, colour) in [(4.0, egui::Color32::from_black_alpha(130)), (1.6, TEXT)] {
        for arm in [
            vec2(1.0, 0.0),
            vec2(-1.0, 0.0),
            vec2(0.0, 1.0),
            vec2(0.0, -1.0),
        ] {
            // The dark outline reaches past the ends of the light arm.
            let (from, to) = if width > 2.0 {
                (3.0, 11.0)
            } else {
                (4.0, 10.0)
            };
            painter.line_segment(
                [centre + from * arm, centre + to * arm],
                Stroke::new(width, colour),
            );
        }
    }
    painter.circle_filled(centre, 1.2, TEXT);
}

/// A model coordinate; those of hyperbolic space grow with the exponential of the way walked.
fn coordinate(texts: &Texts, value: f64) -> String {
    if value.abs() < 1e5 {
        texts.number(value, 3)
    } else {
        texts.marked(&format!("{value:.2e}"))
    }
}

/// Top left, beside the frame figures: where the player is, in both kinds of coordinates, and the mark of a world in
/// which a command that cheats was used.
fn position(painter: &Painter, screen: Rect, texts: &Texts, model: &HudModel) -> Rect {
    let [x, y, z] = model.chart;
    let [x, y, z] = [x, y, z].map(|metres| texts.number(metres, 2));
    let chart = format!("x {x}  y {y}  z {z} m");
    let curved = if model.curved_is_flat {
        texts.say("display-flat")
    } else {
        let numbers = model.curved.map(|value| coordinate(texts, value));
        format!("({})", numbers.join(texts.between_numbers()))
    };
    let mut lines = vec![
        (texts.say("display-chart"), chart),
        (texts.say("display-curved"), curved),
    ];
    if model.cheated {
        lines.push((String::new(), format!("◆ {}", texts.say("cheats-used"))));
    }
    Lines::new(painter, screen, &lines, &mono(), TEXT).paint(
        painter,
        screen,
        screen.min,
        Align2::LEFT_TOP,
    )
}

/// In the middle below `top`: what is against what would be done, what is sighted, or what is loading, and what there is to know.
fn notices(painter: &Painter, screen: Rect, top: f32, texts: &Texts, model: &HudModel) {
    let mut at = pos2(screen.center().x, top);
    if let Some(against) = model.against.as_ref().or(model.sighting.as_ref()) {
        let anchor = Align2::CENTER_TOP;
        let rect = plate(painter, screen, at, anchor, against, small(), TEXT);
        at.y = rect.max.y + GRID;
    } else if let Some(part) = model.loading {
        let part = part.clamp(0.0, 1.0);
        let words = texts.say_with("display-loading", &[("percent", percent(part))]);
        let rect = plate(
            painter,
            screen,
            at,
            Align2::CENTER_TOP,
            &words,
            small(),
            TEXT,
        );
        let rail = Rect::from_min_max(
            pos2(rect.min.x + 6.0, rect.max.y - 3.0),
            rect.max - vec2(6.0, 0.0),
        );
        painter.rect_filled(rail, 1, LINE);
        painter.rect_filled(rail.with_max_x(rail.min.x + part * rail.width()), 1, ACCENT);
        at.y = rect.max.y + GRID;
    }
    if let Some(notice) = &model.notice {
        let rect = plate(
            painter,
            screen,
            at,
            Align2::CENTER_TOP,
            notice,
            FontId::proportional(16.0),
            TEXT,
        );
        at.y = rect.max.y + GRID;
    }
    if let Some(hint) = &model.hint {
        hint::show(painter, screen, at.y, hint);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_stays_short_however_far_one_has_walked() {
        let texts = Texts::default();
        let coordinate = |value| coordinate(&texts, value);
        assert_eq!(coordinate(-0.4304), "-0.430");
        assert_eq!(coordinate(-1e-9), "0.000");
        for far in [1e5, -3.2e43, 1e300, f64::INFINITY] {
            assert!(coordinate(far).len() <= 9, "{}", coordinate(far));
        }
    }
}
