//! Several sets of bindings, of which one is in use.

use thiserror::Error;

use crate::profile::Profile;

/// Most profiles that are kept.
pub const MAX_PROFILES: usize = 12;
/// Most characters of a profile's name.
pub const MAX_PROFILE_NAME_CHARS: usize = 40;

/// Never empty, names all different, one of them in use.
#[derive(Clone, Debug, PartialEq)]
pub struct Profiles {
    profiles: Vec<Profile>,
    chosen: usize,
}

/// Why a profile cannot be made, renamed or deleted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ProfileError {
    /// A name of nothing but blanks.
    #[error("a profile needs a name")]
    NoName,
    /// A name that is too long.
    #[error("a profile's name has at most {MAX_PROFILE_NAME_CHARS} characters")]
    LongName,
    /// A name with characters that cannot be shown.
    #[error("a profile's name is one line of characters that can be shown")]
    OddName,
    /// Another profile has the name.
    #[error("a profile of that name exists already")]
    Taken,
    /// There are as many as there can be.
    #[error("there are at most {MAX_PROFILES} profiles; delete one first")]
    Full,
    /// The last one cannot be deleted.
    #[error("the last profile cannot be deleted; reset it instead")]
    Last,
}

impl ProfileError {
    /// Key of its text.
    pub fn text_key(self) -> &'static str {
        match self {
            Self::NoName => "profile-error-no-name",
            Self::LongName => "profile-error-long-name",
            Self::OddName => "profile-error-odd-name",
            Self::Taken => "profile-error-taken",
            Self::Full => "profile-error-full",
            Self::Last => "profile-error-last",
        }
    }
}

impl Default for Profiles {
    fn default() -> Self {
        Self {
            profiles: vec![Profile::new(String::new())],
            chosen: 0,
        }
    }
}

impl Profiles {
    /// All, in the order in which they were made.
    pub fn all(&self) -> &[Profile] {
        &self.profiles
    }

    /// The place in [`Profiles::all`] of the one in use.
    pub fn chosen_place(&self) -> usize {
        self.chosen
    }

    /// The one in use.
    pub fn chosen(&self) -> &Profile {
        &self.profiles[self.chosen.min(self.profiles.len() - 1)]
    }

    /// The one in use, to change its bindings.
    pub fn chosen_mut(&mut self) -> &mut Profile {
        let place = self.chosen.min(self.profiles.len() - 1);
        &mut self.profiles[place]
    }

    /// Puts another in use. Returns false when there is none at that place.
    pub fn choose(&mut self, place: usize) -> bool {
        let there = place < self.profiles.len();
        if there {
            self.chosen = place;
        }
        there
    }

    /// Makes a profile with the bindings in use and puts it in use.
    ///
    /// # Errors
    /// [`ProfileError`] when the name will not do or there are too many.
    pub fn add(&mut self, name: &str) -> Result<(), ProfileError> {
        let name = self.checked(name, None)?;
        if self.profiles.len() >= MAX_PROFILES {
            return Err(ProfileError::Full);
        }
        self.profiles.push(self.chosen().called(name));
        self.chosen = self.profiles.len() - 1;
        Ok(())
    }

    /// Gives the profile in use another name.
    ///
    /// # Errors
    /// [`ProfileError`] when the name will not do.
    pub fn rename(&mut self, name: &str) -> Result<(), ProfileError> {
        let name = self.checked(name, Some(self.chosen))?;
        self.chosen_mut().rename(name);
        Ok(())
    }

    /// Deletes the profile in use; the one before it is used then.
    ///
    /// # Errors
    /// [`ProfileError::Last`] when there is no other.
    pub fn delete(&mut self) -> Result<(), ProfileError> {
        if self.profiles.len() == 1 {
            return Err(ProfileError::Last);
        }
        self.profiles.remove(self.chosen);
        self.chosen = self.chosen.saturating_sub(1);
        Ok(())
    }

