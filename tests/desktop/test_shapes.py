# SPDX-License-Identifier: Apache-2.0
"""Every shape that a mask can be sketched in, cut out by the scissors or the drill."""

import math
import struct
import sys
import zlib

from driver import need, start
from phantom import head
from replay import compare_with_replay, operations, save_and_end
from steps import Steps

test = Steps()


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


@test.step
def studio(display, arguments, folder):
    """A small window, with the scissors in hand."""
    studio = start(display, arguments.program, folder, [head(folder, True)])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.resize(900, 700)
    studio.wait_idle("the small window", lambda s: s["viewport"][0] < 500 and s["pictureComplete"])
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("x")
    studio.wait("the scissors", lambda s: s["tool"] == "scissors")
    return studio


@test.step
def rectangle(studio):
    drag_shape(studio, "n", (0.36, 0.36), (0.44, 0.44))


@test.step
def circle(studio):
    drag_shape(studio, "o", (0.56, 0.42), (0.6, 0.42))


@test.step
def ellipse(studio):
    drag_shape(studio, "e", (0.44, 0.26), (0.56, 0.32))


@test.step
def polyline(studio):
    click_polyline(studio, [(0.40, 0.55), (0.5, 0.5), (0.58, 0.56), (0.5, 0.6)])


@test.step
def stencil(studio, folder):
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


@test.step
def session(studio, folder):
    return save_and_end(studio, folder)


@test.step
def cuts(session):
    """Those of the session, each with its shape."""
    cuts = [o for o in operations(session[0]) if o["op"] in ("scissors", "drill")]
    shapes = [(o.get("outline") or o["mask"])["shape"] for o in cuts]
    need(shapes == ["rectangle", "circle", "ellipse", "polyline", "stencil"], f"the shapes are {shapes}")
    return cuts


@test.step
def corners(cuts):
    need(len(cuts[3]["outline"]["points"]) == 4, f"the polyline has {cuts[3]['outline']['points']}")


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
