#!/usr/bin/env python3
"""Runs the benchmarks and prints their numbers as a table: key, value, unit, target.

Two sources, one table. Programs of bench/ called bench_GROUP measure a part and print lines
"key value unit target" (bench/report.h). SCENES below measure whole renders through the command
line, from the JSON that --stats writes.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# (group, scene, options, target for millions of samples per core and second)
SCENES = (
    ("cornell", "examples/cornell.lua",
     ["--size", "512x512", "--samples", "64", "--render", "max_depth=8"], ">=0.9"),
    ("mesh", "bench/scenes/million_triangles.lua", [], ">=0.75"),
)


def rows_of_program(path):
    output = subprocess.run([path], check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in output.splitlines():
        key, value, unit, target = line.split()
        yield key, float(value), unit, target


def rows_of_scene(lapidary, group, scene, options, target):
    with tempfile.TemporaryDirectory() as folder:
        stats_file = pathlib.Path(folder) / "stats.json"
        subprocess.run([lapidary, "render", ROOT / scene, "-o", pathlib.Path(folder) / "out.exr",
                        "--stats", stats_file, "--quiet", *options], check=True)
        stats = json.loads(stats_file.read_text())
    core_seconds = stats["seconds"]["render"] * stats["threads"]
    width, height = stats["size"]
    samples = stats["samples_per_pixel"] * width * height
    yield f"{group}.msamples_per_core", samples / core_seconds / 1e6, "M/s", target
    yield f"{group}.mrays_per_core", stats["rays"] / core_seconds / 1e6, "M/s", "-"
    yield f"{group}.peak_rss", stats["peak_rss_bytes"] / 2**20, "MiB", "-"


def meets(value, target):
    if target == "-":
        return True
    limit = float(target[2:])
    return value >= limit if target.startswith(">=") else value <= limit


def measure(build, wanted):
    """Yields (key, value, unit, target) of the group `wanted`, or of all."""
    groups = {path.name.removeprefix("bench_"): path
              for path in sorted(build.glob("bench_*")) if path.is_file()}
    known = sorted(set(groups) | {scene[0] for scene in SCENES})
    if wanted and wanted not in known:
        sys.exit(f"bench: no group '{wanted}'; there are {', '.join(known)}")
    for group, path in groups.items():
        if wanted in (None, group):
            yield from rows_of_program(path)
    for scene in SCENES:
        if wanted in (None, scene[0]):
            yield from rows_of_scene(build / "lapidary", *scene)


def main():
    parser = argparse.ArgumentParser(prog="./dev bench", description="Measures, prints a table.")
    parser.add_argument("group", nargs="?", help="one group only, e.g. cornell")
    parser.add_argument("--json", metavar="FILE", help="also write {key: {value, unit, target}}")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release",
                        help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    table = {}
    for key, value, unit, target in measure(arguments.build, arguments.group):
        note = "" if meets(value, target) else "  missed"
        print(f"{key:<32} {value:>12.4g}  {unit:<10} {target}{note}", flush=True)
        table[key] = {"value": value, "unit": unit, "target": target}
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(table, indent=2) + "\n")


if __name__ == "__main__":
    main()
