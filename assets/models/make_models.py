#!/usr/bin/env python3
"""Makes every model of the game and the pictures of what can be held.

    python3 assets/models/make_models.py              writes the files beside this script
    python3 assets/models/make_models.py --check      fails where a file differs from what would be written
    python3 assets/models/make_models.py --pictures   draws the sheets in docs/pictures/models as well

Only Python's own library is used. Shapes are in shapes.py, the figures in astronaut.py and moves.py, everything else
in things.py; glb.py writes the files, and picture.py is the renderer of the icons.
"""

import json
import struct
import sys
import zlib
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import things  # noqa: E402
from astronaut import JOINTS, TEAL, WHITE, astronaut  # noqa: E402
from glb import Glb, place, turn  # noqa: E402
from moves import clips  # noqa: E402
from picture import Picture, png  # noqa: E402
from vectors import IDENTITY, add, sub  # noqa: E402

HERE = Path(__file__).resolve().parent
# name -> (what is drawn, the middle of the picture, how much of it, from which side and height in degrees)
ICONS = {
    "gun": (things.gun, (0.075, 0.03, 0.0), 0.40, 62.0, 20.0),
    "bullet": (things.bullet, (0.0, 0.0, 0.0), 0.165, 48.0, 32.0),
    "wooden_pickaxe": (things.wooden_pickaxe, (0.0, 0.13, 0.0), 0.78, 68.0, 18.0),
    "iron_pickaxe": (things.iron_pickaxe, (0.0, 0.13, 0.0), 0.78, 68.0, 18.0),
    "diamond_pickaxe": (things.diamond_pickaxe, (0.0, 0.13, 0.0), 0.78, 68.0, 18.0),
    "lamp": (things.lamp, (0.0, 0.232, 0.0), 0.53, 62.0, 16.0),
    "flag": (things.flag, (0.2, 1.22, 0.0), 1.06, 66.0, 12.0),
    "log": (things.log, (0.0, 0.6, 0.0), 1.42, 52.0, 24.0),
    "stone": (things.stone, (0.0, 0.22, 0.0), 0.72, 40.0, 24.0),
    "seed": (things.seed, (0.0, 0.036, 0.0), 0.105, 40.0, 18.0),
    "crumb": (things.crumb, (0.0, 0.075, 0.0), 0.30, 40.0, 24.0),
    "door": (things.door, (0.0, 1.16, 0.0), 2.75, 38.0, 12.0),
}
ICON_PX = 128


def figure(colours, kind):
    """An astronaut's file: skeleton, skin and clips."""
    model, out = astronaut(colours, kind), Glb()
    root = out.node("astronaut")
    nodes = {}
    for name, (parent, at) in JOINTS.items():
        above = JOINTS[parent][1] if parent else (0.0, 0.0, 0.0)
        nodes[name] = out.node(name, nodes.get(parent, root), sub(at, above))
    # What is held hangs from its joint, which moves no part of the body.
    bones = [name for name in JOINTS if name != "hold.R"]
    skin = out.skin([(name, JOINTS[name][1]) for name in bones], [nodes[name] for name in bones])
    body = out.node("body", root)
    out.json["nodes"][body].update(
        mesh=out.mesh("body", model, {name: i for i, name in enumerate(bones)}), skin=skin)
    for name, (times, poses, extras) in clips().items():
        moving = [j for j in JOINTS if any(j in pose for pose in poses)]
        if "layer" not in extras:  # A whole-body clip says where every joint is, so nothing of another shines through.
            moving = bones
        channels = [(nodes[j], "rotation", [turn(pose.get(j, IDENTITY)) for pose in poses]) for j in moving]
        if "layer" not in extras:
            channels.append((nodes["hips"], "translation", [place(pose["place"]) for pose in poses]))
        out.clip(name, times, channels, extras)
    return out.bytes()


def car():
    out = Glb()
    root = out.node("car")
    out.json["nodes"][out.node("body", root)]["mesh"] = out.mesh("body", things.car())
    meshes = {sign: out.mesh("wheel", things.wheel(sign)) for sign in (-1.0, 1.0)}
    for name, at in things.WHEELS.items():
        out.json["nodes"][out.node(name, root, at)]["mesh"] = meshes[1.0 if at[2] > 0 else -1.0]
    return out.bytes()


def single(name, model):
    out = Glb()
    out.json["nodes"][out.node(name)]["mesh"] = out.mesh(name, model)
    return out.bytes()


def icon(name):
    make, middle, span, heading, height = ICONS[name]
    picture = Picture(ICON_PX, ICON_PX, 3)
    camera = picture.camera(middle, heading, height, span)
    if "pickaxe" in name or name == "log":
        camera.roll(-38.0)
    picture.model(camera, make())
    return png(ICON_PX, ICON_PX, picture.pixels())


def files():
    """name -> bytes."""
    out = {"astronaut.glb": figure(WHITE, "round"), "astronaut_teal.glb": figure(TEAL, "wide"), "car.glb": car()}
    for name, (make, *_) in ICONS.items():
        out[f"{name}.glb"] = single(name, make())
    for name in ICONS:
        out[f"icon_{name}.png"] = icon(name)
    return out


def _unpacked(data):
    """A PNG without its compression, which differs between zlibs."""
    if data[:4] != b"\x89PNG":
        return data
    out, at, packed = [], 8, b""
    while at < len(data):
        size = struct.unpack(">I", data[at : at + 4])[0]
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        packed += body if kind == b"IDAT" else b""
        out.append((kind, body if kind == b"IHDR" else b""))
        at += 12 + size
    return out[0], zlib.decompress(packed)


def main():
    made = files()
    if "--check" in sys.argv:
        wrong = [name for name, data in made.items()
                 if not (HERE / name).exists() or _unpacked((HERE / name).read_bytes()) != _unpacked(data)]
        for name in wrong:
            print(f"{name} is not what make_models.py writes")
        return 1 if wrong else 0
    for name, data in made.items():
        (HERE / name).write_bytes(data)
        print(f"{name}: {len(data)} bytes")
    if "--pictures" in sys.argv:
        from sheets import draw_sheets

        draw_sheets(HERE.parent.parent / "docs" / "pictures" / "models")
    return 0


if __name__ == "__main__":
    sys.exit(main())
