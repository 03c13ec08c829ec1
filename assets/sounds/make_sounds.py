#!/usr/bin/env python3
"""Makes every sound of the game, from nothing but noise and sines.

    python3 assets/sounds/make_sounds.py            writes the files beside this script
    python3 assets/sounds/make_sounds.py --check    fails where a file differs from what would be written

Only Python's own library is used. The noise is a generator of our own with a fixed seed for each sound, so the
same samples come out every time. Files are mono, 16 bit; what has no high tones has fewer samples a second.
"""

import math
import struct
import sys
import wave
from io import BytesIO
from pathlib import Path

RATE = 22050
# Beds and wind are long, and there is little above 6 kHz in them.
BED_RATE = 16000
WIND_RATE = 8000
TAU = 2.0 * math.pi


class Noise:
    """White noise within -1 to 1: the 64-bit generator of L'Ecuyer's table with Knuth's constants."""

    def __init__(self, name):
        self.state = 0x9E3779B97F4A7C15
        for byte in name.encode():
            self.state = (self.state ^ byte) * 0x100000001B3 % 2**64

    def next(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 40) / 2**23 - 1.0

    def between(self, low, high):
        return low + (high - low) * 0.5 * (self.next() + 1.0)

    def take(self, count):
        return [self.next() for _ in range(count)]


def samples(seconds, rate=RATE):
    return round(seconds * rate)


def biquad(signal, kind, hz, q, rate=RATE, periodic=False):
    """Low, high or band pass of second order (R. Bristow-Johnson's cookbook). A periodic signal stays periodic:
    the filter runs through it once before what it gives is kept."""
    w = TAU * hz / rate
    alpha = math.sin(w) / (2.0 * q)
    c = math.cos(w)
    b0, b1, b2 = {
        "low": ((1 - c) / 2, 1 - c, (1 - c) / 2),
        "high": ((1 + c) / 2, -(1 + c), (1 + c) / 2),
        "band": (alpha, 0.0, -alpha),
    }[kind]
    a0, a1, a2 = 1 + alpha, -2 * c, 1 - alpha
    b0, b1, b2, a1, a2 = b0 / a0, b1 / a0, b2 / a0, a1 / a0, a2 / a0
    x1 = x2 = y1 = y2 = 0.0
    out = []
    for turn in range(2 if periodic else 1):
        out = []
        for x in signal:
            y = b0 * x + b1 * x1 + b2 * x2 - a1 * y1 - a2 * y2
            x2, x1, y2, y1 = x1, x, y1, y
            out.append(y)
    return out


def fall(signal, attack_s, decay_s, rate=RATE):
    """Rises within `attack_s` and falls to 1/e within every `decay_s` after it."""
    attack = max(1, samples(attack_s, rate))
    out = []
    for i, x in enumerate(signal):
        gain = i / attack if i < attack else math.exp(-(i - attack) / (decay_s * rate))
        out.append(x * gain)
    return out


def sine(hz, seconds, rate=RATE, to_hz=None):
    """A sine, gliding from `hz` to `to_hz`."""
    count, phase, out = samples(seconds, rate), 0.0, []
    for i in range(count):
        now = hz if to_hz is None else hz * (to_hz / hz) ** (i / count)
        phase += TAU * now / rate
        out.append(math.sin(phase))
    return out


def mix(*parts):
    """Sum of (gain, signal) or (gain, signal, start in samples)."""
    total = [0.0] * max(len(p[1]) + (p[2] if len(p) > 2 else 0) for p in parts)
    for part in parts:
        start = part[2] if len(part) > 2 else 0
        for i, x in enumerate(part[1]):
            total[start + i] += part[0] * x
    return total


def wrap_in(loop, gain, signal, start):
    """Adds a sound to a loop; what goes past its end comes in at its beginning."""
    for i, x in enumerate(signal):
        loop[(start + i) % len(loop)] += gain * x


def burst(noise, seconds, kind, hz, q, attack_s, decay_s):
    return fall(biquad(noise.take(samples(seconds)), kind, hz, q), attack_s, decay_s)


