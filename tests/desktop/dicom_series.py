# SPDX-License-Identifier: Apache-2.0
"""Series of DICOM slices made for a test."""

import random

from pydicom.dataset import FileDataset, FileMetaDataset
from pydicom.uid import ExplicitVRLittleEndian, generate_uid

SIDE = 48
SPACING = 4.0


def write_series(folder, modality, value, missing=(), **more):
    """Slices whose pixels are value(distance from the middle in voxels, random numbers), but for those that are missing. `more` are
    attributes by their names."""
    chance = random.Random(7)
    folder.mkdir()
    series, study, frame = generate_uid(), generate_uid(), generate_uid()
    middle = (SIDE - 1) / 2
    for z in sorted(set(range(SIDE)) - set(missing)):
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
        slice_.Modality, slice_.PatientID = modality, "0"
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
