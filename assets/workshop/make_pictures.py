"""Takes the pictures of what the workshop has ready: python3 assets/workshop/make_pictures.py target/release/antipode

Each kit is put into a room of its own, with the floor that new rooms have, and looked at from where it says below. The pictures
are 320 by 180 pixels and lie beside the kits.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
# Where the feet are, and where one looks: yaw and pitch, degrees.
VIEWS = {
    "house": ((2.6, 0, 5.4), (-118, 4)),
    "tunnel-longer": ((1.3, 0, 4.6), (-105, -4)),
    "tunnel-shorter": ((1.9, 0, 11.5), (-101, -3)),
    "portals": ((2.2, 0, 6.0), (-83, -3)),
    "portals-of-size": ((2.2, 0, 8.5), (-78, 4)),
    "falling-loop": ((4.4, 0, 5.6), (-128, 15)),
}
FLOOR = """(
            name: "floor",
            at: (0, -0.5, 0),
            what: Box(size: (200, 1, 200)),
            surface: (colour: "#9aa094", checker: (colour: "#848a7e", size: 2)),
        ),"""


def three(values):
    return "({})".format(", ".join(str(it) for it in values))


def room(kit, view):
    """The text of the room that a kit is seen in."""
    feet, look = view
    text = (HERE / f"{kit}.ron").read_text()
    begin = f"    sun: (aim: (60, 48)),\n    spawn: (at: {three(feet)}, look: {three(look)}),\n    objects: [\n        {FLOOR}\n"
    return re.sub(r"    objects: \[\n", lambda _: begin, text, count=1)


def main():
    game = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        script = []
        for kit, view in VIEWS.items():
            folder = place / "saves" / "rooms" / kit
            folder.mkdir(parents=True)
            text = room(kit, view)
            (folder / "room.ron").write_text(text)
            name = re.search(r'name: "([^"]+)"', text).group(1)
            script += [f'room load "{name}"', "tap F1", f"shot {kit}.png", "tap F1"]
        file = place / "pictures.txt"
        file.write_text("\n".join(script) + "\n")
        command = [game, "--saves-dir", place / "saves", "--size", "320x180", "script", file]
        subprocess.run(command, cwd=place, check=True)
        for kit in VIEWS:
            (HERE / f"{kit}.png").write_bytes((place / f"{kit}.png").read_bytes())


main()