def grains(noise, seconds, count, low_hz, high_hz, decay_s):
    """Many small knocks, as of stones or crumbs, sparser towards the end."""
    total = [0.0] * samples(seconds)
    for _ in range(count):
        start = int(len(total) * 0.8 * noise.between(0.0, 1.0) ** 1.6)
        grain = burst(noise, 4 * decay_s, "band", noise.between(low_hz, high_hz), 3.0, 0.0005, decay_s)
        gain = noise.between(0.4, 1.0) * (1.0 - 0.7 * start / len(total))
        for i, x in enumerate(grain[: len(total) - start]):
            total[start + i] += gain * x
    return total


def step_rock(noise):
    tap = burst(noise, 0.12, "high", 1500.0, 0.7, 0.0005, 0.006)
    ring = burst(noise, 0.12, "band", noise.between(1500.0, 1900.0), 8.0, 0.001, 0.02)
    heel = burst(noise, 0.12, "low", 260.0, 0.9, 0.002, 0.022)
    return mix((0.35, tap), (1.6, ring), (1.3, heel))


def step_gravel(noise):
    crunch = grains(noise, 0.17, 22, 1200.0, 3600.0, 0.005)
    heel = burst(noise, 0.12, "low", 300.0, 0.8, 0.002, 0.025)
    return mix((1.0, crunch), (0.8, heel))


def step_sand(noise):
    slide = burst(noise, 0.20, "band", noise.between(2300.0, 2900.0), 0.6, 0.018, 0.042)
    heel = burst(noise, 0.12, "low", 190.0, 0.8, 0.006, 0.03)
    return mix((1.0, slide), (1.1, heel))


def step_soil(noise):
    heel = burst(noise, 0.18, "low", noise.between(300.0, 380.0), 0.9, 0.003, 0.038)
    crumbs = grains(noise, 0.14, 7, 600.0, 1500.0, 0.006)
    return mix((1.6, heel), (0.35, crumbs))


def step_grass(noise):
    blades = burst(noise, 0.20, "band", noise.between(3300.0, 4100.0), 0.9, 0.022, 0.035)
    second = burst(noise, 0.10, "band", 4600.0, 1.1, 0.01, 0.018)
    heel = burst(noise, 0.14, "low", 240.0, 0.8, 0.004, 0.03)
    return mix((0.8, blades), (0.35, second, samples(0.05)), (1.3, heel))


def landing(noise, heavy):
    thump = fall(sine(95.0 if heavy else 120.0, 0.38, to_hz=42.0 if heavy else 70.0), 0.003, 0.09 if heavy else 0.05)
    body = burst(noise, 0.30, "low", 420.0, 0.7, 0.002, 0.06 if heavy else 0.03)
    crumbs = grains(noise, 0.30, 24 if heavy else 7, 700.0, 2400.0, 0.007)
    return mix((0.9, thump), (1.3, body), (0.55 if heavy else 0.2, crumbs))


def dig(noise):
    bite = burst(noise, 0.20, "band", noise.between(650.0, 900.0), 1.2, 0.002, 0.03)
    crumbs = grains(noise, 0.30, 30, 500.0, 2200.0, 0.008)
    thump = fall(sine(130.0, 0.16, to_hz=80.0), 0.002, 0.04)
    return mix((1.4, bite), (0.7, crumbs), (0.5, thump))


def build(noise):
    """The reverse of digging: crumbs that gather, and a knock that closes."""
    crumbs = list(reversed(grains(noise, 0.18, 20, 400.0, 1600.0, 0.008)))
    knock = fall(sine(150.0, 0.14, to_hz=105.0), 0.002, 0.035)
    press = burst(noise, 0.14, "low", 500.0, 0.8, 0.004, 0.03)
    return mix((0.6, crumbs), (0.7, knock, samples(0.13)), (1.0, press, samples(0.13)))