    /// The name without surrounding blanks, if a profile may bear it; `own` is the place of the one it is for.
    fn checked(&self, name: &str, own: Option<usize>) -> Result<String, ProfileError> {
        let name = name.trim();
        if name.is_empty() {
            return Err(ProfileError::NoName);
        }
        if name.chars().count() > MAX_PROFILE_NAME_CHARS {
            return Err(ProfileError::LongName);
        }
        if name.chars().any(char::is_control) {
            return Err(ProfileError::OddName);
        }
        let lower = name.to_lowercase();
        let taken = self
            .profiles
            .iter()
            .enumerate()
            .any(|(place, other)| Some(place) != own && other.name().to_lowercase() == lower);
        if taken {
            return Err(ProfileError::Taken);
        }
        Ok(name.to_owned())
    }

    /// Takes in a profile that a file tells of. The first one found takes the place of the one that was there.
    /// Returns the place to change its bindings at.
    pub(crate) fn take_in(
        &mut self,
        name: &str,
        first: bool,
    ) -> Result<&mut Profile, ProfileError> {
        if first {
            let unnamed = name.is_empty();
            let name = if unnamed {
                String::new()
            } else {
                self.checked(name, Some(0))?
            };
            self.profiles = vec![Profile::new(name)];
            self.chosen = 0;
            return Ok(&mut self.profiles[0]);
        }
        let name = self.checked(name, None)?;
        if self.profiles.len() >= MAX_PROFILES {
            return Err(ProfileError::Full);
        }
        self.profiles.push(Profile::new(name));
        let last = self.profiles.len() - 1;
        Ok(&mut self.profiles[last])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::action::Action;
    use crate::input::Input;

    #[test]
    fn a_new_profile_begins_with_the_bindings_in_use_and_goes_its_own_way() {
        let mut own = Profiles::default();
        let key = Input::Key("KeyJ");
        assert_eq!(own.chosen_mut().bind(Action::Jump, key), Ok(()));
        assert_eq!(own.add("  Left hand "), Ok(()));
        assert_eq!(own.chosen().name(), "Left hand");
        assert!(own.chosen().inputs(Action::Jump).contains(&key));
        own.chosen_mut().reset_all();
        assert!(own.choose(0) && own.chosen().inputs(Action::Jump).contains(&key));
        assert!(!own.choose(2) && own.chosen_place() == 0);
    }

    #[test]
    fn names_are_checked_and_kept_apart() {
        let mut own = Profiles::default();
        assert_eq!(own.add("One"), Ok(()));
        assert_eq!(own.add("two"), Ok(()));
        for (name, why) in [
            ("", ProfileError::NoName),
            (" \t ", ProfileError::NoName),
            ("oNE", ProfileError::Taken),
            ("a\nb", ProfileError::OddName),
            (&"x".repeat(41), ProfileError::LongName),
        ] {
            assert_eq!(own.add(name), Err(why), "{name:?}");
            assert_eq!(own.rename(name), Err(why), "{name:?}");
        }
        assert_eq!(own.rename("Two"), Ok(()));
        assert_eq!(own.chosen().name(), "Two");
        for n in own.all().len()..MAX_PROFILES {
            assert_eq!(own.add(&format!("more {n}")), Ok(()));
        }
        assert_eq!(own.add("too many"), Err(ProfileError::Full));
    }

    #[test]
    fn the_last_profile_cannot_be_deleted() {
        let mut own = Profiles::default();
        assert_eq!(own.delete(), Err(ProfileError::Last));
        assert_eq!(own.add("One"), Ok(()));
        assert_eq!(own.delete(), Ok(()));
        assert_eq!(own, Profiles::default());
        assert_eq!((own.add("One"), own.choose(0)), (Ok(()), true));
        assert_eq!(own.delete(), Ok(()));
        assert_eq!(own.chosen().name(), "One");
    }
}
