//! What can be changed of what is chosen, as rows of the inspector; of the room itself where nothing is chosen.

use antipode_language::{Texts, Value};
use antipode_room_scene::RoomScene;
use antipode_rooms::aberration::{Aberration, Axis, Lengths, Sides, Ways, thesis_of_stretch};
use antipode_rooms::bounds::{
    FARTHEST_M, FASTEST_FALL_M_S2, HALVES_M, POWERS, SCALES, SIZES_M, STEPS, TURNS_DEG,
};
use antipode_rooms::portal::{Opening, Portal};
use antipode_rooms::room::{Finish, Surface};
use antipode_rooms::{Colour, Object, Room, What};
use antipode_ui::workshop::{Amount, FieldKind, FieldRow, Unit};
use glam::{DVec2, DVec3};

use super::bent;
use super::kits::bounds_of_group;

mod joined;

use joined::{are_alike, join, join_place};

/// Greatest number of the thesis that is offered: a stretch of 1/32.
const THESIS: (f64, f64) = (-31.0 / 32.0, 31.0);

/// Among so many different things that are chosen one looks for one that is alike.
const MOST_KNOWN: usize = 8;

/// The rows of what is chosen.
pub fn rows(texts: &Texts, scene: &RoomScene, chosen: &[usize]) -> Vec<FieldRow> {
    let room = scene.room();
    let Some((first, others)) = chosen.split_first() else {
        return of_room(texts, room);
    };
    let all = room.objects.iter();
    let groups = all.filter(|it| it.what == What::Group);
    let groups: Vec<_> = groups.map(|it| it.name.as_str()).collect();
    let of = |index: usize, words: Option<&Texts>| {
        let mut rows = Rows {
            texts: words,
            all: Vec::new(),
        };
        of_object(&mut rows, scene, index, others.is_empty());
        of_group(&mut rows, &groups, &room.objects[index]);
        rows.all
    };
    let mut rows = of(*first, Some(texts));
    let mut known = vec![&room.objects[*first]];
    for other in others {
        let object = &room.objects[*other];
        if known
            .iter()
            .rev()
            .take(MOST_KNOWN)
            .any(|it| are_alike(it, object))
        {
            join_place(&mut rows, object);
            continue;
        }
        known.push(object);
        let theirs = of(*other, None);
        rows.retain_mut(|row| match theirs.iter().find(|it| it.key == row.key) {
            Some(same) => join(row, same),
            None => false,
        });
    }
    rows
}

/// Rows that are put together.
struct Rows<'a> {
    /// None where others have the words already.
    texts: Option<&'a Texts>,
    all: Vec<FieldRow>,
}

impl Rows<'_> {
    fn say(&self, key: &str) -> String {
        self.texts.map_or_else(String::new, |texts| texts.say(key))
    }

    fn add(&mut self, key: &str, kind: FieldKind, is_default: bool) {
        // The axes of one field share a name, and a room's own fields have those of things.
        let word = key.trim_start_matches("room-");
        let about = match (word, &kind) {
            // A portal has sides, too, which its words explain.
            ("sides", FieldKind::Choice(options, _)) if options.len() == 2 => String::new(),
            ("sides" | "ways" | "outline" | "lengths" | "thesis", _) => {
                self.say(&format!("workshop-hover-{word}"))
            }
            _ => String::new(),
        };
        self.all.push(FieldRow {
            key: key.to_owned(),
            label: self.say(&format!("workshop-field-{word}")),
            about,
            kind,
            is_default,
        });
    }

    fn numbers(
        &mut self,
        key: &str,
        values: &[f64],
        (range, unit): ((f64, f64), Unit),
        is_default: bool,
    ) {
        let amount = |value: &f64| Amount {
            value: Some(*value),
            range,
        };
        let amounts = values.iter().map(amount).collect();
        self.add(key, FieldKind::Numbers(amounts, unit), is_default);
    }

    fn choice(&mut self, key: &str, words: &[&str], chosen: usize, is_default: bool) {
        let option = |word: &&str| {
            let id = [key, word].join("-");
            let label = self.say(&format!("workshop-choice-{id}"));
            ((*word).to_owned(), label)
        };
        let options = words.iter().map(option).collect();
        self.add(key, FieldKind::Choice(options, Some(chosen)), is_default);
    }

    fn colour(&mut self, key: &str, colour: Colour, usual: Colour) {
        let kind = FieldKind::Colour(Some(colour.0));
        self.add(key, kind, colour == usual);
    }

    fn words(&mut self, key: &str, words: String, is_warning: bool) {
        self.all.push(FieldRow {
            key: key.to_owned(),
            label: String::new(),
            about: String::new(),
            kind: FieldKind::Words(words, is_warning),
            is_default: true,
        });
    }
}

