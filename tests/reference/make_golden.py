#!/usr/bin/env python3
"""Makes geometry.json: the port, normals, depth and distances in 80-digit arithmetic.

Everything here is computed the long way round, from the models' definitions and not from the
closed forms that the game uses: chart, then an explicit isometry that takes the eye to the
origin, and normals from a numerical differential. Lengths are metres, angles radians.

Usage: python3 make_golden.py    (needs mpmath 1.3; rewrites geometry.json beside this file)
"""

import json
import math
import random
import struct
from pathlib import Path

from mpmath import mp, mpf, matrix

mp.dps = 80
PROJECTION = {"fov_y": 1.2, "aspect": 1.6, "near": 0.0625}


def f32(x):
    """The nearest single-precision number."""
    return struct.unpack("f", struct.pack("f", x))[0]


def inner(sign, a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + sign * a[3] * b[3]


def norm3(v):
    return mp.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2)


def exponential(q):
    """Hyperbolic exponential chart."""
    d = norm3(q)
    s = mp.sinh(d) / d if d else mpf(1)
    return [q[0] * s, q[1] * s, q[2] * s, mp.cosh(d)]


def transport(q):
    """T(q): the hyperbolic frame at q by parallel transport along the ray; three vectors."""
    d = norm3(q)
    if d == 0:
        return [[mpf(i == j) for j in range(4)] for i in range(3)]
    n = [x / d for x in q]
    frame = []
    for i in range(3):
        v = [mpf(i == j) for j in range(3)]
        a = n[i]
        frame.append([v[j] + (mp.cosh(d) - 1) * a * n[j] for j in range(3)] + [mp.sinh(d) * a])
    return frame


def cylindrical(p):
    """Spherical cylindrical chart: turn up by y, out by r, each along a great circle."""
    r = mp.sqrt(p[0] ** 2 + p[2] ** 2)
    c = [p[0] / r, p[2] / r] if r else [mpf(1), mpf(0)]
    foot = [mp.sin(r) * c[0], mpf(0), mp.sin(r) * c[1], mp.cos(r)]
    up = [mpf(0), mpf(1), mpf(0), mpf(0)]
    return [mp.cos(p[1]) * a + mp.sin(p[1]) * b for a, b in zip(foot, up)]


def cylindrical_frame(p):
    """Orthonormal frame for chart directions x, y, z: Gram-Schmidt on radius and up."""
    r = mp.sqrt(p[0] ** 2 + p[2] ** 2)
    c = [p[0] / r, p[2] / r] if r else [mpf(1), mpf(0)]
    radial = [mp.cos(r) * c[0], mpf(0), mp.cos(r) * c[1], -mp.sin(r)]
    across = [-c[1], mpf(0), c[0], mpf(0)]
    foot = [mp.sin(r) * c[0], mpf(0), mp.sin(r) * c[1], mp.cos(r)]
    up = [-mp.sin(p[1]) * foot[0], mp.cos(p[1]), -mp.sin(p[1]) * foot[2], -mp.sin(p[1]) * foot[3]]
    x = [c[0] * a - c[1] * b for a, b in zip(radial, across)]
    z = [c[1] * a + c[0] * b for a, b in zip(radial, across)]
    return [x, up, z]


def place(hemisphere, map_point, p):
    """Hemisphere B: mirror the chart in x, then negate w."""
    q = [-p[0], p[1], p[2]] if hemisphere == "B" else list(p)
    flip = -1 if hemisphere == "B" else 1
    x = map_point(q)
    return x[:3] + [flip * x[3]]


def place_frame(hemisphere, p):
    flip = -1 if hemisphere == "B" else 1
    q = [flip * p[0], p[1], p[2]]
    frame = [v[:3] + [flip * v[3]] for v in cylindrical_frame(q)]
    frame[0] = [flip * a for a in frame[0]]  # the chart's x is mirrored
    return frame


def axes(eye):
    """Camera axes (right, up, back) as chart directions."""
    cy, sy = mp.cos(mpf(eye["yaw"])), mp.sin(mpf(eye["yaw"]))
    cp, sp = mp.cos(mpf(eye["pitch"])), mp.sin(mpf(eye["pitch"]))
    front = [cy * cp, sp, sy * cp]
    right = [-sy, mpf(0), cy]
    up = [
        right[1] * front[2] - right[2] * front[1],
        right[2] * front[0] - right[0] * front[2],
        right[0] * front[1] - right[1] * front[0],
    ]
    return [right, up, [-a for a in front]]


