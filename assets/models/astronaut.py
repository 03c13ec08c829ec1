"""The astronaut: one skeleton and one set of clips, two outfits.

Every joint's axes are the model's own in the bind pose (arms spread by ARM_DEG), so a joint's turn reads as: about
z swings ahead, about x swings sideways, about y twists.
"""

import math

from shapes import Model, ball, box, hoop, loft, ring, spun, tube
from vectors import add, dot, mix, mul, smooth, sub

ARM_DEG = 32.0
ARM = (0.0, -math.cos(math.radians(ARM_DEG)), math.sin(math.radians(ARM_DEG)))
UPPER_M, LOWER_M = 0.235, 0.225
THIGH_M, SHIN_M = 0.365, 0.365
ANKLE_M = 0.11
HALF_HIPS_M = 0.118
# Where the sole touches, from the ankle: the heel behind it, the ball ahead, under the toe joint, and the tip.
HEEL_M, BALL_M, TIP_M = -0.119, 0.105, 0.221

_SHOULDER = (-0.01, 1.262, 0.235)
_ELBOW = add(_SHOULDER, mul(ARM, UPPER_M))
_WRIST = add(_ELBOW, mul(ARM, LOWER_M))

# name -> (parent, place in the bind pose); the left is the mirror of the right.
JOINTS = {
    "hips": (None, (0.0, 0.86, 0.0)),
    "spine": ("hips", (0.0, 0.97, 0.0)),
    "chest": ("spine", (0.0, 1.12, 0.0)),
    "head": ("chest", (0.0, 1.36, 0.0)),
}
for _side, _sign in (("L", -1.0), ("R", 1.0)):
    def _at(p, sign=_sign):
        return (p[0], p[1], p[2] * sign)

    JOINTS.update({
        f"shoulder.{_side}": ("chest", _at((-0.01, 1.27, 0.11))),
        f"upper_arm.{_side}": (f"shoulder.{_side}", _at(_SHOULDER)),
        f"lower_arm.{_side}": (f"upper_arm.{_side}", _at(_ELBOW)),
        f"hand.{_side}": (f"lower_arm.{_side}", _at(_WRIST)),
        f"thigh.{_side}": ("hips", _at((0.0, ANKLE_M + SHIN_M + THIGH_M, HALF_HIPS_M))),
        f"shin.{_side}": (f"thigh.{_side}", _at((0.0, ANKLE_M + SHIN_M, HALF_HIPS_M))),
        f"foot.{_side}": (f"shin.{_side}", _at((0.0, ANKLE_M, HALF_HIPS_M))),
        f"toe.{_side}": (f"foot.{_side}", _at((BALL_M, 0.03, HALF_HIPS_M))),
    })
JOINTS["hold.R"] = ("hand.R", add(_WRIST, add(mul(ARM, 0.085), (0.035, 0.0, 0.0))))

WHITE = {
    "suit": "eef0f2", "fold": "d3d8de", "accent": "f4761a", "dark": "3a404c", "pack": "c9cfd6", "visor": "2a1a0c",
    "rim": "f4761a", "lamp": "78e2ff", "glove": "f4761a", "sole": "3a404c", "boot": "d9dde2",
}
TEAL = {
    "suit": "8d98a3", "fold": "78838f", "accent": "17b3a3", "dark": "2c333d", "pack": "5d6873", "visor": "0c2530",
    "rim": "e8eef0", "lamp": "ffd36b", "glove": "2c333d", "sole": "23282f", "boot": "4a545f",
}


def _blend(pairs):
    """Normalised weights of at most four joints."""
    pairs = sorted(((j, w) for j, w in pairs if w > 1e-3), key=lambda p: (-p[1], p[0]))[:4]
    total = sum(w for _, w in pairs)
    return [(j, w / total) for j, w in pairs]


def _all(joint):
    return lambda p: [(joint, 1.0)]


