# SPDX-License-Identifier: Apache-2.0
"""The histogram panel by hand: the displayed range dragged, typed and moved by keys, and what the cuts left to be seen."""

import json
import re
import sys

from driver import need, start
from phantom import BRAIN, write_ball_head
from replay import compare_with_replay, operations, save_and_end
from steps import Steps

test = Steps()

SIDE = 6  # pixels beside the bars of a chart
GREATEST = BRAIN  # of all values; the smallest is 0


class Chart:
    """Places on a chart of the panel by their values."""

    def __init__(self, studio, name, lo=0, hi=GREATEST):
        self.studio, self.name, self.lo, self.hi = studio, name, lo, hi

    def at(self, value, height=0.5):
        """Height as a part of the widget from its top."""
        x, y, width, tall = self.studio.state()["widgets"][self.name]
        return round(x + SIDE + (value - self.lo) / (self.hi - self.lo) * (width - 2 * SIDE)), round(y + height * tall)


@test.step
def studio(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.resize(900, 760)
    studio.wait_idle("the volume", lambda s: s["viewport"][0] < 500 and s["pictureComplete"])
    return studio


@test.step
def drag_range(studio):
    """Both ends and the band; typed beyond the data; by keys."""
    chart = Chart(studio, "histogram")
    lo, hi = studio.state()["range"]
    studio.drag([chart.at(lo), chart.at(lo - 10), chart.at(60)])
    state = studio.wait_idle("the lower end", lambda s: abs(s["range"][0] - 60) <= 1 and s["range"][1] == hi)
    lo = state["range"][0]
    studio.drag([chart.at(hi), chart.at(165), chart.at(160)])
    state = studio.wait_idle("the upper end", lambda s: s["range"][0] == lo and abs(s["range"][1] - 160) <= 1)
    width = state["range"][1] - lo
    studio.drag([chart.at(110), chart.at(115), chart.at(120)])
    state = studio.wait_idle("the band", lambda s: abs(s["range"][0] - lo - 10) <= 1)
    need(state["range"][1] - state["range"][0] == width, f"the band changed its width: {state['range']}")

    studio.type_number("rangeHi", 5000)
    state = studio.wait_idle("the answer", lambda s: "rangeNote" in s["widgets"])
    need(state["range"][1] == GREATEST, f"5000 was taken as {state['range'][1]}")
    need(state["message"] == f"5000 lies beyond the data, which go from 0 to {GREATEST}.", state["message"])
    studio.type_number("rangeHi", 170)
    state = studio.wait_idle("the number", lambda s: s["range"][1] == 170 and "rangeNote" not in s["widgets"])
    studio.type_number("rangeLo", 175)
    state = studio.wait_idle("the exchange", lambda s: s["range"] == [170, 175])
    need("exchanged" in state["message"], state["message"])
    studio.type_number("rangeLo", 100)
    studio.wait_idle("the number", lambda s: s["range"] == [100, 175])

    studio.click(chart.at(20))
    studio.key("shift+Left")
    studio.wait_idle("the upper end by a key", lambda s: s["range"] == [100, 174])
    studio.key("ctrl+Right")
    studio.wait_idle("the lower end by a key", lambda s: s["range"] == [101, 174])
    studio.key("Left")
    studio.wait_idle("the band by a key", lambda s: s["range"] == [100, 173])
    studio.click("histogramLog")
    studio.click("histogramLog")


def visible(state):
    """How many voxels the histogram says are visible, and of how many."""
    return tuple(map(int, re.fullmatch(r"(\d+) of (\d+) voxels visible", state["reports"].get("histogram", "")).groups()))


@test.step(after=[drag_range])
def cut_and_count(studio):
    """Scissors through the middle: what is left is counted at rest, and undo brings all of it back."""
    state = studio.wait_idle("the count", lambda s: "histogram" in s["reports"])
    need(visible(state)[0] == visible(state)[1], f"without cuts {state['reports']['histogram']}")
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    studio.drag([studio.view_point(*place) for place in ((0.3, 0.3), (0.5, 0.25), (0.5, 0.75), (0.3, 0.7), (0.3, 0.4))])
    state = studio.wait_idle("the cut", lambda s: s["canUndo"] and visible(s)[0] < visible(s)[1])
    left, total = visible(state)
    need(0.1 < left / total < 0.98, f"{left} of {total} voxels are left")
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: visible(s)[0] == total)
    studio.key("ctrl+shift+z")
    studio.wait_idle("redo", lambda s: visible(s)[0] == left)


