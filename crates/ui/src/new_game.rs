//! The form for a new world. It says in words what is wrong while the player types.

mod radius;

use antipode_language::Texts;
use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{
    Align2, Color32, FontId, Key, Label, Pos2, Rect, Response, RichText, Role, Sense, Shape,
    Stroke, Ui, WidgetInfo, pos2, vec2,
};

use crate::entry::line;
use crate::layout::{Stops, pane};
use crate::legible::is_partly_shown;
use crate::model::{GeometryChoice, Intent, Screen};
use crate::seed::{SeedError, parse_seed};
use crate::shell::Pass;
use crate::theme::{ACCENT, BAD, GOOD, GRID, TEXT, WEAK, small};
use crate::widgets::{button, paint_card, primary_button};

/// Longest text a field takes: far beyond what is valid, so that too long is
/// said and not silently cut, but a pasted book stays out.
const FIELD_LIMIT: usize = 200;

/// Most names that are tried for a free one.
const MOST_NAMES: u32 = 100_000;

/// What the player has filled in so far.
pub(crate) struct NewGameForm {
    /// The name: one that is free is offered until the player types another.
    name: String,
    geometry: GeometryChoice,
    seed: String,
    radius_m: f64,
    /// Whether the name is the player's own.
    touched: bool,
}

/// The fields in which Enter makes the world.
struct Fields {
    name: Response,
    seed: Response,
    radius: Option<Response>,
}

impl Fields {
    /// Enter takes the focus off a line of text, so losing it counts.
    fn any_in_use(&self) -> bool {
        [Some(&self.name), Some(&self.seed), self.radius.as_ref()]
            .into_iter()
            .flatten()
            .any(|field| field.has_focus() || field.lost_focus())
    }
}

impl Default for NewGameForm {
    fn default() -> Self {
        Self {
            name: String::new(),
            geometry: GeometryChoice::default(),
            seed: String::new(),
            radius_m: radius::DEFAULT_M,
            touched: false,
        }
    }
}

impl NewGameForm {
    /// Draws the form; Create, or Enter in a field, makes the world.
    pub(crate) fn show(&mut self, ui: &mut Ui, pass: &mut Pass<'_>) {
        let nothing_focused = ui.ctx().memory(egui::Memory::focused).is_none();
        let regions = pass.regions;
        let mut create = false;
        let mut back = false;
        let texts = pass.model.texts;
        let offers_another = self.offer_name(pass);
        let name = (pass.model.check_name)(self.name.trim());
        let seed = parse_seed(&self.seed);
        let missing = match (&name, &seed) {
            (Err(_), _) => Some(texts.say("needs-name")),
            (_, Err(_)) => Some(texts.say("needs-seed")),
            _ => None,
        };
        let body = |ui: &mut Ui, stops: &mut Stops| {
            let name = self.name_field(ui, pass, &name);
            if !self.touched && (offers_another || name.gained_focus()) {
                select_all(&name, &self.name);
            }
            stops.add(&name);
            self.cards(ui, texts, stops);
            let seed = self.seed_field(ui, texts, seed);
            stops.add(&seed);
            let spherical = self.geometry == GeometryChoice::Spherical;
            let walk_m_s = pass.model.walk_m_s;
            let radius =
                spherical.then(|| radius::choose(ui, texts, &mut self.radius_m, walk_m_s, stops));
            Fields { name, seed, radius }
        };
        let fields = pane(ui, regions.pane, &texts.say("menu-new-game"), body, |ui| {
            create = primary_button(ui, &texts.say("create"), missing.is_none()).clicked();
            back = button(ui, &texts.say("back")).clicked();
            if let Some(missing) = &missing {
                let words = RichText::new(missing).font(small()).color(WEAK);
                ui.add(Label::new(words).wrap());
            }
        });
        let enter = ui.input(|input| input.key_pressed(Key::Enter));
        create |= enter && (nothing_focused || fields.any_in_use());
        if back {
            pass.go = Some(Screen::Main);
        } else if create {
            self.create(pass, &fields);
        }
    }

