# SPDX-License-Identifier: Apache-2.0
"""The histogram panel by hand: the displayed range dragged, typed and moved by keys, and what the cuts left to be seen."""

import argparse
import re
import sys

from driver import need, run_test, start
from phantom import BRAIN, write_ball_head
from replay import compare_with_replay, operations

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


def type_number(studio, box, number):
    studio.click(box)
    studio.key("ctrl+a")
    studio.xdotool("type", str(number))
    studio.key("Return")


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

    type_number(studio, "rangeHi", 5000)
    state = studio.wait_idle("the answer", lambda s: "rangeNote" in s["widgets"])
    need(state["range"][1] == GREATEST, f"5000 was taken as {state['range'][1]}")
    need(state["message"] == f"5000 lies beyond the data, which go from 0 to {GREATEST}.", state["message"])
    type_number(studio, "rangeHi", 170)
    state = studio.wait_idle("the number", lambda s: s["range"][1] == 170 and "rangeNote" not in s["widgets"])
    type_number(studio, "rangeLo", 175)
    state = studio.wait_idle("the exchange", lambda s: s["range"] == [170, 175])
    need("exchanged" in state["message"], state["message"])
    type_number(studio, "rangeLo", 100)
    studio.wait_idle("the number", lambda s: s["range"] == [100, 175])

    studio.move(chart.at(20))
    studio.xdotool("click", 1)
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


def save_and_compare(studio, arguments, folder):
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    state = studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    session = folder / "session.json"
    compare_with_replay(arguments.vstudio, session, folder / "window.png", state["viewport"], folder)
    return operations(session)


def main(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.resize(900, 760)
    studio.wait_idle("the volume", lambda s: s["viewport"][0] < 500 and s["pictureComplete"])
    drag_range(studio)
    cut_and_count(studio)
    done = save_and_compare(studio, arguments, folder)
    views = [operation for operation in done if operation["op"] == "view"]
    need(views[-1]["range"] == [100, 173], f"the session's range is {views[-1]['range']}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--vstudio", required=True)
    parser.add_argument("--work", required=True, help="folder to work in; emptied first")
    sys.exit(run_test(main, parser.parse_args()))
