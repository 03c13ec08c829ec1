#!/usr/bin/env python3
"""Makes the golden file of the hyperbolic plane's tiling, tiling.json, by an independent route.

Numbers here are (p + q sqrt(5))/2 in whole numbers of any size, compared by their squares; the game's are a + b phi of
128 bits. Moves are products of whole matrices. The frame of a tile is found as it is defined: all four neighbours are
made, and the one nearest to the root is its parent.

Tables, in whole numbers unless told:
  walk         every 10 000th of a million steps of a drawn walk: step, centre (x and z as a, b), hash of all so far
  numbers      the tiles within five steps: number, centre
  between      two paths, each as two numbers of digits to base 4 behind a 1, and the nine numbers of the move between
               their frames by columns
  signs        a, b, and the sign of a + b phi
  values       a, b, and a + b phi to the nearest double
  equiangular  chart (xi, y, eta) in radii, and the point (X, Y, Z, W); doubles
  cylindrical  chart (x, y, z) in radii, and the point; doubles

The file carries a hash (FNV-1a, 64 bits) of this script and one of its own data; a test of the crate recomputes both.

Usage: python3 make_tiling.py    (Python 3, mpmath 1.3; rewrites the file, some minutes)
"""

import json
import random
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 120
WORD = (1 << 64) - 1
STEPS, EVERY = 1_000_000, 10_000


def golden(a, b):
    """a + b phi as (p + q sqrt(5))/2."""
    return (2 * a + b, b)


