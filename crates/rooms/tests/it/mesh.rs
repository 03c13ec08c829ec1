//! Triangles of solids: closed, facing outward, as large as they say.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::Arc;

use antipode_rooms::aberration::{Aberration, Axis, Lengths, Sides, Ways};
use antipode_rooms::mesh::{Roundness, Shape, WALL_INSIDE_M, WALL_OUTSIDE_M, meshes, shape};
use antipode_rooms::room::{Object, What};
use antipode_rooms::{Assets, Room};
use glam::{DVec2, DVec3};

const ROUND: Roundness = Roundness { around: 96 };

fn made(what: &What) -> Shape {
    shape(what, ROUND).unwrap()
}

fn assert_sound(shape: &Shape, what: &str) {
    for corners in &shape.triangles {
        let [a, b, c] = corners.map(|it| shape.positions[it as usize]);
        let plane = (b - a).cross(c - a);
        assert!(plane.length() > 0.0, "{what}: a triangle without area");
        for corner in corners {
            let normal = shape.normals[*corner as usize];
            assert!((normal.length() - 1.0).abs() < 1e-9, "{what}: {normal}");
            assert!(
                normal.dot(plane.normalize()) > 0.9,
                "{what}: a normal against its triangle"
            );
        }
    }
    assert_eq!(shape.positions.len(), shape.normals.len());
    assert_eq!(shape.positions.len(), shape.uvs.len());
}

/// A picture as large as a side of a block fills it, wherever the block's middle is.
#[test]
fn pictures_begin_at_the_edges_of_blocks_and_stairs() {
    let size = DVec3::new(2.0, 3.0, 4.0);
    for what in [What::Box { size }, What::Stairs { size, steps: 5 }] {
        let shape = shape(&what, ROUND).unwrap();
        for axis in DVec3::AXES {
            let lies = |(normal, _): &(&DVec3, &DVec2)| normal.dot(axis) > 0.999;
            let uvs = shape.normals.iter().zip(&shape.uvs).filter(lies);
            let (least, most) = uvs.fold((DVec2::INFINITY, DVec2::ZERO), |(a, b), (_, uv)| {
                (a.min(*uv), b.max(*uv))
            });
            let (across, up) = match axis {
                DVec3::X => (4.0, 3.0),
                DVec3::Y => (2.0, 4.0),
                _ => (2.0, 3.0),
            };
            assert!(least.abs().max_element() < 1e-9, "{what:?} {axis} {least}");
            let off = most - DVec2::new(across, up);
            assert!(off.abs().max_element() < 1e-9, "{what:?} {axis} {most}");
        }
    }
}

/// Rows of a picture count from above.
#[test]
fn pictures_stand_upright_on_sides() {
    let (radius, height) = (1.0, 3.0);
    let solids = [
        What::Box { size: DVec3::ONE },
        What::Ball { radius },
        What::Cylinder { radius, height },
        What::Pyramid { size: DVec3::ONE },
    ];
    for what in solids {
        let shape = shape(&what, ROUND).unwrap();
        for corners in &shape.triangles {
            let [a, b, c] = corners.map(|it| {
                let it = it as usize;
                (shape.positions[it], shape.uvs[it], shape.normals[it])
            });
            let is_side = a.2.y.abs() < 0.9;
            for (one, other) in [(a, b), (b, c), (c, a)] {
                let (higher, down) = (one.0.y - other.0.y, one.1.y - other.1.y);
                assert!(!is_side || higher * down < 1e-9, "{what:?} {higher} {down}");
            }
        }
    }
}

#[test]
fn solids_hold_what_a_ruler_finds() {
    let size = DVec3::new(2.0, 3.0, 4.0);
    let stairs: f64 = (1..=5)
        .map(|step| 2.0 / 5.0 * 3.0 / 5.0 * f64::from(step) * 4.0)
        .sum();
    let polygon = 96.0 / 2.0 * (2.0 * PI / 96.0).sin();
    let arch = 24.0 - 2.0 * (1.5 * (2.0 - 0.75) + polygon / 2.0 * 0.75 * 0.75);
    let cases = [
        (What::Box { size }, 24.0),
        (What::Pyramid { size }, 8.0),
        (What::Ramp { size }, 12.0),
        (What::Stairs { size, steps: 5 }, stairs),
        (
            What::Cylinder {
                radius: 2.0,
                height: 3.0,
            },
            polygon * 4.0 * 3.0,
        ),
        (
            What::Arch {
                size,
                opening: DVec2::new(1.5, 2.0),
            },
            arch,
        ),
        (
            What::Sign {
                text: None,
                size: DVec2::new(2.0, 1.0),
            },
            2.0 * 1.0 * 0.04,
        ),
    ];
    for (what, volume) in cases {
        let shape = made(&what);
        let found = shape.volume_m3();
        assert!(
            (found - volume).abs() < 1e-9,
            "{}: {found} for {volume}",
            what.kind()
        );
        assert_sound(&shape, what.kind());
    }
    let ball = made(&What::Ball { radius: 2.0 });
    assert!((ball.volume_m3() / (4.0 / 3.0 * PI * 8.0) - 1.0).abs() < 2e-3);
    assert_sound(&ball, "ball");
    assert!(
        ball.positions
            .iter()
            .all(|it| (it.length() - 2.0).abs() < 1e-12)
    );
}

