# SPDX-License-Identifier: Apache-2.0
"""Starts volume-studio on an X server of its own and drives it with real events. Python's standard library only."""

import json
import os
import pathlib
import shutil
import subprocess
import time

from fence import Fence

SCREEN = "1920x1200x24"
ANSWER_SECONDS = 120  # as long as a machine that does other things too needs for the longest answer
LOOK_SECONDS = 0.01  # between two looks at the layout file


class Failure(Exception):
    pass


class Silence(Failure):
    """A program has ended, or has not answered its input: nothing that is done to it can be judged any more."""

    def __init__(self, studio, message):
        super().__init__(message)
        self.studio = studio


def need(condition, message):
    if not condition:
        raise Failure(message)


def looks(seconds):
    """One look after another at what is waited for, until the time is over. Nothing else here or in the tests sleeps, except for
    the pauses between the places of a pen that is moved at a person's pace."""
    waited = 0.0  # on a machine that has nothing else to do: one that is shared by three is given three times as long
    before = time.monotonic()
    while waited < seconds:
        yield
        time.sleep(LOOK_SECONDS)
        now = time.monotonic()
        waited += (now - before) / max(1.0, os.getloadavg()[0] / os.cpu_count())
        before = now


class Display:
    """An Xvfb that chooses a free display number by itself."""

    def __init__(self):
        for tool in ("Xvfb", "xdotool"):
            need(shutil.which(tool), f"{tool} is not installed (Debian: xvfb xdotool)")
        read_end, write_end = os.pipe()
        # -r: a key that a busy machine lets go late does not repeat.
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", SCREEN, "-nolisten", "tcp", "-r"],
            pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            self.number = answer.readline().strip()
        need(self.number, "Xvfb did not start")
        self.environment = dict(os.environ, DISPLAY=f":{self.number}", QT_QPA_PLATFORM="xcb")
        # Neither the person's desktop theme, its scale, its language nor its way to type may change what is clicked on and typed.
        for name in ("QT_QPA_PLATFORMTHEME", "QT_STYLE_OVERRIDE", "QT_SCALE_FACTOR", "XDG_CURRENT_DESKTOP", "QT_IM_MODULE"):
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


def said_by(state):
    """What the program says, without where everything is."""
    if state is None:
        return "the program says nothing yet"
    return f"the program says { {name: said for name, said in state.items() if name not in ('widgets', 'windows', 'disabled')} }"


def prefer(folder, **preferences):
    """What a person has chosen in a program that was started in that folder before."""
    settings = folder / "home" / "config" / "volume-studio" / "volume-studio.ini"
    settings.parent.mkdir(parents=True, exist_ok=True)
    settings.write_text("[General]\n" + "".join(f"{name}={value}\n" for name, value in preferences.items()))