def combine(frame, v):
    return [sum(v[i] * frame[i][j] for i in range(3)) for j in range(4)]


class Space:
    """One case's space: `model` ports a chart point, `frame` is the chart's frame there."""

    def __init__(self, case):
        self.kind = case["geometry"]
        self.sign = {"euclidean": 0, "hyperbolic": -1, "spherical": 1}[self.kind]
        self.radius = mpf(case["radius"])
        self.eye = case["eye"]
        self.offset = mpf(self.eye["dial"]) / self.radius

    def model(self, point):
        p = [mpf(x) / self.radius for x in point["pos"]]
        if self.kind == "spherical":
            return place(point["hemisphere"], cylindrical, p)
        e = [mpf(x) / self.radius for x in self.eye["pos"]]
        u = [a - b for a, b in zip(p, e)]
        if self.kind == "euclidean":
            return u + [mpf(1)]
        return exponential([u[0], u[1] + self.offset, u[2]])

    def frame(self, point):
        p = [mpf(x) / self.radius for x in point["pos"]]
        if self.kind == "spherical":
            return place_frame(point["hemisphere"], p)
        if self.kind == "euclidean":
            return [[mpf(i == j) for j in range(4)] for i in range(3)]
        e = [mpf(x) / self.radius for x in self.eye["pos"]]
        u = [a - b for a, b in zip(p, e)]
        return transport([u[0], u[1] + self.offset, u[2]])

    def view(self, point):
        """Components along the camera's tangents at the eye, and along the eye itself."""
        x = self.model(point)
        frame = self.frame(self.eye)
        e = self.model(self.eye)
        rows = [combine(frame, axis) for axis in axes(self.eye)]
        out = [inner(self.sign, row, x) * self.radius for row in rows]
        w = mpf(1) if self.sign == 0 else self.sign * inner(self.sign, e, x)
        return out + [w]

    def distance(self, a, b):
        x, y = self.model(a), self.model(b)
        if self.sign == 0:
            return norm3([s - t for s, t in zip(x, y)]) * self.radius
        c = inner(self.sign, x, y) * self.sign
        return (mp.acosh(c) if self.sign < 0 else mp.acos(c)) * self.radius

    def normal(self, point, n):
        """J^-T n, with J the differential of the port in the chart's own frame."""
        frame = self.frame(point)
        step = mpf(10) ** -25
        jacobian = matrix(3, 3)
        for j in range(3):
            ends = []
            for s in (step, -step):
                moved = [mpf(x) for x in point["pos"]]
                moved[j] += s
                ends.append(self.model({"hemisphere": point["hemisphere"], "pos": moved}))
            slope = [(a - b) / (2 * step) for a, b in zip(*ends)]
            for i in range(3):
                jacobian[i, j] = inner(self.sign, frame[i], slope)
        out = mp.lu_solve(jacobian.T, matrix([mpf(x) for x in n]))
        length = norm3(out)
        return [out[i] / length for i in range(3)]

    def clip(self, v):
        sy = 1 / mp.tan(mpf(PROJECTION["fov_y"]) / 2)
        sx = sy / mpf(PROJECTION["aspect"])
        near = mpf(PROJECTION["near"])
        depth = near
        if self.sign < 0:
            rho = norm3(v[:3]) / self.radius
            depth = near * mp.exp(-mp.asinh(rho))
        elif self.sign > 0:
            depth = (near * v[3] - v[2]) / 2
        return [sx * v[0], sy * v[1], depth, -v[2]]


def numbers(values):
    return [float(v) for v in values]


def direction(rng):
    while True:
        v = [rng.uniform(-1, 1) for _ in range(3)]
        if 0.1 < math.dist(v, [0, 0, 0]) < 1:
            return v


def flat_or_raised(rng, geometry, radius, distance, dial):
    """The eye anywhere, the point `distance` metres from it, both exact in binary."""
    eye_pos = [round(rng.uniform(-500, 500) * 64) / 64 for _ in range(3)]
    if distance < 0.01:
        eye_pos = [0.0, 0.0, 0.0]
    v = direction(rng)
    scale = distance / math.dist(v, [0, 0, 0])
    pos = [a + f32(b * scale) for a, b in zip(eye_pos, v)]
    return make(rng, geometry, radius, ("A", eye_pos, dial), ("A", pos))


