#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Makes the grounds of the flow examples beside this file (chute, water_and_snow, waterfall_horsetail, waterfall_steps and
waterfall_block) and the boulder of avalanche_kontertal.

usage: make_flow_ground.py
"""
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))


def write(scene, width, height, cell, z):
    """An ESRI ASCII grid of heights z(x, y) at the cells' centres, from the south-west one on."""
    folder = os.path.join(HERE, scene + ".assets")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "ground.asc"), "w", encoding="ascii") as out:
        out.write(f"ncols {width}\nnrows {height}\nxllcenter 0\nyllcenter 0\ncellsize {cell}\nNODATA_value -9999\n")
        for j in reversed(range(height)):
            out.write(" ".join(f"{z(i * cell, j * cell):.3f}" for i in range(width)) + "\n")


def smooth(a, b, x):
    t = min(max((x - a) / (b - a), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


def slope_then_level(x, angle, begin, bend):
    """Falls by the angle up to `begin`, turns over the length `bend` and is level beyond; 0 at its end."""
    grade = math.tan(math.radians(angle))
    if x >= begin + bend:
        return 0.0
    if x >= begin:
        return grade * (begin + bend - x) ** 2 / (2.0 * bend)
    return grade * (0.5 * bend + begin - x)


def chute(x, y):
    """A channel 2 m wide that falls by 38 degrees into a level run-out of 4 m."""
    away = max(abs(y - 2.0) - 0.7, 0.0)
    wall = 0.7 * smooth(0.0, 0.9, away) * (1.0 - smooth(6.0, 8.5, x))
    back = 1.5 * (1.0 - smooth(0.0, 0.6, x))
    return slope_then_level(x, 38.0, 5.0, 1.5) + wall + back


def two_fluids(x, y):
    """A slope of 24 degrees with humps, and a ridge that keeps its two halves apart at the top."""
    humps = 0.25 * math.sin(0.9 * x) * math.cos(0.8 * y) * smooth(6.0, 9.0, x) * (1.0 - smooth(17.0, 20.0, x))
    ridge = 1.2 * math.exp(-((y - 7.0) / 0.35) ** 2) * (1.0 - smooth(8.0, 11.0, x))
    rim = 1.5 * (smooth(-1.2, 0.0, -min(y, 14.0 - y)) + 1.0 - smooth(0.0, 1.2, x)) * (1.0 - smooth(9.0, 12.0, x))
    return slope_then_level(x, 24.0, 18.0, 4.0) + humps + ridge + rim


def horsetail(x, y):
    """A stream bed, a face of 40 m with ledges that leans by 8 degrees, and a plunge pool with an outlet."""
    wander = 1.2 * math.sin(0.31 * y) + 0.5 * math.sin(0.83 * y + 1.0)
    bed = 40.0 + 0.05 * (20.0 - x) + 1.6 * smooth(1.6, 4.0, abs(y - 20.0))
    lip = 20.0 + 0.3 * wander
    drop = (x - lip) / math.tan(math.radians(8.0))
    ledge = 0.25 * math.sin(0.9 * drop + 0.4 * y) if 0.0 < drop < 40.0 else 0.0
    face = bed - (x + ledge - lip) / math.tan(math.radians(8.0))
    distance = math.hypot(x - 29.0, y - 20.0)
    floor = 2.5 * smooth(4.0, 9.0, distance) - 0.04 * (x - 26.0)
    outlet = smooth(1.5, 4.0, abs(y - 20.0)) if x > 29.0 else 1.0
    floor = (floor + 0.04 * (x - 26.0)) * outlet - 0.04 * (x - 26.0)
    return bed if x <= lip else max(face, floor)


def steps(x, y):
    """80 m in four drops of 20 m; below each a pool of 1.6 m that fills and spills through a gap in its rim."""
    height = 80.0 + 0.05 * max(20.0 - x, 0.0)
    for k, lip in enumerate((20.0, 38.0, 57.0, 75.0)):
        edge = lip + 0.5 * math.sin(0.5 * y + k)
        height -= 20.0 * min(max((x - edge) / 3.5, 0.0), 1.0)
        away = math.hypot((x - lip - 8.5) / 5.5, (y - 20.0) / 5.5)
        height -= 1.6 * (1.0 - smooth(0.4, 1.0, away))
    return height + 2.5 * smooth(3.0, 6.5, abs(y - 20.0 - 0.8 * math.sin(0.12 * x))) - 0.03 * max(x - 80.0, 0.0)


def block(x, y):
    """A plateau that ends in a wall of 55 m over a level base."""
    lip = 30.0 + 0.6 * math.sin(0.45 * y) + 0.3 * math.sin(1.1 * y)
    if x <= lip:
        return 55.0 + 0.03 * (30.0 - x) + 1.5 * smooth(20.0, 23.0, abs(y - 30.0))
    return max(55.0 - 40.0 * (x - lip), -0.01 * (x - 30.0))


def boulder(folder, name):
    """A block of 3.2 x 2.6 x 2 m with blunt edges and dents, closed: a cube's faces cut in 4 x 4 and pulled towards a ball."""
    cuts, points, faces = 4, {}, []

    def corner(axis, sign, u, v):
        p = [0.0, 0.0, 0.0]
        p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = sign, 2.0 * u / cuts - 1.0, 2.0 * v / cuts - 1.0
        key = tuple(round(c, 6) for c in p)
        if key not in points:
            r = math.sqrt(sum(c * c for c in p))
            dent = 1.0 + 0.06 * math.sin(5.1 * p[0] + 1.3) * math.cos(4.3 * p[1]) * math.sin(3.7 * p[2] + 0.4)
            pull = 0.45 + 0.55 / r * 1.25
            points[key] = (len(points) + 1, [c * pull * dent * s for c, s in zip(p, (1.6, 1.3, 1.0))])
        return points[key][0]

    for axis in range(3):
        for sign in (-1.0, 1.0):
            for v in range(cuts):
                for u in range(cuts):
                    q = [corner(axis, sign, u + a, v + b) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                    if sign < 0:
                        q.reverse()
                    faces += [(q[0], q[1], q[2]), (q[0], q[2], q[3])]
    os.makedirs(os.path.join(HERE, folder), exist_ok=True)
    with open(os.path.join(HERE, folder, name), "w", encoding="ascii") as out:
        for _, p in points.values():
            out.write("v " + " ".join(f"{c:.4f}" for c in p) + "\n")
        for f in faces:
            out.write("f " + " ".join(str(i) for i in f) + "\n")


boulder("avalanche_kontertal.assets", "boulder.obj")
write("chute", 116, 41, 0.1, chute)
write("water_and_snow", 161, 71, 0.2, two_fluids)
write("waterfall_horsetail", 113, 81, 0.5, horsetail)
write("waterfall_steps", 136, 51, 0.8, steps)
write("waterfall_block", 121, 61, 1.0, block)