def shot(noise):
    """A dry pop of compressed gas: a knock, a hiss that closes fast, and a short tail."""
    knock = fall(sine(230.0, 0.20, to_hz=70.0), 0.001, 0.03)
    hiss = burst(noise, 0.22, "band", 1700.0, 0.6, 0.0008, 0.024)
    tail = burst(noise, 0.35, "low", 700.0, 0.7, 0.004, 0.07)
    return mix((1.0, knock), (1.4, hiss), (0.5, tail))


def click(noise):
    first = burst(noise, 0.04, "band", 2600.0, 4.0, 0.0004, 0.004)
    second = burst(noise, 0.04, "band", 1900.0, 4.0, 0.0004, 0.005)
    return mix((1.0, first), (0.8, second, samples(0.035)))


def struck(noise):
    """A bullet on a padded suit."""
    slap = burst(noise, 0.14, "band", 900.0, 1.0, 0.001, 0.014)
    thud = fall(sine(170.0, 0.18, to_hz=90.0), 0.002, 0.03)
    return mix((1.0, slap), (0.9, thud))


def hurt(noise):
    """A blow as it is heard from inside the helmet."""
    thud = fall(sine(110.0, 0.34, to_hz=55.0), 0.003, 0.07)
    breath = burst(noise, 0.30, "band", 520.0, 1.1, 0.02, 0.05)
    return mix((1.0, thud), (0.8, breath))


def lamp(noise):
    """Glass and metal set down, and the glow coming on."""
    tap = burst(noise, 0.08, "band", 3100.0, 7.0, 0.0005, 0.012)
    glass = fall(sine(1860.0, 0.5), 0.001, 0.08)
    hum = fall(sine(310.0, 0.5, to_hz=330.0), 0.06, 0.12)
    return mix((1.2, tap), (0.35, glass), (0.4, hum))


def pick_up(noise):
    return mix((0.8, fall(sine(520.0, 0.16, to_hz=700.0), 0.004, 0.03)), (0.6, fall(sine(780.0, 0.2), 0.003, 0.035), samples(0.05)))


def blip(hz, decay_s, overtone=0.0):
    seconds = 6.0 * decay_s
    return mix((1.0, fall(sine(hz, seconds), 0.002, decay_s)), (overtone, fall(sine(2.76 * hz, seconds), 0.001, decay_s / 3)))


def wind(noise):
    """Loop of 6 s: noise whose pitch and strength wander; the wanderings have whole periods in the loop."""
    count = samples(6.0, WIND_RATE)
    white = noise.take(count)
    low = biquad(white, "band", 240.0, 0.8, WIND_RATE, periodic=True)
    high = biquad(white, "band", 620.0, 1.4, WIND_RATE, periodic=True)
    out = []
    for i in range(count):
        t = TAU * i / count
        swell = 0.62 + 0.22 * math.sin(t + 0.4) + 0.16 * math.sin(3 * t + 2.0)
        howl = 0.5 + 0.3 * math.sin(2 * t) + 0.2 * math.sin(5 * t + 1.0)
        out.append(swell * (low[i] + 0.6 * howl * high[i]))
    return out


def bird(noise, rate):
    """One short call: two to four chirps that glide."""
    call, gap = [], noise.between(0.07, 0.12)
    base = noise.between(2600.0, 3900.0)
    for n in range(2 + int(noise.between(0.0, 2.99))):
        chirp = sine(base * noise.between(0.9, 1.15), 0.07, rate, to_hz=base * noise.between(0.8, 1.25))
        count = len(chirp)
        shaped = [x * math.sin(math.pi * i / count) ** 2 for i, x in enumerate(chirp)]
        call.append((noise.between(0.6, 1.0), shaped, samples(n * (0.07 + gap), rate)))
    return mix(*call)


def day(noise):
    """Loop of 9 s: leaves in light air, and birds a way off."""
    count = samples(9.0, BED_RATE)
    air = biquad(noise.take(count), "band", 900.0, 0.5, BED_RATE, periodic=True)
    loop = [x * (0.10 + 0.04 * math.sin(TAU * 2 * i / count)) for i, x in enumerate(air)]
    for n in range(5):
        start = samples(9.0 * (n + noise.between(0.1, 0.8)) / 5.0, BED_RATE)
        wrap_in(loop, noise.between(0.10, 0.28), bird(noise, BED_RATE), start)
    return loop


