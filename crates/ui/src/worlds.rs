//! The screens about saved worlds and rooms: the list, the page of one, what is asked before one is deleted, and those that
//! are brought in from files.

mod field;
mod import;
mod kind;
mod list;
mod model;
mod page;
mod picture;
mod question;

use egui::{Id, Ui};

use crate::model::{Intent, MenuModel, Screen, WorldRow};
use crate::shell::Pass;
use list::Choice;
use page::Page;

pub(crate) use kind::Kind;
pub use model::{ArchiveRow, FolderRow, WorldFiles, WorldsIntent};

/// What is up on the screens about worlds, beside which screen it is.
#[derive(Default)]
pub(crate) struct WorldScreens {
    /// What they are about.
    kind: Kind,
    /// The page of one world, on the screen Load.
    page: Option<Page>,
    /// The form for a world from a file, on the screen Load.
    import: Option<import::Form>,
    /// The directory of the world whose deletion is being asked about.
    doomed: Option<String>,
    /// How often one has come to them: a list is at its top then.
    visits: u32,
}

impl WorldScreens {
    /// What is up beside the plain lists, as a name that it bears every time.
    pub(crate) fn place(&self) -> Option<Id> {
        let page = self.page.as_ref().map(Page::place);
        let place = (page, self.import.is_some(), self.doomed.as_deref());
        (place != (None, false, None)).then(|| Id::unique(place))
    }

    /// The player comes to them from elsewhere: lists are at their top.
    pub(crate) fn come(&mut self) {
        self.visits = self.visits.wrapping_add(1);
    }

    /// Back to the plain lists, of that kind.
    pub(crate) fn reset(&mut self, kind: Kind) {
        *self = Self {
            kind,
            visits: self.visits,
            ..Self::default()
        };
    }

    /// Esc: one level back within these screens; false if there is none.
    pub(crate) fn back(&mut self) -> bool {
        self.doomed.take().is_some()
            || self.page.as_mut().is_some_and(Page::back)
            || self.page.take().is_some()
            || self.import.take().is_some()
    }

    /// Draws the question before a world is deleted, and says whether it was answered;
    /// `None` if nothing is being asked.
    pub(crate) fn ask(&mut self, ui: &mut Ui, pass: &mut Pass<'_>) -> Option<bool> {
        let slug = self.doomed.clone()?;
        // Deleted elsewhere meanwhile: nothing is left to ask.
        let Some(row) = find(self.kind, pass.model, &slug) else {
            self.doomed = None;
            return None;
        };
        let Some(sure) = question::show(ui, pass, self.kind, row) else {
            return Some(false);
        };
        self.doomed = None;
        if sure {
            pass.intents.push(self.kind.delete(slug));
            self.page = None;
        }
        Some(true)
    }

    /// Draws the screen Load, or that of rooms. True if something else is up from the next frame on.
    pub(crate) fn load(&mut self, ui: &mut Ui, pass: &mut Pass<'_>) -> bool {
        let kind = self.kind;
        import::take_dropped(ui, pass, kind);
        let row = self
            .page
            .as_ref()
            .and_then(|page| find(kind, pass.model, page.slug()));
        if let (Some(page), Some(row)) = (&mut self.page, row) {
            return match page.show(ui, pass, kind, row) {
                page::Turn::Stay => false,
                page::Turn::Redraw => true,
                page::Turn::Delete => {
                    self.doomed = Some(row.slug.clone());
                    true
                }
                page::Turn::Back => {
                    self.page = None;
                    true
                }
            };
        }
        self.page = None;
        if let Some(form) = &mut self.import {
            let done = form.show(ui, pass, kind);
            if done {
                self.import = None;
            }
            return done;
        }
        let list = |ui: &mut Ui| list::show(ui, pass, kind, list::Purpose::Load);
        match ui.push_id(self.visits, list).inner {
            Some(Choice::Row(row)) => {
                enter(pass, kind, row);
                false
            }
            Some(Choice::Manage(row)) => {
                self.page = Some(Page::new(&row.slug));
                look_at(pass, kind, &row.slug);
                true
            }
            Some(Choice::Import) => {
                self.import = Some(import::Form::default());
                pass.intents.push(kind.ask(WorldsIntent::FindArchives));
                true
            }
            Some(Choice::New) => {
                pass.intents.push(match kind {
                    Kind::Own => Intent::BuildNewRoom,
                    _ => Intent::NewRoom,
                });
                false
            }
            None => false,
        }
    }

    /// Draws the screen Delete. True if something else is up from the next frame on.
    pub(crate) fn delete(&mut self, ui: &mut Ui, pass: &mut Pass<'_>) -> bool {
        let chosen = list::show(ui, pass, self.kind, list::Purpose::Delete);
        let Some(Choice::Row(row)) = chosen else {
            return false;
        };
        if row.running {
            let values = [("name", row.name.as_str().into())];
            let texts = pass.model.texts;
            pass.go = Some(Screen::Message {
                title: texts.say_with("worlds-cannot-delete-title", &values),
                text: texts.say("worlds-running-no-delete"),
            });
            return false;
        }
        self.doomed = Some(row.slug.clone());
        look_at(pass, self.kind, &row.slug);
        true
    }
}

/// Goes into a place, or says why that cannot be.
fn enter(pass: &mut Pass<'_>, kind: Kind, row: &WorldRow) {
    if row.running {
        pass.intents.push(Intent::Resume);
    } else if let Some(problem) = &row.problem {
        let values = [("name", row.name.as_str().into())];
        pass.go = Some(Screen::Message {
            title: pass
                .model
                .texts
                .say_with("worlds-cannot-load-title", &values),
            text: problem.clone(),
        });
    } else {
        pass.intents.push(kind.enter(row.slug.clone()));
    }
}

/// Asks for what only opening a world tells.
fn look_at(pass: &mut Pass<'_>, kind: Kind, slug: &str) {
    pass.intents.push(kind.ask(WorldsIntent::LookAt {
        slug: slug.to_owned(),
    }));
}

fn find<'a>(kind: Kind, model: &MenuModel<'a>, slug: &str) -> Option<&'a WorldRow> {
    kind.rows(model).iter().find(|row| row.slug == slug)
}

/// The facts of a place in one line, those that are known.
fn facts(pass: &Pass<'_>, row: &WorldRow) -> String {
    let played = [("time", row.played.as_str().into())];
    let facts = [
        row.sentence.clone(),
        row.geometry.clone(),
        row.mode.clone(),
        if row.played.is_empty() {
            String::new()
        } else {
            pass.model.texts.say_with("worlds-played", &played)
        },
        row.last_played.clone(),
        row.size.clone(),
        if row.cheated {
            pass.model.texts.say("cheats-used")
        } else {
            String::new()
        },
    ];
    let known: Vec<_> = facts.into_iter().filter(|fact| !fact.is_empty()).collect();
    known.join("  ·  ")
}

/// How much of a world was changed by hand; of a room, how much is in it.
fn edits(pass: &Pass<'_>, kind: Kind, row: &WorldRow) -> String {
    let texts = pass.model.texts;
    if kind != Kind::World {
        return texts.say_with("rooms-objects", &[("count", row.edits.unwrap_or(0).into())]);
    }
    match row.edits {
        Some(count) => texts.say_with("worlds-edits", &[("count", count.into())]),
        None => texts.say("worlds-edits-unknown"),
    }
}
