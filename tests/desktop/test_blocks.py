# SPDX-License-Identifier: Apache-2.0
"""How long the window is kept from turning to the next event, in one step of work after another, on the head that comes with
Debian or a volume of one's own. Prints each step's longest; fails beyond the bound. On a machine that does other things too the
clock tells of those; there (--busy) what counts is the processor time that it took: of the window's own thread, or of the whole
program shared among the processors, since the window waits for a picture while all of them draw it; less what a virtual machine's
host took from it meanwhile."""

import json
import os
import pathlib
import sys

from driver import need, prefer, start
from steps import Steps
from stolen_time import StolenTime
from test_latency import circle, now_ms
from test_segments import choose, press, reveal

test = Steps()

HEAD = pathlib.Path("/usr/share/mricron/templates/ch2better.nii.gz")
MOST_MS = 100
TIMINGS = "timings.json"


# How the list of edits begins, and their amounts.
EDITS = (("Grow", -2), ("Smooth", 2), ("Fill", 0), ("Keep", None), ("Cut it", 0))


class Timeline:
    """What was done when."""

    def __init__(self, studio, stolen):
        self.studio, self.stolen, self.entries = studio, stolen, [("opening", 0, now_ms())]

    def do(self, name, action, condition=lambda s: True):
        begin = now_ms()
        action()
        self.studio.wait_idle(name, lambda s: condition(s) and s["pictureComplete"], 100)
        self.entries.append((name, begin, now_ms()))

    def report(self, blocks, measure):
        """The longest block of each entry by a measure, in ms."""
        longest = {}
        for name, begin, end in self.entries:
            found = sorted((b for b in blocks if begin <= b["began"] <= end), key=lambda b: -measure(b))
            longest[name] = measure(found[0]) if found else 0
            said = ", ".join(f"{measure(b):.0f} ({b['receiver'].strip()}, {b['event']})" for b in found[:3])
            print(f"{name:28} {(end - begin) / 1e3 if begin else 0:6.1f} s   longest: {said or 'below 40'}", flush=True)
        return longest


@test.step
def timeline(display, arguments, folder):
    volume = pathlib.Path(arguments.volume or HEAD)
    need(volume.exists(), f"there is no {volume}; install mricron-data")
    stolen = StolenTime()
    prefer(folder, firstStrokePercent=0)  # what is grown takes long, as what follows does
    studio = start(display, arguments.program, folder, ["--timings-file", folder / TIMINGS, volume])
    studio.resize(1600, 1000)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"], 100)
    return Timeline(studio, stolen)


@test.step
def cutting(timeline):
    studio = timeline.studio
    view = studio.view_point

    def drag(points):
        return lambda: studio.drag(points)

    def operations():
        return studio.state()["operations"]

    def cut(name, action):
        before = operations()
        timeline.do(name, action, lambda s: s["operations"] > before)

    timeline.do("turn", drag([view(0.5 + 0.01 * i, 0.5) for i in range(20)]))
    studio.key("Home")
    choose(studio, "p", "peel")
    studio.drag(circle(studio, (0.5, 0.4), 0.1, 2.2))
    studio.wait("the mask", lambda s: s["hint"].startswith("Press inside the mask"))
    middle = view(0.5, 0.36)
    cut("peel", drag([(middle[0], middle[1] + 4 * i) for i in range(30)]))
    studio.key("Escape")
    for tool, key in (("drill", "d"), ("laser", "b")):
        choose(studio, key, tool)
        studio.drag(circle(studio, (0.5, 0.4), 0.03, 2.2))
        studio.wait("the mask", lambda s: s["hint"].startswith("The mask "))
        cut(tool, drag(circle(studio, (0.45, 0.6), 0.05, 0.7)))
        studio.key("Escape")
    choose(studio, "x", "scissors")
    cut("scissors", drag([view(*p) for p in ((0.6, 0.6), (0.7, 0.6), (0.7, 0.75), (0.6, 0.75), (0.6, 0.62))]))
    choose(studio, "k", "keep")
    cut("keep", lambda: (studio.move(view(0.5, 0.3)), studio.xdotool("click", 1)))
    choose(studio, "v", "camera")
    for count in range(3):
        done = studio.state()["stepsDone"]
        timeline.do(f"undo {count + 1}", lambda: studio.key("ctrl+z"), lambda s, done=done: s["stepsDone"] == done - 1)
    done = studio.state()["stepsDone"]
    timeline.do("redo", lambda: studio.key("ctrl+shift+z"), lambda s: s["stepsDone"] == done + 1)


@test.step
def segmenting(timeline):
    studio = timeline.studio
    choose(studio, "s", "seed")
    timeline.do("grow", lambda: (studio.drag([studio.view_point(0.58 + 0.01 * i, 0.5) for i in range(5)])),
             lambda s: s["message"].startswith("Grow:") and not s["playing"])
    print(f"{studio.state()['voxels']} voxels grown")
    press(studio, "editFold")
    for name, amount in EDITS:
        before = studio.state()["operations"]
        choose_edit(studio, name, amount)
        timeline.do(f"edit: {name}", lambda: press(studio, "editPerform"), lambda s: s["operations"] > before)
        studio.key("ctrl+z")
        studio.wait_idle("undo", lambda s: s["pictureComplete"], 100)