fn far() -> ((f64, f64), Unit) {
    ((-FARTHEST_M, FARTHEST_M), Unit::Metres)
}

fn sizes() -> ((f64, f64), Unit) {
    ((*SIZES_M.start(), *SIZES_M.end()), Unit::Metres)
}

fn of_object(rows: &mut Rows<'_>, scene: &RoomScene, index: usize, alone: bool) {
    let object = &scene.room().objects[index];
    if alone {
        rows.add("name", FieldKind::Text(Some(object.name.clone())), true);
    }
    rows.numbers("at", &object.at.to_array(), far(), object.at == DVec3::ZERO);
    let label = rows.say("workshop-field-at-group");
    if let Some(row) = rows.all.last_mut().filter(|_| object.group.is_some()) {
        row.label = label;
    }
    let turns = ((*TURNS_DEG.start(), *TURNS_DEG.end()), Unit::Degrees);
    let turn = object.turn.to_array();
    rows.numbers("turn", &turn, turns, object.turn == DVec3::ZERO);
    match &object.what {
        What::Aberration(it) => of_aberration(rows, it, alone),
        What::Portal(it) => of_portal(rows, scene, (object, it), alone),
        What::Group if alone => carried(rows, scene, &object.name),
        what => of_solid(rows, what),
    }
    if has_surface(&object.what) {
        of_surface(rows, &object.surface);
    }
}

/// How large all is that a group carries.
fn carried(rows: &mut Rows<'_>, scene: &RoomScene, group: &str) {
    let bounds = bounds_of_group(scene.room(), scene.poses(), group);
    if let (Some(texts), Some((low, high))) = (rows.texts, bounds) {
        let size = high - low;
        let values = [("x", size.x), ("y", size.y), ("z", size.z)];
        let values = values.map(|(key, metres)| (key, Value::decimals(metres, 2)));
        let words = texts.say_with("workshop-told-carried", &values);
        rows.words("carried", words, false);
    }
}

/// Which group carries something; none where there is no group that could.
fn of_group(rows: &mut Rows<'_>, groups: &[&str], object: &Object) {
    let others = groups.iter().filter(|it| **it != object.name);
    let none = (String::new(), rows.say("workshop-choice-group-none"));
    let named = others.map(|it| ((*it).to_owned(), (*it).to_owned()));
    let options: Vec<_> = std::iter::once(none).chain(named).collect();
    if options.len() == 1 {
        return;
    }
    let wanted = object.group.as_deref().unwrap_or_default();
    let chosen = options.iter().position(|(word, _)| word == wanted);
    rows.add("group", FieldKind::Choice(options, chosen), true);
}

fn of_solid(rows: &mut Rows<'_>, what: &What) {
    match what {
        What::Box { size }
        | What::Pyramid { size }
        | What::Ramp { size }
        | What::Stairs { size, .. }
        | What::Arch { size, .. } => rows.numbers("size", &size.to_array(), sizes(), true),
        What::Cylinder { radius, height } => {
            rows.numbers("radius", &[*radius], sizes(), true);
            rows.numbers("height", &[*height], sizes(), true);
        }
        What::Ball { radius } => rows.numbers("radius", &[*radius], sizes(), true),
        What::Sign { text, size } => {
            rows.numbers("size", &size.to_array(), sizes(), true);
            let said = text.clone().unwrap_or_default();
            rows.add("text", FieldKind::Text(Some(said)), text.is_none());
        }
        What::Model { scale, .. } => {
            let scales = ((*SCALES.start(), *SCALES.end()), Unit::Times);
            rows.numbers("scale", &[*scale], scales, *scale == 1.0);
        }
        What::Light { colour, power } => {
            rows.colour("colour", *colour, Colour::WHITE);
            let powers = ((*POWERS.start(), *POWERS.end()), Unit::Plain);
            rows.numbers("power", &[*power], powers, true);
        }
        What::Aberration(_) | What::Portal(_) | What::Group => {}
    }
    match what {
        What::Stairs { steps, .. } => {
            let range = (f64::from(*STEPS.start()), f64::from(*STEPS.end()));
            rows.numbers("steps", &[f64::from(*steps)], (range, Unit::Plain), true);
        }
        What::Arch { opening, .. } => {
            rows.numbers("opening", &opening.to_array(), sizes(), true);
        }
        _ => {}
    }
}

