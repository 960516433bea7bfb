# SPDX-License-Identifier: Apache-2.0
"""Starts volume-studio on an X server of its own and drives it with real events. Python's standard library only."""

import json
import os
import pathlib
import shutil
import subprocess
import time

SCREEN = "1920x1200x24"


class Failure(Exception):
    pass


def need(condition, message):
    if not condition:
        raise Failure(message)


class Display:
    """An Xvfb that chooses a free display number by itself."""

    def __init__(self):
        for tool in ("Xvfb", "xdotool"):
            need(shutil.which(tool), f"{tool} is not installed (Debian: xvfb xdotool)")
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", SCREEN, "-nolisten", "tcp"],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            number = answer.readline().strip()
        need(number, "Xvfb did not start")
        self.environment = dict(os.environ, DISPLAY=f":{number}", QT_QPA_PLATFORM="xcb")
        # Neither the person's desktop theme, its scale nor its language may change what is clicked on.
        for name in ("QT_QPA_PLATFORMTHEME", "QT_STYLE_OVERRIDE", "QT_SCALE_FACTOR", "XDG_CURRENT_DESKTOP"):
            self.environment.pop(name, None)
        self.environment.update(LC_ALL="C.UTF-8", LANGUAGE="")

    def close(self):
        self.server.terminate()
        self.server.wait()


def own_home(folder):
    """Folders for settings, cache and state, so that neither the person's own change a test nor a test them."""
    places = {"HOME": folder, "XDG_CONFIG_HOME": folder / "config", "XDG_CACHE_HOME": folder / "cache",
              "XDG_STATE_HOME": folder / "state", "XDG_DATA_HOME": folder / "data"}
    for place in places.values():
        place.mkdir(parents=True, exist_ok=True)
    return {name: str(place) for name, place in places.items()}


class Studio:
    """One running volume-studio."""

    def __init__(self, display, program, folder, arguments=(), scale=1, home=None):
        self.folder = pathlib.Path(folder)
        self.layout_file = self.folder / "layout.json"
        self.layout_file.unlink(missing_ok=True)
        self.environment = dict(display.environment, QT_SCALE_FACTOR=str(scale), **own_home(home or self.folder / "home"))
        self.log = open(self.folder / "volume-studio.log", "w+")
        self.process = subprocess.Popen(
            [program, "--layout-file", str(self.layout_file), *map(str, arguments)],
            env=self.environment, stdout=self.log, stderr=subprocess.STDOUT)
        self.wait("the window", lambda state: "mainWindow" in state["widgets"])
        self.focus()

    # --- looking

    def state(self):
        if self.process.poll() is not None:
            self.log.seek(0)
            raise Failure(f"volume-studio ended with {self.process.returncode}:\n{self.log.read()}")
        try:
            return json.loads(self.layout_file.read_text())
        except FileNotFoundError:
            return None

    def wait(self, what, condition, seconds=90):
        """Waits until the condition holds; the bound is generous because a software renderer may share its cores."""
        end = time.monotonic() + seconds
        state = None
        while time.monotonic() < end:
            state = self.state()
            if state is not None and condition(state):
                return state
            time.sleep(0.03)
        if state is not None:
            state.pop("widgets")
        raise Failure(f"waited {seconds} s for {what}; the program says {state}")

    def wait_idle(self, what="the program to be idle", condition=lambda state: True, seconds=90):
        return self.wait(what, lambda state: state["idle"] and condition(state), seconds)

    def view_point(self, fx, fy):
        """A place of the view, given in fractions of it, in pixels of the screen."""
        x, y, width, height = self.state()["viewRect"]
        return round(x + fx * width), round(y + fy * height)

    # --- acting

    def xdotool(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)

    def key(self, keys):
        self.xdotool("key", keys)

    def move(self, point):
        self.xdotool("mousemove", *point)

    def place_of(self, widget):
        """Its rectangle, once it has stayed where it is for a moment: panels follow the picture."""
        place = None
        while True:
            state = self.wait(f"the widget {widget}", lambda s: widget in s["widgets"])
            if state["widgets"][widget] == place:
                return place
            place = state["widgets"][widget]
            time.sleep(0.1)

    def click(self, widget):
        x, y, width, height = self.place_of(widget)
        self.xdotool("mousemove", x + width // 2, y + height // 2, "click", 1)

    def drag(self, points, button=1, pause=0.02):
        """Presses at the first point, moves through the others, releases at the last."""
        self.move(points[0])
        self.xdotool("mousedown", button)
        for point in points[1:]:
            self.move(point)
            time.sleep(pause)
        self.xdotool("mouseup", button)

    def type_number(self, box, number, end="Return"):
        """Replaces what stands in a number box; the minus sign is no option of xdotool's."""
        self.click(box)
        self.key("ctrl+a")
        self.xdotool("type", "--", str(number))
        self.key(end)

    def type_path(self, dialog, path):
        """Types a path into an open file dialog and accepts it."""
        self.wait(dialog, lambda state: dialog in state["widgets"] and "fileNameEdit" in state["widgets"])
        time.sleep(0.3)  # the dialog is laid out once more after it appears
        self.click("fileNameEdit")
        self.key("ctrl+a")
        self.xdotool("type", "--delay", 5, path)
        self.key("Return")
        self.wait(f"{dialog} to close", lambda state: dialog not in state["widgets"])
        self.focus()

    def window(self, title):
        for _ in range(50):  # the X server may show it a moment after the program says so
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], env=self.environment,
                                   check=False, capture_output=True, text=True).stdout.split()
            if found:
                return found[0]
            time.sleep(0.1)
        raise Failure(f"there is no window {title}")

    def main_window(self):
        return self.window("Volume Studio")

    def focus(self):
        """Gives the main window the keyboard: there is no window manager here to do it when a dialog closes."""
        self.xdotool("windowfocus", "--sync", self.main_window())

    def resize(self, width, height):
        self.xdotool("windowsize", self.main_window(), width, height)

    def quit(self):
        if self.state()["viewRect"]:  # there is none on the start screen
            self.move(self.view_point(0.5, 0.5))
        self.focus()
        self.key("ctrl+q")
        time.sleep(1)
        if self.process.poll() is None and "unsavedEdits" in self.state()["widgets"]:
            self.key("alt+d")  # "Discard"
        try:
            code = self.process.wait(30)
        except subprocess.TimeoutExpired:
            raise Failure("volume-studio did not end within 30 s of Ctrl+Q") from None
        self.log.seek(0)
        output = self.log.read()
        need(code == 0, f"volume-studio ended with {code}:\n{output}")
        need("OpenGL:" not in output, f"OpenGL errors:\n{output}")

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.log.close()


def run_test(main, arguments):
    """Runs main(display, arguments), prints what went wrong, returns the exit code."""
    folder = pathlib.Path(arguments.work)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    display = Display()
    try:
        main(display, arguments, folder)
    except (Failure, subprocess.CalledProcessError) as error:
        if shutil.which("import"):  # a picture of what it looked like helps most
            subprocess.run(["import", "-window", "root", str(folder / "failure.png")], env=display.environment,
                           check=False)
        print(f"FAILED: {error}")
        return 1
    finally:
        for studio in STARTED:
            studio.kill()
        display.close()
    print("passed")
    return 0


STARTED = []


def start(*arguments, **options):
    studio = Studio(*arguments, **options)
    STARTED.append(studio)
    return studio
