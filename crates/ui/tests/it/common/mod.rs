//! A game of two fields round the menus, and what tests read from a frame.
pub mod hud;

use antipode_language::{Language, Texts};
use antipode_settings::Config;
use antipode_ui::{
    AboutModel, Backdrop, Intent, MenuModel, Shell, WorldFiles, WorldRow, WorldsIntent, apply_theme,
};
use egui::{Key, Rect, Shape, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

/// Sizes of windows, in points.
pub const SIZES: [Vec2; 6] = [
    vec2(640.0, 360.0),
    vec2(427.0, 240.0),
    vec2(320.0, 200.0),
    vec2(1280.0, 720.0),
    vec2(3840.0, 2160.0),
    vec2(700.0, 1400.0),
];
/// Smaller than anybody could use.
pub const SMALLEST: [Vec2; 4] = [
    vec2(1.0, 1.0),
    vec2(1.0, 400.0),
    vec2(900.0, 2.0),
    vec2(40.0, 30.0),
];

/// Every language with every one of these sizes.
pub fn everywhere(sizes: &[Vec2]) -> Vec<(Language, Vec2)> {
    let languages = Language::ALL.into_iter();
    languages
        .flat_map(|language| sizes.iter().map(move |size| (language, *size)))
        .collect()
}

/// What the game round the menus knows, and every intent they returned.
pub struct Game {
    pub texts: Texts,
    pub shell: Shell,
    pub worlds: Vec<WorldRow>,
    pub rooms: Vec<WorldRow>,
    pub in_room: bool,
    pub own_room: antipode_ui::OwnRoom,
    pub files: WorldFiles,
    pub config: Config,
    pub running: Option<String>,
    pub backdrop: Backdrop,
    pub about: AboutModel,
    pub adapter_notice: String,
    pub intents: Vec<Intent>,
}

impl Game {
    pub fn new() -> Self {
        Self {
            texts: Texts::default(),
            shell: Shell::new(),
            worlds: Vec::new(),
            rooms: Vec::new(),
            in_room: false,
            own_room: antipode_ui::OwnRoom::No,
            files: WorldFiles::default(),
            config: Config::default(),
            running: None,
            backdrop: Backdrop::default(),
            about: about(),
            adapter_notice: "No GPU was found: the processor draws.".to_owned(),
            intents: Vec::new(),
        }
    }

    pub fn show(&mut self, ctx: &egui::Context) {
        let names: Vec<_> = self.worlds.iter().map(|row| row.name.clone()).collect();
        let check_new = |name: &str| {
            if names.iter().any(|taken| taken == name) {
                return check_name("taken");
            }
            check_name(name)
        };
        let model = MenuModel {
            texts: &self.texts,
            running_world: self.running.as_deref(),
            backdrop: self.backdrop,
            in_room: self.in_room,
            own_room: self.own_room,
            worlds: &self.worlds,
            rooms: &self.rooms,
            config: &self.config,
            check_name: &check_new,
            walk_m_s: 4.5,
            check_rename: &|_, name| check_name(name),
            check_room_rename: &|_, name| check_name(name),
            world_files: &self.files,
            room_files: &self.files,
            adapter_notice: Some(&self.adapter_notice),
            sound_notice: Some("There is no sound device."),
            version: "0.1.0",
            about: &self.about,
        };
        let mut intents = self.shell.show(ctx, &model);
        for intent in &intents {
            match intent {
                Intent::Set { id, value } => {
                    self.config.settings.set(id, (*value).into()).unwrap();
                }
                Intent::ResetSetting(id) => assert!(self.config.settings.reset(id)),
                Intent::Bind(profiles) => self.config.profiles = (**profiles).clone(),
                _ => {}
            }
        }
        self.intents.append(&mut intents);
    }
}

fn about() -> AboutModel {
    AboutModel {
        adapter: "Radiant 9000 (Vulkan)".to_owned(),
        driver: "radiant 1.2".to_owned(),
        system: "linux, x86_64".to_owned(),
        built_with: "Rust 1.95, wgpu 30, egui 0.37".to_owned(),
        components: include_str!("../../../../../assets/licences/components.txt"),
    }
}

pub fn check_name(name: &str) -> Result<(), String> {
    if name.is_empty() {
        return Err("Give the world a name.".to_owned());
    }
    if name.chars().count() > 40 {
        return Err("At most 40 characters.".to_owned());
    }
    if name.eq_ignore_ascii_case("taken") {
        return Err("There is a world of that name already.".to_owned());
    }
    Ok(())
}

pub fn harness(game: Game, size: Vec2) -> Harness<'static, Game> {
    Harness::builder()
        .with_size(size)
        .with_max_steps(8)
        .allow_missing_glyphs()
        .with_context_setup(apply_theme)
        .build_ui_state(|ui, game: &mut Game| game.show(ui.ctx()), game)
}

