# SPDX-License-Identifier: Apache-2.0
"""What the tests of vstudio's commands share: calling it, reading what it wrote, a small volume."""
import gzip
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

VSTUDIO = sys.argv.pop(1)
SOURCES = pathlib.Path(__file__).parents[3] / "src"


def call(*arguments, **environment):
    return subprocess.run([VSTUDIO, *map(os.fspath, map(as_argument, arguments))], capture_output=True, text=True,
                          errors="replace", timeout=300, env={**os.environ, **environment})


def as_argument(value):
    return value if isinstance(value, (bytes, os.PathLike)) else str(value)


def read_png(path):
    """Width, height and the raw RGBA rows of one of our own PNGs."""
    data = pathlib.Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed, size = 8, b"", None
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    return size[0], size[1], zlib.decompress(packed)


def nrrd_floats(path):
    """The values of one of our own NRRD files of 32-bit floats."""
    header, data = pathlib.Path(path).read_bytes().split(b"\n\n", 1)
    assert b"type: float" in header, header
    if b"encoding: gzip" in header:
        data = gzip.decompress(data)
    return list(struct.unpack(f"<{len(data) // 4}f", data))


def write_grey_png(path, width, height, value):
    rows = b"".join(b"\0" + bytes(value(x, y) for x in range(width)) for y in range(height))

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    pathlib.Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) +
                                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Case(unittest.TestCase):
    """A folder with a small volume in it."""

    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.raw = self.folder / "ramp.raw"
        # 24 x 20 x 16 voxels: a bright box in the middle of air.
        self.raw.write_bytes(bytes(200 if 6 <= x < 18 and 5 <= y < 15 and 4 <= z < 12 else x
                                   for z in range(16) for y in range(20) for x in range(24)))
        self.layout = ("--raw", "24x20x16:uint8:1,1,1.5")

    def tearDown(self):
        self.holder.cleanup()

    def expect_error(self, code, mentions, *arguments):
        result = call(*arguments)
        self.assertEqual(result.returncode, code, result)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        for text in mentions:
            self.assertIn(str(text), lines[0])

    def session_call(self, *operations, **volume):
        """Writes s.json and gives the arguments that replay it."""
        session = self.folder / "s.json"
        session.write_text(json.dumps({"volumeStudioSession": 1, "operations": operations,
                                       "volume": {"path": "ramp.raw", "raw": "24x20x16:uint8", **volume}}))
        return "run", session, "-o", self.folder / "out"
