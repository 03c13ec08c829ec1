"""Solids of few triangles: lofts, superellipsoids, rounded boxes and wheels.

Axes while modelling are the game's: x ahead, y up, z to the right, metres. A Piece holds points and faces; its
normals are averaged over the faces at a point that bend by less than the crease angle, so one rule gives both soft
curves and crisp edges.
"""

import math

from vectors import add, cross, dot, length, linear, mul, sub, unit

TAU = 2.0 * math.pi


class Model:
    """Triangles by material, ready to be written."""

    def __init__(self):
        self.parts = {}  # material name -> (vertices, triangles)

    def part(self, material):
        return self.parts.setdefault(material, ([], [], {}))

    def triangles(self):
        return sum(len(part[1]) for part in self.parts.values())


class Piece:
    """One solid under construction; `weigh` gives a point's (joint, weight) pairs."""

    def __init__(self, colour, material="paint", crease=42.0, weigh=None):
        self.points, self.faces = [], []
        self.colour, self.material, self.crease, self.weigh = colour, material, crease, weigh

    def point(self, p):
        self.points.append(p)
        return len(self.points) - 1

    def face(self, corners, colour=None, material=None):
        """A convex polygon; all of a piece's faces turn the same way as seen from outside."""
        self.faces.append((corners, colour or self.colour, material or self.material))

    def placed(self, move):
        self.points = [move(p) for p in self.points]
        return self

    def mirrored(self):
        """The same on the other side of the plane between left and right."""
        other = Piece(self.colour, self.material, self.crease, self.weigh)
        other.points = [(x, y, -z) for x, y, z in self.points]
        other.faces = [(tuple(reversed(c)), colour, material) for c, colour, material in self.faces]
        return other

    def volume(self):
        """Signed volume about the points' middle: negative where the faces look inward."""
        middle = mul(tuple(map(sum, zip(*self.points))), 1.0 / len(self.points))
        total = 0.0
        for corners, _, _ in self.faces:
            p = [sub(self.points[c], middle) for c in corners]
            total += sum(dot(p[0], cross(p[i], p[i + 1])) for i in range(1, len(p) - 1))
        return total

    def triangles(self):
        inside_out = self.volume() < 0.0
        for corners, colour, material in self.faces:
            corners = tuple(reversed(corners)) if inside_out else corners
            distinct = []
            for c in corners:
                if all(length(sub(self.points[c], self.points[d])) > 1e-6 for d in distinct):
                    distinct.append(c)
            for i in range(1, len(distinct) - 1):
                corner = (distinct[0], distinct[i], distinct[i + 1])
                a, b, c = (self.points[k] for k in corner)
                normal = cross(sub(b, a), sub(c, a))
                if length(normal) > 1e-9:
                    yield corner, normal, colour, material

    def into(self, model):
        """Adds the solid's triangles to the model's parts."""
        triangles = list(self.triangles())
        key = [tuple(round(v, 5) for v in p) for p in self.points]
        around = {}
        for corner, normal, _, _ in triangles:
            for i in range(3):
                a, b, c = (self.points[corner[(i + k) % 3]] for k in range(3))
                u, v = unit(sub(b, a)), unit(sub(c, a))
                angle = math.acos(min(max(dot(u, v), -1.0), 1.0))
                around.setdefault(key[corner[i]], []).append((unit(normal), angle))
        limit = math.cos(math.radians(self.crease))
        for corner, normal, colour, material in triangles:
            vertices, faces, known = model.part(material)
            own = unit(normal)
            triple = []
            for c in corner:
                total = (0.0, 0.0, 0.0)
                for other, angle in around[key[c]]:
                    if dot(own, other) >= limit:
                        total = add(total, mul(other, angle))
                soft = unit(total)
                weights = self.weigh(self.points[c]) if self.weigh else ()
                vertex = (self.points[c], tuple(round(v, 4) for v in soft), linear(colour), weights)
                name = (key[c], vertex[1], colour, tuple(weights))
                if name not in known:
                    known[name] = len(vertices)
                    vertices.append(vertex)
                triple.append(known[name])
            faces.append(tuple(triple))


def ring(centre, u, v, sides, power=1.0, phase=0.0):
    """Points round a superellipse; `power` 1 is an ellipse, smaller is squarer."""
    out = []
    for i in range(sides):
        a = TAU * (i + phase) / sides
        c, s = math.cos(a), math.sin(a)
        c = math.copysign(abs(c) ** power, c)
        s = math.copysign(abs(s) ** power, s)
        out.append(add(centre, add(mul(u, c), mul(v, s))))
    return out


def loft(rings, colour, material="paint", bands=None, caps=(True, True), crease=42.0, weigh=None, closed=True):
    """A skin over rings of equal numbers of points, which turn anticlockwise as seen from the last ring.

    `bands` gives the colour of each strip; `closed` joins each ring's last point to its first.
    """
    piece = Piece(colour, material, crease, weigh)
    index = [[piece.point(p) for p in points] for points in rings]
    sides = len(rings[0])
    for k in range(len(rings) - 1):
        strip = bands[k] if bands else colour
        for i in range(sides if closed else sides - 1):
            j = (i + 1) % sides
            piece.face((index[k][i], index[k][j], index[k + 1][j], index[k + 1][i]), strip)
    if caps[0]:
        piece.face(tuple(reversed(index[0])), bands[0] if bands else colour)
    if caps[1]:
        piece.face(tuple(index[-1]), bands[-1] if bands else colour)
    return piece


