//! The volume of each group of sounds.

/// A group of sounds that has a volume of its own, besides that of all together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Group {
    /// Steps, landings, digging and building.
    Effects,
    /// Wind, day and night.
    Ambience,
    /// Music.
    Music,
    /// Menus and the hotbar.
    Interface,
}

impl Group {
    /// Every group.
    pub const ALL: [Self; 4] = [Self::Effects, Self::Ambience, Self::Music, Self::Interface];
}

/// Volumes as sliders show them: each from 0, silent, to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumes {
    /// Of everything together.
    pub master: f32,
    /// Of [`Group::Effects`].
    pub effects: f32,
    /// Of [`Group::Ambience`].
    pub ambience: f32,
    /// Of [`Group::Music`].
    pub music: f32,
    /// Of [`Group::Interface`].
    pub interface: f32,
}

impl Default for Volumes {
    fn default() -> Self {
        Self {
            master: 0.8,
            effects: 0.8,
            ambience: 0.7,
            music: 0.5,
            interface: 0.6,
        }
    }
}

impl Volumes {
    /// Amplitude of a group, 0 to 1.
    pub fn gain(&self, group: Group) -> f32 {
        amplitude(match group {
            Group::Effects => self.effects,
            Group::Ambience => self.ambience,
            Group::Music => self.music,
            Group::Interface => self.interface,
        })
    }

    /// Amplitude of everything together, 0 to 1.
    pub fn master_gain(&self) -> f32 {
        amplitude(self.master)
    }
}

/// Loudness is heard roughly as the root of amplitude, so half a slider sounds like half.
fn amplitude(slider: f32) -> f32 {
    let slider = slider.clamp(0.0, 1.0);
    // A clamp lets what is no number pass.
    if slider.is_finite() {
        slider * slider
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sliders_end_in_silence_and_in_full_and_nonsense_is_silent() {
        assert_eq!(amplitude(0.0), 0.0);
        assert_eq!(amplitude(1.0), 1.0);
        assert_eq!(amplitude(7.0), 1.0);
        assert_eq!(amplitude(-1.0), 0.0);
        assert_eq!(amplitude(f32::NAN), 0.0);
    }

    #[test]
    fn each_group_follows_its_own_slider() {
        for group in Group::ALL {
            let mut volumes = Volumes {
                master: 1.0,
                effects: 1.0,
                ambience: 1.0,
                music: 1.0,
                interface: 1.0,
            };
            *match group {
                Group::Effects => &mut volumes.effects,
                Group::Ambience => &mut volumes.ambience,
                Group::Music => &mut volumes.music,
                Group::Interface => &mut volumes.interface,
            } = 0.0;
            for other in Group::ALL {
                assert_eq!(volumes.gain(other), if other == group { 0.0 } else { 1.0 });
            }
        }
    }
}
