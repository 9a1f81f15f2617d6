#!/usr/bin/env python3
"""Runs the benchmarks and prints their numbers as a table: key, value, unit, target.

Programs of bench/ called bench_GROUP measure a part and print lines "key value unit target"
(bench/report.h). SCENES below measure whole renders through the command line, from the JSON that
--stats writes; the group "cli" measures the command line itself.
"""

import argparse
import dataclasses
import json
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PEERS = ("perforated.1000", "tree.8", "tree.10", "menger.4")  # models, quick ones first


@dataclasses.dataclass(frozen=True)
class Scene:
    """A scene to render, and the least it should reach."""
    group: str
    file: str
    options: tuple
    msamples: str  # millions of samples per core and second
    peak_mb: str = "-"
    needs_blob: bool = False  # the mesh that build/.../write_blob writes


SCENES = (
    Scene("cornell", "examples/cornell.lua",
          ("--size", "512x512", "--samples", "64", "--render", "max_depth=8"), ">=0.9"),
    Scene("mesh", "bench/scenes/million_triangles.lua", (), ">=0.75", "<=250", needs_blob=True),
)


def rows_of_program(path):
    output = subprocess.run([path], check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in output.splitlines():
        key, value, unit, target = line.split()
        yield key, float(value), unit, target


def render(build, scene, folder):
    """The statistics of rendering `scene`; files go to `folder`."""
    options = [*scene.options]
    if scene.needs_blob:
        subprocess.run([build / "write_blob", folder / "blob.obj"], check=True)
        options += ["--set", f"mesh={folder}/blob.obj", "--allow", folder]
    subprocess.run([build / "lapidary", "render", ROOT / scene.file, "-o", folder / "out.exr",
                    "--stats", folder / "stats.json", "--quiet", *options], check=True)
    return json.loads((folder / "stats.json").read_text())


def rows_of_scene(build, scene):
    with tempfile.TemporaryDirectory() as folder:
        stats = render(build, scene, pathlib.Path(folder))
    core_seconds = stats["render_cpu_seconds"]  # fair on a machine that does other things, too
    yield f"{scene.group}.msamples_per_core", stats["samples"] / core_seconds / 1e6, "M/s", scene.msamples
    yield f"{scene.group}.mrays_per_core", stats["rays"] / core_seconds / 1e6, "M/s", "-"
    yield f"{scene.group}.noise", stats["noise"], "rel", "-"
    yield f"{scene.group}.peak_rss", stats["peak_rss_bytes"] / 1e6, "MB", scene.peak_mb


def rows_of_lights(build):
    """The error of choosing one of 10,000 lamps by a hierarchy and by power, at equal processor
    time, against a picture of many more samples."""
    scene = Scene("lights", "bench/scenes/many_lights.lua", (), "-")
    samples = 16
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)

        def picture(name, choice, samples, seed):
            options = ("--samples", str(samples), "--seed", str(seed),
                       "--render", f"light_choice={choice}", "--render", "sampling=uniform")
            stats = render(build, dataclasses.replace(scene, options=options), folder)
            (folder / "out.exr").rename(folder / name)
            return stats["render_cpu_seconds"]

        def error(name):
            text = subprocess.run([build / "lapidary", "compare", folder / name,
                                   folder / "reference.exr"], check=True, stdout=subprocess.PIPE,
                                  text=True).stdout
            return float(text.split()[1])

        by_tree = picture("tree.exr", "tree", samples, 1)
        by_power = picture("power.exr", "power", samples, 1)
        picture("power.exr", "power", max(1, round(samples * by_tree / by_power)), 1)
        picture("reference.exr", "tree", 24 * samples, 2)
        hierarchy, power = error("tree.exr"), error("power.exr")
    yield "lights.10000.relmse_hierarchy", hierarchy, "rel", "-"
    yield "lights.10000.relmse_power", power, "rel", "-"
    yield "lights.10000.error_ratio", power / hierarchy, "x", ">=5"


