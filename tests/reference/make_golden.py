#!/usr/bin/env python3
"""Makes the golden files of the geometry crate in at least 80 digits, by an independent route.

Three files beside this one:
  functions.json   functions of one or two numbers;
  kernels.json     charts, maps, normals, depth, distances, directions, translations, frames;
  strategies.json  whole spaces: a point seen by an eye.
Everything is computed the long way round, from the models' definitions and not from the closed forms
that the game uses: chart, then an explicit isometry that takes the eye to the origin, inverse
cosines for distances, and normals from a numerical differential. Inputs are exact single-precision
numbers (positions of whole spaces: double). Lengths are metres or radii as named, angles radians.

Each file carries a hash (FNV-1a, 64 bits) of this script and one of its own data; a test of the
crate recomputes both, so that neither can be changed alone.

Usage: python3 make_golden.py    (Python 3, mpmath 1.3; rewrites the three files, about a minute)
"""

import json
import math
import random
import struct
from pathlib import Path

from mpmath import mp, mpf, matrix

mp.dps = 80
# Boosts at 350 radii subtract numbers of 304 digits.
FAR_DIGITS = 700
PROJECTION = {"fov_y": 1.2, "aspect": 1.6, "near": 0.0625}


def f32(x):
    """The nearest single-precision number."""
    return struct.unpack("f", struct.pack("f", x))[0]


def inner(sign, a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + sign * a[3] * b[3]


def norm3(v):
    return mp.sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2)


def exponential(q, sign=-1):
    """Exponential chart: straight out by |q|."""
    d = norm3(q)
    n = [x / d for x in q] if d else [mpf(0)] * 3
    return [x * sine(sign, d) for x in n] + [cosine(sign, d)]


def transport(q, sign=-1):
    """T(q): the frame at q by parallel transport along the ray; three vectors."""
    d = norm3(q)
    if d == 0:
        return [[mpf(i == j) for j in range(4)] for i in range(3)]
    n = [x / d for x in q]
    frame = []
    for i in range(3):
        v = [mpf(i == j) for j in range(3)]
        a = n[i]
        turned = [v[j] + (cosine(sign, d) - 1) * a * n[j] for j in range(3)]
        frame.append(turned + [-sign * sine(sign, d) * a])
    return frame


def sine(sign, t):
    return mp.sin(t) if sign > 0 else mp.sinh(t)


def cosine(sign, t):
    return mp.cos(t) if sign > 0 else mp.cosh(t)


def cylindrical(p, sign=1):
    """Cylindrical chart: out by r, then up by y, each along a geodesic."""
    r = mp.sqrt(p[0] ** 2 + p[2] ** 2)
    c = [p[0] / r, p[2] / r] if r else [mpf(1), mpf(0)]
    foot = [sine(sign, r) * c[0], mpf(0), sine(sign, r) * c[1], cosine(sign, r)]
    up = [mpf(0), mpf(1), mpf(0), mpf(0)]
    return [cosine(sign, p[1]) * a + sine(sign, p[1]) * b for a, b in zip(foot, up)]


def cylindrical_frame(p, sign=1):
    """Orthonormal frame for chart directions x, y, z: Gram-Schmidt on radius and up."""
    r = mp.sqrt(p[0] ** 2 + p[2] ** 2)
    c = [p[0] / r, p[2] / r] if r else [mpf(1), mpf(0)]
    s = -sign * sine(sign, r)
    radial = [cosine(sign, r) * c[0], mpf(0), cosine(sign, r) * c[1], s]
    across = [-c[1], mpf(0), c[0], mpf(0)]
    foot = [sine(sign, r) * c[0], mpf(0), sine(sign, r) * c[1], cosine(sign, r)]
    fall = -sign * sine(sign, p[1])
    up = [fall * foot[0], cosine(sign, p[1]), fall * foot[2], fall * foot[3]]
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
        self.level = case["level"]
        self.sign = {"euclidean": 0, "hyperbolic": -1, "spherical": 1}[self.kind]
        self.radius = mpf(case["radius"])
        self.eye = case["eye"]
        self.offset = mpf(self.eye["dial"]) / self.radius
        if self.level:
            # The dial over 80 m is the curvature; it bends flat pictures to either side.
            k = mpf(self.eye["dial"]) / 80
            self.sign = -1 if k > 0 else 1 if k < 0 else 0
            self.radius = 1 / abs(k) if k else mpf(1)

    def local(self, point):
        """The chart coordinates that the map's chart is taken at, in radii."""
        p = [mpf(x) / self.radius for x in point["pos"]]
        if self.kind == "spherical":
            return p
        e = [mpf(x) / self.radius for x in self.eye["pos"]]
        u = [a - b for a, b in zip(p, e)]
        if self.level:
            u[1] += mpf(self.eye["lift"]) / self.radius
        elif self.sign:
            u[1] += self.offset
        return u

    def model(self, point):
        u = self.local(point)
        if self.kind == "spherical":
            return place(point["hemisphere"], cylindrical, u)
        if self.sign == 0:
            return u + [mpf(1)]
        return cylindrical(u, self.sign) if self.level else exponential(u)

    def frame(self, point):
        u = self.local(point)
        if self.kind == "spherical":
            return place_frame(point["hemisphere"], u)
        if self.sign == 0:
            return [[mpf(i == j) for j in range(4)] for i in range(3)]
        return cylindrical_frame(u, self.sign) if self.level else transport(u)

    def view(self, point):
        """Components along the camera's tangents at the eye, and along the eye itself."""
        x = self.model(point)
        frame = self.frame(self.eye)
        e = self.model(self.eye)
        if self.sign == 0:
            x = [a - b for a, b in zip(x, e)]
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
        elif self.sign > 0 and self.level:
            depth = near * (1 + v[3]) / 2
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


