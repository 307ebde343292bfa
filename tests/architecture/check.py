#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
"""Holds the tree against resources/docs/architecture.md: include arrows, cycles, file and function sizes, type names, headers.

usage: check.py ROOT [--figures]
"""
import os
import re
import statistics
import sys

# Folder -> folders it may include from, besides itself.
CORE_DATA = ["core/base", "core/math", "core/physics", "core/fields"]
CORE_SIM = CORE_DATA + ["core/property", "core/nodes", "core/sim"]
SCENE = CORE_SIM + ["core/scene"]
SDK = SCENE + ["plugins/sdk"]
ARROWS = {
    "core/base": [],
    "core/math": ["core/base"],
    "core/physics": ["core/base", "core/math"],
    "core/fields": ["core/base", "core/math"],
    "core/rigid": CORE_DATA,
    "core/sph": CORE_DATA + ["core/rigid"],
    "core/property": ["core/base", "core/math", "core/fields"],
    "core/nodes": ["core/base", "core/math", "core/property"],
    "core/sim": CORE_DATA + ["core/property", "core/nodes"],
    "core/snow": CORE_SIM,
    "core/flake": ["core/base", "core/math", "core/sim"],
    "core/flow": CORE_SIM + ["core/rigid", "core/sph"],
    "core/air": CORE_DATA + ["core/sim"],
    "core/cloud": CORE_SIM + ["core/air", "core/flow", "core/rigid", "core/snow", "core/sph"],
    "core/processes": CORE_SIM + ["core/snow", "core/flow", "core/cloud"],
    "core/raycast": CORE_DATA,
    "core/bench": CORE_SIM + ["core/air", "core/cloud", "core/snow", "core/flake", "core/flow", "core/rigid", "core/sph", "core/raycast", "core/processes", "gpu"],
    "core/scene": CORE_SIM + ["core/flake"],
    "gpu": CORE_SIM + ["core/air", "core/rigid", "core/snow", "core/sph"],
    "plugins/sdk": SCENE,
    "plugins/host": SDK,
    "plugins/gdal_common": SDK,
    "plugins/import_helper": SDK + ["plugins/host"],
    "editor/render": CORE_SIM + ["core/snow", "core/flake"],
    "editor/cli": SDK + ["core/air", "core/cloud", "core/flow", "core/sph", "core/snow", "core/flake", "plugins/host", "editor/render", "core/raycast", "core/bench", "gpu"],
    "editor/document": SDK + ["plugins/host"],
    "editor/commands": SDK + ["editor/document"],
    "editor/models": SDK + ["editor/document", "editor/commands"],
    "editor/panels": SDK + ["core/flake", "editor/document", "editor/commands", "editor/models"],
    "editor/timeline": SDK + ["editor/document", "editor/commands", "editor/models"],
    "editor/viewport": SDK + ["core/flake", "editor/document", "editor/commands", "editor/render"],
    "editor/app": SDK + ["plugins/host", "core/raycast", "core/flake", "core/flow", "core/cloud", "editor/cli", "editor/document", "editor/commands", "editor/models",
                         "editor/panels", "editor/timeline", "editor/viewport", "editor/render"],
}
PLUGIN_ARROWS = SDK + ["plugins/gdal_common"]  # every other folder under plugins/
MAX_FILE, MAX_FILE_95, MAX_FUNCTION, MAX_FUNCTION_95 = 600, 400, 80, 40
SOURCE = (".h", ".cpp", ".cu", ".cuh")
HEADED = SOURCE + (".cmake", ".py", ".sh", ".vert", ".frag", ".geom", ".comp", ".glsl")
NOT_A_FUNCTION = re.compile(r"^(template\s*<.*>\s*)?(inline\s+|constexpr\s+|static\s+|constinit\s+|const\s+)*(namespace|class|struct|enum|union|using|extern)\b")


def sources(root, tops, endings):
    for top in tops:
        for folder, dirs, files in os.walk(os.path.join(root, top)):
            dirs.sort()
            for name in sorted(files):
                if name.endswith(endings):
                    yield os.path.relpath(os.path.join(folder, name), root)


def folder_of(path):
    parts = path.split("/")
    return parts[0] if parts[0] == "gpu" else "/".join(parts[:2])


def allowed(folder):
    if folder in ARROWS:
        return ARROWS[folder]
    return PLUGIN_ARROWS if folder.startswith("plugins/") else None


def check_arrows(path, includes, problems):
    folder = folder_of(path)
    may = allowed(folder)
    if may is None:
        problems.append(f"{path}: folder {folder} is not in the table of arrows; add it with the folders it may include")
        return
    for target in includes:
        there = folder_of(target)
        if there != folder and there not in may:
            problems.append(f"{path}: includes {target}, but {folder} may not include from {there}")


def check_cycles(graph, problems):
    state = {}

    def visit(node, trail):
        state[node] = 1
        for target in graph.get(node, []):
            if state.get(target) == 1:
                problems.append("include cycle: " + " -> ".join(trail[trail.index(target):] + [target]) if target in trail else f"include cycle at {target}")
            elif target not in state:
                visit(target, trail + [target])
        state[node] = 2

    for node in sorted(graph):
        if node not in state:
            visit(node, [node])