def _trunk(p):
    y = p[1]
    spine = smooth((y - 0.90) / 0.13)
    chest = smooth((y - 1.03) / 0.15)
    out = [("hips", 1.0 - spine), ("spine", spine * (1.0 - chest)), ("chest", spine * chest)]
    shoulder = 0.45 * smooth((abs(p[2]) - 0.10) / 0.12) * smooth((y - 1.14) / 0.12)
    side = "R" if p[2] > 0 else "L"
    thigh = 0.5 * smooth((0.86 - y) / 0.12) * smooth((abs(p[2]) - 0.04) / 0.14)
    out = [(j, w * (1.0 - shoulder) * (1.0 - thigh)) for j, w in out]
    return _blend(out + [(f"shoulder.{side}", shoulder), (f"thigh.{side}", thigh)])


def _limb(names, origin, way, bounds):
    """Weights along a limb: from each joint to the next within (middle, half width)."""
    def weigh(p):
        t = dot(sub(p, origin), way)
        share, out = 1.0, []
        for name, (middle, half) in zip(names, bounds):
            next_share = share * smooth((t - middle + half) / (2.0 * half))
            out.append((name, share - next_share))
            share = next_share
        return _blend(out + [(names[-1], share)])
    return weigh


def _trunk_rings():
    rows = []
    for y, x, rx, rz in (
        (0.725, 0.0, 0.085, 0.12), (0.765, 0.0, 0.145, 0.185), (0.85, 0.0, 0.168, 0.208), (0.935, 0.0, 0.166, 0.205),
        (0.99, 0.0, 0.166, 0.204), (1.07, 0.002, 0.18, 0.218), (1.18, 0.002, 0.193, 0.232),
        (1.27, -0.004, 0.185, 0.225), (1.335, -0.006, 0.158, 0.185), (1.39, 0.0, 0.125, 0.135),
    ):
        rows.append(ring((x, y, 0.0), (0.0, 0.0, rz), (rx, 0.0, 0.0), 14, 0.9, 0.5))
    return rows


def trunk(model, c):
    bands = [c["suit"]] * 9
    bands[3] = c["accent"]
    loft(_trunk_rings(), c["suit"], bands=bands, weigh=_trunk, crease=60.0).into(model)
    # The belt stands out from the suit, and has a buckle.
    rows = [ring((0.0, y, 0.0), (0.0, 0.0, rz), (rx, 0.0, 0.0), 14, 0.9, 0.5)
            for y, rx, rz in ((0.932, 0.160, 0.20), (0.938, 0.178, 0.217), (0.984, 0.178, 0.217), (0.990, 0.160, 0.20))]
    loft(rows, c["accent"], weigh=_trunk, crease=30.0).into(model)
    box((0.182, 0.961, 0.0), (0.012, 0.024, 0.038), c["dark"], 0.0, weigh=_trunk).into(model)
    # The panel on the chest with its lights and the hose to the pack.
    chest = _all("chest")
    box((0.196, 1.175, 0.0), (0.034, 0.068, 0.098), c["dark"], 0.016, weigh=chest).into(model)
    box((0.229, 1.197, -0.040), (0.010, 0.018, 0.026), c["accent"], 0.0, weigh=chest).into(model)
    box((0.229, 1.197, 0.036), (0.010, 0.018, 0.032), c["lamp"], 0.0, "glow", weigh=chest).into(model)
    box((0.229, 1.146, 0.0), (0.008, 0.010, 0.066), c["fold"], 0.0, weigh=chest).into(model)
    hoses = [(0.20, 1.13, 0.085), (0.195, 1.075, 0.16), (0.09, 1.05, 0.232), (-0.06, 1.06, 0.235), (-0.20, 1.10, 0.17)]
    hose = tube(hoses, [0.019] * 5, c["fold"], 6, weigh=_trunk, up=(0.0, 1.0, 0.0))
    hose.into(model)
    hose.mirrored().into(model)


def _visor_edge(a, scale, c):
    """A point of the opening: rounded, wider than high, on the helmet's sphere."""
    y = math.copysign(abs(math.sin(a)) ** c["square"], math.sin(a)) * c["high"] * scale
    z = math.copysign(abs(math.cos(a)) ** c["square"], math.cos(a)) * c["wide"] * scale
    return y - 0.004, z


HELMET = (0.0, 1.562, 0.0)
HELMET_M = 0.236


