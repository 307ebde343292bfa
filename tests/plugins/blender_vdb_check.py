# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Run by Blender: reads the sequence fall.0000.vdb to fall.0002.vdb of a folder and checks what it sees."""
import os
import sys

import bpy

folder = sys.argv[sys.argv.index("--") + 1]
files = sorted(name for name in os.listdir(folder) if name.endswith(".vdb"))
bpy.ops.object.volume_import(
    filepath=os.path.join(folder, files[0]), directory=folder, files=[{"name": name} for name in files], align="WORLD"
)
volume = bpy.context.object.data
assert volume.is_sequence and volume.frame_duration == 3, (volume.is_sequence, volume.frame_duration)
bpy.context.scene.frame_set(volume.frame_start)
assert volume.grids.load(), volume.grids.error_message
kinds = {grid.name: grid.data_type for grid in volume.grids}
assert kinds == {
    "density": "FLOAT",
    "mist": "FLOAT",
    "snow": "FLOAT",
    "temperature": "FLOAT",
    "velocity": "VECTOR_FLOAT",
}, kinds
for grid in volume.grids:
    assert grid.load(), grid.name
    size = [round(grid.matrix_object[k][k], 6) for k in range(3)]
    assert size == [0.5, 0.5, 0.5], size
print("read", len(kinds), "grids of", len(files), "frames")
