# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Paints the textures of the example's models. Standard library only."""
import math
import os
import random
import struct
import zlib

SIZE = 256


def write_png(path, width, height, pixels, channels):
    """8-bit PNG; rows filtered by their upper neighbour."""
    row_bytes, rows = width * channels, []
    previous = bytes(row_bytes)
    for y in range(height):
        row = bytes(pixels[y * row_bytes:(y + 1) * row_bytes])
        rows.append(b"\x02" + bytes((a - b) & 255 for a, b in zip(row, previous)))
        previous = row
    chunk = lambda tag, data: struct.pack(">I", len(data)) + tag + data + struct.pack(">I", zlib.crc32(tag + data))
    header = struct.pack(">IIBBBBB", width, height, 8, 6 if channels == 4 else 2, 0, 0, 0)
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b""))


class Noise:
    """Value noise that repeats without a seam."""

    def __init__(self, seed):
        rng = random.Random(seed)
        self.table = [rng.random() for _ in range(4096)]

    def at(self, x, y, px, py):
        """x, y in cells; px, py = cells after which it repeats."""
        i, j = math.floor(x), math.floor(y)
        fx, fy = x - i, y - j
        fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
        v = lambda a, b: self.table[((i + a) % px * 71 + (j + b) % py * 977) % 4096]
        low = v(0, 0) + (v(1, 0) - v(0, 0)) * fx
        high = v(0, 1) + (v(1, 1) - v(0, 1)) * fx
        return low + (high - low) * fy


def paint(path, function, size=SIZE, channels=3):
    pixels = bytearray()
    for y in range(size):
        for x in range(size):
            # Steps of 4 keep the files small and are below what the eye sees in rough textures.
            pixels += bytes(max(0, min(255, int(c) & ~3)) for c in function(x / size, y / size))
    write_png(path, size, size, pixels, channels)


def wood(noise):
    """Weathered boards, grain along u; eight courses along v, so that each log gets its own."""
    def colour(u, v):
        course = int(v * 8)
        inside = v * 8 - course
        tone = 0.82 + 0.30 * noise.table[course * 5]
        wave = noise.at(u * 4, v * 16, 4, 16)
        grain = noise.at(u * 8 + wave, (v + 0.012 * wave) * 128, 8, 128)
        fine = noise.at(u * 24, v * 256, 24, 256)
        seam = min(1.0, min(inside, 1 - inside) * 9)
        crack = 0.45 if noise.at(u * 3 + 17, v * 64, 3, 64) > 0.93 else 1.0
        s = tone * (0.62 + 0.38 * grain + 0.16 * (fine - 0.5)) * (0.55 + 0.45 * seam) * crack
        grey = 0.35 * noise.at(u * 5, v * 9, 5, 9)
        return (s * (178 - 30 * grey), s * (132 + 8 * grey), s * (92 + 44 * grey))
    return colour


def shingle(noise):
    """Wooden shingles in rows of 0.25 m (a tile is 2 m), each with its own tone."""
    def colour(u, v):
        row = int(v * 8)
        along = v * 8 - row
        shift = noise.table[row * 3] * 0.9
        x = (u + shift) % 1.0 * 14
        k = int(x)
        inside = x - k
        tone = 0.62 + 0.5 * noise.table[(row * 131 + k * 17) % 4096]
        grain = noise.at(x * 4, v * 16, 56, 16)
        gap = 0.35 if min(inside, 1 - inside) < 0.035 else 1.0
        shade = 0.40 if along > 0.94 else 0.82 + 0.18 * along
        s = tone * (0.72 + 0.28 * grain) * gap * shade
        moss = max(0.0, noise.at(u * 5, v * 5, 5, 5) - 0.72) * 1.6
        return (s * (138 - 40 * moss), s * (126 - 6 * moss), s * (112 - 50 * moss))
    return colour


def stone(noise):
    """Rubble masonry: cells of jittered points, mortar where two are equally near."""
    n = 7
    def colour(u, v):
        x, y = u * n, v * n * 1.5
        first = second = 9.0
        best = 0
        for j in range(int(y) - 1, int(y) + 2):
            for i in range(int(x) - 1, int(x) + 2):
                key = (i % n) * 37 + (j % int(n * 1.5)) * 411
                px, py = i + 0.15 + 0.7 * noise.table[key % 4096], j + 0.2 + 0.6 * noise.table[(key + 999) % 4096]
                d = math.hypot((x - px) * 0.8, y - py)
                if d < first:
                    first, second, best = d, first, key
                elif d < second:
                    second = d
        joint = min(1.0, (second - first) * 5)
        tone = 0.60 + 0.5 * noise.table[(best * 3) % 4096]
        grain = noise.at(u * 32, v * 32, 32, 32) * 0.25 + noise.at(u * 96, v * 96, 96, 96) * 0.2
        s = tone * (0.66 + grain) * (0.45 + 0.55 * joint)
        warm = noise.table[(best * 7) % 4096]
        return (s * (150 + 22 * warm), s * (146 + 10 * warm), s * (142 - 10 * warm))
    return colour


