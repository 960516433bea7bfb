# SPDX-License-Identifier: Apache-2.0
"""What a volume is can be read at any time, and so can every notice of reading it; slices that no file holds are marked; where voxels lie
is corrected."""

import sys

from dicom_series import SIDE, SPACING, write_series
from driver import need, start
from replay import compare_with_replay, save_and_end
from steps import Steps

test = Steps()

MISSING = (10, 30, 31)


def are_close(camera, other):
    """From where it is looked at, but for what fitting rounds."""
    values = [[c["azimuth"], c["elevation"], c["roll"], 100 * c["zoom"], *c["pan"]] for c in (camera, other)]
    return all(abs(a - b) < 0.1 for a, b in zip(*values))


@test.step
def studio(display, arguments, folder):
    write_series(folder / "ct", "CT", lambda r, chance: 1060 if r < 18 else 0, missing=MISSING, RescaleIntercept=-1024, RescaleSlope=1,
                 SpecificCharacterSet="ISO_IR 100", PatientName="M\xfcller^J\xf6rg Maria", StudyDate="20240131",
                 StudyDescription="Sch\xe4del", SeriesNumber=3, SeriesDescription="Weichteil")
    studio = start(display, arguments.program, folder, [folder / "ct"])
    studio.resize(1300, 900)
    state = studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    need("3 slices are missing" in state["message"], f"the status bar says {state['message']}")
    need("noticesBadge" in state["widgets"], "no badge says that there is a notice")
    return studio


@test.step
def overwritten(studio):
    """The message goes with the first edit, the badge stays."""
    studio.key("x")
    studio.drag([studio.view_point(0.45, 0.45), studio.view_point(0.55, 0.5), studio.view_point(0.5, 0.55), studio.view_point(0.45, 0.45)])
    studio.key("Return")
    state = studio.wait_idle("the cut", lambda s: s["stepsDone"] == 1 and "missing" not in s["message"])
    need("noticesBadge" in state["widgets"], "the badge went with the message")


def properties(state):
    return {name[len("property."):]: text for name, text in state["reports"].items() if name.startswith("property.")}


@test.step(after=[overwritten])
def read(studio, folder):
    studio.click("noticesBadge")
    state = studio.wait("the properties", lambda s: "propertiesDialog" in s["windows"])
    said = properties(state)
    expected = {"file": str(folder / "ct"), "format": "DICOM", "patient": "M\xfcller, J\xf6rg Maria (0)",
                "study": "Sch\xe4del, 2024-01-31", "series": "3: Weichteil", "modality": "CT",
                "spacing": f"{SPACING:g} \xd7 {SPACING:g} \xd7 {SPACING:g} mm", "values": "-1024 to 36 HU",
                "scale": "1 \xd7 stored value \u2212 1024", "time": "volume 1 of 1", "channels": "1", "interpolated": "11, 31–32"}
    for name, text in expected.items():
        need(said.get(name) == text, f"{name} reads {said.get(name)}, not {text}")
    need(said["size"].startswith(f"{SIDE} \xd7 {SIDE} \xd7 {SIDE} voxels, int16"), f"size reads {said['size']}")
    need(said["orientation"].startswith("LPS"), f"orientation reads {said['orientation']}")
    studio.click("closeProperties")
    state = studio.wait("the badge to go", lambda s: "propertiesDialog" not in s["windows"])
    need("noticesBadge" not in state["widgets"], "what was read is still announced")
    studio.focus()
    studio.key("ctrl+i")
    studio.wait("the notice again", lambda s: "notice" in s["widgets"])
    studio.click("closeProperties")
    studio.wait("the dialog to go", lambda s: "propertiesDialog" not in s["windows"])
    studio.focus()


@test.step(after=[read])
def marked(studio):
    """The axial slices 10, 30 and 31, and no others."""
    studio.key("F4")
    studio.wait_idle("slices", lambda s: "axialSlice" in s["widgets"] and s["pictureComplete"])
    x, y, width, height = studio.place_of("axialSlice")
    studio.move((x + width // 2, y + height // 2))
    seen = {}
    while (index := studio.state()["crosshair"][2]) < 33:
        state = studio.wait_idle("the slice", lambda s: s["pictureComplete"])
        seen[index] = state["reports"].get("axialSlice") == "interpolated"
        studio.xdotool("click", 4)
        studio.wait_idle("the next slice", lambda s: s["crosshair"][2] == index + 1)
    need({index for index, is_marked in seen.items() if is_marked} == {30, 31}, f"marked: {seen}")


@test.step(after=[marked])
def corrected(studio):
    """Half a turn of the axial slice, and a spacing; Undo and Redo know it, and cuts stay in their voxels. All of it is in the picture
    before and after."""
    cut = studio.state()["stepsDone"]
    studio.focus()
    studio.key("Home")
    before = studio.wait_idle("all in the picture", lambda s: s["pictureComplete"])["camera"]
    studio.key("ctrl+i")
    studio.wait("the properties", lambda s: "applyGeometry" in s["widgets"])
    studio.click("axialFlipAcross")
    studio.wait("a mirror image", lambda s: "left and right are exchanged" in s["reports"]["correctionMeaning"])
    studio.click("axialFlipDown")
    studio.wait("half a turn", lambda s: "RAS" in s["reports"]["correctionMeaning"] and "mirror" not in s["reports"]["correctionMeaning"])
    studio.type_number("spacingSlices", 2.5, end="Tab")
    studio.wait("the spacing", lambda s: "2.5 mm, RAS" in s["reports"]["correctionMeaning"])
    studio.click("applyGeometry")
    state = studio.wait_idle("the correction", lambda s: s["stepsDone"] == cut + 1 and "inFile" in properties(s))
    said = properties(state)
    need(said["spacing"] == f"{SPACING:g} \xd7 {SPACING:g} \xd7 2.5 mm", f"the spacing reads {said['spacing']}")
    need(said["orientation"].startswith("RAS"), f"the orientation reads {said['orientation']}")
    need(said["inFile"] == f"{SPACING:g} \xd7 {SPACING:g} \xd7 {SPACING:g} mm, LPS", f"the file's geometry reads {said['inFile']}")
    studio.click("closeProperties")
    studio.wait("the dialog to go", lambda s: "propertiesDialog" not in s["windows"])
    studio.focus()
    studio.key("ctrl+z")
    studio.wait_idle("the correction undone, and all in the picture again", lambda s: s["stepsDone"] == cut and are_close(s["camera"], before))
    studio.key("ctrl+shift+z")
    studio.wait_idle("the correction redone", lambda s: s["stepsDone"] == cut + 1 and are_close(s["camera"], state["camera"]) and s["pictureComplete"])


@test.step(after=[corrected])
def session(studio, folder):
    return save_and_end(studio, folder)


@test.step
def replay(arguments, session, folder):
    path, viewport = session
    compare_with_replay(arguments.vstudio, path, folder / "window.png", viewport, folder)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
