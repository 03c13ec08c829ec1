//! From `key=value` words to what an object is.

use glam::{DVec2, DVec3};

use crate::aberration::{Aberration, Axis, Exit, Lengths, Sides, Ways};
use crate::check::shown;
use crate::colour::Colour;
use crate::error::RoomError;
pub use crate::kinds::KINDS;
use crate::kinds::kind;
use crate::portal::Opening;
use crate::room::{Checker, Finish, Object, Spawn, Texture, What};

/// What was read, or a sentence that says why it cannot be.
pub type Taken<T> = Result<T, RoomError>;

fn refuse<T>(sentence: impl Into<String>) -> Taken<T> {
    Err(RoomError::Command(sentence.into()))
}

/// The `key=value` words of a command, each key once.
#[derive(Debug)]
pub struct Pairs<'a>(Vec<(&'a str, &'a str)>);

impl<'a> Pairs<'a> {
    /// Parts words at their first `=`.
    ///
    /// # Errors
    /// If a word has none, or a key is said twice.
    pub fn of(words: &[&'a str]) -> Taken<Self> {
        let mut pairs = Vec::new();
        for word in words {
            let Some(pair) = word.split_once('=') else {
                return refuse(format!(
                    "{} says nothing; write key=value, such as at=0,1,-5.",
                    shown(word)
                ));
            };
            pairs.push(pair);
        }
        Self::from_pairs(pairs)
    }

    /// Pairs that are parted already.
    ///
    /// # Errors
    /// If a key is said twice.
    pub fn from_pairs(pairs: impl IntoIterator<Item = (&'a str, &'a str)>) -> Taken<Self> {
        let pairs: Vec<_> = pairs.into_iter().collect();
        let mut keys: Vec<_> = pairs.iter().map(|(key, _)| *key).collect();
        keys.sort_unstable();
        match keys.windows(2).find(|it| it[0] == it[1]) {
            Some(twice) => refuse(format!("{} is said twice.", shown(twice[0]))),
            None => Ok(Self(pairs)),
        }
    }

    /// The pairs, in their order.
    pub fn all(&self) -> &[(&'a str, &'a str)] {
        &self.0
    }

    fn has(&self, key: &str) -> bool {
        self.0.iter().any(|(it, _)| *it == key)
    }
}

/// Something new of that kind.
///
/// # Errors
/// [`RoomError::Command`]: what is missing or cannot be read.
pub fn new_object(word: &str, pairs: &Pairs<'_>) -> Taken<Object> {
    let Some((what, needed)) = kind(word) else {
        return refuse(format!(
            "There is no kind {}; there are {}.",
            shown(word),
            KINDS.join(", ")
        ));
    };
    if let Some(missing) = ["name"].iter().chain(needed).find(|it| !pairs.has(it)) {
        return refuse(format!(
            "To add something of the kind {word}, say its {missing}, too: {missing}=..."
        ));
    }
    if word == "portal" && !pairs.has("size") && !pairs.has("polygon") {
        return refuse("To add a portal, say its size or its polygon, too: size=WIDTH,HEIGHT.");
    }
    let mut object = Object::new("", DVec3::ZERO, what);
    set(&mut object, pairs, true)?;
    Ok(object)
}

/// Changes where one begins.
///
/// # Errors
/// [`RoomError::Command`]: what cannot be read.
pub fn set_spawn(spawn: &mut Spawn, pairs: &Pairs<'_>) -> Taken<()> {
    for (key, value) in &pairs.0 {
        match *key {
            "at" => spawn.at = three(key, value)?,
            "look" => spawn.look = two(key, value)?,
            _ => {
                return refuse(format!(
                    "A spawn has no {}; it has at and look.",
                    shown(key)
                ));
            }
        }
    }
    Ok(())
}

/// Changes an object; a new one has to be told its lengths if it is an aberration.
///
/// # Errors
/// [`RoomError::Command`]: what cannot be read; the object may be changed in part then.
pub fn set(object: &mut Object, pairs: &Pairs<'_>, is_new: bool) -> Taken<()> {
    let mut lengths = Told::default();
    for (key, value) in &pairs.0 {
        if set_common(object, key, value)?
            || set_surface(object, key, value)?
            || set_kind(&mut object.what, key, value)?
        {
            continue;
        }
        match (&object.what, *key) {
            (What::Aberration(_), "axis") => lengths.axis = Some(axis(value)?),
            (What::Aberration(_), "felt") => lengths.felt_m = Some(number(key, value)?),
            (What::Aberration(_), "stretch") => lengths.stretch = Some(three(key, value)?),
            _ => {
                return refuse(format!(
                    "{} is no word for something of the kind {}.",
                    shown(key),
                    object.what.kind()
                ));
            }
        }
    }
    let name = object.name.clone();
    match &mut object.what {
        What::Aberration(it) => lengths.apply(it, &name, is_new),
        _ => Ok(()),
    }
}

/// What a command says of an aberration's lengths.
#[derive(Default)]
struct Told {
    axis: Option<Axis>,
    felt_m: Option<f64>,
    stretch: Option<DVec3>,
}

impl Told {
    fn apply(&self, it: &mut Aberration, name: &str, is_new: bool) -> Taken<()> {
        it.lengths = match (self.axis, self.felt_m, self.stretch, it.lengths) {
            (None, None, None, lengths) if !is_new => lengths,
            (None, None, Some(stretch), _) => Lengths::Stretch(stretch),
            (Some(axis), Some(felt_m), None, _) => Lengths::Felt { axis, felt_m },
            (None, Some(felt_m), None, Lengths::Felt { axis, .. })
            | (Some(axis), None, None, Lengths::Felt { felt_m, .. })
                if !is_new =>
            {
                Lengths::Felt { axis, felt_m }
            }
            _ => {
                return refuse(format!(
                    "The aberration {} has either axis and felt, or stretch.",
                    shown(name)
                ));
            }
        };
        Ok(())
    }
}

fn set_common(object: &mut Object, key: &str, value: &str) -> Taken<bool> {
    match key {
        "name" => value.clone_into(&mut object.name),
        "at" => object.at = three(key, value)?,
        "turn" => object.turn = three(key, value)?,
        "group" => object.group = (value != "none").then(|| value.to_owned()),
        "mass" if value == "none" => object.mass = None,
        "mass" => object.mass = Some(number(key, value)?),
        _ => return Ok(false),
    }
    Ok(true)
}

fn set_surface(object: &mut Object, key: &str, value: &str) -> Taken<bool> {
    let surface = &mut object.surface;
    match key {
        // A lamp has a colour, and no surface.
        "colour" => match &mut object.what {
            What::Light { colour: light, .. } => *light = colour(key, value)?,
            _ => surface.colour = colour(key, value)?,
        },
        "checker" if value == "none" => surface.checker = None,
        "checker" => {
            let (second, size) = value.split_once(',').unwrap_or((value, "1"));
            surface.checker = Some(Checker {
                colour: colour(key, second)?,
                size: number(key, size)?,
            });
        }
        "texture" if value == "none" => surface.texture = None,
        "texture" => {
            let (file, size) = value.rsplit_once(',').unwrap_or((value, "1"));
            surface.texture = Some(Texture {
                file: file.to_owned(),
                size: number(key, size)?,
            });
        }
        "glow" => surface.glow = number(key, value)?,
        "finish" => {
            surface.finish = one_of(
                key,
                value,
                &[
                    ("matt", Finish::Matt),
                    ("mirror", Finish::Mirror),
                    ("glass", Finish::Glass),
                ],
            )?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

fn set_kind(what: &mut What, key: &str, value: &str) -> Taken<bool> {
    match (what, key) {
        (
            What::Box { size }
            | What::Pyramid { size }
            | What::Ramp { size }
            | What::Stairs { size, .. }
            | What::Arch { size, .. },
            "size",
        ) => *size = three(key, value)?,
        (What::Cylinder { radius, .. } | What::Ball { radius }, "radius") => {
            *radius = number(key, value)?;
        }
        (What::Cylinder { height, .. }, "height") => *height = number(key, value)?,
        (What::Stairs { steps, .. }, "steps") => {
            let Ok(count) = value.parse() else {
                return refuse(format!("{} is no whole number of steps.", shown(value)));
            };
            *steps = count;
        }
        (What::Arch { opening, .. }, "opening") => *opening = two(key, value)?,
        (What::Model { file, .. }, "file") => value.clone_into(file),
        (What::Model { scale, .. }, "scale") => *scale = number(key, value)?,
        (What::Light { power, .. }, "power") => *power = number(key, value)?,
        (What::Sign { text, .. }, "text") => *text = (!value.is_empty()).then(|| value.to_owned()),
        (What::Sign { size, .. }, "size") => *size = two(key, value)?,
        (What::Aberration(it), "half") => it.half = three(key, value)?,
        (What::Aberration(it), "sides") => it.sides = sides(value, it.sides)?,
        (What::Aberration(it), "exit") => {
            let exit = one_of(
                key,
                value,
                &[
                    ("original", Exit::Original),
                    ("inverse", Exit::Inverse),
                    ("none", Exit::Nothing),
                ],
            )?;
            it.sides = Sides::Legacy { exit };
        }
        (What::Portal(it), "to") => (*value).clone_into(&mut it.to),
        (What::Portal(it), "size") => it.opening = Opening::Size(two(key, value)?),
        (What::Portal(it), "polygon") => it.opening = Opening::Polygon(corners(key, value)?),
        (What::Portal(it), "sides") => it.sides = one_of(key, value, &[("1", 1), ("2", 2)])?,
        (What::Aberration(it), "ways") => {
            it.ways = one_of(
                key,
                value,
                &[("both", Ways::Both), ("forward", Ways::Forward)],
            )?;
        }
        (What::Aberration(it), "outline") => {
            it.outline = one_of(key, value, &[("on", true), ("off", false)])?;
        }
        _ => return Ok(false),
    }
    Ok(true)
}

fn sides(value: &str, before: Sides) -> Taken<Sides> {
    let exit = match before {
        Sides::Legacy { exit } => exit,
        _ => Exit::default(),
    };
    let all = [
        ("walls", Sides::Walls),
        ("soft", Sides::Soft),
        ("snell", Sides::Snell),
        ("legacy", Sides::Legacy { exit }),
    ];
    one_of("sides", value, &all)
}

fn axis(value: &str) -> Taken<Axis> {
    one_of(
        "axis",
        value,
        &[("x", Axis::X), ("y", Axis::Y), ("z", Axis::Z)],
    )
}

fn one_of<T: Copy>(key: &str, value: &str, all: &[(&str, T)]) -> Taken<T> {
    if let Some((_, it)) = all.iter().find(|(word, _)| *word == value) {
        return Ok(*it);
    }
    let words: Vec<_> = all.iter().map(|(word, _)| *word).collect();
    let words = words.join(", ");
    refuse(format!(
        "{key}={} is not known; it is one of {words}.",
        shown(value)
    ))
}

/// A colour: `#c04030`.
///
/// # Errors
/// [`RoomError::Command`] if it is none.
pub fn colour(key: &str, value: &str) -> Taken<Colour> {
    match Colour::parse(value) {
        Some(it) => Ok(it),
        None => refuse(format!(
            "{key}={} is no colour; write it like #c04030.",
            shown(value)
        )),
    }
}

/// A number.
///
/// # Errors
/// [`RoomError::Command`] if it is none.
pub fn number(key: &str, value: &str) -> Taken<f64> {
    match value.parse::<f64>() {
        Ok(it) if it.is_finite() => Ok(it),
        _ => refuse(format!("{key}={} is no number.", shown(value))),
    }
}

fn numbers<const N: usize>(key: &str, value: &str) -> Taken<[f64; N]> {
    let all: Vec<f64> = value
        .split(',')
        .map(|it| number(key, it))
        .collect::<Taken<_>>()?;
    match all.try_into() {
        Ok(it) => Ok(it),
        Err(_) => refuse(format!(
            "{key}={} is to be {N} numbers with commas between them, and no blanks.",
            shown(value)
        )),
    }
}

/// Places in a plane: X,Y,X,Y and so on.
fn corners(key: &str, value: &str) -> Taken<Vec<DVec2>> {
    let all: Vec<f64> = value
        .split(',')
        .map(|it| number(key, it))
        .collect::<Taken<_>>()?;
    if !all.len().is_multiple_of(2) {
        return refuse(format!(
            "{key}={} is to be two numbers for each corner.",
            shown(value)
        ));
    }
    let corner = |pair: &[f64]| DVec2::new(pair[0], pair[1]);
    Ok(all.chunks_exact(2).map(corner).collect())
}

/// Two numbers: `X,Y`.
///
/// # Errors
/// [`RoomError::Command`] if it is none.
pub fn two(key: &str, value: &str) -> Taken<DVec2> {
    numbers(key, value).map(DVec2::from_array)
}

/// Three numbers: `X,Y,Z`.
///
/// # Errors
/// [`RoomError::Command`] if it is none.
pub fn three(key: &str, value: &str) -> Taken<DVec3> {
    numbers(key, value).map(DVec3::from_array)
}