def make(rng, geometry, radius, eye, point, level=False):
    case = {
        "geometry": geometry,
        "level": level,
        "radius": radius,
        "eye": {
            "hemisphere": eye[0],
            "pos": eye[1],
            "dial": eye[2],
            "lift": 1.625,
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


def level_case(rng, geometry, dial, distance, far_away=0.0):
    """The horizon map and the bend; `far_away` moves eye and point from the world's origin."""
    eye_pos = [round(rng.uniform(-500, 500) * 64) / 64 + far_away for _ in range(3)]
    v = direction(rng)
    scale = distance / math.dist(v, [0, 0, 0])
    pos = [a + round(b * scale * 1024) / 1024 for a, b in zip(eye_pos, v)]
    return make(rng, geometry, 20.0, ("A", eye_pos, dial), ("A", pos), level=True)


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
    for dial in (1e-6, 1e-3, 0.5, 5.0, 10.0, 20.0):
        for distance in (0.5, 7.0, 40.0, 76.0):
            out.append(level_case(rng, "hyperbolic", dial, distance))
            out.append(level_case(rng, "euclidean", dial, distance))
            bent = min(distance, 1.2 * 80 / dial)
            out.append(level_case(rng, "euclidean", -dial, bent))
    out += [level_case(rng, "euclidean", 0.0, distance) for distance in (0.5, 40.0)]
    for far_away in (1e6, 1e8):
        out += [level_case(rng, "hyperbolic", 10.0, 30.0, far_away) for _ in range(3)]
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
                "level": case["level"],
                "radius": case["radius"],
                "eye": case["eye"],
                "a": a,
                "b": b,
                "distance": float(Space(case).distance(a, b)),
            }
        )
    return out


def spread(low, high, count):
    """Single-precision numbers from low to high, evenly in their logarithm."""
    step = (math.log(high) - math.log(low)) / (count - 1)
    return [f32(math.exp(math.log(low) + i * step)) for i in range(count)]


def beside(x):
    """A number and its neighbours in single precision."""
    bits = struct.unpack("I", struct.pack("f", x))[0]
    return [struct.unpack("f", struct.pack("I", bits + i))[0] for i in (-1, 0, 1)]


def over(t, value, limit):
    return value(t) / t if t else mpf(limit)


def sinc(sign, t):
    if sign == 0:
        return mpf(1)
    return over(t, lambda t: sine(sign, t), 1)


