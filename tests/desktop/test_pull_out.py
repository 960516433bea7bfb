# SPDX-License-Identifier: Apache-2.0
"""A segment is pulled out by a key and by its row's menu, moved, turned and scaled by hand, and goes back; it follows what is done to the
segment, and all of it is replayed."""

import sys

from driver import need, start
from phantom import write_ball_head, write_labels
from replay import compare_with_replay, operations, save_and_end
from steps import Steps
from test_segments import cell, click_cell, working
from test_tools import Done, move_by_hand, redo

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


@test.step(after=[by_menu])
def replay(studio, arguments, folder):
    session, viewport = save_and_end(studio, folder)
    names = [op["op"] for op in operations(session)]
    need(names.count("pull out") >= 5 and "put back" in names, f"the session has {names}")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