def ball(centre, radii, colour, round_=1.0, rings=6, sides=12, material="paint", crease=50.0, weigh=None, span=None):
    """A superellipsoid about y; `round_` 1 is an ellipsoid, smaller is boxier."""
    low, high = span or (-90.0, 90.0)
    rows = []
    for k in range(rings + 1):
        a = math.radians(low + (high - low) * k / rings)
        c, s = math.cos(a), math.sin(a)
        c, s = max(c, 0.0) ** round_, math.copysign(abs(s) ** round_, s)
        middle = (centre[0], centre[1] + radii[1] * s, centre[2])
        rows.append(ring(middle, (0.0, 0.0, radii[2] * c), (radii[0] * c, 0.0, 0.0), sides, round_, 0.5))
    return loft(rows, colour, material, caps=(low > -90.0, high < 90.0), crease=crease, weigh=weigh)


def tube(path, radii, colour, sides=10, material="paint", bands=None, caps=(True, True), crease=42.0, weigh=None,
         up=(1.0, 0.0, 0.0), power=1.0):
    """A loft of rings at right angles to a path; each radius is (along `up`, across it) or one number."""
    rows = []
    for i, p in enumerate(path):
        before, after = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        way = unit(sub(after, before))
        side = unit(cross(way, up))
        top = cross(side, way)
        r = radii[i] if isinstance(radii[i], tuple) else (radii[i], radii[i])
        rows.append(ring(p, mul(side, r[1]), mul(top, -r[0]), sides, power, 0.5))
    return loft([list(reversed(r)) for r in rows], colour, material, bands, caps, crease, weigh)


def box(centre, half, colour, bevel=0.02, material="paint", crease=30.0, weigh=None, taper=(1.0, 1.0)):
    """A box whose twelve edges are cut off by `bevel`, if there is one; `taper` scales x and z at the top."""
    if not bevel:
        rows = [[add(centre, (sx * half[0] * (taper[0] if sy > 0 else 1.0), sy * half[1],
                              sz * half[2] * (taper[1] if sy > 0 else 1.0)))
                 for sx, sz in ((1, 1), (1, -1), (-1, -1), (-1, 1))] for sy in (-1, 1)]
        return loft(rows, colour, material, crease=crease, weigh=weigh)
    piece = Piece(colour, material, crease, weigh)
    corner = {}
    for sx in (-1, 1):
        for sy in (-1, 1):
            for sz in (-1, 1):
                for axis in range(3):
                    p = [sx * half[0], sy * half[1], sz * half[2]]
                    for k, s in enumerate((sx, sy, sz)):
                        if k != axis:
                            p[k] -= s * bevel
                    if sy > 0:
                        p[0] *= taper[0]
                        p[2] *= taper[1]
                    corner[sx, sy, sz, axis] = piece.point(add(centre, tuple(p)))
    faces = []
    signs = (-1, 1)
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3

        def at(sa, sb, sc, which, axis=axis, b=b, c=c):
            key = [0, 0, 0]
            key[axis], key[b], key[c] = sa, sb, sc
            return corner[key[0], key[1], key[2], which]

        for s in signs:
            faces.append([at(s, -1, -1, axis), at(s, 1, -1, axis), at(s, 1, 1, axis), at(s, -1, 1, axis)])
        for sb in signs:
            for sc in signs:  # the edge along `axis`
                faces.append([at(-1, sb, sc, b), at(1, sb, sc, b), at(1, sb, sc, c), at(-1, sb, sc, c)])
    for sx in signs:
        for sy in signs:
            for sz in signs:
                faces.append([corner[sx, sy, sz, axis] for axis in range(3)])
    for f in faces:
        a, b, c = (piece.points[k] for k in f[:3])
        middle = mul(tuple(map(sum, zip(*(piece.points[k] for k in f)))), 1.0 / len(f))
        outward = dot(cross(sub(b, a), sub(c, a)), sub(middle, centre)) > 0.0
        piece.face(tuple(f if outward else reversed(f)))
    return piece


def spun(profile, colour, axis="y", centre=(0.0, 0.0, 0.0), sides=16, material="paint", bands=None, crease=35.0,
         weigh=None):
    """A solid of revolution: (height along the axis, radius) from one end to the other."""
    rows = []
    for height, radius in profile:
        if axis == "y":
            rows.append(ring((0.0, height, 0.0), (0.0, 0.0, radius), (radius, 0.0, 0.0), sides))
        elif axis == "x":
            rows.append(ring((height, 0.0, 0.0), (0.0, radius, 0.0), (0.0, 0.0, radius), sides))
        else:
            rows.append(ring((0.0, 0.0, height), (radius, 0.0, 0.0), (0.0, radius, 0.0), sides))
    rows = [[add(centre, p) for p in r] for r in rows]
    return loft(rows, colour, material, bands, (profile[0][1] > 0, profile[-1][1] > 0), crease, weigh)


def hoop(centre, axis_u, axis_v, radius, thick, colour, turns=16, sides=6, material="paint", weigh=None, span=TAU,
         start=0.0, across=None):
    """A torus or an arc of one, round the plane of the unit vectors u and v; `across` is its half width."""
    w = cross(axis_u, axis_v)
    whole = span >= TAU - 1e-9
    rows = []
    for k in range(turns + (0 if whole else 1)):
        a = start + span * k / turns
        out = add(mul(axis_u, math.cos(a)), mul(axis_v, math.sin(a)))
        middle = add(centre, mul(out, radius))
        rows.append(ring(middle, mul(w, across or thick), mul(out, thick), sides, 1.0, 0.5))
    if whole:
        rows.append(rows[0])
    return loft(rows, colour, material, caps=(not whole, not whole), weigh=weigh, crease=70.0)
