# SPDX-License-Identifier: Apache-2.0
"""Sculpting from nothing, from the start screen on: a block that is carved, one that is built up, the drill through all of it, and what the
camera tool's drags do."""

import sys

from driver import need, start
from replay import compare_with_replay, operations, save_and_end
from steps import Steps

test = Steps()


def begin_block(studio, button=None, build=False):
    studio.click(button) if button else studio.key("ctrl+alt+n")
    studio.wait("the dialog", lambda s: "blockDialog" in s["windows"])
    for axis, size, spacing in (("X", 40, 1.5), ("Y", 50, 1), ("Z", 60, 0.5)):
        studio.type_number(f"blockSize{axis}", size, "Tab")
        studio.type_number(f"blockSpacing{axis}", spacing, "Tab")
    if build:
        studio.click("blockBuild")
    need(studio.state()["reports"]["blockTotal"] == "60 \xd7 50 \xd7 30 mm, 0.1 million voxels", f"the dialog says {studio.state()['reports']}")
    studio.click("blockBegin")
    state = studio.wait_idle("the block", lambda s: s["title"].startswith("block of 40 x 50 x 60") and s["pictureComplete"])
    studio.focus()
    return state


def ring(studio, radius, middle=(0.5, 0.5)):
    """Points around the middle of the view."""
    return [studio.view_point(middle[0] + radius * x, middle[1] + radius * y)
            for x, y in ((1, 0), (0.7, 0.7), (0, 1), (-0.7, 0.7), (-1, 0), (-0.7, -0.7), (0, -1), (0.7, -0.7), (1, 0))]


@test.step
def studio(display, arguments, folder):
    studio = start(display, arguments.program, folder)
    studio.resize(1300, 900)
    begin_block(studio, "blockButton")
    return studio


@test.step
def drags(studio):
    """The camera tool moves and zooms by itself where it is told to."""
    before = studio.state()["camera"]
    studio.click("dragMoves")
    studio.drag([studio.view_point(0.5, 0.5), studio.view_point(0.55, 0.55)])
    moved = studio.wait_idle("the picture to move", lambda s: s["camera"]["pan"] != before["pan"])["camera"]
    need(moved["azimuth"] == before["azimuth"] and moved["zoom"] == before["zoom"], "moving turned or zoomed")
    studio.click("dragZooms")
    studio.drag([studio.view_point(0.5, 0.5), studio.view_point(0.5, 0.4)])
    nearer = studio.wait_idle("the picture to come nearer", lambda s: s["camera"]["zoom"] > moved["zoom"])["camera"]
    need(nearer["azimuth"] == before["azimuth"], "zooming turned")
    studio.click("dragTurns")
    studio.drag([studio.view_point(0.5, 0.5), studio.view_point(0.6, 0.5)])
    studio.wait_idle("the picture to turn", lambda s: s["camera"]["azimuth"] != before["azimuth"])
    studio.key("Home")
    studio.wait_idle("the first view", lambda s: s["camera"]["azimuth"] == 0 and s["pictureComplete"])


@test.step(after=[drags])
def drilled(studio):
    """Through all: what is seen through the hole is the background, at whichever depth the slider stands."""
    studio.key("d")
    studio.drag(ring(studio, 0.05))
    x, y, _, height = studio.place_of("drillThrough")
    studio.click((x + 9, y + height // 2))
    need("drillDepth" in studio.state()["disabled"], "the depth can be set though it does not count")
    studio.drag([studio.view_point(0.5, 0.5), studio.view_point(0.502, 0.5)])
    state = studio.wait_idle("the hole", lambda s: s["stepsDone"] == 1)
    need(state["reports"]["duration"].endswith("s"), f"the step took {state['reports']['duration']}")


@test.step(after=[drilled])
def swept(studio):
    """A curved way through corners that are clicked; Enter ends it and, once it is shown, cuts it."""
    studio.key("w")
    studio.drag(ring(studio, 0.03, (0.3, 0.35)))
    studio.wait("the sweep's mask", lambda s: s["hint"].startswith("Draw the way"))
    studio.click("sweepPlane")
    studio.click("sweepSpline")
    studio.wait("corners to be wanted", lambda s: s["hint"].startswith("Click the corners"))
    for place in ((0.3, 0.35), (0.45, 0.3), (0.6, 0.4)):
        studio.click(studio.view_point(*place))
        studio.wait("the next corner", lambda s: s["hint"].startswith("Click the next corner"))
    studio.key("Return")
    studio.wait_idle("the way", lambda s: s["hint"].startswith("Enter cuts"))
    studio.key("Return")
    studio.wait_idle("the sweep", lambda s: s["stepsDone"] == 2)


@test.step(after=[swept])
def advanced(studio):
    """Raw energy and another filter, for who compares them: at the end of the page, which scrolls."""
    studio.click("sweepLine")
    x, y, _, height = studio.place_of("sweepAdvanced")
    studio.click((x + 9, y + height // 2))
    x, y, _, height = studio.place_of("sweepRaw")
    studio.click((x + 9, y + height // 2))
    studio.key("Escape")
    studio.drag(ring(studio, 0.03, (0.7, 0.6)))
    studio.wait_idle("the way", lambda s: s["hint"].startswith("Enter cuts"))
    studio.key("Return")
    studio.wait_idle("the raw sweep", lambda s: s["stepsDone"] == 3)


@test.step(after=[advanced])
def session(studio, arguments, folder):
    path, viewport = save_and_end(studio, folder)
    content = operations(path)
    drill = [op for op in content if op["op"] == "drill"]
    need(len(drill) == 1 and drill[0]["depthMax"] >= 80 / 0.5, f"drilled {drill}")
    curved, raw = (op for op in content if op["op"] == "sweep")
    way = curved["path"]["stroke"]
    need(curved["path"]["kind"] == "view plane" and len(way) > 100, f"swept along {len(way)} places")
    need(min(y for _, y in way[10:-10]) < way[0][1] - 20, "the curve does not pass its middle corner")
    need(curved["energy"] == "calibrated" and raw["energy"] == "raw", f"energies {curved['energy']} and {raw['energy']}")
    return path, viewport


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


@test.step
def built(display, arguments, folder):
    """Nothing is there at first; what is cut out of nothing is what is seen."""
    own = folder / "built"
    own.mkdir()
    studio = start(display, arguments.program, own)
    studio.resize(1300, 900)
    begin_block(studio, "blockButton", build=True)
    studio.key("x")
    studio.drag(ring(studio, 0.1))
    studio.wait_idle("what is built", lambda s: s["stepsDone"] == 1 and s["pictureComplete"])
    path, viewport = save_and_end(studio, own)
    view = next(op for op in operations(path) if op["op"] == "view")
    need(view["sculptureView"] == "probe", f"it is seen as {view['sculptureView']}")
    compare_with_replay(arguments.vstudio, path, own / "window.png", viewport, own)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
