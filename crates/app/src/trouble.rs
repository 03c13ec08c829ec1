//! Why the graphics failed for good, as a game that ends tells the one that it starts.

use std::convert::Infallible;
use std::fmt;
use std::str::FromStr;

use antipode_render::RenderError;

/// A failure of the graphics that another start can do without: the processor draws then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// The adapter was lost, and none could be opened again.
    Lost,
    /// The adapter refuses a shader, in its words.
    Shader(String),
    /// Something else, as a sentence.
    Other(String),
}

impl Trouble {
    /// What a failure comes to; `None` where no other start would do better: nothing here can draw, or what was asked
    /// for cannot be drawn.
    pub fn of(error: &RenderError) -> Option<Self> {
        match error {
            RenderError::Lost(_) => Some(Self::Lost),
            RenderError::Shader(words) => Some(Self::Shader(words.clone())),
            RenderError::NoDevice { .. } | RenderError::NoSurface(_) => {
                Some(Self::Other(error.to_string()))
            }
            RenderError::NoAdapter { .. }
            | RenderError::Readback(_)
            | RenderError::Model(_)
            | RenderError::Options(_) => None,
        }
    }
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lost => f.write_str("lost"),
            Self::Shader(words) => write!(f, "shader:{words}"),
            Self::Other(words) => write!(f, "other:{words}"),
        }
    }
}

impl FromStr for Trouble {
    type Err = Infallible;

    /// Reads what [`fmt::Display`] wrote; anything else is some other trouble in these words.
    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(match text.split_once(':') {
            _ if text == "lost" => Self::Lost,
            Some(("shader", words)) => Self::Shader(words.to_owned()),
            Some(("other", words)) => Self::Other(words.to_owned()),
            _ => Self::Other(text.to_owned()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_one_process_writes_the_next_one_reads() {
        for trouble in [
            Trouble::Lost,
            Trouble::Shader("a type: unknown".to_owned()),
            Trouble::Other("It is gone: really.".to_owned()),
        ] {
            assert_eq!(trouble.to_string().parse(), Ok(trouble));
        }
    }
}
