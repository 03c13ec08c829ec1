//! The state of the menus: the screen that is up, where Esc leads, and which control gets the focus.

use std::cell::Cell;

use antipode_settings::Input;
use egui::{Context, Event, Id, Key, LayerId, Rect, Ui, UiBuilder};

use crate::controls::ControlsScreen;
use crate::layout::Regions;
use crate::model::{Intent, MenuModel, Screen, ToastKind};
use crate::new_game::NewGameForm;
use crate::settings::SettingsScreen;
use crate::theme::SCRIM;
use crate::toasts::{Room, Toasts};
use crate::trail::Trail;
use crate::worlds::{Kind, WorldScreens};
use crate::{about, backdrop, column, dialog, trail};

/// What the main menu is called on the way to other screens.
const MAIN: &str = "antipode-main-menu";

/// The menus. It starts on the main menu.
///
/// The game forwards Esc to [`Shell::escape`] itself, since Esc must work
/// while no menu is up, and takes no input for the world while
/// [`Shell::is_open`].
pub struct Shell {
    screen: Screen,
    /// Where a message leads back to: the last screen that was neither work in
    /// progress nor a message.
    behind: Screen,
    form: NewGameForm,
    /// What is up on the screens about worlds.
    worlds: WorldScreens,
    settings: SettingsScreen,
    controls: ControlsScreen,
    toasts: Toasts,
    /// What lies on the world while no menu does.
    covered: Option<Rect>,
    /// What the display shows at the right of the world, below the room for toasts.
    instruments: Rect,
    /// Where the world is seen, if that is not the whole of the window.
    tile: Option<Rect>,
    /// How the player came to what is up.
    trail: Trail,
    /// What was left takes the focus, or else the next widget that is first on its screen.
    focus_first: bool,
    /// Whether the player last used keys rather than the pointer.
    by_keyboard: bool,
    /// What Esc asked for since the last frame.
    queued: Vec<Intent>,
    changed: bool,
}

/// What the screens read and write while one frame is drawn.
pub(crate) struct Pass<'a> {
    pub model: &'a MenuModel<'a>,
    pub regions: Regions,
    pub intents: Vec<Intent>,
    /// The screen to go to when the frame is over.
    pub go: Option<Screen>,
    /// What a dialog covers, which nothing else may lie on.
    pub dialog: Cell<Option<Rect>>,
    focus_first: bool,
}

impl Pass<'_> {
    /// Gives the focus to this widget if its screen has just been opened.
    pub(crate) fn offer_focus(&mut self, response: &egui::Response) {
        if std::mem::take(&mut self.focus_first) {
            response.request_focus();
        }
    }
}

impl Default for Shell {
    fn default() -> Self {
        Self::new()
    }
}

impl Shell {
    /// The main menu, with the focus on its first button.
    pub fn new() -> Self {
        Self {
            screen: Screen::Main,
            behind: Screen::Main,
            form: NewGameForm::default(),
            worlds: WorldScreens::default(),
            settings: SettingsScreen::default(),
            controls: ControlsScreen::default(),
            toasts: Toasts::default(),
            covered: None,
            instruments: Rect::NOTHING,
            tile: None,
            trail: Trail::new(Id::unique(MAIN)),
            focus_first: true,
            by_keyboard: true,
            queued: Vec::new(),
            changed: true,
        }
    }

    /// The screen that is up.
    pub fn screen(&self) -> &Screen {
        &self.screen
    }

    /// Whether any screen is up: the world is paused and takes no input.
    pub fn is_open(&self) -> bool {
        self.screen != Screen::Hidden
    }

    /// Shows a screen. May be called every frame to move a progress bar on.
    pub fn open(&mut self, screen: Screen) {
        self.changed |= self.screen != screen;
        let both_busy = matches!(
            (&self.screen, &screen),
            (Screen::Busy { .. }, Screen::Busy { .. })
        );
        if self.screen == screen || both_busy {
            self.screen = screen;
            return;
        }
        if screen == Screen::NewGame {
            self.form = NewGameForm::default();
        }
        self.switch(screen);
        self.focus_first = true;
    }

    /// Esc: one level back; out of the pause menu into the world if one is
    /// `running`; from the world into the pause menu. Work in progress stays.
    pub fn escape(&mut self, running: bool) {
        self.by_keyboard = true;
        let back = match self.screen {
            Screen::Settings => self.settings.back(),
            Screen::Controls => self.controls.back(),
            _ => self.worlds.back(),
        };
        if back {
            self.focus_first = true;
            return;
        }
        match self.screen {
            Screen::Busy { .. } => {}
            Screen::Message { .. } | Screen::Unsaved { .. } => {
                self.queued.push(Intent::DismissMessage);
                self.dismiss(running);
            }
            Screen::Main if running => self.switch(Screen::Hidden),
            Screen::Main => self.focus_first = true,
            Screen::Hidden
            | Screen::NewGame
            | Screen::Load
            | Screen::Delete
            | Screen::Rooms
            | Screen::Workshop
            | Screen::Settings
            | Screen::Controls
            | Screen::About => {
                self.switch(Screen::Main);
                self.focus_first = true;
            }
        }
    }