fn has_surface(what: &What) -> bool {
    !matches!(
        what,
        What::Model { .. } | What::Light { .. } | What::Portal(_) | What::Group
    )
}

fn of_surface(rows: &mut Rows<'_>, surface: &Surface) {
    let usual = Surface::default();
    rows.colour("colour", surface.colour, usual.colour);
    let has_checker = surface.checker.is_some();
    rows.add(
        "checker",
        FieldKind::Switch(Some(has_checker)),
        !has_checker,
    );
    if let Some(checker) = surface.checker {
        rows.colour("checker-colour", checker.colour, checker.colour);
        rows.numbers("checker-size", &[checker.size], sizes(), true);
    }
    if let Some(picture) = &surface.texture {
        let file = FieldKind::Text(Some(picture.file.clone()));
        rows.add("texture-file", file, false);
        rows.numbers("texture-size", &[picture.size], sizes(), true);
    } else if let Some(texts) = rows.texts {
        rows.words("texture-none", texts.say("workshop-texture-none"), false);
    }
    let finish = match surface.finish {
        Finish::Matt => 0,
        Finish::Mirror => 1,
        Finish::Glass => 2,
    };
    rows.choice("finish", &["matt", "mirror", "glass"], finish, finish == 0);
    let powers = ((*POWERS.start(), *POWERS.end()), Unit::Plain);
    rows.numbers("glow", &[surface.glow], powers, surface.glow == 0.0);
}

fn of_aberration(rows: &mut Rows<'_>, it: &Aberration, alone: bool) {
    let halves = ((2.0 * HALVES_M.start(), 2.0 * HALVES_M.end()), Unit::Metres);
    rows.numbers("box", &(2.0 * it.half).to_array(), halves, true);
    if let (true, Some(texts)) = (alone, rows.texts) {
        for (number, (words, is_warning)) in bent::told(texts, it).into_iter().enumerate() {
            rows.words(&format!("told-{number}"), words, is_warning);
        }
    }
    let is_felt = matches!(it.lengths, Lengths::Felt { .. });
    rows.choice("lengths", &["felt", "stretch"], usize::from(!is_felt), true);
    match it.lengths {
        Lengths::Felt { axis, felt_m } => {
            rows.choice("axis", &["x", "y", "z"], axis.index(), true);
            let length = 2.0 * it.half[axis.index()];
            let range = ((length / 32.0, length * 32.0), Unit::Metres);
            rows.numbers("felt", &[felt_m], range, felt_m == length);
            let times = felt_m / length;
            rows.add("times", FieldKind::Stretch(Some(times)), times == 1.0);
            let thesis = (THESIS, Unit::Plain);
            rows.numbers("thesis", &[thesis_of_stretch(times)], thesis, times == 1.0);
        }
        Lengths::Stretch(stretch) => {
            let alike = (stretch.max_element() - stretch.min_element()).abs() < 1e-9;
            let all = alike.then_some(stretch.x);
            rows.add("times-all", FieldKind::Stretch(all), all == Some(1.0));
            for axis in Axis::ALL {
                let one = stretch[axis.index()];
                let key = ["times-x", "times-y", "times-z"][axis.index()];
                rows.add(key, FieldKind::Stretch(Some(one)), one == 1.0);
            }
        }
    }
    let sides = match it.sides {
        Sides::Walls => 0,
        Sides::Soft => 1,
        Sides::Snell => 2,
        Sides::Legacy { .. } => 3,
    };
    rows.choice(
        "sides",
        &["walls", "soft", "snell", "legacy"],
        sides,
        sides == 0,
    );
    let ways = usize::from(it.ways == Ways::Forward);
    rows.choice("ways", &["both", "forward"], ways, ways == 0);
    rows.add("outline", FieldKind::Switch(Some(it.outline)), !it.outline);
}

fn of_portal(
    rows: &mut Rows<'_>,
    scene: &RoomScene,
    (object, it): (&Object, &Portal),
    alone: bool,
) {
    if let Opening::Size(size) = &it.opening {
        rows.numbers("size", &size.to_array(), sizes(), true);
    }
    let room = scene.room();
    let names: Vec<_> = room
        .portals()
        .map(|(index, _)| room.objects[index].name.clone())
        .collect();
    let partner = names.iter().position(|name| *name == it.to);
    let options = names.into_iter().map(|name| (name.clone(), name)).collect();
    rows.add("to", FieldKind::Choice(options, partner), true);
    let two = usize::from(it.sides == 2);
    rows.choice("sides", &["1", "2"], two, two == 0);
    if let (true, Some(texts)) = (alone, rows.texts) {
        let (words, is_warning) = bent::of_portal(texts, room, scene.space(), &object.name);
        rows.words("told", words, is_warning);
    }
}

