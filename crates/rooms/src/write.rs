//! From a [`Room`] to the text of its file: always in one order, a field a line, what nothing has to be said of left
//! out, so that two versions of a room can be compared line by line.

use std::fmt::Write;

use glam::{DVec2, DVec3};

use crate::aberration::{Aberration, Exit, Lengths, Sides, Ways};
use crate::check::check;
use crate::error::Fault;
use crate::portal::{Opening, Portal};
use crate::room::{Finish, Object, Room, Surface, VERSION, What};

const HEAD: &str = "// A room of Antipode. docs/rooms.md of the game says what may stand here.\n";

/// The text of a room's file.
///
/// # Errors
/// What is wrong with the room; what is refused in a file is not written into one.
pub fn write(room: &Room) -> Result<String, Fault> {
    check(room)?;
    Ok(write_so_far(room))
}

/// The same of a room that is being changed, whatever is wrong with it.
pub fn write_so_far(room: &Room) -> String {
    let mut out = Lines {
        text: HEAD.to_owned(),
        deep: 0,
    };
    out.open("(");
    out.field("version", VERSION);
    out.field("name", text(&room.name));
    if !room.sentence.is_empty() {
        out.field("sentence", text(&room.sentence));
    }
    out.field("gravity", three(room.gravity));
    out.field(
        "sky",
        format!(
            "(colour: \"{}\", light: {})",
            room.sky.colour,
            number(room.sky.light)
        ),
    );
    if let Some(sun) = &room.sun {
        let said = format!(
            "(aim: {}, colour: \"{}\", power: {})",
            two(sun.aim),
            sun.colour,
            number(sun.power)
        );
        out.field("sun", said);
    }
    if let Some(fog) = &room.fog {
        out.field(
            "fog",
            format!("(colour: \"{}\", reach: {})", fog.colour, number(fog.reach)),
        );
    }
    out.field(
        "spawn",
        format!(
            "(at: {}, look: {})",
            three(room.spawn.at),
            two(room.spawn.look)
        ),
    );
    out.open("objects: [");
    for object in &room.objects {
        write_object(&mut out, object);
    }
    out.close("],");
    out.close(")");
    out.text
}

/// A text in quotes.
pub(crate) fn text(text: &str) -> String {
    format!("{text:?}")
}

/// Lines with their indent.
struct Lines {
    text: String,
    deep: usize,
}

impl Lines {
    fn line(&mut self, line: &str) {
        self.text.extend(std::iter::repeat_n("    ", self.deep));
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn open(&mut self, line: &str) {
        self.line(line);
        self.deep += 1;
    }

    fn close(&mut self, line: &str) {
        self.deep -= 1;
        self.line(line);
    }

    fn field(&mut self, name: &str, value: impl std::fmt::Display) {
        self.line(&format!("{name}: {value},"));
    }
}

fn write_object(out: &mut Lines, object: &Object) {
    out.open("(");
    out.field("name", text(&object.name));
    if let Some(group) = &object.group {
        out.field("group", text(group));
    }
    out.field("at", three(object.at));
    if object.turn != DVec3::ZERO {
        out.field("turn", three(object.turn));
    }
    out.field("what", what(&object.what));
    if object.surface != Surface::default() {
        out.field("surface", surface(&object.surface));
    }
    if let Some(mass) = object.mass {
        out.field("mass", number(mass));
    }
    out.close("),");
}

fn what(what: &What) -> String {
    match what {
        What::Box { size } => format!("Box(size: {})", three(*size)),
        What::Pyramid { size } => format!("Pyramid(size: {})", three(*size)),
        What::Ramp { size } => format!("Ramp(size: {})", three(*size)),
        What::Cylinder { radius, height } => {
            format!(
                "Cylinder(radius: {}, height: {})",
                number(*radius),
                number(*height)
            )
        }
        What::Ball { radius } => format!("Ball(radius: {})", number(*radius)),
        What::Stairs { size, steps } => format!("Stairs(size: {}, steps: {steps})", three(*size)),
        What::Arch { size, opening } => {
            format!("Arch(size: {}, opening: {})", three(*size), two(*opening))
        }
        What::Model { file, scale } => {
            format!("Model(file: {}, scale: {})", text(file), number(*scale))
        }
        What::Light { colour, power } => {
            format!("Light(colour: \"{colour}\", power: {})", number(*power))
        }
        What::Aberration(it) => aberration(it),
        What::Portal(it) => portal(it),
        What::Sign { text: None, size } => format!("Sign(size: {})", two(*size)),
        What::Sign {
            text: Some(it),
            size,
        } => format!("Sign(text: {}, size: {})", text(it), two(*size)),
        What::Group => "Group".to_owned(),
    }
}

fn aberration(it: &Aberration) -> String {
    let lengths = match it.lengths {
        Lengths::Felt { axis, felt_m } => format!("axis: {axis:?}, felt: {}", number(felt_m)),
        Lengths::Stretch(stretch) => format!("stretch: {}", three(stretch)),
    };
    let sides = match it.sides {
        Sides::Walls => "Walls".to_owned(),
        Sides::Soft => "Soft".to_owned(),
        Sides::Snell => "Snell".to_owned(),
        Sides::Legacy {
            exit: Exit::Original,
        } => "Legacy(exit: Original)".to_owned(),
        Sides::Legacy {
            exit: Exit::Inverse,
        } => "Legacy(exit: Inverse)".to_owned(),
        Sides::Legacy {
            exit: Exit::Nothing,
        } => "Legacy(exit: Nothing)".to_owned(),
    };
    let ways = match it.ways {
        Ways::Both => "",
        Ways::Forward => ", ways: Forward",
    };
    let outline = if it.outline { ", outline: true" } else { "" };
    format!(
        "Aberration(half: {}, {lengths}, sides: {sides}{ways}{outline})",
        three(it.half)
    )
}

fn portal(it: &Portal) -> String {
    let opening = match &it.opening {
        Opening::Size(size) => format!("size: {}", two(*size)),
        Opening::Polygon(corners) => {
            let corners: Vec<_> = corners.iter().map(|it| two(*it)).collect();
            format!("polygon: [{}]", corners.join(", "))
        }
    };
    let sides = if it.sides == 1 {
        String::new()
    } else {
        format!(", sides: {}", it.sides)
    };
    format!("Portal({opening}, to: {}{sides})", text(&it.to))
}

fn surface(it: &Surface) -> String {
    let mut out = format!("(colour: \"{}\"", it.colour);
    // Writing into a string cannot fail.
    if let Some(checker) = &it.checker {
        let _ = write!(
            out,
            ", checker: (colour: \"{}\", size: {})",
            checker.colour,
            number(checker.size)
        );
    }
    if let Some(texture) = &it.texture {
        let _ = write!(
            out,
            ", texture: (file: {}, size: {})",
            text(&texture.file),
            number(texture.size)
        );
    }
    if it.glow != 0.0 {
        let _ = write!(out, ", glow: {}", number(it.glow));
    }
    match it.finish {
        Finish::Matt => {}
        Finish::Mirror => out.push_str(", finish: Mirror"),
        Finish::Glass => out.push_str(", finish: Glass"),
    }
    out.push(')');
    out
}

/// The shortest digits that are read as the same number; 0 has no sign.
fn number(value: f64) -> String {
    format!("{}", value + 0.0)
}

fn two(it: DVec2) -> String {
    format!("({}, {})", number(it.x), number(it.y))
}

fn three(it: DVec3) -> String {
    format!("({}, {}, {})", number(it.x), number(it.y), number(it.z))
}