pub fn window(game: Game) -> Harness<'static, Game> {
    harness(game, vec2(1280.0, 720.0))
}

/// Clicks the one widget of that name and lets the menu settle.
pub fn click(harness: &mut Harness<'_, Game>, label: &str) {
    harness.get_by_label(label).click();
    harness.run();
}

pub fn press(harness: &mut Harness<'_, Game>, key: Key) {
    harness.key_press(key);
    harness.run();
}

pub fn type_text(harness: &mut Harness<'_, Game>, text: &str) {
    harness.event(egui::Event::Text(text.to_owned()));
    harness.run();
}

/// The accessible name of what has the focus; empty when nothing has.
pub fn focused(harness: &Harness<'_, Game>) -> String {
    use egui_kittest::kittest::NodeT as _;
    harness
        .root()
        .children_recursive()
        .map(|node| node.accesskit_node())
        .find(|node| node.is_focused() && node.role() != egui::Role::Window)
        .and_then(|node| node.label())
        .unwrap_or_default()
}

/// Intents since the last call, but for closer looks at worlds, which change nothing.
pub fn decisions(harness: &mut Harness<'_, Game>) -> Vec<Intent> {
    let looks = |intent: &Intent| matches!(intent, Intent::Worlds(WorldsIntent::LookAt { .. }));
    let mut intents = intents(harness);
    intents.retain(|intent| !looks(intent));
    intents
}

/// Intents since the last call.
pub fn intents(harness: &mut Harness<'_, Game>) -> Vec<Intent> {
    std::mem::take(&mut harness.state_mut().intents)
}

pub fn world(index: usize) -> WorldRow {
    WorldRow {
        slug: format!("world-{index}"),
        name: format!("World {index}"),
        full_name: format!("World {index}"),
        geometry: "Spherical".to_owned(),
        mode: if index == 1 { "Gathering" } else { "" }.to_owned(),
        played: "12 min".to_owned(),
        last_played: "2026-01-31".to_owned(),
        size: "1.2 MB".to_owned(),
        cheated: false,
        problem: None,
        running: false,
        picture: None,
        path: format!("/home/me/saves/world-{index}"),
        edits: None,
        export_to: format!("/home/me/world-{index}.antipode-world"),
        ..WorldRow::default()
    }
}

pub fn room(index: usize, shipped: bool) -> WorldRow {
    let origin = if shipped { "game:" } else { "" };
    WorldRow {
        slug: format!("{origin}room-{index}"),
        name: format!("Room {index}"),
        full_name: format!("Room {index}"),
        sentence: "This tunnel is longer than the house that it leads through.".to_owned(),
        shipped,
        path: format!("/home/me/rooms/room-{index}"),
        edits: Some(12),
        export_to: format!("/home/me/room-{index}.antipode-room"),
        ..WorldRow::default()
    }
}

/// A text on the screen: what it covers, what it is clipped to, what it says,
/// and whether it was ended by an ellipsis.
pub struct Painted {
    pub rect: Rect,
    pub clip: Rect,
    pub text: String,
    pub elided: bool,
}

pub fn painted(output: &egui::FullOutput) -> Vec<Painted> {
    fn gather(shape: &Shape, clip: Rect, into: &mut Vec<Painted>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, clip, into)),
            Shape::Text(text) => into.push(Painted {
                rect: text.galley.rect.translate(text.pos.to_vec2()),
                clip,
                text: text.galley.text().to_owned(),
                elided: text.galley.elided,
            }),
            _ => {}
        }
    }
    let mut all = Vec::new();
    for clipped in &output.shapes {
        gather(&clipped.shape, clipped.clip_rect, &mut all);
    }
    all
}
