//! Long random walks through rough, cavernous land: nobody falls through it, nobody gets stuck.

use crate::common::{Soup, Walker};
use antipode_physics::{CharacterInput, ChartGround};
use glam::{DVec3, IVec3, Vec3};

const HALF_M: i32 = 14;

/// Steep hills, overhangs and holes between them, in a bowl that nobody can leave; negative is solid.
fn rough(at: Vec3) -> f32 {
    let hills = at.y - 2.0 * (at.x * 0.5).sin() * (at.z * 0.43).cos();
    let lumps = 1.6 * (at.x * 0.9).sin() * (at.y * 0.8 + 1.0).sin() * (at.z * 0.85 + 0.4).cos();
    let rim = 11.0 - at.x.hypot(at.z);
    (hills + lumps).min(rim)
}

fn land() -> ChartGround {
    let mut soup = Soup::default();
    soup.march(
        IVec3::new(-HALF_M, -8, -HALF_M),
        IVec3::new(HALF_M, 12, HALF_M),
        rough,
    );
    soup.world()
}

/// A small repeatable generator (SplitMix64) of numbers in 0..1.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

#[test]
fn half_an_hour_of_wandering_stays_in_the_air_and_never_sticks() {
    let world = land();
    let (mut deepest, mut stays, mut blocked) = (f64::MAX, 0, 0);
    for seed in 0..15 {
        let mut dice = Dice(seed);
        let mut walker = Walker::at(
            &world,
            dice.roll() * 8.0 - 4.0,
            9.0,
            dice.roll() * 8.0 - 4.0,
        );
        let mut stay = 0;
        for leg in 0..120 {
            let turn = dice.roll() * std::f64::consts::TAU;
            let (sprint, jumps) = (dice.roll() < 0.4, dice.roll() < 0.5);
            let from = walker.feet();
            for step in 0..60 {
                let wish = DVec3::new(turn.cos(), 0.0, turn.sin());
                let jump = jumps && step % 20 < 3;
                walker.step(CharacterInput {
                    wish,
                    sprint,
                    jump,
                    ..CharacterInput::default()
                });
                blocked += usize::from(walker.character.velocity.length() < 0.1);
                assert!(walker.feet().is_finite());
                let middle = walker.feet() + DVec3::Y * 0.9;
                deepest = deepest.min(f64::from(rough(middle.as_vec3())));
                assert!(
                    walker.feet().y > -7.5,
                    "seed {seed}, leg {leg}: fell through at {from}"
                );
            }
            stay = if walker.feet().distance(from) < 0.05 {
                stay + 1
            } else {
                0
            };
            stays += usize::from(stay > 0);
            assert!(
                stay < 10,
                "seed {seed}, leg {leg}: stuck at {:?}",
                walker.character
            );
        }
    }
    assert!(
        deepest > 0.0,
        "the body's middle was {deepest} in the ground"
    );
    // Walls met head on and pits too steep to walk out of hold a walker up now and then. Without the
    // detours, or without leaning in gullies, both counts double.
    assert!(stays < 50, "{stays} of 1800 legs led nowhere");
    assert!(blocked < 5500, "{blocked} of 108000 steps led nowhere");
}
