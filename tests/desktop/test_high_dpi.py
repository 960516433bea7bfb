# SPDX-License-Identifier: Apache-2.0
"""At scales 1, 1.5 and 2 strokes land exactly under the pen, in device pixels, and replay without a window to the same picture."""

import math
import sys

from driver import need, start
from phantom import write_ball_head
from replay import compare_with_replay, operations
from steps import Steps

test = Steps()

# Device pixels. Whole scales have none to round. At 1.5 the view's corner may lie in the middle of a device pixel, half a pixel
# each way from where this script takes it to be (0.71 in all), and an odd size times 1.5 is rounded to whole pixels, half of one
# at the far side. Measured in the middle of the view: 0.58.
ROUNDING = {1: 0.01, 1.5: 0.75, 2: 0.01}


def odd(points):
    """Odd places too: between the scaled pixels."""
    return [(px + i % 2, py + (i + 1) % 2) for i, (px, py) in enumerate(points)]


def draw_mask(studio, key, tool, places):
    studio.move(studio.view_point(0.5, 0.5))
    studio.key(key)
    studio.wait(f"the {tool} tool", lambda s: s["tool"] == tool)
    hint = studio.state()["hint"]
    outline = odd([studio.view_point(*place) for place in places])
    studio.drag(outline)
    studio.wait(f"the mask of {tool}", lambda s: s["hint"] != hint and not s["hint"].startswith("Let go"))
    return outline


def off(points, drawn, corner):
    """How far the points of an operation are from where the pen was, at most, in device pixels."""
    need(len(points) == len(drawn), f"the stroke has {len(points)} points, the pen made {len(drawn)}")
    return max(math.dist(point[:2], (px - corner[0] + 0.5, py - corner[1] + 0.5))
               for point, (px, py) in zip(points, drawn))


def last(session, name):
    return [operation for operation in operations(session) if operation["op"] == name][-1]


def at_scale(display, arguments, folder, volume, scale):
    folder.mkdir()
    studio = start(display, arguments.program, folder, [volume], scale=scale)
    studio.resize(round(1000 * scale ** 0.5), round(700 * scale ** 0.5))  # less to draw; more where widgets are larger
    # The hint may need another line once there is a volume; the picture then follows the view.
    state = studio.wait_idle("a picture of the volume as large as the view",
                             lambda s: s["pictureComplete"] and s["viewport"] == s["viewRect"][2:])
    x, y = state["viewRect"][:2]

    peel_mask = draw_mask(studio, "p", "peel", ((0.42, 0.41), (0.58, 0.43), (0.57, 0.6), (0.43, 0.59)))
    middle = studio.view_point(0.5, 0.5)
    studio.drag([(middle[0], middle[1] + d) for d in range(0, 101, 10)])
    studio.wait_idle("the peel", lambda s: s["operations"] >= 1 and s["canUndo"])
    done = studio.state()["steps"]

    drill_mask = draw_mask(studio, "d", "drill", ((0.45, 0.3), (0.5, 0.29), (0.5, 0.35), (0.45, 0.36)))
    drilled = odd([(middle[0] + 7 * i, middle[1] - 90 + 3 * i) for i in range(8)])
    studio.drag(drilled)
    studio.wait_idle("the drill", lambda s: s["steps"] == done + 1)

    studio.click("autoStart")  # off
    studio.move(studio.view_point(0.5, 0.5))
    studio.key("s")
    studio.wait("the seed tool", lambda s: s["tool"] == "seed")
    seeded = odd([(middle[0] - 20 + 6 * i, middle[1] + 4 * i) for i in range(8)])
    studio.drag(seeded)
    studio.wait_idle("the seeds", lambda s: s["voxels"] > 0)

    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    studio.quit()

    session = folder / "session.json"
    peel, drill, seed = (last(session, name) for name in ("peel", "drill", "seed"))
    errors = {"peel's mask": off(peel["mask"]["points"], peel_mask, (x, y)),
              "drill's mask": off(drill["mask"]["points"], drill_mask, (x, y)),
              "drill": off(drill["stroke"], drilled, (x, y)),
              "seed": off(seed["strokes"][0]["points"], seeded, (x, y))}
    print(f"scale {scale}: off by at most", {name: round(error, 3) for name, error in errors.items()}, "device pixels")
    far = [f"{name} by {error:.2f}" for name, error in errors.items() if error > ROUNDING[scale]]
    need(not far, f"off by more than {ROUNDING[scale]} device pixels at scale {scale}: {', '.join(far)}")
    # A layer is ten logical pixels.
    need(abs(peel["layers"] - 10 / scale) < 1e-6, f"{peel['layers']} layers were peeled, not {10 / scale}")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", state["viewport"], folder)


@test.step
def volume(folder):
    write_ball_head(folder / "head.nrrd")
    return folder / "head.nrrd"


@test.step
def scale_1(display, arguments, folder, volume):
    at_scale(display, arguments, folder / "scale_1", volume, 1)


@test.step
def scale_1_5(display, arguments, folder, volume):
    at_scale(display, arguments, folder / "scale_1.5", volume, 1.5)


@test.step
def scale_2(display, arguments, folder, volume):
    at_scale(display, arguments, folder / "scale_2", volume, 2)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