    /// Offers a name nobody has taken, as long as the player has typed none; tells whether it is another than before.
    fn offer_name(&mut self, pass: &Pass<'_>) -> bool {
        if self.touched {
            return false;
        }
        let numbered = |number: u32| {
            let values = [("number", number.into())];
            pass.model.texts.say_with("name-offered", &values)
        };
        let mut names = (1..MOST_NAMES).map(numbered);
        let free = names.find(|name| (pass.model.check_name)(name).is_ok());
        let free = free.unwrap_or_default();
        let another = free != self.name;
        self.name = free;
        another
    }

    /// Asks for the world, or sends the player back to what is wrong. Everything is
    /// checked anew: it may have changed in this very frame.
    fn create(&mut self, pass: &mut Pass<'_>, fields: &Fields) {
        self.touched = true;
        let name = (pass.model.check_name)(self.name.trim());
        match (name, parse_seed(&self.seed)) {
            (Ok(()), Ok(seed)) => pass.intents.push(self.intent(seed)),
            (Err(_), _) => fields.name.request_focus(),
            (_, Err(_)) => fields.seed.request_focus(),
        }
    }

    fn intent(&self, seed: Option<u64>) -> Intent {
        let spherical = self.geometry == GeometryChoice::Spherical;
        Intent::NewGame {
            name: self.name.trim().to_owned(),
            geometry: self.geometry,
            seed,
            radius_m: spherical.then_some(self.radius_m),
        }
    }

    fn name_field(
        &mut self,
        ui: &mut Ui,
        pass: &mut Pass<'_>,
        check: &Result<(), String>,
    ) -> Response {
        let texts = pass.model.texts;
        let label = ui.label(texts.say("name"));
        let hint = texts.say("name-hint");
        let field = line(ui, &mut self.name, &hint, FIELD_LIMIT).labelled_by(label.id);
        pass.offer_focus(&field);
        self.touched |= field.changed();
        match check {
            Ok(()) if is_partly_shown(&self.name) => {
                verdict(ui, &texts.say("name-not-shown"), WEAK);
            }
            Ok(()) => verdict(ui, &texts.say("name-free"), GOOD),
            Err(reason) => verdict(ui, reason, if self.touched { BAD } else { WEAK }),
        }
        field
    }

    fn seed_field(
        &mut self,
        ui: &mut Ui,
        texts: &Texts,
        seed: Result<Option<u64>, SeedError>,
    ) -> Response {
        let label = ui.label(texts.say("seed"));
        let hint = texts.say("seed-hint");
        let field = line(ui, &mut self.seed, &hint, FIELD_LIMIT).labelled_by(label.id);
        match seed {
            Ok(None) => verdict(ui, &texts.say("seed-random"), WEAK),
            Ok(Some(seed)) => {
                let values = [("seed", seed.to_string().into())];
                verdict(ui, &texts.say_with("seed-is", &values), GOOD);
            }
            Err(error) => verdict(ui, &error.say(texts), BAD),
        }
        field
    }

    fn cards(&mut self, ui: &mut Ui, texts: &Texts, stops: &mut Stops) {
        ui.label(texts.say("space"));
        let across = ui.available_width() >= 480.0;
        let width = if across {
            (ui.available_width() - 2.0 * GRID) / 3.0
        } else {
            ui.available_width()
        };
        let height = GeometryChoice::ALL
            .map(|choice| card_height(ui, &choice.description(texts), width, across))
            .into_iter()
            .fold(0.0, f32::max);
        let size = vec2(width, height);
        let mut draw = |ui: &mut Ui| {
            for choice in GeometryChoice::ALL {
                let response = card(ui, texts, choice, self.geometry == choice, size, across);
                stops.add(&response);
                if response.clicked() {
                    self.geometry = choice;
                }
            }
        };
        if across {
            ui.horizontal(draw);
        } else {
            draw(ui);
        }
    }
}

