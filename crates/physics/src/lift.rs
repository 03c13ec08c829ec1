//! Lifting someone out of ground that was built over them.

use glam::DVec3;

use crate::patch::{Capsule, Patch};
use crate::{BodyGround, Character, CharacterTuning};

/// How far up a free place is looked for.
const HIGHEST_LIFT_M: f64 = 64.0;

/// How far apart the places are that are tried on the way up.
const LIFT_STEP_M: f64 = 0.1;

/// Halvings of the last step up, to end within 0.1 mm of the ground.
const REFINEMENTS: usize = 10;

/// Ground this deep (m) in the capsule calls for a lift; less is stepped onto or pushed out of.
const DEEP_M: f64 = 0.15;

/// Overlaps (m) that a free place may have: it stands on the ground.
const TOUCH_M: f64 = 1e-3;

/// Spacing of the points of the axis that are asked whether they are in solid ground.
const POINT_SPACING_M: f64 = 0.3;

impl BodyGround<'_> {
    /// Raises a character that is stuck in the ground to the first free place above, up to 64 m:
    /// `inside` says whether a point of the chart is in solid ground, and there the capsule
    /// must be neither inside nor overlap terrain. A fall is stopped. Returns whether the character
    /// moved; one that is free, or finds no free place, is left as it was.
    ///
    /// The capsule is that of [`CharacterTuning::default`].
    pub fn lift_out(&self, character: &mut Character, inside: &dyn Fn(DVec3) -> bool) -> bool {
        self.lift_out_sized(character, &CharacterTuning::default(), inside)
    }

    /// [`Self::lift_out`] for a character of another size.
    pub fn lift_out_sized(
        &self,
        character: &mut Character,
        tuning: &CharacterTuning,
        inside: &dyn Fn(DVec3) -> bool,
    ) -> bool {
        let capsule = Capsule::new(tuning.height_m, tuning.radius_m);
        let feet = character.feet;
        if !feet.is_finite() || self.is_free(&capsule, feet, DEEP_M, inside) {
            return false;
        }
        let steps = (HIGHEST_LIFT_M / LIFT_STEP_M).round() as usize;
        let raised = |lift_m: f64| feet + DVec3::Y * lift_m;
        let free = |lift_m: f64| self.is_free(&capsule, raised(lift_m), TOUCH_M, inside);
        let Some(mut high) = (1..=steps)
            .map(|step| step as f64 * LIFT_STEP_M)
            .find(|&lift_m| free(lift_m))
        else {
            return false;
        };
        let mut low = high - LIFT_STEP_M;
        for _ in 0..REFINEMENTS {
            let middle = 0.5 * (low + high);
            if free(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        character.feet = raised(high);
        character.velocity.y = character.velocity.y.max(0.0);
        true
    }

    fn is_free(
        &self,
        capsule: &Capsule,
        feet: DVec3,
        depth_m: f64,
        inside: &dyn Fn(DVec3) -> bool,
    ) -> bool {
        let span = capsule.height_m - 2.0 * DEEP_M;
        let points = (span / POINT_SPACING_M).ceil().max(1.0) as usize;
        let solid = (0..=points)
            .any(|i| inside(feet + DVec3::Y * (DEEP_M + span * i as f64 / points as f64)));
        if solid {
            return false;
        }
        let (min, max) = capsule.bounds(feet);
        let frame = self.frame(feet);
        Patch::gather(self.ground, frame.as_ref(), feet, min, max)
            .depth_any_side(capsule, DVec3::ZERO)
            <= depth_m
    }
}
