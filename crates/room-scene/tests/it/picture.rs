//! What pictures of rooms are drawn of.

use std::convert::Infallible;

use antipode_rays::{Pattern, RayScene};
use antipode_room_scene::{RoomScene, SignBoard};
use antipode_rooms::What;
use image::RgbaImage;

use crate::room;

fn drawn(scene: &RoomScene, boards: &mut Vec<SignBoard>) -> RayScene {
    let made: Result<_, Infallible> = scene.ray_scene(|board| {
        boards.push(board.clone());
        Ok(RgbaImage::new(4, 4))
    });
    made.unwrap()
}

#[test]
fn everything_that_stands_in_a_room_is_drawn_once() {
    for shipped in antipode_rooms::shipped::ROOMS {
        let scene = room(shipped.id);
        let mut boards = Vec::new();
        let picture = drawn(&scene, &mut boards);
        let objects = &scene.room().objects;
        for (index, object) in objects.iter().enumerate() {
            let count = picture
                .instances
                .iter()
                .filter(|it| it.object as usize == index)
                .count();
            let wanted = match object.what {
                _ if object.mass.is_some() => 0,
                What::Aberration(_) | What::Portal(_) | What::Light { .. } | What::Group => 0,
                // The board, and what is written on it.
                What::Sign { .. } => 2,
                _ => 1,
            };
            assert_eq!(count, wanted, "{}: {}", shipped.id, object.name);
        }
        let loose: Vec<_> = scene.room().loose().map(|(index, ..)| index).collect();
        let moves = scene.now().things;
        for index in loose {
            let count = moves
                .iter()
                .filter(|it| it.object as usize == index)
                .count();
            assert_eq!(count, 1, "{}: {}", shipped.id, objects[index].name);
        }
        let boxes = scene.room().aberrations().count();
        assert_eq!(picture.aberrations.placed().len(), boxes);
        assert_eq!(picture.wall_materials.len(), boxes);
        let mut walls = picture.wall_materials.iter();
        assert!(walls.all(|it| *it < picture.materials.len()));
        assert!(boards.iter().any(|it| it.text == scene.room().sentence));
    }
}

#[test]
fn surfaces_look_as_the_file_says() {
    let scene = room("long-house");
    let picture = drawn(&scene, &mut Vec::new());
    let floor = &picture.materials[picture.instances[0].materials];
    assert!(
        (floor.colour.x - 0.238).abs() < 0.01,
        "#86 is {} of light",
        floor.colour.x
    );
    let Pattern::Checker { edge_m, .. } = floor.pattern else {
        panic!("{floor:?}");
    };
    assert_eq!(edge_m, 3.0);
    assert!(picture.sun.unwrap().direction.y > 0.5);
}