def functions():
    """Rows of arguments, then answers."""
    out = {}
    tiny = [0.0] + spread(1e-38, 1e-3, 24)
    right = [x for edge in (3.2, (math.pi / 2) ** 2) for x in beside(edge)]
    far = [f32(9.8696) - i * f32(0.0009765625) for i in (0, 1, 7)]
    s = tiny + right + far + spread(1e-3, 9.8, 60)
    out["sinc_cos"] = [[x, sinc(1, mp.sqrt(mpf(x))), mp.cos(mp.sqrt(mpf(x)))] for x in s]
    t = tiny + beside(1.0) + beside(2.0) + spread(1e-3, 80.0, 100)
    out["sinhc_cosh"] = [[x, sinc(-1, mpf(x)), mp.cosh(mpf(x))] for x in t]
    wide = spread(80.5, 350.0, 20)
    out["sinhc_cosh_wide"] = [[x, sinc(-1, mpf(x)), mp.cosh(mpf(x))] for x in wide]
    out["exp"] = [[x, mp.exp(mpf(x))] for x in tiny + spread(1e-3, 80.0, 80) + [87.5]]
    rows = []
    for x in tiny + right + far + spread(1e-3, 9.8, 40):
        rows.append([x, sinc(1, mp.sqrt(mpf(x))), mp.cos(mp.sqrt(mpf(x)))])
    for x in tiny + beside(1.0) + beside(4.0) + spread(1e-3, 6400.0, 50):
        rows.append([-x, sinc(-1, mp.sqrt(mpf(x))), mp.cosh(mp.sqrt(mpf(x)))])
    out["sine_cosine"] = rows
    rows = []
    for sign, top in ((1, 9.8), (-1, 3.99)):
        for x in [1e-38, 1e-20] + spread(1e-9, top, 50):
            root = mp.sqrt(mpf(x))
            rows.append([x, sign, (sinc(sign, root) - 1) / root**2])
        rows.append([0.0, sign, -sign * mpf(1) / 6])
    out["sinc_bend"] = rows
    rows = []
    for x in [0.0] + spread(1e-37, 1e6, 60) + [x for e in (0.5, 1.0, 2.0) for x in beside(e)]:
        for c in (1.0, -1.0, f32(0.3), 0.0, f32(-0.77)):
            rows.append([x, c, mp.atan2(mpf(x), mpf(c)) if x or c else mpf(0)])
    out["angle"] = rows
    x = [0.0] + beside(0.75) + beside(1e4) + spread(1e-38, 1e37, 120)
    out["asinh"] = [[v, mp.asinh(mpf(v))] for v in x]
    rows = []
    for sign in (-1, 0, 1):
        for t in [1e-30, 1e-8, 1e-4, 0.03, 0.3, 0.499, 0.51, 1.0, 1.9, 2.0, 2.1, 3.1] + spread(1e-6, 20, 20):
            t = mpf(t)
            if sign > 0 and t > 3.2:
                continue
            c = cosine(sign, t) if sign else mpf(1)
            rows.append(
                [sign, t, sinc(sign, t), sinc(sign, t) * t, c, (c - 1) / t**2, (sinc(sign, t) - 1) / t**2]
            )
    out["scalar"] = rows
    rows, arcs, angles, inverses = [], [], [], []
    for kappa in [0.0] + [x for k in spread(1e-30, 0.0625, 12) for x in (k, -k)]:
        sign, k = (kappa > 0) - (kappa < 0), mp.sqrt(abs(mpf(kappa)))
        for x in (0.0, 1e-8, 0.5, 3.0, 11.0):
            t = mpf(f32(x))
            rows.append([kappa, t, sinc(sign, k * t) * t, cosine(sign, k * t) if sign else mpf(1)])
            if sign <= 0:
                arcs.append([kappa, t, mp.asinh(k * t) / k if k else t])
            else:
                angles.append([kappa, t, mpf(0.625), mp.atan2(k * t, mpf(0.625)) / k])
        if sign:
            c = mpf(0.625 if sign > 0 else 1.625)
            inverses.append([kappa, c, (mp.acos(c) if sign > 0 else mp.acosh(c)) / k])
    out.update({"sin_cos_k": rows, "asin_k": arcs, "atan_k": angles, "acos_k": inverses})
    rows = []
    for size in spread(1e-37, 1e18, 40):
        v = [f32(x * size) for x in (0.3, -0.6, 0.2)]
        length = norm3([mpf(x) for x in v])
        rows.append(v + [length] + [mpf(x) / length for x in v])
    out["length"] = rows
    return out


def chart_points(rng, distances):
    out = []
    for d in distances:
        v = direction(rng)
        scale = d / math.dist(v, [0, 0, 0])
        out.append([f32(x * scale) for x in v])
    return out


