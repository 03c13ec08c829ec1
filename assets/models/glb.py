"""Writes a model as one .glb file.

The files follow glTF: metres, y up, the front towards +z, the right-hand side towards -x. While modelling, x is
ahead and z to the right, so (x, y, z) is written (-z, y, x). Numbers are rounded so that the last bit of a machine's
sines does not show.
"""

import json
import struct

FLOAT, U8, U16, U32 = 5126, 5121, 5123, 5125

MATERIALS = {
    "paint": {"roughnessFactor": 0.62, "metallicFactor": 0.0},
    "metal": {"roughnessFactor": 0.32, "metallicFactor": 0.35},
    "rubber": {"roughnessFactor": 0.92, "metallicFactor": 0.0},
    "visor": {"roughnessFactor": 0.08, "metallicFactor": 0.0},
    "glass": {"roughnessFactor": 0.05, "metallicFactor": 0.0, "baseColorFactor": [1.0, 1.0, 1.0, 0.28]},
    "globe": {"roughnessFactor": 0.05, "metallicFactor": 0.0, "baseColorFactor": [1.0, 1.0, 1.0, 0.45]},
    "glow": {"roughnessFactor": 0.5, "metallicFactor": 0.0},
}
GLOWING, CLEAR = ("glow", "globe"), ("glass", "globe")


def place(v):
    return tuple(round(c, 5) + 0.0 for c in (-v[2], v[1], v[0]))


def turn(q):
    x, y, z, w = -q[2], q[1], q[0], q[3]
    size = (x * x + y * y + z * z + w * w) ** 0.5
    return tuple(round(c / size, 6) + 0.0 for c in (x, y, z, w))


class Glb:
    """A file being put together."""

    def __init__(self):
        self.bin = bytearray()
        self.json = {
            "asset": {"version": "2.0", "generator": "Antipode make_models.py"},
            "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "materials": [], "accessors": [],
            "bufferViews": [],
        }

    def accessor(self, kind, component, rows, bounds=False, normalised=False, target=None):
        """Stores rows of numbers; returns the accessor's index."""
        letter = {FLOAT: "f", U8: "B", U16: "H", U32: "I"}[component]
        width = len(rows[0])
        data = struct.pack(f"<{width * len(rows)}{letter}", *(v for row in rows for v in row))
        view = {"buffer": 0, "byteOffset": len(self.bin), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.json["bufferViews"].append(view)
        self.bin += data + b"\0" * (-len(data) % 4)
        out = {"bufferView": len(self.json["bufferViews"]) - 1, "componentType": component, "count": len(rows),
               "type": kind}
        if normalised:
            out["normalized"] = True
        if bounds:
            stored = list(struct.iter_unpack(f"<{width}{letter}", data))
            out["min"] = [min(row[i] for row in stored) for i in range(width)]
            out["max"] = [max(row[i] for row in stored) for i in range(width)]
        self.json["accessors"].append(out)
        return len(self.json["accessors"]) - 1

    def node(self, name, parent=None, at=(0.0, 0.0, 0.0), extras=None):
        """Adds a node `at` from its parent, in modelling axes; returns its index."""
        node = {"name": name}
        if any(at):
            node["translation"] = list(place(at))
        if extras:
            node["extras"] = extras
        self.json["nodes"].append(node)
        index = len(self.json["nodes"]) - 1
        if parent is None:
            self.json["scenes"][0]["nodes"].append(index)
        else:
            self.json["nodes"][parent].setdefault("children", []).append(index)
        return index

    def material(self, name, colour):
        for i, known in enumerate(self.json["materials"]):
            if known["name"] == name:
                return i
        kind = name.split(".")[0]
        out = {"name": name, "pbrMetallicRoughness": MATERIALS[kind]}
        if kind in GLOWING:
            out["emissiveFactor"] = [round(v, 4) for v in colour]
        if kind in CLEAR:
            out["alphaMode"] = "BLEND"
        self.json["materials"].append(out)
        return len(self.json["materials"]) - 1

    def mesh(self, name, model, joints=None):
        """Adds a mesh with a primitive for each material; `joints` numbers the names in its weights."""
        primitives = []
        for material in sorted(model.parts):
            vertices, triangles, _ = model.parts[material]
            if not triangles:
                continue
            attributes = {
                "POSITION": self.accessor("VEC3", FLOAT, [place(v[0]) for v in vertices], bounds=True, target=34962),
                "NORMAL": self.accessor("VEC3", FLOAT, [_unit(place(v[1])) for v in vertices], target=34962),
                "COLOR_0": self.accessor("VEC4", U16, [tuple(round(c * 65535) for c in v[2]) + (65535,)
                                                       for v in vertices], normalised=True, target=34962),
            }
            if joints:
                rows = [_weights(v[3], joints) for v in vertices]
                attributes["JOINTS_0"] = self.accessor("VEC4", U8, [r[0] for r in rows], target=34962)
                attributes["WEIGHTS_0"] = self.accessor("VEC4", U16, [r[1] for r in rows], normalised=True, target=34962)
            indices = self.accessor("SCALAR", U16, [(i,) for t in triangles for i in t], target=34963)
            primitives.append({"attributes": attributes, "indices": indices,
                               "material": self.material(material, vertices[0][2])})
        self.json["meshes"].append({"name": name, "primitives": primitives})
        return len(self.json["meshes"]) - 1

    def skin(self, joints, nodes):
        """A skin over joints at given places, whose axes are the model's in the bind pose."""
        rows = []
        for _, at in joints:
            x, y, z = place(at)
            rows.append((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -x, -y, -z, 1.0))
        self.json.setdefault("skins", []).append(
            {"joints": nodes, "inverseBindMatrices": self.accessor("MAT4", FLOAT, rows), "skeleton": nodes[0]})
        return len(self.json["skins"]) - 1

    def clip(self, name, times, channels, extras):
        """`channels` are (node, path, rows) in file axes."""
        samplers, out = [], []
        clock = self.accessor("SCALAR", FLOAT, [(round(t, 5),) for t in times], bounds=True)
        for node, path, rows in channels:
            steady = all(row == rows[0] for row in rows)
            keys = clock
            if steady:  # One key says it all.
                keys, rows = self._start(), rows[:1]
            kind = "VEC4" if path == "rotation" else "VEC3"
            samplers.append({"input": keys, "output": self.accessor(kind, FLOAT, rows), "interpolation": "LINEAR"})
            out.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})
        self.json.setdefault("animations", []).append(
            {"name": name, "channels": out, "samplers": samplers, "extras": dict(extras, seconds=round(times[-1], 5))})

    def _start(self):
        if not hasattr(self, "start"):
            self.start = self.accessor("SCALAR", FLOAT, [(0.0,)], bounds=True)
        return self.start

    def bytes(self):
        self.json["buffers"] = [{"byteLength": len(self.bin)}]
        text = json.dumps(self.json, separators=(",", ":"), sort_keys=True).encode()
        text += b" " * (-len(text) % 4)
        body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(self.bin), 0x004E4942) + self.bin
        return struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body


def _unit(v):
    size = sum(c * c for c in v) ** 0.5
    return tuple(round(c / size, 5) + 0.0 for c in v)


def _weights(pairs, joints):
    """Four joints and four weights that sum to 65535 exactly."""
    pairs = [(joints[j], round(w * 65535)) for j, w in pairs]
    pairs[0] = (pairs[0][0], pairs[0][1] + 65535 - sum(w for _, w in pairs))
    pairs += [(0, 0)] * (4 - len(pairs))
    return tuple(j for j, _ in pairs), tuple(w for _, w in pairs)
