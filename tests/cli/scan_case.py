# SPDX-License-Identifier: Apache-2.0
"""What tests of other people's volumes share: the libraries that write them, noise to write, and vstudio in a folder of its own."""
import importlib
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest


def libraries(*names):
    """These libraries. Without them the test program is skipped, and says so; CI must have them."""
    try:
        return [importlib.import_module(name) for name in names]
    except ImportError as error:
        word = "failed" if "CI" in os.environ else "skipped"
        print(f"{word}: 1 test program, since {error.name} is not there; tools/setup.sh installs it")
        sys.exit(1 if "CI" in os.environ else 77)


numpy, = libraries("numpy")


def noise(shape, kind, seed=1):
    random = numpy.random.default_rng(seed)
    if numpy.dtype(kind).kind == "f":
        return random.normal(0, 100, shape).astype(kind)
    info = numpy.iinfo(kind)
    return random.integers(max(info.min, -30000), min(info.max, 30000), shape).astype(kind)


class ScanCase(unittest.TestCase):
    vstudio = sys.argv.pop(1)

    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.scratch.name)

    def tearDown(self):
        self.scratch.cleanup()

    def call(self, *arguments):
        return subprocess.run([self.vstudio, *map(str, arguments)], capture_output=True, text=True, errors="replace", timeout=300)

    def succeed(self, *arguments):
        done = self.call(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def refuse(self, expected, *arguments, status=1):
        """One line, which names the file, says what is wrong and what would be right."""
        done = self.call(*arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        lines = [line for line in done.stderr.split("\n") if line and not line.startswith("note:")]
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertRegex(lines[0], expected)
        return lines[0]
