# SPDX-License-Identifier: Apache-2.0
"""What a camera sees, reckoned apart from the program (doc/behaviour.md, "Pictures"): vectors are (left, posterior, superior)."""

import math

HALF_VIEW = math.radians(13)  # of the picture's smaller side
FRAMED = 0.78  # of the grid's half diagonal, at zoom 1


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def axes(camera):
    """The viewer's unit axes: right, up and back."""
    azimuth, elevation, roll = (math.radians(camera[name]) for name in ("azimuth", "elevation", "roll"))
    back = (math.sin(azimuth) * math.cos(elevation), -math.cos(azimuth) * math.cos(elevation), math.sin(elevation))
    upright = (-math.sin(azimuth) * math.sin(elevation), math.cos(azimuth) * math.sin(elevation), math.cos(elevation))
    level = (math.cos(azimuth), math.sin(azimuth), 0.0)
    right = tuple(math.sin(roll) * u + math.cos(roll) * v for u, v in zip(upright, level))
    up = tuple(math.cos(roll) * u - math.sin(roll) * v for u, v in zip(upright, level))
    return right, up, back


def seen(camera, point, centre, diagonal, size):
    """Where a point is in a picture, in parts of its width and height."""
    right, up, back = axes(camera)
    half = FRAMED * 0.5 * diagonal / camera["zoom"] / min(1.0, size[0] / size[1])  # of the picture's height, in mm
    d = tuple(p - c for p, c in zip(point, centre))
    nearer = 1.0
    if camera["projection"] == "perspective":
        distance = half / math.tan(HALF_VIEW)
        nearer = distance / (distance - dot(d, back))
    x = (dot(d, right) - camera["pan"][0]) * nearer / (half * size[0] / size[1])
    y = (dot(d, up) - camera["pan"][1]) * nearer / half
    return 0.5 + 0.5 * x, 0.5 - 0.5 * y
