# SPDX-License-Identifier: Apache-2.0
"""A first stroke that takes more than was meant: growth stops at a part of what is displayed and goes on when asked; where it leaked is
marked on the scrub bar."""

import math
import sys

from driver import need, start
from replay import compare_with_replay, operations, save_and_end
from steps import Steps
from viewer import seen

test = Steps()

SIZE = (112, 56, 56)
MIDDLE = [(side - 1) / 2 for side in SIZE]
BALL, LARGER, NECK = ((22, 28, 28), 16), ((84, 28, 28), 24), 2


def body():
    """Two balls and the neck between them, as the set of their voxels (x, y, z)."""
    voxels = set()
    for z in range(SIZE[2]):
        for y in range(SIZE[1]):
            for x in range(SIZE[0]):
                place = (x, y, z)
                if (any(math.dist(place, middle) <= radius for middle, radius in (BALL, LARGER))
                        or (BALL[0][0] <= x <= LARGER[0][0] and math.dist(place[1:], BALL[0][1:]) <= NECK)):
                    voxels.add(place)
    return voxels


def write_body(path, voxels):
    values = bytearray(SIZE[0] * SIZE[1] * SIZE[2])
    for x, y, z in voxels:
        values[(z * SIZE[1] + y) * SIZE[0] + x] = 100
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIZE[0]} {SIZE[1]} {SIZE[2]}\n"
              "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n\n")
    path.write_bytes(header.encode() + values)


def place_of(studio, voxel):
    state = studio.state()
    return studio.view_point(*seen(state["camera"], voxel, MIDDLE, math.dist((0, 0, 0), SIZE), state["viewRect"][2:]))


def scrub_place(studio, generation):
    """Where that generation is on the bar."""
    x, y, width, height = studio.place_of("scrubBar")
    return x + 7 + (width - 14) * (generation - 1) / (studio.state()["extent"] - 1), y + height / 2


@test.step
def voxels():
    return body()


@test.step
def studio(display, arguments, folder, voxels):
    write_body(folder / "balls.nrrd", voxels)
    studio = start(display, arguments.program, folder, [folder / "balls.nrrd"])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def stops(studio, voxels):
    """The first stroke, on the smaller ball, stops with the generation in which it has a quarter of all that is displayed."""
    studio.key("s")
    middle = BALL[0]
    studio.drag([place_of(studio, (middle[0] + along, middle[1] - 15, middle[2])) for along in (-2, 0, 2)])
    state = studio.wait_idle("growth to stop", lambda s: s["stepsDone"] >= 2 and not s["playing"])
    quarter = len(voxels) // 4
    need(quarter <= state["voxels"] < 1.1 * quarter, f"it stopped with {state['voxels']} of {len(voxels)} voxels")
    need("growGoOn" in state["widgets"], "nothing says how to go on")
    need("25 %" in state["message"], f"the status bar says {state['message']}")
    return state


@test.step
def goes_on(studio, voxels, stops):
    studio.click("growGoOn")
    state = studio.wait_idle("all of it", lambda s: s["voxels"] == len(voxels) and not s["playing"])
    need("growGoOn" not in state["widgets"], "it still asks whether to go on")


@test.step(after=[goes_on])
def leak(studio, voxels):
    """One mark, after which the neck or what lies behind it is entered. A click near it goes there, and the keys do."""
    state = studio.state()
    marks = [int(mark) for mark in state["reports"].get("scrubBar", "").split()]
    need(len(marks) == 1, f"marks at {marks}")
    x, y = scrub_place(studio, marks[0])
    studio.click((x + 3, y))
    state = studio.wait_idle("the mark", lambda s: s["generation"] == marks[0])
    first = sum(1 for voxel in voxels if math.dist(voxel, BALL[0]) <= BALL[1])
    need(0.97 * first <= state["voxels"] <= 1.25 * first, f"before the leak {state['voxels']} voxels are shown, the ball has {first}")
    studio.key("ctrl+z")
    studio.wait_idle("the step back", lambda s: s["voxels"] == len(voxels))
    studio.key("ctrl+shift+b")
    studio.wait_idle("the mark by keys", lambda s: s["generation"] == marks[0])
    return marks[0]


@test.step
def without_limit(studio, voxels, leak):
    """The size is chosen in the panel: with `never` a first stroke takes all it reaches. A second stroke is not stopped anyway."""
    studio.key("ctrl+shift+n")
    studio.wait_idle("another segment", lambda s: len(s["segments"]) == 2 and s["voxels"] == 0)
    studio.type_number("growthLimit", 0)
    middle = LARGER[0]
    before = studio.state()["stepsDone"]
    studio.drag([place_of(studio, (middle[0] + along, middle[1] - 23, middle[2])) for along in (-2, 0, 2)])
    state = studio.wait_idle("growth to end", lambda s: s["stepsDone"] >= before + 2 and not s["playing"])
    need(state["voxels"] > 0.5 * len(voxels), f"it has {state['voxels']} of {len(voxels)} voxels")
    need("growGoOn" not in state["widgets"], "it asks whether to go on")


@test.step(after=[without_limit])
def session(studio, folder, leak):
    path, viewport = save_and_end(studio, folder)
    grown = [op for op in operations(path) if op["op"] == "grow"]
    need(len(grown) == 3, f"{len(grown)} runs were saved, not the one that stopped, the one that went on and the second stroke's")
    need(any(op["op"] == "show generation" and op["generation"] == leak for op in operations(path)), "the way back was not saved")
    return path, viewport


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


@test.step
def kept(display, arguments, session, folder):
    """The size is remembered."""
    again = start(display, arguments.program, folder, [folder / "balls.nrrd"])
    again.wait_idle("the volume", lambda s: s["pictureComplete"])
    again.key("s")
    again.drag([place_of(again, (BALL[0][0] + along, BALL[0][1] - 15, BALL[0][2])) for along in (-2, 0, 2)])
    again.wait_idle("growth to end", lambda s: s["stepsDone"] >= 2 and not s["playing"] and s["voxels"] > 30000)
    again.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
