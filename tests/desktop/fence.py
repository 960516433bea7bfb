# SPDX-License-Identifier: Apache-2.0
"""The event that tests send behind their input (driver.py says what for)."""

import socket
import struct


class Fence:
    """Marks the end of what xdotool has sent, by X's own protocol over a connection of its own. The event goes to a window that the
    program has for nothing else, whoever has the keyboard or the pointer."""

    SETUP, SEND_EVENT, KEY_PRESS = 0x6c, 25, 2

    def __init__(self, display_number):
        self.server = socket.socket(socket.AF_UNIX)
        self.server.connect(f"/tmp/.X11-unix/X{display_number}")
        self.server.sendall(struct.pack("<BxHHHHxx", self.SETUP, 11, 0, 0, 0))
        accepted, length = struct.unpack("<BxxxxxH", self.server.recv(8, socket.MSG_WAITALL))
        self.server.recv(4 * length, socket.MSG_WAITALL)
        if accepted != 1:
            raise ConnectionError("the X server refused the fence's connection")

    def send(self, window):
        event = struct.pack("<BBHIIIIhhhhHBx", self.KEY_PRESS, 8, 0, 0, 0, window, 0, 0, 0, 0, 0, 0, 1)
        self.server.sendall(struct.pack("<BBHII", self.SEND_EVENT, 0, 11, window, 0) + event)  # to who made the window
