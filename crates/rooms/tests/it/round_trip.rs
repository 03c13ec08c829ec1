//! What is written is read as the same, and written as the same again.

use antipode_rooms::aberration::{Aberration, Axis, Exit, Lengths, Sides, Ways};
use antipode_rooms::room::{Checker, Finish, Fog, Object, Surface, Texture, What};
use antipode_rooms::{Colour, Room, check, read, write};
use glam::{DVec2, DVec3};
use proptest::prelude::*;

fn three(range: std::ops::Range<f64>) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(range).prop_map(DVec3::from)
}

fn colour() -> impl Strategy<Value = Colour> {
    any::<[u8; 3]>().prop_map(Colour)
}

fn aberration() -> impl Strategy<Value = What> {
    let lengths = prop_oneof![
        (0..3_usize, 0.04..30.0_f64)
            .prop_map(|(axis, times)| (Some(Axis::ALL[axis]), DVec3::splat(times))),
        three(0.04..30.0).prop_map(|stretch| (None, stretch)),
    ];
    let exit = prop::sample::select(vec![Exit::Original, Exit::Inverse, Exit::Nothing]);
    let sides = prop_oneof![
        Just(Sides::Walls),
        Just(Sides::Soft),
        Just(Sides::Snell),
        exit.prop_map(|exit| Sides::Legacy { exit })
    ];
    (three(0.05..0.4), lengths, sides, any::<[bool; 2]>()).prop_map(
        |(half, (axis, times), sides, [forward, outline])| {
            let lengths = match axis {
                Some(axis) => Lengths::Felt {
                    axis,
                    felt_m: 2.0 * half[axis.index()] * times.x,
                },
                None => Lengths::Stretch(times),
            };
            let sides = if axis.is_none() && sides == Sides::Walls {
                Sides::Soft
            } else {
                sides
            };
            let ways = if axis.is_some() && forward {
                Ways::Forward
            } else {
                Ways::Both
            };
            What::Aberration(Aberration {
                half,
                lengths,
                sides,
                ways,
                outline,
            })
        },
    )
}

fn what() -> impl Strategy<Value = What> {
    let size = || three(0.01..1000.0);
    prop_oneof![
        size().prop_map(|size| What::Box { size }),
        size().prop_map(|size| What::Pyramid { size }),
        size().prop_map(|size| What::Ramp { size }),
        (0.01..1000.0, 0.01..1000.0).prop_map(|(radius, height)| What::Cylinder { radius, height }),
        (0.01..1000.0).prop_map(|radius| What::Ball { radius }),
        (size(), 1..200_u32).prop_map(|(size, steps)| What::Stairs { size, steps }),
        three(0.1..1000.0).prop_map(|size| What::Arch {
            size,
            opening: DVec2::new(size.z.min(size.y) / 2.0, size.y / 2.0)
        }),
        (0.001..1000.0).prop_map(|scale| What::Model {
            file: "models/a b.glb".to_owned(),
            scale
        }),
        (colour(), 0.0..1000.0).prop_map(|(colour, power)| What::Light { colour, power }),
        aberration(),
        prop::option::of("[ -~äß世]{0,60}").prop_map(|text| What::Sign {
            text,
            size: DVec2::new(1.0, 0.5)
        }),
        Just(What::Group),
    ]
}

fn surface() -> impl Strategy<Value = Surface> {
    let checker = (colour(), 0.01..9.0).prop_map(|(colour, size)| Checker { colour, size });
    let texture = (0.01..9.0).prop_map(|size| Texture {
        file: "textures/x.png".to_owned(),
        size,
    });
    let finish = prop::sample::select(vec![Finish::Matt, Finish::Mirror, Finish::Glass]);
    (
        colour(),
        prop::option::of(checker),
        prop::option::of(texture),
        0.0..9.0,
        finish,
    )
        .prop_map(|(colour, checker, texture, glow, finish)| Surface {
            colour,
            checker,
            texture,
            glow,
            finish,
        })
}

fn room() -> impl Strategy<Value = Room> {
    let object = (
        three(-40.0..40.0),
        three(-360.0..360.0),
        what(),
        surface(),
        any::<bool>(),
    );
    let fog = (colour(), 1.0..1000.0).prop_map(|(colour, reach)| Fog { colour, reach });
    let light = |it: &What| matches!(it, What::Light { .. });
    (
        "[a-zA-Zé\"\\\\ -]{0,20}x",
        prop::option::of(fog),
        prop::collection::vec(object, 0..12),
    )
        .prop_map(move |(name, fog, objects)| {
            let mut room = Room::new(&name);
            room.fog = fog;
            room.sentence = format!("It is \"{name}\".");
            for (index, (at, turn, what, surface, grouped)) in objects.into_iter().enumerate() {
                let lights = room.objects.iter().filter(|it| light(&it.what)).count();
                if light(&what) && lights == 8 {
                    continue;
                }
                // In a row, so that no aberration meets another.
                let at = if matches!(what, What::Aberration(_)) {
                    DVec3::new(3.0 * index as f64, 0.0, 0.0)
                } else {
                    at
                };
                let group = room
                    .objects
                    .iter()
                    .find(|it| it.what == What::Group && grouped)
                    .map(|it| it.name.clone());
                let in_group =
                    group.is_some() && !matches!(what, What::Group | What::Aberration(_));
                let mut object = Object::new(&format!("thing {index}"), at, what);
                object.turn = turn;
                object.surface = surface;
                object.group = group.filter(|_| in_group);
                room.push(object);
            }
            room
        })
}

proptest! {
    #[test]
    fn what_is_written_is_read_as_the_same(room in room()) {
        prop_assert_eq!(check(&room), Ok(()));
        let text = write(&room).unwrap();
        let again = read("room.ron", text.as_bytes()).map_err(|error| TestCaseError::fail(format!("{error}\n{text}")))?;
        prop_assert_eq!(&again, &room);
        prop_assert_eq!(write(&again).unwrap(), text);
    }

    #[test]
    fn one_change_of_a_room_changes_one_line(room in room(), at in 0..200_usize) {
        let before = write(&room).unwrap();
        let mut room = room;
        let index = at % room.objects.len();
        room.object_mut(index).surface.glow = 7.25;
        let after = write(&room).unwrap();
        let changed = after.lines().filter(|line| !before.contains(line)).count();
        prop_assert!(changed <= 1, "{changed} lines");
    }

    #[test]
    fn no_text_makes_it_panic(text in "[(){}\\[\\]:,\"a-z0-9 .#/*\\n-]{0,200}") {
        let _ = read("room.ron", text.as_bytes());
        let _ = read("room.ron", format!("(version: 1, name: \"a\", objects: [{text}])").as_bytes());
    }
}

#[test]
fn what_is_not_sound_is_not_written() {
    let mut room = Room::new("a");
    room.object_mut(0).at.x = f64::NAN;
    let said = write(&room).unwrap_err().to_string();
    assert!(said.starts_with("at of \"floor\" is to be"), "{said}");
}
