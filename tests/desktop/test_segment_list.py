# SPDX-License-Identifier: Apache-2.0
"""A label map of 200 labels: a list that is searched, sorted and as long as there is room, and one segment shown alone."""

import json
import sys

from driver import need, start
from replay import compare_with_replay, operations, save_and_end
from steps import Steps

test = Steps()

SIDE = 60
CUBE = 6  # voxels of a label's block, of which the last is nobody's
LABELS = 200
ROW = 26
HEADER = 30  # at most


def write_grid(path, values, more=""):
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIDE} {SIDE} {SIDE}\n"
              "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n" + more + "\n")
    path.write_bytes(header.encode() + values)


def write_labels(path):
    """Blocks beside one another, of which each tenth is twice as long; names count backward."""
    values = bytearray(SIDE ** 3)
    label = 0
    sizes = {}
    for z in range(0, SIDE, CUBE):
        for y in range(0, SIDE, CUBE):
            for x in range(0, SIDE, 2 * CUBE):
                if label < LABELS:
                    label += 1
                    length = 2 * CUBE - 1 if label % 10 == 0 else CUBE - 1
                    for dz in range(CUBE - 1):
                        for dy in range(CUBE - 1):
                            at = ((z + dz) * SIDE + y + dy) * SIDE + x
                            values[at:at + length] = bytes([label]) * length
                    sizes[label] = length
    names = "".join(f"Segment{n - 1}_LabelValue:={n}\nSegment{n - 1}_Name:=Bone {LABELS + 1 - n}\n" for n in range(1, LABELS + 1))
    write_grid(path, values, names)


def rows(studio):
    """The names of the rows, seen ones and hidden ones."""
    seen, hidden = studio.state()["reports"]["segments"].split(" | ")
    return [names.split(", ") if names else [] for names in (seen, hidden)]


def cell(studio, row, column):
    x, y, width, height = studio.place_of("segments")
    right = {"volume": 92, "eye": 43, "lock": 15}
    along = {"colour": 14, "name": 60}.get(column) or width - right[column]
    first = y + height - 1 - shown_rows(height) * ROW
    return x + along, first + row * ROW + ROW // 2


def shown_rows(height):
    return (height - 2 - 20) // ROW


@test.step
def studio(display, arguments, folder):
    write_grid(folder / "body.nrrd", bytes([100]) * SIDE ** 3)
    write_labels(folder / "labels.seg.nrrd")
    studio = start(display, arguments.program, folder, [folder / "body.nrrd"])
    studio.resize(1400, 1180)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def labels(studio, folder):
    need("segmentSearch" not in studio.state()["widgets"], "one segment can be searched")
    few = studio.state()["widgets"]["segments"][3]
    studio.key("ctrl+l")
    studio.type_path("openLabelsDialog", folder / "labels.seg.nrrd")
    state = studio.wait_idle("the labels", lambda s: len(s["segments"]) == LABELS, 240)
    need(state["widgets"]["segments"][3] > few + 3 * ROW, "the list is as short as with one segment")
    studio.place_of("segmentSearch")
    need(rows(studio)[0][0] == f"Bone {LABELS}", f"the first is {rows(studio)[0][0]}, not as they were made")


@test.step(after=[labels])
def search(studio):
    studio.click("segmentSearch")
    studio.type("bone 1")
    studio.wait("what is searched for", lambda s: len(s["reports"]["segments"].split(", ")) == 111)
    studio.type("7")
    studio.wait("fewer", lambda s: len(s["reports"]["segments"].split(", ")) == 11)
    need(set(rows(studio)[0]) == {"Bone 17"} | {f"Bone {n}" for n in range(170, 180)}, f"found {rows(studio)[0]}")


@test.step(after=[search])
def sort(studio):
    """A click on a heading sorts by it, another the other way round, a third as they were made."""
    x, y, width, _ = studio.place_of("segments")
    orders = [["Bone 17", *(f"Bone {n}" for n in range(170, 180))]]
    orders += [orders[0][::-1], [f"Bone {n}" for n in range(179, 169, -1)] + ["Bone 17"]]
    for order in orders:
        studio.click((x + 60, y + 8))
        studio.wait("the order", lambda s: s["reports"]["segments"].split(" | ")[0].split(", ") == order)
    for bone in (orders[0][:1], orders[0][-1:]):
        need(bone[0] in rows(studio)[0], "sorting lost some")
    studio.click((x + width - 92, y + 8))
    studio.wait("by volume", lambda s: s["reports"]["segments"].split(" | ")[0].split(", ")[-1] in ("Bone 171", "Bone 17"))
    for _ in range(2):
        studio.click((x + width - 92, y + 8))
    studio.wait("as they were made", lambda s: s["reports"]["segments"].startswith("Bone 179"))


@test.step(after=[sort])
def alone(studio):
    """The menu of a row shows it alone, Alt+click on its eye all again; work goes on on the other."""
    before = [s["name"] for s in studio.state()["segments"] if s["working"]]
    studio.click(lambda: cell(studio, 2, "name"), button=3)
    studio.place_of("segmentMenu")
    studio.xdotool("key", "Down", "key", "Return")
    state = studio.wait_idle("one alone", lambda s: [x["name"] for x in s["segments"] if x["visible"]] == ["Bone 177"])
    need([s["name"] for s in state["segments"] if s["working"]] == before, "the menu goes to work on another")
    studio.focus()
    studio.arrive(lambda: cell(studio, 2, "eye"))
    studio.xdotool("keydown", "alt", "click", 1, "keyup", "alt")
    studio.wait_idle("all again", lambda s: all(x["visible"] for x in s["segments"]))
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: sum(x["visible"] for x in s["segments"]) == 1)


@test.step(after=[alone])
def choose(studio):
    """A click on a row that was found goes to work on it; without a search it is still at work, and in sight."""
    studio.click(lambda: cell(studio, 4, "name"))
    studio.wait_idle("work on it", lambda s: [x["name"] for x in s["segments"] if x["working"]] == ["Bone 175"])
    studio.click("segmentSearch")
    studio.key("ctrl+a")
    studio.key("BackSpace")
    state = studio.wait("all of them", lambda s: len(s["reports"]["segments"].split(", ")) >= LABELS - 1)
    need([x["name"] for x in state["segments"] if x["working"]] == ["Bone 175"], "searching goes to work on another")


@test.step(after=[choose])
def session(studio, folder):
    studio.move(studio.view_point(0.5, 0.5))
    return save_and_end(studio, folder)


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    kinds = [operation["op"] for operation in operations(path)]
    need(kinds.count("show segments") == 2 and "undo" in kinds, f"the session has {kinds}")
    report = compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)
    need(report["complete"], f"the replay is not complete: {json.dumps(report)[:300]}")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