def _visor(model, c):
    head, sides = _all("head"), 16
    rows = []
    for scale in (1.0, 0.80, 0.50, 0.18):
        points = []
        for i in range(sides):
            y, z = _visor_edge(2.0 * math.pi * i / sides, scale, c)
            bulge = 0.004 + 0.010 * (1.0 - scale**2)
            points.append(add(HELMET, (math.sqrt(HELMET_M**2 - y**2 - z**2) + bulge, y, z)))
        rows.append(points)
    back = [add(HELMET, (0.05, p[1] - HELMET[1], p[2])) for p in rows[0]]
    loft([back] + rows, c["visor"], "visor", weigh=head, crease=80.0).into(model)
    rim = []
    for i in range(sides + 1):
        y, z = _visor_edge(2.0 * math.pi * (i % sides) / sides, 1.04, c)
        x = math.sqrt(HELMET_M**2 - y**2 - z**2)
        out = (0.35, y / 0.2, z / 0.2)
        size = math.sqrt(dot(out, out))
        out = mul(out, 1.0 / size)
        rim.append(ring(add(HELMET, (x - 0.004, y, z)), mul(out, 0.021), (0.024, 0.0, 0.0), 5, 1.0, 0.5))
    loft(rim, c["rim"], weigh=head, caps=(False, False), crease=75.0).into(model)


def helmet(model, c, kind):
    head = _all("head")
    c = dict(c, **({"square": 0.72, "high": 0.132, "wide": 0.176} if kind == "round"
                   else {"square": 0.88, "high": 0.155, "wide": 0.182}))
    ball(HELMET, (HELMET_M, HELMET_M, HELMET_M), c["suit"], 0.97, 8, 16, weigh=head, crease=80.0).into(model)
    _visor(model, c)
    hoop((0.0, 1.375, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), 0.150, 0.030, c["accent"], 14, 5, weigh=_all("chest"),
         across=0.026).into(model)
    ear = spun([(0.0, 0.072), (0.030, 0.068), (0.042, 0.048)], c["dark"], "z", (-0.015, 1.562, 0.212), 12, weigh=head,
               bands=[c["fold"], c["fold"]])
    ear.into(model)
    ear.mirrored().into(model)
    dot_ = spun([(0.0, 0.034), (0.012, 0.030)], c["accent"], "z", (-0.015, 1.562, 0.250), 8, weigh=head)
    dot_.into(model)
    dot_.mirrored().into(model)
    if kind == "round":
        # One stripe over the crown.
        rows = []
        for k in range(9):
            a = math.radians(56 + 14.5 * k)
            out = (math.cos(a), math.sin(a), 0.0)
            rows.append(ring(add(HELMET, mul(out, HELMET_M - 0.002)), (0.0, 0.0, 0.034), mul(out, 0.010), 6, 0.8, 0.5))
        loft(rows, c["accent"], weigh=head, crease=60.0).into(model)
    else:
        # Two searchlights on the brow, and a crest.
        for side in (-1.0, 1.0):
            place = (0.10, 1.722, side * 0.122)
            spun([(-0.05, 0.020), (-0.03, 0.036), (0.03, 0.042), (0.034, 0.036)], c["dark"], "x", place, 10,
                 weigh=head).into(model)
            spun([(0.030, 0.032), (0.040, 0.026)], c["lamp"], "x", place, 10, "glow", weigh=head).into(model)
        rows = []
        for k in range(8):
            a = math.radians(62 + 15 * k)
            out = (math.cos(a), math.sin(a), 0.0)
            rows.append(ring(add(HELMET, mul(out, HELMET_M - 0.013)), (0.0, 0.0, 0.020), mul(out, 0.026), 6, 0.8, 0.5))
        loft(rows, c["accent"], weigh=head, crease=60.0).into(model)


