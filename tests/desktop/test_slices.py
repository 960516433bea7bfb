# SPDX-License-Identifier: Apache-2.0
"""Linked slices: leading the crosshair, seeding and painting on them, and all of it replayed."""

import math
import os
import pathlib
import sys

from driver import need, prefer, start
from replay import compare_with_replay, operations, run, save_and_end
from steps import Steps

test = Steps()

DATA = pathlib.Path(os.environ.get("VOLUME_STUDIO_TEST_DATA",
                                   pathlib.Path(__file__).resolve().parents[2].parent / "shared" / "data"))
CT = DATA / "dicom_ct_j2k"
SIZE = (60, 64, 40)
SPACING = (2.0, 2.0, 3.0)
BRAIN = 180


def write_head(path):
    """Scalp, skull and brain around the middle; x runs to the patient's right and y to the face, as in most NIfTI files."""
    def squares(axis):
        middle = (SIZE[axis] - 1) / 2
        return [((i - middle) * SPACING[axis]) ** 2 for i in range(SIZE[axis])]
    values = bytearray()
    for z in squares(2):
        for y in squares(1):
            for x in squares(0):
                r2 = x + y + z
                values.append(BRAIN if r2 < 44 ** 2 else 20 if r2 < 50 ** 2 else 120 if r2 < 56 ** 2 else 0)
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {' '.join(map(str, SIZE))}\n"
              f"space directions: (-{SPACING[0]},0,0) (0,-{SPACING[1]},0) (0,0,{SPACING[2]})\n"
              "space origin: (0,0,0)\nencoding: raw\n\n")
    path.write_bytes(header.encode() + values)


def slice_point(studio, name, fx, fy):
    x, y, width, height = studio.state()["widgets"][f"{name}Slice"]
    return round(x + fx * width), round(y + fy * height)


