//! How the panes lie, and that as a text which the settings keep: `row(0.25 tabs(list* parts) 0.75 view)`. A star follows the
//! tab that is up.

use std::fmt::Write as _;
use std::iter::Peekable;
use std::str::Chars;

use egui::Id;
use egui_tiles::{Container, Linear, LinearDir, Tabs, Tile, TileId, Tiles, Tree};

/// A pane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Pane {
    View,
    List,
    Inspector,
    Parts,
    Messages,
    History,
}

/// Deepest that tiles of a kept layout lie in each other.
const DEEPEST: u32 = 8;
/// Where the panes lie in a wide window, and in a narrow one.
const WIDE: &str = "row(0.21 col(0.6 tabs(list*) 0.4 tabs(parts* history)) 0.54 col(0.82 tabs(view*) 0.18 tabs(messages*)) 0.25 tabs(inspector*))";
const NARROW: &str =
    "row(0.62 tabs(view*) 0.38 col(0.42 tabs(list* parts history) 0.58 tabs(inspector* messages)))";
/// From this width on a window is wide, points.
const WIDE_FROM: f32 = 1100.0;

impl Pane {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::View,
        Self::List,
        Self::Inspector,
        Self::Parts,
        Self::Messages,
        Self::History,
    ];

    /// What it is called in the settings.
    pub fn id(self) -> &'static str {
        match self {
            Self::View => "view",
            Self::List => "list",
            Self::Inspector => "inspector",
            Self::Parts => "parts",
            Self::Messages => "messages",
            Self::History => "history",
        }
    }
}

/// The panes as a text has them; as they are at first in a window of that width where it says nothing that can be used.
pub(super) fn tree(text: &str, width: f32) -> Tree<Pane> {
    read(text)
        .or_else(|| read(usual(width)))
        .unwrap_or_else(|| Tree::new_tabs(root_id(), Pane::ALL.to_vec()))
}

/// How panes lie at first.
pub(super) fn usual(width: f32) -> &'static str {
    if width >= WIDE_FROM { WIDE } else { NARROW }
}

fn root_id() -> Id {
    Id::unique("antipode-workshop-tiles")
}

/// The panes as a text.
pub(super) fn text(tree: &Tree<Pane>) -> String {
    let mut out = String::new();
    if let Some(root) = tree.root() {
        put(&tree.tiles, root, &mut out);
    }
    out
}

fn put(tiles: &Tiles<Pane>, id: TileId, out: &mut String) {
    match tiles.get(id) {
        Some(Tile::Pane(pane)) => out.push_str(pane.id()),
        Some(Tile::Container(Container::Tabs(tabs))) => {
            out.push_str("tabs(");
            for (place, child) in tabs.children.iter().enumerate() {
                if place > 0 {
                    out.push(' ');
                }
                put(tiles, *child, out);
                if tabs.active == Some(*child) {
                    out.push('*');
                }
            }
            out.push(')');
        }
        Some(Tile::Container(Container::Linear(linear))) => {
            out.push_str(match linear.dir {
                LinearDir::Horizontal => "row(",
                LinearDir::Vertical => "col(",
            });
            let sum: f32 = linear.children.iter().map(|it| linear.shares[*it]).sum();
            for (place, child) in linear.children.iter().enumerate() {
                if place > 0 {
                    out.push(' ');
                }
                let share = linear.shares[*child] / sum.max(1e-6);
                // Writing into a text does not fail.
                let _ = write!(out, "{share:.3} ");
                put(tiles, *child, out);
            }
            out.push(')');
        }
        Some(Tile::Container(Container::Grid(grid))) => {
            out.push_str("tabs(");
            let children: Vec<_> = grid.children().copied().collect();
            for child in children {
                put(tiles, child, out);
                out.push(' ');
            }
            out.push(')');
        }
        None => {}
    }
}

/// None where the text is of nothing, or leaves a pane out or has one twice.
fn read(text: &str) -> Option<Tree<Pane>> {
    let mut tiles = Tiles::default();
    let mut found = Vec::new();
    let mut reader = Reader {
        letters: text.chars().peekable(),
        tiles: &mut tiles,
        found: &mut found,
    };
    let root = reader.tile(0)?;
    found.sort_unstable();
    let mut all = Pane::ALL.to_vec();
    all.sort_unstable();
    (found == all).then(|| Tree::new(root_id(), root, tiles))
}

struct Reader<'a> {
    letters: Peekable<Chars<'a>>,
    tiles: &'a mut Tiles<Pane>,
    found: &'a mut Vec<Pane>,
}

impl Reader<'_> {
    fn word(&mut self) -> String {
        while self.letters.next_if(|c| c.is_whitespace()).is_some() {}
        let mut word = String::new();
        while let Some(c) = self.letters.next_if(|c| c.is_alphanumeric() || *c == '.') {
            word.push(c);
        }
        word
    }

    fn is_next(&mut self, mark: char) -> bool {
        while self.letters.next_if(|c| c.is_whitespace()).is_some() {}
        self.letters.next_if_eq(&mark).is_some()
    }

    fn tile(&mut self, depth: u32) -> Option<TileId> {
        if depth > DEEPEST {
            return None;
        }
        match self.word().as_str() {
            "tabs" => self.tabs(depth),
            "row" => self.linear(LinearDir::Horizontal, depth),
            "col" => self.linear(LinearDir::Vertical, depth),
            word => {
                let pane = Pane::ALL.into_iter().find(|it| it.id() == word)?;
                self.found.push(pane);
                Some(self.tiles.insert_pane(pane))
            }
        }
    }

    fn tabs(&mut self, depth: u32) -> Option<TileId> {
        let (mut children, mut active) = (Vec::new(), None);
        if !self.is_next('(') {
            return None;
        }
        while !self.is_next(')') {
            let child = self.tile(depth + 1)?;
            children.push(child);
            if self.is_next('*') {
                active = Some(child);
            }
        }
        let mut tabs = Tabs::new(children);
        if let Some(active) = active {
            tabs.set_active(active);
        }
        Some(self.tiles.insert_container(Container::Tabs(tabs)))
    }

    fn linear(&mut self, dir: LinearDir, depth: u32) -> Option<TileId> {
        let mut children = Vec::new();
        if !self.is_next('(') {
            return None;
        }
        while !self.is_next(')') {
            let share: f32 = self.word().parse().ok()?;
            let child = self.tile(depth + 1)?;
            children.push((child, share.clamp(0.02, 1.0)));
        }
        let mut linear = Linear::new(dir, children.iter().map(|(child, _)| *child).collect());
        for (child, share) in &children {
            linear.shares.set_share(*child, *share);
        }
        Some(self.tiles.insert_container(Container::Linear(linear)))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    fn a_layout_comes_back_as_it_was_left() {
        for usual in [WIDE, NARROW] {
            let once = text(&read(usual).unwrap());
            assert_eq!(text(&read(&once).unwrap()), once);
            assert!(once.contains("tabs(list*"), "{once}");
        }
    }

    #[test]
    fn a_layout_that_lacks_a_pane_or_has_it_twice_or_is_none_is_not_taken() {
        let deep = "tabs(".repeat(100);
        for wrong in [
            "",
            "view",
            "tabs(view list inspector parts messages)",
            "tabs(view view list inspector parts messages history)",
            "row(x view)",
            "row(0.5 view",
            &deep,
        ] {
            assert!(read(wrong).is_none(), "{wrong}");
            assert_eq!(text(&tree(wrong, 2000.0)), text(&read(WIDE).unwrap()));
        }
    }
}
