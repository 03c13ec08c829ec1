//! Errors of the graphics adapter, as sentences for the player.

use thiserror::Error;

/// A failure of the graphics adapter, or a request it cannot meet.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RenderError {
    /// There is no adapter of the kind asked for.
    #[error("No {wanted} was found on this machine ({found}). {advice}")]
    NoAdapter {
        /// The kind asked for, as a noun.
        wanted: &'static str,
        /// What there is instead.
        found: String,
        /// What the player can do.
        advice: &'static str,
    },
    /// The adapter is there but will not open.
    #[error(
        "The graphics adapter {adapter} could not be opened: {why}. Update its driver, or start with --adapter software."
    )]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The driver's words.
        why: String,
    },
    /// The window system gives no surface to draw on.
    #[error(
        "The window cannot be drawn into: {0}. Check that the display's graphics driver is installed."
    )]
    NoSurface(String),
    /// The adapter was lost or stopped answering.
    #[error("The graphics adapter was lost: {0}. Your world is safe; start the game again.")]
    Lost(String),
    /// A picture could not be read back.
    #[error(
        "A picture could not be read back from the graphics adapter: {0}. Try again, or use a smaller size."
    )]
    Readback(String),
    /// The adapter will not take one of the shaders.
    #[error(
        "The graphics adapter refuses a shader of the game ({0}). Update its driver, or start with --adapter software."
    )]
    Shader(String),
    /// A model of the game cannot be read.
    #[error("A model of the game is damaged ({0}). Install the game again.")]
    Model(String),
    /// The options are outside what can be drawn.
    #[error("The renderer cannot be set up: {0}.")]
    Options(String),
}

/// A sentence has at most so many characters of a compiler's words. The log has all of them.
const LONGEST_REASON: usize = 160;

impl RenderError {
    /// The adapter will not take a shader: what its compiler says, in one short line.
    pub(crate) fn shader(said: &str) -> Self {
        // The lines that a compiler draws round the text are no words, and no font of the game has them.
        let drawn = |c: char| ('\u{2500}'..='\u{257f}').contains(&c);
        let words: Vec<_> = said
            .split(|c: char| c.is_whitespace() || drawn(c))
            .filter(|word| !word.is_empty())
            .collect();
        let words = words.join(" ");
        let end = words.char_indices().nth(LONGEST_REASON).map(|(end, _)| end);
        Self::Shader(end.map_or_else(|| words.clone(), |end| format!("{}…", &words[..end])))
    }
}
