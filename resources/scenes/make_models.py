#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Makes the models of the example scene: an alpine hut and two spruces as glTF 2.0 with PNG textures.

Standard library only; the same files each time. Run it in this folder:  python3 make_models.py
Shapes are built with z up in metres and written with y up, as glTF wants it.
"""
import json
import math
import os
import random
import struct

from make_textures import write_textures

OUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "kontertal.assets")


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def mul(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])
    return mul(a, 1.0 / length) if length > 0 else (0.0, 0.0, 1.0)


class Part:
    """Triangles of one material."""

    def __init__(self):
        self.positions, self.normals, self.uvs, self.indices = [], [], [], []

    def vertex(self, p, n, uv):
        self.positions.append(p)
        self.normals.append(n)
        self.uvs.append(uv)
        return len(self.positions) - 1

    def quad(self, a, b, c, d, uv=(1.0, 1.0), offset=(0.0, 0.0), normals=None):
        """Corners anticlockwise seen from outside; uv = texture repeats along a-b and a-d."""
        n = unit(cross(sub(b, a), sub(d, a)))
        normals = normals or (n, n, n, n)
        u, v = offset
        corners = [(u, v + uv[1]), (u + uv[0], v + uv[1]), (u + uv[0], v), (u, v)]
        k = [self.vertex(p, m, t) for p, m, t in zip((a, b, c, d), normals, corners)]
        self.indices += [k[0], k[1], k[2], k[0], k[2], k[3]]

    def triangle(self, a, b, c, uvs):
        n = unit(cross(sub(b, a), sub(c, a)))
        self.indices += [self.vertex(p, n, t) for p, t in zip((a, b, c), uvs)]

    def box(self, low, high, scale=1.0, offset=(0.0, 0.0)):
        """Axis-aligned box; the texture repeats every 1/scale metres."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        dx, dy, dz = (x1 - x0) * scale, (y1 - y0) * scale, (z1 - z0) * scale
        self.quad((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1), (dx, dz), offset)
        self.quad((x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1), (dy, dz), offset)
        self.quad((x1, y1, z0), (x0, y1, z0), (x0, y1, z1), (x1, y1, z1), (dx, dz), offset)
        self.quad((x0, y1, z0), (x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (dy, dz), offset)
        self.quad((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1), (dx, dy), offset)
        self.quad((x0, y1, z0), (x1, y1, z0), (x1, y0, z0), (x0, y0, z0), (dx, dy), offset)


# --- the hut --------------------------------------------------------------------------------------------------

HALF_X, HALF_Y = 4.0, 3.0        # walls
BASE_TOP, EAVES = 0.7, 3.1       # heights of stone base and wall plate
PITCH = math.tan(math.radians(25.0))
OVER_X, OVER_Y = 0.9, 1.0        # overhang at gables and eaves
ROOF = 0.20                      # thickness of the roof
LOG = 0.24                       # height of a log


def wall_top(y):
    return EAVES + (HALF_Y - abs(y)) * PITCH


def log_course(part, start, end, outward, z, seed):
    """One log of a wall: a three-sided bulge from start to end (plan points)."""
    bulge, length = 0.07, math.hypot(end[0] - start[0], end[1] - start[1])
    rows = [(0.0, 0.0), (bulge, 0.28), (bulge, 0.72), (0.0, 1.0)]
    shift = (seed * 0.37 % 1.0, seed * 0.125 % 1.0)
    for (o0, h0), (o1, h1) in zip(rows, rows[1:]):
        at = lambda p, o, h: (p[0] + outward[0] * o, p[1] + outward[1] * o, z + h * LOG)
        a, b, c, d = at(start, o0, h0), at(end, o0, h0), at(end, o1, h1), at(start, o1, h1)
        n0 = unit((outward[0], outward[1], (h0 - 0.5) * 1.6))
        n1 = unit((outward[0], outward[1], (h1 - 0.5) * 1.6))
        part.quad(a, b, c, d, (length * 0.5, 0.12), (shift[0], shift[1] + h0 * 0.12), (n0, n0, n1, n1))


def hut_walls(wood):
    z, course = BASE_TOP, 0
    while z < EAVES + HALF_Y * PITCH - LOG:
        if z + LOG <= EAVES + 0.02:
            log_course(wood, (-HALF_X, -HALF_Y), (HALF_X, -HALF_Y), (0, -1), z, course)
            log_course(wood, (HALF_X, HALF_Y), (-HALF_X, HALF_Y), (0, 1), z, course + 7)
            half = HALF_Y
        else:
            half = HALF_Y - (z + LOG - EAVES) / PITCH
        log_course(wood, (HALF_X, -half), (HALF_X, half), (1, 0), z, course + 3)
        log_course(wood, (-HALF_X, half), (-HALF_X, -half), (-1, 0), z, course + 5)
        # Crossed ends at the corners, alternating.
        if z + LOG <= EAVES + 0.02:
            for sx in (-1, 1):
                for sy in (-1, 1):
                    r = 0.10
                    if course % 2:
                        x0, x1 = sorted((sx * HALF_X, sx * (HALF_X + 0.32)))
                        wood.box((x0, sy * HALF_Y - r, z + 0.02), (x1, sy * HALF_Y + r, z + LOG - 0.02), 0.5)
                    else:
                        y0, y1 = sorted((sy * HALF_Y, sy * (HALF_Y + 0.32)))
                        wood.box((sx * HALF_X - r, y0, z + 0.02), (sx * HALF_X + r, y1, z + LOG - 0.02), 0.5)
        z += LOG
        course += 1
    for sx in (-1, 1):  # closes the gables behind the logs
        x = sx * (HALF_X - 0.02)
        corners = [(x, -HALF_Y, EAVES), (x, HALF_Y, EAVES), (x, 0.0, wall_top(0))]
        wood.triangle(*(corners if sx > 0 else corners[::-1]), [(0, 0), (3, 0), (1.5, 1)])


def hut_roof(shingle, wood):
    """Two slabs with real thickness; boards below, shingles above, edges closed."""
    x0, x1 = -(HALF_X + OVER_X), HALF_X + OVER_X
    length = x1 - x0
    ridge_low = wall_top(0)
    y_eave = HALF_Y + OVER_Y
    eave_low = EAVES - OVER_Y * PITCH
    slope = math.hypot(y_eave, ridge_low - eave_low)
    up = ROOF * math.sqrt(1 + PITCH * PITCH)
    for s in (-1, 1):
        def at(x, ridge, top):
            return (x, 0.0 if ridge else s * y_eave, (ridge_low if ridge else eave_low) + (up if top else 0.0))
        first, last = (x0, x1) if s < 0 else (x1, x0)
        shingle.quad(at(first, False, True), at(last, False, True), at(last, True, True), at(first, True, True),
                     (length * 0.5, slope * 0.5))
        wood.quad(at(last, False, False), at(first, False, False), at(first, True, False), at(last, True, False),
                  (length * 0.5, slope * 0.5))
        wood.quad(at(first, False, False), at(last, False, False), at(last, False, True), at(first, False, True),
                  (length * 0.5, 0.1))
        for x in (x0, x1):
            ring = [at(x, False, False), at(x, True, False), at(x, True, True), at(x, False, True)]
            if (x > 0) != (s < 0):
                ring = [ring[1], ring[0], ring[3], ring[2]]
            wood.quad(*ring, (slope * 0.5, 0.1))
    for y in (-HALF_Y, 0.0, HALF_Y):  # purlins reach out under the gables
        z = wall_top(y) - 0.02
        wood.box((x0 + 0.12, y - 0.1, z - 0.22), (x1 - 0.12, y + 0.1, z), 0.5)
    count = 11
    for k in range(count):  # rafter tails under the eaves
        x = x0 + 0.35 + (length - 0.7) * k / (count - 1)
        for s in (-1, 1):
            a, b = s * (HALF_Y - 0.1), s * (y_eave - 0.12)
            za, zb = wall_top(a) - 0.01, EAVES - (abs(b) - HALF_Y) * PITCH - 0.01
            for side in (-1, 1):
                ring = [(x + side * 0.06, a, za - 0.16), (x + side * 0.06, b, zb - 0.14),
                        (x + side * 0.06, b, zb), (x + side * 0.06, a, za)]
                wood.quad(*(ring if side * s < 0 else [ring[1], ring[0], ring[3], ring[2]]), (0.5, 0.1))
            lower = [(x - 0.06, a, za - 0.16), (x + 0.06, a, za - 0.16), (x + 0.06, b, zb - 0.14), (x - 0.06, b, zb - 0.14)]
            end = [(x - 0.06, b, zb - 0.14), (x + 0.06, b, zb - 0.14), (x + 0.06, b, zb), (x - 0.06, b, zb)]
            wood.quad(*(lower if s > 0 else lower[::-1]), (0.1, 0.5))
            wood.quad(*(end if s < 0 else [end[1], end[0], end[3], end[2]]), (0.1, 0.1))


def window(frame, glass, shutter, centre, width, height, axis, side):
    """Window in a wall across `axis` (0 = wall faces x, 1 = wall faces y)."""
    def place(along0, along1, out0, out1, z0, z1):
        along = (centre[0] + along0, centre[0] + along1)
        base = (HALF_X if axis == 0 else HALF_Y) + 0.05
        out = sorted((side * (base + out0), side * (base + out1)))
        if axis == 0:
            return (out[0], along[0], centre[1] + z0), (out[1], along[1], centre[1] + z1)
        return (along[0], out[0], centre[1] + z0), (along[1], out[1], centre[1] + z1)
    w, h, t = width / 2, height / 2, 0.09
    glass.box(*place(-w, w, 0.0, 0.03, -h, h))
    for args in ((-w - t, -w, -h - t, h + t), (w, w + t, -h - t, h + t), (-w, w, h, h + t)):
        frame.box(*place(args[0], args[1], 0.0, 0.09, args[2], args[3]), 0.5)
    frame.box(*place(-w - 0.2, w + 0.2, 0.0, 0.20, -h - t, -h), 0.5)  # sill that catches snow
    frame.box(*place(-0.025, 0.025, 0.02, 0.06, -h, h), 0.5)
    frame.box(*place(-w, w, 0.02, 0.06, -0.025, 0.025), 0.5)
    for s in (-1, 1):
        inner, outer = s * (w + t + 0.02), s * (w + t + 0.02 + width * 0.55)
        shutter.box(*place(min(inner, outer), max(inner, outer), 0.03, 0.08, -h - t, h + t), 1.0)


def build_hut():
    parts = {name: Part() for name in ("wood", "trim", "shutter", "door", "stone", "shingle", "glass", "firewood", "metal")}
    stone, wood, trim = parts["stone"], parts["wood"], parts["trim"]
    stone.box((-HALF_X - 0.12, -HALF_Y - 0.12, -1.6), (HALF_X + 0.12, HALF_Y + 0.12, BASE_TOP), 0.5)
    hut_walls(wood)
    hut_roof(parts["shingle"], trim)
    # Chimney through the southern slope, with a cover slab.
    stone.box((1.2, -1.55, 3.2), (1.95, -0.8, 5.55), 0.8)
    stone.box((1.1, -1.65, 5.75), (2.05, -0.7, 5.85), 0.8)
    for x in (1.24, 1.80):
        for y in (-1.51, -0.95):
            stone.box((x, y, 5.55), (x + 0.11, y + 0.11, 5.75), 0.8)
    # Door and step on the east gable, windows round the house.
    door_y = -1.2
    parts["door"].box((HALF_X + 0.05, door_y - 0.5, BASE_TOP), (HALF_X + 0.10, door_y + 0.5, BASE_TOP + 2.0), 1.0)
    for y in (door_y - 0.62, door_y + 0.5):
        trim.box((HALF_X + 0.03, y, BASE_TOP), (HALF_X + 0.16, y + 0.12, BASE_TOP + 2.12), 0.5)
    trim.box((HALF_X + 0.03, door_y - 0.5, BASE_TOP + 2.0), (HALF_X + 0.16, door_y + 0.5, BASE_TOP + 2.12), 0.5)
    parts["metal"].box((HALF_X + 0.10, door_y + 0.36, BASE_TOP + 0.95), (HALF_X + 0.16, door_y + 0.42, BASE_TOP + 1.08))
    stone.box((HALF_X + 0.1, door_y - 0.8, -0.8), (HALF_X + 0.75, door_y + 0.8, 0.36), 0.6)
    stone.box((HALF_X + 0.1, door_y - 0.7, 0.36), (HALF_X + 0.45, door_y + 0.7, 0.62), 0.6)
    for x in (-2.2, 0.3, 2.6):
        window(trim, parts["glass"], parts["shutter"], (x, 1.95), 0.8, 0.95, 1, -1)
    for x in (-2.0, 1.8):
        window(trim, parts["glass"], parts["shutter"], (x, 1.95), 0.8, 0.95, 1, 1)
    window(trim, parts["glass"], parts["shutter"], (1.2, 1.95), 0.8, 0.95, 0, 1)
    window(trim, parts["glass"], parts["shutter"], (0.0, 3.35), 0.6, 0.6, 0, 1)
    window(trim, parts["glass"], parts["shutter"], (0.0, 1.95), 0.8, 0.95, 0, -1)
    # Firewood under the northern eaves and a bench before the southern wall.
    parts["firewood"].box((-0.9, HALF_Y + 0.12, -0.4), (3.4, HALF_Y + 0.62, 1.35), 1.0)
    trim.box((-3.4, -HALF_Y - 0.62, 0.42), (-1.0, -HALF_Y - 0.18, 0.48), 0.5)
    for x in (-3.2, -1.35):
        trim.box((x, -HALF_Y - 0.56, -0.6), (x + 0.12, -HALF_Y - 0.24, 0.42), 0.5)
    materials = [
        ("wood", "wood.png", (0.78, 0.70, 0.62, 1), 0.95, False),
        ("trim", "wood.png", (0.62, 0.50, 0.40, 1), 0.95, False),
        ("shutter", "wood.png", (0.16, 0.42, 0.22, 1), 0.9, False),
        ("door", "wood.png", (0.50, 0.30, 0.17, 1), 0.9, False),
        ("stone", "stone.png", (0.9, 0.9, 0.9, 1), 0.97, False),
        ("shingle", "shingle.png", (0.85, 0.82, 0.78, 1), 0.95, False),
        ("glass", None, (0.012, 0.016, 0.02, 1), 0.12, False),
        ("firewood", "firewood.png", (1, 1, 1, 1), 0.97, False),
        ("metal", None, (0.03, 0.03, 0.03, 1), 0.5, False),
    ]
    write_gltf("hut", parts, materials)


# --- spruces ---------------------------------------------------------------------------------------------------

def frond(part, root, heading, length, width, lift, droop):
    """A drooping branch: a strip bent along its way and folded like a flat roof along its stem."""
    out = (math.cos(heading), math.sin(heading), 0.0)
    side = (-out[1], out[0], 0.0)
    steps, rows = 4, []
    for k in range(steps + 1):
        t = k / steps
        z = lift * t - droop * t * t
        centre = add(root, add(mul(out, length * t), (0.0, 0.0, length * z)))
        half = 0.5 * width * (1.0 - 0.25 * t) * (0.55 + 0.45 * min(1.0, 3.0 * t))
        fold = 0.30 * half
        left = add(centre, add(mul(side, half), (0, 0, -fold)))
        right = add(centre, add(mul(side, -half), (0, 0, -fold)))
        # Soft shading: normals lean outwards as on a closed crown.
        up = unit((out[0] * 0.55, out[1] * 0.55, 0.9))
        rows.append((left, centre, right, unit(add(up, mul(side, 0.5))), up, unit(add(up, mul(side, -0.5))), t))
    for (l0, c0, r0, nl0, nc0, nr0, t0), (l1, c1, r1, nl1, nc1, nr1, t1) in zip(rows, rows[1:]):
        for a, b, c, d, na, nb, nc, nd, ua, ub in ((c0, c1, l1, l0, nc0, nc1, nl1, nl0, 0.5, 0.0),
                                                   (r0, r1, c1, c0, nr0, nr1, nc1, nc0, 1.0, 0.5)):
            k = [part.vertex(a, na, (ua, 1.0 - t0)), part.vertex(b, nb, (ua, 1.0 - t1)),
                 part.vertex(c, nc, (ub, 1.0 - t1)), part.vertex(d, nd, (ub, 1.0 - t0))]
            part.indices += [k[0], k[1], k[2], k[0], k[2], k[3]]


def trunk(part, height, radius):
    sides = 8
    for k in range(sides):
        a0, a1 = 2 * math.pi * k / sides, 2 * math.pi * (k + 1) / sides
        low = [(radius * math.cos(a), radius * math.sin(a), -0.8) for a in (a0, a1)]
        high = [(0.02 * math.cos(a), 0.02 * math.sin(a), height) for a in (a0, a1)]
        n0, n1 = (math.cos(a0), math.sin(a0), 0.0), (math.cos(a1), math.sin(a1), 0.0)
        part.quad(low[0], low[1], high[1], high[0], (0.25, height * 0.5), (k * 0.25, 0), (n0, n1, n1, n0))


def build_spruce(name, height, radius, first, spacing, seed):
    rng = random.Random(seed)
    parts = {"bark": Part(), "needles": Part()}
    trunk(parts["bark"], height, 0.035 * height * 0.55)
    z, turn = first, rng.random() * 6.28
    while z < height - 0.15:
        t = (z - first) / (height - first)  # 0 low .. 1 top
        reach = radius * (1.0 - t) ** 0.82 * (0.72 + 0.28 * min(1.0, 6.0 * t + 0.45)) + 0.10
        count = 8 if reach > 0.9 else (6 if reach > 0.45 else 5)
        for k in range(count):
            heading = turn + 2 * math.pi * (k + 0.35 * (rng.random() - 0.5)) / count
            length = reach * (0.82 + 0.30 * rng.random())
            width = max(0.22, length * (0.62 + 0.12 * rng.random()))
            lift = 0.10 + 0.75 * t ** 1.5
            droop = 0.62 - 0.45 * t + 0.10 * rng.random()
            root = (0.0, 0.0, z + spacing * 0.45 * (rng.random() - 0.5))
            frond(parts["needles"], root, heading, length, width, lift, droop)
        turn += 0.9 + 0.5 * rng.random()
        z += spacing * (1.0 - 0.55 * t)
    for k in range(3):  # leader
        frond(parts["needles"], (0, 0, height - 0.5), k * 2.1, 0.55, 0.22, 1.6, 0.2)
    write_gltf(name, parts, [("bark", "bark.png", (1, 1, 1, 1), 0.97, False),
                             ("needles", "needles.png", (1, 1, 1, 1), 0.9, True)])


# --- glTF --------------------------------------------------------------------------------------------------------

def write_gltf(name, parts, materials):
    blob, views, accessors, primitives = bytearray(), [], [], []
    images, textures, described = [], [], []

    def accessor(data, component, kind, count, target, bounds=None):
        while len(blob) % 4:
            blob.append(0)
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data), "target": target})
        blob.extend(data)
        entry = {"bufferView": len(views) - 1, "componentType": component, "count": count, "type": kind}
        if bounds:
            entry["min"], entry["max"] = bounds
        accessors.append(entry)
        return len(accessors) - 1

    for index, (part_name, image, colour, roughness, cutout) in enumerate(materials):
        surface = {"baseColorFactor": list(colour), "metallicFactor": 0.0, "roughnessFactor": roughness}
        if image:
            if image not in images:
                images.append(image)
                textures.append({"source": len(images) - 1, "sampler": 0})
            surface["baseColorTexture"] = {"index": images.index(image)}
        entry = {"name": part_name, "pbrMetallicRoughness": surface}
        if cutout:
            entry.update({"alphaMode": "MASK", "alphaCutoff": 0.5, "doubleSided": True})
        described.append(entry)
        part = parts[part_name]
        up = lambda v: (v[0], v[2], -v[1])
        points = [up(p) for p in part.positions]
        pack = lambda rows: b"".join(struct.pack("<%df" % len(r), *r) for r in rows)
        single = lambda rows: [tuple(struct.unpack("<f", struct.pack("<f", c))[0] for c in r) for r in rows]
        exact = single(points)
        bounds = ([min(p[k] for p in exact) for k in range(3)], [max(p[k] for p in exact) for k in range(3)])
        count = len(points)
        attributes = {
            "POSITION": accessor(pack(points), 5126, "VEC3", count, 34962, bounds),
            "NORMAL": accessor(pack([up(n) for n in part.normals]), 5126, "VEC3", count, 34962),
            "TEXCOORD_0": accessor(pack(part.uvs), 5126, "VEC2", count, 34962),
        }
        indices = accessor(struct.pack("<%dH" % len(part.indices), *part.indices), 5123, "SCALAR", len(part.indices), 34963)
        primitives.append({"attributes": attributes, "indices": indices, "material": index})
    document = {
        "asset": {"version": "2.0", "generator": "Spindrift make_models.py", "copyright": "2026 Spindrift contributors, Apache-2.0"},
        "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": name}],
        "meshes": [{"name": name, "primitives": primitives}],
        "materials": described, "textures": textures, "images": [{"uri": i} for i in images],
        "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}],
        "accessors": accessors, "bufferViews": views, "buffers": [{"uri": name + ".bin", "byteLength": len(blob)}],
    }
    with open(os.path.join(OUT, name + ".bin"), "wb") as out:
        out.write(blob)
    with open(os.path.join(OUT, name + ".gltf"), "w", encoding="utf-8") as out:
        json.dump(document, out, indent=1)
        out.write("\n")
    print(name, sum(len(p.indices) for p in parts.values()) // 3, "triangles")


if __name__ == "__main__":
    os.makedirs(OUT, exist_ok=True)
    write_textures(OUT)
    build_hut()
    build_spruce("spruce_tall", 11.5, 2.5, 1.1, 0.62, 11)
    build_spruce("spruce_young", 5.2, 1.55, 0.45, 0.42, 23)