fn of_room(texts: &Texts, room: &Room) -> Vec<FieldRow> {
    let usual = Room::new("");
    let mut rows = Rows {
        texts: Some(texts),
        all: Vec::new(),
    };
    rows.add("room-name", FieldKind::Text(Some(room.name.clone())), true);
    let sentence = room.sentence.clone();
    let is_empty = sentence.is_empty();
    rows.add("room-sentence", FieldKind::Text(Some(sentence)), is_empty);
    rows.numbers(
        "spawn-at",
        &room.spawn.at.to_array(),
        far(),
        room.spawn == usual.spawn,
    );
    let turns = ((-360.0, 360.0), Unit::Degrees);
    let looks = room.spawn.look == usual.spawn.look;
    rows.numbers("spawn-look", &room.spawn.look.to_array(), turns, looks);
    let falls = ((-FASTEST_FALL_M_S2, FASTEST_FALL_M_S2), Unit::Plain);
    let gravity = room.gravity.to_array();
    rows.numbers(
        "room-gravity",
        &gravity,
        falls,
        room.gravity == usual.gravity,
    );
    rows.colour("room-sky", room.sky.colour, usual.sky.colour);
    let powers = ((*POWERS.start(), *POWERS.end()), Unit::Plain);
    let light = room.sky.light;
    rows.numbers("room-light", &[light], powers, light == usual.sky.light);
    let has_sun = room.sun.is_some();
    rows.add("room-has-sun", FieldKind::Switch(Some(has_sun)), has_sun);
    if let Some(sun) = room.sun {
        let usual = antipode_rooms::room::Sun::default();
        rows.numbers("room-sun", &sun.aim.to_array(), turns, sun.aim == usual.aim);
        rows.colour("room-sun-colour", sun.colour, usual.colour);
        rows.numbers(
            "room-sun-power",
            &[sun.power],
            powers,
            sun.power == usual.power,
        );
    }
    let has_fog = room.fog.is_some();
    rows.add("room-has-fog", FieldKind::Switch(Some(has_fog)), !has_fog);
    if let Some(fog) = room.fog {
        let reaches = ((1.0, 100_000.0), Unit::Metres);
        rows.numbers("room-fog", &[fog.reach], reaches, true);
        rows.colour("room-fog-colour", fog.colour, Colour::WHITE);
    }
    rows.all
}

/// The numbers of a field of an object, if it has such.
pub fn numbers_of(object: &Object, key: &str) -> Option<Vec<f64>> {
    let three = |it: &DVec3| Some(it.to_array().to_vec());
    let two = |it: &DVec2| Some(it.to_array().to_vec());
    match (key, &object.what) {
        ("at", _) => three(&object.at),
        ("turn", _) => three(&object.turn),
        ("glow", _) => Some(vec![object.surface.glow]),
        (
            "size",
            What::Box { size }
            | What::Pyramid { size }
            | What::Ramp { size }
            | What::Stairs { size, .. }
            | What::Arch { size, .. },
        ) => three(size),
        ("size", What::Sign { size, .. }) => two(size),
        ("size", What::Portal(it)) => match &it.opening {
            Opening::Size(size) => two(size),
            Opening::Polygon(_) => None,
        },
        ("radius", What::Cylinder { radius, .. } | What::Ball { radius }) => Some(vec![*radius]),
        ("height", What::Cylinder { height, .. }) => Some(vec![*height]),
        ("steps", What::Stairs { steps, .. }) => Some(vec![f64::from(*steps)]),
        ("opening", What::Arch { opening, .. }) => two(opening),
        ("scale", What::Model { scale, .. }) => Some(vec![*scale]),
        ("power", What::Light { power, .. }) => Some(vec![*power]),
        ("box", What::Aberration(it)) => three(&(2.0 * it.half)),
        ("felt", What::Aberration(it)) => match it.lengths {
            Lengths::Felt { felt_m, .. } => Some(vec![felt_m]),
            Lengths::Stretch(_) => None,
        },
        _ => None,
    }
}
