# SPDX-License-Identifier: Apache-2.0
"""Every shape that a mask can be sketched in, cut out by the scissors or the drill."""

import argparse
import math
import struct
import sys
import zlib

from driver import need, run_test, start
from phantom import head
from replay import compare_with_replay, operations


def write_star(path, size=96):
    """A picture that shows a white star on black."""
    def value(x, y):
        angle = math.atan2(y - size / 2, x - size / 2)
        tip = abs((angle / (2 * math.pi) * 5) % 1 * 2 - 1)
        return 255 if math.hypot(x - size / 2, y - size / 2) < size * (0.2 + 0.27 * tip) else 0

    rows = b"".join(b"\0" + bytes(value(x, y) for x in range(size)) for y in range(size))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def wait_cut(studio, name, before):
    return studio.wait_idle(name, lambda s: s["operations"] > before and s["message"].startswith(name)
                            and s["pictureComplete"])


def drag_shape(studio, key, begin, end):
    studio.key(key)
    before = studio.state()["operations"]
    (x0, y0), (x1, y1) = studio.view_point(*begin), studio.view_point(*end)
    studio.drag([(x0 + (x1 - x0) * i // 6, y0 + (y1 - y0) * i // 6) for i in range(7)])
    wait_cut(studio, "Scissors", before)


def click_polyline(studio, corners):
    """Corner after corner, the first one again to close it."""
    studio.key("y")
    before = studio.state()["operations"]
    for corner in [*corners, corners[0]]:
        studio.click(studio.view_point(*corner))
        need(corner is corners[0] or studio.state()["operations"] == before, "a polyline cut before it was closed")
    wait_cut(studio, "Scissors", before)


def drill_star(studio, folder):
    """The shape of a picture, fitted into a box and carried along by the drill."""
    write_star(folder / "star.png")
    studio.key("d")
    studio.click("stencil")
    studio.type_path("stencilDialog", folder / "star.png")
    studio.wait("the star", lambda s: "star.png" in s["message"])
    studio.drag([studio.view_point(0.42 + 0.02 * i, 0.62 + 0.02 * i) for i in range(6)])
    studio.wait("the drill's mask", lambda s: s["hint"].startswith("The mask follows"))
    before = studio.state()["operations"]
    studio.drag([studio.view_point(0.5, 0.68), studio.view_point(0.505, 0.68)])
    wait_cut(studio, "Drill", before)


def main(display, arguments, folder):
    studio = start(display, arguments.program, folder, [head(folder, True)])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.resize(900, 700)
    studio.wait_idle("the small window", lambda s: s["viewport"][0] < 500 and s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    drag_shape(studio, "n", (0.36, 0.36), (0.44, 0.44))
    drag_shape(studio, "o", (0.56, 0.42), (0.6, 0.42))
    drag_shape(studio, "e", (0.44, 0.26), (0.56, 0.32))
    click_polyline(studio, [(0.40, 0.55), (0.5, 0.5), (0.58, 0.56), (0.5, 0.6)])
    drill_star(studio, folder)
    studio.key("F12")
    studio.type_path("screenshotDialog", folder / "window.png")
    studio.wait_idle("the picture", lambda s: s["message"].startswith("Saved picture"))
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    state = studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    cuts = [o for o in operations(folder / "session.json") if o["op"] in ("scissors", "drill")]
    shapes = [(o.get("outline") or o["mask"])["shape"] for o in cuts]
    need(shapes == ["rectangle", "circle", "ellipse", "polyline", "stencil"], f"the shapes are {shapes}")
    need(len(cuts[3]["outline"]["points"]) == 4, f"the polyline has {cuts[3]['outline']['points']}")
    compare_with_replay(arguments.vstudio, folder / "session.json", folder / "window.png", state["viewport"], folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--vstudio", required=True)
    parser.add_argument("--work", required=True, help="folder to work in; emptied first")
    sys.exit(run_test(main, parser.parse_args()))
