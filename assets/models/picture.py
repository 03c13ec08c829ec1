"""A small software renderer and PNG writer: linear light, a warm key, a cool sky, filmic tones, samples averaged."""

import math
import struct
import zlib

from vectors import add, cross, dot, mul, sub, unit

KEY = unit((0.55, 0.80, 0.50))
KEY_LIGHT = (2.35, 2.18, 1.90)
SKY = (0.62, 0.72, 0.90)
BOUNCE = (0.46, 0.40, 0.34)
# material -> (gloss, glow): how strong highlights are, and what share of the colour shines by itself.
SURFACE = {"paint": (0.10, 0.0), "metal": (0.5, 0.0), "visor": (0.9, 0.0), "glow": (0.1, 1.6), "glass": (0.8, 0.0),
           "rubber": (0.05, 0.0), "globe": (0.4, 1.1)}
# What is clear covers this share of what is behind it.
CLEARNESS = {"glass": 0.35, "globe": 0.5}


class Camera:
    """Looks at a point from a direction, with a narrow lens so that proportions are true."""

    def __init__(self, target, heading_deg, height_deg, span_m, width, height):
        a, e = math.radians(heading_deg), math.radians(height_deg)
        self.back = (math.cos(a) * math.cos(e), math.sin(e), math.sin(a) * math.cos(e))
        self.right = unit(cross((0.0, 1.0, 0.0), self.back))
        self.up = cross(self.back, self.right)
        self.distance = span_m * 3.2
        self.eye = add(target, mul(self.back, self.distance))
        self.scale = height / span_m * self.distance
        self.middle = (width / 2.0, height / 2.0)

    def roll(self, degrees):
        """Turns the picture about its middle, clockwise positive."""
        a = math.radians(degrees)
        c, s = math.cos(a), math.sin(a)
        self.right, self.up = (add(mul(self.right, c), mul(self.up, s)), sub(mul(self.up, c), mul(self.right, s)))

    def place(self, p):
        d = sub(p, self.eye)
        depth = -dot(d, self.back)
        k = self.scale / depth
        return (self.middle[0] + dot(d, self.right) * k, self.middle[1] - dot(d, self.up) * k, depth)


class Picture:
    """Linear colour, cover and depth, `samples` squared for each pixel."""

    def __init__(self, width, height, samples=2):
        self.width, self.height, self.samples = width, height, samples
        self.w, self.h = width * samples, height * samples
        self.colour = [None] * (self.w * self.h)
        self.depth = [1e9] * (self.w * self.h)

    def camera(self, target, heading_deg, height_deg, span_m, cell=None):
        """`cell` (x, y, width, height) in pixels makes it a part of the picture."""
        s = self.samples
        x, y, w, h = cell or (0, 0, self.width, self.height)
        out = Camera(target, heading_deg, height_deg, span_m, w * s, h * s)
        out.middle = ((x + w / 2.0) * s, (y + h / 2.0) * s)
        out.cell = (x * s, y * s, (x + w) * s, (y + h) * s)
        return out

    def draw(self, camera, triangles, opacity=1.0):
        """Triangles of (places, normals, colour, material); clear ones last."""
        for places, normals, colour, material in triangles:
            self._triangle(camera, [camera.place(p) for p in places], places, normals, colour, material, opacity)

    def model(self, camera, model, move=lambda v: (v[0], v[1])):
        """Draws a model, what is clear last; `move` gives a vertex's place and normal."""
        for material in sorted(model.parts, key=lambda m: m in CLEARNESS):
            vertices, triangles, _ = model.parts[material]
            moved = [move(v) for v in vertices]
            kind = material.split(".")[0]
            self.draw(camera, (([moved[i][0] for i in t], [moved[i][1] for i in t], vertices[t[0]][2], kind)
                               for t in triangles), CLEARNESS.get(kind, 1.0))

    def _triangle(self, camera, q, places, normals, colour, material, opacity):
        (x0, y0, z0), (x1, y1, z1), (x2, y2, z2) = q
        area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        if area >= -1e-9:
            return
        left, top, right, bottom = camera.cell
        xa, xb = max(int(min(x0, x1, x2)), left), min(int(max(x0, x1, x2)) + 1, right)
        ya, yb = max(int(min(y0, y1, y2)), top), min(int(max(y0, y1, y2)) + 1, bottom)
        toward = unit(sub(camera.eye, places[0]))
        for y in range(ya, yb):
            for x in range(xa, xb):
                px, py = x + 0.5, y + 0.5
                a = ((x1 - px) * (y2 - py) - (x2 - px) * (y1 - py)) / area
                if a < 0.0:
                    continue
                b = ((x2 - px) * (y0 - py) - (x0 - px) * (y2 - py)) / area
                c = 1.0 - a - b
                if b < 0.0 or c < 0.0:
                    continue
                z = a * z0 + b * z1 + c * z2
                at = y * self.w + x
                if z >= self.depth[at]:
                    continue
                n = add(add(mul(normals[0], a), mul(normals[1], b)), mul(normals[2], c))
                light = shade(unit(n), toward, colour, material)
                if opacity < 1.0:
                    under = self.colour[at]
                    if under is None:
                        self.colour[at] = light
                    else:
                        self.colour[at] = tuple(u + (v - u) * opacity for u, v in zip(under, light))
                else:
                    self.colour[at], self.depth[at] = light, z

    def shadow(self, camera, centre, radius_m, depth=0.42):
        """A soft round shade on the ground at `centre`, under whatever is drawn."""
        left, top, right, bottom = camera.cell
        cx, cy, d = camera.place(centre)
        rx = radius_m * camera.scale / d
        ry = rx * max(camera.back[1], 0.05)
        for y in range(max(top, int(cy - ry)), min(bottom, int(cy + ry) + 1)):
            for x in range(max(left, int(cx - rx)), min(right, int(cx + rx) + 1)):
                r2 = ((x - cx) / rx) ** 2 + ((y - cy) / ry) ** 2
                at = y * self.w + x
                if r2 < 1.0 and self.colour[at] is None:
                    self.colour[at] = ("shade", depth * (1.0 - r2) ** 1.5)

    def pixels(self, background=None):
        """RGBA bytes; `background` is a function of height 0 to 1 that gives linear light, or none."""
        out = bytearray()
        s = self.samples
        for y in range(self.height):
            behind = background(y / self.height) if background else None
            for x in range(self.width):
                total, cover = [0.0, 0.0, 0.0], 0.0
                for sy in range(s):
                    row = (y * s + sy) * self.w + x * s
                    for k in range(row, row + s):
                        c = self.colour[k]
                        if c is not None and c[0] == "shade":
                            c = tuple(v * (1.0 - c[1]) for v in behind) if behind else None
                        elif c is None:
                            c = behind
                        if c is not None:
                            cover += 1.0
                            for i in range(3):
                                total[i] += tone(c[i])
                # Averaged after the tone map, so that edges of bright things are smooth.
                if cover == 0.0:
                    out += b"\0\0\0\0"
                else:
                    out += bytes(int(to_srgb(v / cover) * 255.0 + 0.5) for v in total)
                    out.append(int(cover / (s * s) * 255.0 + 0.5))
        return bytes(out)