def chart_spot(rng, radius, level=None):
    r = rng.uniform(0, 1.6) if level is None else level
    angle, y = rng.uniform(-math.pi, math.pi), rng.uniform(0.1, 1.1)
    return [f32(x * radius) for x in (r * math.cos(angle), y, r * math.sin(angle))]


def make(rng, geometry, radius, eye, point):
    case = {
        "geometry": geometry,
        "radius": radius,
        "eye": {
            "hemisphere": eye[0],
            "pos": eye[1],
            "dial": eye[2],
            "yaw": rng.uniform(-math.pi, math.pi),
            "pitch": rng.uniform(-1.5, 1.5),
        },
        "point": {"hemisphere": point[0], "pos": point[1]},
        "normal": [f32(x) for x in direction(rng)],
    }
    space = Space(case)
    view = space.view(case["point"])
    case["view"] = numbers(view)
    case["distance"] = float(space.distance(case["eye"], case["point"]))
    case["clip"] = numbers(space.clip(view))
    case["frame_normal"] = numbers(space.normal(case["point"], case["normal"]))
    return case


def cases(rng):
    out = []
    for distance in (1e-3, 1.0, 30.0, 400.0, 3000.0):
        out += [flat_or_raised(rng, "euclidean", 1.0, distance, 10.0) for _ in range(3)]
    for distance in (1e-6, 1e-3, 0.1, 2.0, 13.0, 20.0, 60.0, 150.0, 300.0, 390.0):
        for dial in (0.0, 0.5, 10.0, 20.0):
            for radius in (20.0, 1024.0):
                out.append(flat_or_raised(rng, "hyperbolic", radius, distance, dial))
    for radius in (16.0, 32.0, 64.0):
        for pair in ("AA", "AB", "BA", "BB"):
            for _ in range(5):
                eye = (pair[0], chart_spot(rng, radius), 0.0)
                out.append(make(rng, "spherical", radius, eye, (pair[1], chart_spot(rng, radius))))
        for level in (0.0, 1e-7, math.pi / 2, math.pi / 2 + 0.2):
            eye = ("A", chart_spot(rng, radius, math.pi / 2), 0.0)
            out.append(make(rng, "spherical", radius, eye, ("B", chart_spot(rng, radius, level))))
    return out


def pairs(rng, made):
    """Distances between two points, near each other and far apart."""
    out = []
    for case in made:
        near = rng.choice([1e-6, 1e-2, 5.0])
        v = direction(rng)
        a = case["point"]
        b = {"hemisphere": a["hemisphere"], "pos": [x + near * y for x, y in zip(a["pos"], v)]}
        out.append(
            {
                "geometry": case["geometry"],
                "radius": case["radius"],
                "eye": case["eye"],
                "a": a,
                "b": b,
                "distance": float(Space(case).distance(a, b)),
            }
        )
    return out


def scalars():
    out = []
    for t in [1e-30, 1e-8, 1e-4, 0.03, 0.3, 0.499, 0.51, 1.0, 1.9, 2.1, 3.1, 8.0, 20.0]:
        t = mpf(t)
        row = {
            "t": t,
            "sinc": mp.sin(t) / t,
            "sinhc": mp.sinh(t) / t,
            "cos_bend": (mp.cos(t) - 1) / t**2,
            "cosh_bend": (mp.cosh(t) - 1) / t**2,
            "sinc_bend": (mp.sin(t) / t - 1) / t**2,
            "sinhc_bend": (mp.sinh(t) / t - 1) / t**2,
        }
        out.append({k: float(v) for k, v in row.items()})
    return out


def main():
    rng = random.Random(20)
    made = cases(rng)
    golden = {
        "projection": PROJECTION,
        "scalars": scalars(),
        "ports": made,
        "pairs": pairs(rng, made),
    }
    rows = []
    for key, value in golden.items():
        if isinstance(value, list):
            lines = ",\n".join(json.dumps(row) for row in value)
            rows.append(f"{json.dumps(key)}: [\n{lines}\n]")
        else:
            rows.append(f"{json.dumps(key)}: {json.dumps(value)}")
    text = "{\n" + ",\n".join(rows) + "\n}\n"
    Path(__file__).with_name("geometry.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