    /// Whether the player has been asked to press something for an action: the next key, button or notch goes to
    /// [`Shell::take_input`] and nowhere else. Esc goes to [`Shell::escape`] as ever, and cancels.
    pub fn wants_input(&self) -> bool {
        self.screen == Screen::Controls && self.controls.is_waiting()
    }

    /// Takes what the player has pressed for an action.
    pub fn take_input(&mut self, input: Input) {
        self.by_keyboard = true;
        self.controls.take(input);
    }

    /// Whether there has been something new to draw since the last question, but for what the player does in it.
    pub fn take_changed(&mut self) -> bool {
        std::mem::take(&mut self.changed)
    }

    /// Puts a line up for some seconds, over whatever is on the screen.
    pub fn toast(&mut self, text: impl Into<String>, kind: ToastKind) {
        self.changed = true;
        self.toasts.push(text.into(), kind);
    }

    /// Keeps such lines off something that lies on the world while no menu does, in points; `None` for nothing.
    pub fn keep_toasts_off(&mut self, covered: Option<Rect>) {
        self.covered = covered;
    }

    /// Keeps such lines within the part of the window in which the world is seen, in points; `None` for all of it.
    pub fn keep_toasts_within(&mut self, tile: Option<Rect>) {
        self.tile = tile;
    }

    /// Keeps such lines above what the display shows there, in points; what is nowhere is in nobody's way.
    pub fn keep_toasts_above(&mut self, shown: Rect) {
        self.instruments = shown;
    }

    /// Draws what is up and returns what the player asked for, in order.
    pub fn show(&mut self, ctx: &Context, model: &MenuModel<'_>) -> Vec<Intent> {
        let mut intents = std::mem::take(&mut self.queued);
        let screen = ctx.content_rect();
        let room = if self.is_open() {
            let (mut asked, room) = self.show_open(ctx, model);
            intents.append(&mut asked);
            room
        } else if let Some(tile) = self.tile {
            Room::in_tile(tile)
        } else if let Some(covered) = self.covered {
            Room::beside(screen, covered)
        } else {
            Room::in_world(screen, self.instruments)
        };
        self.toasts.show(ctx, room);
        intents
    }

    /// Where things stand, and where toasts do: where nothing is, else in a strip that the screen leaves to them.
    fn make_room(&mut self, ctx: &Context) -> (Regions, Room) {
        let regions = Regions::of(ctx);
        if regions.wide && self.screen == Screen::Main {
            return (regions, Room::in_world(regions.whole, Rect::NOTHING));
        }
        if let Some(room) = Room::right_of(regions.whole, regions.pane.max.x) {
            return (regions, room);
        }
        let height = self.toasts.strip(ctx, regions.pane.width());
        let (regions, rect) = regions.without_strip(height);
        (regions, Room { rect, waits: false })
    }

    /// The intents, and where toasts may be.
    fn show_open(&mut self, ctx: &Context, model: &MenuModel<'_>) -> (Vec<Intent>, Room) {
        self.read_input(ctx);
        let place = self.place();
        self.trail.arrive(place, Id::unique(MAIN), self.is_screen());
        let returned = self.focus_first && self.trail.return_focus(ctx);
        let (regions, room) = self.make_room(ctx);
        let mut pass = Pass {
            model,
            regions,
            intents: Vec::new(),
            go: None,
            dialog: Cell::new(None),
            focus_first: std::mem::take(&mut self.focus_first) && !returned,
        };
        let builder = UiBuilder::new()
            .layer_id(LayerId::background())
            .max_rect(pass.regions.whole);
        let mut ui = Ui::new(ctx.clone(), Id::unique("antipode-menu"), builder);
        if pass.regions.compact {
            ui.spacing_mut().item_spacing.y = 4.0;
        }
        if model.running_world.is_some() {
            ui.painter().rect_filled(pass.regions.whole, 0, SCRIM);
        } else {
            backdrop::show(ui.painter(), pass.regions.whole, model.backdrop);
        }
        self.draw(&mut ui, &mut pass);
        // What was asked about may have gone, and the question with it; or the button that was pressed.
        let gone = self.place() != place || !trail::is_focus_drawn(ctx);
        self.focus_first |= self.by_keyboard && gone;
        if returned && !self.trail.is_returned(ctx) {
            // What was left is gone.
            self.focus_first = true;
        }
        if self.focus_first {
            ctx.request_repaint();
        }
        self.trail.note(ctx);
        let dialog = pass.dialog.get();
        let above = dialog.map(|dialog| Room::above(regions.whole, dialog));
        (self.finish(pass), above.unwrap_or(room))
    }