class Studio:
    """One running volume-studio.

    Whatever is done here with keys and pointer returns when the program has answered that very input. xdotool returns when the X
    server has the events, not when the program has handled them; so behind them goes a fence, an event on the same road, and the
    program writes how many fences it has passed (apps/desktop/testing/input_fence.h says what that takes) into its layout file, together
    with the state that the input led to. Whoever looks at a state afterwards therefore never sees one from before the input, and
    whoever acts again acts on what the input led to; nothing here waits for a time and hopes. What the program then goes on with by
    itself (a picture at full quality, growth, files) is waited for with wait() and wait_idle(): for what stays once it is there, never
    for what passes (growth under way), which a busy machine may not see.

    A place is the name of a widget, a point of the screen, or a function without arguments that gives the point: the first and
    the last are looked at again when the pointer has arrived, for a panel may have moved meanwhile."""

    def __init__(self, display, program, folder, arguments=(), scale=1, home=None):
        self.folder = pathlib.Path(folder)
        self.layout_file = self.folder / "layout.json"
        self.layout_file.unlink(missing_ok=True)
        self.environment = dict(display.environment, QT_SCALE_FACTOR=str(scale), **own_home(home or self.folder / "home"))
        self.fence = Fence(display.number)
        self.fences = 0
        self.log = open(self.folder / "volume-studio.log", "w+")
        self.process = subprocess.Popen(
            [program, "--layout-file", str(self.layout_file), *map(str, arguments)],
            env=self.environment, stdout=self.log, stderr=subprocess.STDOUT)
        self.wait("the window", lambda state: "mainWindow" in state["windows"])
        self.focus()

    # --- looking

    def state(self):
        """What the program says of itself: nothing before the first time, and never less than what the last action led to."""
        if self.process.poll() is not None:
            self.log.seek(0)
            raise Silence(self, f"volume-studio ended with {self.process.returncode}:\n{self.log.read()}")
        return self.written()

    def written(self):
        try:
            return json.loads(self.layout_file.read_text())
        except FileNotFoundError:
            return None

    def wait(self, what, condition, seconds=90):
        """Waits until the condition holds; the bound is generous because a software renderer may share its cores."""
        state = None
        for _ in looks(seconds):
            state = self.state()
            if state is not None and condition(state):
                return state
        raise Failure(f"waited {seconds} s for {what}; {said_by(state)}")

    def wait_idle(self, what="the program to be idle", condition=lambda state: True, seconds=90):
        return self.wait(what, lambda state: state["idle"] and condition(state), seconds)

    def view_point(self, fx, fy):
        """A place of the view, given in fractions of it, in pixels of the screen."""
        x, y, width, height = self.state()["viewRect"]
        return round(x + fx * width), round(y + fy * height)

    def place_of(self, widget):
        """Its rectangle [x, y, width, height], once it is there."""
        return self.wait(f"the widget {widget}", lambda state: widget in state["widgets"])["widgets"][widget]

    # --- acting

    def xdotool(self, *words, lasting=False, ends=False):
        """Does what xdotool's words say. Returns the state that it led to. Lasting: what it led to may last (the program shows how
        far it is) and is not waited for. Ends: the program may end of it; then nothing is returned."""
        self.send(*words)
        return self.answer(" ".join(map(str, words)), lasting, ends)

    def send(self, *words):
        """Does what xdotool's words say and waits for nothing: for tests that measure or look meanwhile, and then answer()."""
        done = subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=False, capture_output=True, text=True)
        need(done.returncode == 0, f"xdotool {' '.join(map(str, words))}: {done.stderr.strip()}")

    def answer(self, what, lasting=False, ends=False):
        """Waits until all that was sent has been answered."""
        is_sent = False
        for _ in looks(ANSWER_SECONDS):
            if ends and self.process.poll() is not None:
                return None
            state = self.written() if ends else self.state()
            if state["passed"] == self.fences:
                if is_sent and (lasting or not state["lasting"]):
                    return state
                self.fence.send(state["fence"])
                self.fences += 1
                is_sent = True
        raise Silence(self, f"the program did not answer '{what}' within {ANSWER_SECONDS} s; {said_by(state)}")

    def key(self, keys, lasting=False):
        return self.xdotool("key", keys, lasting=lasting)

    def type(self, text):
        return self.xdotool("type", "--delay", 5, "--", text)

    def move(self, point):
        return self.xdotool("mousemove", *point)

    def arrive(self, place, lasting=False):
        """Moves the pointer to a place, from beside it: a press there is no second click of the last one."""
        def point():
            if isinstance(place, str):
                x, y, width, height = self.wait(f"the widget {place}, enabled", lambda state: place in state["widgets"]
                                                and place not in state["disabled"])["widgets"][place]
                return x + width // 2, y + height // 2
            return tuple(place() if callable(place) else place)

        for _ in range(50):
            x, y = point()
            self.xdotool("mousemove", x - 30 if x > 30 else x + 30, y, "mousemove", x, y, lasting=lasting)
            if point() == (x, y):
                return
        raise Failure(f"{place} does not keep its place; {said_by(self.state())}")

    def click(self, place, button=1, times=1, lasting=False):
        self.arrive(place, lasting)
        return self.xdotool("click", "--repeat", times, "--delay", 0, button, lasting=lasting)

    def drag(self, points, button=1, pause=0.02):
        """Presses at the first point, moves through the others with pauses in seconds, releases at the last. Points may be a
        function that gives them."""
        self.arrive((lambda: points()[0]) if callable(points) else points[0])
        way = points() if callable(points) else points
        moves = [word for x, y in way[1:] for word in ("mousemove", x, y, "sleep", pause)]
        return self.xdotool("mousedown", button, *moves, "mouseup", button)

    def type_number(self, box, number, end="Return"):
        """Replaces what stands in a number box."""
        self.click(box)
        self.key("ctrl+a")
        self.type(str(number))
        return self.key(end)

    def choose(self, choices, begin):
        """What begins so, in a list of choices: by the wheel, up to the first and down again."""
        self.arrive(choices)
        chosen = self.state()["reports"][choices]
        for button in (4, 5):
            before = None
            while chosen != before and not chosen.startswith(begin):
                before = chosen
                chosen = self.xdotool("click", button)["reports"][choices]
        need(chosen.startswith(begin), f"{choices} has no choice that begins with '{begin}'")

    def type_path(self, dialog, path):
        """Types a path into an open file dialog and accepts it."""
        self.wait(dialog, lambda state: dialog in state["windows"] and "fileNameEdit" in state["widgets"])
        self.click("fileNameEdit")
        self.key("ctrl+a")
        self.type(path)
        # What the dialog proposes while one types may pop up late, and takes a Return for itself.
        for _ in range(3):
            self.key("Return")
            if dialog not in self.answer(f"{dialog} has been given a Return")["windows"]:
                break
        self.wait(f"{dialog} to close", lambda state: dialog not in state["windows"])
        return self.focus()

    def focus(self, window="mainWindow"):
        """Gives a window the keyboard: there is no window manager here to do it when a dialog closes."""
        windows = self.answer(f"{window} is shown")["windows"]  # to the X server too
        need(window in windows, f"there is no window {window} to be given the keyboard")
        return self.xdotool("windowfocus", windows[window])

    def resize(self, width, height):
        return self.xdotool("windowsize", self.state()["windows"]["mainWindow"], width, height)

    def quit(self):
        if self.state()["viewRect"]:  # there is none on the start screen
            self.move(self.view_point(0.5, 0.5))
        self.focus()
        self.xdotool("key", "ctrl+q", ends=True)
        for _ in looks(ANSWER_SECONDS):
            if self.process.poll() is not None or "unsavedEdits" in self.written()["windows"]:
                break
        if self.process.poll() is None and "unsavedEdits" in self.written()["windows"]:
            self.focus("unsavedEdits")
            self.xdotool("key", "alt+d", ends=True)  # "Discard"
        try:
            code = self.process.wait(ANSWER_SECONDS)
        except subprocess.TimeoutExpired:
            raise Failure(f"volume-studio did not end within {ANSWER_SECONDS} s of Ctrl+Q") from None
        self.log.seek(0)
        output = self.log.read()
        need(code == 0, f"volume-studio ended with {code}:\n{output}")
        need("OpenGL:" not in output, f"OpenGL errors:\n{output}")

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.log.close()


STARTED = []


def start(*arguments, **options):
    studio = Studio(*arguments, **options)
    STARTED.append(studio)
    return studio
