//! The languages there are, and which of them the system speaks.

/// A language that the game speaks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Language {
    /// English; what other languages lack is said in it.
    #[default]
    English,
    /// Polish.
    Polish,
    /// Spanish.
    Spanish,
    /// German.
    German,
    /// Chinese, in simplified characters.
    Chinese,
}

impl Language {
    /// Every language, in the order in which they are offered.
    pub const ALL: [Self; 5] = [
        Self::English,
        Self::Polish,
        Self::Spanish,
        Self::German,
        Self::Chinese,
    ];

    /// Its two letters (ISO 639-1), as settings and locale files have them.
    pub fn id(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Polish => "pl",
            Self::Spanish => "es",
            Self::German => "de",
            Self::Chinese => "zh",
        }
    }

    /// What it calls itself.
    pub fn own_name(self) -> &'static str {
        match self {
            Self::English => "English",
            Self::Polish => "Polski",
            Self::Spanish => "Español",
            Self::German => "Deutsch",
            Self::Chinese => "中文",
        }
    }

    /// The language of these two letters; `None` where the game does not speak it.
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.id() == id)
    }

    /// The language of a locale's name as the environment has it, such as `pl_PL.UTF-8` or `de-AT`.
    pub fn from_locale(locale: &str) -> Option<Self> {
        let language = locale.split(['_', '-', '.', '@']).next().unwrap_or("");
        Self::from_id(&language.to_ascii_lowercase())
    }

    /// The language the environment asks for, by `LC_ALL`, `LC_MESSAGES` or `LANG`; English otherwise.
    pub fn of_system() -> Self {
        Self::of_environment(|variable| std::env::var(variable).ok())
    }

    /// As POSIX has it: the first of the variables that is not empty decides, whether or not it can be met.
    fn of_environment(read: impl Fn(&str) -> Option<String>) -> Self {
        ["LC_ALL", "LC_MESSAGES", "LANG"]
            .into_iter()
            .filter_map(read)
            .find(|locale| !locale.is_empty())
            .and_then(|locale| Self::from_locale(&locale))
            .unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_lead_back_to_their_languages() {
        for language in Language::ALL {
            assert_eq!(Language::from_id(language.id()), Some(language));
        }
        assert_eq!(Language::from_id("tlh"), None);
    }

    #[test]
    fn the_environment_is_asked_in_the_order_of_posix() {
        let of = |variables: &[(&str, &str)]| {
            Language::of_environment(|wanted| {
                let found = variables.iter().find(|(name, _)| *name == wanted);
                found.map(|(_, locale)| (*locale).to_owned())
            })
        };
        assert_eq!(of(&[]), Language::English);
        assert_eq!(of(&[("LANG", "C.UTF-8")]), Language::English);
        assert_eq!(of(&[("LANG", "pl_PL.UTF-8")]), Language::Polish);
        assert_eq!(of(&[("LANG", "zh_CN")]), Language::Chinese);
        assert_eq!(of(&[("LANG", "de-AT@euro")]), Language::German);
        assert_eq!(of(&[("LC_ALL", ""), ("LANG", "es")]), Language::Spanish);
        let both = [("LANG", "pl_PL"), ("LC_ALL", "fr_FR")];
        assert_eq!(of(&both), Language::English, "LC_ALL decides, met or not");
    }
}
