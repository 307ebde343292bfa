#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Paints the ground types of the example from the slope of its elevation model: rock on cliffs, soil and scree
below them, vegetation elsewhere. Standard library only. Run it in this folder:  python3 make_ground.py"""
import math
import os
import struct
import zlib

from make_textures import Noise

SOIL, VEGETATION, ROCK = 2, 3, 4  # numbers of GroundType
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "kontertal.assets")


def read_grid(path):
    with open(path, encoding="ascii") as text:
        head = [next(text).split() for _ in range(6)]
        cell, no_data = float(head[4][1]), float(head[5][1])
        return [[None if float(v) == no_data else float(v) for v in line.split()] for line in text if line.strip()], cell


def slope_degrees(rows, i, j, cell):
    here = rows[j][i]
    east = rows[j][min(i + 1, len(rows[j]) - 1)]
    north = rows[max(j - 1, 0)][i]
    if here is None or east is None or north is None:
        return 0.0
    return math.degrees(math.atan(math.hypot(east - here, north - here) / cell))


def type_of(slope, rough):
    if slope + 10.0 * (rough - 0.5) > 41.0:
        return ROCK
    return SOIL if slope + 14.0 * (rough - 0.5) > 36.0 else VEGETATION


def main():
    rows, cell = read_grid(os.path.join(FOLDER, "dem_5m.asc"))
    noise = Noise(9)
    raw = bytearray()
    for j in range(len(rows)):
        raw.append(0)
        for i in range(len(rows[0])):
            rough = 0.6 * noise.at(i / 9.0, j / 9.0, 60, 60) + 0.4 * noise.at(i / 3.0, j / 3.0, 180, 180)
            raw.append(type_of(slope_degrees(rows, i, j, cell), rough))
    chunk = lambda tag, data: struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    with open(os.path.join(FOLDER, "ground_types.png"), "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(raw), 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    main()