def choose_edit(studio, name, amount):
    reveal(studio, "segmentEdit")
    studio.choose("segmentEdit", name)
    if amount is not None:
        reveal(studio, "editAmount")
        studio.type_number("editAmount", amount)


MODES = (("2", "mip"), ("3", "xray"), ("4", "overlay"), ("5", "segment"), ("9", "volume"), ("1", "surface"))


@test.step
def looking(timeline):
    studio = timeline.studio
    choose(studio, "v", "camera")
    for key, mode in MODES:
        timeline.do(f"mode {mode}", lambda: studio.key(key), lambda s: s["mode"] == mode)
    timeline.do("slices", lambda: studio.key("F4"), lambda s: "axialSlider" in s["widgets"])
    timeline.do("gradients", lambda: press(studio, "tabGradient"), lambda s: s["reports"].get("gradientCurve", "").endswith("chosen"))
    press(studio, "functionChoice")
    studio.wait("the gallery", lambda s: "preset.mr_t1_head" in s["widgets"])
    timeline.do("a preset", lambda: studio.click("preset.mr_t1_head"), lambda s: s["reports"]["functionChoice"].startswith("MR"))
    studio.focus()


@test.step
def filing(timeline, folder):
    """What goes into files and comes out of them."""
    studio = timeline.studio
    for name, keys, dialog, file in (("saving", "ctrl+s", "saveDialog", "session.json"),
                                     ("replaying", "ctrl+o", "openDialog", "session.json"),
                                     ("labels out", "ctrl+e", "labelsDialog", "labels.nrrd"),
                                     ("labels in", "ctrl+l", "openLabelsDialog", "labels.nrrd")):
        studio.move(studio.view_point(0.5, 0.9))
        studio.key(keys)
        before = studio.state()["message"]
        timeline.do(name, lambda: studio.type_path(dialog, folder / file),
                 lambda s: s["message"] != before and not s["loading"] and not s["message"].startswith("Reading"))


@test.step(after=[segmenting])
def give_up(timeline):
    """What lasts is ended by its button or by Escape, and nothing has happened."""
    studio = timeline.studio
    choose_edit(studio, "Smooth", 100)  # the most there is here, which takes seconds
    for name, way in (("the button", lambda place: studio.click(place, lasting=True)),
                      ("Escape", lambda place: studio.key("Escape", lasting=True))):
        need(any(is_given_up(timeline, way) for _ in range(5)), f"{name} was never before the end of the work")


def is_given_up(timeline, way):
    """Whether an edit was given up, which a hand may be too late for; then it is taken back."""
    studio = timeline.studio
    studio.wait_idle("the picture", lambda s: s["pictureComplete"])
    before = studio.state()
    press(studio, "editPerform", lasting=True)
    state = studio.wait("progress", lambda s: "giveUp" in s["widgets"] or s["operations"] > before["operations"])
    if "giveUp" in state["widgets"]:
        x, y, width, height = state["widgets"]["giveUp"]
        timeline.do("giving up", lambda: way((x + width // 2, y + height // 2)),
                 lambda s: s["message"].startswith("Given up") or s["operations"] > before["operations"])
    state = studio.focus()
    if state["operations"] > before["operations"]:
        studio.key("ctrl+z")
        return False
    for what in ("operations", "voxels", "stepsDone"):
        need(state[what] == before[what], f"{what} were {before[what]} and are {state[what]} after giving up")
    return True


def by_clock(block):
    return block["ms"]


def by_processor(stolen):
    """Never more than by the clock, and nothing of what the program did not have, though the kernel may have charged it for that."""
    def measure(block):
        used = max(block["threadMs"], block["programMs"] / len(os.sched_getaffinity(0)))
        return max(0, min(block["ms"], used) - stolen.between(block["began"], block["began"] + block["ms"]))
    return measure


@test.step
def longest(timeline, arguments, folder):
    """Ends the program. Returns the longest block of each entry."""
    timeline.studio.quit()
    timeline.stolen.end()
    blocks = json.loads((folder / TIMINGS).read_text())["blocks"]
    print(f"{timeline.stolen.total():.0f} ms of processors were taken by the host")
    return timeline.report(blocks, by_processor(timeline.stolen) if arguments.busy else by_clock)


@test.step
def bound(longest, arguments):
    bound = arguments.slack * MOST_MS
    late = [f"{name} ({ms:.0f} ms)" for name, ms in longest.items() if ms > bound]
    need(not late, f"the window was kept longer than {bound:.0f} ms by {', '.join(late)}")


def with_volume(parser):
    parser.add_argument("--volume", help="instead of the head")
    parser.add_argument("--slack", type=float, default=1, help="how many times the bound a slow machine may take")
    parser.add_argument("--busy", action="store_true", help="the machine does other things too: bound the processor time")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio", configure=with_volume))
