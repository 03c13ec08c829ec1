//! Noise libraries over a chunk's block of samples, four octaves of fractal noise each.

use antipode_terrain::SAMPLES;
use fastnoise_lite::{FastNoiseLite, FractalType, NoiseType};
use noise::{Fbm, MultiFractal, NoiseFn, Perlin};

use crate::terrain::clock::Rival;

/// Octaves of each, as many as the world that ours is measured in has.
const OCTAVES: u8 = 4;
/// Cycles per metre of the first octave, near those of the game's biomes.
const FREQUENCY: f64 = 0.03;
/// Samples of a block.
const COUNT: usize = SAMPLES * SAMPLES * SAMPLES;

/// Every library that runs on this machine, each filling one block.
pub fn noises<'a>() -> Vec<Rival<'a>> {
    vec![
        noise_perlin(),
        fastnoise_lite(),
        #[cfg(target_arch = "x86_64")]
        simdnoise_simplex(),
    ]
}

/// A block from a function of the place, columns upward as ours.
fn block(out: &mut [f32], at: impl Fn([f64; 3]) -> f32) {
    for (index, value) in out.iter_mut().enumerate() {
        let [x, z, y] = [
            index / (SAMPLES * SAMPLES),
            index / SAMPLES % SAMPLES,
            index % SAMPLES,
        ];
        *value = at([x as f64, y as f64, z as f64]);
    }
}

fn noise_perlin<'a>() -> Rival<'a> {
    let fbm = Fbm::<Perlin>::new(20)
        .set_octaves(OCTAVES.into())
        .set_frequency(FREQUENCY);
    let mut out = vec![0.0; COUNT];
    Rival::new("noise 0.9, Fbm<Perlin>", COUNT, move || {
        block(&mut out, |p| fbm.get(p) as f32);
        out[COUNT / 2]
    })
}

fn fastnoise_lite<'a>() -> Rival<'a> {
    let mut noise = FastNoiseLite::with_seed(20);
    noise.set_noise_type(Some(NoiseType::Perlin));
    noise.set_fractal_type(Some(FractalType::FBm));
    noise.set_fractal_octaves(Some(OCTAVES.into()));
    noise.set_frequency(Some(FREQUENCY as f32));
    let mut out = vec![0.0; COUNT];
    Rival::new("fastnoise-lite 1.1, Perlin", COUNT, move || {
        block(&mut out, |p| {
            let [x, y, z] = p.map(|c| c as f32);
            noise.get_noise_3d(x, y, z)
        });
        out[COUNT / 2]
    })
}

#[cfg(target_arch = "x86_64")]
fn simdnoise_simplex<'a>() -> Rival<'a> {
    use simdnoise::NoiseBuilder;
    Rival::new("simdnoise 3.1, simplex", COUNT, || {
        NoiseBuilder::fbm_3d(SAMPLES, SAMPLES, SAMPLES)
            .with_seed(20)
            .with_freq(FREQUENCY as f32)
            .with_octaves(OCTAVES)
            .generate()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_is_filled_in_the_order_of_our_samples() {
        let mut out = vec![0.0; COUNT];
        block(&mut out, |[x, y, z]| (x * 1e4 + y * 1e2 + z) as f32);
        assert_eq!(out[1], 100.0, "up first");
        assert_eq!(out[SAMPLES], 1.0, "then along z");
        assert_eq!(out[SAMPLES * SAMPLES], 1e4, "then along x");
    }
}
