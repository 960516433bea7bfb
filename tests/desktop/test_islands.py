# SPDX-License-Identifier: Apache-2.0
"""The parts of a segment, clicked: one goes, or with R only it stays; to the voxel, undone, and replayed."""

import argparse
import sys

from driver import need, run_test, start
from phantom import SIDE, write_ball_head
from replay import compare_with_replay, operations, run
from test_segments import click_cell, press, reveal, save, working

# Two balls of one label, left and right of the middle: voxels of their centres, and radii.
BALLS = (((21, 36, 36), 8), ((51, 36, 36), 6))
PLACES = ((0.385, 0.5), (0.615, 0.5))  # where they are seen from the front, in fractions of the view


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


def choose_edit(studio):
    press(studio, "editFold")
    reveal(studio, "segmentEdit")
    studio.choose("segmentEdit", "Drop or keep")
    press(studio, "editPerform")
    studio.wait("the tool", lambda s: s["tool"] == "island" and "Balls" in s["hint"])


def click(studio, place):
    studio.click(lambda: studio.view_point(*place))


def main(display, arguments, folder):
    volume, labels = folder / "head.nrrd", folder / "balls.seg.nrrd"
    write_ball_head(volume)
    first, second = write_balls(labels)
    studio = start(display, arguments.program, folder, [volume])
    studio.resize(1230, 870)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("ctrl+l")
    studio.type_path("openLabelsDialog", labels)
    state = studio.wait_idle("the labels", lambda s: any(g["name"] == "Balls" for g in s["segments"]))
    row = [segment["name"] for segment in state["segments"]].index("Balls")
    click_cell(studio, row, "name")
    studio.wait_idle("both balls", lambda s: working(s)["voxels"] == first + second and s["pictureComplete"])

    def balls(state):
        return state["segments"][row]["voxels"]

    choose_edit(studio)
    before = studio.state()["operations"]
    click(studio, PLACES[0])
    state = studio.wait_idle("one ball to go", lambda s: s["operations"] > before)
    need(balls(state) in (first, second), f"the click left {balls(state)} voxels, not one of the balls ({first}, {second})")
    left = balls(state)
    clicked = first + second - left
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: balls(s) == first + second)
    click(studio, PLACES[1])
    studio.wait_idle("the other ball to go", lambda s: balls(s) == clicked)
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: balls(s) == first + second)

    # Beside both there is nothing, and nothing happens.
    count = studio.state()["operations"]
    click(studio, (0.04, 0.04))
    studio.wait_idle("a word", lambda s: "nothing lies under pixel" in s["message"])
    need(studio.state()["operations"] == count and balls(studio.state()) == first + second, "a click beside did something")

    studio.key("r")
    studio.wait("the reversed sign", lambda s: "all that is not connected to it goes" in s["hint"])
    click(studio, PLACES[0])
    studio.wait_idle("only the ball clicked", lambda s: balls(s) == clicked and s["pictureComplete"])
    state = save(studio, folder)
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()

    session = folder / "session.json"
    kinds = [operation["edit"] for operation in operations(session) if operation["op"] == "edit segment"]
    need(kinds[-1:] == ["keep island"], f"the session's edits are {kinds}")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", state["viewport"], folder)
    table = run(arguments.vstudio, "stats", session)
    need(str(clicked) in table, f"replayed, the balls have other voxels than {clicked}:\n{table}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--vstudio", required=True)
    parser.add_argument("--work", required=True, help="folder to work in; emptied first")
    sys.exit(run_test(main, parser.parse_args()))
