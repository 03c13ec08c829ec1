"""The car, the lamp and what a hand can hold. Axes are the game's: x ahead, y up, z to the right, metres."""

import math

from shapes import Model, ball, box, hoop, loft, ring, spun, tube
from vectors import add, mul, rotate, turn_z

BODY, CREAM, DARK, STEEL, TYRE, SEAT = "eda81c", "fbf3df", "3a404c", "b9c1ca", "2a2d33", "c8562a"
ORANGE, GLASS = "f4761a", "a9dcec"
WHEEL_M = 0.36
# name -> hub; the right wheels' outer side is +z.
WHEELS = {"wheel.FL": (1.0, 0.36, -0.61), "wheel.FR": (1.0, 0.36, 0.61), "wheel.RL": (-0.98, 0.36, -0.61),
          "wheel.RR": (-0.98, 0.36, 0.61)}


def both(piece, model):
    piece.into(model)
    piece.mirrored().into(model)


def _section(x, low, wide, top, inner, floor):
    """A ring across the car: round below and at the shoulder, and down to a floor where people sit."""
    half = [(low, wide - 0.14), (low + 0.05, wide - 0.04), (low + 0.16, wide), (top - 0.12, wide),
            (top - 0.035, wide - 0.03), (top, wide - 0.10), (top + 0.004, inner), (floor, inner - 0.01)]
    right = [(x, y, z) for y, z in half]
    return right + [(x, y, -z) for _, y, z in reversed(right)]


def car():
    model = Model()
    sections = [
        _section(1.53, 0.44, 0.36, 0.66, 0.18, 0.67), _section(1.49, 0.37, 0.44, 0.745, 0.22, 0.76),
        _section(1.38, 0.32, 0.49, 0.80, 0.25, 0.825), _section(1.0, 0.28, 0.52, 0.85, 0.27, 0.885),
        _section(0.56, 0.27, 0.56, 0.89, 0.30, 0.92), _section(0.50, 0.27, 0.565, 0.90, 0.46, 0.90),
        _section(0.47, 0.27, 0.565, 0.90, 0.46, 0.50), _section(-0.30, 0.27, 0.57, 0.90, 0.46, 0.48),
        _section(-0.93, 0.27, 0.56, 0.90, 0.46, 0.50), _section(-0.96, 0.27, 0.56, 0.90, 0.46, 0.905),
        _section(-1.30, 0.30, 0.53, 0.88, 0.30, 0.90), _section(-1.44, 0.36, 0.49, 0.82, 0.26, 0.835),
        _section(-1.50, 0.44, 0.40, 0.72, 0.20, 0.73),
    ]
    body = loft(sections, BODY, crease=42.0)
    # Inside, the tub is dark; low down the sills are too.
    for k, (corners, _, material) in enumerate(body.faces):
        middle = mul(tuple(map(sum, zip(*(body.points[c] for c in corners)))), 1.0 / len(corners))
        inside = -0.955 < middle[0] < 0.505 and abs(middle[2]) < 0.462 and middle[1] > 0.4
        if inside or middle[1] < 0.36:
            body.faces[k] = (corners, DARK, material)
    body.into(model)
    _front(model)
    _rear(model)
    _sides(model)
    _cabin(model)
    return model


def _front(model):
    # Two big eyes, a grille between them and a bumper that smiles.
    both(spun([(-0.10, 0.13), (0.03, 0.168), (0.065, 0.168), (0.075, 0.150), (0.055, 0.140)], CREAM, "x",
              (1.455, 0.655, 0.335), 18), model)
    both(spun([(0.05, 0.142), (0.075, 0.130), (0.098, 0.085), (0.105, 0.0)], "fff4d6", "x", (1.455, 0.655, 0.335), 18,
              "glow.head", crease=80.0), model)
    box((1.525, 0.60, 0.0), (0.045, 0.085, 0.15), DARK, 0.03).into(model)
    for k in range(3):
        box((1.566, 0.60, 0.085 * (k - 1)), (0.012, 0.062, 0.014), STEEL, 0.0).into(model)
    path = [(1.30, 0.505, -0.66), (1.44, 0.455, -0.58), (1.56, 0.41, -0.34), (1.60, 0.395, 0.0), (1.56, 0.41, 0.34),
            (1.44, 0.455, 0.58), (1.30, 0.505, 0.66)]
    tube(path, [(0.045, 0.03)] + [(0.068, 0.045)] * 5 + [(0.045, 0.03)], DARK, 8, up=(0.0, 1.0, 0.0)).into(model)
    both(ball((1.585, 0.41, 0.20), (0.03, 0.035, 0.035), "ffb347", 0.9, 4, 8, "glow.head"), model)
    # A cream stripe over the bonnet, and a badge.
    rows = [[(x, y, z) for y, z in ((top, 0.10), (top + 0.012, 0.09), (top + 0.012, -0.09), (top, -0.10))]
            for x, top in ((1.47, 0.752), (1.38, 0.816), (1.0, 0.877), (0.57, 0.912))]
    loft(rows, CREAM).into(model)
    spun([(-0.02, 0.05), (0.012, 0.05), (0.02, 0.036)], ORANGE, "x", (1.545, 0.735, 0.0), 12).into(model)


