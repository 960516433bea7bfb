# SPDX-License-Identifier: Apache-2.0
"""The window follows a desktop that goes from dark to light and back, all of it and at once, unless a theme is preferred."""

import shutil
import subprocess
import sys

from driver import need, start
from phantom import write_ball_head
from steps import Steps
from test_histogram import visible
from test_start import scissors

test = Steps()

SIZE = (1230, 870)
NONE, DARK, LIGHT = 0, 1, 2
DARK_GROUND, LIGHT_GROUND = (0x1f, 0x22, 0x26), (0xe8, 0xeb, 0xee)  # of the window in each theme


class Desktop:
    """A session bus with a portal on it."""

    def __init__(self, display, portal):
        need(shutil.which("dbus-daemon"), "dbus-daemon is not installed (Debian: dbus-daemon)")
        self.bus = subprocess.Popen(["dbus-daemon", "--session", "--nofork", "--print-address"], stdout=subprocess.PIPE,
                                    text=True, env=display.environment)
        display.environment["DBUS_SESSION_BUS_ADDRESS"] = self.bus.stdout.readline().strip()
        self.portal = subprocess.Popen([portal], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                       env=display.environment)
        need(self.portal.stdout.readline() == "ready\n", "the portal did not start")

    def tell(self, *words):
        line = " ".join(map(str, words))
        print(line, file=self.portal.stdin, flush=True)
        need(self.portal.stdout.readline() == line + "\n", f"the portal did not {line}")

    def grab(self, path):
        self.tell("grab", path)
        return read_ppm(path)

    def close(self):
        for process in (self.portal, self.bus):
            process.terminate()
            process.wait()


def read_ppm(path):
    """Width, and the bytes of the pixels."""
    kind, size, _, pixels = path.read_bytes().split(b"\n", 3)
    need(kind == b"P6", f"{path} is no PPM")
    return int(size.split()[0]), pixels


def without_picture(grabbed, view):
    """Without the rendered picture, which themes leave alone, and the status bar, which tells how fast it came."""
    width, pixels = grabbed
    x, y, wide, high = view
    rows = bytearray(pixels[:3 * width * (SIZE[1] - 28)])
    for row in range(y, y + high):
        at = 3 * (row * width + x)
        rows[at:at + 3 * wide] = bytes(3 * wide)
    return width, bytes(rows)


def ground(grabbed):
    """The window's colour in the menu bar, right of the menus."""
    width, pixels = grabbed
    at = 3 * (4 * width + 900)
    return tuple(pixels[at:at + 3])


def prefer(studio, desktop, scheme, is_light):
    """The desktop says so, and the program has heard it."""
    desktop.tell("scheme", scheme)
    studio.wait("the program to hear of it", lambda s: s["desktopLight"] == is_light)


def photograph(studio, desktop, folder, colour):
    """The picture of the screen at rest, when the window has that colour."""
    is_idle = False
    while not is_idle:
        studio.wait_idle("the window to be at rest", lambda s: s["pictureComplete"])
        state = studio.answer("the window is painted")
        is_idle = state["idle"]
    grabbed = without_picture(desktop.grab(folder / "now.ppm"), state["viewRect"])
    need(ground(grabbed) == colour, f"the window is {ground(grabbed)}, not {colour}")
    return grabbed


