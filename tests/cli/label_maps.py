# SPDX-License-Identifier: Apache-2.0
"""Label maps as bytes, one a voxel, and how well two regions overlap."""
import gzip
import struct


def read_labels(path):
    """Voxels of a one-byte NIfTI file, and millilitres a voxel."""
    content = gzip.decompress(path.read_bytes())
    spacing = struct.unpack_from("<3f", content, 80)
    offset = int(struct.unpack_from("<f", content, 108)[0])
    return content[offset:], spacing[0] * spacing[1] * spacing[2] / 1000


def mask(labels, values):
    """One where a voxel has one of the values, else zero."""
    return labels.translate(bytes(1 if v in values else 0 for v in range(256)))


def dice(a, b):
    """Dice coefficient of two masks: 1 where they are the same, 0 where they share nothing."""
    both = (int.from_bytes(a, "little") & int.from_bytes(b, "little")).bit_count()
    return 2 * both / (a.count(1) + b.count(1))