def _rear(model):
    both(box((-1.475, 0.66, 0.345), (0.045, 0.085, 0.055), "d8281c", 0.02, "glow.tail"), model)
    path = [(-1.28, 0.48, -0.66), (-1.42, 0.43, -0.56), (-1.52, 0.40, -0.30), (-1.54, 0.395, 0.0), (-1.52, 0.40, 0.30),
            (-1.42, 0.43, 0.56), (-1.28, 0.48, 0.66)]
    tube(path, [(0.045, 0.03)] + [(0.065, 0.042)] * 5 + [(0.045, 0.03)], DARK, 8, up=(0.0, 1.0, 0.0)).into(model)
    # The spare wheel on the back.
    spun([(-0.07, 0.14), (-0.075, 0.22), (-0.04, 0.25), (0.04, 0.25), (0.075, 0.22), (0.07, 0.14)], TYRE, "x",
         (-1.545, 0.72, 0.0), 16).into(model)
    spun([(-0.085, 0.06), (-0.078, 0.15), (-0.05, 0.16)], CREAM, "x", (-1.545, 0.72, 0.0), 12).into(model)


def _sides(model):
    # Mudguards over the wheels, dark wells behind them, doors between.
    for x, _, z in (WHEELS["wheel.FR"], WHEELS["wheel.RR"]):
        both(hoop((x, WHEEL_M + 0.01, z - 0.005), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.445, 0.036, BODY, 12, 8,
                  span=math.radians(190), start=math.radians(-5), across=0.145), model)
        both(spun([(-0.02, 0.33), (0.012, 0.33)], DARK, "z", (x, WHEEL_M + 0.10, 0.505), 16), model)
    both(box((0.01, 0.62, 0.575), (0.50, 0.22, 0.055), BODY, 0.035), model)
    both(box((0.01, 0.34, 0.60), (0.53, 0.055, 0.085), DARK, 0.03), model)
    both(box((0.01, 0.60, 0.632), (0.50, 0.022, 0.006), CREAM, 0.0), model)
    both(box((-0.30, 0.74, 0.635), (0.075, 0.018, 0.014), STEEL, 0.0, "metal"), model)
    both(tube([(0.43, 0.92, 0.54), (0.44, 0.96, 0.62)], [0.014, 0.014], DARK, 6), model)
    both(ball((0.44, 0.985, 0.665), (0.03, 0.05, 0.062), BODY, 0.7, 5, 10), model)


