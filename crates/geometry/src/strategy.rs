//! The one trait through which the game knows its space.

use crate::{Atlas, Map, Metric, Optics};

/// A space: its charts, how they are seen and drawn, and how long its ways are.
pub trait Strategy: Atlas + Map + Optics + Metric {}

impl<T: Atlas + Map + Optics + Metric> Strategy for T {}
