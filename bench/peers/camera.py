# SPDX-License-Identifier: Apache-2.0
"""The perspective camera of src/render/camera/camera.cpp at zoom 1, and the same as a VTK camera."""
import math

import numpy as np

HALF_FOV_DEGREES = 13.0
FRAME = 0.78  # part of the grid's half diagonal that fits into half the picture's smaller side


def diagonal(world, dims):
    """Length of the longest diagonal of the grid's box, mm."""
    signs = ((1, 1, 1), (-1, 1, 1), (1, -1, 1), (1, 1, -1))
    return max(np.linalg.norm(world[:3, :3] @ (np.array(s) * dims)) for s in signs)


def pose(info, azimuth, elevation, size):
    """Eye, target and up in LPS millimetres, and the length of the grid's diagonal."""
    world, dims = np.array(info["worldFromVoxel"]), np.array(info["dims"])
    a, e = math.radians(azimuth), math.radians(elevation)
    to_eye = np.array([math.sin(a) * math.cos(e), -math.cos(a) * math.cos(e), math.sin(e)])
    up = np.array([-math.sin(a) * math.sin(e), math.cos(a) * math.sin(e), math.cos(e)])
    length = diagonal(world, dims)
    half_height = FRAME * 0.5 * length / min(1.0, size[0] / size[1])
    target = world[:3, :3] @ (0.5 * (dims - 1)) + world[:3, 3]
    return target + to_eye * half_height / math.tan(math.radians(HALF_FOV_DEGREES)), target, up, length


def aim(renderer, eye_target_up_length):
    eye, target, up, length = eye_target_up_length
    camera = renderer.GetActiveCamera()
    camera.SetPosition(eye)
    camera.SetFocalPoint(target)
    camera.SetViewUp(up)
    camera.SetViewAngle(2 * HALF_FOV_DEGREES)
    distance = float(np.linalg.norm(eye - target))
    camera.SetClippingRange(max(distance - length, 0.01 * distance), distance + length)
