//! Who stands far off in the beam of a flashlight is lit by it as all else is.

use std::path::Path;

use antipode_testing::may_skip;
use antipode_tests::program::{field, number, run_with};
use antipode_tests::seam::picture;
use image::RgbImage;

const SIZE: [&str; 4] = ["--size", "960x540", "--view-distance", "3"];
/// The numbers in which the fault was found: the eye 14 m over ground, and figures 17 to 35 m off.
const FIGURES: [(f64, f64); 5] = [
    (26.0, 0.0),
    (30.0, 3.0),
    (35.0, -3.0),
    (40.0, 2.0),
    (46.0, -4.0),
];

/// Whether there is an adapter to draw with; the first picture tells.
fn no_adapter(saves: &Path) -> bool {
    let options = ["--size", "64x64", "--view-distance", "1"];
    let probe = run_with(
        saves,
        "new euclidean seed=4 generator=1\nshot probe.png",
        &options,
    );
    probe.status != Some(0) && may_skip(&format!("a graphics adapter ({})", probe.stderr.trim()))
}

/// Makes pictures by night: `alone.png` without figures, `dark.png` with them, `lit.png` by flashlight. From so
/// high up no hill hides who is far off.
fn make_pictures(saves: &Path, world: &str) {
    let shot = |name: &str| format!("set time 440\nwait 0.05\nshot {name}.png\n");
    let spawned = FIGURES
        .map(|(x, z)| format!("spawn bot {x} 8 {z}"))
        .join("\n");
    let script = format!(
        "new {world} seed=21 generator=1\nset npcs off\nset fly on\nteleport 12 19.5 0 A\nsettle\ntap F1\ntap Digit1\naim 0 -25\n\
         {}{spawned}\nset npcs still\nwait 1\n{}tap KeyY\nwait 0.2\n{}probe",
        shot("alone"),
        shot("dark"),
        shot("lit")
    );
    let run = run_with(saves, &script, &SIZE);
    let told = run.probe(0);
    assert_eq!(field(told, "flashlight").as_bool(), Some(true));
    let drawn =
        number(told, "picture.figures_by_frame") + number(told, "picture.figures_by_vertex");
    assert!(drawn >= FIGURES.len() as f64, "{drawn} figures are drawn");
}

/// Places at which two pictures differ by more than so many steps in some channel.
fn changed(a: &RgbImage, b: &RgbImage, steps: u8) -> Vec<(u32, u32)> {
    let differs = |(x, y, p): (u32, u32, &image::Rgb<u8>)| {
        let off = p.0.iter().zip(b.get_pixel(x, y).0);
        off.map(|(p, q)| p.abs_diff(q))
            .any(|off| off > steps)
            .then_some((x, y))
    };
    a.enumerate_pixels().filter_map(differs).collect()
}

/// Far off in an open space the numbers of directions are huge: a highlight told by their first three alone was
/// hundreds of times too bright there.
#[test]
fn who_is_far_off_in_the_beam_of_a_flashlight_is_lit_and_no_white_cut_out() {
    let saves = tempfile::tempdir().unwrap();
    if no_adapter(saves.path()) {
        return;
    }
    for world in ["hyperbolic", "euclidean"] {
        make_pictures(saves.path(), world);
        let [alone, dark, lit] =
            ["alone", "dark", "lit"].map(|name| picture(&saves.path().join(format!("{name}.png"))));
        let figures = changed(&alone, &dark, 12);
        let lights = changed(&dark, &lit, 2).len();
        let white = figures
            .iter()
            .filter(|(x, y)| lit.get_pixel(*x, *y).0.iter().all(|channel| *channel > 240))
            .count();
        assert!(figures.len() > 400, "{world}: {} of figures", figures.len());
        assert!(lights > 400, "{world}: {lights} are lit");
        assert!(
            white * 100 < figures.len(),
            "{world}: {white} of {} are white",
            figures.len()
        );
    }
}
