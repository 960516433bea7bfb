# SPDX-License-Identifier: Apache-2.0
"""Looking around: what is opened fills the view, the cube and the keys of the standard views, tumbling, rolling at the rim."""

import json
import math
import sys

from driver import need, start
from replay import compare_with_replay, save_and_end
from steps import Steps
from viewer import axes, dot, seen

test = Steps()

SIZE = (96, 60, 150)  # voxels of a millimetre; a body far from its middle, with noise in the air
BODY = ((8, 10, 20), (40, 34, 120))
CENTRE = tuple((n - 1) / 2 for n in SIZE)
DIAGONAL = math.dist((0, 0, 0), SIZE)
MARGIN = 0.04  # left free around what is fitted
CELL = 4  # voxels: what is visible is known so finely
STANDARD = {"ctrl+1": (0, -1, 0), "ctrl+2": (0, 1, 0), "ctrl+3": (1, 0, 0), "ctrl+4": (-1, 0, 0), "ctrl+5": (0, 0, 1),
            "ctrl+6": (0, 0, -1)}


def write_body(path):
    (x0, y0, z0), (x1, y1, z1) = BODY
    values = bytearray(SIZE[0] * SIZE[1] * SIZE[2])
    for z in range(z0, z1):
        for y in range(y0, y1):
            row = (z * SIZE[1] + y) * SIZE[0]
            values[row + x0:row + x1] = bytes([200]) * (x1 - x0)
    for speck in range(0, len(values), 39989):  # a prime: scattered
        values[speck] = 220
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {' '.join(map(str, SIZE))}\n"
              "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n\n")
    path.write_bytes(header.encode() + values)


def need_fitted(state, what):
    """The body is in the picture with its margin, and as large as macrocells can tell."""
    size = state["viewRect"][2:]
    corners = [[BODY[(n >> axis) & 1][axis] for axis in range(3)] for n in range(8)]
    places = [seen(state["camera"], corner, CENTRE, DIAGONAL, size) for corner in corners]
    room = min(min(x, 1 - x, y, 1 - y) for x, y in places)
    cells = [[BODY[(n >> axis) & 1][axis] + (CELL if (n >> axis) & 1 else -CELL) for axis in range(3)] for n in range(8)]
    around = [seen(state["camera"], corner, CENTRE, DIAGONAL, size) for corner in cells]
    least = min(min(x, 1 - x, y, 1 - y) for x, y in around)
    need(room > MARGIN - 0.005 and least < MARGIN + 0.005,
         f"{what}: the body leaves {room:.3f} of the view free, and {least:.3f} around its macrocells")


def looks_from(state, direction):
    back = axes(state["camera"])[2]
    return dot(back, direction) / math.sqrt(dot(direction, direction)) > 1 - 1e-9


def direction_of(zone):
    return tuple({"-": -1, "0": 0, "+": 1}[sign] for sign in zone)


