"""Vectors, quaternions (x, y, z, w) and colours, as plain tuples."""

import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return mul(a, 1.0 / length(a))


def mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def smooth(t):
    """0 to 1 with no speed at either end."""
    t = min(max(t, 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


IDENTITY = (0.0, 0.0, 0.0, 1.0)


def turn(axis, degrees):
    """The quaternion of a turn about a unit axis."""
    half = math.radians(degrees) / 2.0
    s = math.sin(half)
    return (axis[0] * s, axis[1] * s, axis[2] * s, math.cos(half))


def turn_x(degrees):
    return turn((1.0, 0.0, 0.0), degrees)


def turn_y(degrees):
    return turn((0.0, 1.0, 0.0), degrees)


def turn_z(degrees):
    return turn((0.0, 0.0, 1.0), degrees)


def chain(*turns):
    """One turn that does the last first, as matrices multiply."""
    out = IDENTITY
    for q in turns:
        out = times(out, q)
    return out


def times(p, q):
    px, py, pz, pw = p
    qx, qy, qz, qw = q
    return (
        pw * qx + px * qw + py * qz - pz * qy,
        pw * qy - px * qz + py * qw + pz * qx,
        pw * qz + px * qy - py * qx + pz * qw,
        pw * qw - px * qx - py * qy - pz * qz,
    )


def inverse(q):
    return (-q[0], -q[1], -q[2], q[3])


def rotate(q, v):
    u = (q[0], q[1], q[2])
    t = mul(cross(u, v), 2.0)
    return add(add(v, mul(t, q[3])), cross(u, t))


def from_axes(x, y, z):
    """The turn that carries the coordinate axes to an orthonormal right-handed frame."""
    trace = x[0] + y[1] + z[2]
    if trace > 0.0:
        s = math.sqrt(trace + 1.0) * 2.0
        return ((y[2] - z[1]) / s, (z[0] - x[2]) / s, (x[1] - y[0]) / s, s / 4.0)
    if x[0] > y[1] and x[0] > z[2]:
        s = math.sqrt(1.0 + x[0] - y[1] - z[2]) * 2.0
        return (s / 4.0, (y[0] + x[1]) / s, (z[0] + x[2]) / s, (y[2] - z[1]) / s)
    if y[1] > z[2]:
        s = math.sqrt(1.0 + y[1] - x[0] - z[2]) * 2.0
        return ((y[0] + x[1]) / s, s / 4.0, (z[1] + y[2]) / s, (z[0] - x[2]) / s)
    s = math.sqrt(1.0 + z[2] - x[0] - y[1]) * 2.0
    return ((z[0] + x[2]) / s, (z[1] + y[2]) / s, s / 4.0, (x[1] - y[0]) / s)


def nlerp(a, b, t):
    """Between two turns, the short way."""
    if sum(p * q for p, q in zip(a, b)) < 0.0:
        b = tuple(-v for v in b)
    q = mix(a, b, t)
    n = math.sqrt(sum(v * v for v in q))
    return tuple(v / n for v in q)


def linear(hex_colour):
    """Linear light of an sRGB colour written as 'rrggbb'."""
    out = []
    for i in (0, 2, 4):
        c = int(hex_colour[i : i + 2], 16) / 255.0
        out.append(c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4)
    return tuple(out)
