//! The form for a new world. It says in words what is wrong while the player types.

mod cards;
mod radius;
mod squares;

use antipode_language::Texts;
use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;
use egui::{Color32, Key, Label, Response, RichText, Ui};

use crate::entry::line;
use crate::layout::{Stops, pane};
use crate::legible::is_partly_shown;
use crate::model::{GeometryChoice, Intent, ModeChoice, Screen};
use crate::seed::{SeedError, parse_seed};
use crate::shell::Pass;
use crate::theme::{BAD, GOOD, WEAK, small};
use crate::widgets::{button, primary_button};
use cards::Card;

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
    mode: ModeChoice,
    seed: String,
    /// Radius of a closed world, metres.
    radius_m: f64,
    /// That of a hyperbolic world, metres.
    squares_radius_m: f64,
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
            mode: ModeChoice::default(),
            seed: String::new(),
            radius_m: radius::DEFAULT_M,
            squares_radius_m: squares::DEFAULT_RADIUS_M,
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
            self.space(ui, texts, stops);
            self.mode(ui, texts, stops);
            let seed = self.seed_field(ui, texts, seed);
            stops.add(&seed);
            let radius = self.size(ui, texts, pass.model.walk_m_s, stops);
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
        let radius_m = match self.geometry {
            GeometryChoice::Spherical => Some(self.radius_m),
            GeometryChoice::HyperbolicWorld => Some(self.squares_radius_m),
            GeometryChoice::Hyperbolic | GeometryChoice::Euclidean => None,
        };
        Intent::NewGame {
            name: self.name.trim().to_owned(),
            geometry: self.geometry,
            mode: self.mode,
            seed,
            radius_m,
        }
    }

    /// The size of a world whose space has one; returns the field in which Enter makes the world.
    fn size(
        &mut self,
        ui: &mut Ui,
        texts: &Texts,
        walk_m_s: f64,
        stops: &mut Stops,
    ) -> Option<Response> {
        match self.geometry {
            GeometryChoice::Spherical => {
                let radius_m = &mut self.radius_m;
                Some(radius::choose(ui, texts, radius_m, walk_m_s, stops))
            }
            GeometryChoice::HyperbolicWorld => {
                squares::choose(ui, texts, &mut self.squares_radius_m, stops);
                None
            }
            GeometryChoice::Hyperbolic | GeometryChoice::Euclidean => None,
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

    fn space(&mut self, ui: &mut Ui, texts: &Texts, stops: &mut Stops) {
        let card = |choice: GeometryChoice| Card {
            label: choice.label(texts),
            about: choice.description(texts),
            space: Some(choice),
            chosen: self.geometry == choice,
        };
        let cards = GeometryChoice::ALL.map(card);
        if let Some(index) = cards::choose(ui, &texts.say("space"), &cards, stops) {
            self.geometry = GeometryChoice::ALL[index];
        }
    }

    fn mode(&mut self, ui: &mut Ui, texts: &Texts, stops: &mut Stops) {
        let card = |choice: ModeChoice| Card {
            label: choice.label(texts),
            about: choice.description(texts),
            space: None,
            chosen: self.mode == choice,
        };
        let cards = ModeChoice::ALL.map(card);
        if let Some(index) = cards::choose(ui, &texts.say("mode"), &cards, stops) {
            self.mode = ModeChoice::ALL[index];
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