def night(noise):
    """Loop of 9 s: crickets at two distances over air that hardly moves."""
    count = samples(9.0, BED_RATE)
    loop = [0.35 * x for x in biquad(noise.take(count), "low", 320.0, 0.7, BED_RATE, periodic=True)]
    for hz, chirps, gain, shift in [(4300.0, 13, 0.22, 0.0), (3850.0, 9, 0.10, 0.31), (4620.0, 6, 0.06, 0.77)]:
        for n in range(chirps):
            for pulse in range(3):
                tone = sine(hz, 0.028, BED_RATE)
                shaped = [x * math.sin(math.pi * i / len(tone)) ** 2 for i, x in enumerate(tone)]
                at_s = 9.0 * (n + noise.between(0.0, 0.12)) / chirps + shift + 0.045 * pulse
                wrap_in(loop, gain * (0.7 + 0.15 * pulse), shaped, samples(at_s, BED_RATE))
    return loop


def pad(noise):
    """A4 as a slow chord of strings would play it: detuned partials that rise and fade."""
    seconds, parts = 3.2, []
    for partial, gain in [(0.5, 0.45), (1.0, 1.0), (2.0, 0.32), (3.0, 0.14), (4.0, 0.05)]:
        for detune in (-0.0018, 0.0023):
            parts.append((gain, sine(440.0 * partial * (1.0 + detune), seconds)))
    tone = mix(*parts)
    count = len(tone)
    return [x * math.sin(math.pi * (i / count) ** 0.6) ** 2 for i, x in enumerate(tone)]


def bell(noise):
    """A4 struck: partials of a bar, the higher the sooner gone."""
    return mix(*((gain, fall(sine(440.0 * partial, 2.4), 0.003, decay_s))
                 for partial, gain, decay_s in [(1.0, 1.0, 0.6), (2.0, 0.25, 0.45), (2.76, 0.3, 0.22), (5.4, 0.1, 0.09)]))


def engine(noise):
    """Loop of 2 s: four pulses a turn at 22 turns a second, no two alike, so that the half orders growl."""
    count = samples(2.0, WIND_RATE)
    partials = [(k, 1.0 / k**0.8, noise.between(0.0, TAU)) for k in range(1, 24)]
    hiss = biquad(noise.take(count), "band", 900.0, 0.8, WIND_RATE, periodic=True)
    out = []
    for i in range(count):
        t = i / WIND_RATE
        # Whole numbers of hertz, so that the loop closes.
        tone = sum(gain * math.sin(TAU * 22 * k * t + phase) * (1.0 if k % 4 == 0 else 0.32) for k, gain, phase in partials)
        beat = 0.75 + 0.25 * math.sin(TAU * 44 * t)
        out.append(tone * (0.9 + 0.1 * math.sin(TAU * 3 * t)) + 0.5 * beat * hiss[i])
    return out


def tyres(noise):
    """Loop of 3 s: rubber that slides, a band of noise with a squeal in it that wanders."""
    count = samples(3.0, BED_RATE)
    white = noise.take(count)
    scrape = biquad(white, "band", 620.0, 0.9, BED_RATE, periodic=True)
    squeal = biquad(white, "band", 1150.0, 9.0, BED_RATE, periodic=True)
    return [
        scrape[i] + (0.9 + 0.4 * math.sin(TAU * 2 * i / count) + 0.3 * math.sin(TAU * 5 * i / count + 1.0)) * squeal[i]
        for i in range(count)
    ]


