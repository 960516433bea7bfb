#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the small inputs that fuzzing begins from: tests/fuzz/corpus/TARGET/NAME. Inputs that were findings (found-...) stay.

usage: make_corpus.py

To be run when a format or the schema has changed: DICOM's identifiers and gzip's times are others each time.
"""
import json
import pathlib
import random
import struct
import zlib

import seeds_of_schema
from cbor import encoded
from variants import FORMATS

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
MOST_BYTES = 3000  # of an input: small ones are mutated sooner
SIBLINGS = {"values.bin", "values.raw", "scan.img"}  # which the targets put beside a header


def scans(form, count):
    """Small scans of a format, each of another seed; of those in two files the header, whose values the target has beside it."""
    found, seed = [], 0
    while len(found) < count:
        seed += 1
        case = FORMATS[form](random.Random(seed))
        name = case.main or sorted(case.files)[0]
        is_alone = set(case.files) - {name} <= SIBLINGS or form == "dicom"
        if is_alone and len(case.files[name]) <= MOST_BYTES:
            found.append(case.files[name])
    return found


def segmentation(*fields):
    """The header of a label map as 3D Slicer writes it."""
    lines = ["NRRD0004", "type: uchar", "dimension: 3", "sizes: 2 2 2", "encoding: raw", *fields]
    return "\n".join(lines).encode() + b"\n\n" + bytes(8)


def labels():
    return [segmentation("Segment0_Name:=Liver", "Segment0_LabelValue:=1", "Segment0_Color:=0.5 0.25 1",
                         "Segment1_ID:=two", "Segment1_LabelValue:=-2", "Segment1_Name:=" + "ä" * 101),
            segmentation("Segment_:=", "Segment2_LabelValue:=9223372036854775807", "Segment2_Color:=2 -1 1e300"),
            segmentation().replace(b"\n", b"\r\n")]


def png(kind, depth, rows, *chunks):
    """A picture of 3 pixels a row."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    head = struct.pack(">IIBBBBB", 3, len(rows), depth, kind, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + b"".join(chunk(*c) for c in chunks) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def pictures():
    return [png(0, 8, [b"\0\x80\xff"] * 2), png(2, 8, [bytes(range(9))]), png(6, 16, [bytes(range(24))]),
            png(3, 2, [b"\x1b"], (b"PLTE", bytes(range(12))), (b"tRNS", b"\0\x80"))]


GRID = {"dims": [3, 4, 5], "worldFromVoxel": [1.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, -1.5, 2.25, 1e6, 1.0]}
OPTIONS = {"series": None, "frame": 2, "level": 1, "channel": None, "slices": [3, 4], "raw": {"dims": [4, 5, 6], "type": 3, "spacing": [1.0, 2.0, 3.0], "offset": 7}}


def answers():
    details = {"format": "DICOM", "patient": "Doe, Jane", "study": "", "series": "thin", "modality": "CT", "isAngiography": True,
               "slope": 0.5, "intercept": -1024.0, "frame": 0, "frames": 1, "slices": 5, "interpolated": [1, 4]}
    volume = {"grid": GRID, "type": 2, "range": [-5.0, 9.5], "usual": [0.0, 9.0], "nonFinite": 1, "name": "head", "unit": "HU",
              "details": details}
    choice = {"uid": "1.2", "description": "thin", "modality": "CT", "size": [3, 4], "pixelSpacing": [0.5, 0.5], "sliceSpacing": None,
              "images": 7}
    return [encoded(one) for one in (
        {"share": 0.5}, {"share": None}, {"refused": "a.nii: is empty", "usage": False, "choices": [choice]},
        {"volume": volume, "notices": ["one", "two"]}, {"picture": [5, 6]}, {"segmentation": 900, "sources": 2})]


def tiffs():
    """Small stacks in the plainest form (TIFF 6.0, section 2): little and big endian, strips, a description, two pages, BigTIFF."""
    def page(order, big, at, data, last, more=()):
        entry, count, offset = ("HHQQ", "Q", "Q") if big else ("HHII", "H", "I")
        fields = [(256, 4, 3), (257, 4, 2), (258, 3, 16), (259, 3, 1), (262, 3, 1), (273, 4, at), (277, 3, 1), (278, 4, 2), (279, 4, 12), *more]
        fields.sort()
        def value(kind, number):
            size = 8 if big else 4
            return int.from_bytes(number.to_bytes({3: 2, 4: 4}[kind], order).ljust(size, b"\0"), order)
        sign = "<" if order == "little" else ">"
        size = struct.calcsize(sign + entry) * len(fields) + struct.calcsize(sign + count + offset)
        directory = struct.pack(sign + count, len(fields)) + b"".join(struct.pack(sign + entry, tag, kind, 1, value(kind, number))
                                                                       for tag, kind, number in fields)
        following = 0 if last else at + len(data) + size + len(data)
        return data + directory + struct.pack(sign + offset, following)

    data = bytes(range(12))
    def file(order, pages=1, big=False):
        sign = "<" if order == "little" else ">"
        head = (b"II" if order == "little" else b"MM") + (struct.pack(sign + "HHHQ", 43, 8, 0, 16 + 12) if big else struct.pack(sign + "HI", 42, 8 + 12))
        out = head
        for number in range(pages):
            out += page(order, big, len(out), data, number + 1 == pages)
        return out
    return [file("little"), file("big"), file("little", 2), file("big", 3), file("little", 1, True)]


