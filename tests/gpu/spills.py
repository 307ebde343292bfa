#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Fails if a CUDA kernel of the particle solver spills registers or keeps a stack.

Usage: spills.py NVCC ARCHITECTURE SOURCE_DIR. Needs the compiler, no card.
Prints one line per kernel of ours: registers, stack, spilled bytes.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ENTRY = re.compile(r"Compiling entry function '(\S+)'")
MEMORY = re.compile(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads")
REGISTERS = re.compile(r"Used (\d+) registers")
REQUIRED = ("DensityPass", "ShearPass", "PlainForcePass", "SmoothForcePass", "ContinuityForcePass", "SmoothContinuityForcePass", "IntegrateKernel", "PressureKernel",
            "BodyDensityKernel", "BodyRateKernel", "BodyPressureKernel", "BodyRubKernel", "BodyReactionKernel",
            "BodyConstraintKernel", "BodyDivergenceKernel", "BodySolvePushKernel", "BodySolveLoadKernel",
            "ConstraintPass", "DivergencePass", "PressurePushPass", "ViscousProductPass", "StressPass")


def kernels(report):
    """Yields (mangled name, stack, spilled, registers) for each kernel that ptxas reports."""
    name, memory = None, None
    for line in report.splitlines():
        if match := ENTRY.search(line):
            name, memory = match.group(1), None
        elif match := MEMORY.search(line):
            memory = [int(group) for group in match.groups()]
        elif (match := REGISTERS.search(line)) and name and memory is not None:
            yield name, memory[0], memory[1] + memory[2], int(match.group(1))
            name = None


def main():
    nvcc, architecture, root = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    number = re.match(r"\d+a?", architecture)
    arch = f"sm_{number.group(0)}" if number else "sm_90"
    with tempfile.TemporaryDirectory() as folder:
        command = [nvcc, "-std=c++20", "-O3", "-DNDEBUG", f"-arch={arch}", "-I", str(root), "-Xptxas", "-v",
                   "--expt-relaxed-constexpr", "-cubin", str(root / "tests/gpu/flow_kernels.cu"),
                   "-o", str(pathlib.Path(folder) / "flow.cubin")]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"nvcc failed:\n{done.stderr}")
    found, bad = set(), []
    for name, stack, spilled, registers in kernels(done.stdout + done.stderr):
        # A pair pass is named by what it sums, any other kernel by itself.
        short = next((part for part in re.findall(r"\d+([A-Za-z]+(?:Pass|Kernel))", name)
                      if part not in ("forEachKernel", "PairKernel")), None)
        if short is None or "spin" not in name:
            continue
        found.add(short)
        print(f"{arch} {short}: {registers} registers, {stack} bytes of stack, {spilled} bytes spilled")
        if stack or spilled:
            bad.append(short)
    missing = [name for name in REQUIRED if name not in found]
    if missing:
        sys.exit(f"no report for {', '.join(missing)}")
    if bad:
        sys.exit(f"spills or stack in {', '.join(bad)}")


if __name__ == "__main__":
    main()
