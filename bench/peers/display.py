# SPDX-License-Identifier: Apache-2.0
"""An X display for programs that cannot render without: the one that is there, or an Xvfb of our own."""
import contextlib
import os
import shutil
import subprocess
import sys


@contextlib.contextmanager
def display():
    """Sets DISPLAY while it lasts. The server must outlive its clients (-noreset), as renderers come and go."""
    if os.environ.get("DISPLAY"):
        yield
        return
    if shutil.which("Xvfb") is None:
        sys.exit("there is no display, and Xvfb is missing; install Debian's xvfb")
    reading, writing = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-noreset",
                               "-nolisten", "tcp"], pass_fds=[writing], stderr=subprocess.DEVNULL)
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            number = pipe.readline().strip()
        if not number:
            sys.exit("Xvfb does not start")
        os.environ["DISPLAY"] = f":{number}"
        yield
    finally:
        os.environ.pop("DISPLAY", None)
        server.terminate()
        server.wait()
