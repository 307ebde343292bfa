#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Peak depth, speed and pressure of an avalanche, and its run-out along a path, from what `spindrift-cli export
--format ply --part flow` writes. Figures of the kind that depth-averaged models publish.

usage: avalanche_peaks.py FOLDER --spacing 0.6 [--path LINE.geojson] [--like DEM.asc | --cell 5] [--output NAME]
       avalanche_peaks.py --raster PRESSURE_kPa.asc --path LINE.geojson

  FOLDER    has PLY files of the part flow, all frames; the finer the frames, the finer the peaks
  --spacing of the particles, m: spacing_m of the scene's flow settings
  --path    line down the avalanche's track, in the coordinates of the terrain; run-out counts along it
  --like    ESRI ASCII grid whose cells are taken (its values as heights: depths are along the slope's normal then,
            else vertical)
  --output  writes NAME_ppr.asc (kPa), NAME_pfd.asc (m) and NAME_pfv.asc (m/s)
  --density of the pressure rho v^2, kg/m3 (200); v is the mean speed of the column in a cell
  --least   columns of less depth than this do not count, m (0.05)
  --threshold  pressures that bound the run-out, kPa (1 3 10)
  --width   how far from the path cells count, m (200)
  --raster  takes the peak pressure from this grid instead
"""
import argparse
import array
import glob
import json
import math
import os
import sys


class Grid:
    """Values of square cells, row by row from the south."""

    def __init__(self, columns, rows, x, y, cell, fill=0.0):
        self.columns, self.rows, self.x, self.y, self.cell = columns, rows, x, y, cell
        self.values = [fill] * (columns * rows)

    def like(self):
        return Grid(self.columns, self.rows, self.x, self.y, self.cell)

    def centre(self, k):
        return self.x + (k % self.columns + 0.5) * self.cell, self.y + (k // self.columns + 0.5) * self.cell

    @staticmethod
    def read(name):
        with open(name, encoding="ascii") as text:
            words = text.read().split()
        head, at = {}, 0
        while words[at][0].isalpha() and words[at].lower() != "nan":
            head[words[at].lower()] = float(words[at + 1])
            at += 2
        columns, rows, cell = int(head["ncols"]), int(head["nrows"]), head["cellsize"]
        half = 0.5 * cell
        x = head["xllcorner"] if "xllcorner" in head else head["xllcenter"] - half
        y = head["yllcorner"] if "yllcorner" in head else head["yllcenter"] - half
        grid = Grid(columns, rows, x, y, cell)
        none = head.get("nodata_value", -9999.0)
        for row in range(rows):
            for column in range(columns):
                value = float(words[at + row * columns + column])
                grid.values[(rows - 1 - row) * columns + column] = math.nan if value == none else value
        return grid

    def write(self, name):
        with open(name, "w", encoding="ascii") as out:
            out.write(f"ncols {self.columns}\nnrows {self.rows}\nxllcorner {self.x:.4f}\nyllcorner {self.y:.4f}\n"
                      f"cellsize {self.cell:g}\nNODATA_value -9999\n")
            for row in reversed(range(self.rows)):
                line = self.values[row * self.columns:(row + 1) * self.columns]
                out.write(" ".join(f"{v:.3f}" for v in line) + "\n")


class Frame:
    """Particles of one PLY file: places in the terrain's coordinates, speeds and the volume of each."""

    def __init__(self, name):
        with open(name, "rb") as data:
            head = []
            while not head or head[-1] != "end_header":
                head.append(data.readline().decode("ascii").strip())
            body = data.read()
        self.time, self.origin, count, names = 0.0, (0.0, 0.0), 0, []
        for line in head:
            words = line.split()
            if line.startswith("comment time_film_s"):
                self.time = float(words[2])
            elif line.startswith("comment local_origin"):
                self.origin = (float(words[2]), float(words[3]))
            elif line.startswith("element vertex"):
                count = int(words[2])
            elif line.startswith("property"):
                names.append(words[2])
        values = array.array("f")
        values.frombytes(body[:4 * len(names) * count])
        if sys.byteorder == "big":
            values.byteswap()
        column = lambda what: values[names.index(what)::len(names)]
        self.x, self.y = column("x"), column("y")
        self.speed = [math.sqrt(u * u + v * v + w * w) for u, v, w in
                      zip(*(column("scalar_velocity_" + axis) for axis in "xyz"))]


def cosines(heights):
    """Cosine of the slope in each cell."""
    grid, w = heights.like(), heights.columns
    for k, here in enumerate(heights.values):
        def slope(step, first, last):
            a = heights.values[k - step] if not first else math.nan
            b = heights.values[k + step] if not last else math.nan
            if math.isnan(a):
                a, b = here, b - here + b if not math.isnan(b) else here
            elif math.isnan(b):
                b = here + here - a
            return (b - a) / (2.0 * heights.cell)
        sx = slope(1, k % w == 0, k % w == w - 1)
        sy = slope(w, k < w, k >= len(heights.values) - w)
        grid.values[k] = 1.0 if math.isnan(sx + sy) else 1.0 / math.sqrt(1.0 + sx * sx + sy * sy)
    return grid


def box_of(frames, cell):
    """Cells round all places, a cell more on each side."""
    xs = [min(f.x) + f.origin[0] for f in frames] + [max(f.x) + f.origin[0] for f in frames]
    ys = [min(f.y) + f.origin[1] for f in frames] + [max(f.y) + f.origin[1] for f in frames]
    x, y = math.floor(min(xs) / cell - 1) * cell, math.floor(min(ys) / cell - 1) * cell
    return Grid(int((max(xs) - x) / cell) + 2, int((max(ys) - y) / cell) + 2, x, y, cell)


def peaks(files, shape, cosine, volume, options):
    """Peak pressure, depth and speed, and what each frame does."""
    pressure, depth, speed = shape.like(), shape.like(), shape.like()
    for name in files:
        frame = Frame(name)
        number, way = {}, {}
        ox, oy = frame.origin[0] - shape.x, frame.origin[1] - shape.y
        for x, y, v in zip(frame.x, frame.y, frame.speed):
            i, j = int((x + ox) // shape.cell), int((y + oy) // shape.cell)
            if 0 <= i < shape.columns and 0 <= j < shape.rows:
                k = j * shape.columns + i
                number[k] = number.get(k, 0) + 1
                way[k] = way.get(k, 0.0) + v
        for k, n in number.items():
            d = n * volume / shape.cell ** 2 * (cosine.values[k] if cosine else 1.0)
            if d < options.least:
                continue
            v = way[k] / n
            depth.values[k] = max(depth.values[k], d)
            speed.values[k] = max(speed.values[k], v)
            pressure.values[k] = max(pressure.values[k], options.density * v * v * 1e-3)
    return pressure, depth, speed


def read_path(name):
    with open(name, encoding="utf-8") as text:
        data = json.load(text)
    return [tuple(p[:2]) for p in data["features"][0]["geometry"]["coordinates"]]


def along(path, x, y):
    """Distance along a path of its point nearest to a place, and the distance between both."""
    best, begun = (math.inf, 0.0), 0.0
    for (ax, ay), (bx, by) in zip(path, path[1:]):
        dx, dy = bx - ax, by - ay
        size = math.hypot(dx, dy)
        t = min(max(((x - ax) * dx + (y - ay) * dy) / (size * size), 0.0), 1.0)
        away = math.hypot(x - ax - t * dx, y - ay - t * dy)
        best = min(best, (away, begun + t * size))
        begun += size
    return best[1], best[0]


def report(pressure, path, options):
    for threshold in options.threshold:
        cells = [k for k, p in enumerate(pressure.values) if p > threshold]
        line = f"pressure > {threshold:g} kPa: area {len(cells) * pressure.cell ** 2:.0f} m2"
        if path and cells:
            places = (along(path, *pressure.centre(k)) for k in cells)
            reached = max((s for s, away in places if away <= options.width), default=math.nan)
            line += f", run-out {reached:.1f} m along the path"
        print(line)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("folder", nargs="?")
    for name in ("--path", "--like", "--output", "--raster"):
        parser.add_argument(name)
    parser.add_argument("--cell", type=float, default=5.0)
    parser.add_argument("--spacing", type=float)
    parser.add_argument("--density", type=float, default=200.0)
    parser.add_argument("--least", type=float, default=0.05)
    parser.add_argument("--width", type=float, default=200.0)
    parser.add_argument("--threshold", type=float, nargs="+", default=[1.0, 3.0, 10.0])
    options = parser.parse_args()
    path = read_path(options.path) if options.path else None
    if options.raster:
        return report(Grid.read(options.raster), path, options)
    files = sorted(glob.glob(os.path.join(options.folder or ".", "*flow*.ply")))
    if not files or not options.spacing:
        parser.error("FOLDER with PLY files of the part flow, and --spacing of the scene's flow settings, are needed")
    heights = Grid.read(options.like) if options.like else None
    shape = heights.like() if heights else box_of([Frame(f) for f in files[::10] + files[-1:]], options.cell)
    made = peaks(files, shape, cosines(heights) if heights else None, options.spacing ** 3, options)
    for grid, name, unit in zip(made, ("ppr", "pfd", "pfv"), ("kPa", "m", "m/s")):
        print(f"peak {name}: {max(grid.values):.2f} {unit}")
        if options.output:
            grid.write(f"{options.output}_{name}.asc")
    report(made[0], path, options)


if __name__ == "__main__":
    main()