def tick(studio, box):
    """A box is wider than what of it can be clicked."""
    x, y, _, height = studio.place_of(box)
    studio.click((x + 9, y + height // 2))


@test.step
def studio(display, arguments, folder):
    write_body(folder / "body.nrrd")
    return start(display, arguments.program, folder, [folder / "body.nrrd"])


@test.step
def opening(studio):
    state = studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    need(state["camera"]["zoom"] > 1.1, f"a body in a corner of its grid is opened with zoom {state['camera']['zoom']}")
    need_fitted(state, "opened")


@test.step(after=[opening])
def standard_views(studio):
    for key, direction in STANDARD.items():
        studio.key(key)
        state = studio.wait_idle(key, lambda s: looks_from(s, direction))
        need_fitted(state, key)
    up = axes(state["camera"])[1]
    need(dot(up, (0, -1, 0)) > 1 - 1e-9, f"from below, {up} is up, not the face")
    studio.key("Home")
    studio.wait_idle("the face", lambda s: looks_from(s, (0, -1, 0)))


@test.step(after=[opening])
def window_size(studio):
    studio.resize(1000, 900)
    state = studio.wait_idle("the window's size", lambda s: s["widgets"]["mainWindow"][2:] == [1000, 900])
    need_fitted(state, "in a narrower window")
    studio.resize(1400, 900)
    studio.wait_idle("the window's size", lambda s: s["widgets"]["mainWindow"][2:] == [1400, 900])


@test.step(after=[standard_views, window_size])
def cube(studio):
    """A click on a zone looks from there, with any tool, and cuts nothing."""
    studio.key("d")
    for zone in ("0--", "+--", "+0-", "+00", "+0+", "00+", "0-+", "0-0"):
        state = studio.wait(f"the zone {zone} of the cube", lambda s: zone in s["cube"])
        studio.click(lambda: studio.state()["cube"][zone])
        state = studio.wait_idle(f"the zone {zone}", lambda s: looks_from(s, direction_of(zone)))
        need_fitted(state, f"from {zone}")
    x, y = state["cube"]["0-0"]
    studio.drag([(x, y), (x + 3, y + 20), (x + 5, y + 60)])
    state = studio.wait_idle("the drag on the cube")
    need(not looks_from(state, (0, -1, 0)) and state["steps"] == 0, "a drag on the cube does not turn, or it drills")
    studio.key("v")


@test.step(after=[cube])
def tumble(studio):
    """The surface goes with the hand, past the pole."""
    studio.key("Home")
    before = studio.wait_idle("the face", lambda s: looks_from(s, (0, -1, 0)))
    x, y = studio.view_point(0.5, 0.2)
    studio.drag([(x, y + step) for step in range(0, 401, 50)])
    state = studio.wait_idle("the drag", lambda s: s["camera"] != before["camera"])
    turned = 0.35 * 400
    back = axes(state["camera"])[2]
    expected = (0, -math.cos(math.radians(turned)), math.sin(math.radians(turned)))
    need(math.dist(back, expected) < 1e-6, f"400 pixels down look from {back}, not from {expected}")
    need(axes(state["camera"])[1][2] < 0, "past the pole the head is not below")


@test.step(after=[tumble])
def turntable(studio, folder):
    studio.key("Home")
    studio.wait_idle("the face", lambda s: looks_from(s, (0, -1, 0)))
    tick(studio, "cameraTurntable")
    x, y = studio.view_point(0.5, 0.2)
    studio.drag([(x + step / 4, y + step) for step in range(0, 401, 50)])
    state = studio.wait_idle("the turntable to stop at the pole", lambda s: s["camera"]["elevation"] == 90)
    need(state["camera"]["roll"] == 0 and abs(state["camera"]["azimuth"] + 35) < 1, f"turned to {state['camera']}")
    settings = folder / "home" / "config" / "volume-studio" / "volume-studio.ini"
    need("turntable=true" in settings.read_text(), "the turntable is not remembered")
    tick(studio, "cameraTurntable")
    need("turntable=false" in settings.read_text(), "the turntable is remembered for ever")


@test.step(after=[turntable])
def roll(studio):
    studio.key("Home")
    studio.wait_idle("the face", lambda s: looks_from(s, (0, -1, 0)))
    x, y, width, height = studio.state()["viewRect"]
    begin = (x + width - 8, y + height // 2)
    end = (x + width - 8, y + height // 2 - height // 4)
    studio.drag([begin, ((begin[0] + end[0]) // 2, (begin[1] + end[1]) // 2), end])
    state = studio.wait_idle("the roll", lambda s: s["camera"]["roll"] != 0)
    expected = -math.degrees(math.atan2(height // 4, width / 2 - 8))  # up on the right: anticlockwise
    need(abs(state["camera"]["roll"] - expected) < 1, f"rolled by {state['camera']['roll']}, not by {expected}")
    need(state["camera"]["azimuth"] == 0 == state["camera"]["elevation"], "rolling turns too")


@test.step(after=[roll])
def by_hand(studio):
    """Who has zoomed looks from elsewhere as near; fitting shows all again, orthographic too."""
    studio.key("Home")
    studio.wait_idle("the face", lambda s: looks_from(s, (0, -1, 0)))
    studio.move(studio.view_point(0.5, 0.5))
    studio.xdotool("click", "--repeat", 4, "--delay", 20, 4)
    zoomed = studio.wait_idle("the wheel")["camera"]["zoom"]
    studio.key("ctrl+3")
    state = studio.wait_idle("the left", lambda s: looks_from(s, (1, 0, 0)))
    need(abs(state["camera"]["zoom"] / zoomed - 1) < 0.5, f"zoom {zoomed} became {state['camera']['zoom']}")
    studio.key("shift+f")
    need_fitted(studio.wait_idle("the fit", lambda s: s["camera"]["zoom"] < zoomed / 1.5), "fitted")
    studio.key("shift+o")
    state = studio.wait_idle("no perspective", lambda s: s["camera"]["projection"] == "orthographic")
    need_fitted(state, "orthographic")
    studio.key("ctrl+1")
    need_fitted(studio.wait_idle("the face", lambda s: looks_from(s, (0, -1, 0))), "orthographic, the face")


@test.step(after=[by_hand])
def session(studio, folder):
    """Cuts a piece off, so that there is something to save, and the camera with it."""
    studio.key("x")
    studio.drag([studio.view_point(*place) for place in ((0.45, 0.3), (0.55, 0.3), (0.6, 0.5), (0.5, 0.55), (0.46, 0.4))])
    studio.wait_idle("the scissors", lambda s: s["stepsDone"] == 1)
    return save_and_end(studio, folder)


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    report = compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)
    need(report["complete"], "the replay is not complete")


@test.step
def plain_session(display, arguments, folder, session):
    """A camera that a session lacks frames the grid: nothing is fitted."""
    content = json.loads(session[0].read_text())
    content["operations"] = []
    content.pop("state", None)
    plain = folder / "plain.json"
    plain.write_text(json.dumps(content))
    studio = start(display, arguments.program, folder, [plain])
    camera = studio.wait_idle("the session", lambda s: s["pictureComplete"])["camera"]
    need(camera["zoom"] == 1 and camera["pan"] == [0, 0], f"a session without a camera opens with {camera}")
    studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