def parts(number):
    p, q = number
    assert (p - q) % 2 == 0
    return [(p - q) // 2, q]


def add(m, n):
    return (m[0] + n[0], m[1] + n[1])


def times(m, n):
    return ((m[0] * n[0] + 5 * m[1] * n[1]) // 2, (m[0] * n[1] + m[1] * n[0]) // 2)


def sign(number):
    """p against -q sqrt(5), by their squares where they do not differ in sign."""
    p, q = number
    if p >= 0 and q >= 0:
        return int(p > 0 or q > 0)
    if p <= 0 and q <= 0:
        return -1
    larger = p * p > 5 * q * q
    return (1 if larger else -1) * (1 if p > 0 else -1)


def less(m, n):
    return sign((m[0] - n[0], m[1] - n[1])) < 0


def product(a, b):
    """Of two matrices, by rows."""
    out = []
    for row in a:
        line = []
        for j in range(3):
            total = times(row[0], b[0][j])
            total = add(total, times(row[1], b[1][j]))
            line.append(add(total, times(row[2], b[2][j])))
        out.append(line)
    return out


ZERO, ONE, PHI, MINUS = golden(0, 0), golden(1, 0), golden(0, 1), golden(-1, 0)
IDENTITY = [[ONE, ZERO, ZERO], [ZERO, ONE, ZERO], [ZERO, ZERO, ONE]]
STEP = [[PHI, ZERO, ONE], [ZERO, ONE, ZERO], [PHI, ZERO, PHI]]
QUARTER = [[ZERO, MINUS, ZERO], [ONE, ZERO, ZERO], [ZERO, ZERO, ONE]]
TURNS = [IDENTITY]
for _ in range(3):
    TURNS.append(product(TURNS[-1], QUARTER))
OVER = [product(turn, STEP) for turn in TURNS]


def fixed(frame):
    """The frame of a tile from one that may be turned, and by how much it was."""
    if frame[2][2] == ONE:
        turn = next(j for j in range(4) if product(frame, TURNS[j]) == IDENTITY)
        return product(frame, TURNS[turn]), turn
    far = []
    for over in OVER:
        total = times(frame[2][0], over[0][2])
        total = add(total, times(frame[2][1], over[1][2]))
        far.append(add(total, times(frame[2][2], over[2][2])))
    nearest = far[0]
    for other in far[1:]:
        if less(other, nearest):
            nearest = other
    ties = [k for k in range(4) if far[k] == nearest]
    # Of two that follow each other the first.
    parent = ties[0] if len(ties) == 1 else next(k for k in ties if (k + 1) % 4 in ties)
    turn = (parent - 2) % 4
    return product(frame, TURNS[turn]), turn


def neighbour(frame, side):
    """The frame over a side, and the side there that leads back."""
    there, turn = fixed(product(frame, OVER[side]))
    return there, (2 - turn) % 4


def centre(frame):
    return parts(frame[0][2]) + parts(frame[1][2])


def draws(state):
    while True:
        state = (state * 6364136223846793005 + 1442695040888963407) & WORD
        yield state >> 33


def walk():
    """Steps over drawn sides; far out, homewards (side 2) for a drawn while."""
    rows, frame, home, mixed = [], IDENTITY, 0, 0xCBF29CE484222325
    draw = draws(20)
    for step in range(1, STEPS + 1):
        drawn = next(draw)
        side = 2 if home else drawn & 3
        home = max(home - 1, 0)
        frame, back = neighbour(frame, side)
        for number in centre(frame) + [back]:
            for word in (number & WORD, number >> 64 & WORD):
                mixed = (mixed ^ word) * 0x100000001B3 & WORD
        if not home and parts(frame[2][2])[1] > 1 << 106:
            home = (drawn >> 2) % 128
        if step % EVERY == 0:
            rows.append([step] + centre(frame) + [mixed])
    return rows


def children(frame):
    for side in range(4):
        there, back = neighbour(frame, side)
        if back == 2 and there[2][2] != ONE:
            yield side, there


def numbers():
    rows, ring = [], [IDENTITY]
    for _ in range(6):
        rows += [[len(rows) + i] + centre(frame) for i, frame in enumerate(ring)]
        # The children of the root all have it over their side 2, as parents have to be.
        ring = [child for frame in ring for _, child in children(frame)]
    return rows


def inverse(frame):
    """By the cofactors of a matrix of determinant 1."""
    def minor(i, j):
        rows = [r for r in range(3) if r != i]
        cols = [c for c in range(3) if c != j]
        one = times(frame[rows[0]][cols[0]], frame[rows[1]][cols[1]])
        other = times(frame[rows[0]][cols[1]], frame[rows[1]][cols[0]])
        value = (one[0] - other[0], one[1] - other[1])
        return value if (i + j) % 2 == 0 else (-value[0], -value[1])
    return [[minor(j, i) for j in range(3)] for i in range(3)]


def path(rng, steps):
    """The tile at the end of a drawn path from the root, from parent to child."""
    frame = IDENTITY
    for _ in range(steps):
        _, frame = rng.choice(list(children(frame)))
    return frame


def digits_of(frame):
    """The path to a tile, up all its parents: the first 50 steps and the others."""
    sides = []
    while frame[2][2] != ONE:
        frame, back = neighbour(frame, 2)
        sides.insert(0, back)
    halves = []
    for half in (sides[:50], sides[50:]):
        digits = 1
        for side in half:
            digits = 4 * digits + side
        halves.append(digits)
    return halves


def between(rng):
    rows = []
    for case in range(120):
        first = path(rng, rng.choice([3, 10, 25, 40, 60]) + case % 7)
        if case % 3:
            # Some steps away, by whatever way.
            second = first
            for _ in range(rng.randrange(1, 12)):
                second, _ = neighbour(second, rng.randrange(4))
        else:
            second = path(rng, rng.randrange(1, 20))
        move = product(inverse(first), second)
        columns = [x for j in range(3) for i in range(3) for x in parts(move[i][j])]
        rows.append(digits_of(first) + digits_of(second) + columns)
    return rows


def pairs(rng):
    """Pairs a, b: few and many digits, and b the best or nearly the best for a to cancel."""
    out = [(0, 0), (1, 0), (0, 1), (-1, 1), (1, -1), (-2, 1), (2, -1)]
    a, b = 0, 1
    for _ in range(178):
        a, b = b, a + b
        out += [(a, -b), (-a, b), (b, -a), (-b, a)]
    for _ in range(300):
        bits = rng.randrange(1, 125)
        b = rng.randrange(1, 1 << bits) * rng.choice([1, -1])
        out.append((rng.randrange(-1 << bits, 1 << bits), b))
        a = -int(mp.nint(b * (1 + mp.sqrt(5)) / 2)) + rng.randrange(-3, 4)
        if abs(a) <= 1 << 125:
            out.append((a, b))
    return [pair for pair in out if max(map(abs, pair)) <= 1 << 125]


def charts(rng):
    equiangular, cylindrical = [], []
    for reach in (1e-9, 1e-3, 0.3, 0.53, 0.7):
        for _ in range(40):
            xi, y, eta = (rng.uniform(-reach, reach) for _ in range(3))
            x, z, up = mp.tanh(mpf(xi)), mp.tanh(mpf(eta)), mpf(y)
            w = 1 / mp.sqrt(1 - x * x - z * z)
            point = [x * w * mp.cosh(up), mp.sinh(up), z * w * mp.cosh(up), w * mp.cosh(up)]
            equiangular.append([xi, y, eta] + [float(c) for c in point])
            x, z = mpf(xi), mpf(eta)
            r = mp.sqrt(x * x + z * z)
            out = mp.sinh(r) / r * mp.cosh(up)
            point = [x * out, mp.sinh(up), z * out, mp.cosh(r) * mp.cosh(up)]
            cylindrical.append([xi, y, eta] + [float(c) for c in point])
    return {"equiangular": equiangular, "cylindrical": cylindrical}


def fnv(data):
    """FNV-1a, 64 bits."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 & WORD
    return f"{value:016x}"


def text_of(rows):
    lines = ",\n".join(json.dumps(row) for row in rows)
    return f"[\n{lines}\n]"


def main():
    rng = random.Random(20)
    phi = (1 + mp.sqrt(5)) / 2
    numbered = pairs(rng)
    tables = {
        "signs": [[a, b, sign(golden(a, b))] for a, b in numbered],
        "values": [[a, b, float(a + b * phi)] for a, b in numbered],
        "numbers": numbers(),
        "between": between(rng),
        **charts(rng),
        "walk": walk(),
    }
    data = "{\n" + ",\n".join(f"{json.dumps(key)}: {text_of(rows)}" for key, rows in tables.items()) + "\n}"
    script = fnv(Path(__file__).read_bytes())
    text = f'{{\n"generator": "{script}",\n"content": "{fnv(data.encode())}",\n"data": {data}\n}}\n'
    Path(__file__).with_name("tiling.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