def stores():
    """Stores of one level and one chunk: attributes, array, chunk."""
    axes = [{"name": name, "type": "space", "unit": "micrometer"} for name in "zyx"]
    image = {"multiscales": [{"version": "0.4", "axes": axes, "datasets": [
        {"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [2, 0.5, 0.5]}, {"type": "translation", "translation": [1, 2, 3]}]}]}]}
    ours = {**image, "volumeStudio": {"worldFromVoxel": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 5.5], "unit": "HU"}}
    channels = {"multiscales": [{"axes": [{"name": "c", "type": "channel"}, *axes], "datasets": [
        {"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 1, 1]}]}]}], "omero": {"channels": [{"label": "DAPI"}]}}
    data = bytes(range(24))
    def array(shape=(2, 3, 4), codec=None, **more):
        return {"zarr_format": 2, "shape": list(shape), "chunks": list(shape), "dtype": "|u1", "compressor": codec, "fill_value": 0, "order": "C",
                "filters": None, "dimension_separator": "/", **more}
    blosc = bytes([2, 1, 2, 1]) + struct.pack("<III", 24, 24, 40) + data  # its own bytes, not compressed
    return [json.dumps(attributes).encode() + b"\0" + json.dumps(one).encode() + b"\0" + chunk for attributes, one, chunk in (
        (image, array(), data), (ours, array(codec={"id": "zlib", "level": 1}), zlib.compress(data)),
        (image, array(codec={"id": "zstd", "level": 1}), zstd(data)), (image, array(codec={"id": "blosc", "cname": "lz4", "clevel": 1, "shuffle": 1}), blosc),
        (channels, array((1, 2, 3, 4), fill_value="NaN", dimension_separator="."), data),
        (image, array((1, 3, 4), dtype=">u2", chunks=[1, 3, 4]), data))]


def requests():
    order = {"grid": GRID, "segments": [{"label": 7, "name": "Leber", "colour": [0.1, 0.2, 0.3]}], "source": "/c", "reading": OPTIONS}
    return [encoded(one) for one in ({"path": "/a.nii", "options": OPTIONS}, {"picture": "/b.png"}, {"segmentation": order})]


def streams():
    def framed(message):
        return struct.pack("<I", len(message)) + message
    return [bytes([2]) + b"".join(map(framed, answers()[:2])), bytes([255]) + framed(answers()[4]) + framed(b"") + b"\1"]


def zstd(data):
    """As the program compresses lists, in the simplest form (RFC 8878): a frame of one block, which is left as it is, or says how often
    its one byte comes."""
    if len(data) > 255:
        block, kind, size = data[:1], 1, b"\x60" + (len(data) - 256).to_bytes(2, "little")
    else:
        block, kind, size = data, 0, b"\x20" + bytes([len(data)])
    return b"\x28\xb5\x2f\xfd" + size + (1 | kind << 1 | len(data) << 3).to_bytes(3, "little") + block


class StateFile:
    """The input for a state: its table of contents in a line, then its blocks."""

    def __init__(self):
        self.blocks = b""

    def block(self, data=b""):
        self.blocks += data
        return [8 + len(self.blocks) - len(data), len(data)]

    def list(self, form="", *numbers):
        data = struct.pack("<" + form * len(numbers), *numbers)
        return [*self.block(zstd(data)), len(data)]

    def delta(self, *box, held=b""):
        return {"bricks": self.list("i", *box), "ends": self.list("Q", *([len(held)] if box else [])), "voxels": 5,
                "held": self.block(held)}

    def run(self, *voxels):
        rules = {"range": [1.0, 2.0], "fenced": False, "sculptureVersion": 0, "view": 0, "connectivity": 6, "difference": [0.0, 5.0]}
        return {"playhead": len(voxels), "extent": len(voxels), "finished": True, "voxels": self.list("Q", *voxels), "rules": rules,
                "live": False, "consistentFrom": 0, "frozen": 0, "seeds": self.list("i", 17, 1)}

    def bricks(self):
        data = b"some bytes"
        return {"list": self.list("I", 0, 1, 2, 4096, len(data)), "bytes": self.block(data)}

    def undo(self):
        return {"before": self.run(), "labels": [1, 1], "extentAfter": 2, "added": self.list("I", 17), "allowedAgain": self.list(),
                "bricks": self.bricks(), "changesForbidden": False, "forbidden": self.block()}

    def input(self, table):
        return json.dumps(table, separators=(",", ":")).encode() + b"\n" + self.blocks


def segment(label, name):
    return {"label": label, "name": name, "colour": [0.5, 0.5, 1.0], "opacity": 1.0, "visible": True, "locked": False, "tools": "take",
            "claimed": False}


def states():
    geometry = [1, 0, 0, 0, 1, 0, 0, 0, 2, -5.5, 3, 4]
    parts = {"places": [], "parts": [], "last": -1}

    def table(file, **more):
        return {"view": {"op": "view"}, "geometry": geometry, "precision": 16, "cut": file.delta(), "versions": [1, 2], "parts": parts,
                "segments": {"segments": [segment(1, "Segment 1")], "atWork": 1}, "measurements": [], "pastes": [], "done": [],
                "undone": [], **more}

    empty, cut, grown, labelled = StateFile(), StateFile(), StateFile(), StateFile()
    box = (0, 0, 0, 16, 16, 16)
    part = {"part": {"name": "Part 1", "visible": True, "all": False, "middle": [1, 2, 3]}, "from": 0, "upTo": -1}
    cut_edit = {"operation": {"op": "un-cut"}, "limited": False, "changesSegments": False, "growth": [],
                "cut": cut.delta(*box, held=b"held"), "geometryBefore": geometry, "partsBefore": parts}
    grow_edit = {"operation": {"op": "grow", "generations": 2, "sculptureView": "cut"}, "limited": False, "changesSegments": True,
                 "growth": [grown.undo()]}
    looks = [{"value": 3, "name": "Liver", "colour": [1.0, 0.5, 0.0]}]
    voxels = bytes([1]) * 16 ** 3  # as many as the scan of the target has
    label_edit = {"operation": {"op": "load labels", "path": "labels.nrrd"}, "limited": False, "changesSegments": True, "growth": [],
                  "labels": {"voxels": [*labelled.block(zstd(voxels)), len(voxels)], "values": [0, 3], "looks": looks}}
    return [empty.input(table(empty)),
            cut.input(table(cut, cut=cut.delta(*box, held=b"bytes"), trimmed=cut.delta(), pastes=[cut.delta()], done=[cut_edit],
                            parts={**parts, "parts": [part]})),
            grown.input(table(grown, growth={"label": 1, "run": grown.run(1, 5), "forbidden": grown.block(), "others": [],
                                             "bricks": grown.bricks()}, done=[grow_edit])),
            labelled.input(table(labelled, undone=[label_edit]))]


def journals():
    first = {"volumeStudioJournal": 1, "volume": {"path": "/scans/head.nrrd", "checksum": "0123456789abcdef"}, "precision": 16}
    operations = [json.loads(session)["operations"] for session in sessions()[:2]]
    lines = [[first, *({"n": n, "operation": one} for n, one in enumerate(some[:4])), {"saved": "/a.json"},
              {"n": 1, "operation": {"op": "undo"}}] for some in operations]
    return ["".join(json.dumps(line) + "\n" for line in some).encode() for some in lines]


def sessions():
    return [json.dumps(one).encode() for one in seeds_of_schema.sessions(ROOT / "doc" / "session.schema.json")]


def functions():
    presets = ROOT / "data" / "transfer_functions"
    return [(presets / f"{name}.json").read_bytes() for name in ("ct_bone", "ct_bone_2d", "edges")]


def layouts():
    return [b"256x256x108:int16:0.957,0.957,1.5", b"3x2x1:float32::7", b"1x1x1:uint8:2"]


MADE = {"answer": answers, "request": requests, "stream": streams, "labels": labels, "picture": pictures, "session": sessions,
        "function": functions, "journal": journals, "state": states, "layout": layouts, "tiff": tiffs, "store": stores,
        **{form: lambda form=form: scans(form, 5) for form in FORMATS},
        "volume": lambda: [scan for form in FORMATS for scan in scans(form, 2)]}


def main():
    for target, make in MADE.items():
        folder = HERE / "corpus" / target
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("made-*"):
            old.unlink()
        for number, content in enumerate(make(), 1):
            (folder / f"made-{number}").write_bytes(content)


if __name__ == "__main__":
    main()