def pack(model, c, kind):
    chest = _all("chest")
    if kind == "round":
        ball((-0.262, 1.165, 0.0), (0.118, 0.262, 0.205), c["pack"], 0.45, 6, 12, weigh=chest, crease=48.0).into(model)
        ball((-0.268, 1.335, 0.0), (0.121, 0.040, 0.212), c["accent"], 0.45, 4, 12, weigh=chest).into(model)
        box((-0.378, 1.115, 0.0), (0.018, 0.105, 0.115), c["dark"], 0.014, weigh=chest).into(model)
        for k in range(2):
            box((-0.394, 1.08 + 0.07 * k, 0.0), (0.008, 0.015, 0.085), c["fold"], 0.0, weigh=chest).into(model)
        tube([(-0.30, 1.38, -0.15), (-0.305, 1.56, -0.152), (-0.31, 1.735, -0.155)], [0.011, 0.009, 0.008], c["fold"],
             6, weigh=chest).into(model)
        ball((-0.31, 1.748, -0.155), (0.026, 0.026, 0.026), c["accent"], 1.0, 4, 8, weigh=chest).into(model)
        return
    box((-0.235, 1.165, 0.0), (0.075, 0.20, 0.15), c["pack"], 0.03, weigh=chest).into(model)
    for side in (-1.0, 1.0):
        profile = [(0.92, 0.03), (0.935, 0.075), (0.97, 0.094), (1.05, 0.096), (1.052, 0.10), (1.10, 0.10),
                   (1.102, 0.096), (1.34, 0.096), (1.395, 0.075), (1.42, 0.03)]
        bands = [c["dark"], c["dark"], c["fold"], c["accent"], c["accent"], c["accent"], c["fold"], c["accent"],
                 c["accent"]]
        spun(profile, c["fold"], "y", (-0.29, 0.0, side * 0.112), 12, bands=bands, weigh=chest).into(model)
        spun([(1.415, 0.028), (1.45, 0.028), (1.455, 0.02)], c["dark"], "y", (-0.29, 0.0, side * 0.112), 8,
             weigh=chest).into(model)
    tube([(-0.29, 1.44, -0.112), (-0.29, 1.46, 0.0), (-0.29, 1.44, 0.112)], [0.014] * 3, c["dark"], 6,
         weigh=chest).into(model)


def arm(model, c):
    """The right arm and its mirror."""
    weigh = _limb(["shoulder.R", "upper_arm.R", "lower_arm.R", "hand.R"], _SHOULDER, ARM,
                  [(0.0, 0.07), (UPPER_M, 0.055), (UPPER_M + LOWER_M, 0.03)])
    marks = [(-0.075, 0.070), (-0.04, 0.100), (0.01, 0.108), (0.06, 0.100), (0.10, 0.094), (0.135, 0.092),
             (0.175, 0.091), (0.215, 0.089), (0.245, 0.088), (0.32, 0.094), (0.40, 0.082)]
    path = [add(_SHOULDER, mul(ARM, t)) for t, _ in marks]
    bands = [c["suit"]] * 10
    bands[4] = c["accent"]
    bands[7] = c["fold"]
    pieces = [tube(path, [r for _, r in marks], c["suit"], 10, bands=bands, weigh=weigh, crease=60.0)]
    # The cuff, the palm, four fingers closed as one, and the thumb ahead of them.
    at = lambda t, x=0.0: add(add(_SHOULDER, mul(ARM, UPPER_M + LOWER_M + t)), (x, 0.0, 0.0))
    pieces.append(tube([at(-0.065), at(-0.058), at(-0.012), at(-0.004)], [0.070, 0.087, 0.083, 0.066], c["dark"], 10,
                       weigh=weigh, crease=35.0))
    pieces.append(tube([at(-0.02), at(0.005), at(0.045), at(0.085), at(0.105)],
                       [(0.050, 0.046), (0.060, 0.054), (0.068, 0.058), (0.064, 0.054), (0.040, 0.034)], c["glove"], 9,
                       weigh=weigh, crease=75.0, power=0.85))
    pieces.append(tube([at(0.085, -0.02), at(0.122, -0.005), at(0.132, 0.03), at(0.108, 0.058)],
                       [(0.036, 0.052), (0.036, 0.054), (0.032, 0.052), (0.022, 0.042)], c["glove"], 7,
                       weigh=_all("hand.R"), crease=75.0, up=ARM))
    pieces.append(tube([at(0.02, 0.045), at(0.045, 0.082), at(0.082, 0.088), at(0.098, 0.080)],
                       [0.022, 0.027, 0.025, 0.014], c["glove"], 6, weigh=_all("hand.R"), crease=75.0,
                       up=(0.0, 0.3, 1.0)))
    for piece in pieces:
        piece.into(model)
        _left(piece).into(model)


