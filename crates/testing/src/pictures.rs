//! How far apart two pictures show the same land, and land that is made to be told by.

use image::RgbaImage;

/// Colours nearer than this are alike, of 255.
const ALIKE: u8 = 8;
/// So many pixels may be off, of nearly a million: where land goes out of sight behind land.
pub const MOST_OFF: usize = 100;

/// The land's shader, with land striped by where in the world it is, in each colour along another axis: whatever lies
/// elsewhere in the picture than it should is seen to. Stripes are 8 to 16 pixels wide where land is seen from straight
/// above. `text` is the shader of the game.
///
/// # Panics
/// When the text has no function, or several, that colours land.
pub fn striped_land(text: &str) -> String {
    let shown = "fn land_colour(";
    assert_eq!(text.matches(shown).count(), 1);
    let own = "fn land_colour(in: VertexOut, point: Shaded, steps: Steps, offered: f32) -> vec4<f32> {
        let octave = log2(max(length(in.place.xyz), 1.0) / 60.0);
        let fine = exp2(floor(octave));
        let turns = vec3<f32>(3.14159265) * in.grain / fine;
        // As fine as can be seen at a distance, without a border; grey where a pixel holds much of a stripe.
        let plain = smoothstep(vec3<f32>(0.15), vec3<f32>(0.3), fwidth(in.grain) / fine);
        let stripes = mix(cos(turns), cos(0.5 * turns), fract(octave)) * (1.0 - plain);
        return vec4<f32>(0.2 + 0.18 * stripes, 1.0);
    }";
    text.replace(shown, "fn land_colour_shown(") + own
}

/// Of every pixel and colour the least, or the most, of all pixels that are no farther than `near_px` from it along
/// either side of the picture.
fn of_near(picture: &RgbaImage, near_px: usize, choose: impl Fn(u8, u8) -> u8) -> Vec<u8> {
    let mut chosen = picture.as_raw().clone();
    for apart in [4, 4 * picture.width() as usize] {
        let from = chosen.clone();
        for bytes in (1..=near_px).map(|by| by * apart) {
            let pairs = chosen[bytes..].iter_mut().zip(&from);
            pairs.for_each(|(here, there)| *here = choose(*here, *there));
            let pairs = chosen.iter_mut().zip(&from[bytes..]);
            pairs.for_each(|(here, there)| *here = choose(*here, *there));
        }
    }
    chosen
}

/// Pixels whose colour is not between those that the other picture has near them.
fn misplaced(picture: &RgbaImage, other: &RgbaImage, near_px: usize) -> usize {
    let (least, most) = (
        of_near(other, near_px, u8::min),
        of_near(other, near_px, u8::max),
    );
    let is_off = |i: usize, value: u8| {
        value.saturating_add(ALIKE) < least[i] || value > most[i].saturating_add(ALIKE)
    };
    let pixels = picture.as_raw().chunks_exact(4).enumerate();
    pixels
        .filter(|(i, pixel)| (0..3).any(|c| is_off(4 * i + c, pixel[c])))
        .count()
}

/// Pixels of either picture whose colour the other has nowhere within `near_px` pixels of them; of the two counts the
/// larger.
pub fn apart(a: &RgbaImage, b: &RgbaImage, near_px: usize) -> usize {
    misplaced(a, b, near_px).max(misplaced(b, a, near_px))
}

/// Land lies less than so many pixels from where the other picture has it, but for [`MOST_OFF`] pixels; none where that
/// is more than `most_px`.
pub fn strays_px(a: &RgbaImage, b: &RgbaImage, most_px: usize) -> Option<usize> {
    (0..=most_px).find(|near_px| apart(a, b, *near_px) <= MOST_OFF)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stripes of grey, moved to the right by so many pixels.
    fn stripes(by: u32) -> RgbaImage {
        RgbaImage::from_fn(200, 20, |x, _| {
            let grey = (x + 32 - by) % 16 * 12;
            image::Rgba([grey as u8, 0, 0, 255])
        })
    }

    #[test]
    fn what_is_moved_is_told_to_the_pixel() {
        for by in 0..=3 {
            assert_eq!(strays_px(&stripes(0), &stripes(by), 4), Some(by as usize));
        }
        assert_eq!(strays_px(&stripes(0), &stripes(3), 2), None);
        assert!(apart(&stripes(0), &stripes(3), 2) > 10 * MOST_OFF);
    }
}