class Editor(Chart):
    """Places on a chart with a curve, and what it says of its points."""

    TOP, BELOW = 4, 26  # pixels above the bars, and for strip and numbers below

    def on(self, value, opacity):
        x, y, width, tall = self.studio.state()["widgets"][self.name]
        bottom = y + tall - self.BELOW
        return self.at(value)[0], round(bottom - opacity * (tall - self.BELOW - self.TOP))

    def wait(self, chosen, count):
        said = f"{chosen} of {count} chosen"
        return self.studio.wait(f"{self.name} to say {said}", lambda s: s["reports"].get(self.name) == said)


def in_use(studio, name):
    return studio.wait(f"the colours {name}", lambda s: s["reports"].get("functionChoice") == name)


@test.step(after=[drag_range])
def edit_intensity(studio):
    """Points added, dragged, typed, coloured, chosen and moved by keys, removed; a hill moved; a box; undo."""
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("9")
    studio.wait("volume mode", lambda s: s["mode"] == "volume")
    studio.click("tabIntensity")
    curve = Editor(studio, "intensityCurve")
    curve.wait("none", 4)  # that of the displayed range, 100 to 173
    in_use(studio, "The mode's own colours")
    studio.drag([curve.on(107, 0.2), curve.on(112, 0.3), curve.on(120, 0.5)])
    curve.wait(1, 4)
    in_use(studio, "displayed range")
    studio.click(curve.on(30, 0.7))
    curve.wait(0, 5)
    studio.type_number("intensityValue", 40)
    studio.type_number("intensityOpacity", 0)
    studio.type_number("intensityValue", 150)
    studio.wait("the answer", lambda s: s["message"] == "150 lies beyond the next point: this one was put to 100")
    studio.click("intensityUndo")
    studio.click(curve.on(40, 0))
    curve.wait(0, 5)
    studio.key("Tab")
    curve.wait(1, 5)
    studio.key("Tab")
    curve.wait(2, 5)
    studio.key("shift+Right")
    studio.key("Up")
    studio.key("Delete")
    curve.wait(1, 4)
    studio.key("ctrl+z")
    curve.wait(1, 5)
    studio.drag([curve.on(140, 0.2), curve.on(135, 0.2), curve.on(130, 0.2)])  # the hill between 100 and 173
    studio.click("intensityAdd")
    state = studio.wait("the box", lambda s: s["reports"]["intensityCurve"].split()[0] != "none")
    points = int(state["reports"]["intensityCurve"].split()[2])
    need(points >= 7, f"a box makes {state['reports']['intensityCurve']}")
    studio.click("intensityColour")
    studio.wait("the dialog", lambda s: "colourDialog" in s["widgets"])
    x, y, width, height = studio.state()["widgets"]["colourDialog"]
    studio.click((x + width // 10, y + height // 6))
    studio.key("Return")
    studio.wait("the dialog to close", lambda s: "colourDialog" not in s["widgets"])
    studio.focus()


def gallery(studio, button):
    studio.click("functionChoice")
    studio.click(button)
    studio.wait("the gallery to close", lambda s: button not in s["widgets"])
    studio.focus()


@test.step(after=[edit_intensity])
def colours(studio, folder):
    """Saved as a file, reset, taken from the gallery, another table, then the file again. Returns what it holds."""
    studio.click("functionSave")
    studio.type_path("functionSaveDialog", folder / "colours.json")
    studio.wait("the file", lambda s: s["message"].startswith("Saved colours"))
    studio.click("functionReset")
    in_use(studio, "The mode's own colours")
    studio.key("1")
    studio.wait("surface mode", lambda s: s["mode"] == "surface")
    gallery(studio, "preset.grey_ramp")
    in_use(studio, "Grey ramp")
    studio.wait("the mode that suits it", lambda s: s["mode"] == "volume")
    studio.click("intensityUndo")
    in_use(studio, "The mode's own colours")
    studio.wait("the mode from before", lambda s: s["mode"] == "surface")
    gallery(studio, "preset.grey_ramp")
    in_use(studio, "Grey ramp")
    gallery(studio, "map.ember")
    studio.click("functionOpen")
    studio.type_path("functionOpenDialog", folder / "colours.json")
    in_use(studio, "displayed range")
    return json.loads((folder / "colours.json").read_text())


@test.step
def points_of_colours(colours):
    need(len({point["colour"] for point in colours["points"]}) > 3, f"the points are {colours['points']}")


@test.step(after=[colours])
def edit_gradient(studio):
    """Counted when first wanted; the function there comes into use with the first edit."""
    studio.click("tabGradient")
    curve = Editor(studio, "gradientCurve", 0, 1)
    curve.wait("none", 4)
    studio.drag([curve.on(0.6, 0.35), curve.on(0.55, 0.5), curve.on(0.5, 0.6)])
    curve.wait(2, 4)
    in_use(studio, "edges")
    studio.click("gradientUndo")
    in_use(studio, "displayed range")


@test.step(after=[edit_gradient])
def edit_both(studio):
    """A box moved and stretched, a triangle drawn, another painted; by numbers; by keys."""
    studio.click("tabBoth")
    plane = Editor(studio, "plane")
    x, y, width, height = plane.wait("none", 1)["widgets"]["plane"]

    def place(fx, fy):
        return round(x + fx * width), round(y + fy * height)

    studio.drag([place(0.7, 0.45), place(0.69, 0.42), place(0.65, 0.4)])  # the box at 100 to 173
    plane.wait(0, 1)
    in_use(studio, "intensity and gradient")
    studio.click("drawTriangle")
    studio.drag([place(0.1, 0.2), place(0.2, 0.3), place(0.3, 0.6)])
    plane.wait(0, 2)
    studio.wait("the numbers of a triangle's top", lambda s: "shapeTopLo" in s["widgets"])
    studio.type_number("shapeTopLo", 20)
    studio.type_number("shapeTopHi", 5)
    studio.wait("the answer", lambda s: "exchanged" in s["message"])
    studio.type_number("shapeOpacity", 30)
    studio.click("drawPaint")
    studio.drag([place(0.15, 0.75), place(0.3, 0.72), place(0.5, 0.78)])
    plane.wait(0, 3)
    studio.drag([place(0.5, 0.78), place(0.45, 0.76)], button=3)
    studio.key("Tab")
    plane.wait(1, 3)
    studio.key("shift+Right")
    studio.key("Tab")
    plane.wait(2, 3)


@test.step
def session(studio, folder):
    studio.move(studio.view_point(0.5, 0.9))
    return save_and_end(studio, folder)


@test.step
def last_view(session):
    return [operation for operation in operations(session[0]) if operation["op"] == "view"][-1]


@test.step(after=[edit_both])
def shapes_of_session(last_view):
    function = last_view["transferFunction"]
    need([shape["shape"] for shape in function["shapes"]] == ["painting", "trapezoid", "box"],
         f"the shapes are {[shape['shape'] for shape in function['shapes']]}")
    painting, triangle, box = function["shapes"]
    need(max(max(row) for row in painting["cells"]) == 255, "the paint is faint")
    need(triangle["base"][0] == triangle["base"][1], f"the triangle stands on {triangle['base']}")
    need(triangle["opacity"] == 0.3, f"the triangle's opacity is {triangle['opacity']}")
    need(90 <= box["values"][0] < 100 and abs(box["values"][1] - box["values"][0] - 73) < 1e-6, f"{box['values']}")


@test.step
def range_of_session(last_view):
    need(last_view["range"] == [100, 173], f"the session's range is {last_view['range']}")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
