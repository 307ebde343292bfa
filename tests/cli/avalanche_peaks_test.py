#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""A block of particles that slides over three cells: peaks, area and run-out by resources/tools/avalanche_peaks.py.

Usage: avalanche_peaks_test.py SOURCE_DIR
"""
import json
import os
import struct
import subprocess
import sys
import tempfile

TOOL = os.path.join(sys.argv[1], "resources/tools/avalanche_peaks.py")


def write_frame(name, time, x0, speed):
    """8 x 8 x 4 particles of 0.5 m in the cell that begins at x0: 2 m of snow over 4 x 4 m."""
    places = [(x0 + 0.5 * (i + 0.5), 0.5 * (j + 0.5), 0.5 * (k + 0.5)) for k in range(4) for j in range(8) for i in range(8)]
    with open(name, "wb") as out:
        out.write((f"ply\nformat binary_little_endian 1.0\ncomment time_film_s {time}\n"
                   f"comment local_origin 1000.0 2000.0 0.0 epsg 0\nelement vertex {len(places)}\n"
                   + "".join(f"property float {p}\n" for p in "xyz") + "property uint id\n"
                   + "".join(f"property float scalar_velocity_{a}\n" for a in "xyz") + "end_header\n").encode())
        for number, place in enumerate(places):
            out.write(struct.pack("<3fI3f", *place, number, 0.6 * speed, 0.0, -0.8 * speed))


def main():
    with tempfile.TemporaryDirectory() as folder:
        for frame, (x0, speed) in enumerate([(0.0, 0.0), (4.0, 10.0), (8.0, 1.0)]):
            write_frame(os.path.join(folder, f"a_flow.{frame:04d}.ply"), frame, x0, speed)
        path = os.path.join(folder, "path.geojson")
        with open(path, "w", encoding="utf-8") as out:
            json.dump({"features": [{"geometry": {"coordinates": [[1000.0, 2002.0], [1050.0, 2002.0]]}}]}, out)
        words = [sys.executable, TOOL, folder, "--spacing", "0.5", "--cell", "4", "--path", path, "--threshold", "1"]
        said = subprocess.run(words + ["--output", os.path.join(folder, "peak")], check=True, capture_output=True, text=True).stdout
        # 200 kg/m3 (10 m/s)^2 = 20 kPa in the second cell; the third has 0.2 kPa.
        for expected in ("peak ppr: 20.00 kPa", "peak pfd: 2.00 m", "peak pfv: 10.00 m/s",
                         "pressure > 1 kPa: area 16 m2, run-out 6.0 m along the path"):
            if expected not in said:
                sys.exit(f"expected '{expected}' in:\n{said}")
        again = subprocess.run([sys.executable, TOOL, "--raster", os.path.join(folder, "peak_ppr.asc"), "--path", path,
                                "--threshold", "0.1"], check=True, capture_output=True, text=True).stdout
        if "area 32 m2, run-out 10.0 m" not in again:
            sys.exit(again)


if __name__ == "__main__":
    main()
