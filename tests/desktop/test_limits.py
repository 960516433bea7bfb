# SPDX-License-Identifier: Apache-2.0
"""Tools that spare a segment, or take nothing else: seen while the pen moves, and in the sculpture to the voxel."""

import array
import gzip
import json
import math
import sys

from driver import need, start
from phantom import SIDE, write_ball_head
from replay import compare_with_replay, operations, run, save_and_end
from steps import Steps
from test_islands import BALLS, SPACING, write_balls
from test_segments import cell, click_cell, working
from test_tools import Done, choose, ellipse, line, undo
from viewer import seen

test = Steps()


def ball_voxels(n):
    (cx, cy, cz), radius = BALLS[n]
    return {(z * SIDE + y) * SIDE + x
            for z in range(cz - radius, cz + radius + 1) for y in range(cy - radius, cy + radius + 1)
            for x in range(cx - radius, cx + radius + 1)
            if (x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 <= radius ** 2}


def place_of_ball(studio, which):
    """In the picture, in parts of its width and height."""
    state = studio.state()
    middle = [SPACING * (SIDE - 1) / 2] * 3
    centre = [SPACING * voxel for voxel in BALLS[which][0]]
    return seen(state["camera"], centre, middle, SPACING * math.dist((0, 0, 0), [SIDE] * 3), state["viewRect"][2:])


def read_floats(path):
    """The values of a NRRD as `sculpture` writes it."""
    header, values = path.read_bytes().split(b"\n\n", 1)
    if b"encoding: gz" in header:
        values = gzip.decompress(values)
    need(b"type: float" in header, f"{path} does not hold floats")
    return array.array("f", values)


@test.step
def studio(display, arguments, folder):
    write_ball_head(folder / "head.nrrd")
    write_balls(folder / "balls.seg.nrrd")
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.resize(1230, 1000)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def balls(studio, folder):
    studio.move(studio.view_point(0.5, 0.9))
    studio.key("ctrl+l")
    studio.type_path("openLabelsDialog", folder / "balls.seg.nrrd")
    state = studio.wait_idle("the labels", lambda s: any(g["name"] == "Balls" for g in s["segments"]))
    row = [segment["name"] for segment in state["segments"]].index("Balls")
    click_cell(studio, row, "name")
    studio.wait_idle("work on it", lambda s: working(s)["name"] == "Balls" and s["pictureComplete"])
    return row


@test.step(after=[balls])
def menu(studio, balls):
    """What tools do with a segment is chosen in the menu of its row too."""
    for steps, treatment in ((2, "take only"), (3, "spare")):
        need(working(studio.state())["tools"] != treatment, f"{treatment} holds already")
        studio.click(lambda: cell(studio, balls, "name"), button=3)
        studio.place_of("segmentMenu")
        studio.xdotool("key", *(["Up"] * (1 if treatment == "take only" else 2)), "key", "Return")
        studio.wait_idle(treatment, lambda s: working(s)["tools"] == treatment)
    undo(studio)
    undo(studio)
    need(working(studio.state())["tools"] == "take", "undo leaves what tools do with it")


@test.step(after=[menu])
def spared(studio):
    """Scissors through all of the head leave the balls standing where the row says so."""
    choose(studio, "x", "scissors")
    studio.click("scissorsSpares")
    studio.wait_idle("that it is spared", lambda s: working(s)["tools"] == "spare")
    done = Done(studio)
    studio.drag(ellipse(studio, (0.5, 0.5), (0.2, 0.28)))
    done.wait("Scissors")


@test.step(after=[spared])
def only(studio):
    """The drill takes nothing but the balls."""
    choose(studio, "d", "drill")
    studio.click("drillTakesOnly")
    studio.wait_idle("that nothing else is taken", lambda s: working(s)["tools"] == "take only")
    studio.drag(ellipse(studio, (0.5, 0.5), (0.04, 0.05)))
    studio.wait("the drill's mask", lambda s: s["hint"].startswith("The mask follows"))
    done = Done(studio)
    x, y = place_of_ball(studio, 0)
    studio.drag(line(studio, (x - 0.02, y), (x + 0.02, y)))
    done.wait("Drill")


@test.step(after=[only])
def replay(studio, arguments, folder):
    session, viewport = save_and_end(studio, folder)
    tools = [op.get("tools") for op in operations(session) if op["op"] == "segment"]
    need("spare" in tools and "take only" in tools, f"the session treats segments as {tools}")
    content = json.loads(session.read_text())
    cuts = [n for n, op in enumerate(content["operations"]) if op["op"] in ("scissors", "drill")]
    for n, place in enumerate(cuts):
        content["operations"].insert(place + 1 + n, {"op": "sculpture", "file": f"cut{n}.nrrd"})
    extended = session.with_name("with_sculptures.json")
    extended.write_text(json.dumps(content))
    run(arguments.vstudio, "run", extended, "-o", folder)
    first, second = (read_floats(folder / f"cut{n}.nrrd") for n in (0, 1))
    both = ball_voxels(0) | ball_voxels(1)
    need(not any(first[at] >= 0.5 for at in both), "scissors cut what they were to spare")
    need(sum(value >= 0.5 for value in first) > 20000, "scissors cut nothing beside it")
    taken = [at for at, value in enumerate(second) if value >= 0.5 > first[at]]
    need(len(taken) > 50, f"the drill took {len(taken)} voxels of the balls")
    need(set(taken) <= both, "the drill took more than the balls")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