    /// What is up, as a name that it bears every time.
    fn place(&self) -> Id {
        if self.screen == Screen::Main {
            return Id::unique(MAIN);
        }
        let screen = std::mem::discriminant(&self.screen);
        Id::unique((screen, self.worlds.place(), self.controls.place()))
    }

    /// Whether it is one of the screens that the main menu leads to, and no part of one.
    fn is_screen(&self) -> bool {
        let whole = self.worlds.place().is_none() && self.controls.place().is_none();
        whole
            && matches!(
                self.screen,
                Screen::NewGame
                    | Screen::Load
                    | Screen::Delete
                    | Screen::Rooms
                    | Screen::Workshop
                    | Screen::Settings
                    | Screen::Controls
                    | Screen::About
            )
    }

    fn draw(&mut self, ui: &mut Ui, pass: &mut Pass<'_>) {
        if let Some(answered) = self.worlds.ask(ui, pass) {
            self.focus_first |= answered && self.by_keyboard;
            return;
        }
        match &self.screen {
            Screen::Busy {
                title,
                progress,
                detail,
            } => {
                return dialog::busy(ui, pass, title, *progress, detail);
            }
            Screen::Message { title, text } => {
                return dialog::message(ui, pass, title, text);
            }
            Screen::Unsaved { text } => return dialog::unsaved(ui, pass, text),
            _ => {}
        }
        if pass.regions.wide || self.screen == Screen::Main {
            column::show(ui, pass, &self.screen);
        }
        let turned = match &self.screen {
            Screen::Load | Screen::Rooms | Screen::Workshop => self.worlds.load(ui, pass),
            Screen::Delete => self.worlds.delete(ui, pass),
            Screen::Controls => self.controls.show(ui, pass),
            Screen::NewGame => {
                self.form.show(ui, pass);
                false
            }
            Screen::Settings => {
                self.settings.show(ui, pass);
                false
            }
            Screen::About => {
                about::show(ui, pass);
                false
            }
            _ => false,
        };
        // Something else is up on the same screen from the next frame on.
        self.focus_first |= turned;
    }

    /// Carries out what the screens asked for. Screens change between frames
    /// only, so that one key press is never seen by two of them.
    fn finish(&mut self, pass: Pass<'_>) -> Vec<Intent> {
        let running = pass.model.running_world.is_some();
        if pass.intents.contains(&Intent::DismissMessage) {
            self.dismiss(running);
        } else if pass.intents.contains(&Intent::Resume) {
            self.switch(Screen::Hidden);
        } else if let Some(screen) = pass.go {
            self.open(screen);
            let is_answered = matches!(self.screen, Screen::NewGame | Screen::Message { .. });
            self.focus_first = self.by_keyboard || is_answered;
        } else if pass.focus_first {
            // Nobody took it: whatever comes up next on this screen may.
            self.focus_first = true;
        }
        pass.intents
    }

    fn switch(&mut self, screen: Screen) {
        let passing = matches!(
            self.screen,
            Screen::Busy { .. } | Screen::Message { .. } | Screen::Unsaved { .. }
        );
        if !passing {
            self.behind = self.screen.clone();
        }
        if screen == Screen::Hidden {
            self.trail = Trail::new(Id::unique(MAIN));
        }
        if matches!(self.screen, Screen::Main | Screen::Hidden) {
            self.worlds.come();
        }
        self.worlds.reset(Kind::of(&screen));
        self.settings = SettingsScreen::default();
        self.controls.reset();
        self.screen = screen;
    }

    fn dismiss(&mut self, running: bool) {
        let back = match std::mem::replace(&mut self.behind, Screen::Main) {
            Screen::Hidden if !running => Screen::Main,
            screen => screen,
        };
        self.switch(back);
        self.focus_first = true;
    }

    /// Notes whether keys or the pointer are in use, and drops repeats of the
    /// keys that press buttons: a key held down must not run through screens.
    fn read_input(&mut self, ctx: &Context) {
        let mut arrow = false;
        ctx.input_mut(|input| {
            for event in &input.events {
                match event {
                    Event::Key {
                        key, pressed: true, ..
                    } => {
                        self.by_keyboard = true;
                        arrow |= matches!(
                            key,
                            Key::ArrowUp | Key::ArrowDown | Key::ArrowLeft | Key::ArrowRight
                        );
                    }
                    Event::PointerButton { .. } => self.by_keyboard = false,
                    _ => {}
                }
            }
            input.events.retain(|event| {
                !matches!(
                    event,
                    Event::Key {
                        key: Key::Enter | Key::Space,
                        pressed: true,
                        repeat: true,
                        ..
                    }
                )
            });
        });
        // egui moves the focus by arrows only once something has it.
        if arrow && ctx.memory(egui::Memory::focused).is_none() {
            self.focus_first = true;
        }
    }
}
