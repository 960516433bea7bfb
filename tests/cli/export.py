#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Exports segments and sculpted volumes with vstudio export, rightly and wrongly.

usage: export.py VSTUDIO [DATA_FOLDER]     (a DICOM series is left out where DATA_FOLDER is not there)
"""
import gzip
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import pydicom  # Debian package python3-pydicom

DATA = pathlib.Path(sys.argv.pop(2)) if len(sys.argv) > 2 else pathlib.Path("none")
VSTUDIO = sys.argv.pop(1)
DIMS = (40, 36, 32)
SPACING = (1, 1, 1.5)
ORIGIN = (-20, 100, 5)


def call(*arguments):
    return subprocess.run([VSTUDIO, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def in_ball(voxel, centre, radius):
    return math.dist([v * s for v, s in zip(voxel, SPACING)], [c * s for c, s in zip(centre, SPACING)]) <= radius


def label_at(voxel):
    """Two balls that touch."""
    return 1 if in_ball(voxel, (12, 18, 16), 9) else 2 if in_ball(voxel, (28, 18, 16), 8) else 0


def write_nrrd(path, value, kind="uint8", code="B"):
    values = [value((x, y, z)) for z in range(DIMS[2]) for y in range(DIMS[1]) for x in range(DIMS[0])]
    header = (f"NRRD0004\ntype: {kind}\ndimension: 3\nspace: left-posterior-superior\nsizes: {DIMS[0]} {DIMS[1]} {DIMS[2]}\n"
              f"space directions: ({SPACING[0]},0,0) (0,{SPACING[1]},0) (0,0,{SPACING[2]})\nkinds: domain domain domain\n"
              f"endian: little\nencoding: raw\nspace origin: ({ORIGIN[0]},{ORIGIN[1]},{ORIGIN[2]})\n\n")
    path.write_bytes(header.encode() + struct.pack(f"<{len(values)}{code}", *values))
    return path


def read_nrrd(path):
    head, _, data = path.read_bytes().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
    data = gzip.decompress(data) if "gz" in fields["encoding"] else data
    code = {"unsigned char": "B", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "float": "f"}[fields["type"]]
    return fields["type"], struct.unpack(f"<{len(data) // struct.calcsize(code)}{code}", data)


def read_stl(path):
    data = path.read_bytes()
    count = struct.unpack("<I", data[80:84])[0]
    assert len(data) == 84 + 50 * count
    triangles = [struct.unpack("<12x9f2x", data[84 + 50 * n:134 + 50 * n]) for n in range(count)]
    return data[:80], [(t[:3], t[3:6], t[6:]) for t in triangles]


def volume_of(triangles):
    """Within the surface, which must be closed: each edge once each way."""
    edges = {}
    volume = 0
    for a, b, c in triangles:
        for p, q in ((a, b), (b, c), (c, a)):
            edges[p, q] = edges.get((p, q), 0) + 1
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    assert all(edges.get((q, p), 0) == n for (p, q), n in edges.items()), "open"
    return volume


class Export(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.labels = write_nrrd(self.folder / "labels.nrrd", label_at)

    def tearDown(self):
        self.holder.cleanup()

    def export(self, *arguments):
        result = call("export", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return result.stdout

    def refused(self, code, mentions, *arguments):
        result = call("export", *arguments)
        self.assertEqual(result.returncode, code, result)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        for text in mentions:
            self.assertIn(str(text), result.stderr)

    def test_surfaces_enclose_what_labels_cover(self):
        self.export(self.labels, "-o", self.folder / "a.stl", "--segment", 1, "--smooth", 0)
        header, triangles = read_stl(self.folder / "a.stl")
        self.assertIn(b"SPACE=LPS", header)
        # A Gaussian of 1 mm moves the level of a ball of 9 mm inward by 1/9 mm.
        self.assertAlmostEqual(volume_of(triangles) / (4 / 3 * math.pi * 8.89 ** 3), 1, delta=0.04)
        points = [p for t in triangles for p in t]
        for axis, centre in enumerate((12 - 20, 18 + 100, 16 * 1.5 + 5)):  # in the world
            middle = (min(p[axis] for p in points) + max(p[axis] for p in points)) / 2
            self.assertAlmostEqual(middle, centre, delta=0.3)

    def test_smoothing_and_fewer_triangles_keep_the_volume(self):
        self.export(self.labels, "-o", self.folder / "all.stl", "--smooth", 0)
        _, all_of_them = read_stl(self.folder / "all.stl")
        self.export(self.labels, "-o", self.folder / "few.stl", "--smooth", 10, "--keep", 0.2)
        _, few = read_stl(self.folder / "few.stl")
        self.assertAlmostEqual(len(few) / len(all_of_them), 0.2, delta=0.01)
        self.assertAlmostEqual(volume_of(few) / volume_of(all_of_them), 1, delta=0.01)
        self.export(self.labels, "-o", self.folder / "count.stl", "--triangles", 500)
        self.assertLessEqual(len(read_stl(self.folder / "count.stl")[1]), 1000)  # two surfaces

    def test_every_format_has_an_object_for_each_segment(self):
        for name in ("a.ply", "a.obj", "a.glb"):
            self.assertIn("2 surfaces", self.export(self.labels, "-o", self.folder / name))
        text = (self.folder / "a.obj").read_text()
        self.assertEqual(text.count("\no "), 2)
        self.assertTrue((self.folder / "a.mtl").exists())
        glb = (self.folder / "a.glb").read_bytes()
        content = json.loads(glb[20:20 + struct.unpack("<I", glb[12:16])[0]])
        self.assertEqual([node["name"] for node in content["nodes"]], ["Label 1", "Label 2"])

    def test_a_file_for_each(self):
        lines = self.export(self.labels, "-o", self.folder / "x.stl", "--each").splitlines()
        self.assertEqual(len(lines), 2)
        self.assertTrue((self.folder / "x-Label 1.stl").exists() and (self.folder / "x-Label 2.stl").exists())
        self.assertFalse((self.folder / "x.stl").exists())

    def test_chosen_labels_stay_in_the_label_map(self):
        self.export(self.labels, "-o", self.folder / "two.nrrd", "--segment", "Label 2")
        _, values = read_nrrd(self.folder / "two.nrrd")
        self.assertEqual(set(values), {0, 2})

    def test_the_surface_of_a_volume_at_a_level(self):
        ball = lambda v: int(1000 - 40 * math.dist((v[0], v[1], v[2] * 1.5), (20, 18, 24)))
        volume = write_nrrd(self.folder / "v.nrrd", ball, "int16", "h")
        self.export(volume, "--what", "volume", "--level", 620, "-o", self.folder / "v.stl")
        _, triangles = read_stl(self.folder / "v.stl")
        self.assertAlmostEqual(volume_of(triangles) / (4 / 3 * math.pi * 9.5 ** 3), 1, delta=0.02)

    def session(self, volume, *operations):
        path = self.folder / "session.json"
        path.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": str(volume)},
                                    "operations": list(operations)}))
        return path

    def test_a_sculpted_volume_keeps_its_type(self):
        volume = write_nrrd(self.folder / "v.nrrd", lambda v: 100 + v[0], "int16", "h")
        session = self.session(volume, {"op": "clip", "box": [[-1, -1, -1], [19.5, 40, 40]]})
        text = self.export(session, "--what", "volume", "-o", self.folder / "left.nrrd", "--fill", -5)
        self.assertIn("int16 values, cut ones -5", text)
        kind, values = read_nrrd(self.folder / "left.nrrd")
        self.assertIn(kind, ("short", "int16"))
        row = values[18 * 40 + 16 * 40 * 36:][:40]
        self.assertEqual(row[:18], tuple(range(100, 118)))
        self.assertEqual(set(row[24:]), {-5})
        self.export(session, "--what", "volume", "-o", self.folder / "left.stl", "--level", 0)
        volume_mm3 = volume_of(read_stl(self.folder / "left.stl")[1])
        self.assertAlmostEqual(volume_mm3 / (20 * 36 * 32 * 1.5), 1, delta=0.01)

    def test_a_session_has_the_same_surfaces_as_its_label_map(self):
        volume = write_nrrd(self.folder / "v.nrrd", lambda v: 100 * label_at(v))
        session = self.session(volume, {"op": "load labels", "path": str(self.labels)})
        self.export(session, "-o", self.folder / "s.stl")
        self.export(self.labels, "-o", self.folder / "l.stl")
        self.assertEqual((self.folder / "s.stl").read_bytes(), (self.folder / "l.stl").read_bytes())
        self.export(session, "-o", self.folder / "s.csv")
        self.assertEqual(len((self.folder / "s.csv").read_text().splitlines()), 3)

    def test_dicom_segmentations(self):
        self.export(self.labels, "-o", self.folder / "s.dcm")
        self.check_segmentation(pydicom.dcmread(self.folder / "s.dcm"), SPACING, ORIGIN)

    def series(self):
        """A CT series on the labels' grid."""
        folder = self.folder / "series"
        folder.mkdir()
        study, series, frame = (pydicom.uid.generate_uid() for _ in range(3))
        for z in range(DIMS[2]):
            data = pydicom.Dataset()
            data.SOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
            data.SOPInstanceUID = f"1.2.3.{z + 1}"
            data.StudyInstanceUID, data.SeriesInstanceUID, data.FrameOfReferenceUID = study, series, frame
            data.SpecificCharacterSet, data.Modality = "ISO_IR 100", "CT"
            data.PatientName, data.PatientID, data.StudyDate = "Doe^J\xfcrgen", "42", "20200102"
            data.ImagePositionPatient = [ORIGIN[0], ORIGIN[1], ORIGIN[2] + z * SPACING[2]]
            data.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
            data.PixelSpacing, data.SliceThickness = [SPACING[1], SPACING[0]], SPACING[2]
            data.Columns, data.Rows = DIMS[:2]
            data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
            data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = 16, 16, 15, 1
            data.RescaleSlope, data.RescaleIntercept = 1, 0
            data.PixelData = struct.pack("<h", z) * (DIMS[0] * DIMS[1])
            data.file_meta = pydicom.dataset.FileMetaDataset()
            data.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
            data.is_little_endian, data.is_implicit_VR = True, False
            data.save_as(folder / f"{z:03}.dcm", write_like_original=False)
        return folder

    def test_dicom_segmentations_belong_to_their_series(self):
        folder = self.series()
        self.export(self.labels, "--volume", folder, "-o", self.folder / "s.dcm")
        data = pydicom.dcmread(self.folder / "s.dcm")
        slices = {str(s.SOPInstanceUID): s for s in map(pydicom.dcmread, folder.iterdir())}
        one = next(iter(slices.values()))
        self.check_segmentation(data, SPACING, ORIGIN)
        for tag in ("PatientName", "PatientID", "StudyInstanceUID", "StudyDate", "FrameOfReferenceUID"):
            self.assertEqual(data[tag].value, one[tag].value)
        self.assertNotEqual(data.SeriesInstanceUID, one.SeriesInstanceUID)
        self.assertEqual(data.ReferencedSeriesSequence[0].SeriesInstanceUID, one.SeriesInstanceUID)
        for frame in data.PerFrameFunctionalGroupsSequence:
            uid = frame.DerivationImageSequence[0].SourceImageSequence[0].ReferencedSOPInstanceUID
            self.assertEqual(slices[uid].ImagePositionPatient, frame.PlanePositionSequence[0].ImagePositionPatient)

    def check_segmentation(self, data, spacing, origin):
        """Every voxel of the file is that of the labels, in its place."""
        self.assertEqual(data.SOPClassUID, "1.2.840.10008.5.1.4.1.1.66.4")
        shared = data.SharedFunctionalGroupsSequence[0]
        measures = shared.PixelMeasuresSequence[0]
        self.assertEqual([float(v) for v in measures.PixelSpacing], [spacing[1], spacing[0]])
        self.assertEqual(float(measures.SpacingBetweenSlices), spacing[2])
        self.assertEqual([float(v) for v in shared.PlaneOrientationSequence[0].ImageOrientationPatient], [1, 0, 0, 0, 1, 0])
        self.assertEqual([s.SegmentLabel for s in data.SegmentSequence], ["Label 1", "Label 2"])
        voxels = {}
        pixels = data.PixelData
        size = data.Rows * data.Columns
        for n, frame in enumerate(data.PerFrameFunctionalGroupsSequence):
            segment = frame.SegmentIdentificationSequence[0].ReferencedSegmentNumber
            place = [float(v) for v in frame.PlanePositionSequence[0].ImagePositionPatient]
            self.assertEqual(place[:2], list(origin[:2]))
            z = round((place[2] - origin[2]) / spacing[2])
            for i in range(size):
                bit = n * size + i
                if pixels[bit // 8] >> bit % 8 & 1:
                    voxels[i % data.Columns, i // data.Columns, z] = segment
        expected = {(x, y, z): label_at((x, y, z)) for z in range(DIMS[2]) for y in range(DIMS[1]) for x in range(DIMS[0])}
        self.assertEqual(voxels, {v: label for v, label in expected.items() if label})

    def test_what_is_wrong_is_said_in_a_line(self):
        self.refused(2, ["x.foo", ".stl"], self.labels, "-o", self.folder / "x.foo")
        self.refused(2, [".dcm"], self.labels, "--what", "volume", "-o", self.folder / "x.dcm")
        self.refused(2, ["nobody", "Label 1, Label 2"], self.labels, "--segment", "nobody", "-o", self.folder / "x.stl")
        self.refused(2, ["--volume"], self.labels, "-o", self.folder / "x.csv")
        self.refused(1, ["no label"], write_nrrd(self.folder / "e.nrrd", lambda v: 0), "-o", self.folder / "x.stl")
        self.refused(1, ["x.stl"], self.labels, "-o", self.folder / "none" / "x.stl")
        volume = write_nrrd(self.folder / "v.nrrd", lambda v: v[0])
        self.refused(1, ["no surface"], volume, "--what", "volume", "--level", 100, "-o", self.folder / "x.stl")
        self.refused(1, ["no segment"], self.session(volume), "-o", self.folder / "x.stl")
        self.assertEqual([p.name for p in self.folder.glob("x*")], [])


if __name__ == "__main__":
    unittest.main()
