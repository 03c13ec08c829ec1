//! What may be asked of a scene's pictures: their map, their dial, and what the player is told of them.

use antipode_geometry::HyperbolicMap;

use crate::notice::Hint;
use crate::scene::Scene;

impl Scene {
    /// Asks for the space's other picture, as the key does: it comes gliding, and the player is told its name.
    pub fn turn_map(&mut self) {
        let hint = if !self.player.lens.turn_map() {
            Hint::NoOtherMap
        } else if let Some(map) = self.player.lens.map() {
            Hint::Map(map)
        } else if self.player.lens.bend().is_some() {
            Hint::Bent
        } else {
            Hint::Unbent
        };
        self.outbox.hints.push(hint);
        self.kept.changed = true;
    }

    /// Shows a hyperbolic world through a map at once. Returns false where the space has no other map.
    pub fn set_map(&mut self, map: HyperbolicMap) -> bool {
        let fits = self.player.lens.set_map(map);
        self.repicture(fits)
    }

    /// Sets the dial of a hyperbolic world at once, 0 to 20. Returns false when out of range or there is none.
    pub fn set_curvature(&mut self, value: f64) -> bool {
        let fits = self.player.lens.set_curvature(value);
        self.repicture(fits)
    }

    /// Bends the picture of a flat world at once, -20 to 20; 0 unbends it. Returns false when out of range or the
    /// world is not flat.
    pub fn set_bend(&mut self, value: f64) -> bool {
        let fits = self.player.lens.set_bend(value);
        self.repicture(fits)
    }

    fn repicture(&mut self, fits: bool) -> bool {
        self.kept.changed |= fits;
        self.player.aimed = None;
        self.renew_picture();
        self.update_marker();
        fits
    }
}