def inverse_transpose(model, frame, sign, p, n):
    """J^-T n at p, with J the differential of the chart in its own frame."""
    step = mpf(10) ** -(mp.dps // 3)
    jacobian = matrix(3, 3)
    for j in range(3):
        ends = [[x + s * (i == j) for i, x in enumerate(p)] for s in (step, -step)]
        high, low = (model(end) for end in ends)
        slope = [(a - b) / (2 * step) for a, b in zip(high, low)]
        for i in range(3):
            jacobian[i, j] = inner(sign, frame[i], slope)
    out = mp.lu_solve(jacobian.T, matrix(n))
    length = norm3(out)
    return [out[i] / length for i in range(3)]


def exact(values):
    return [mpf(x) for x in values]


def charts(rng, out):
    near = [0.0, 1e-38, 1e-20, 1e-8, 1e-4, 0.02, 0.3, 0.999, 1.001, 1.6, 1.999, 2.001, 2.6, 3.0]
    mp.dps = 300
    for name, chart, framed in (
        ("exponential", exponential, transport),
        ("cylindrical", cylindrical, cylindrical_frame),
    ):
        points, directions, normals = [], [], []
        # Products of two hyperboloid coordinates end the cylindrical chart sooner.
        far = [5.0, 8.0, 20.0, 36.0, 79.5 if chart is exponential else 54.0]
        for sign, distances in ((1, near + [3.14159]), (-1, near + far)):
            for p in chart_points(rng, distances * 2):
                q, v = exact(p), [f32(x) for x in direction(rng)]
                points.append([sign] + p + chart(q, sign))
                frame = framed(q, sign)
                directions.append([sign] + p + v + combine(frame, exact(v)))
                past = norm3(q) > 3.1 or (chart is cylindrical and abs(p[1]) > 1.5)
                if norm3(q) < 1e-30 or (sign > 0 and past):
                    continue
                normals.append(
                    [sign] + p + v
                    + inverse_transpose(lambda p: chart(p, sign), frame, sign, q, exact(v))
                )
        out[name + "_point"] = points
        out[name + "_direction"] = directions
        out[name + "_normal"] = normals
    mp.dps = FAR_DIGITS
    for name, chart in (("exponential", exponential), ("cylindrical", cylindrical)):
        rows = chart_points(rng, [100.0, 200.0, 349.0])
        out[name + "_point_wide"] = [[-1] + p + chart(exact(p), -1) for p in rows]
    mp.dps = 80


def sphere_spots(rng, radius):
    """Poles, equator to the last ulp, beyond it, and the far end of the uprights."""
    rim = f32(math.pi / 2 * radius)
    levels = [0.0, 1e-6, 0.3 * radius, radius, 1.7 * radius] + beside(rim)
    out = []
    for r in levels:
        for y in (0.0, 0.15 * radius, 1.2 * radius, -0.4 * radius):
            angle = rng.uniform(-math.pi, math.pi)
            out.append([f32(r * math.cos(angle)), f32(y), f32(r * math.sin(angle))])
        out.append([f32(r), f32(0.2 * radius), 0.0])
    return out


def spheres(rng, out):
    rows, ported, directions, normals = [], [], [], []
    for hemisphere in "AB":
        b = int(hemisphere == "B")
        for p in sphere_spots(rng, 1.0):
            q, v = exact(p), [f32(x) for x in direction(rng)]
            rows.append([b] + p + place(hemisphere, cylindrical, q))
            frame = place_frame(hemisphere, q)
            directions.append([b] + p + v + combine(frame, exact(v)))
            model = lambda p: place(hemisphere, cylindrical, p)
            normals.append([b] + p + v + inverse_transpose(model, frame, 1, q, exact(v)))
        for radius in (16.0, 32.0, 48.0):
            k = f32(1.0 / radius)
            for p in sphere_spots(rng, radius):
                x = place(hemisphere, cylindrical, [mpf(a) * mpf(k) for a in p])
                ported.append([k, b] + p + [a / mpf(k) for a in x[:3]] + [x[3]])
    out["sphere_point"] = rows
    out["sphere_direction"] = directions
    out["sphere_normal"] = normals
    out["sphere_port"] = ported


def boosted(model, up, eye, sign, radius):
    """Components along the chart's upright frame at the eye, xyz in metres."""
    level = [[1, 0, 0, 0], up, [0, 0, 1, 0]]
    xyz = [inner(sign, [mpf(a) for a in axis], model) * radius for axis in level]
    return xyz + [sign * inner(sign, eye, model)]


def raised(radius, offset, u):
    radius, h = mpf(radius), mpf(offset) / mpf(radius)
    q = [mpf(x) / radius for x in u]
    x = exponential([q[0], q[1] + h, q[2]])
    eye, up = [0, mp.sinh(h), 0, mp.cosh(h)], [0, mp.cosh(h), 0, mp.sinh(h)]
    return boosted(x, up, eye, -1, radius)


def horizon(kappa, lift, u):
    if kappa == 0:
        return [mpf(x) for x in u] + [mpf(1)]
    sign, radius = (1 if kappa > 0 else -1), 1 / mp.sqrt(abs(mpf(kappa)))
    h = mpf(lift) / radius
    q = [mpf(x) / radius for x in u]
    x = cylindrical([q[0], q[1] + h, q[2]], sign)
    eye, up = [0, sine(sign, h), 0, cosine(sign, h)], [0, cosine(sign, h), 0, -sign * sine(sign, h)]
    return boosted(x, up, eye, sign, radius)


def maps(rng, out):
    mp.dps = FAR_DIGITS
    ports, normals, wide = [], [], []
    for radius in (20.0, 1024.0):
        for offset in (0.0, 1e-6, 0.5, 10.0, 20.0):
            distances = [0.0, 1e-30, 1e-12, 1e-4, 0.05, 0.5, 1.0, 1.9, 2.1, 3.0, 6.0, 12.0, 20.0, 50.0, 78.0]
            points = chart_points(rng, [d * radius for d in distances])
            # The offset centre, straight down, straight up, level.
            points += [[0.0, -offset, 0.0], [f32(1e-6), -3 * radius, 0.0], [0.0, 30.0, 0.0], [30.0, 0.0, 0.0]]
            points += [[f32(1e-3), f32(-offset + d), 0.0] for d in (1e-3, -1e-3)]
            for u in points:
                ports.append([radius, offset] + u + raised(radius, offset, u))
                if norm3(exact(u)) > 1e-9 and norm3(exact(u)) < 60 * radius:
                    v = [f32(x) for x in direction(rng)]
                    q = [mpf(x) / radius for x in u]
                    q[1] += mpf(offset) / mpf(radius)
                    if norm3(q) > 1e-9:
                        n = inverse_transpose(exponential, transport(q), -1, q, exact(v))
                        normals.append([radius, offset] + u + v + n)
            for u in chart_points(rng, [150.0 * radius, 345.0 * radius]):
                wide.append([radius, offset] + u + raised(radius, offset, u))
    out.update({"raised_port": ports, "raised_normal": normals, "raised_port_wide": wide})
    ports, normals = [], []
    curvatures = [1e-30, 1e-14, 1e-8, 1e-5, 1e-3, 0.004, 0.015625, 0.0625]
    for kappa in [0.0] + [f32(x) for k in curvatures for x in (k, -k)]:
        k = math.sqrt(abs(kappa))
        reach = (1.4 if kappa > 0 else 37.0) / k if k else 300.0
        distances = [0.0, 1e-6, 0.01, 1.0] + [x * reach for x in (0.02, 0.03, 0.1, 0.3, 0.54, 1.0)]
        for lift in (0.0, 1.625):
            points = chart_points(rng, [min(d, 3e4) for d in distances])
            points += [[f32(0.2 / k if k else 1.0), f32(y * min(reach, 300.0)), 0.0] for y in (-0.9, 0.5, 0.9)]
            if kappa > 0:
                points = [p for p in points if abs(p[1] + lift) * k < 1.49]
            for u in points:
                ports.append([kappa, lift] + u + horizon(kappa, lift, u))
                v = [f32(x) for x in direction(rng)]
                if kappa == 0:
                    n = [mpf(x) / norm3(exact(v)) for x in v]
                else:
                    sign = 1 if kappa > 0 else -1
                    root = mp.sqrt(abs(mpf(kappa)))
                    q = [mpf(x) * root for x in u]
                    q[1] += mpf(lift) * root
                    model = lambda p: cylindrical(p, sign)
                    n = inverse_transpose(model, cylindrical_frame(q, sign), sign, q, exact(v))
                normals.append([kappa, lift] + u + v + n)
    out.update({"horizon_port": ports, "horizon_normal": normals})
    mp.dps = 80


def depths(rng, out):
    rows = []
    for sign, ends in ((-1, (1e-3, 1.0, 8.0, 20.0, 40.0)), (1, (1e-3, 1.0, 1.5708, 2.0, 3.0))):
        for d in ends:
            v = direction(rng)
            scale = 20.0 * float(sine(sign, mpf(d))) / math.dist(v, [0, 0, 0])
            view = [f32(x * scale) for x in v] + [f32(float(cosine(sign, mpf(d))))]
            near, k = f32(0.05), f32(0.05)
            x = exact(view)
            answers = [
                mpf(near) / (x[3] + mpf(k) * norm3(x[:3])),
                (mpf(near) * x[3] - x[2]) / 2,
                mpf(near) * (1 + x[3]) / 2,
            ]
            rho = norm3(x[:3]) * mpf(k)
            away = (mp.asinh(rho) if sign < 0 else mp.atan2(rho, x[3])) * 20
            rows.append([sign, near, k] + view + answers + [away])
    out["depth"] = rows


def tangent(sign, a, b):
    """The part of b at right angles to a, at unit length."""
    along = inner(sign, a, b) * sign
    v = [y - along * x for x, y in zip(a, b)]
    length = mp.sqrt(inner(sign, v, v))
    return [x / length for x in v]


def distances(rng, out):
    rows = []
    for sign, sizes in ((-1, spread(1e-8, 1.0, 17)), (1, spread(1e-8, 1.5, 17))):
        for size in sizes * 2:
            p, q = chart_points(rng, [size, size])
            a, b = (exponential(exact(v), sign) for v in (p, q))
            c = inner(sign, a, b) * sign
            d = mp.acos(c) if sign > 0 else mp.acosh(c)
            rows.append([sign] + p + q + [d] + tangent(sign, a, b))
    # From the eye to the far end of the sphere.
    for gap in (1.0, 0.1, 1e-3, 1e-5, 3e-7):
        for q in chart_points(rng, [math.pi - gap]):
            a, b = [mpf(0)] * 3 + [mpf(1)], exponential(exact(q), 1)
            rows.append([1, 0.0, 0.0, 0.0] + q + [mp.acos(b[3])] + tangent(1, a, b))
    out["chords"] = rows
    mp.dps = FAR_DIGITS
    rows = []
    for size in (1e-6, 0.1, 3.0, 20.0, 79.0, 300.0):
        p, q = chart_points(rng, [size, size * 0.75])
        a, b = (exponential(exact(v)) for v in (p, q))
        rows.append(p + q + [mp.acosh(-inner(-1, a, b))])
    out["hyperbolic_far"] = rows
    mp.dps = 80


def frames(rng, out):
    rows = []
    for sign, ends in ((1, [0.0, 1e-20, 1e-3, 1.0, 1.57, 3.0, 3.1405, 3.1415925]), (-1, [0.0, 1e-3, 1.0, 3.0, 8.0])):
        for q in chart_points(rng, ends * 2):
            x = exact(q)
            frame = transport(x, sign) + [exponential(x, sign)]
            rows.append([sign] + q + [v for axis in frame for v in axis])
    out["translation"] = rows
    rows = []
    for sign in (1, -1):
        for q in chart_points(rng, [0.0, 0.5, 1.5]):
            frame = transport(exact(q), sign) + [exponential(exact(q), sign)]
            bent = [[f32(float(x) + rng.uniform(-1e-3, 1e-3)) for x in axis] for axis in frame]
            x, y, z, point = (exact(axis) for axis in bent)
            done = []
            for v in (point, x, y, z):
                for other in done:
                    part = inner(sign, v, other) / inner(sign, other, other)
                    v = [a - part * b for a, b in zip(v, other)]
                length = mp.sqrt(abs(inner(sign, v, v)))
                done.append([a / length for a in v])
            done = done[1:] + done[:1]
            rows.append([sign] + [v for axis in bent for v in axis] + [v for axis in done for v in axis])
    out["orthonormalized"] = rows


def kernels(rng):
    out = {}
    for part in (charts, spheres, maps, depths, distances, frames):
        part(rng, out)
    return out


def fnv(data):
    """FNV-1a, 64 bits."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return f"{value:016x}"


def text_of(value):
    if isinstance(value, list):
        lines = ",\n".join(json.dumps(numbers(row) if isinstance(row, list) else row) for row in value)
        return f"[\n{lines}\n]"
    return json.dumps(value)


def write(name, tables):
    data = "{\n" + ",\n".join(f"{json.dumps(key)}: {text_of(value)}" for key, value in tables.items()) + "\n}"
    script = fnv(Path(__file__).read_bytes())
    text = f'{{\n"generator": "{script}",\n"content": "{fnv(data.encode())}",\n"data": {data}\n}}\n'
    Path(__file__).with_name(name).write_text(text, encoding="utf-8")


def main():
    rng = random.Random(20)
    made = cases(rng)
    write("strategies.json", {"projection": PROJECTION, "ports": made, "pairs": pairs(rng, made)})
    write("functions.json", functions())
    write("kernels.json", kernels(rng))


if __name__ == "__main__":
    main()
