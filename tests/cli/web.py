#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Stores on a web server: read box by box, kept on the disk, and servers that fail in all the ways that servers do.

usage: web.py VSTUDIO
"""
import http.server
import json
import os
import re
import threading
import time
import unittest
import urllib.parse

from scan_case import ScanCase


class Server(http.server.ThreadingHTTPServer):
    """Serves a folder. `faults` has for names of files what is to go wrong with them."""
    daemon_threads = True

    def __init__(self, folder):
        self.folder, self.faults, self.asked, self.lock = folder, {}, [], threading.Lock()
        super().__init__(("127.0.0.1", 0), Handler)
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def address(self, name):
        return f"http://127.0.0.1:{self.server_port}/{name}"


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def do_GET(self):
        name = urllib.parse.unquote(self.path).lstrip("/")
        with self.server.lock:
            self.server.asked.append(name)
            fault = next((what for end, what in self.server.faults.items() if name.endswith(end)), None)
        file = self.server.folder / name
        if fault == "hang":
            time.sleep(30)
        if isinstance(fault, int) or (not file.is_file() and fault is None):
            self.answer(fault or 404, b"no such thing")
        elif isinstance(fault, str) and fault.startswith("to "):
            self.send_response(302)
            self.send_header("Location", fault[3:])
            self.send_header("Content-Length", "0")
            self.end_headers()
        elif fault == "cut":
            self.send_response(200)
            self.send_header("Content-Length", str(file.stat().st_size))
            self.end_headers()
            self.wfile.write(file.read_bytes()[:20])
            self.close_connection = True
        else:
            self.answer(200, file.read_bytes())

    def answer(self, code, content):
        self.send_response(code)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *_):
        pass


class Web(ScanCase):
    def setUp(self):
        super().setUp()
        os.environ["XDG_CACHE_HOME"] = str(self.folder / "cache")
        os.environ["VOLUME_STUDIO_WEB_SECONDS"] = "2"
        (self.folder / "served").mkdir()
        self.store = self.folder / "served" / "a scan.zarr"
        self.succeed("phantom", "vessels", "--size", "160x192x128", "-o", self.store)
        self.server = Server(self.folder / "served")
        self.address = self.server.address("a%20scan.zarr")

    def tearDown(self):
        self.server.shutdown()
        self.server.server_close()
        super().tearDown()

    def info(self, path, *options):
        """What is said of a volume, but where it lies."""
        return re.sub(r"(?m)^(file|modified).*\n", "", self.succeed("info", path, *options).stdout)

    def test_it_is_the_same_scan_and_is_fetched_once(self):
        for level in (0, 1, 2):
            self.assertEqual(self.info(self.address, "--level", level), self.info(self.store, "--level", level))
        asked = len(self.server.asked)
        self.assertGreater(asked, 10)
        self.assertEqual(len(set(self.server.asked)), len([n for n in self.server.asked if not n.endswith(".zattrs")]) + 1)
        self.info(self.address, "--level", 0)
        self.assertEqual(len(self.server.asked), asked + 1)  # whether it is the same still

    def test_pictures_fetch_what_is_seen(self):
        pictures = []
        for n, scan in enumerate((self.address, self.store)):
            pictures.append(self.folder / f"{n}.png")
            self.succeed("render", scan, "-o", pictures[-1], "--level", 2, "--size", "300x200", "--samples", 2, "--zoom", "4")
        self.assertRegex(self.call("compare", *pictures).stdout, "max [01] ")
        finest = [n for n in self.server.asked if "/0/" in n and not n.endswith(".zarray")]
        self.assertGreater(len(finest), 0)
        self.assertLess(len(finest), 3 * 3 * 2)

    def test_a_session_names_the_address(self):
        session, copy = self.folder / "s.json", self.folder / "t.json"
        session.write_text(json.dumps({"volumeStudioSession": 1, "volume": {"path": self.address, "level": 1}, "operations": []}))
        self.succeed("run", session, "-o", self.folder / "out", "--save", copy)
        saved = json.loads(copy.read_text())
        self.assertEqual((saved["volume"]["path"], saved["volume"]["level"]), (self.address, 1))
        self.succeed("run", copy, "-o", self.folder / "again")

    def test_a_store_that_has_become_another_is_fetched_anew(self):
        before = self.info(self.address)
        self.succeed("phantom", "body", "--size", "70", "-o", self.folder / "b.zarr")
        os.rename(self.store, self.folder / "old.zarr")
        os.rename(self.folder / "b.zarr", self.store)
        self.assertNotEqual(self.info(self.address), before)
        self.assertEqual(self.info(self.address), self.info(self.store))

    def test_chunks_that_the_server_has_not_are_of_the_fill_value(self):
        (self.store / "0" / "0" / "0" / "0").unlink()
        self.assertEqual(self.info(self.address), self.info(self.store))
        asked = len(self.server.asked)
        self.info(self.address)
        self.assertEqual(len(self.server.asked), asked + 1)

    def test_servers_that_fail(self):
        chunk = "/0/0/1/1"
        for fault, said in ((500, "the server answers with 500"), (403, "the server answers with 403"), ("cut", "ended in the middle"),
                            ("hang", "does not answer in time"), ("to file:///etc/passwd", "cannot be fetched")):
            with self.subTest(fault=fault):
                self.server.faults = {chunk: fault}
                line = self.refuse(f"a%20scan.zarr{chunk}: .*{said}.*; try again later", "info", self.address)
                self.assertNotIn(str(self.folder), line)
                # What it gives is there all the same, and the picture says what it lacks.
                done = self.succeed("render", self.address, "-o", self.folder / "p.png", "--level", 2, "--size", "200x150", "--mode", "mip")
                self.assertRegex(done.stderr, f"note: .*{said}.*; pictures are coarser there")
        self.server.faults = {}
        self.assertEqual(self.info(self.address), self.info(self.store))
        self.server.faults = {"a scan.zarr/.zattrs": 503}
        self.refuse("answers with 503", "info", self.address)

    def test_addresses_of_nothing(self):
        self.refuse("the server has no .zattrs there; give the address of a store", "info", self.server.address("nothing.zarr"))
        self.refuse("cannot be reached", "info", "http://127.0.0.1:9/a.zarr")
        (self.folder / "served" / "bad.zarr").mkdir()
        for content in ("{", '{"multiscales": 3}'):
            (self.folder / "served" / "bad.zarr" / ".zattrs").write_text(content)
            line = self.refuse(r"bad\.zarr/\.zattrs", "info", self.server.address("bad.zarr"))
        attributes = json.loads((self.store / ".zattrs").read_text())
        for name in ("../../out", "/etc"):
            attributes["multiscales"][0]["datasets"][0]["path"] = name
            (self.folder / "served" / "bad.zarr" / ".zattrs").write_text(json.dumps(attributes))
            self.refuse("leads out of it", "info", self.server.address("bad.zarr"))


if __name__ == "__main__":
    unittest.main(verbosity=1)