def _cabin(model):
    roof = [ring((-0.22, y, 0.0), (0.0, 0.0, z), (x, 0.0, 0.0), 24, 0.5, 0.5)
            for y, x, z in ((1.405, 0.58, 0.47), (1.415, 0.635, 0.525), (1.45, 0.64, 0.53), (1.485, 0.60, 0.49),
                            (1.50, 0.48, 0.38))]
    loft(roof, CREAM, crease=60.0).into(model)
    posts = {"a": ((0.50, 0.89, 0.49), (0.33, 1.425, 0.445)), "b": ((-0.87, 0.89, 0.49), (-0.76, 1.425, 0.445))}
    for low, high in posts.values():
        both(tube([low, high], [0.034, 0.030], BODY, 8), model)
    for low, high in posts.values():
        right = [low, high]
        ring_ = [right[0], right[1], (high[0], high[1], -high[2]), (low[0], low[1], -low[2])]
        shift = (0.006, 0.0, 0.0)
        loft([ring_, [add(p, shift) for p in ring_]], GLASS, "glass").into(model)
    (al, ah), (bl, bh) = posts.values()
    pane = [al, ah, bh, bl]
    both(loft([pane, [add(p, (0.0, 0.0, 0.006)) for p in pane]], GLASS, "glass"), model)
    for z in (-0.23, 0.23):
        box((-0.22, 0.58, z), (0.24, 0.075, 0.185), SEAT, 0.05).into(model)
        back = box((0.0, 0.26, 0.0), (0.07, 0.27, 0.18), SEAT, 0.05)
        back.placed(lambda p, z=z: add(rotate(turn_z(12.0), p), (-0.45, 0.56, z))).into(model)
        rest = ball((-0.575, 1.13, z), (0.05, 0.075, 0.11), SEAT, 0.6, 5, 10)
        rest.into(model)
    box((0.445, 0.84, 0.0), (0.06, 0.07, 0.44), DARK, 0.03).into(model)
    # The driver sits on the left.
    axle = rotate(turn_z(28.0), (1.0, 0.0, 0.0))
    up = rotate(turn_z(28.0), (0.0, 1.0, 0.0))
    hub = (0.20, 0.93, -0.23)
    hoop(hub, (0.0, 0.0, 1.0), up, 0.135, 0.017, TYRE, 16, 6).into(model)
    tube([hub, add(hub, mul(axle, 0.22))], [0.028, 0.022], DARK, 8).into(model)
    for way in ((0.0, 0.0, 1.0), (0.0, 0.0, -1.0), mul(up, -1.0)):
        tube([hub, add(hub, mul(way, 0.13))], [0.014, 0.012], STEEL, 6, up=axle).into(model)


def wheel(outer):
    """A wheel about its own hub; `outer` is +1 where its outer side is +z."""
    model = Model()
    tyre = spun([(-0.115, 0.20), (-0.125, 0.28), (-0.105, 0.335), (-0.05, 0.36), (0.05, 0.36), (0.105, 0.335),
                 (0.125, 0.28), (0.115, 0.20)], TYRE, "z", sides=20, material="rubber")
    rim = spun([(0.07, 0.10), (0.10, 0.205), (0.128, 0.205), (0.13, 0.19), (0.09, 0.15), (0.098, 0.085)], CREAM, "z",
               sides=16)
    cap = spun([(0.09, 0.095), (0.125, 0.085), (0.135, 0.05)], ORANGE, "z", sides=12)
    knobs = []
    for k in range(5):
        a = 2.0 * math.pi * k / 5
        knobs.append(spun([(0.08, 0.022), (0.112, 0.02)], DARK, "z", (0.135 * math.cos(a), 0.135 * math.sin(a), 0.0), 6))
    for piece in [tyre, rim, cap, *knobs]:
        (piece if outer > 0 else piece.mirrored()).into(model)
    return model


