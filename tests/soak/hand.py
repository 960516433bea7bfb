# SPDX-License-Identifier: Apache-2.0
"""A random hand on the window: strokes with every tool, keys, buttons, and the history back and forth."""

from driver import Failure

TOOLS = "xxxxsssttpppddbbwkchgm"  # their keys: those that change most with one stroke more often
SHAPES = "nnnef"  # rectangle, ellipse, free-form, where the tool in hand has them
VIEWS = ("1", "2", "3", "4", "5", "9", "6", "7", "8", "l", "a", "shift+s", "shift+a", "shift+t", "shift+x", "shift+i")
GROWTH = ("period", "comma", "ctrl+g", "ctrl+period", "shift+g", "shift+b", "ctrl+shift+b")
# What is not pressed at random: what leaves the document, what waits for a file's name, what another test is about.
LEAVING = ("quit", "start", "open", "close", "play", "new", "save", "export", "screenshot", "language", "theme", "recover", "case",
           "recent", "window", "minim", "maxim", "giveup", "film", "about", "help", "preferences", "folder", "load", "labels")


class Hand:
    """Does one thing after another with a studio, as a random generator says, and waits for each to be answered."""

    def __init__(self, studio, chance, session=None):
        self.studio, self.chance, self.session = studio, chance, session
        self.done = []  # what it did, for whoever looks for a fault
        ways = [(self.stroke, 10), (self.history, 3), (self.look, 2), (self.grow, 2), (self.button, 3), (self.segment, 1),
                (self.note, 1), (self.turn, 1)] + ([(self.save, 1)] if session else [])
        self.ways = [way for way, times in ways for _ in range(times)]

    def act(self):
        way = self.chance.choice(self.ways)
        self.done.append(way.__name__)
        way()
        self.leave_dialogs()

    def settle(self):
        """Whatever goes on by itself ends; the picture may still be refined."""
        if self.studio.state()["playing"]:
            self.key("ctrl+period")
        return self.studio.wait("the end of what goes on", lambda s: not s["playing"] and not s["away"] and not s["loading"])

    # --- in the view

    def place(self):
        return self.studio.view_point(self.chance.uniform(0.3, 0.7), self.chance.uniform(0.25, 0.75))

    def key(self, keys):
        """With the pointer over the picture, whose keys they are."""
        self.studio.move(self.studio.view_point(0.5, 0.5))
        self.done[-1] += f" {keys}"
        return self.studio.key(keys, lasting=True)

    def stroke(self):
        """A tool is taken and led along a way of a few places; sometimes it is only clicked with."""
        self.key(self.chance.choice(TOOLS))
        if self.chance.random() < 0.5:
            self.key(self.chance.choice(SHAPES))
        x, y = self.place()
        if self.chance.random() < 0.25:
            self.studio.xdotool("mousemove", x, y, "click", 1, lasting=True)
        else:
            way = [(x + self.chance.randint(-90, 90), y + self.chance.randint(-70, 70)) for _ in range(self.chance.randint(1, 6))]
            moves = [word for px, py in way for word in ("mousemove", px, py)]
            self.studio.xdotool("mousemove", x, y, "mousedown", 1, *moves, "mouseup", 1, lasting=True)
        if self.chance.random() < 0.5:
            self.key("Return")  # where a sketch waits to be used

    def turn(self):
        (x, y), (to_x, to_y) = self.place(), self.place()
        self.studio.xdotool("mousemove", x, y, "mousedown", 3, "mousemove", to_x, to_y, "mouseup", 3, lasting=True)
        self.studio.xdotool("click", self.chance.choice((4, 5)), lasting=True)

    def look(self):
        self.key(self.chance.choice(VIEWS))

    def grow(self):
        self.key(self.chance.choice(GROWTH))

    def segment(self):
        self.key(self.chance.choice(("ctrl+shift+n", "ctrl+shift+n", "ctrl+shift+r", "ctrl+shift+u")))

    def history(self):
        for _ in range(self.chance.randint(1, 4)):
            self.key(self.chance.choice(("ctrl+z", "ctrl+z", "ctrl+shift+z")))

    # --- beside it

    def button(self):
        """Any button that is enabled, but for those that leave the document."""
        state = self.studio.state()
        names = [name for name, (_, _, width, height) in state["widgets"].items()
                 if width < 220 and height < 60 and name not in state["disabled"] and name not in state["windows"] and
                 not any(word in name.lower() for word in LEAVING)]
        if not names:
            return
        name = self.chance.choice(sorted(names))
        self.done[-1] += f" {name}"
        x, y, width, height = state["widgets"][name]
        self.studio.xdotool("mousemove", x + width // 2, y + height // 2, "click", 1, lasting=True)

    def note(self):
        self.key("ctrl+n")
        if "note" in self.studio.answer("a note", lasting=True)["windows"]:
            self.studio.focus("note")
            self.studio.type(f"note {len(self.done)}")
            self.studio.xdotool("key", "Return", lasting=True)

    def save(self):
        """The session, each time into the same file: by name at first, and then where it lies, which asks nothing."""
        self.settle()
        is_there = self.session.exists()
        self.key("ctrl+s" if is_there else "ctrl+shift+s")
        if "saveDialog" in self.studio.answer("saving", lasting=True)["windows"]:
            self.studio.focus("saveDialog")
            if is_there: # the document is another one than was saved there: whether to replace that would be asked
                self.studio.xdotool("key", "Escape", lasting=True)
            else:
                self.studio.type_path("saveDialog", self.session)

    def leave_dialogs(self):
        """Dialogs and menus that have opened are left as they came."""
        for _ in range(8):
            state = self.studio.answer("what has opened", lasting=True)
            others = [name for name in state["windows"] if name != "mainWindow"]
            if not others:
                return
            self.studio.focus(others[-1])
            self.studio.xdotool("key", "Escape", lasting=True)
            if "mainWindow" in self.studio.answer("Escape", lasting=True)["windows"]:
                self.studio.focus()
        raise Failure(f"these windows do not close: {others}; {self.done[-3:]}")
