#!/usr/bin/env python3
"""Makes the pictures of the sky: the band of faint stars on a cube, and clouds that repeat.

    python3 assets/sky/make_sky.py            writes the files beside this script
    python3 assets/sky/make_sky.py --check    fails where a file differs from what would be written

Only Python's own library is used. All is noise of our own with fixed seeds, so the same pixels come out every time.
stars.png: the six faces of a cube below one another, +x, -x, +y, -y, +z, -z, sRGB; single bright stars are drawn as
points by the game and are not in it. clouds.png: how thick clouds are, 0 to 255, repeating on all sides.
"""

import math
import struct
import sys
import zlib
from pathlib import Path

FACE = 256
CLOUDS = 256
MASK = 0xFFFFFFFF


def mixed(h):
    """An even 32-bit number of another one (C. Wellons' lowbias32)."""
    h = ((h ^ (h >> 16)) * 0x7FEB352D) & MASK
    h = ((h ^ (h >> 15)) * 0x846CA68B) & MASK
    return h ^ (h >> 16)


def lattice(x, y, z, seed):
    return mixed((x * 0x9E3779B1 ^ y * 0x85EBCA77 ^ z * 0xC2B2AE3D ^ seed) & MASK) / MASK


def eased(t):
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0)


def noise(p, seed, period=None):
    """Value noise from 0 to 1; repeats along x and y after `period` cells."""
    base = [math.floor(c) for c in p]
    f = [eased(c - b) for c, b in zip(p, base)]
    wrap = (lambda c: c % period) if period else (lambda c: c)
    x = [wrap(base[0]), wrap(base[0] + 1)]
    y = [wrap(base[1]), wrap(base[1] + 1)]
    z = [base[2], base[2] + 1]
    total = 0.0
    for i in (0, 1):
        for j in (0, 1):
            for k in (0, 1):
                weight = (f[0] if i else 1.0 - f[0]) * (f[1] if j else 1.0 - f[1]) * (f[2] if k else 1.0 - f[2])
                if weight > 0.0:
                    total += weight * lattice(x[i], y[j], z[k], seed)
    return total


def layered(p, octaves, seed, period=None):
    total, amplitude, weight = 0.0, 0.5, 0.0
    for octave in range(octaves):
        total += amplitude * noise(p, seed + octave, period)
        weight += amplitude
        amplitude *= 0.5
        p = [2.0 * c for c in p[:2]] + [2.0 * p[2]]
        period = period and period * 2
    return total / weight


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def smooth(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


# The band lies aslant of the axis about which the sky turns, so that it never stands the same two hours running.
POLE = unit((0.52, 0.46, -0.72))
CORE = unit((0.20, 0.75, 0.63))


def star_light(d):
    """Linear light of the band in a direction."""
    height = dot(d, POLE)
    if abs(height) > 0.55:
        return (0.0, 0.0, 0.0)
    core = 0.5 + 0.5 * dot(d, CORE)
    ragged = layered([c * 3.0 + 20.0 for c in d], 4, 11) - 0.5
    wide = math.exp(-((height + 0.10 * ragged) / (0.13 + 0.10 * core * core)) ** 2)
    clots = layered([c * 7.0 + 50.0 for c in d], 4, 23)
    dust = layered([c * 4.5 + 90.0 for c in d], 5, 37)
    lane = smooth(0.44, 0.66, dust) * math.exp(-((height - 0.05 * ragged) / 0.11) ** 2)
    edge = smooth(0.55, 0.40, abs(height))
    light = edge * wide * (0.25 + 0.75 * core ** 2) * (0.35 + 1.1 * clots * clots) * (1.0 - 0.80 * lane)
    grain = lattice(int(d[0] * 4096), int(d[1] * 4096), int(d[2] * 4096), 5)
    light *= 0.82 + 0.5 * grain ** 6
    warm = core ** 3
    return (light * (0.80 + 0.30 * warm), light * (0.84 + 0.08 * warm), light * (1.0 - 0.22 * warm))


def direction(face, u, v):
    """Of a place on a face, u to the right and v downwards from -1 to 1: the cube as graphics adapters lay it."""
    return unit(
        ((1.0, -v, -u), (-1.0, -v, u), (u, 1.0, v), (u, -1.0, -v), (u, -v, 1.0), (-u, -v, -1.0))[face]
    )


def to_srgb(x):
    x = min(max(x, 0.0), 1.0)
    return 12.92 * x if x <= 0.0031308 else 1.055 * x ** (1.0 / 2.4) - 0.055


def stars():
    rows = []
    for face in range(6):
        for y in range(FACE):
            row = bytearray()
            for x in range(FACE):
                d = direction(face, (2 * x + 1) / FACE - 1.0, (2 * y + 1) / FACE - 1.0)
                row += bytes(round(255 * to_srgb(0.34 * c)) for c in star_light(d))
            rows.append(bytes(row))
    return png(FACE, rows, 2)


def gradient_noise(x, y, seed, period):
    """Perlin's noise of the plane from about -0.7 to 0.7, repeating after `period` cells."""
    i, j = math.floor(x), math.floor(y)
    f, g = x - i, y - j

    def slope(a, b, dx, dy):
        angle = math.tau * lattice(a % period, b % period, 0, seed)
        return math.cos(angle) * dx + math.sin(angle) * dy

    near = slope(i, j, f, g) + eased(f) * (slope(i + 1, j, f - 1.0, g) - slope(i, j, f, g))
    far = slope(i, j + 1, f, g - 1.0)
    far += eased(f) * (slope(i + 1, j + 1, f - 1.0, g - 1.0) - far)
    return near + eased(g) * (far - near)


def layers(x, y, octaves, seed, period, fold=False):
    """Layers of that noise; folded at 0 they make round heaps with creases between them."""
    total, amplitude = 0.0, 0.5
    for octave in range(octaves):
        n = gradient_noise(x * period, y * period, seed + octave, period)
        total += amplitude * (2.0 * abs(n) if fold else n)
        amplitude *= 0.5
        period *= 2
    return total


def clouds():
    """Heaps in loose groups: where there are any says slow noise, and folded noise gives them their shape."""
    rows = []
    for y in range(CLOUDS):
        row = bytearray()
        for x in range(CLOUDS):
            u, v = x / CLOUDS, y / CLOUDS
            lean = layers(u, v, 2, 71, 5) * 0.05
            group = layers(u + lean, v - lean, 5, 97, 4)
            heaps = layers(u, v, 4, 53, 9, fold=True)
            thick = 0.36 + 0.9 * group + 0.42 * heaps
            row.append(round(255 * min(max(thick, 0.0), 1.0)))
        rows.append(bytes(row))
    return png(CLOUDS, rows, 0)


def png(width, rows, colour_type):
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    head = struct.pack(">IIBBBBB", width, len(rows), 8, colour_type, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def main():
    here = Path(__file__).parent
    differs = False
    for name, make in (("clouds.png", clouds), ("stars.png", stars)):
        made = make()
        if "--check" in sys.argv[1:]:
            if (here / name).read_bytes() != made:
                print(f"{name} differs from what would be written")
                differs = True
        else:
            (here / name).write_bytes(made)
    sys.exit(differs)


main()
