# SPDX-License-Identifier: Apache-2.0
"""What programs and decoder say to each other is CBOR (RFC 8949); as much of it as their messages use."""
import struct


def head(kind, number):
    if number < 24:
        return bytes([kind << 5 | number])
    for more, form in ((24, ">B"), (25, ">H"), (26, ">I"), (27, ">Q")):
        if number < 1 << 8 * struct.calcsize(form):
            return bytes([kind << 5 | more]) + struct.pack(form, number)
    raise ValueError(f"{number} has more than 64 bits")


def encoded(value):
    if value is None or isinstance(value, bool):
        return {None: b"\xf6", False: b"\xf4", True: b"\xf5"}[value]
    if isinstance(value, int):
        return head(0, value) if value >= 0 else head(1, -1 - value)
    if isinstance(value, float):
        return b"\xfb" + struct.pack(">d", value)
    if isinstance(value, str):
        return head(3, len(value.encode())) + value.encode()
    if isinstance(value, list):
        return head(4, len(value)) + b"".join(map(encoded, value))
    return head(5, len(value)) + b"".join(encoded(key) + encoded(value[key]) for key in sorted(value))
