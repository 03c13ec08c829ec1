//! Colours as they stand in a file: `"#rrggbb"`, in sRGB.

use serde::{Deserialize, Deserializer, de};

/// A colour in sRGB, a byte each for red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour(pub [u8; 3]);

impl Colour {
    /// White.
    pub const WHITE: Self = Self([0xff; 3]);

    /// Reads `#rrggbb`; nothing for anything else.
    pub fn parse(text: &str) -> Option<Self> {
        let digits = text.strip_prefix('#')?;
        if digits.len() != 6 || !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
            return None;
        }
        let number = u32::from_str_radix(digits, 16).ok()?;
        let [_, red, green, blue] = number.to_be_bytes();
        Some(Self([red, green, blue]))
    }
}

impl std::fmt::Display for Colour {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [red, green, blue] = self.0;
        write!(out, "#{red:02x}{green:02x}{blue:02x}")
    }
}

impl<'de> Deserialize<'de> for Colour {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        let text = String::deserialize(source)?;
        Self::parse(&text).ok_or_else(|| {
            de::Error::custom("a colour is written like \"#c04030\": red, green and blue, two hexadecimal digits each")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_read_as_they_are_written() {
        for text in ["#000000", "#c04030", "#ffffff", "#0a0b0c"] {
            assert_eq!(
                Colour::parse(text).map(|it| it.to_string()).as_deref(),
                Some(text)
            );
        }
        assert_eq!(Colour::parse("#FFaa00"), Some(Colour([255, 170, 0])));
        for wrong in [
            "", "#", "red", "#12345", "#1234567", "#+12345", "c04030", "#éa00",
        ] {
            assert_eq!(Colour::parse(wrong), None, "{wrong}");
        }
    }
}
