# SPDX-License-Identifier: Apache-2.0
"""Scans open as they are looked at: by what DICOM says they are, and MR from above its air. Sessions are none of that business."""

import json
import sys

from dicom_series import write_series
from driver import need, start
from replay import compare_with_replay, operations, save_and_end
from steps import Steps

test = Steps()

def noisy(signal, noise, chance):
    """The magnitude of a signal with noise in both channels."""
    return ((signal + chance.gauss(0, noise)) ** 2 + chance.gauss(0, noise) ** 2) ** 0.5


def opened(display, arguments, folder, volume):
    window = folder / f"{volume.name}_window"
    window.mkdir()
    studio = start(display, arguments.program, window, [volume])
    return studio, studio.wait_idle("the volume", lambda s: s["pictureComplete"])


@test.step
def mr(display, arguments, folder):
    """A weak skin around a bright brain: it begins between the air's noise and the skin, not above it."""
    write_series(folder / "mr", "MR", lambda r, chance: noisy(200 if r < 14 else 60 if r < 19 else 0, 5, chance))
    studio, state = opened(display, arguments, folder, folder / "mr")
    need(state["mode"] == "surface" and 20 <= state["range"][0] <= 55, f"MR opens in {state['mode']} from {state['range'][0]}")
    studio.quit()


@test.step
def angiography(display, arguments, folder):
    write_series(folder / "mra", "MR", lambda r, chance: noisy(300 if r < 3 else 60 if r < 19 else 0, 5, chance), AngioFlag="Y")
    studio, state = opened(display, arguments, folder, folder / "mra")
    need(state["mode"] == "mip", f"an angiography opens in {state['mode']}")
    studio.quit()


@test.step
def ct(display, arguments, folder):
    """In Hounsfield units, and slices over soft tissue, unless the file says that its values have no unit."""
    for rescale, is_hounsfield in (("HU", True), ("US", False)):
        volume = folder / f"ct_{rescale}"
        write_series(volume, "CT", lambda r, chance: 1800 if r < 6 else 1060 if r < 18 else chance.uniform(0, 30),
                     RescaleType=rescale, RescaleIntercept=-1024, RescaleSlope=1)
        studio, state = opened(display, arguments, folder, volume)
        need(state["mode"] == "surface" and -600 < state["range"][0] < -300, f"CT opens from {state['range'][0]}")
        need((state["sliceWindow"] == [-150, 250]) == is_hounsfield, f"with {rescale} slices show {state['sliceWindow']}")
        studio.quit()


@test.step
def pet(display, arguments, folder):
    """What is hot saturates and leaves the body in sight."""
    write_series(folder / "pet", "PT", lambda r, chance: 30000 if r < 1.5 else noisy(900 if r < 18 else 0, 20, chance))
    studio, state = opened(display, arguments, folder, folder / "pet")
    need(state["mode"] == "mip", f"PET opens in {state['mode']}")
    need(state["range"][0] < 800 and 900 < state["range"][1] < 30000, f"PET opens over {state['range']}")
    return studio


@test.step
def session(pet, folder):
    """What is opened so is saved so."""
    studio = pet
    studio.key("s")
    studio.drag([studio.view_point(0.49, 0.5), studio.view_point(0.51, 0.5)])
    studio.wait_idle("seeds", lambda s: s["stepsDone"] > 0 and not s["playing"])
    return save_and_end(studio, folder)


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    first = operations(path)[0]
    need(first["op"] == "view" and first["mode"] == "mip", f"the session begins with {json.dumps(first)[:200]}")
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


@test.step
def moved(display, arguments, session, folder):
    """A session whose scan has moved asks where it is; the next time it is found there."""
    path, _ = session
    archive, elsewhere = folder / "archive", folder / "elsewhere"
    archive.mkdir()
    elsewhere.mkdir()
    (folder / "pet").rename(archive / "pet")
    lonely = elsewhere / "session.json"
    saved = json.loads(path.read_text())
    saved["volume"]["path"] = str(folder / "pet")
    lonely.write_text(json.dumps(saved))
    home = folder / "moved_home"
    window = folder / "moved"
    window.mkdir()
    studio = start(display, arguments.program, window, [lonely], home=home)
    studio.type_path("findVolumeDialog", next((archive / "pet").iterdir()))
    state = studio.wait_idle("the session with its scan", lambda s: s["pictureComplete"] and s["segments"][0]["voxels"] > 0)
    need(state["title"].startswith("pet"), f"the window is called {state['title']}")
    studio.quit()
    studio = start(display, arguments.program, window, [lonely], home=home)
    studio.wait_idle("the session found its scan", lambda s: s["pictureComplete"] and s["segments"][0]["voxels"] > 0)
    need("findVolumeDialog" not in studio.state()["windows"], "it asks for what it can find")
    studio.quit()


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