def firewood(noise):
    """Ends of split logs: rings in jittered circles on a dark ground."""
    n = 7
    def colour(u, v):
        x, y = u * n, v * n
        best, key = 9.0, 0
        for j in range(int(y) - 1, int(y) + 2):
            for i in range(int(x) - 1, int(x) + 2):
                k = (i % n) * 53 + (j % n) * 307
                d = math.hypot(x - i - 0.35 - 0.3 * noise.table[k % 4096], y - j - 0.35 - 0.3 * noise.table[(k + 77) % 4096])
                d /= 0.44 + 0.14 * noise.table[(k + 5) % 4096]
                if d < best:
                    best, key = d, k
        if best > 1.0:
            return (26, 20, 15)
        ring = 0.86 + 0.14 * math.sin(best * 26 + 6 * noise.at(x, y, n, n))
        bark = 0.45 if best > 0.88 else 1.0
        s = (0.66 + 0.4 * noise.table[(key * 3) % 4096]) * ring * bark
        return (s * 202, s * 160, s * 108)
    return colour


def bark(noise):
    def colour(u, v):
        ridge = noise.at(u * 10 + 2 * noise.at(u * 4, v * 8, 4, 8), v * 6, 10, 6)
        fine = noise.at(u * 48, v * 48, 48, 48)
        s = 0.45 + 0.5 * ridge + 0.25 * (fine - 0.5)
        return (s * 104, s * 84, s * 68)
    return colour


def needles(path):
    """A spruce branch from its root (below) to its tip, seen from above, on a transparent ground."""
    rng = random.Random(5)
    size = SIZE
    colour = [[0.0, 0.0, 0.0, 0.0] for _ in range(size * size)]

    def dot(x, y, radius, rgb):
        for j in range(int(y - radius), int(y + radius) + 2):
            for i in range(int(x - radius), int(x + radius) + 2):
                if 0 <= i < size and 0 <= j < size:
                    a = max(0.0, min(1.0, radius + 0.5 - math.hypot(i - x, j - y)))
                    p = colour[j * size + i]
                    for c in range(3):
                        p[c] += (rgb[c] - p[c]) * a
                    p[3] = max(p[3], a)

    def stroke(x0, y0, x1, y1, radius, rgb):
        steps = max(1, int(math.hypot(x1 - x0, y1 - y0)))
        for k in range(steps + 1):
            t = k / steps
            dot(x0 + (x1 - x0) * t, y0 + (y1 - y0) * t, radius * (1 - 0.4 * t), rgb)

    def twig(x0, y0, angle, length):
        x1, y1 = x0 + math.cos(angle) * length, y0 - math.sin(angle) * length
        count = int(length / 2.6)
        for k in range(count + 1):
            t = k / max(1, count)
            x, y = x0 + (x1 - x0) * t, y0 + (y1 - y0) * t
            for s in (-1, 1):
                a = angle + s * (0.75 + 0.35 * rng.random())
                n = (6.5 + 3.5 * rng.random()) * (1 - 0.45 * t)
                g = 0.75 + 0.5 * rng.random()
                stroke(x, y, x + math.cos(a) * n, y - math.sin(a) * n, 0.95, (40 * g, 60 * g, 36 * g))
        stroke(x0, y0, x1, y1, 1.1, (66, 54, 38))

    middle = size / 2
    y = size - 4.0
    while y > 14:
        t = 1 - y / size
        reach = (size * 0.49) * (1 - t) ** 0.62 * (0.6 + 0.4 * min(1, t * 6))
        for s in (-1, 1):
            lean = 0.55 + 0.45 * t + 0.12 * (rng.random() - 0.5)
            twig(middle, y, math.pi / 2 - s * (math.pi / 2 - lean), reach * (0.82 + 0.18 * rng.random()))
        y -= 15.0 - 4.0 * t
    twig(middle, size - 2.0, math.pi / 2, size * 0.97)
    pixels = bytearray()
    for p in colour:
        # Clear texels take the needles' colour: filtering must not bleed black.
        rgb = p[:3] if p[3] > 0 else (38, 56, 34)
        pixels += bytes([int(rgb[0]) & ~3, int(rgb[1]) & ~3, int(rgb[2]) & ~3, int(255 * p[3])])
    write_png(path, size, size, pixels, 4)


def write_textures(folder):
    noise = Noise(3)
    paint(os.path.join(folder, "wood.png"), wood(noise))
    paint(os.path.join(folder, "shingle.png"), shingle(noise))
    paint(os.path.join(folder, "stone.png"), stone(noise))
    paint(os.path.join(folder, "firewood.png"), firewood(noise), 128)
    paint(os.path.join(folder, "bark.png"), bark(noise), 128)
    needles(os.path.join(folder, "needles.png"))