def horn(noise):
    """Two reeds a third apart, as friendly as a horn can be."""
    seconds, parts = 0.6, []
    for hz in (392.0, 494.0):
        for partial, gain in [(1, 1.0), (2, 0.7), (3, 0.5), (4, 0.3), (5, 0.2), (6, 0.1)]:
            parts.append((gain, sine(hz * partial, seconds)))
    tone = mix(*parts)
    ramp = samples(0.025)
    return [x * min(1.0, i / ramp, (len(tone) - i) / ramp) for i, x in enumerate(tone)]


def door(noise):
    """A latch, and a light sheet that falls shut."""
    latch = burst(noise, 0.05, "band", 2400.0, 4.0, 0.0005, 0.007)
    sheet = burst(noise, 0.25, "band", 310.0, 1.6, 0.002, 0.04)
    thud = fall(sine(120.0, 0.25, to_hz=70.0), 0.002, 0.05)
    return mix((0.7, latch), (1.3, sheet, samples(0.03)), (0.9, thud, samples(0.03)))


STEPS = {"rock": step_rock, "gravel": step_gravel, "sand": step_sand, "soil": step_soil, "grass": step_grass}

# name: (what makes it, samples a second, loudest sample, whether it is a loop)
SOUNDS = {f"step-{ground}-{n}": (make, RATE, 0.7, False) for ground, make in STEPS.items() for n in (1, 2, 3)}
SOUNDS |= {f"dig-{n}": (dig, RATE, 0.75, False) for n in (1, 2, 3)}
SOUNDS |= {f"build-{n}": (build, RATE, 0.7, False) for n in (1, 2)}
SOUNDS |= {
    "land-soft": (lambda noise: landing(noise, False), RATE, 0.75, False),
    "land-hard": (lambda noise: landing(noise, True), RATE, 0.9, False),
    "shot": (shot, RATE, 0.85, False),
    "click": (click, RATE, 0.5, False),
    "struck": (struck, RATE, 0.75, False),
    "hurt": (hurt, RATE, 0.8, False),
    "lamp": (lamp, RATE, 0.6, False),
    "pick-up": (pick_up, RATE, 0.5, False),
    "tick": (lambda noise: blip(1500.0, 0.008), RATE, 0.5, False),
    "press": (lambda noise: blip(980.0, 0.018, 0.4), RATE, 0.6, False),
    "slot": (lambda noise: blip(620.0, 0.012, 0.6), RATE, 0.5, False),
    "wind": (wind, WIND_RATE, 0.8, True),
    "day": (day, BED_RATE, 0.8, True),
    "night": (night, BED_RATE, 0.8, True),
    "engine": (engine, WIND_RATE, 0.8, True),
    "tyres": (tyres, BED_RATE, 0.8, True),
    "horn": (horn, RATE, 0.7, False),
    "door": (door, RATE, 0.7, False),
    "pad": (pad, RATE, 0.7, False),
    "bell": (bell, RATE, 0.7, False),
}


def fade_out(signal, rate):
    """The last 8 ms go to nothing, so that no sound ends in a click."""
    count = min(len(signal), samples(0.008, rate))
    for i in range(count):
        signal[len(signal) - 1 - i] *= i / count
    return signal


def file_of(name):
    make, rate, peak, loop = SOUNDS[name]
    signal = make(Noise(name))
    if not loop:
        signal = fade_out(signal, rate)
    scale = 32767.0 * peak / max(abs(x) for x in signal)
    file = BytesIO()
    with wave.open(file, "wb") as out:
        out.setnchannels(1)
        out.setsampwidth(2)
        out.setframerate(rate)
        out.writeframes(struct.pack(f"<{len(signal)}h", *(round(scale * x) for x in signal)))
    return file.getvalue()


def main():
    here, check, wrong, total = Path(__file__).parent, "--check" in sys.argv[1:], [], 0
    for name in SOUNDS:
        path, made = here / f"{name}.wav", file_of(name)
        total += len(made)
        if not check:
            path.write_bytes(made)
        elif not path.exists() or path.read_bytes() != made:
            wrong.append(path.name)
    if wrong:
        sys.exit("not as this script makes them: " + ", ".join(wrong))
    print(f"{len(SOUNDS)} sounds, {total / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
