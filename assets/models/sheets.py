"""Contact sheets of all models and clips, for people to look at."""

import math

import things
from astronaut import TEAL, WHITE, astronaut
from moves import clips, posed, skinned
from picture import Picture, small_png
from vectors import add, rotate

SIZE = (640, 360)


def background(_):
    """A plain grey blue, which packs best and lets white stand out."""
    return (0.34, 0.40, 0.47)


def _shifted(at):
    return lambda v: (add(v[0], at), v[1])


def figures():
    picture = Picture(*SIZE)
    for row, (colours, kind) in enumerate(((WHITE, "round"), (TEAL, "wide"))):
        model = astronaut(colours, kind)
        for column, heading in enumerate((6.0, 50.0, 94.0, 142.0)):
            camera = picture.camera((0.0, 0.9, 0.0), heading, 10.0, 2.0, (160 * column, 180 * row, 160, 180))
            picture.model(camera, model)
            picture.shadow(camera, (0.0, 0.0, 0.0), 0.5)
    return picture


def car():
    picture, body = Picture(*SIZE), things.car()
    for cell, heading in enumerate((42.0, 3.0, 90.0, 222.0)):
        camera = picture.camera((0.0, 0.72, 0.0), heading, 14.0, 2.3, (320 * (cell % 2), 180 * (cell // 2), 320, 180))
        for at in things.WHEELS.values():
            picture.model(camera, things.wheel(at[2]), _shifted(at))
        picture.model(camera, body)
        picture.shadow(camera, (0.0, 0.0, 0.0), 1.8)
    return picture


def held(icons):
    picture = Picture(*SIZE)
    columns = math.ceil(len(icons) / 2)
    wide = SIZE[0] // columns
    for cell, (make, middle, span, heading, height) in enumerate(icons.values()):
        place = (wide * (cell % columns), 180 * (cell // columns), wide, 180)
        picture.model(picture.camera(middle, heading, height, span * 1.12, place), make())
    return picture


def moves(names, heading, columns=8):
    """A row of frames for each clip; one frame only for the hold, which carries the gun."""
    picture, model, known = Picture(*SIZE, samples=2), astronaut(WHITE, "round"), clips()
    wide, high = SIZE[0] // columns, SIZE[1] // len(names)
    for row, name in enumerate(names):
        _, poses, extras = known[name]
        last = len(poses) - 1
        for column in range(columns):
            pose = posed(poses[column * last // (columns if extras["loop"] else columns - 1)])
            aim = (0.35, 0.75, 0.0) if name == "die" else (0.0, 0.86, 0.0)
            span = 1.9 * max(1.0, 0.62 * high / wide) * (1.5 if name == "die" else 1.15)
            camera = picture.camera(aim, heading, 8.0, span, (column * wide, row * high, wide, high))
            picture.model(camera, model, lambda v, pose=pose: skinned(pose, v[0], v[1], v[3]))
            if name == "hold":
                _held(picture, camera, pose)
            picture.shadow(camera, (pose["place"][0], 0.0, 0.0), 0.5)
    return picture


def _held(picture, camera, pose):
    q, at = pose["joints"]["hold.R"]
    picture.model(camera, things.gun(), lambda v: (add(at, rotate(q, v[0])), rotate(q, v[1])))


def draw_sheets(folder):
    from make_models import ICONS

    folder.mkdir(parents=True, exist_ok=True)
    sheets = {
        "astronauts": figures, "car": car, "held": lambda: held(ICONS), "walk_run": lambda: moves(("walk", "run"), 86.0),
        "jump_fall": lambda: moves(("jump", "fall"), 66.0), "idle_hold": lambda: moves(("idle", "hold"), 52.0),
        "hit_die": lambda: moves(("hit", "die"), 74.0), "sit_rest": lambda: moves(("sit", "rest", "perch"), 60.0),
    }
    for name, make in sheets.items():
        data = small_png(*SIZE, make().pixels(background), 160)
        (folder / f"{name}.png").write_bytes(data)
        print(f"{name}.png: {len(data)} bytes")
