# SPDX-License-Identifier: Apache-2.0
"""At twice the scale strokes still land exactly under the pen, in device pixels."""

import argparse
import math
import sys

from driver import need, run_test, start
from phantom import write_ball_head
from replay import compare_with_replay, operations


def main(display, arguments, folder):
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume], scale=2)
    state = studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    x, y, width, height = state["viewRect"]
    need(state["viewport"] == [width, height], f"the viewport {state['viewport']} is not the view's {width} x {height}")

    studio.move(studio.view_point(0.5, 0.5))
    studio.key("p")
    studio.wait("the peel tool", lambda s: s["tool"] == "peel")
    # Odd places too: between the scaled pixels.
    outline = [studio.view_point(*place) for place in ((0.42, 0.41), (0.58, 0.43), (0.57, 0.6), (0.43, 0.59))]
    outline = [(px + i % 2, py + (i + 1) % 2) for i, (px, py) in enumerate(outline)]
    studio.drag(outline)
    studio.wait("the mask", lambda s: s["hint"].startswith("Press inside the mask"))
    middle = studio.view_point(0.5, 0.5)
    studio.drag([(middle[0], middle[1] + d) for d in range(0, 101, 10)])
    studio.wait_idle("the peel", lambda s: s["operations"] >= 1 and s["canUndo"])

    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    studio.quit()

    session = folder / "session.json"
    peel = next(operation for operation in operations(session) if operation["op"] == "peel")
    drawn = len(peel["mask"]["points"])
    need(drawn == len(outline), f"the mask has {drawn} points, the pen made {len(outline)}")
    for point, (px, py) in zip(peel["mask"]["points"], outline):
        expected = (px - x + 0.5, py - y + 0.5)
        need(math.dist(point, expected) < 0.01, f"the mask has {point} where the pen was at {expected}")
    # A layer is ten logical pixels, so 100 device pixels at scale 2 are five layers.
    need(abs(peel["layers"] - 5) < 1e-6, f"{peel['layers']} layers were peeled, not 5")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", [width, height], folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--vstudio", required=True)
    parser.add_argument("--work", required=True, help="folder to work in; emptied first")
    sys.exit(run_test(main, parser.parse_args()))
