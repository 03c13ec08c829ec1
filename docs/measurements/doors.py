#!/usr/bin/env python3
"""Measures what a pair of doors in a world costs: processor time of a frame, and memory.

    python3 docs/measurements/doors.py path/to/antipode        prints the table of doors.md

Pictures are drawn by the software adapter, so that all of a frame is time of processors, which does not depend on what else
the machine does. Each case is a process of its own; the cases take turns, a short and a long run each, and a frame is
the difference of both by the number of frames. Ratios are of the least of each case.
"""

import json
import os
import resource
import subprocess
import sys
import tempfile

TURNS = 4
SHORT, LONG = 2, 42
SIZE = "640x360"
# Metres from the start to the far door, in every space but the closed one, whose land is all at hand.
FAR_M = 400.0
SPACES = ("euclidean", "hyperbolic", "spherical")


def run(program, script):
    """Runs a script; returns what it printed and the processor seconds that it took."""
    with tempfile.TemporaryDirectory() as place:
        path = os.path.join(place, "script")
        with open(path, "w", encoding="utf-8") as file:
            file.write(script)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(
            [program, "script", path, "--saves-dir", place, "--adapter", "software", "--size", SIZE],
            check=True, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    took_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.stdout, took_s


def last_probe(program, script):
    lines = [line for line in run(program, script)[0].splitlines() if line.startswith('{"t"')]
    return json.loads(lines[-1])


def begun(space):
    return f"new {space} seed=5 generator=1\nset npcs off\nsettle\nwait 1\ntap Digit1\ntap F1\nset time 150\naim 0 -4\n"


def door(pos, chart):
    return "spawn door " + " ".join(f"{x:.3f}" for x in pos) + (f" {chart}" if chart else "") + "\n"


def cases(program, space):
    """The scripts up to what is measured: without doors, with small ones, with one that fills the picture, with a door in a door."""
    feet = last_probe(program, begun(space) + "probe\n")["player"]["pos"]
    closed = space == "spherical"
    near, far = "A" if closed else "", "B" if closed else ""

    def at(ahead, aside):
        return (feet[0] + ahead, feet[1] + 0.2, feet[2] + aside)

    elsewhere = (20.0, feet[1], 10.0) if closed else (feet[0] + FAR_M, feet[1], feet[2])
    begin = begun(space)
    looks = "settle\nwait 1\nsettle\n"
    return {
        "none": begin + looks,
        "small": begin + door(at(9.0, -2.0), near) + door(at(9.0, 2.0), near) + looks,
        "full": begin + door(at(0.9, 0.0), near) + door(elsewhere, far) + looks,
        # Two leaves that face each other: each shows itself in the other.
        "nested": begin + door(at(0.9, 0.0), near) + door(at(-5.0, 0.0), near) + looks,
    }


def measured(program, space):
    scripts = cases(program, space)
    least = {name: float("inf") for name in scripts}
    for _ in range(TURNS):
        for name, script in scripts.items():
            took = [run(program, script + f"perf {frames / 60:.5f}\n")[1] for frames in (SHORT, LONG)]
            least[name] = min(least[name], (took[1] - took[0]) / (LONG - SHORT))
    memory = {name: last_probe(program, scripts[name] + "probe\n")["memory_mb"] for name in ("none", "full")}
    return least, memory


def main():
    program = os.path.abspath(sys.argv[1])
    print("| space | frame, ms of processors | both small | one fills the picture | one in a door | memory, MB | with the far door |")
    print("|---|---|---|---|---|---|---|")
    for space in sys.argv[2:] or SPACES:
        least, memory = measured(program, space)
        ratio = {name: f"{value / least['none']:.2f}" for name, value in least.items()}
        more = memory["full"] / memory["none"]
        print(f"| {space} | {1e3 * least['none']:.0f} | {ratio['small']} | {ratio['full']} | {ratio['nested']} "
              f"| {memory['none']:.0f} | {more:.2f} |", flush=True)


if __name__ == "__main__":
    main()