def differing(a, b):
    """The rectangle of pixels that differ; nothing where none does."""
    width, pixels_a = a
    _, pixels_b = b
    places = [i // 3 for i in range(len(pixels_a)) if pixels_a[i] != pixels_b[i]] if pixels_a != pixels_b else []
    xs, ys = [p % width for p in places], [p // width for p in places]
    return f"{len(places)} pixels in x {min(xs)}..{max(xs)}, y {min(ys)}..{max(ys)}" if places else ""


def need_same(a, b, what):
    difference = differing(a, b)
    need(not difference, f"{what}: {difference}")


def open_window(display, arguments, folder):
    """With slices, an undone step in the history, and the preferences open."""
    studio = start(display, arguments.program, folder, [folder / "head.nrrd"])
    studio.resize(*SIZE)
    studio.wait_idle("the volume", lambda s: s["pictureComplete"])
    studio.move(studio.view_point(0.9, 0.9))
    scissors(studio)
    studio.key("ctrl+z")
    studio.wait_idle("undo", lambda s: s["canRedo"] and "histogram" in s["reports"] and len(set(visible(s))) == 1)
    studio.key("ctrl+h")
    studio.wait("the history", lambda s: "historyList" in s["widgets"])
    studio.key("F4")
    studio.wait_idle("slices", lambda s: s["pictureComplete"] and "axialSlice" in s["widgets"])
    studio.key("ctrl+comma")
    studio.wait("the preferences", lambda s: "preferencesDialog" in s["widgets"])
    studio.focus("preferencesDialog")
    studio.move((SIZE[0] + 200, 500))  # over nothing that would light up
    return studio


def close(studio):
    studio.focus("preferencesDialog")
    studio.key("Escape")
    studio.wait("the preferences to close", lambda s: "preferencesDialog" not in s["widgets"])
    studio.focus()
    studio.quit()


@test.step
def desktop(display, arguments, folder, cleanup):
    """A dark one, though Qt's own colours are light here."""
    write_ball_head(folder / "head.nrrd")
    settings = folder / "home" / "config" / "volume-studio"
    settings.mkdir(parents=True)
    (settings / "volume-studio.ini").write_text("[General]\ntheme=desktop\n")
    desktop = Desktop(display, arguments.portal)
    cleanup.callback(desktop.close)
    desktop.tell("scheme", DARK)
    return desktop


@test.step
def studio(display, arguments, folder, desktop):
    studio = open_window(display, arguments, folder)
    studio.wait("the program to hear of it", lambda s: not s["desktopLight"])
    return studio


@test.step
def dark(studio, desktop, folder):
    return photograph(studio, desktop, folder, DARK_GROUND)


@test.step
def light(studio, desktop, folder):
    prefer(studio, desktop, LIGHT, True)
    return photograph(studio, desktop, folder, LIGHT_GROUND)


@test.step
def dark_again(studio, desktop, folder, dark):
    prefer(studio, desktop, DARK, False)
    need_same(photograph(studio, desktop, folder, DARK_GROUND), dark, "not dark again")


@test.step
def no_preference(studio, desktop, folder, light):
    """As Qt says."""
    prefer(studio, desktop, NONE, True)
    need_same(photograph(studio, desktop, folder, LIGHT_GROUND), light, "not light without a preference")


@test.step
def preferred_dark(studio, desktop, folder):
    """Whatever the desktop says."""
    prefer(studio, desktop, DARK, False)
    studio.click("themeDark")
    preferred = photograph(studio, desktop, folder, DARK_GROUND)
    prefer(studio, desktop, LIGHT, True)
    need_same(photograph(studio, desktop, folder, DARK_GROUND), preferred, "a preference for dark does not hold")


@test.step(after=[preferred_dark])
def preferred_light(studio, desktop, folder):
    studio.click("themeDesktop")
    photograph(studio, desktop, folder, LIGHT_GROUND)
    studio.click("themeLight")
    prefer(studio, desktop, DARK, False)
    photograph(studio, desktop, folder, LIGHT_GROUND)
    studio.click("themeDesktop")
    photograph(studio, desktop, folder, DARK_GROUND)


@test.step
def end(studio):
    need(studio.state()["glErrors"] == 0, "OpenGL errors")
    close(studio)


@test.step(after=[end])
def light_at_first(display, arguments, folder, desktop, light):
    """Nothing is left of the colours that a window began with."""
    desktop.tell("scheme", LIGHT)
    studio = open_window(display, arguments, folder)
    studio.wait("the program to hear of it", lambda s: s["desktopLight"])
    need_same(photograph(studio, desktop, folder, LIGHT_GROUND), light, "what was dark at first differs from what was light")
    close(studio)


if __name__ == "__main__":
    sys.exit(test.main(__doc__, "--program", "--portal"))
