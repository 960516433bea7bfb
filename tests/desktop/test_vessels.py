# SPDX-License-Identifier: Apache-2.0
"""A vessel is grown and measured by two clicks along it: its length, its curve, where it is narrow; undone, saved, replayed, listed."""

import csv
import math
import sys

from driver import need, start
from replay import compare_with_replay, operations, run, save_and_end
from steps import Steps

test = Steps()

SIZE = (90, 40, 40)
RADIUS = 7.0
NARROW = 0.5  # of the radius, in the middle


def write_tube(path):
    """A tube along x, half as wide in the middle; its wall has values between."""
    values = bytearray()
    for z in range(SIZE[2]):
        for y in range(SIZE[1]):
            for x in range(SIZE[0]):
                radius = RADIUS * (1 - NARROW * math.exp(-((x - 45) / 5) ** 2))
                away = math.hypot(y - 19.5, z - 19.5)
                inside = min(max(0.5 + radius - away, 0), 1) if 4 <= x <= 85 else 0
                values.append(round(200 * inside))
    header = (f"NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: {' '.join(map(str, SIZE))}\n"
              "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n\n")
    path.write_bytes(header.encode() + values)


@test.step
def studio(display, arguments, folder):
    write_tube(folder / "tube.nrrd")
    studio = start(display, arguments.program, folder, [folder / "tube.nrrd"])
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    return studio


@test.step
def grown(studio):
    studio.key("s")
    studio.wait("the seed tool", lambda s: s["tool"] == "seed")
    x, y = studio.view_point(0.3, 0.5)
    studio.drag([(x - 20, y), (x, y + 3), (x + 20, y)])
    studio.wait_idle("a first stop", lambda s: s["voxels"] > 1000 and not s["playing"])
    studio.click("growGoOn")
    studio.wait_idle("growth to end", lambda s: s["voxels"] > 5000 and not s["playing"])


@test.step(after=[grown])
def measured(studio):
    studio.key("m")
    studio.wait("the measure tool", lambda s: s["tool"] == "measure")
    need("vesselCurve" not in studio.state()["widgets"], "a curve is shown before anything was measured")
    studio.click("measureVessel")
    studio.click(studio.view_point(0.2, 0.5))
    studio.click(studio.view_point(0.8, 0.5))
    state = studio.wait_idle("the vessel", lambda s: len(s["measurements"]) == 1)
    need(20 < state["measurements"][0] < 80, f"{state['measurements']} mm long")
    need("vesselCurve" in state["widgets"], "the curve is not shown")
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: not s["measurements"])
    studio.key("ctrl+shift+z")
    after = studio.wait_idle("redo", lambda s: len(s["measurements"]) == 1)
    need(after["measurements"] == state["measurements"], "redo measured otherwise")


@test.step(after=[measured])
def replay(studio, arguments, folder):
    session, viewport = save_and_end(studio, folder)
    vessels = [op for op in operations(session) if op["op"] == "measure"]
    need(len(vessels) == 1 and vessels[0]["kind"] == "vessel" and len(vessels[0]["diameters"]) > 20, "the session lacks it")
    compare_with_replay(arguments.vstudio, session, folder / "window.png", viewport, folder)
    run(arguments.vstudio, "stats", session, "--measurements", folder / "m.csv", "--vessels", folder / "v.csv")
    with open(folder / "m.csv", encoding="utf-8") as file:
        row = next(csv.DictReader(file))
    need(abs(float(row["narrowest_mm"]) - 2 * RADIUS * NARROW) < 0.3, f"{row['narrowest_mm']} mm at the narrowest")
    need(abs(float(row["stenosis_percent"]) - 100 * NARROW) < 3, f"{row['stenosis_percent']} % narrower")
    with open(folder / "v.csv", encoding="utf-8") as file:
        points = list(csv.DictReader(file))
    for point in points:
        away = math.hypot(float(point["y_lps_mm"]) - 19.5, float(point["z_lps_mm"]) - 19.5)
        radius = RADIUS * (1 - NARROW * math.exp(-((float(point["x_lps_mm"]) - 45) / 5) ** 2))
        need(away < 0.25, f"the centreline is {away} mm off")
        need(abs(float(point["diameter_mm"]) - 2 * radius) < 0.4, f"{point['diameter_mm']} mm instead of {2 * radius}")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