def shade(n, toward, colour, material):
    gloss, glow = SURFACE[material]
    lit = max(dot(n, KEY) * 0.85 + 0.15, 0.0)
    sky = 0.5 + 0.5 * n[1]
    half = unit(add(KEY, toward))
    spark = max(dot(n, half), 0.0)
    edge = (1.0 - max(dot(n, toward), 0.0)) ** 4
    shine = gloss * (spark ** (20.0 + 160.0 * gloss)) * 2.4
    # A window of sky in glossy things, which is what tells glass from black paint.
    bounce = sub(mul(n, 2.0 * dot(n, toward)), toward)
    window = gloss * gloss * max(0.0, min(1.0, (bounce[1] - 0.1) * 3.0)) * (0.10 + 0.8 * edge)
    out = []
    for i in range(3):
        ambient = BOUNCE[i] + (SKY[i] - BOUNCE[i]) * sky
        out.append(colour[i] * (KEY_LIGHT[i] * lit * 0.62 + ambient * 0.62 + glow) + shine + (edge * 0.16 + window) * SKY[i])
    return tuple(out)


def tone(v):
    """The usual rational fit of the ACES curve (Narkowicz 2015)."""
    v *= 0.72
    return min(max(v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14), 0.0), 1.0)


def to_srgb(v):
    return v * 12.92 if v <= 0.0031308 else 1.055 * v ** (1.0 / 2.4) - 0.055


def _palette(rgb, most):
    """At most `most` colours for a picture by median cut: the box that is widest and fullest is halved."""
    counts = {}
    for i in range(0, len(rgb), 3):
        c = (rgb[i] & 0xFC, rgb[i + 1] & 0xFC, rgb[i + 2] & 0xFC)
        counts[c] = counts.get(c, 0) + 1
    boxes = [sorted(counts)]

    def width(box):
        return max((max(c[k] for c in box) - min(c[k] for c in box), -k) for k in range(3))

    while len(boxes) < most:
        scores = [(width(b)[0] * math.sqrt(len(b)), i) for i, b in enumerate(boxes) if len(b) > 1]
        if not scores:
            break
        box = boxes.pop(max(scores)[1])
        axis = -width(box)[1]
        box.sort(key=lambda c: (c[axis], c))
        boxes += [box[: len(box) // 2], box[len(box) // 2 :]]
    colours, number = bytearray(), {}
    for i, box in enumerate(boxes):
        total = sum(counts[c] for c in box)
        colours += bytes(round(sum(c[k] * counts[c] for c in box) / total) for k in range(3))
        number.update((c, i) for c in box)
    return bytes(colours), number


def small_png(width, height, rgba, most=96):
    """A PNG of few colours and without cover, for documents."""
    rgb = bytes(v for i, v in enumerate(rgba) if i % 4 != 3)
    colours, number = _palette(rgb, most)
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for i in range(y * width * 3, (y + 1) * width * 3, 3):
            rows.append(number[rgb[i] & 0xFC, rgb[i + 1] & 0xFC, rgb[i + 2] & 0xFC])
    head = struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)
    return _file((b"IHDR", head), (b"PLTE", colours), (b"IDAT", zlib.compress(bytes(rows), 9)), (b"IEND", b""))


def _file(*chunks):
    out = b"\x89PNG\r\n\x1a\n"
    for kind, data in chunks:
        out += struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return out


def png(width, height, rgba):
    """A PNG file's bytes."""
    depth = 4
    rows = bytearray()
    before = bytes(width * depth)
    for y in range(height):
        row = rgba[y * width * depth : (y + 1) * width * depth]
        # Filter 4 (Paeth), which soft shading packs best with.
        rows.append(4)
        for i in range(width * depth):
            a, b = (row[i - depth] if i >= depth else 0), before[i]
            c = before[i - depth] if i >= depth else 0
            pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
            guess = a if pa <= pb and pa <= pc else (b if pb <= pc else c)
            rows.append((row[i] - guess) & 255)
        before = row
    head = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return _file((b"IHDR", head), (b"IDAT", zlib.compress(bytes(rows), 9)), (b"IEND", b""))
