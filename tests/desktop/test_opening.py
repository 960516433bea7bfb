# SPDX-License-Identifier: Apache-2.0
"""Scans open as they are looked at: by what DICOM says they are, and MR from above its air. Sessions are none of that business."""

import json
import random
import sys

from pydicom.dataset import FileDataset, FileMetaDataset
from pydicom.uid import ExplicitVRLittleEndian, generate_uid

from driver import need, start
from replay import compare_with_replay, operations, save_and_end
from steps import Steps

test = Steps()

SIDE = 48
SPACING = 4.0


def write_series(folder, modality, value, **more):
    """Slices whose pixels are value(distance from the middle in voxels, random numbers)."""
    chance = random.Random(7)
    folder.mkdir()
    series, study, frame = generate_uid(), generate_uid(), generate_uid()
    middle = (SIDE - 1) / 2
    for z in range(SIDE):
        pixels = bytearray()
        for y in range(SIDE):
            for x in range(SIDE):
                r = ((x - middle) ** 2 + (y - middle) ** 2 + (z - middle) ** 2) ** 0.5
                pixels += max(0, min(65535, round(value(r, chance)))).to_bytes(2, "little")
        meta = FileMetaDataset()
        meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.128" if modality == "PT" else "1.2.840.10008.5.1.4.1.1.4"
        meta.MediaStorageSOPInstanceUID = generate_uid()
        meta.TransferSyntaxUID = ExplicitVRLittleEndian
        path = folder / f"{z:03}.dcm"
        slice_ = FileDataset(str(path), {}, file_meta=meta, preamble=b"\0" * 128)
        slice_.is_little_endian, slice_.is_implicit_VR = True, False
        slice_.SOPClassUID, slice_.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
        slice_.SeriesInstanceUID, slice_.StudyInstanceUID, slice_.FrameOfReferenceUID = series, study, frame
        slice_.Modality, slice_.PatientName, slice_.PatientID = modality, "Nobody^Anonymous", "0"
        slice_.Rows, slice_.Columns, slice_.SamplesPerPixel = SIDE, SIDE, 1
        slice_.PhotometricInterpretation = "MONOCHROME2"
        slice_.BitsAllocated, slice_.BitsStored, slice_.HighBit, slice_.PixelRepresentation = 16, 16, 15, 0
        slice_.PixelSpacing, slice_.SliceThickness = [SPACING, SPACING], SPACING
        slice_.ImageOrientationPatient, slice_.ImagePositionPatient = [1, 0, 0, 0, 1, 0], [0, 0, SPACING * z]
        slice_.InstanceNumber = z + 1
        for name, said in more.items():
            setattr(slice_, name, said)
        slice_.PixelData = bytes(pixels)
        slice_.save_as(str(path), write_like_original=False)


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


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--vstudio"))