def rows_of_caustics(build):
    """The error of caustics at equal processor time, against pictures of many more samples whose
    own error is the first row of each scene. For a quarter of an hour: only by its name.

    Errors leave out the worst 0.1 % of the pixels; "caustic" is the region that holds it."""
    scenes = {"lens": ("bench/scenes/lens.lua", "110,140,150,105", ((5, "-", "-"),
                       (25, "<=1e-4", "<=1e-3"), (100, "<=3e-5", "<=3e-4"))),
              "cornell": ("bench/scenes/cornell_glass.lua", "150,222,65,26",
                          ((10, "<=0.0057", "-"), (35, "<=0.0021", "-")))}
    for name, (file, region, budgets) in scenes.items():
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)

            def picture(out, method, seconds, seed):
                """On one thread; the processor time that it took."""
                options = ("--time", str(seconds), "--samples", "1000000", "--seed", str(seed),
                           "--threads", "1", "--render", f"caustics={method}")
                stats = render(build, Scene(name, file, options, "-"), folder)
                (folder / "out.exr").rename(folder / out)
                return stats["cpu_seconds"]

            def compared(a, b, *options):
                text = subprocess.run([build / "lapidary", "compare", folder / a, folder / b,
                                       *options], check=True, stdout=subprocess.PIPE,
                                      text=True).stdout
                return float(text.split()[1])

            def errors(a, b):
                trim = ("--trim", "0.001")
                return compared(a, b, *trim), compared(a, b, *trim, "--crop", region)

            long = 4 * budgets[-1][0]
            picture("reference.exr", "auto", long, 101)
            picture("half.exr", "auto", long, 102)
            whole, caustic = errors("half.exr", "reference.exr")
            yield f"caustics.{name}.reference.whole", 0.5 * whole, "rel", "-"
            yield f"caustics.{name}.reference.caustic", 0.5 * caustic, "rel", "-"
            for seconds, whole_target, caustic_target in budgets:
                for method in ("auto", "photons", "paths"):
                    taken = picture("picture.exr", method, seconds, 1)
                    whole, caustic = errors("picture.exr", "reference.exr")
                    key = f"caustics.{name}.{seconds}s.{method}"
                    yield f"{key}.cpu", taken, "s", "-"
                    is_auto = method == "auto"
                    yield f"{key}.whole", whole, "rel", whole_target if is_auto else "-"
                    yield f"{key}.caustic", caustic, "rel", caustic_target if is_auto else "-"
                    energy = compared("picture.exr", "reference.exr", "--metric", "energy", "--crop",
                                      region)
                    yield f"{key}.energy", energy, "1", "-"


def rows_of_light_radius(build):
    """How much worse "auto" is than the better of photons and paths for lamps of several sizes over
    the lens: errors times processor time, against pictures of many times the samples."""
    region, seconds = "110,140,150,105", 12
    for radius in (0.05, 0.3, 1.0):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)

            def picture(out, method, seconds, seed):
                options = ("--set", f"radius={radius}", "--time", str(seconds), "--samples",
                           "1000000", "--seed", str(seed), "--threads", "1", "--render",
                           f"caustics={method}")
                stats = render(build, Scene("lens", "bench/scenes/lens.lua", options, "-"), folder)
                (folder / "out.exr").rename(folder / out)
                return stats["cpu_seconds"]

            def error(*options):
                text = subprocess.run([build / "lapidary", "compare", folder / "picture.exr",
                                       folder / "reference.exr", "--trim", "0.001", *options],
                                      check=True, stdout=subprocess.PIPE, text=True).stdout
                return float(text.split()[1])

            picture("reference.exr", "auto", 8 * seconds, 101)
            costs = {}
            for method in ("auto", "photons", "paths"):
                taken = picture("picture.exr", method, seconds, 1)
                costs[method] = (taken * error(), taken * error("--crop", region))
        for i, part in enumerate(("whole", "caustic")):
            best = min(costs["photons"][i], costs["paths"][i])
            yield (f"caustics.light_radius.{radius:g}.{part}", costs["auto"][i] / best, "x",
                   "<=1.3")


