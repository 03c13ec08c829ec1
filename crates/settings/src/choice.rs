//! Settings that are one of a few: each choice has the word that stands in the file and in commands.

/// An enumeration whose variants have words, each listed once.
macro_rules! words {
    ($(#[$about:meta])* $name:ident { $($(#[$what:meta])* $variant:ident = $id:literal,)+ }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum $name {
            $($(#[$what])* $variant,)+
        }

        impl $name {
            /// All, in their order.
            pub const ALL: [Self; Self::IDS.len()] = [$(Self::$variant),+];

            /// The words of all, in the same order.
            pub const IDS: &'static [&'static str] = &[$($id),+];

            /// Its word.
            pub fn id(self) -> &'static str {
                match self {
                    $(Self::$variant => $id,)+
                }
            }

            /// What a word means, if anything.
            pub fn from_id(id: &str) -> Option<Self> {
                match id {
                    $($id => Some(Self::$variant),)+
                    _ => None,
                }
            }
        }
    };
}

pub(crate) use words;

/// Words of which one is the default.
macro_rules! choice {
    ($(#[$about:meta])* $name:ident $variants:tt default $default:ident) => {
        words! {
            $(#[$about])*
            $name $variants
        }

        impl Default for $name {
            fn default() -> Self {
                Self::$default
            }
        }
    };
}

choice! {
    /// How much exactness pictures trade for speed.
    Quality {
        /// Errors too small to notice in motion are let pass.
        Fast = "fast",
        /// Nothing is off by half a pixel or more.
        Balanced = "balanced",
        /// Everything by the full formulas.
        Exact = "exact",
    } default Balanced
}

choice! {
    /// Most frames a second.
    FrameCap {
        /// 30 a second.
        Cap30 = "30",
        /// 60 a second.
        Cap60 = "60",
        /// 90 a second.
        Cap90 = "90",
        /// 120 a second.
        Cap120 = "120",
        /// 144 a second.
        Cap144 = "144",
        /// 240 a second.
        Cap240 = "240",
        /// As many as the machine makes.
        None = "none",
    } default Cap60
}

impl FrameCap {
    /// Most frames a second; `None` where there is no limit.
    pub fn frames_per_s(self) -> Option<u32> {
        match self {
            Self::Cap30 => Some(30),
            Self::Cap60 => Some(60),
            Self::Cap90 => Some(90),
            Self::Cap120 => Some(120),
            Self::Cap144 => Some(144),
            Self::Cap240 => Some(240),
            Self::None => None,
        }
    }
}

choice! {
    /// How edges are smoothed.
    Msaa {
        /// Four samples on a graphics card, one in software.
        Auto = "auto",
        /// One sample a pixel.
        Off = "off",
        /// Four samples a pixel.
        Four = "4x",
    } default Auto
}

impl Msaa {
    /// Samples a pixel; `software`: whether the processor draws.
    pub fn samples(self, software: bool) -> u32 {
        match (self, software) {
            (Self::Off, _) | (Self::Auto, true) => 1,
            (Self::Four, _) | (Self::Auto, false) => 4,
        }
    }
}

choice! {
    /// Shadows of the sun and the moon.
    Shadows {
        /// High on a graphics card, low in software.
        Auto = "auto",
        /// None.
        Off = "off",
        /// As fine as a processor can draw them.
        Low = "low",
        /// Finer and softer.
        High = "high",
    } default Auto
}

impl Shadows {
    /// What automatic stands for; `software`: whether the processor draws.
    #[must_use]
    pub fn resolved(self, software: bool) -> Self {
        match (self, software) {
            (Self::Auto, true) => Self::Low,
            (Self::Auto, false) => Self::High,
            (chosen, _) => chosen,
        }
    }
}

choice! {
    /// What land looks like near by.
    Surfaces {
        /// Fine on a graphics card, plain in software.
        Auto = "auto",
        /// The colours of its kinds.
        Plain = "plain",
        /// Grass, ripples, pebbles and layers, with light by pixel.
        Fine = "fine",
    } default Auto
}

impl Surfaces {
    /// Whether they are fine; `software`: whether the processor draws.
    pub fn are_fine(self, software: bool) -> bool {
        match self {
            Self::Auto => !software,
            Self::Plain => false,
            Self::Fine => true,
        }
    }
}

choice! {
    /// Whether there is a mirror over the view from a car's bonnet.
    RearMirror {
        /// On a graphics card, and not in software.
        Auto = "auto",
        /// None.
        Off = "off",
        /// Always.
        On = "on",
    } default Auto
}

impl RearMirror {
    /// Whether there is one; `software`: whether the processor draws.
    pub fn is_on(self, software: bool) -> bool {
        match self {
            Self::Auto => !software,
            Self::Off => false,
            Self::On => true,
        }
    }
}

choice! {
    /// Share of the window's resolution that the world is drawn in, along each side.
    RenderScale {
        /// All of it on a graphics card, half in software.
        Auto = "auto",
        /// A quarter.
        Quarter = "25",
        /// Half.
        Half = "50",
        /// Two thirds.
        TwoThirds = "67",
        /// Three quarters.
        ThreeQuarters = "75",
        /// All of it.
        Full = "100",
    } default Auto
}

impl RenderScale {
    /// The share, above 0 and at most 1; `software`: whether the processor draws.
    pub fn share(self, software: bool) -> f32 {
        match self {
            Self::Quarter => 0.25,
            Self::Half => 0.5,
            Self::TwoThirds => 2.0 / 3.0,
            Self::ThreeQuarters => 0.75,
            Self::Full => 1.0,
            Self::Auto => {
                if software {
                    0.5
                } else {
                    1.0
                }
            }
        }
    }
}

choice! {
    /// The map that new hyperbolic worlds are seen through.
    Map {
        /// Land keeps its shape near the eye and drops away.
        Raised = "raised",
        /// Straight lines of the space are straight in the picture.
        Horizon = "horizon",
    } default Raised
}

choice! {
    /// The language of all texts.
    Language {
        /// The system's, where the game speaks it.
        System = "system",
        /// English.
        English = "en",
        /// Polish.
        Polish = "pl",
        /// German.
        German = "de",
        /// Spanish.
        Spanish = "es",
        /// Chinese, in simplified characters.
        Chinese = "zh",
    } default System
}
