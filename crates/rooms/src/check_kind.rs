//! What makes each kind of object sound.

use crate::aberration::{Aberration, Axis, Lengths, Sides, Ways};
use crate::bounds::{
    CORNERS, FARTHEST_M, HALVES_M, LOOSE_M, MASSES_KG, POWERS, SCALES, SIZES_M, STEPS, STRETCHES,
};
use crate::check::{Checked, check_name, check_text, each, one, pair, wrong};
use crate::files;
use crate::portal::{Opening, Portal};
use crate::room::What;

const EACH_WAY: &str = " m along each axis";

pub(crate) fn check_kind(what: &What) -> Checked {
    match what {
        What::Box { size } | What::Pyramid { size } | What::Ramp { size } => {
            each("what.size", *size, &SIZES_M, EACH_WAY)
        }
        What::Cylinder { radius, height } => {
            one("what.radius", *radius, &SIZES_M, " m")?;
            one("what.height", *height, &SIZES_M, " m")
        }
        What::Ball { radius } => one("what.radius", *radius, &SIZES_M, " m"),
        What::Stairs { size, steps } => {
            each("what.size", *size, &SIZES_M, EACH_WAY)?;
            if STEPS.contains(steps) {
                return Ok(());
            }
            let reason = format!(
                "is to be {} to {}, and is {steps}",
                STEPS.start(),
                STEPS.end()
            );
            Err(wrong("what.steps", reason))
        }
        What::Arch { size, opening } => {
            each("what.size", *size, &SIZES_M, EACH_WAY)?;
            pair("what.opening", *opening, &SIZES_M, " m")?;
            if opening.x >= size.z || opening.y >= size.y {
                return Err(wrong(
                    "what.opening",
                    "is to be less wide and less high than the arch",
                ));
            }
            if opening.y < opening.x / 2.0 {
                return Err(wrong(
                    "what.opening",
                    "is to be at least half as high as it is wide, since its top is round",
                ));
            }
            Ok(())
        }
        What::Model { file, scale } => {
            files::check_model(file).map_err(|reason| wrong("what.file", reason))?;
            one("what.scale", *scale, &SCALES, "")
        }
        What::Light { power, .. } => one("what.power", *power, &POWERS, ""),
        What::Aberration(aberration) => check_aberration(aberration),
        What::Portal(portal) => check_portal(portal),
        What::Sign { text, size } => {
            check_text("what.text", text.as_deref().unwrap_or_default())?;
            pair("what.size", *size, &SIZES_M, " m")
        }
        What::Group => Ok(()),
    }
}

/// What may be loose: solids that are round or have flat sides, neither tiny nor huge.
pub(crate) fn check_loose(what: &What, mass: Option<f64>) -> Checked {
    let Some(mass) = mass else {
        return Ok(());
    };
    one("mass", mass, &MASSES_KG, " kg")?;
    match what {
        What::Box { size } | What::Pyramid { size } | What::Ramp { size } => each(
            "what.size",
            *size,
            &LOOSE_M,
            " m along each axis for something loose",
        ),
        What::Ball { radius } => half_width(*radius),
        What::Cylinder { radius, height } => {
            half_width(*radius)?;
            one("what.height", *height, &LOOSE_M, " m for something loose")
        }
        other => {
            let reason = format!(
                "is said of something of the kind {}; only a box, a ball, a cylinder, a pyramid or a ramp can be loose",
                other.kind()
            );
            Err(wrong("mass", reason))
        }
    }
}

fn half_width(radius: f64) -> Checked {
    let range = LOOSE_M.start() / 2.0..=LOOSE_M.end() / 2.0;
    one("what.radius", radius, &range, " m for something loose")
}

fn check_aberration(it: &Aberration) -> Checked {
    each("what.half", it.half, &HALVES_M, EACH_WAY)?;
    match it.lengths {
        Lengths::Felt { axis, felt_m } => {
            let length = 2.0 * it.half[axis.index()];
            if !STRETCHES.contains(&(felt_m / length)) {
                let (least, most) = (length * STRETCHES.start(), length * STRETCHES.end());
                let reason = format!(
                    "is to be {least} to {most} m for a box of {length} m (1/32 to 32 times), and is {felt_m}"
                );
                return Err(wrong("what.felt", reason));
            }
        }
        Lengths::Stretch(stretch) => {
            for axis in Axis::ALL {
                let value = stretch[axis.index()];
                if !STRETCHES.contains(&value) {
                    let reason = format!("is to be 1/32 to 32 along each axis, and is {value}");
                    return Err(wrong("what.stretch", reason));
                }
            }
        }
    }
    if it.sides == Sides::Walls && !it.doors().contains(&true) {
        let reason = "cannot be Walls: with more than one axis stretched no two faces are doors, and nobody could enter; Soft has none";
        return Err(wrong("what.sides", reason));
    }
    if it.ways == Ways::Forward && !matches!(it.lengths, Lengths::Felt { .. }) {
        return Err(wrong(
            "what.ways",
            "can be Forward only with axis and felt, since forward is along the axis",
        ));
    }
    Ok(())
}

fn check_portal(it: &Portal) -> Checked {
    check_name(&it.to).map_err(|reason| wrong("what.to", reason))?;
    if !(1..=2).contains(&it.sides) {
        let reason = format!("is to be 1 or 2, and is {}", it.sides);
        return Err(wrong("what.sides", reason));
    }
    match &it.opening {
        Opening::Size(size) => pair("what.size", *size, &SIZES_M, " m"),
        Opening::Polygon(corners) => {
            if !CORNERS.contains(&corners.len()) {
                let (least, most) = (CORNERS.start(), CORNERS.end());
                let reason = format!(
                    "is to have {least} to {most} corners, and has {}",
                    corners.len()
                );
                return Err(wrong("what.polygon", reason));
            }
            let near = -FARTHEST_M..=FARTHEST_M;
            corners
                .iter()
                .try_for_each(|it| pair("what.polygon", *it, &near, " m"))
        }
    }
}