def rows_of_pictures(build):
    """What share of the time of rendering a room goes to the large pictures on its walls: against
    the same room in the colours these have on average, the median of pairs."""
    scene = Scene("texture", "bench/scenes/pictured_room.lua", (), "-")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        plain = []
        for seed, wall in enumerate(("floor", "back", "left", "right")):
            mean = subprocess.run([build / "write_picture", folder / f"{wall}.png", str(seed)],
                                  check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
            plain += ["--set", f"{wall}={mean}"]
        pictured = ("--set", f"pictures={folder}", "--allow", folder)

        def seconds(options):
            options = (*options, "--threads", "1", "--render", "sampling=uniform")
            return render(build, dataclasses.replace(scene, options=options),
                          folder)["render_cpu_seconds"]

        pairs = [(seconds(pictured), seconds(plain)) for _ in range(5)]
    yield ("texture.room_overhead", statistics.median(1 - b / a for a, b in pairs), "share",
           "<=0.15")


def rows_of_command_line(build):
    def start():
        begin = time.perf_counter()
        subprocess.run([build / "lapidary", "help"], check=True, stdout=subprocess.DEVNULL)
        return time.perf_counter() - begin

    yield "cli.help_start", 1e3 * statistics.median(start() for _ in range(21)), "ms", "<=30"


def povray_seconds(scene, folder):
    """Processor seconds that POV-Ray takes to trace a scene at 800x600 on one thread."""
    (folder / "scene.pov").write_text(scene)

    def seconds(width, height):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run(["povray", "+Iscene.pov", "+Oout.png", "+FN", f"+W{width}", f"+H{height}",
                        "-A", "-D", "-V", "+WT1"], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

    return seconds(800, 600) - seconds(4, 3)  # less starting and parsing


def rows_of_peers(build, table):
    """How many times as long as ours POV-Ray takes for the same pictures."""
    if shutil.which("povray") is None:
        sys.exit("bench: --peers needs POV-Ray; Debian's packages are povray and povray-includes")
    for model in PEERS:
        scene = subprocess.run([build / "bench_csg", "--povray", model], check=True,
                               stdout=subprocess.PIPE, text=True).stdout
        with tempfile.TemporaryDirectory() as folder:
            theirs = povray_seconds(scene, pathlib.Path(folder))
        ours = table[f"csg.{model}.picture_seconds"]["value"]
        yield f"csg.vs_povray.{model.replace('.', '_')}", theirs / ours, "x", "-"


def meets(value, target):
    if target == "-":
        return True
    limit = float(target[2:])
    return value >= limit if target.startswith(">=") else value <= limit


def measure(build, wanted):
    """Yields (key, value, unit, target) of the group `wanted`, or of all."""
    groups = {path.name.removeprefix("bench_"): path
              for path in sorted(build.glob("bench_*")) if path.is_file()}
    known = sorted({*groups, "caustics", "cli", *(scene.group for scene in SCENES)})
    if wanted and wanted not in known:
        sys.exit(f"bench: no group '{wanted}'; there are {', '.join(known)}")
    for group, path in groups.items():
        if wanted in (None, group):
            yield from rows_of_program(path)
    for scene in SCENES:
        if wanted in (None, scene.group):
            yield from rows_of_scene(build, scene)
    if wanted in (None, "lights"):
        yield from rows_of_lights(build)
    if wanted in (None, "texture"):
        yield from rows_of_pictures(build)
    if wanted == "caustics":
        yield from rows_of_caustics(build)
        yield from rows_of_light_radius(build)
    if wanted in (None, "cli"):
        yield from rows_of_command_line(build)


def main():
    parser = argparse.ArgumentParser(prog="./dev bench", description="Measures, prints a table.")
    parser.add_argument("group", nargs="?", help="one group only, e.g. cornell")
    parser.add_argument("--peers", action="store_true",
                        help="group csg: also run POV-Ray on the same models, for minutes")
    parser.add_argument("--json", metavar="FILE", help="also write {key: {value, unit, target}}")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release",
                        help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.peers and arguments.group not in (None, "csg"):
        parser.error("--peers measures the group csg")
    table = {}

    def show(rows):
        for key, value, unit, target in rows:
            note = "" if meets(value, target) else "  missed"
            print(f"{key:<32} {value:>12.4g}  {unit:<10} {target}{note}", flush=True)
            table[key] = {"value": value, "unit": unit, "target": target}

    try:
        show(measure(arguments.build, arguments.group))
        if arguments.peers:
            show(rows_of_peers(arguments.build, table))
    except subprocess.CalledProcessError as error:
        sys.exit(f"bench: {pathlib.Path(error.cmd[0]).name} ended with {error.returncode}")
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(table, indent=2) + "\n")


if __name__ == "__main__":
    main()
