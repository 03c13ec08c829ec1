//! The named qualities of pictures: how exact they are.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// How much exactness a picture trades for speed: each is a measured point between the two.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quality {
    /// Errors and land too small to notice in motion are let pass.
    Fast,
    /// Nothing is off, and nothing missing, by half a pixel or more; but for the levels of detail
    /// of land over six chunks away, which are as coarse as the budget of triangles takes.
    #[default]
    Balanced,
    /// Everything is drawn, each vertex by the full formulas.
    Exact,
}

impl Quality {
    /// All three, the quickest first.
    pub const ALL: [Self; 3] = [Self::Fast, Self::Balanced, Self::Exact];

    /// The lower-case name, as on the command line and in scripts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Balanced => "balanced",
            Self::Exact => "exact",
        }
    }
}

impl fmt::Display for Quality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// A word that names no quality.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("\"{0}\" is not a quality; choose fast, balanced or exact")]
pub struct ParseQualityError(String);

impl FromStr for Quality {
    type Err = ParseQualityError;

    /// Reads a lower-case name.
    ///
    /// # Errors
    /// [`ParseQualityError`] for any other word.
    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|quality| quality.name() == name)
            .ok_or_else(|| ParseQualityError(name.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn qualities_read_back_and_others_are_refused() {
        for quality in Quality::ALL {
            assert_eq!(quality.to_string().parse(), Ok(quality));
        }
        let refused = "Best".parse::<Quality>().map_err(|e| e.to_string());
        assert!(refused.is_err_and(|said| said.contains("\"Best\"")));
    }
}
