//! Values that are put into a message: words and numbers.

use std::borrow::Cow;

use fluent_bundle::FluentValue;
use fluent_bundle::types::{FluentNumber, FluentNumberOptions};

/// Numbers from here on are put in as words: plural rules count no further.
const TOO_LARGE: f64 = 1e15;
/// Most digits behind the decimal mark.
const MOST_DIGITS: usize = 6;

/// Something to put into a message in place of `{ $name }`.
///
/// Integers and [`Value::decimals`] are numbers: a message can choose its words by them, as plural forms.
#[derive(Clone, Debug, PartialEq)]
pub struct Value<'a>(FluentValue<'a>);

impl Value<'_> {
    /// A number rounded to so many digits (at most 6) behind the language's decimal mark.
    pub fn decimals(number: f64, digits: usize) -> Self {
        let digits = digits.min(MOST_DIGITS);
        if !number.is_finite() || number.abs() >= TOO_LARGE {
            return Self(FluentValue::String(format!("{number:.digits$}").into()));
        }
        let scale = 10_f64.powi(digits as i32);
        // Adding zero drops the sign of what rounds to it.
        let rounded = (number * scale).round_ties_even() / scale + 0.0;
        // A number matches a literal of a message, such as `[0]`, only if their options are the same: a literal has its
        // digits behind the point as the least, none at all where it has no point, and nothing else.
        let options = FluentNumberOptions {
            minimum_fraction_digits: (digits > 0).then_some(digits),
            ..FluentNumberOptions::default()
        };
        Self(FluentValue::Number(FluentNumber::new(rounded, options)))
    }

    /// The same rounded down, for an amount that is there: what is too little never looks like enough. A millionth of
    /// the last digit is added before, so that sums of what was weighed in binary stay what they are.
    pub fn decimals_of_stock(amount: f64, digits: usize) -> Self {
        let scale = 10_f64.powi(digits.min(MOST_DIGITS) as i32);
        Self::decimals((amount * scale + 1e-6).floor() / scale, digits)
    }
}

impl Value<'_> {
    /// What a message shows of it, with that decimal mark.
    pub(crate) fn write(&self, mark: char) -> String {
        match &self.0 {
            FluentValue::String(text) => text.to_string(),
            number => write(number, mark).unwrap_or_default(),
        }
    }
}

impl<'a> From<&Value<'a>> for FluentValue<'a> {
    fn from(value: &Value<'a>) -> Self {
        value.0.clone()
    }
}

impl<'a> From<&'a str> for Value<'a> {
    fn from(text: &'a str) -> Self {
        Self(FluentValue::String(text.into()))
    }
}

impl<'a> From<&'a String> for Value<'a> {
    fn from(text: &'a String) -> Self {
        Self::from(text.as_str())
    }
}

impl From<String> for Value<'_> {
    fn from(text: String) -> Self {
        Self(FluentValue::String(text.into()))
    }
}

impl<'a> From<Cow<'a, str>> for Value<'a> {
    fn from(text: Cow<'a, str>) -> Self {
        Self(FluentValue::String(text))
    }
}

impl From<char> for Value<'_> {
    fn from(letter: char) -> Self {
        letter.to_string().into()
    }
}

macro_rules! from_integers {
    ($($integer:ty),+) => {
        $(impl From<$integer> for Value<'_> {
            fn from(number: $integer) -> Self {
                if (number as f64).abs() >= TOO_LARGE {
                    return number.to_string().into();
                }
                Self::decimals(number as f64, 0)
            }
        })+
    };
}

from_integers!(u8, u16, u32, u64, usize, i8, i16, i32, i64, isize);

/// A number with a decimal point.
pub(crate) fn with_point<M>(value: &FluentValue<'_>, _: &M) -> Option<String> {
    write(value, '.')
}

/// A number with a decimal comma.
pub(crate) fn with_comma<M>(value: &FluentValue<'_>, _: &M) -> Option<String> {
    write(value, ',')
}

fn write(value: &FluentValue<'_>, mark: char) -> Option<String> {
    let FluentValue::Number(number) = value else {
        return None;
    };
    let digits = number.options.minimum_fraction_digits.unwrap_or(0);
    let text = format!("{:.digits$}", number.value);
    Some(text.replace('.', mark.encode_utf8(&mut [0; 4])))
}