#[test]
fn solids_are_closed() {
    // Of stairs and arches edges meet in the middle of others; of these, each edge has its opposite.
    let size = DVec3::new(2.0, 3.0, 4.0);
    let round = [
        What::Cylinder {
            radius: 2.0,
            height: 3.0,
        },
        What::Ball { radius: 2.0 },
    ];
    for what in [
        What::Box { size },
        What::Pyramid { size },
        What::Ramp { size },
    ]
    .into_iter()
    .chain(round)
    {
        let shape = made(&what);
        let key = |it: u32| {
            (shape.positions[it as usize] * 1e6)
                .round()
                .to_array()
                .map(|it| it as i64)
        };
        let mut edges: HashMap<_, i32> = HashMap::new();
        for [a, b, c] in &shape.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry((key(*from), key(*to))).or_default() += 1;
                *edges.entry((key(*to), key(*from))).or_default() -= 1;
            }
        }
        assert!(edges.values().all(|it| *it == 0), "{}", what.kind());
    }
}

#[test]
fn ramps_and_stairs_rise_to_their_front_and_gates_lead_to_it() {
    let size = DVec3::new(4.0, 2.0, 1.0);
    let height_at = |shape: &Shape, x: f64| {
        let near = shape.positions.iter().filter(|it| (it.x - x).abs() < 1e-9);
        near.map(|it| it.y).fold(f64::MIN, f64::max)
    };
    let ramp = made(&What::Ramp { size });
    assert_eq!((height_at(&ramp, -2.0), height_at(&ramp, 2.0)), (-1.0, 1.0));
    let stairs = made(&What::Stairs { size, steps: 4 });
    assert_eq!(
        (
            height_at(&stairs, -2.0),
            height_at(&stairs, -1.0),
            height_at(&stairs, 2.0)
        ),
        (-0.5, 0.0, 1.0)
    );
    // Nothing of an arch stands in its gate.
    let arch = made(&What::Arch {
        size: DVec3::new(1.0, 4.0, 4.0),
        opening: DVec2::new(2.0, 3.0),
    });
    let is_in_gate = |it: &DVec3| it.z.abs() < 0.9 && it.y < -0.1;
    assert!(!arch.positions.iter().any(is_in_gate));
}

#[test]
fn walls_stand_where_no_doors_are() {
    let it = Aberration {
        half: DVec3::new(1.0, 2.0, 5.0),
        lengths: Lengths::Felt {
            axis: Axis::Z,
            felt_m: 50.0,
        },
        sides: Sides::Walls,
        ways: Ways::Both,
        outline: false,
    };
    let walls = made(&What::Aberration(it));
    assert_sound(&walls, "walls");
    // Open along z: no corner is nearer to the middle than a wall's inner face.
    let nearest = walls
        .positions
        .iter()
        .map(|it| it.abs())
        .reduce(DVec3::min)
        .unwrap();
    let wanted = DVec3::new(1.0 - WALL_INSIDE_M, 2.0 - WALL_INSIDE_M, 5.0);
    assert!((nearest - wanted).length() < 1e-12, "{nearest}");
    let most = walls.positions.iter().copied().reduce(DVec3::max).unwrap();
    assert_eq!(
        most,
        DVec3::new(1.0 + WALL_OUTSIDE_M, 2.0 + WALL_OUTSIDE_M, 5.0)
    );
    for sides in [Sides::Soft, Sides::Snell] {
        assert!(shape(&What::Aberration(Aberration { sides, ..it }), ROUND).is_none());
    }
}

#[test]
fn equal_solids_share_their_triangles_and_stand_where_they_are_said_to() {
    let mut room = Room::new("a");
    for (name, x) in [("a", 1.0), ("b", 2.0)] {
        room.push(Object::new(
            name,
            DVec3::new(x, 0.0, 0.0),
            What::Ball { radius: 1.0 },
        ));
    }
    room.object_mut(1).turn.x = 90.0;
    let made = meshes(&room, &Assets::default(), ROUND);
    assert_eq!(made.len(), 3);
    assert!(Arc::ptr_eq(&made[1].shape, &made[2].shape));
    assert_eq!(made[2].pose.translation, DVec3::new(2.0, 0.0, 0.0));
    // Its front looks where `aim 90 0` does.
    assert!((made[1].pose.transform_vector3(DVec3::X) - DVec3::Z).length() < 1e-12);
}
