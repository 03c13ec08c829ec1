//! Bytes of sRGB and linear light (IEC 61966-2-1), by tables.

use std::sync::LazyLock;

use glam::Vec4;

/// Linear light is told apart in this many steps: so fine that each of the 256 bytes has a step
/// of its own even in the dark, where they lie 1.2 steps apart.
const LIGHT_STEPS: usize = 4096;

/// Room for every index of 13 bits.
const ENTRIES: usize = 2 * LIGHT_STEPS;

static TABLES: LazyLock<LightTables> = LazyLock::new(LightTables::new);

/// Bytes of sRGB by steps of linear light, and steps of light by bytes.
#[derive(Debug)]
pub(crate) struct LightTables {
    bytes: Box<[u8; ENTRIES]>,
    steps: [u16; 256],
}

impl LightTables {
    /// The tables, made when they are first asked for.
    pub(crate) fn get() -> &'static Self {
        &TABLES
    }

    fn new() -> Self {
        let byte = |step: usize| {
            let c = step as f32 / LIGHT_STEPS as f32;
            let srgb = if c <= 0.003_130_8 {
                c * 12.92
            } else {
                1.055 * c.powf(1.0 / 2.4) - 0.055
            };
            // The cast saturates, for the entries past full light.
            (srgb * 255.0).round() as u8
        };
        let step = |byte: usize| (LIGHT_STEPS as f32 * light_of(byte as u8)).round() as u16;
        Self {
            bytes: Box::new(std::array::from_fn(byte)),
            steps: std::array::from_fn(step),
        }
    }

    /// Linear light to sRGB, and 255; what bytes cannot say is held to what they can.
    #[inline]
    pub(crate) fn bytes(&self, linear: Vec4) -> [u8; 4] {
        /// Adding this rounds to a whole number and leaves it in the low bits.
        const ROUNDS: f32 = 8_388_608.0;
        let most = LIGHT_STEPS as f32;
        let steps = (linear * most).clamp(Vec4::ZERO, Vec4::splat(most)) + ROUNDS;
        let byte = |step: f32| self.bytes[step.to_bits() as usize % ENTRIES];
        [byte(steps.x), byte(steps.y), byte(steps.z), u8::MAX]
    }

    /// The byte half way between two in light, as a picture has it between two vertices, to a step of 1/4096.
    #[inline]
    pub(crate) fn halfway(&self, a: u8, b: u8) -> u8 {
        let steps = self.steps[usize::from(a)] + self.steps[usize::from(b)];
        self.bytes[usize::from(steps / 2)]
    }
}

/// sRGB to linear light, and 1.
pub(crate) fn linear([r, g, b]: [u8; 3]) -> Vec4 {
    Vec4::new(light_of(r), light_of(g), light_of(b), 1.0)
}

fn light_of(byte: u8) -> f32 {
    let c = f32::from(byte) / 255.0;
    if c <= 0.040_45 {
        c / 12.92
    } else {
        ((c + 0.055) / 1.055).powf(2.4)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_survives_linear_light() {
        let tables = LightTables::get();
        for c in 0..=255 {
            let colour = [c, 0, 255 - c];
            assert_eq!(tables.bytes(linear(colour)), [c, 0, 255 - c, 255]);
            assert_eq!(tables.halfway(c, c), c);
        }
        let out = tables.bytes(Vec4::new(-1.0, 1.1, 9.0, 1.0));
        assert_eq!(out, [0, 255, 255, 255], "held to what bytes can say");
    }

    #[test]
    fn half_way_is_half_of_the_light() {
        let tables = LightTables::get();
        for (a, b) in [(0, 255), (10, 200), (60, 61), (3, 90)] {
            let light = light_of(tables.halfway(a, b));
            let exact = f32::midpoint(light_of(a), light_of(b));
            // Half of a byte's own width in light, and a step.
            assert!(
                (light - exact).abs() < 0.005 * exact.sqrt() + 3e-4,
                "{a} {b}"
            );
            assert_eq!(tables.halfway(a, b), tables.halfway(b, a));
        }
    }
}
