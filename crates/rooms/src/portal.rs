//! What a portal is: an opening in its plane, and the portal that it leads to.
//!
//! Its plane is that of its own y and z axis, and +x is its front. Places in it are metres to the right and up, as who looks at its
//! front sees them.

use antipode_deformation as deformation;
use glam::DVec2;
use serde::Deserialize;

/// A portal: what goes in here comes out of its partner.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "Written")]
pub struct Portal {
    /// Where one can go in.
    pub opening: Opening,
    /// The name of its partner, which leads back to it; it may be its own.
    pub to: String,
    /// One side, its front, or both: 1 or 2.
    pub sides: u32,
}

/// Where one can go in.
#[derive(Debug, Clone, PartialEq)]
pub enum Opening {
    /// A rectangle about the portal's place: width and height, metres of the scene.
    Size(DVec2),
    /// A convex polygon: its corners, each once and in their order.
    Polygon(Vec<DVec2>),
}

/// How it stands in a file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename = "Portal")]
struct Written {
    #[serde(default)]
    size: Option<DVec2>,
    #[serde(default)]
    polygon: Option<Vec<DVec2>>,
    to: String,
    #[serde(default = "one")]
    sides: u32,
}

fn one() -> u32 {
    1
}

impl TryFrom<Written> for Portal {
    type Error = &'static str;

    fn try_from(it: Written) -> Result<Self, Self::Error> {
        let opening = match (it.size, it.polygon) {
            (Some(size), None) => Opening::Size(size),
            (None, Some(polygon)) => Opening::Polygon(polygon),
            _ => return Err("a portal has either size or polygon"),
        };
        Ok(Self {
            opening,
            to: it.to,
            sides: it.sides,
        })
    }
}

impl Portal {
    /// One that leads nowhere yet.
    pub(crate) fn new() -> Self {
        Self {
            opening: Opening::Size(DVec2::ONE),
            to: String::new(),
            sides: 1,
        }
    }
}

impl Opening {
    /// Its corners, metres of the scene to the right and up.
    pub fn polygon(&self) -> Vec<DVec2> {
        match self {
            Self::Size(size) => deformation::Portal::rectangle(*size),
            Self::Polygon(polygon) => polygon.clone(),
        }
    }
}
