# SPDX-License-Identifier: Apache-2.0
"""The parts of a segment, clicked: one goes, or with R only it stays; to the voxel, undone, and replayed."""

import math
import sys

from driver import need, start
from phantom import SIDE, write_ball_head
from replay import compare_with_replay, operations, run
from steps import Steps
from test_segments import click_cell, press, reveal, save, working
from viewer import seen

test = Steps()

# Two balls of one label, left and right of the middle: voxels of their centres, and radii.
SPACING = 2.5
BALLS = (((21, 36, 36), 8), ((51, 36, 36), 6))


def write_balls(path):
    """On the grid of phantom.write_ball_head(). Returns how many voxels each ball has."""
    values = bytearray(SIDE ** 3)
    counts = []
    for (cx, cy, cz), radius in BALLS:
        inside = [(z * SIDE + y) * SIDE + x
                  for z in range(cz - radius, cz + radius + 1) for y in range(cy - radius, cy + radius + 1)
                  for x in range(cx - radius, cx + radius + 1)
                  if (x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 <= radius ** 2]
        for at in inside:
            values[at] = 1
        counts.append(len(inside))
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIDE} {SIDE} {SIDE}\n"
              "space directions: (2.5,0,0) (0,2.5,0) (0,0,2.5)\nspace origin: (0,0,0)\nencoding: raw\n"
              "Segment0_LabelValue:=1\nSegment0_Name:=Balls\n\n")
    path.write_bytes(header.encode() + values)
    return counts


class Balls:
    """The segment with both balls in the window."""

    def __init__(self, studio, row, counts):
        self.studio, self.row, self.whole = studio, row, sum(counts)

    def of(self, state):
        return state["segments"][self.row]["voxels"]

    def wait(self, what, voxels):
        return self.studio.wait_idle(what, lambda s: self.of(s) == voxels and s["pictureComplete"])


@test.step
def counts(folder):
    """The files to open. Returns how many voxels each ball has."""
    write_ball_head(folder / "head.nrrd")
    return write_balls(folder / "balls.seg.nrrd")


@test.step
def studio(display, arguments, folder, counts):
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.resize(1230, 870)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def balls(studio, folder, counts):
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("ctrl+l")
    studio.type_path("openLabelsDialog", folder / "balls.seg.nrrd")
    state = studio.wait_idle("the labels", lambda s: any(g["name"] == "Balls" for g in s["segments"]))
    row = [segment["name"] for segment in state["segments"]].index("Balls")
    click_cell(studio, row, "name")
    studio.wait_idle("both balls", lambda s: working(s)["voxels"] == sum(counts) and s["pictureComplete"])
    return Balls(studio, row, counts)


@test.step(after=[balls])
def choose_edit(studio):
    press(studio, "editFold")
    reveal(studio, "segmentEdit")
    studio.choose("segmentEdit", "Drop or keep")
    press(studio, "editPerform")
    studio.wait("the tool", lambda s: s["tool"] == "island" and "Balls" in s["hint"])


def click(studio, place):
    studio.click(lambda: studio.view_point(*place))


def click_ball(studio, which):
    state = studio.state()
    middle = [SPACING * (SIDE - 1) / 2] * 3
    centre = [SPACING * voxel for voxel in BALLS[which][0]]
    click(studio, seen(state["camera"], centre, middle, SPACING * math.dist((0, 0, 0), [SIDE] * 3), state["viewRect"][2:]))


@test.step(after=[choose_edit])
def clicked(studio, balls, counts):
    """The click takes one ball away. Returns how many voxels that had."""
    before = studio.state()["operations"]
    click_ball(studio, 0)
    state = studio.wait_idle("one ball to go", lambda s: s["operations"] > before)
    need(balls.of(state) in counts, f"the click left {balls.of(state)} voxels, not one of the balls {counts}")
    return balls.whole - balls.of(state)


@test.step
def undone(studio, balls, clicked):
    studio.key("ctrl+z")
    balls.wait("undo", balls.whole)


@test.step(after=[undone])
def other_ball(studio, balls, clicked):
    click_ball(studio, 1)
    balls.wait("the other ball to go", clicked)
    studio.key("ctrl+z")
    balls.wait("undo", balls.whole)


@test.step(after=[choose_edit])
def click_beside(studio, balls):
    """Beside both there is nothing, and nothing happens."""
    before = studio.state()
    click(studio, (0.04, 0.04))
    state = studio.wait_idle("a word", lambda s: "nothing lies under pixel" in s["message"])
    need(state["operations"] == before["operations"] and balls.of(state) == balls.of(before), "a click beside did something")


@test.step
def only_one(studio, balls, clicked):
    """Reversed, the ball that is clicked stays."""
    studio.key("r")
    studio.wait("the reversed sign", lambda s: "all that is not connected to it goes" in s["hint"])
    click_ball(studio, 0)
    balls.wait("only the ball clicked", clicked)


@test.step
def session(studio, folder):
    state = save(studio, folder)
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    return folder / "session.json", state["viewport"]


@test.step
def edit_of_session(session):
    kinds = [operation["edit"] for operation in operations(session[0]) if operation["op"] == "edit segment"]
    need(kinds[-1:] == ["keep island"], f"the session's edits are {kinds}")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


@test.step(after=[only_one])
def voxels_of_replay(arguments, session, clicked):
    table = run(arguments.vstudio, "stats", session[0])
    need(str(clicked) in table, f"replayed, the balls have other voxels than {clicked}:\n{table}")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
