//! The section of the image suite: how far the game's pictures on this adapter are from the expected ones.

use std::io::Cursor;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use image::RgbImage;

use super::blocks::difference;
use super::suite::{self, MOST_STEPS, Played, SCENES, Shot, Suite};
use crate::{Cell, LabError, Picture, Section, Table};

/// The section's identity and heading.
pub const ID: &str = "gpu-pictures";
const TITLE: &str = "Pictures beside those of a software adapter";

const METHOD: [&str; 2] = [
    "The game's own program plays the scripts of the image suite on this adapter, with one sample a pixel and the shadows of a software adapter, and its pictures of 256 by 144 pixels are compared with those that Mesa's lavapipe drew. The means of blocks of 16 by 16 pixels are compared, since adapters round single pixels of edges and stars differently; the worst block and channel counts, in steps of 1/255.",
    "A picture that misses the bar shows land, light or figures otherwise than expected. Whether that is a fault of the game, of the driver or of the bar, the pictures below tell.",
];

/// The section, and sentences about what is missing in it; `adapter` is the name of the one that is measured.
pub fn section(suite: &Suite, adapter: &str) -> (Section, Vec<String>) {
    if let Some(lack) = suite.lacks() {
        return (super::told::absent(ID, TITLE, &lack), vec![lack]);
    }
    let (mut rows, mut played, mut lacks) = (Vec::new(), Vec::new(), Vec::new());
    let mut pictures = Vec::new();
    for scene in SCENES {
        match compared(suite, scene) {
            Ok(Compared {
                adapter: drew,
                shots,
            }) => {
                if drew != adapter {
                    lacks.push(format!(
                        "The game drew {scene}.script with {drew} and not with {adapter}: its pictures say nothing of that."
                    ));
                }
                played.push(vec![Cell::text(scene), Cell::Text(drew)]);
                for (row, picture) in shots {
                    rows.push(row);
                    pictures.extend(picture);
                }
            }
            Err(why) => lacks.push(format!("Pictures are missing. {why}")),
        }
    }
    let columns = [
        "script",
        "picture",
        "worst block off by",
        "its corner",
        "at most 3",
    ];
    let tables = [
        Table::new("Pictures", columns, rows),
        Table::new("What the game drew with", ["script", "adapter"], played),
    ];
    let method = METHOD.into_iter().map(str::to_owned);
    let method: Vec<String> = method.chain(lacks.iter().cloned()).collect();
    let mut section = Section::new(ID, TITLE, method, tables);
    section.pictures = pictures;
    (section, lacks)
}

/// A row of the table, and what is shown where the picture misses the bar.
type Judged = (Vec<Cell>, Option<Picture>);

/// What a scene came to.
struct Compared {
    /// What drew it.
    adapter: String,
    shots: Vec<Judged>,
}

fn compared(suite: &Suite, scene: &str) -> Result<Compared, LabError> {
    let folder = tempfile::tempdir().map_err(|source| LabError::Write {
        path: std::env::temp_dir(),
        source,
    })?;
    let Played { adapter, shots } = suite.play(scene, folder.path())?;
    let judged = |shot: &Shot| judged(scene, shot, &suite.expected(&shot.name)?);
    Ok(Compared {
        adapter,
        shots: shots.iter().map(judged).collect::<Result<_, LabError>>()?,
    })
}

fn judged(scene: &str, shot: &Shot, expected: &RgbImage) -> Result<Judged, LabError> {
    let worst = suite::worst(&shot.name, &shot.found, expected)?;
    let (x, y) = worst.at;
    let name = Path::new(&shot.name).file_stem().unwrap_or_default();
    let (name, good) = (name.to_string_lossy(), worst.steps <= MOST_STEPS);
    let shown = if good {
        None
    } else {
        Some(Picture {
            title: format!("{name}: expected, drawn, and eight times their difference"),
            png: in_base64(&beside_each_other(&shot.found, expected))?,
        })
    };
    let row = vec![
        Cell::text(scene),
        Cell::text(name),
        Cell::figure(worst.steps, "steps"),
        Cell::text(format!("({x}, {y})")),
        Cell::Verdict(good),
    ];
    Ok((row, shown))
}

/// What was expected, what was drawn, and their difference, from the left; the pictures are of one size.
fn beside_each_other(found: &RgbImage, expected: &RgbImage) -> RgbImage {
    let apart = difference(found, expected);
    let width = expected.width();
    RgbImage::from_fn(3 * width, expected.height(), |x, y| {
        let from = [expected, found, &apart][(x / width) as usize % 3];
        *from.get_pixel(x % width, y)
    })
}

fn in_base64(picture: &RgbImage) -> Result<String, LabError> {
    let mut png = Cursor::new(Vec::new());
    let written = picture.write_to(&mut png, image::ImageFormat::Png);
    written
        .map_err(|e| LabError::Suite(format!("A picture could not be put into the page: {e}.")))?;
    Ok(STANDARD.encode(png.into_inner()))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn a_picture_is_judged_by_its_worst_block() {
        let expected = RgbImage::new(32, 16);
        let of_red = |red: u8| {
            let found = RgbImage::from_fn(32, 16, |x, _| {
                image::Rgb([if x < 16 { 0 } else { red }, 0, 0])
            });
            let name = "day.png".to_owned();
            judged("euclidean", &Shot { name, found }, &expected).unwrap()
        };
        let (row, shown) = of_red(3);
        assert_eq!((&row[4], shown), (&Cell::Verdict(true), None));
        let (off, shown) = of_red(4);
        let corner = [Cell::figure(4.0, "steps"), Cell::text("(16, 0)")];
        assert_eq!(off[1..4], [&[Cell::text("day")], &corner[..]].concat());
        assert_eq!(off[4], Cell::Verdict(false));
        let png = STANDARD.decode(shown.unwrap().png).unwrap();
        let shown = image::load_from_memory(&png).unwrap().to_rgb8();
        assert_eq!(shown.dimensions(), (96, 16));
        let red = [0, 31, 63, 95].map(|x| shown.get_pixel(x, 0).0[0]);
        assert_eq!(red, [0, 0, 4, 32]);
    }

    #[test]
    fn without_a_game_the_section_says_why_it_is_empty() {
        let nowhere = Path::new("/nowhere").to_owned();
        let suite = Suite {
            game: nowhere.join("antipode"),
            scenes: nowhere,
            adapter: antipode_render::AdapterChoice::Gpu,
            patience: std::time::Duration::ZERO,
        };
        let (section, lacks) = section(&suite, "a card");
        assert!(lacks.len() == 1 && section.method == lacks, "{lacks:?}");
        assert!(section.id == ID && section.tables.is_empty());
    }
}