def lamp():
    """A lantern 0.46 m high that stands on the ground: foot, glowing globe in a cage, cap and ring."""
    model = Model()
    foot = [(0.0, 0.115), (0.012, 0.125), (0.03, 0.122), (0.045, 0.095), (0.06, 0.07), (0.085, 0.062), (0.10, 0.072),
            (0.112, 0.072)]
    spun(foot, DARK, sides=20, bands=[DARK, DARK, ORANGE, DARK, DARK, STEEL, STEEL], crease=40.0).into(model)
    spun([(0.08, 0.045), (0.12, 0.052), (0.15, 0.050), (0.235, 0.050), (0.28, 0.044), (0.30, 0.03)], "fff1c4", sides=14,
         material="glow", crease=80.0).into(model)
    ball((0.0, 0.215, 0.0), (0.125, 0.118, 0.125), "ffd98a", 1.0, 10, 20, "globe", crease=80.0,
         span=(-62.0, 62.0)).into(model)
    cap = [(0.308, 0.078), (0.318, 0.084), (0.335, 0.080), (0.352, 0.050), (0.365, 0.030), (0.385, 0.024)]
    spun(cap, DARK, sides=20, bands=[STEEL, DARK, DARK, DARK, ORANGE], crease=40.0).into(model)
    for k in range(4):
        a = math.pi * (0.25 + 0.5 * k)
        out = (math.cos(a), 0.0, math.sin(a))
        path = [add(mul(out, r), (0.0, y, 0.0)) for r, y in ((0.070, 0.100), (0.118, 0.145), (0.136, 0.215),
                                                             (0.118, 0.285), (0.076, 0.325))]
        tube(path, [0.0085] * 5, DARK, 6, "metal", up=(-out[2], 0.0, out[0]), crease=80.0).into(model)
    hoop((0.0, 0.215, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), 0.136, 0.008, DARK, 24, 6, "metal").into(model)
    hoop((0.0, 0.425, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.045, 0.0085, STEEL, 16, 6, "metal").into(model)
    return model


def flag():
    """A pole 1.7 m high with a spike below the ground, and a swallow-tailed cloth that flies along x."""
    model = Model()
    pole = [(-0.25, 0.004), (0.0, 0.017), (0.02, 0.021), (0.05, 0.017), (1.645, 0.014), (1.65, 0.014)]
    spun(pole, CREAM, sides=10, bands=[STEEL, DARK, DARK, CREAM, STEEL], crease=40.0).into(model)
    ball((0.0, 1.67, 0.0), (0.032, 0.032, 0.032), ORANGE, 1.0, 6, 12, crease=80.0).into(model)
    # Thin, with both sides; the waves are those of cloth that hangs at the pole and is free at its end.
    columns, rows = 9, []
    for k in range(columns):
        s = k / (columns - 1)
        x, wave = 0.012 + 0.60 * s, 0.045 * s * math.sin(7.0 * s)
        notch = 0.13 * max(0.0, s - 0.72) / 0.28
        low, high = 1.22 + 0.02 * s, 1.61 - 0.02 * s
        middle = 0.5 * (low + high)
        rows.append((x, wave, low, middle - notch, middle + notch, high))
    for below, above in ((2, 3), (4, 5)):
        sections = []
        for row in rows:
            x, wave = row[0], row[1]
            sections.append([(x, row[below], wave + 0.004), (x, row[above], wave + 0.004), (x, row[above], wave - 0.004),
                             (x, row[below], wave - 0.004)])
        bands = [ORANGE] * (columns - 1)
        loft(sections, ORANGE, "paint", bands, crease=50.0).into(model)
    for y in (1.25, 1.58):
        hoop((0.0, y, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), 0.022, 0.006, DARK, 10, 6).into(model)
    return model


def door():
    """A frame to walk and drive through: 1.9 m wide and 2.2 m high inside, its foot on the ground, its front along x.

    What is inside is left open; the renderer shows there what lies behind the other one of the pair."""
    model = Model()
    teal, side, top = "1f7f8c", 1.04, 2.29
    # The feet go into the ground, for slopes.
    both(box((0.0, 0.615, side), (0.10, 1.765, 0.09), teal, 0.02), model)
    both(box((0.0, 0.10, side), (0.15, 0.14, 0.13), DARK, 0.03), model)
    both(box((0.0, 2.06, side), (0.13, 0.05, 0.115), CREAM, 0.015), model)
    box((0.0, top, 0.0), (0.10, 0.09, side + 0.09), teal, 0.02).into(model)
    box((0.0, top + 0.11, 0.0), (0.13, 0.03, side + 0.15), DARK, 0.015).into(model)
    # A lit edge all round the opening, on either face: nobody takes one for a gate that leads on.
    for x in (-0.103, 0.103):
        both(box((x, 1.02, 0.965), (0.012, 0.98, 0.012), "78e2ff", 0.0, "glow"), model)
        box((x, 2.215, 0.0), (0.012, 0.012, 0.95), "78e2ff", 0.0, "glow").into(model)
        ball((x, top, 0.0), (0.02, 0.045, 0.045), ORANGE, 1.0, 5, 10).into(model)
    return model


def bullet():
    """A bolt 0.16 m long that flies along x: its middle is the origin."""
    model = Model()
    spun([(-0.08, 0.020), (-0.072, 0.026), (-0.064, 0.026), (-0.062, 0.022), (-0.054, 0.022), (-0.052, 0.026),
          (0.012, 0.026)], "d9a441", "x", sides=12, material="metal", crease=35.0).into(model)
    spun([(0.010, 0.0255), (0.018, 0.0275), (0.026, 0.0255)], DARK, "x", sides=12).into(model)
    spun([(0.024, 0.0245), (0.045, 0.022), (0.063, 0.015), (0.075, 0.007), (0.08, 0.0)], "ff8a2b", "x", sides=12,
         material="glow", crease=80.0).into(model)
    return model


def gun():
    """A stubby thrower held by its grip at the origin; the barrel points along x."""
    model = Model()
    grip = [ring((x, y, 0.0), (0.0, 0.0, hz), (hx, 0.0, 0.0), 10, 0.75, 0.5)
            for x, y, hx, hz in ((-0.030, -0.085, 0.034, 0.024), (-0.026, -0.078, 0.040, 0.028),
                                 (-0.004, 0.0, 0.034, 0.026), (0.006, 0.05, 0.036, 0.026))]
    loft(grip, DARK, crease=50.0).into(model)
    hoop((0.062, 0.022, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.036, 0.0075, DARK, 8, 6, span=math.radians(220),
         start=math.radians(160)).into(model)
    tube([(0.050, 0.046, 0.0), (0.056, 0.026, 0.0), (0.066, 0.012, 0.0)], [0.008, 0.008, 0.006], ORANGE, 6).into(model)
    body = [ring((x, 0.083, 0.0), (0.0, 0.0, hz), (0.0, hy, 0.0), 12, 0.65, 0.5)
            for x, hy, hz in ((-0.095, 0.026, 0.022), (-0.085, 0.042, 0.034), (0.0, 0.048, 0.040), (0.105, 0.046, 0.038),
                              (0.118, 0.036, 0.030))]
    loft(body, "eef0f2", crease=50.0).into(model)
    both(box((0.005, 0.088, 0.038), (0.058, 0.016, 0.008), ORANGE, 0.004), model)
    box((-0.03, 0.133, 0.0), (0.045, 0.010, 0.012), DARK, 0.004).into(model)
    spun([(0.105, 0.030), (0.115, 0.034), (0.225, 0.034), (0.228, 0.040), (0.258, 0.040), (0.262, 0.034), (0.258, 0.022),
          (0.235, 0.020)], STEEL, "x", (0.0, 0.085, 0.0), 14, "metal",
         [STEEL, STEEL, STEEL, ORANGE, ORANGE, DARK, DARK]).into(model)
    for x in (0.140, 0.168, 0.196):
        hoop((x, 0.085, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), 0.037, 0.0075, "78e2ff", 14, 6, "glow").into(model)
    return model


def pickaxe(head, edge, facets):
    """Held at the origin, the handle along y, the longer point along x."""
    model = Model()
    wood, dark_wood = "a5713f", "6f4a2a"
    handle = [(-0.20, 0.020), (-0.19, 0.026), (-0.165, 0.024), (-0.05, 0.0185), (0.06, 0.0185), (0.30, 0.019),
              (0.47, 0.023), (0.49, 0.020)]
    spun(handle, wood, sides=10, bands=[dark_wood, dark_wood, ORANGE, dark_wood, wood, wood, wood],
         crease=45.0).into(model)
    rows = []
    for k in range(13):
        s = -1.0 + 2.0 * k / 12
        x = 0.25 * s
        y = 0.435 - 0.115 * s * s
        tip = 1.0 - abs(s) ** 1.6
        rows.append(ring((x, y, 0.0), (0.0, 0.0, 0.007 + 0.024 * tip), (-0.35 * s * 0.03, 0.007 + 0.030 * tip, 0.0),
                         facets, 0.85, 0.5))
    bands = [edge if k in (0, 1, 10, 11) else head for k in range(12)]
    material = "paint" if head == "b98550" else "metal"
    loft(rows, head, material, bands, crease=25.0 if facets == 6 else 55.0).into(model)
    box((0.0, 0.432, 0.0), (0.040, 0.046, 0.036), DARK, 0.012).into(model)
    return model


def wooden_pickaxe():
    return pickaxe("b98550", "d9b078", 8)


def iron_pickaxe():
    return pickaxe("aeb7c1", "e6ebef", 8)


def diamond_pickaxe():
    return pickaxe("45d6d0", "b8fbf4", 6)


def log():
    """A piece of a trunk 1.2 m long that stands on its end."""
    model = Model()
    bark, pale, heart = "6b4a2f", "c79a63", "a8763f"
    rows = []
    for y, r in ((0.0, 0.150), (0.02, 0.163), (0.28, 0.156), (0.62, 0.160), (0.95, 0.153), (1.18, 0.160), (1.2, 0.148)):
        points = ring((0.0, y, 0.0), (0.0, 0.0, r), (r, 0.0, 0.0), 14)
        # Bark is not round: ribs go up it, and turn a little.
        ribs = [1.0 + 0.045 * math.cos(5.0 * math.tau * k / 14 + 0.9 * y) for k in range(14)]
        rows.append([(x * rib, h, z * rib) for (x, h, z), rib in zip(points, ribs)])
    loft(rows, bark, bands=[pale] + [bark] * 4 + [pale], crease=38.0).into(model)
    for y, up in ((1.2, 1.0), (0.0, -1.0)):
        profile = [(y, 0.140), (y + 0.004 * up, 0.138), (y + 0.005 * up, 0.0)]
        spun(profile if up > 0 else list(reversed(profile)), pale, sides=14).into(model)
        profile = [(y + 0.004 * up, 0.07), (y + 0.008 * up, 0.066), (y + 0.009 * up, 0.0)]
        spun(profile if up > 0 else list(reversed(profile)), heart, sides=10).into(model)
    # The end of a branch.
    tube([(0.12, 0.78, 0.03), (0.21, 0.84, 0.05)], [0.042, 0.030], bark, 7).into(model)
    spun([(0.208, 0.024), (0.2125, 0.0)], pale, "x", (0.0, 0.845, 0.05), 7).into(model)
    return model


def stone():
    """A stone half a metre across that lies on the ground."""
    model = Model()
    rows = []
    for k, (y, r) in enumerate(((0.0, 0.17), (0.06, 0.245), (0.20, 0.275), (0.34, 0.24), (0.44, 0.15), (0.47, 0.05))):
        points = ring((0.0, y, 0.0), (0.0, 0.0, 0.92 * r), (1.08 * r, 0.0, 0.0), 9, phase=0.3 * k)
        bumps = [1.0 + 0.09 * math.sin(2.7 * i + 1.9 * k) for i in range(9)]
        rows.append([(x * bump, h + 0.02 * (bump - 1.0) / 0.09 * min(k, 1), z * bump)
                     for (x, h, z), bump in zip(points, bumps)])
    bands = ["6f7377", "7d8286", "8b9094", "979c9f", "a3a7a9"]
    loft(rows, "8b9094", bands=bands, crease=16.0).into(model)
    return model


def crumb():
    """A lump of crusty bread 17 cm high, pale where it was broken, so that it is seen on any ground."""
    model = Model()
    crust, pale = "c9772e", "fbe6ae"
    ball((0.0, 0.070, 0.0), (0.105, 0.078, 0.090), crust, 0.8, 6, 10, crease=30.0).into(model)
    ball((0.050, 0.100, 0.030), (0.070, 0.062, 0.072), pale, 0.7, 5, 9, crease=20.0).into(model)
    ball((-0.050, 0.112, -0.020), (0.050, 0.044, 0.056), pale, 0.7, 5, 8, crease=20.0).into(model)
    return model


def seed():
    """A nut 7 cm high that lies with its tip up."""
    model = Model()
    nut, cap = "9a5b2a", "5d4427"
    spun([(0.0, 0.012), (0.006, 0.020), (0.022, 0.0245), (0.038, 0.023), (0.050, 0.016), (0.058, 0.006), (0.064, 0.0)], nut,
         sides=14, crease=70.0).into(model)
    spun([(-0.001, 0.0), (0.0, 0.016), (0.008, 0.0255), (0.020, 0.0275), (0.024, 0.0245)], cap, sides=14,
         bands=[cap, cap, "7a5c36", cap], crease=40.0).into(model)
    tube([(0.0, 0.060, 0.0), (0.006, 0.074, 0.0), (0.016, 0.082, 0.0)], [0.004, 0.0035, 0.002], "6fae3f", 6).into(model)
    return model
