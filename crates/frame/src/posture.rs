//! The posture of a figure at a moment: plain data for a picture.

/// A movement of a body. Figures with a skeleton have a clip for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Clip {
    /// Stands.
    Idle,
    /// Walks; its moment counts cycles, and the right foot comes down at whole ones.
    Walk,
    /// Runs; counted as the walk.
    Run,
    /// Jumps, and hangs in the air at the end.
    Jump,
    /// Falls.
    Fall,
    /// Comes down on the ground: the crouch that a jump begins with.
    Land,
    /// Dies, and lies.
    Die,
    /// Sits at the wheel of a car.
    Sit,
    /// Sits on the ground, its arms on its knees.
    Rest,
    /// Sits on a stone or a stump, its feet on the ground before it.
    Perch,
    /// Is hit. Lies over the others from the belt up.
    Hit,
    /// Carries something in the right hand. Lies over the others, most of all over the right arm.
    Hold,
}

impl Clip {
    /// Every clip, by its number in a [`Posture`].
    pub const ALL: [Self; 12] = [
        Self::Idle,
        Self::Walk,
        Self::Run,
        Self::Jump,
        Self::Fall,
        Self::Land,
        Self::Die,
        Self::Sit,
        Self::Rest,
        Self::Perch,
        Self::Hit,
        Self::Hold,
    ];

    /// Those that move the whole body; the rest lie over them.
    pub const WHOLE: [Self; 10] = [
        Self::Idle,
        Self::Walk,
        Self::Run,
        Self::Jump,
        Self::Fall,
        Self::Land,
        Self::Die,
        Self::Sit,
        Self::Rest,
        Self::Perch,
    ];

    /// The name that the clip has in a model's file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Idle => "idle",
            Self::Walk => "walk",
            Self::Run => "run",
            Self::Jump | Self::Land => "jump",
            Self::Fall => "fall",
            Self::Die => "die",
            Self::Sit => "sit",
            Self::Rest => "rest",
            Self::Perch => "perch",
            Self::Hit => "hit",
            Self::Hold => "hold",
        }
    }
}

/// A mixture of clips, each at a moment of its own, and what is turned besides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posture {
    /// Share of each clip by its number, 0 to 1. Those of whole bodies are weights of a mean.
    pub shares: [f32; Clip::ALL.len()],
    /// Seconds since each clip began; cycles of walk and run.
    pub moments: [f32; Clip::ALL.len()],
    /// The way the legs go from the way the figure faces, radians, to the right positive.
    pub twist_rad: f32,
    /// How far it looks up, radians.
    pub pitch_rad: f32,
    /// How far what is held is swung, from 0 raised to 1 struck; -1 where it is not swung.
    pub swing: f32,
    /// How far what is held is thrown back, 0 to 1.
    pub kick: f32,
}

impl Default for Posture {
    fn default() -> Self {
        Self::of(Clip::Idle, 0.0)
    }
}

impl Posture {
    /// One clip alone at a moment.
    pub fn of(clip: Clip, moment: f32) -> Self {
        let mut posture = Self {
            shares: [0.0; Clip::ALL.len()],
            moments: [0.0; Clip::ALL.len()],
            twist_rad: 0.0,
            pitch_rad: 0.0,
            swing: -1.0,
            kick: 0.0,
        };
        posture.put(clip, 1.0, moment);
        posture
    }

    /// The same with another clip set.
    #[must_use]
    pub fn with(mut self, clip: Clip, share: f32, moment: f32) -> Self {
        self.put(clip, share, moment);
        self
    }

    /// Sets the share and moment of a clip.
    pub fn put(&mut self, clip: Clip, share: f32, moment: f32) {
        self.shares[clip as usize] = share;
        self.moments[clip as usize] = moment;
    }

    /// Share of a clip.
    pub fn share(&self, clip: Clip) -> f32 {
        self.shares[clip as usize]
    }

    /// Moment of a clip.
    pub fn moment(&self, clip: Clip) -> f32 {
        self.moments[clip as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clips_are_numbered_in_their_order() {
        for (number, clip) in Clip::ALL.into_iter().enumerate() {
            assert_eq!(clip as usize, number);
        }
        let posture = Posture::of(Clip::Die, 1.5).with(Clip::Hold, 0.5, 2.0);
        assert_eq!(
            (posture.share(Clip::Die), posture.moment(Clip::Hold)),
            (1.0, 2.0)
        );
        assert_eq!(posture.share(Clip::Idle), 0.0);
    }
}
