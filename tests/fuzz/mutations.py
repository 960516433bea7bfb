# SPDX-License-Identifier: Apache-2.0
"""What becomes of files on bad disks, in bad programs and in the hands of people who mean harm."""
import gzip
import re

EXTREMES = [b"\x00", b"\xff", b"\x7f", b"\x80", b"\x00\x00", b"\xff\xff", b"\xff\x7f", b"\x00\x80", b"\x00\x00\x00\x00",
            b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f", b"\x7f\xff\xff\xff", b"\x00\x00\x80\x7f", b"\x00\x00\xc0\x7f",
            b"\x00\x00\x80\xff", b"\xff\xff\x7f\x7f", b"\xff\xff\xff\xff\xff\xff\xff\x7f"]
WORDS = [b"-1", b"0", b"1e30", b"-1e-30", b"nan", b"inf", b"99999999999", b"2147483647", b"4294967296", b"1 1 1 1", b"", b"a" * 3000,
         b"%s%n", b"\xff\xfe", b"0x10", b"1.5", b"1,5", b"(1,2,3)", b"None", b"LOCAL", b"LIST", b"../values.bin", b"/dev/zero"]


def flip(random, data):
    for _ in range(random.choice([1, 1, 2, 8])):
        data[random.randrange(len(data))] ^= 1 << random.randrange(8)


def extreme(random, data):
    word = random.choice(EXTREMES)
    at = random.randrange(len(data))
    data[at:at + len(word)] = word


def cut(random, data):
    del data[random.randrange(len(data)):]


def remove(random, data):
    at = random.randrange(len(data))
    del data[at:at + random.choice([1, 2, 4, 16, 100])]


def insert(random, data):
    at = random.randrange(len(data) + 1)
    data[at:at] = random.choice([b"\n", b"\0", b" ", b"\0" * 100, bytes(data[:50])])


def double(random, data):
    at = random.randrange(len(data))
    length = random.choice([1, 4, 20, 200])
    data[at:at] = data[at:at + length]


def token(random, data):
    """Another word instead of one of a header in text."""
    words = list(re.finditer(rb"[^\s:=(),]+", bytes(data[:2000])))
    if words:
        word = random.choice(words)
        data[word.start():word.end()] = random.choice(WORDS)


def line(random, data):
    """A line of a header is left out, doubled or moved."""
    lines = bytes(data[:2000]).split(b"\n")
    if len(lines) > 2:
        one = random.randrange(len(lines) - 1)
        taken = lines[one]
        action = random.choice(["leave out", "double", "move"])
        if action != "double":
            del lines[one]
        if action != "leave out":
            lines.insert(random.randrange(len(lines)), taken)
        data[:2000] = b"\n".join(lines)


BINARY = [flip, flip, extreme, extreme, extreme, cut, remove, insert, double]
TEXT = [token, token, token, line, flip, extreme, cut, remove, insert, double]


def near_the_beginning(random, data, mutate, length):
    """Most of what matters stands at the beginning: changes there, most of the time."""
    if random.random() < 0.7 and len(data) > length:
        head = data[:length]
        mutate(random, head)
        data[:length] = head
    else:
        mutate(random, data)


def mutated(random, case):
    """Changes one file of a case, once or a few times, under its compression where it has one."""
    name = random.choice([case.main] * 3 + list(case.files)) if case.main else random.choice(list(case.files))
    data = case.files[name]
    inside = data[:2] == b"\x1f\x8b" and random.random() < 0.7
    data = bytearray(gzip.decompress(data) if inside else data)
    ways = TEXT if case.form in ("nrrd", "meta", "vtk") else BINARY
    for _ in range(random.choice([1, 1, 1, 2, 4])):
        if data:
            near_the_beginning(random, data, random.choice(ways), 400)
    case.files[name] = gzip.compress(bytes(data)) if inside else bytes(data)
    return case