def _left(piece):
    """The mirror, with the other side's joints."""
    other = piece.mirrored()
    right = piece.weigh
    other.weigh = lambda p: [(j.replace(".R", ".L") if j.endswith(".R") else j, w)
                             for j, w in right((p[0], p[1], -p[2]))]
    return other


def leg(model, c):
    """The right leg and its mirror."""
    top = JOINTS["thigh.R"][1]
    weigh = _limb(["hips", "thigh.R", "shin.R", "foot.R"], top, (0.0, -1.0, 0.0),
                  [(-0.02, 0.08), (THIGH_M, 0.06), (THIGH_M + SHIN_M - 0.02, 0.05)])
    marks = [(0.84, 0.085, 0.0), (0.79, 0.116, 0.0), (0.70, 0.119, 0.0), (0.60, 0.108, 0.0),
             (0.555, 0.103, 0.002), (0.51, 0.100, 0.004), (0.475, 0.099, 0.004), (0.44, 0.099, 0.002),
             (0.38, 0.103, -0.006), (0.30, 0.105, -0.008), (0.22, 0.100, -0.003)]
    path = [(x, y, HALF_HIPS_M + 0.004) for y, _, x in marks]
    bands = [c["suit"]] * 10
    bands[2] = c["fold"]
    pieces = [tube(path, [(r, r * 0.94) for _, r, _ in marks], c["suit"], 10, bands=bands, weigh=weigh, crease=60.0)]
    knee = ball((0.072, 0.480, HALF_HIPS_M + 0.004), (0.045, 0.072, 0.070), c["accent"], 0.8, 5, 8, weigh=weigh)
    pieces.append(knee)
    pieces.extend(_boot(c, weigh))
    for piece in pieces:
        piece.into(model)
        _left(piece).into(model)


def _boot(c, leg_weigh):
    z = HALF_HIPS_M + 0.004

    def weigh(p):
        toe = smooth((p[0] - 0.06) / 0.09)
        return _blend([("foot.R", 1.0 - toe), ("toe.R", toe)])

    shaft = tube([(0.0, y, z) for y in (0.265, 0.258, 0.20, 0.11)],
                 [(0.096, 0.092), (0.115, 0.109), (0.112, 0.104), (0.105, 0.096)], c["boot"], 10, weigh=leg_weigh,
                 bands=[c["accent"], c["boot"], c["boot"]], crease=35.0)
    rows = []
    for x, top, half in ((-0.118, 0.085, 0.050), (-0.105, 0.135, 0.080), (-0.04, 0.172, 0.095),
                         (0.085, 0.145, 0.104), (0.145, 0.125, 0.106), (0.195, 0.100, 0.092), (0.218, 0.070, 0.060)):
        middle = (x, (top + 0.025) / 2.0, z)
        rows.append(ring(middle, (0.0, 0.0, half), (0.0, (top - 0.025) / 2.0, 0.0), 10, 0.78, 0.5))
    upper = loft(rows, c["boot"], weigh=weigh, crease=75.0)
    outline = [(-0.125, 0.045), (-0.118, 0.078), (-0.06, 0.096), (0.02, 0.098), (0.085, 0.106), (0.15, 0.110),
               (0.205, 0.094), (0.228, 0.060)]
    edge = [(x, 0.0, h) for x, h in outline] + [(x, 0.0, -h) for x, h in reversed(outline)]
    sole = loft([[(x * s, y, z + h * s) for x, _, h in edge] for y, s in ((0.0, 0.97), (0.008, 1.0), (0.044, 0.98))],
                c["sole"], weigh=weigh, crease=40.0)
    return [shaft, upper, sole]


def astronaut(colours, kind):
    model = Model()
    trunk(model, colours)
    helmet(model, colours, kind)
    pack(model, colours, kind)
    arm(model, colours)
    leg(model, colours)
    return model
