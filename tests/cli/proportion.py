#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sessions whose strokes are long, wide or far out on a small grid: each is done or refused by one line, at little cost.

usage: proportion.py VSTUDIO [NAME]     (NAME: only the cases whose name contains it)

Each case is what somebody could write into a session file of a few hundred kilobytes. Each answer: exit 0, or exit 1 and one
line that names the file; within two seconds of processor time and half a gigabyte, once in three times at least. A machine whose
processors are slower than those of which the two seconds are said has as much more.
"""
import json
import os
import random
import subprocess
import sys
import tempfile

from usual_machine import slowness

SECONDS = 2.0  # on a usual machine
MEGABYTES = 500
SANITIZED = "ASAN_OPTIONS" in os.environ or "TSAN_OPTIONS" in os.environ  # which cost many times as much
COSTLY = "cost too much"
MANY = 5000
PEN = 250  # places of a stroke, a second or two of a quick pen

# Runs a command, at most a minute, and says on the last line what it cost: processor time and the largest process.
MEASURE = """
import resource, subprocess, sys
code = subprocess.run(sys.argv[1:], timeout=60).returncode
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, file=sys.stderr)
sys.exit(code if code >= 0 else 128 - code)
"""


def places(count, most, dimensions, chance):
    """Places far apart, so that each piece of a way between them is long."""
    return [[chance.choice([-1, 1]) * most * chance.uniform(0.1, 1) for _ in range(dimensions)] for _ in range(count)]


def walk(count, step, lo, hi, chance):
    """A way about a picture, as a pen goes that scribbles: each place near the one before."""
    place, way = [(low + high) / 2 for low, high in zip(lo, hi)], []
    for _ in range(count):
        place = [min(max(p + chance.uniform(-step, step), low), high) for p, low, high in zip(place, lo, hi)]
        way.append(place)
    return way


def cases(chance):
    far = places(MANY, 1e6, 2, chance)
    near = walk(PEN, 12, [300, 200], [900, 700], chance)
    pressed = [point + [1] for point in far]
    box = {"shape": "ellipse", "points": [[400, 300], [800, 600]]}
    huge = {"shape": "ellipse", "points": [[-1e6, -1e6], [1e6, 1e6]]}
    star = {"shape": "free-form", "points": far}
    scribble = {"shape": "free-form", "points": near}
    voxels = places(MANY, 1e5, 3, chance)
    trail = {"points": places(MANY, 1e6, 3, chance), "radius": 1e4}
    thin = {"points": places(MANY, 1e6, 3, chance)}
    inside = [[chance.uniform(0, 15) for _ in range(3)] for _ in range(MANY)]
    grown = {"op": "seed", "strokes": [box]}
    yield "peel star", [{"op": "peel", "layers": 4096, "mask": star}]
    yield "peel scribble", [{"op": "peel", "layers": 4096, "mask": scribble, "radius": 4}]
    yield "peel huge", [{"op": "peel", "layers": 4096, "mask": huge}]
    for tool in ("drill", "laser"):
        yield f"{tool} far", [{"op": tool, "mask": box, "stroke": pressed, "depthMax": 4096}]
        yield f"{tool} huge mask", [{"op": tool, "mask": huge, "stroke": pressed, "depthMax": 4096}]
        yield f"{tool} near", [{"op": tool, "mask": box, "stroke": [p + [1] for p in near], "depthMax": 4096}]
        yield f"{tool} digging", [{"op": tool, "mask": box, "stroke": [p + [1] for p in near], "keepDigging": True}]
        yield f"{tool} digging far", [{"op": tool, "mask": box, "stroke": pressed, "keepDigging": True}]
        yield f"{tool} star", [{"op": tool, "mask": star, "stroke": pressed[:100]}]
    yield "scissors star", [{"op": "scissors", "outline": star}]
    yield "scissors scribble", [{"op": "scissors", "outline": scribble, "depth": 4096}]
    yield "scissors outside", [{"op": "scissors", "outline": star, "outside": True, "radius": 4}]
    for kind in ("polyline", "spline"):
        yield f"sweep {kind}", [{"op": "sweep", "mask": {"shape": "ellipse", "points": [[-3, -3], [3, 3]]},
                                 "path": {"kind": kind, "points": voxels}}]
        yield f"sweep {kind} inside", [{"op": "sweep", "mask": {"shape": "ellipse", "points": [[-3, -3], [3, 3]]},
                                        "path": {"kind": kind, "points": inside}}]
    for kind in ("surface", "view plane"):
        yield f"sweep {kind} far", [{"op": "sweep", "mask": box, "path": {"kind": kind, "stroke": far}}]
        yield f"sweep {kind} near", [{"op": "sweep", "mask": box, "path": {"kind": kind, "stroke": near}}]
    yield "seed star", [{"op": "seed", "strokes": [star], "width": 5}]
    yield "seed wide", [{"op": "seed", "strokes": [scribble], "width": 1000}]
    yield "seed filled", [{"op": "seed", "strokes": [{"shape": "stencil", "points": near}]}]
    yield "seed many", [{"op": "seed", "strokes": [huge] * 5000}]
    yield "seed trails", [{"op": "seed", "strokes": [], "trails": [trail]}]
    yield "seed voxels", [{"op": "seed", "strokes": [box], "voxels": [[1 << 20] * 3] * MANY}]
    yield "absorb star", [grown, {"op": "absorb", "strokes": [star], "width": 1000}]
    yield "paint trail", [{"op": "paint segment", "adds": True, "trail": trail}]
    yield "paint thin", [{"op": "paint segment", "adds": True, "trail": thin}]
    yield "paint disc", [{"op": "paint segment", "adds": True, "trail": {**trail, "axis": "z"}}]
    yield "paint inside", [{"op": "paint segment", "adds": True, "trail": {"points": inside, "radius": 1}}]
    yield "brush star", [grown, {"op": "brush segment", "adds": True,
                                 "stroke": {"op": "drill", "mask": star, "stroke": pressed[:PEN]}}]
    yield "brush in a brush", [{"op": "brush segment", "adds": True,
                                "stroke": {"op": "brush segment", "adds": True, "stroke": {"op": "peel"}}}]
    for kind, points in (("path", voxels), ("area", [[x, y, 8] for x, y, _ in voxels]),
                         ("area", [[x, y, 8] for x, y, _ in inside])):
        yield f"measure {kind}", [{"op": "measure", "kind": kind, "points": points}]
    for edit in ("margin", "open", "close", "smooth", "hollow", "fill holes", "drop small"):
        yield f"edit {edit}", [grown, {"op": "edit segment", "edit": edit, "amount": 10000}]
    yield "cut margin", [grown, {"op": "cut segment", "margin": 10000}]
    yield "many segments", [{"op": "segment", "segment": f"s{i}"} for i in range(300)]
    yield "many undone", [{"op": "peel", "layers": 2, "mask": box}, *[{"op": "undo"}, {"op": "redo"}] * 2500]
    yield "grow", [grown, *[{"op": "grow", "generations": 1 << 30}, {"op": "rewind", "generations": 1 << 30}] * 1000]
    seen = {"camera": {}, "mode": "surface", "range": [0, 2], "sculptureView": "cut"}
    yield "large canvas", [{"op": "peel", "layers": 2, "mask": huge, "canvas": {"viewport": [16384, 16384], **seen}}]
    yield "large picture", [{"op": "picture", "file": "a.png", "size": [16384, 16384]}]
    canvas = {"viewport": [3840, 2160], **seen}
    yield "canvas", [{"op": "peel", "layers": 2, "mask": huge, "canvas": canvas}]
    yield "canvas seeds", [{"op": "seed", "strokes": [huge], "canvas": canvas}]
    yield "canvas drill", [{"op": "drill", "mask": huge, "stroke": pressed, "canvas": canvas}]
    yield "canvas stroke", [{"op": "drill", "mask": box, "stroke": [[x * 0.005, y * 0.005, 1] for x, y in far[:PEN // 3]],
                             "canvas": canvas}]
    for zoom in (0.001, 1000):
        near_camera = {**canvas, "viewport": [1000, 1000], "camera": {"zoom": zoom}}
        yield f"zoom {zoom} peel", [{"op": "peel", "layers": 4096, "mask": huge, "canvas": near_camera}]
        yield f"zoom {zoom} drill", [{"op": "drill", "mask": huge, "stroke": pressed, "canvas": near_camera}]
        yield f"zoom {zoom} laser", [{"op": "laser", "mask": box, "stroke": pressed, "canvas": near_camera}]


def wrong(program, session, out, most):
    """What is wrong with the answer, and what it cost in seconds and MB."""
    arguments = [sys.executable, "-c", MEASURE, program, "run", session, "-o", out]
    done = subprocess.run(arguments, capture_output=True, text=True)
    lines = done.stderr.splitlines()
    try:
        seconds, megabytes = map(float, lines.pop().split())
    except ValueError:
        return "took more than a minute", 60, 0
    errors = [line for line in lines if not line.startswith("note: ")]
    if done.returncode not in (0, 1):
        return f"exit code {done.returncode}: {' | '.join(lines)[:300]}", seconds, megabytes
    if done.returncode == 1 and (len(errors) != 1 or session not in errors[0]):
        return f"not one line that names it: {' | '.join(lines)[:300]}", seconds, megabytes
    if not SANITIZED and (seconds > most or megabytes > MEGABYTES):
        return COSTLY, seconds, megabytes
    return None, seconds, megabytes


def main():
    program = sys.argv[1]
    only = sys.argv[2] if len(sys.argv) > 2 else ""
    chance = random.Random(20)
    failures = count = 0
    with tempfile.TemporaryDirectory() as folder:
        session = os.path.join(folder, "session.json")
        most = SECONDS * slowness(program, folder)
        print(f"at most {most:.1f} s")
        for name, operations in cases(chance):
            if only not in name:
                continue
            count += 1
            with open(session, "w") as file:
                json.dump({"volumeStudioSession": 2, "volume": {"block": [16, 16, 16]}, "operations": operations}, file)
            for _ in range(3):  # beside other work the same takes more of a processor's time
                fault, seconds, megabytes = wrong(program, session, os.path.join(folder, "out"), most)
                if fault != COSTLY:
                    break
            print(f"{name}: {seconds:.1f} s, {megabytes:.0f} MB" + (f": WRONG: {fault}" if fault else ""), flush=True)
            failures += fault is not None
    print(f"{count} sessions, {failures} wrong")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