/// Selects what stands in a field, so that typing replaces it.
fn select_all(field: &Response, text: &str) {
    let mut state = TextEditState::load(&field.ctx, field.id).unwrap_or_default();
    let all = CCursorRange::two(CCursor::new(0), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(all));
    state.store(&field.ctx, field.id);
}

fn verdict(ui: &mut Ui, words: &str, colour: Color32) {
    ui.label(RichText::new(words).font(small()).color(colour));
}

/// Side of a card's picture, in points.
const ICON: f32 = 40.0;

/// Width left for a card's words.
fn card_wrap(width: f32, across: bool) -> f32 {
    let beside = if across { 0.0 } else { ICON + 12.0 };
    (width - 24.0 - beside).max(1.0)
}

fn card_height(ui: &Ui, description: &str, width: f32, across: bool) -> f32 {
    let words = ui
        .painter()
        .layout(
            description.to_owned(),
            small(),
            WEAK,
            card_wrap(width, across),
        )
        .size()
        .y;
    let words = words + 24.0 + 20.0;
    if across {
        words + ICON + GRID
    } else {
        words.max(ICON + 20.0)
    }
}

fn card(
    ui: &mut Ui,
    texts: &Texts,
    choice: GeometryChoice,
    chosen: bool,
    size: egui::Vec2,
    across: bool,
) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let label = choice.label(texts);
    response.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, chosen, &label));
    paint_card(ui, &response, chosen);
    let painter = ui.painter().with_clip_rect(ui.clip_rect().intersect(rect));
    let corner = rect.min + vec2(12.0, 10.0);
    let icon = Rect::from_min_size(corner, vec2(ICON, ICON));
    let colour = if chosen { ACCENT } else { TEXT };
    ui.painter()
        .extend(icon_shapes(choice, icon, Stroke::new(1.5, colour)));
    let words = if across {
        corner + vec2(0.0, ICON + GRID)
    } else {
        corner + vec2(ICON + 12.0, 0.0)
    };
    painter.text(
        words,
        Align2::LEFT_TOP,
        label,
        FontId::proportional(16.0),
        TEXT,
    );
    let wrap = card_wrap(size.x, across);
    let text = painter.layout(choice.description(texts), small(), WEAK, wrap);
    painter.galley(words + vec2(0.0, 22.0), text, WEAK);
    response
}

/// A patch of each space in lines: geodesics that part, stay apart, or meet.
fn icon_shapes(choice: GeometryChoice, rect: Rect, stroke: Stroke) -> Vec<Shape> {
    let bend = match choice {
        GeometryChoice::Hyperbolic => -0.45,
        GeometryChoice::Euclidean => 0.0,
        GeometryChoice::Spherical => 1.0,
    };
    let at = |x: f32, y: f32| -> Pos2 {
        pos2(
            rect.center().x + 0.5 * x * rect.width(),
            rect.center().y + 0.5 * y * rect.height(),
        )
    };
    // A line at offset d runs at d * width(t): narrow ends where geodesics meet.
    let width = |t: f32| {
        if bend > 0.0 {
            (1.0 - t * t).max(0.0).sqrt()
        } else {
            0.62 - bend * (t * t - 0.4)
        }
    };
    let mut shapes = Vec::new();
    for d in [-1.0, -0.5, 0.0, 0.5, 1.0_f32] {
        let steps = (-8..=8).map(|step| step as f32 / 8.0);
        shapes.push(Shape::line(
            steps.clone().map(|t| at(d * width(t), t)).collect(),
            stroke,
        ));
        if bend <= 0.0 {
            shapes.push(Shape::line(
                steps.map(|t| at(t, d * width(t))).collect(),
                stroke,
            ));
        } else if d.abs() < 1.0 {
            let half = (1.0 - d * d).sqrt();
            shapes.push(Shape::line(
                steps.map(|t| at(t * half, d)).collect(),
                stroke,
            ));
        }
    }
    shapes
}