def strip_code(text):
    """Blanks strings, characters and comments, keeping line breaks, so that braces can be counted."""
    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)


def functions(text):
    """(first line, last line) of every function body at namespace or class level."""
    lines = strip_code(text).split("\n")
    stack, found = [], []
    for number, line in enumerate(lines):
        for char in line:
            if char == "{":
                stack.append(number)
            elif char == "}" and stack:
                opened = stack.pop()
                start = opened
                while start > 0 and lines[start - 1].strip() and not re.search(r"[;{}:]\s*$", lines[start - 1]) and not lines[start - 1].lstrip().startswith("#"):
                    start -= 1
                head = " ".join(l.strip() for l in lines[start:opened + 1]).split("{")[0]
                indent = len(lines[start]) - len(lines[start].lstrip())
                control = re.match(r"^(if|for|while|switch|do|else|return|case|try|catch)\b", head) or "= [" in head or re.search(r"=\s*$", head)
                if "(" in head and indent <= 4 and not NOT_A_FUNCTION.match(head) and not control and not head.startswith("}"):
                    found.append((start + 1, number + 1))
    return [f for f in found if not any(o != f and o[0] <= f[0] and f[1] <= o[1] for o in found)]


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0


def check_sources(root, problems):
    file_sizes, function_sizes, graph = {}, {}, {}
    for path in sources(root, ["core", "gpu", "plugins", "editor"], SOURCE):
        text = open(os.path.join(root, path), encoding="utf-8").read()
        includes = [i for i in re.findall(r'^\s*#include "([^"]+)"', text, re.M) if os.path.exists(os.path.join(root, i))]
        graph[path] = includes
        check_arrows(path, includes, problems)
        file_sizes[path] = text.count("\n")
        for first, last in functions(text):
            function_sizes[f"{path}:{first}"] = last - first + 1
    check_cycles(graph, problems)
    for path, size in file_sizes.items():
        if size > MAX_FILE:
            problems.append(f"{path}: {size} lines, the limit is {MAX_FILE}")
    for place, size in function_sizes.items():
        if size > MAX_FUNCTION:
            problems.append(f"{place}: a function of {size} lines, the limit is {MAX_FUNCTION}")
    if percentile(file_sizes.values(), 0.95) > MAX_FILE_95:
        problems.append(f"more than 5 % of the files are longer than {MAX_FILE_95} lines")
    if percentile(function_sizes.values(), 0.95) > MAX_FUNCTION_95:
        problems.append(f"more than 5 % of the functions are longer than {MAX_FUNCTION_95} lines")
    return file_sizes, function_sizes


def check_names(root, problems):
    """Two types of one name in different headers link to one destructor, whichever the linker keeps."""
    places = {}
    opening = re.compile(r"^(?:namespace ([\w:]+) \{|(?:class|struct) (\w+)(?: final)?(?: :[^;{]*)? \{)", re.M)
    for path in sources(root, ["core", "gpu", "plugins", "editor"], (".h", ".cuh")):
        namespace = ""
        for match in opening.finditer(strip_code(open(os.path.join(root, path), encoding="utf-8").read())):
            namespace = match.group(1) or namespace
            if match.group(2) and "SPIN_ISA" not in namespace:  # one body per instruction set, by intention
                places.setdefault(f"{namespace}::{match.group(2)}", []).append(path)
    for name, paths in places.items():
        if len(paths) > 1:
            problems.append(f"{name} is defined in {' and '.join(paths)}; types of one namespace need names of their own")


def check_headers(root, problems):
    for path in sources(root, ["core", "gpu", "plugins", "editor", "tests", "resources", "translations"], HEADED):
        if "__pycache__" in path:
            continue
        head = open(os.path.join(root, path), encoding="utf-8").read(400)
        if "SPDX-License-Identifier: Apache-2.0" not in head:
            problems.append(f"{path}: the two SPDX lines are missing at the top")


def check_unfinished(root, problems):
    word = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
    for path in sources(root, ["core", "gpu", "plugins", "editor", "tests"], SOURCE):
        for number, line in enumerate(open(os.path.join(root, path), encoding="utf-8"), 1):
            if word.search(line):
                problems.append(f"{path}:{number}: unfinished work is marked in the code; finish it or file it")


def main():
    root = sys.argv[1]
    problems = []
    file_sizes, function_sizes = check_sources(root, problems)
    check_names(root, problems)
    check_headers(root, problems)
    check_unfinished(root, problems)
    print(f"{len(file_sizes)} files, median {statistics.median(file_sizes.values()):.0f} lines, 95 % {percentile(file_sizes.values(), 0.95)}, "
          f"longest {max(file_sizes.values())}; {len(function_sizes)} functions, 95 % {percentile(function_sizes.values(), 0.95)} lines, "
          f"longest {max(function_sizes.values())}")
    if "--figures" in sys.argv:
        for table in (file_sizes, function_sizes):
            for name, size in sorted(table.items(), key=lambda item: -item[1])[:12]:
                print(f"  {size:5d}  {name}")
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
