//! The tuning of a character: every figure that a player feels, with its units.

/// Sizes, speeds and times of a walking character. [`Default`] gives the player's own.
///
/// Lengths are metres, times seconds, angles radians. Every value is expected to be finite and
/// non-negative, and `height_m >= 2 * radius_m`; a shorter capsule is treated as a ball.
#[derive(Clone, Debug, PartialEq)]
pub struct CharacterTuning {
    /// Height of the upright capsule, from the feet to the crown.
    pub height_m: f64,
    /// Radius of the capsule.
    pub radius_m: f64,
    /// Speed over the ground when walking; it is the horizontal speed, so hills do not slow it.
    pub walk_speed_m_s: f64,
    /// What sprinting multiplies the walking speed by.
    pub sprint_factor: f64,
    /// How fast the velocity follows the wish on the ground.
    pub ground_acceleration_m_s2: f64,
    /// How fast the velocity dies on the ground without a wish.
    pub ground_braking_m_s2: f64,
    /// How fast the velocity follows the wish in the air.
    pub air_acceleration_m_s2: f64,
    /// How fast the horizontal velocity dies in the air without a wish.
    pub air_braking_m_s2: f64,
    /// Height that the feet reach in a jump from standing on level ground.
    pub jump_height_m: f64,
    /// Steepest slope that can be stood on; steeper ground is slid down.
    pub max_slope_rad: f64,
    /// Highest step that is walked up without a jump.
    pub step_height_m: f64,
    /// Deepest drop that walking follows without leaving the ground.
    pub snap_m: f64,
    /// Downward acceleration.
    pub gravity_m_s2: f64,
    /// Fastest fall.
    pub terminal_speed_m_s: f64,
    /// For how long after walking off an edge a jump is still granted.
    pub coyote_s: f64,
    /// For how long before landing a press of jump is remembered.
    pub jump_buffer_s: f64,
    /// Speed of spectator flight.
    pub fly_speed_m_s: f64,
    /// What sprinting multiplies the speed of flight by.
    pub fly_sprint_factor: f64,
    /// How fast the velocity follows the wish in flight.
    pub fly_acceleration_m_s2: f64,
}

impl Default for CharacterTuning {
    fn default() -> Self {
        Self {
            height_m: 1.8,
            radius_m: 0.35,
            walk_speed_m_s: 4.5,
            sprint_factor: 1.7,
            ground_acceleration_m_s2: 50.0,
            ground_braking_m_s2: 50.0,
            air_acceleration_m_s2: 12.0,
            air_braking_m_s2: 4.0,
            jump_height_m: 1.2,
            max_slope_rad: 50f64.to_radians(),
            step_height_m: 0.4,
            snap_m: 0.4,
            gravity_m_s2: 9.81,
            terminal_speed_m_s: 60.0,
            coyote_s: 0.1,
            jump_buffer_s: 0.1,
            fly_speed_m_s: 8.0,
            fly_sprint_factor: 3.0,
            fly_acceleration_m_s2: 60.0,
        }
    }
}

impl CharacterTuning {
    /// Upward speed in m/s that carries the feet to [`Self::jump_height_m`]: v^2 = 2 g h.
    pub fn jump_speed_m_s(&self) -> f64 {
        (2.0 * self.gravity_m_s2 * self.jump_height_m).sqrt()
    }

    /// Height of the eyes above the feet, where a first-person camera stands.
    pub fn eye_height_m(&self) -> f64 {
        self.height_m * 0.9
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_jump_speed_spends_itself_at_the_jump_height() {
        let tuning = CharacterTuning::default();
        let speed = tuning.jump_speed_m_s();
        let apex = speed * speed / (2.0 * tuning.gravity_m_s2);
        assert!((apex - 1.2).abs() < 1e-12, "{apex}");
    }

    #[test]
    fn walking_follows_the_steepest_slope_down_at_a_sprint() {
        let tuning = CharacterTuning::default();
        let run = tuning.walk_speed_m_s * tuning.sprint_factor / 60.0;
        assert!(run * tuning.max_slope_rad.tan() < tuning.snap_m);
    }
}
