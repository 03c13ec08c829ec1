#!/usr/bin/env python3
"""Makes the strips of pictures of doors in worlds that lie beside it.

    python3 docs/pictures/doors/strips.py path/to/antipode      needs ImageMagick's montage

In each space somebody walks through, stands in the door, and looks back; a car drives through, and a bullet flies through.
"""

import json
import os
import subprocess
import sys
import tempfile

SIZE = "320x180"
HERE = os.path.dirname(os.path.abspath(__file__))
# Seed, where the doors are looked for, the charts of both, and the way that who goes through looks.
WORLDS = {
    "euclidean": (5, (6.0, 2.0), (34.0, -48.0), ""),
    "hyperbolic": (5, (6.0, 2.0), (34.0, -48.0), ""),
    "spherical": (12, (4.0, 0.0), (12.0, -10.0), "B"),
}


def run(program, script, place):
    path = os.path.join(place, "script")
    with open(path, "w", encoding="utf-8") as file:
        file.write(script)
    done = subprocess.run(
        [program, "script", path, "--saves-dir", place, "--adapter", "software", "--size", SIZE], check=True, capture_output=True, text=True, cwd=place)
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith('{"t"')]


def door(pos, chart):
    return "spawn door " + " ".join(f"{x:.3f}" for x in pos) + (f" {chart}" if chart else "") + "\n"


def begun(space):
    return f"new {space} seed={WORLDS[space][0]} generator=1\nset npcs off\nsettle\nset time 120\ntap F1\n"


def ground(program, space, place):
    """Where doors can stand: about the places of a world, where cars that are let fall before, on and behind it stand level."""
    _, near, far, chart = WORLDS[space]
    first = "A" if chart else ""
    feet = run(program, begun(space) + "probe\n", place)[-1]["player"]["pos"]
    if not chart:
        far = (feet[0] + far[0], feet[2] + far[1])
    found = []
    for (x, z), where in (((feet[0] + near[0], feet[2] + near[1]), first), (far, chart)):
        strips = []
        for row in range(3):
            script = begun(space)
            for line in range(5):
                for ahead in (-5.0, 0.0, 5.0):
                    at = (x + 13.0 * (row - 1) + ahead, feet[1] + 9.0, z + 9.0 * (line - 2))
                    script += "spawn car " + " ".join(f"{it:.3f}" for it in at) + f" {where}\n"
            cars = run(program, script + "settle\nwait 5\nprobe\n", place)[-1]["cars"][-15:]
            strips += [cars[at:at + 3] for at in range(0, len(cars) - 2, 3)]

        def level(cars):
            heights = [car["pos"][1] for car in cars]
            is_in_line = abs(cars[0]["pos"][0] + cars[2]["pos"][0] - 2 * cars[1]["pos"][0]) < 2.0
            return is_in_line, min(car["upright"] for car in cars) - 0.15 * (max(heights) - min(heights))

        found.append(max(strips, key=level)[1]["pos"])
    return found


def shots(count, name, between):
    return "".join(between + f"shot {name}{at}.png\n" for at in range(count))


def strip(place, name, count):
    pictures = [os.path.join(place, f"{name}{at}.png") for at in range(count)]
    target = os.path.join(HERE, f"{name}.png")
    subprocess.run(["montage", *pictures, "-tile", f"{count}x1", "-geometry", "224x126+3+3", "-background", "#202428",
                    "+dither", "-colors", "200", "PNG8:" + target], check=True)


def main():
    program = os.path.abspath(sys.argv[1])
    for space in sys.argv[2:] or WORLDS:
        with tempfile.TemporaryDirectory() as place:
            doors = ground(program, space, place)
            chart = WORLDS[space][3]
            near, far = doors
            first = "A" if chart else ""
            begin = begun(space) + door(near, first) + door(far, chart)

            def stand(back, aside=0.0):
                at = (near[0] - back, near[1] + 0.8, near[2] + aside)
                return "teleport " + " ".join(f"{x:.3f}" for x in at) + f" {first}\nsettle\nwait 1\ntap Digit1\n"

            walk = f"{space}-walk"
            run(program, begin + stand(2.6) + "aim 0 -4\n" + f"shot {walk}0.png\n"
                + "hold KeyW 0.45\n" + f"shot {walk}1.png\n" + "hold KeyW 0.35\n" + f"shot {walk}2.png\n"
                + "hold KeyW 0.5\naim 180 -4\n" + f"shot {walk}3.png\n", place)
            strip(place, walk, 4)
            astride = f"{space}-astride"
            run(program, begin + stand(2.0) + "tap Tab\naim 0 -8\nwait 1\n" + f"shot {astride}0.png\n"
                + "hold KeyW 0.3\nwait 0.3\n" + f"shot {astride}1.png\n" + "hold KeyW 0.12\nwait 0.3\n"
                + f"shot {astride}2.png\n" + "hold KeyW 0.4\nwait 0.5\n" + f"shot {astride}3.png\n", place)
            strip(place, astride, 4)
            car = f"{space}-car"
            at = (near[0] - 6.5, near[1] + 1.0, near[2])
            spawned = "spawn car " + " ".join(f"{x:.3f}" for x in at) + f" {first}\n"
            run(program, begin + stand(6.5, -2.2) + spawned + "wait 2\naim 90 -10\nwait 0.2\ntap KeyC\nwait 1\n"
                + "down KeyW\nwait 1.2\n" + shots(6, car, "wait 0.3\n"), place)
            strip(place, car, 6)
            bullet = f"{space}-bullet"
            run(program, begin + stand(2.2) + "aim 0 -3\nclick LEFT\n" + shots(4, bullet, "wait 0.034\n"), place)
            strip(place, bullet, 4)


if __name__ == "__main__":
    main()
