//! What a traveller asks of the solids of a scene.

use glam::DVec3;

/// What a straight path meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneHit {
    /// When, in the parameter of the path.
    pub time: f64,
    /// Which of the scene's objects.
    pub object: u32,
    /// Which of its triangles, or another part of it.
    pub part: u32,
    /// Normal of the surface in the scene, of length 1, to whichever side.
    pub normal: DVec3,
}

/// The solids of a scene.
pub trait SceneQuery {
    /// What the path x + t v meets first, 0 <= t <= `longest`. v is not of length 1.
    fn first(&self, x: DVec3, v: DVec3, longest: f64) -> Option<SceneHit>;

    /// Shows all triangles that may reach into the box between two corners, in metres of the scene.
    fn near(&self, low: DVec3, high: DVec3, show: &mut dyn FnMut([DVec3; 3]));
}

/// A scene without solids.
#[derive(Clone, Copy, Debug, Default)]
pub struct Void;

impl SceneQuery for Void {
    fn first(&self, _: DVec3, _: DVec3, _: f64) -> Option<SceneHit> {
        None
    }

    fn near(&self, _: DVec3, _: DVec3, _: &mut dyn FnMut([DVec3; 3])) {}
}
