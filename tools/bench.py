#!/usr/bin/env python3
"""Runs the benchmarks and prints their numbers as a table: key, value, unit, target.

Programs of bench/ called bench_GROUP measure a part and print lines "key value unit target"
(bench/report.h). SCENES below measure whole renders through the command line, from the JSON that
--stats writes; the group "cli" measures the command line itself.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import resource
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
INTERRUPTED = 4  # the exit code of a render that Ctrl-C ended
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


@dataclasses.dataclass(frozen=True)
class CausticScene:
    """A scene that caustics are judged on."""
    file: str
    region: str               # the caustic: X,Y,W,H
    reference_seconds: int    # of each half
    targets: dict             # seconds: (whole, caustic) of "auto"
    options: tuple = ()


CAUSTIC_SCENES = {
    "lens": CausticScene("bench/scenes/lens.lua", "110,140,150,105", 700,
                         {25: ("<=1e-4", "<=1e-3"), 100: ("<=3e-5", "<=3e-4")}),
    "cornell": CausticScene("bench/scenes/cornell_glass.lua", "150,222,65,26", 350,
                            {10: ("<=0.0057", "-"), 25: ("-", "-"), 35: ("<=0.0021", "-")}),
    "prism": CausticScene("examples/rainbow.lua", "180,50,70,100", 350, {},
                          ("--size", "400x225")),
    "pool": CausticScene("examples/pool.lua", "80,40,240,120", 350, {}, ("--size", "400x225")),
}
CAUSTIC_SECONDS = (5, 10, 25, 100)
# Plain progressive photon mapping is what photons were before they were aimed or shared out.
CAUSTIC_METHODS = {
    "auto": (),
    "photons": ("--render", "caustics=photons"),
    "paths": ("--render", "caustics=paths"),
    "plain": ("--render", "caustics=photons", "--render", "photon_aim=none", "--render",
              "sampling=uniform"),
}


def processor_seconds(process):
    """What a process has taken so far; nothing once it has ended."""
    try:
        fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    except FileNotFoundError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def render_for(build, scene, out, seconds, seed, options):
    """Renders on one thread until that much processor time is gone, as Ctrl-C would end it: on a
    machine that does other things too, wall time says little. What it took."""
    stats = out.with_suffix(".json")
    command = [build / "lapidary", "render", ROOT / scene.file, "-o", out, "--stats", stats,
               "--quiet", "--threads", "1", "--samples", "1000000", "--seed", str(seed),
               *scene.options, *options]
    with subprocess.Popen(command) as process:
        while process.poll() is None and processor_seconds(process) < seconds:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
    if process.returncode not in (0, INTERRUPTED):
        raise subprocess.CalledProcessError(process.returncode, command)
    return json.loads(stats.read_text())["cpu_seconds"]


def rows_of_caustics(build, wanted, references):
    """The error of caustics at equal processor time, for two hours: only by its name, or that of
    one scene. Errors leave out the worst 0.1 % of the pixels; "caustic" is the region that holds
    it.

    The reference is two renders, with smaller radii, whose own errors are independent: half of
    their difference is that of each, and is taken from the mean difference to both."""
    for name, scene in CAUSTIC_SCENES.items():
        if wanted not in ("caustics", f"caustics.{name}"):
            continue
        halves = [references / f"{name}.{half}.exr" for half in "ab"]
        for seed, half in enumerate(halves, 901):
            if not half.exists():
                unfinished = half.with_suffix(".part.exr")
                render_for(build, scene, unfinished, scene.reference_seconds, seed,
                           ("--render", "photon_radius=1.4"))
                unfinished.rename(half)

        def compared(a, b, *options):
            text = subprocess.run([build / "lapidary", "compare", a, b, *options], check=True,
                                  stdout=subprocess.PIPE, text=True).stdout
            return float(text.split()[1])

        places = {"whole": (), "caustic": ("--crop", scene.region)}
        own = {place: 0.5 * compared(*halves, "--trim", "0.001", *crop)
               for place, crop in places.items()}
        for place, error in own.items():
            yield f"caustics.{name}.reference.{place}", 0.5 * error, "rel", "-"
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "picture.exr"
            for seconds in sorted({*CAUSTIC_SECONDS, *scene.targets}):
                for method, options in CAUSTIC_METHODS.items():
                    key = f"caustics.{name}.{seconds}s.{method}"
                    taken = render_for(build, scene, picture, seconds, 1, options)
                    yield f"{key}.cpu", taken, "s", "-"
                    targets = scene.targets.get(seconds, ("-", "-"))
                    for (place, crop), target in zip(places.items(), targets):
                        error = statistics.mean(compared(picture, half, "--trim", "0.001", *crop)
                                                for half in halves) - own[place]
                        yield (f"{key}.{place}", error, "rel",
                               target if method == "auto" else "-")
                    energy = statistics.mean(compared(picture, half, "--metric", "energy",
                                                      "--crop", scene.region) for half in halves)
                    yield f"{key}.energy", energy, "1", "-"


def rows_of_light_radius(build):
    """How much worse "auto" is than the better of photons and paths for lamps of several sizes over
    the lens: errors times processor time, against pictures of many times the samples."""
    lens, seconds = CAUSTIC_SCENES["lens"], 12
    for radius in (0.05, 0.3, 1.0):
        sized = ("--set", f"radius={radius}")
        with tempfile.TemporaryDirectory() as folder:
            reference = pathlib.Path(folder) / "reference.exr"
            picture = pathlib.Path(folder) / "picture.exr"

            def error(*options):
                text = subprocess.run([build / "lapidary", "compare", picture, reference, "--trim",
                                       "0.001", *options], check=True, stdout=subprocess.PIPE,
                                      text=True).stdout
                return float(text.split()[1])

            render_for(build, lens, reference, 8 * seconds, 101, sized)
            costs = {}
            for method in ("auto", "photons", "paths"):
                taken = render_for(build, lens, picture, seconds, 1,
                                   (*sized, *CAUSTIC_METHODS[method]))
                costs[method] = (taken * error(), taken * error("--crop", lens.region))
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


def rows_of_ranks(build):
    """The throughput of two ranks with a thread each over that of one process with two: the median
    of pairs, of wall time, and of processor time with that of waiting for messages."""
    if shutil.which("mpirun") is None:
        print("bench: no mpirun, so nothing is known of ranks", file=sys.stderr)
        return
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1",
                   "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}

    def run(folder, launcher, threads):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([*launcher, build / "lapidary", "render", ROOT / "examples/cornell.lua",
                        "-o", folder / "out.exr", "--stats", folder / "stats.json", "--quiet",
                        "--size", "512x512", "--samples", "64", "--render", "max_depth=8",
                        "--threads", str(threads)], check=True, env=environment)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        stats = json.loads((folder / "stats.json").read_text())
        assert stats["ranks"] * stats["threads"] == 2, "both should have two threads in all"
        return (stats["seconds"]["render"],
                after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)

    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        pairs = [(run(folder, [], 2),
                  run(folder, ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", "2"], 1))
                 for _ in range(5)]
    for what, i, target in (("throughput", 0, ">=0.9"), ("per_cpu", 1, "-")):
        yield (f"ranks.two.{what}", statistics.median(one[i] / two[i] for one, two in pairs), "x",
               target)


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


def measure(build, wanted, references):
    """Yields (key, value, unit, target) of the group `wanted`, or of all that take minutes."""
    groups = {path.name.removeprefix("bench_"): path
              for path in sorted(build.glob("bench_*")) if path.is_file()}
    of_caustics = ["caustics", *(f"caustics.{name}" for name in CAUSTIC_SCENES)]
    known = sorted({*groups, *of_caustics, "caustics.light_radius", "cli", *(scene.group for scene in SCENES)})
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
    if wanted in (None, "ranks"):
        yield from rows_of_ranks(build)
    if wanted in of_caustics:
        with tempfile.TemporaryDirectory() as folder:
            yield from rows_of_caustics(build, wanted, references or pathlib.Path(folder))
    if wanted in ("caustics", "caustics.light_radius"):
        yield from rows_of_light_radius(build)
    if wanted in (None, "cli"):
        yield from rows_of_command_line(build)


def main():
    parser = argparse.ArgumentParser(prog="./dev bench", description="Measures, prints a table.")
    parser.add_argument("group", nargs="?", help="one group only, e.g. cornell")
    parser.add_argument("--peers", action="store_true",
                        help="group csg: also run POV-Ray on the same models, for minutes")
    parser.add_argument("--json", metavar="FILE", help="also write {key: {value, unit, target}}")
    parser.add_argument("--references", metavar="FOLDER", type=pathlib.Path,
                        help="group caustics: keep the references there, and use those that are")
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
        show(measure(arguments.build, arguments.group, arguments.references))
        if arguments.peers:
            show(rows_of_peers(arguments.build, table))
    except subprocess.CalledProcessError as error:
        sys.exit(f"bench: {pathlib.Path(error.cmd[0]).name} ended with {error.returncode}")
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(table, indent=2) + "\n")


if __name__ == "__main__":
    main()
