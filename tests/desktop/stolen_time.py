# SPDX-License-Identifier: Apache-2.0
"""Time in which a virtual machine's processors were kept from it by its host ("steal" in /proc/stat). A pause of them lengthens
what goes on by the clock, and some kernels charge it as processor time to whatever ran when it began."""

import bisect
import os
import pathlib
import threading
import time

STAT = pathlib.Path("/proc/stat")
STEAL = 8  # the word of the line "cpu"
TICK_MS = 1e3 / os.sysconf("SC_CLK_TCK")
PERIOD_S = 0.01
LAG_MS = 30  # a processor's next ticks tell of a pause


def stolen_ms():
    """Of all processors together, since the machine was started."""
    return int(STAT.read_text().split("\n", 1)[0].split()[STEAL]) * TICK_MS


class StolenTime:
    """Looks on from when it is made until it is ended."""

    def __init__(self):
        self.samples, self.is_over = [], threading.Event()
        self.thread = threading.Thread(target=self.look, daemon=True)
        self.thread.start()

    def look(self):
        while not self.is_over.wait(PERIOD_S):
            self.samples.append((time.monotonic() * 1e3, stolen_ms()))

    def end(self):
        self.is_over.set()
        self.thread.join()

    def between(self, begin_ms, end_ms):
        """How much was taken from one moment of the steady clock to another."""
        first = bisect.bisect_right(self.samples, (begin_ms, 0)) - 1
        last = bisect.bisect_left(self.samples, (end_ms + LAG_MS, 0))
        if not self.samples:
            return 0
        return self.samples[min(last, len(self.samples) - 1)][1] - self.samples[max(first, 0)][1]

    def total(self):
        return self.samples[-1][1] - self.samples[0][1] if self.samples else 0
