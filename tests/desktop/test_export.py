# SPDX-License-Identifier: Apache-2.0
"""Surfaces, a DICOM segmentation, a table and the sculpted volume by File > Export, as vstudio export writes them of the
saved session; an export that is given up leaves nothing."""

import sys

from driver import need, start
from phantom import write_ball_head
from replay import run
from steps import Steps
from test_segments import grow

test = Steps()


def open_dialog(studio):
    studio.focus()
    studio.key("ctrl+shift+e")
    studio.wait("the dialog", lambda s: "exportDialog" in s["widgets"])


def save_as(studio, path):
    studio.click("exportSave")
    studio.type_path("exportFileDialog", path)


def exported(studio, path):
    save_as(studio, path)
    studio.wait_idle(f"{path.name}", lambda s: s["message"].startswith(f"Exported {path}")
                     and "exportDialog" not in s["widgets"])
    need(path.exists(), f"{path} is not there")


@test.step
def studio(display, arguments, folder):
    """With a segment."""
    volume = folder / "head.nrrd"
    write_ball_head(volume)
    studio = start(display, arguments.program, folder, [volume])
    studio.resize(1100, 760)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    grow(studio)
    return studio


@test.step
def check_list(studio):
    """Without a segment there is no surface, and nothing to estimate."""
    open_dialog(studio)
    studio.wait("the estimate", lambda s: "exportEstimate" in s["widgets"])
    studio.click("exportSegment")
    studio.wait("the estimate to go", lambda s: "exportEstimate" not in s["widgets"])
    studio.click("exportSegment")
    studio.wait("the estimate to come back", lambda s: "exportEstimate" in s["widgets"])


@test.step(after=[check_list])
def surface(studio, folder):
    exported(studio, folder / "seen.stl")


@test.step
def other_formats(studio, folder):
    for name, kind in (("seen.glb", "glTF"), ("seen.dcm", "DICOM"), ("seen.nrrd", "NRRD")):
        open_dialog(studio)
        studio.choose("exportFormat", kind)
        exported(studio, folder / name)


@test.step
def table(studio, folder):
    open_dialog(studio)
    studio.click("exportTable")
    exported(studio, folder / "seen.csv")


@test.step
def volume(studio, folder):
    open_dialog(studio)
    studio.click("exportVolume")
    studio.type_number("exportLeast", 100, "Tab")
    exported(studio, folder / "head.stl")


@test.step
def give_up(studio, folder):
    """Given up before anything is written."""
    open_dialog(studio)
    save_as(studio, folder / "never.obj")
    studio.wait("the export to begin", lambda s: "exportProgress" in s["widgets"] or "exportDialog" not in s["widgets"])
    studio.key("Escape")  # Cancel's key: by the time that a hand is at the button, it may be done
    studio.wait_idle("the end", lambda s: "exportProgress" not in s["widgets"])
    if "exportDialog" in studio.state()["widgets"]:
        studio.key("Escape")
        studio.wait("the dialog to close", lambda s: "exportDialog" not in s["widgets"])
    studio.focus()


@test.step
def session(studio, folder):
    studio.key("ctrl+s")
    studio.type_path("saveDialog", folder / "session.json")
    state = studio.wait_idle("the session", lambda s: "session.json" in s["message"])
    need(state["glErrors"] == 0, f"{state['glErrors']} OpenGL errors")
    studio.quit()
    return folder / "session.json"


@test.step
def same_files(arguments, session, folder):
    """What vstudio export writes of the saved session."""
    different = []
    for name, options in (("seen.stl", []), ("seen.glb", []), ("seen.nrrd", []), ("seen.csv", []),
                          ("head.stl", ["--what", "volume", "--range", "100:180"])):
        again = folder / f"again_{name}"
        print(run(arguments.vstudio, "export", session, "-o", again, *options).strip())
        different += [] if again.read_bytes() == (folder / name).read_bytes() else [name]
    need(not different, f"{', '.join(different)}: they differ from what vstudio export writes")


@test.step
def same_segmentation(arguments, session, folder):
    """But for its identifiers, which are its own."""
    run(arguments.vstudio, "export", session, "-o", folder / "again.dcm")
    size = abs((folder / "again.dcm").stat().st_size - (folder / "seen.dcm").stat().st_size)
    need(size < 200, "the DICOM segmentations differ")


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