def slice_line(studio, name, begin, end, count=12):
    (x0, y0), (x1, y1) = slice_point(studio, name, *begin), slice_point(studio, name, *end)
    return [(x0 + (x1 - x0) * i // count, y0 + (y1 - y0) * i // count) for i in range(count + 1)]


def pixel_mm(studio, name, across, down):
    """What a pixel of a slice is at first: all of it is seen, with 6 % of room."""
    _, _, width, height = studio.state()["widgets"][f"{name}Slice"]
    return 1.06 * max(SIZE[across] * SPACING[across] / width, SIZE[down] * SPACING[down] / height)


def crosshair_at(studio, what, expected):
    """A voxel of tolerance: a click is on a whole pixel."""
    return studio.wait_idle(what, lambda s: all(abs(a - b) <= 1 for a, b in zip(s["crosshair"], expected)))


@test.step
def studio(display, arguments, folder):
    write_head(folder / "head.nrrd")
    return start(display, arguments.program, folder, [folder / "head.nrrd"])


@test.step
def open_slices(studio):
    state = studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    need("axialSlice" not in state["widgets"], "slices are open at first")
    studio.key("F4")
    state = studio.wait_idle("the slices", lambda s: all(f"{n}Slice" in s["widgets"]
                                                        for n in ("axial", "coronal", "sagittal")))
    need(state["crosshair"] == [n // 2 for n in SIZE], f"the crosshair is at {state['crosshair']}, not in the middle")


@test.step(after=[open_slices])
def lead_crosshair(studio):
    """A click on each slice moves the two others; the patient's left is on the right, the face on top."""
    mm = pixel_mm(studio, "axial", 0, 1)
    x, y = slice_point(studio, "axial", 0.5, 0.5)
    studio.click((x + 40, y - 30))
    # To the patient's left: x falls. Towards the face: y rises.
    expected = [SIZE[0] / 2 - 40 * mm / SPACING[0], SIZE[1] / 2 + 30 * mm / SPACING[1], SIZE[2] // 2]
    state = crosshair_at(studio, "the click on the axial slice", expected)
    need(state["crosshair"][2] == SIZE[2] // 2, "a click on the axial slice changed that slice")

    mm = pixel_mm(studio, "sagittal", 1, 2)
    x, y = slice_point(studio, "sagittal", 0.5, 0.5)
    studio.drag([(x, y), (x + 10, y - 10), (x + 25, y - 20)])  # leads all the way
    across = state["crosshair"][0]
    state = crosshair_at(studio, "the drag on the sagittal slice",
                         [across, SIZE[1] / 2 - 25 * mm / SPACING[1], SIZE[2] / 2 + 20 * mm / SPACING[2]])
    need(state["crosshair"][0] == across, "a drag on the sagittal slice changed that slice")


@test.step(after=[open_slices])
def scroll(studio):
    z = studio.state()["crosshair"][2]
    studio.move(slice_point(studio, "axial", 0.5, 0.5))
    studio.xdotool("click", "--repeat", 2, 4)  # two notches away
    studio.wait_idle("the wheel", lambda s: s["crosshair"][2] == z + 2)
    studio.xdotool("click", 1)
    studio.key("Page_Down")
    studio.wait_idle("Page Down", lambda s: s["crosshair"][2] == z + 1)
    # Zooming and moving leave the crosshair alone, and a place under the mouse is still what is clicked on.
    before = studio.state()["crosshair"]
    studio.xdotool("keydown", "ctrl", "click", "--repeat", 3, 4, "keyup", "ctrl")
    x, y = slice_point(studio, "axial", 0.5, 0.5)
    studio.drag([(x, y), (x + 15, y), (x + 30, y)], button=2)
    studio.wait_idle("the zoomed slice")
    need(studio.state()["crosshair"] == before, "looking around moved the crosshair")
    studio.key("shift+Home")


@test.step(after=[open_slices])
def window(studio):
    """The right button leads level and width, and neither the displayed range nor the 3D picture with them."""
    before = studio.wait_idle("the 3D picture", lambda s: s["pictureComplete"])
    low, high = before["sliceWindow"]
    need(low < 10 and high == BRAIN, f"slices begin with the window {low} to {high}")
    x, y = slice_point(studio, "coronal", 0.5, 0.5)
    studio.drag([(x, y), (x + 5, y - 5), (x + 40, y - 20)], button=3)
    state = studio.wait_idle("the window", lambda s: s["sliceWindow"] != [low, high])
    width = (high - low) * math.exp(40 / 200)
    level = (low + high) / 2 - width / 2 * 20 / 200
    expected = [level - width / 2, level + width / 2]
    need(all(abs(a - b) <= width / 90 for a, b in zip(state["sliceWindow"], expected)), f"{state['sliceWindow']}, not {expected}")
    need(state["range"] == before["range"] and state["crosshair"] == before["crosshair"], "more has changed than the window")
    studio.drag([(x, y), (x, y + 5), (x, y + 60)], button=3)
    state = studio.wait_idle("the level", lambda s: s["sliceWindow"][0] > expected[0])
    need(state["pictures"] == before["pictures"], "the 3D picture was made again for a window of slices")


@test.step(after=[window])
def chosen_window(studio):
    """A click of the right button offers windows; with Ctrl the button zooms and with the brush it removes, as before."""
    led = studio.state()["sliceWindow"]
    place = slice_point(studio, "axial", 0.4, 0.6)
    studio.click(place, button=3)
    studio.wait("the windows", lambda s: "sliceWindows" in s["widgets"])
    studio.key("Down")
    studio.key("Down")
    studio.key("Return")
    state = studio.wait_idle("the window of a brain", lambda s: s["sliceWindow"] == [0, 80])
    need("sliceWindows" not in state["widgets"], "the menu is still there")
    studio.focus()
    studio.key("shift+w")
    studio.wait_idle("the tint", lambda s: s["tintsSlices"])
    studio.xdotool("keydown", "ctrl")
    studio.drag([place, (place[0], place[1] - 20), (place[0], place[1] - 40)], button=3)
    studio.xdotool("keyup", "ctrl")
    state = studio.wait_idle("the zoomed slice")
    need(state["sliceWindow"] == [0, 80] != led, "the window went along with the zoom")
    studio.key("shift+Home")


@test.step(after=[open_slices])
def from_surface(studio):
    """A double click in the 3D view goes to the surface: the face looks at us, so far to the front."""
    studio.click(studio.view_point(0.5, 0.5), times=2)
    front = (SIZE[1] - 1) / 2 + 56 / SPACING[1]
    studio.wait_idle("the surface", lambda s: abs(s["crosshair"][1] - front) <= 1.5)
    x, y = slice_point(studio, "axial", 0.5, 0.5)
    studio.click((x, y))
    crosshair_at(studio, "the middle again", [SIZE[0] / 2, SIZE[1] / 2, studio.state()["crosshair"][2]])


@test.step(after=[open_slices])
def seed(studio):
    studio.key("s")
    studio.wait("the seed tool", lambda s: s["tool"] == "seed")
    studio.type_number("growthSpeed", 1)  # half a minute, in which it is paused
    studio.drag(slice_line(studio, "coronal", (0.45, 0.5), (0.55, 0.5)))
    studio.wait("growth", lambda s: s["generation"] > 3)
    studio.click("growPause")
    studio.wait_idle("the pause", lambda s: not s["playing"])


@test.step(after=[seed])
def paint(studio):
    """A stroke adds, the right button removes, undo and redo take one step a stroke."""
    studio.key("t")
    studio.wait("the paint tool", lambda s: s["tool"] == "paint")
    counts = [studio.state()["voxels"]]
    for button, slice_name, begin, end in ((1, "axial", (0.3, 0.3), (0.7, 0.3)), (3, "sagittal", (0.4, 0.6), (0.6, 0.4)),
                                           (1, "sagittal", (0.3, 0.7), (0.3, 0.7))):
        studio.drag(slice_line(studio, slice_name, begin, end), button=button)
        adds = button == 1
        state = studio.wait_idle(f"a stroke on the {slice_name} slice",
                                 lambda s: s["voxels"] > counts[-1] if adds else s["voxels"] < counts[-1])
        counts.append(state["voxels"])
    for _ in range(3):
        studio.key("ctrl+z")
        counts.insert(0, counts.pop())
        studio.wait_idle("undo", lambda s: s["voxels"] == counts[-1])
    for _ in range(3):
        studio.key("ctrl+shift+z")
        counts.append(counts.pop(0))
        studio.wait_idle("redo", lambda s: s["voxels"] == counts[-1])
    # A stroke that is dropped leaves nothing.
    before = studio.state()["operations"]
    studio.move(slice_point(studio, "axial", 0.3, 0.5))
    studio.xdotool("mousedown", 1)
    studio.move(slice_point(studio, "axial", 0.5, 0.6))
    studio.key("Escape")
    studio.xdotool("mouseup", 1)
    state = studio.wait_idle("the dropped stroke")
    need(state["operations"] == before, "a dropped stroke made an operation")


@test.step(after=[open_slices])
def measure(studio):
    """A dragged distance and a clicked angle on slices, a distance across the surface; what is deleted is gone."""
    studio.key("m")
    studio.wait("the measure tool", lambda s: s["tool"] == "measure")
    mm = pixel_mm(studio, "axial", 0, 1)
    x, y = slice_point(studio, "axial", 0.5, 0.5)
    studio.drag([(x - 30, y), (x, y + 20), (x + 30, y + 80)])
    state = studio.wait("the distance", lambda s: len(s["measurements"]) == 1)
    need(abs(state["measurements"][0] - 100 * mm) < 0.1, f"{state['measurements']} mm instead of {100 * mm}")
    studio.drag([studio.view_point(0.45, 0.5), studio.view_point(0.5, 0.5), studio.view_point(0.55, 0.5)])
    state = studio.wait_idle("the distance on the surface", lambda s: len(s["measurements"]) == 2)
    need(5 < state["measurements"][1] < 60, f"{state['measurements'][1]} mm across the face")
    studio.click("measureAngle")
    x, y = slice_point(studio, "sagittal", 0.5, 0.5)
    for point in ((x - 40, y), (x, y), (x + 30, y - 30)):
        studio.click(point)
    state = studio.wait("the angle", lambda s: len(s["measurements"]) == 3)
    need(abs(state["measurements"][2] - 135) < 0.01, f"{state['measurements'][2]} degrees instead of 135")
    studio.click("measurePath")
    x, y = slice_point(studio, "axial", 0.4, 0.5)
    studio.drag([(x, y), (x + 60, y), (x + 60, y + 40)])
    state = studio.wait("the path", lambda s: len(s["measurements"]) == 4)
    need(abs(state["measurements"][3] / (100 * mm) - 1) < 0.02, f"{state['measurements'][3]} mm instead of {100 * mm}")
    studio.click("measureArea")
    studio.drag([(x, y), (x + 60, y), (x + 60, y + 40), (x, y + 40), (x, y + 2)])
    state = studio.wait("the area", lambda s: len(s["measurements"]) == 5)
    need(abs(state["measurements"][4] / (2400 * mm * mm) - 1) < 0.02, f"{state['measurements'][4]} mm2 instead of {2400 * mm * mm}")
    studio.click("measureDeleteLast")
    studio.wait("one less", lambda s: len(s["measurements"]) == 4)
    studio.key("ctrl+z")
    studio.wait("undone", lambda s: len(s["measurements"]) == 5)
    studio.click("measureDeleteAll")
    studio.wait("none", lambda s: not s["measurements"])
    studio.key("ctrl+z")
    return studio.wait("all again", lambda s: len(s["measurements"]) == 5)["measurements"]


@test.step(after=[open_slices])
def arrange(studio):
    width = studio.state()["widgets"]["axialSlice"][2]
    studio.key("F7")
    studio.wait_idle("the large slice", lambda s: s["widgets"]["axialSlice"][2] > 1.2 * width)
    studio.click("axialEnlarge")
    studio.wait_idle("four views", lambda s: s["widgets"]["axialSlice"][2] == width)
    studio.key("F5")
    studio.wait_idle("the 3D view alone", lambda s: "axialSlice" not in s["widgets"] and s["pictureComplete"])


@test.step
def session(studio, folder):
    return save_and_end(studio, folder)


@test.step
def done(session):
    """What was seeded and painted."""
    done = [operation for operation in operations(session[0]) if operation["op"] in ("seed", "paint segment")]
    need([operation["op"] for operation in done] == ["seed"] + 3 * ["paint segment"], f"the session has {done}")
    return done


@test.step
def seeds_of_session(done):
    need(done[0]["trails"][0]["axis"] == "y" and len(done[0]["voxels"]) > 4, "the seeds are not on a coronal slice")


@test.step(after=[chosen_window])
def window_of_session(session):
    views = [operation for operation in operations(session[0]) if operation["op"] == "view"]
    need(views and views[-1]["sliceWindow"] == [0, 80] and views[-1]["tintSlices"], f"the session's last view is {views[-1:]}")


@test.step
def brush_of_session(done):
    need([operation["adds"] for operation in done[1:]] == [True, False, True], "the brush's signs are others")


@test.step
def measured_in_session(arguments, measure, session, folder):
    """The session's measurements are those that the window showed."""
    table = folder / "measured.csv"
    run(arguments.vstudio, "stats", session[0], "--measurements", table)
    values = [float(line.split(",")[2]) for line in table.read_text().splitlines()[1:]]
    need(len(values) == 5 and all(abs(a - b) < 1e-6 * abs(b) for a, b in zip(values, measure)), f"{values} instead of {measure}")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    report = compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)
    need(report["complete"], "the replay is not complete")
    print(run(arguments.vstudio, "stats", path))


@test.step(after=[session])
def preferred_window(display, arguments, folder):
    """CT scans are opened with the window that is preferred, all others with their own."""
    prefer(folder, sliceWindow="lung")
    if not CT.exists():
        print(f"there is no {CT}: not tried on a CT scan")
    for volume, expected in ((CT, [-1350, 150]), (folder / "head.nrrd", [0, BRAIN])):
        if volume.exists():
            studio = start(display, arguments.program, folder, [volume])
            state = studio.wait_idle("the volume", lambda s: s["pictureComplete"])
            need(state["sliceWindow"] == expected, f"{volume.name} is opened with the window {state['sliceWindow']}")
            studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
