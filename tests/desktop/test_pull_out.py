# SPDX-License-Identifier: Apache-2.0
"""A segment is pulled out by a key and by its row's menu, moved, turned and scaled by hand, and goes back; it follows what is done to the
segment. With parts that are pasted it stands in a list, is named, hidden, discarded and spread, and all of it is replayed."""

import math
import sys

from driver import need, start
from phantom import write_ball_head, write_labels
from replay import compare_with_replay, operations, save_and_end
from steps import Steps
from test_segments import cell, click_cell, working
from test_tools import Done, choose, ellipse, move_by_hand, redo, undo

test = Steps()


@test.step
def studio(display, arguments, folder):
    write_ball_head(folder / "head.nrrd")
    write_labels(folder / "labels.seg.nrrd")
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.resize(1230, 870)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("ctrl+l")
    studio.type_path("openLabelsDialog", folder / "labels.seg.nrrd")
    studio.wait_idle("the labels", lambda s: any(g["name"] == "Core" for g in s["segments"]) and s["pictureComplete"])
    return studio


def row_of(studio, name):
    return [segment["name"] for segment in studio.state()["segments"]].index(name)


@test.step
def by_key(studio):
    """Pulled out beside the head, where it is in hand at once; dragged, turned and scaled; undone and redone."""
    click_cell(studio, row_of(studio, "Core"), "name")
    studio.wait_idle("work on it", lambda s: working(s)["name"] == "Core" and s["pictureComplete"])
    done = Done(studio)
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("ctrl+shift+v")
    done.wait("Pull out")
    move_by_hand(studio, "Pull out")
    redo(studio)


@test.step(after=[by_key])
def by_menu(studio):
    """The other one by its row's menu, which then puts it back; both have handles."""
    other = next(s["name"] for s in studio.state()["segments"] if s["name"] != "Core" and s["voxels"] > 0)
    row = row_of(studio, other)
    counts = []
    for wanted in ("Pull out", "Put back", "Pull out"):
        done = Done(studio)
        studio.click(lambda: cell(studio, row, "name"), button=3)
        studio.place_of("segmentMenu")
        studio.xdotool("key", "Down", "key", "Down", "key", "Down", "key", "Return")
        counts.append(len(done.wait(wanted)["handles"]))
    need(counts == [2, 1, 2], f"there are {counts} handles")


ROW = 24  # PartList's rows, logical pixels


def parts(studio):
    """The names in the list of parts: those that are seen, and those that are hidden."""
    return [[name for name in names.split(", ") if name] for names in studio.state()["reports"]["partList"].split(" | ")]


def row_in_parts(studio, row, x):
    left, top, _, _ = studio.state()["widgets"]["partList"]
    return left + x, top + ROW * row + ROW // 2


def slide(studio, slider, begin, end):
    """Drags a slider from a place to another, from its left end or, below zero, from its right one."""
    x, y, width, height = studio.place_of(slider)
    places = [begin + (end - begin) * i // 5 for i in range(6)]
    studio.drag([(x + place if place > 0 else x + width + place, y + height // 2) for place in places])


def operation(studio, name, act):
    done = Done(studio)
    act()
    return done.wait(name)


@test.step(after=[by_menu])
def in_a_list(studio):
    """A part that is pasted stands in the list with what is pulled out: it is named, hidden, shown and, by undo, back after it was discarded."""
    choose(studio, "x", "scissors")
    operation(studio, "Scissors", lambda: studio.drag(ellipse(studio, (0.45, 0.5), (0.04, 0.04))))
    operation(studio, "Paste", lambda: (studio.move(studio.view_point(0.5, 0.9)), studio.key("shift+v")))
    need(parts(studio)[0][0] == "Part 1" and len(parts(studio)[0]) == 3, f"the list has {parts(studio)}")

    studio.click(lambda: row_in_parts(studio, 0, 60))
    studio.key("F2")
    studio.key("ctrl+a")
    studio.type("Flap")
    operation(studio, "Part", lambda: studio.key("Return"))
    need(parts(studio)[0][0] == "Flap", f"the list has {parts(studio)}")

    for row, said in enumerate(("Part", "Pull out")):
        name = parts(studio)[0][row]
        before = len(studio.state()["handles"])
        operation(studio, said, lambda: studio.click(lambda: row_in_parts(studio, row, 10)))
        need(parts(studio)[1] == [name] and len(studio.state()["handles"]) == before - 1, f"{name} is not hidden: {parts(studio)}")
        operation(studio, said, lambda: studio.click(lambda: row_in_parts(studio, row, 10)))
        need(parts(studio)[1] == [] and len(studio.state()["handles"]) == before, f"{name} is not shown again: {parts(studio)}")

    studio.click(lambda: row_in_parts(studio, 0, 60))
    operation(studio, "Discard part", lambda: studio.click("discardPart"))
    need("Flap" not in parts(studio)[0], f"the list has {parts(studio)}")
    undo(studio)
    need(parts(studio)[0][0] == "Flap", f"the list has {parts(studio)}")


@test.step(after=[in_a_list])
def spread(studio):
    """The slider moves all apart from the middle; one that is dragged then follows the pen, and stays where it is let go."""
    before = studio.state()["handles"]
    slide(studio, "spread", 7, 20)
    state = studio.wait_idle("parts that are apart", lambda s: s["handles"] != before and s["pictureComplete"])
    need(all(math.dist(a, b) > 5 for a, b in zip(before, state["handles"])), f"handles were at {before}, are at {state['handles']}")
    x, y = state["handles"][0]
    state = operation(studio, "Move part", lambda: studio.drag([(x + 5 * i, y + 3 * i) for i in range(9)]))
    need(math.dist(state["handles"][0], (x + 40, y + 24)) < 4, f"dragged from {(x, y)} by (40, 24) to {state['handles'][0]}")


@test.step(after=[spread])
def trimmed(studio):
    """What Keep took away belongs to no part, until that is wanted."""
    choose(studio, "c", "clip")
    operation(studio, "Clip", lambda: slide(studio, "clipHi0Slider", -7, -60))
    before = studio.state()["operations"]
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("shift+v")
    studio.wait_idle("nothing pasted", lambda s: s["message"].startswith("Nothing to paste"))
    need(studio.state()["operations"] == before, "something was pasted")
    operation(studio, "Paste", lambda: studio.key("ctrl+alt+v"))
    need(len(parts(studio)[0]) == 4, f"the list has {parts(studio)}")


@test.step(after=[trimmed])
def replay(studio, arguments, folder):
    session, viewport = save_and_end(studio, folder)
    names = [op["op"] for op in operations(session)]
    need(names.count("pull out") >= 5 and "put back" in names, f"the session has {names}")
    need({"part", "discard part", "paste"} <= set(names), f"the session has {names}")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
