#!/usr/bin/env python3
"""The command line as users run it: exit codes, messages, files.

usage: program_test.py PATH/TO/lapidary [unittest's arguments]
"""

import json
import math
import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

LAPIDARY = None  # set by main
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"

BALL = """
return scene {
  camera = perspective { from = {0, -5, 1}, at = {0, 0, 0}, fov = 40 },
  lights = { sphere_light { center = {0, 0, 6}, radius = 0.5, power = 300 } },
  objects = { sphere { radius = param("radius", 1) } },
  render = { size = {24, 16}, samples = 2 },
}
"""

TETRAHEDRON = """
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
"""


# What gives photons much, or nothing, to do.
PHOTONS = """
local kind = param("kind", "lens")
local floor = rectangle { corner = {-4, -4, 0}, edge_u = {8, 0, 0}, edge_v = {0, 8, 0},
                          material = matte() }
local lamp = sphere_light { center = {0, 0, 4}, radius = 0.2, power = kind == "dark" and 0 or 100 }
local hull = box { min = {-1, -1, 3}, max = {1, 1, 5} } -
             box { min = {-0.9, -0.9, 3.1}, max = {0.9, 0.9, 4.9} }
local objects = { floor, sphere { center = {0, 0, 1}, radius = 0.8, material = glass(1.5) } }
if kind == "boxed" then objects[3] = hull:material(matte()) end
if kind == "mirrors" then
  objects = { sphere { material = metal "silver" },
              box { min = {-3, -3, -2}, max = {3, 3, -1}, material = metal "gold" } }
end
if kind == "flat" then objects[2] = mesh { file = "flat.obj", material = glass(1.5) } end
if kind == "flat lamp" then
  objects[3] = mesh { file = "flat.obj", material = emissive { power = 100 } }
end
if kind == "cut lamp" then
  lamp = nil
  objects[3] = (sphere { center = {0, 0, 4}, radius = 0.2 } &
                sphere { center = {3, 0, 4}, radius = 0.2 }):material(emissive { power = 100 })
end
return scene {
  camera = perspective { from = {0, -6, 3}, at = {0, 0, 0.5} },
  lights = { lamp }, objects = objects, render = { size = {32, 24}, samples = 4 },
}
"""


class ProgramTest(unittest.TestCase):
    """Runs the program in a folder of its own."""

    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return name

    def start(self, *arguments):
        return subprocess.Popen([LAPIDARY, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def wait_for_block(self, program):
        """Until a render that shows its progress as JSON has done another block."""
        while '"progress"' not in (line := program.stderr.readline()):
            self.assertTrue(line, "it ended before")

    def run_program(self, *arguments):
        return subprocess.run([LAPIDARY, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=120, check=False)

    def succeed(self, *arguments):
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def fail_with(self, code, *arguments):
        """The one error message of a run that leaves no file behind."""
        before = sorted(self.folder.iterdir())
        done = self.run_program(*arguments)
        self.assertEqual(done.returncode, code, (arguments, done.stdout, done.stderr))
        self.assertEqual(done.stderr.count("error:"), 1, done.stderr)
        self.assertEqual(sorted(self.folder.iterdir()), before)
        return done.stderr


def png_size(path):
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


class Help(ProgramTest):
    def test_lists_verbs_and_nodes(self):
        text = self.succeed("help").stdout
        for word in ("render", "check", "probe", "compare", "sphere", "glass", "perspective"):
            self.assertIn(word, text)
        self.assertEqual(text, self.succeed("--help").stdout)

    def test_explains_a_node_and_a_verb(self):
        self.assertIn("radius", self.succeed("help", "sphere").stdout)
        self.assertIn("--samples", self.succeed("help", "render").stdout)
        self.assertEqual(self.succeed("help", "check").stdout,
                         self.succeed("check", "--help").stdout)

    def test_explains_the_verb_and_the_node_of_one_name(self):
        text = self.succeed("help", "render").stdout
        self.assertTrue(text.startswith(self.succeed("render", "--help").stdout))
        self.assertIn("filter_radius", text)
        self.assertIn("max_depth", text)

    def test_fits_a_terminal(self):
        for topic in ((), ("metal",), ("distant_light",), ("mesh",)):
            for line in self.succeed("help", *topic).stdout.splitlines():
                if not line.startswith("    "):  # examples stay whole
                    self.assertLessEqual(len(line), 80, line)

    def test_suggests_a_node(self):
        self.assertIn("sphere", self.fail_with(2, "help", "spere"))

    def test_states_its_version(self):
        self.assertRegex(self.succeed("--version").stdout, r"^lapidary \d+\.\d+\.\d+\n$")

    def test_hints_at_what_was_meant(self):
        self.write("a.lua", BALL)
        for arguments, message in (
                (("rendr", "a.lua"), "did you mean 'render'?"),
                (("a.lua",), "did you mean: lapidary render a.lua"),
                (("-v",), "without a verb there are --help and --version"),
                (("render", "a.lua", "--samples"), "error: --samples needs a value\n"),
                (("render", "a.lua", "--sample", "3"), "did you mean '--samples'?")):
            self.assertIn(message, self.fail_with(2, *arguments))
        self.assertIn("did you mean 'a.lua'?", self.fail_with(3, "render", "aa.lua"))

    def test_wrong_usage(self):
        self.write("a.lua", BALL)
        for arguments in ((), ("paint",), ("render",), ("render", "a.lua", "--speed", "3"),
                          ("render", "a.lua", "--samples", "0"),
                          ("render", "a.lua", "--samples", "many"),
                          ("render", "a.lua", "--size", "0x0"),
                          ("render", "a.lua", "--size", "1000000x1000000"),
                          ("render", "a.lua", "--size", "wide"),
                          ("render", "a.lua", "--time", "nan"),
                          ("render", "a.lua", "--noise", "-1"),
                          ("render", "a.lua", "--render", "smoothness=3"),
                          ("render", "a.lua", "--integrator", "magic"),
                          ("render", "a.lua", "--up", "z"),
                          ("compare", "a.png")):
            self.fail_with(2, *arguments)


class Render(ProgramTest):
    def test_writes_the_scenes_name_with_png(self):
        self.write("ball.lua", BALL)
        done = self.succeed("render", "ball.lua")
        self.assertEqual(done.stdout, "")
        self.assertEqual(png_size(self.folder / "ball.png"), (24, 16))
        self.assertNotIn("\x1b", done.stderr)

    def test_writes_every_format(self):
        self.write("ball.lua", BALL)
        names = ["a.png", "b.exr", "c.jpg", "d.hdr"]
        self.succeed("render", "ball.lua", *(word for name in names for word in ("-o", name)))
        for name in names:
            self.assertGreater((self.folder / name).stat().st_size, 100, name)

    def test_options_override_the_scene(self):
        self.write("ball.lua", BALL)
        self.succeed("render", "ball.lua", "--size", "8x6", "--samples", "5", "--stats", "s.json",
                     "--threads", "1", "--set", "radius=0.5", "--render", "max_depth=2")
        self.assertEqual(png_size(self.folder / "ball.png"), (8, 6))
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(stats["samples_per_pixel"], 5)
        self.assertEqual(stats["threads"], 1)

    def test_states_what_it_took(self):
        self.write("ball.lua", BALL)
        self.succeed("render", "ball.lua", "--stats", "s.json", "--samples", "16")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(set(stats["seconds"]), {"load", "build", "photons", "render", "write"})
        self.assertEqual(stats["scene"],
                         {"objects": 2, "operands": 2, "triangles": 0, "lights": 1})
        self.assertGreaterEqual(stats["rays"], 24 * 16 * 16)
        self.assertEqual(stats["nan_samples"], 0)
        self.assertGreater(stats["peak_rss_bytes"], 1_000_000)
        self.assertGreater(stats["cpu_seconds"], 0)
        self.assertGreater(stats["noise"], 0)

    def test_states_how_many_photons_there_were_and_their_memory(self):
        self.write("lens.lua", PHOTONS)
        self.succeed("render", "lens.lua", "--stats", "s.json", "--samples", "8")
        stats = json.loads((self.folder / "s.json").read_text())
        photons = stats["photons"]
        self.assertGreater(photons["left"], 0)
        self.assertGreaterEqual(photons["emitted"], photons["traced"])
        # Of a block of 4 passes, with tables of at most four times their 64 bytes each.
        self.assertGreater(photons["bytes"], 64 * photons["left"] / 2 * 0.5)
        self.assertLess(photons["bytes"], 4 * 64 * photons["left"])
        self.assertIsNone(stats["map_photons"])
        self.succeed("render", "lens.lua", "--stats", "s.json", "--samples", "1", "--render",
                     "integrator=illumination", "--render", "map_photons=30000")
        stats = json.loads((self.folder / "s.json").read_text())
        maps = stats["map_photons"]
        self.assertEqual(maps["emitted"], 30000)
        self.assertGreater(maps["left"], 0)
        self.assertGreater(maps["maps"], 0)
        self.assertEqual(maps["bytes"], 16 * maps["texels"])
        self.assertEqual(stats["photons"], {"emitted": 0, "traced": 0, "left": 0, "bytes": 0})

    def test_is_silent_when_asked(self):
        self.write("ball.lua", BALL)
        self.assertEqual(self.succeed("render", "ball.lua", "--quiet").stderr, "")

    def test_progress_as_json(self):
        self.write("ball.lua", BALL)
        self.write("talks.lua", "print('words')\n" + BALL)
        done = self.succeed("render", "talks.lua", "--progress", "json", "--samples", "32")
        events = [json.loads(line) for line in done.stderr.splitlines()]
        states = [event for event in events if event["event"] == "progress"]
        self.assertGreater(len(states), 1)
        self.assertEqual(states[-1]["samples_per_pixel"], 32)
        self.assertEqual(states[-1]["fraction"], 1)
        self.assertEqual([e["phase"] for e in events if e["event"] == "phase"],
                         ["load", "build", "photons", "render", "write"])
        self.assertIn({"event": "note", "text": "words"}, events)
        self.assertEqual(events[-1]["event"], "picture")
        self.assertEqual(events[-1]["file"], "talks.png")

    def test_errors_as_json(self):
        self.write("bad.lua", "return scene { objects = { sphere { radius = -1 } } }")
        done = self.run_program("render", "bad.lua", "--progress", "json")
        self.assertEqual(done.returncode, 3)
        error = json.loads(done.stderr.splitlines()[-1])
        self.assertEqual((error["event"], error["file"], error["line"], error["parameter"]),
                         ("error", "bad.lua", 1, "radius"))
        self.assertIn("text", error)

    def test_stops_by_the_clock_even_if_the_scene_says_samples(self):
        self.write("ball.lua", BALL)
        self.succeed("render", "ball.lua", "--time", "0.3", "--stats", "s.json")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertGreater(stats["samples_per_pixel"], 2)
        self.assertLess(stats["seconds"]["render"], 3)

    def test_puts_a_bare_mesh_into_a_studio(self):
        self.write("shape.obj", TETRAHEDRON)
        self.succeed("render", "shape.obj", "--size", "16x12", "--samples", "1")
        self.assertEqual(png_size(self.folder / "shape.png"), (16, 12))
        self.succeed("render", "shape.obj", "--size", "16x12", "--samples", "1", "--up", "z")

    def test_same_bits_for_any_number_of_threads(self):
        self.write("ball.lua", BALL)
        for threads in ("1", "2", "3"):
            self.succeed("render", "ball.lua", "--threads", threads, "-o", f"{threads}.exr")
            done = self.succeed("compare", f"{threads}.exr", "1.exr", "--metric", "mse")
            self.assertEqual(done.stdout, "mse 0\n")

    def test_same_bits_of_maps_for_any_number_of_threads(self):
        self.write("cornell.lua", (EXAMPLES / "cornell.lua").read_text())
        for threads in ("1", "3"):
            self.succeed("render", "cornell.lua", "--threads", threads, "-o", f"{threads}.exr",
                         "--integrator", "illumination", "--size", "32x32", "--samples", "4",
                         "--render", "map_photons=20000")
        self.assertEqual(self.succeed("compare", "3.exr", "1.exr", "--metric", "mse").stdout,
                         "mse 0\n")


class BadInput(ProgramTest):
    SCENES = {
        "empty file": ("", "returns no scene"),
        "malformed Lua": ("return scene {", "bad.lua:1"),
        "endless loop": ("while true do end", "bad.lua:1"),
        "unknown node": ("return scene { objects = { spere { radius = 1 } } }", "sphere"),
        "unknown parameter": ("return scene { objects = { sphere { raduis = 1 } } }", "radius"),
        "wrong type": ("return scene { objects = { sphere { radius = 'big' } } }", "radius"),
        "not a number": ("return scene { objects = { sphere { radius = 0/0 } } }", "radius"),
        "infinite": ("return scene { objects = { sphere { center = {1/0, 0, 0} } } }", "center"),
        "zero radius": ("return scene { objects = { sphere { radius = 0 } } }", "radius"),
        "singular": ("return scene { objects = { sphere {}:scale { 1, 0, 1 } } }", "bad.lua:1"),
        "camera at its target": ("return scene { camera = perspective { from = {1, 2, 3}, "
                                 "at = {1, 2, 3} }, objects = { sphere {} } }", "bad.lua:1"),
        "size 0x0": ("return scene { objects = { sphere {} }, render = { size = {0, 0} } }",
                     "size"),
        "huge size": ("return scene { objects = { sphere {} }, "
                      "render = { size = {65536, 65536} } }", "65536"),
        "too many materials": ("local m = matte 'red' for i = 1, 20 do m = blend { m, m } end "
                               "return scene { objects = { sphere { material = m } } }",
                               "more than 1000"),
        "materials too deep": ("local m = matte 'red' for i = 1, 5000 do m = coated(m) end "
                               "return scene { objects = { sphere { material = m } } }",
                               "more than 1000"),
        "missing mesh": ("return scene { objects = { mesh { file = 'gone.obj' } } }", "gone.obj"),
    }

    def test_each_scene_gets_one_clear_error(self):
        for name, (text, fragment) in self.SCENES.items():
            with self.subTest(name):
                self.write("bad.lua", text)
                self.assertIn(fragment, self.fail_with(3, "render", "bad.lua"))

    def test_nothing_takes_the_place_of_what_is_read_or_written(self):
        self.write("plain.lua", "return scene { objects = { sphere {} } }")
        small = ("--size", "8x8", "--samples", "8", "--quiet")
        self.succeed("render", "plain.lua", "-o", "wood.png", *small)
        self.succeed("render", "plain.lua", "-o", "part.exr", "--blocks", "1-1", *small[:2])
        self.write("s.lua", "return scene { objects = { sphere { "
                            "material = matte { color = image 'wood.png' } } } }")
        os.symlink("s.lua", self.folder / "link.json")
        before = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        for arguments, fragment in (
                (("s.lua", "-o", "a.png", "--stats", "./s.lua"), "would replace the scene"),
                (("s.lua", "-o", "a.png", "--stats", "link.json"), "would replace the scene"),
                (("s.lua", "-o", "a.png", "--stats", "a.png"), "are one file"),
                (("s.lua", "-o", "a.png", "-o", "a.png"), "are one file"),
                (("s.lua", "-o", "wood.png"), "a file that the scene reads"),
                (("s.lua", "-o", "a.png", "--preview", "wood.png", "--checkpoint", "0"),
                 "a file that the scene reads"),
                (("plain.lua", "-o", "part.exr", "--blocks", "2-2", "--plan", "part.exr"),
                 "would replace --plan")):
            with self.subTest(arguments):
                self.assertIn(fragment, self.fail_with(2, "render", *arguments))
                after = {path.name: path.read_bytes() for path in self.folder.iterdir()}
                self.assertEqual(before, after)

    def test_folders_that_a_scene_may_read_are_there(self):
        self.write("plain.lua", "return scene { objects = { sphere {} } }")
        self.assertIn("no such folder", self.fail_with(2, "check", "plain.lua", "--allow", "gone"))

    def test_a_number_of_photons_is_one_that_memory_holds(self):
        self.write("lens.lua", PHOTONS)
        for photons, fragment in (("0", "from 1"), ("-5", "from 1"), ("2e9", "from 1"),
                                  ("1000000000", "GB")):
            with self.subTest(photons):
                code = 2 if fragment == "from 1" else 3
                self.assertIn(fragment, self.fail_with(
                    code, "render", "lens.lua", "--render", "integrator=illumination", "--render",
                    "map_photons=" + photons))
                self.assertIn(fragment, self.fail_with(code, "bake", "lens.lua", "--photons",
                                                       photons))

    # What there is to say of a scene in which photons, or all light, have nowhere to go.
    NOWHERE = {
        "dark": "no light of the scene sends out anything",
        "cut lamp": "the scene has no light",
        "boxed": "no photon",
        "mirrors": "",
    }

    def test_photons_that_have_nowhere_to_go_end(self):
        self.write("lens.lua", PHOTONS)
        for kind, fragment in self.NOWHERE.items():
            for options in ((), ("--render", "caustics=photons"),
                            ("--render", "integrator=illumination", "--render",
                             "map_photons=20000")):
                with self.subTest(kind, options=options):
                    said = self.succeed("render", "lens.lua", "--set", "kind=" + kind, *options,
                                        "--stats", "s.json", "--quiet").stderr
                    stats = json.loads((self.folder / "s.json").read_text())
                    self.assertEqual(stats["photons"]["left"], 0)
                    # Once, and nothing of mirrors alone: their picture lacks nothing.
                    is_map = "integrator=illumination" in options
                    if fragment and not (kind == "boxed" and is_map):
                        self.assertEqual(said.count(fragment), 1, said)

    def test_surfaces_without_area_are_refused(self):
        self.write("lens.lua", PHOTONS)
        self.write("flat.obj", "v 0 0 1\nv 1 0 1\nv 2 0 1\nf 1 2 3\nf 1 1 2\n")
        for kind in ("flat", "flat lamp"):
            for verb in ("render", "bake"):
                with self.subTest(kind, verb=verb):
                    self.assertIn("zero area", self.fail_with(3, verb, "lens.lua", "--set",
                                                              "kind=" + kind))

    MESHES = {
        "empty file": "",
        "no triangles": "v 0 0 0\nv 1 0 0\n",
        "index out of range": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
        "not a number": "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    }

    def test_each_mesh_gets_one_clear_error(self):
        for name, text in self.MESHES.items():
            with self.subTest(name):
                self.write("bad.obj", text)
                self.assertIn("bad.obj", self.fail_with(3, "render", "bad.obj"))

    def test_missing_and_unknown_files(self):
        self.write("picture.gif", "GIF89a")
        for file in ("gone.lua", "gone.obj", "picture.gif", "."):
            self.fail_with(3, "render", file)
        self.fail_with(3, "compare", "gone.png", "picture.gif")
        self.fail_with(3, "check", "gone.lua")

    def test_output_that_cannot_be_written_is_found_before_rendering(self):
        self.write("ball.lua", BALL)
        for output in ("nowhere/a.png", "a.tiff", "a", "."):
            with self.subTest(output):
                self.fail_with(3, "render", "ball.lua", "-o", output, "--samples", "1000000")
        self.fail_with(3, "render", "ball.lua", "--stats", "nowhere/s.json", "--samples", "1000000")

    def test_an_unused_parameter_is_an_error(self):
        self.write("ball.lua", BALL)
        self.assertIn("radius", self.fail_with(3, "render", "ball.lua", "--set", "raduis=2"))


class Compare(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("ball.lua", BALL)
        self.succeed("render", "ball.lua", "-o", "a.exr", "-o", "a.png")
        self.succeed("render", "ball.lua", "-o", "b.exr", "--seed", "1")

    def test_prints_metric_and_value(self):
        for metric in ("relmse", "mse", "mae", "flip"):
            self.assertEqual(self.succeed("compare", "a.exr", "a.exr", "--metric", metric).stdout,
                             f"{metric} 0\n")
            name, value = self.succeed("compare", "a.exr", "b.exr", "--metric",
                                       metric).stdout.split()
            self.assertEqual(name, metric)
            self.assertGreater(float(value), 0)

    def test_energy_is_a_ratio(self):
        self.assertEqual(self.succeed("compare", "a.exr", "a.exr", "--metric", "energy").stdout,
                         "energy 1\n")
        ratio = float(self.succeed("compare", "a.exr", "b.exr",
                                   "--metric", "energy").stdout.split()[1])
        self.assertNotEqual(ratio, 1)
        self.assertAlmostEqual(ratio, 1, delta=0.5)

    def test_black_reference_has_no_energy(self):
        self.assertIn("black", self.fail_with(3, "compare", "a.exr", "b.exr", "--metric", "energy",
                                              "--crop", "2,3,4,5"))

    def test_crops_and_trims(self):
        whole = float(self.succeed("compare", "a.exr", "b.exr").stdout.split()[1])
        trimmed = float(self.succeed("compare", "a.exr", "b.exr", "--trim", "0.1").stdout.split()[1])
        self.assertLess(trimmed, whole)
        self.succeed("compare", "a.exr", "b.exr", "--crop", "2,3,4,5")
        self.fail_with(3, "compare", "a.exr", "b.exr", "--crop", "20,10,10,10")

    def test_sizes_must_agree(self):
        self.succeed("render", "ball.lua", "--size", "8x8", "-o", "small.png")
        self.fail_with(3, "compare", "a.png", "small.png")


ROOM = """
local quad = mesh "quad.obj"
return scene {
  camera = perspective { from = {0, -5, 1}, at = {0, 0, 0}, fov = 40 },
  lights = { sphere_light { center = {0.3, 0, 3}, radius = 0.2, power = 100 } },
  objects = {
    rectangle { corner = {-2, -2, 0}, edge_u = {4, 0, 0}, edge_v = {0, 4, 0} }:name "the floor",
    (sphere { center = {-1, 0, 0.5}, radius = 0.5 } - box { min = {-2, -2, 0.6}, max = {2, 2, 2} })
      :name "Bowl/1",
    cylinder { from = {1, 0, 0}, to = {1, 0, 1}, radius = 0.3, name = "bowl_1" },
    quad:translate { 0, 1, 0.2 }:name "own",
    mesh "tetrahedron.obj":translate { 0, -1.5, 0.1 },
  },
  render = { size = {24, 16}, samples = 2 },
}
"""

QUAD = """
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3 4/4
"""


class Bake(ProgramTest):
    def room(self):
        self.write("quad.obj", QUAD)
        self.write("tetrahedron.obj", TETRAHEDRON)
        return self.write("room.lua", ROOM)

    def index(self, folder):
        return json.loads((self.folder / folder / "index.json").read_text())

    def test_writes_an_image_for_each_surface(self):
        self.succeed("bake", self.room(), "-o", "maps", "--photons", "20000", "--radius", "0.3")
        index = self.index("maps")
        self.assertEqual(index["unit"], "W/m2")
        self.assertEqual(index["radius"], 0.3)
        maps = {entry["image"]: entry for entry in index["maps"]}
        files = {p.name for p in (self.folder / "maps").iterdir()}
        meshes = {m["mapping"]["mesh"] for m in maps.values() if "mesh" in m["mapping"]}
        self.assertEqual(files, set(maps) | meshes | {"index.json"})
        floor = maps["the_floor.exr"]
        self.assertEqual(floor["mapping"]["kind"], "plane")
        for found, expected in zip(floor["mapping"]["origin"], (-2, -2, 0)):
            self.assertAlmostEqual(found, expected)
        self.assertEqual(floor["ends"], {"u": "border", "v_low": "border", "v_high": "border"})
        # Names differ by more than the case of their letters.
        folded = [name.lower() for name in files]
        self.assertEqual(len(folded), len(set(folded)))
        self.assertTrue(any(name.startswith("bowl_1") for name in folded))
        kinds = {entry["object"]: entry["mapping"]["kind"] for entry in maps.values()}
        self.assertEqual(kinds["own"], "own_uvs")
        self.assertIn("atlas", kinds.values())
        ball = next(m for m in maps.values() if m["surface"] == "sphere")
        self.assertEqual(ball["ends"], {"u": "seam", "v_low": "pole", "v_high": "pole"})
        lattice = ball["mapping"]["lattice"]
        self.assertEqual(len(lattice["points"]), lattice["columns"] * lattice["rows"])
        for x, y, z in filter(None, lattice["points"]):
            self.assertAlmostEqual(math.dist((x, y, z), (-1, 0, 0.5)), 0.5)

    def test_an_atlas_comes_with_its_mesh(self):
        self.succeed("bake", self.room(), "-o", "maps", "--photons", "20000")
        entry = next(m for m in self.index("maps")["maps"] if m["mapping"]["kind"] == "atlas")
        lines = (self.folder / "maps" / entry["mapping"]["mesh"]).read_text().splitlines()
        uvs = [tuple(map(float, line.split()[1:])) for line in lines if line.startswith("vt ")]
        self.assertEqual(len(uvs), 12)
        self.assertEqual(sum(line.startswith("f ") for line in lines), 4)
        self.assertTrue(all(0 <= c <= 1 for uv in uvs for c in uv))

        def area(a, b, c):
            return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        triangles = [uvs[i:i + 3] for i in range(0, 12, 3)]
        for i, triangle in enumerate(triangles):
            middle = tuple(sum(p[k] for p in triangle) / 3 for k in (0, 1))
            for j, (a, b, c) in enumerate(triangles):
                inside = min(area(a, b, middle), area(b, c, middle), area(c, a, middle)) > 0
                self.assertEqual(inside, i == j)

    def test_is_the_same_for_any_number_of_threads(self):
        scene = self.room()
        for threads in "1", "3":
            self.succeed("bake", scene, "-o", "t" + threads, "--photons", "5000", "--threads",
                          threads, "--quiet")
        for path in (self.folder / "t1").iterdir():
            self.assertEqual(path.read_bytes(), (self.folder / "t3" / path.name).read_bytes())

    def test_says_what_there_is_not_to_bake(self):
        def complaint(lights, material, *options):
            scene = self.write("s.lua", """
              return scene {
                camera = perspective { from = {0, -5, 1}, at = {0, 0, 0} },
                lights = { %s },
                objects = { sphere { radius = 1, material = %s } },
              }""" % (lights, material))
            return self.fail_with(3, "bake", scene, "-o", "maps", "--photons", "1000", *options)
        lamp = "point_light { position = {0, 0, 4}, power = 50 }"
        self.assertIn("no light sends out anything",
                      complaint("point_light { position = {0, 0, 4}, power = 0 }", "matte()"))
        self.assertIn("no photon of all light", complaint(lamp, "metal 'gold'"))
        self.assertIn("no photon of all light",
                      complaint("point_light { position = {0, 0, 0}, power = 50 }", "matte()"))
        self.assertIn("no photon of caustics light",
                      complaint(lamp, "matte()", "--light", "caustics"))
        self.assertIn("texels", complaint(lamp, "matte()", "--resolution", "1e7"))

    def test_wrong_options(self):
        scene = self.room()
        for option, value in (("--photons", "0"), ("--radius", "-1"), ("--filter", "round"),
                              ("--light", "blue"), ("--format", "gif"), ("--resolution", "0")):
            self.fail_with(2, "bake", scene, option, value)
        self.write("file", "")
        self.assertIn("cannot be made", self.fail_with(3, "bake", scene, "-o", "file/maps"))


class Check(ProgramTest):
    def test_says_what_is_there(self):
        self.write("ball.lua", BALL)
        text = self.succeed("check", "ball.lua").stdout
        self.assertIn("ball.lua: 1 object, 1 operand, 0 triangles, 1 light\n", text)
        self.assertIn("12.566", text)  # the unit sphere's area
        self.assertIn("4.1887", text)  # and its volume

    def test_lists_lights_apart_from_objects(self):
        self.write("scene.lua", "return scene { objects = { sphere {}, "
                                "disk_light { center = {0, 0, 5}, at = {0, 0, 0}, power = 5, "
                                "name = 'lamp' } }, lights = { environment {}, "
                                "{ point_light { power = 3 } } } }")
        text = self.succeed("check", "scene.lua").stdout
        self.assertIn("1 object, 1 operand, 0 triangles, 3 lights\n", text)
        objects, lights = text.split("light\n", 1)
        self.assertNotIn("disk", objects)
        self.assertRegex(lights, r"disk +3\.14159 +'lamp' \(scene\.lua:1\)\n")
        self.assertRegex(lights, r"environment +- +environment \(scene\.lua:1\)\n")
        self.assertRegex(lights, "point_light")
        self.assertNotIn("sphere", lights)

    def test_finds_overlaps_and_open_meshes(self):
        self.write("open.obj", TETRAHEDRON.replace("f 3 1 4\n", ""))
        self.write("scene.lua", "return scene { objects = { sphere {}:name 'one', "
                                "sphere { center = {1, 0, 0} }:name 'two', "
                                "mesh { file = 'open.obj', name = 'sheet' }, "
                                "mesh { file = 'open.obj', material = glass(1.5), "
                                "name = 'vessel' } } }")
        text = self.succeed("check", "scene.lua").stdout
        self.assertRegex(text, "mesh +3  3 open .*'sheet'")
        problems = text.split("meshes to look at:\n")[1]
        self.assertRegex(problems, "'vessel' .*: made of glass, but not closed: 3 open edges, one ")
        self.assertNotIn("sheet", problems)
        self.assertRegex(text, "'one'.* and 'two'")

    def test_what_the_scene_prints_stands_before_the_table(self):
        self.write("ball.lua", "print('hello')  print('again')" + BALL)
        done = subprocess.run([LAPIDARY, "check", "ball.lua"], cwd=self.folder, check=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertTrue(done.stdout.startswith("hello\nagain\nball.lua: 1 object"), done.stdout)

    def test_warns_of_a_light_that_faces_away(self):
        scene = ("return scene { objects = { sphere {}, plane { point = {0, 0, -1} } },\n"
                 "lights = { rectangle_light { center = {0, 0, 4}, normal = {0, 0, %d}, "
                 "power = 9 } }, render = { size = {4, 4}, samples = 1 } }")
        self.write("up.lua", scene % 1)
        self.write("down.lua", scene % -1)
        for verb in ("check", "render"):
            warning = self.succeed(verb, "up.lua").stderr.splitlines()[0]
            self.assertTrue(warning.startswith("warning: up.lua:2: the light faces away"), warning)
            self.assertNotIn("warning", self.succeed(verb, "down.lua").stderr)

    def test_measures_combinations(self):
        self.write("scene.lua", "return scene { objects = { (box { size = {2, 2, 2} } - sphere {} "
                                "- sphere { center = {9, 0, 0} }):name 'worn' } }")
        text = self.succeed("check", "scene.lua").stdout
        row = re.search(r"difference +0  yes +(\S+) ±(\S+) +(\S+) ±(\S+)  'worn'", text)
        area, area_error, volume, volume_error = map(float, row.groups())
        self.assertAlmostEqual(area, 24 + 4 * math.pi, delta=0.04 + 4 * area_error)
        self.assertAlmostEqual(volume, 8 - 4 / 3 * math.pi, delta=0.004 + 4 * volume_error)
        self.assertIn("3 operands, 1 of them clipped away; from {-1, -1, -1} to {1, 1, 1}", text)

    def test_sees_what_the_section_leaves(self):
        self.write("scene.lua", "return scene { objects = { sphere {} }, section = half_space {} }")
        text = self.succeed("check", "scene.lua").stdout
        self.assertAlmostEqual(float(re.search(r"(\S+) ±\S+  sphere ", text)[1]),
                               2 / 3 * math.pi, delta=0.02)
        self.assertIn("2 operands, 0 of them clipped away; from {-1, -1, -1} to {1, 1, 1}", text)

    def test_says_where_an_unbounded_solid_has_no_end(self):
        self.write("scene.lua", "return scene { objects = { half_space {} - "
                                "box { size = {2, 2, 2} } } }")
        text = self.succeed("check", "scene.lua").stdout
        self.assertRegex(text, "difference +0  yes +unbounded +unbounded ")
        self.assertIn("unbounded: nothing in it ends it towards +x, -x, +y, -y, -z, so that", text)

    def test_names_operands_that_do_nothing(self):
        self.write("scene.lua", "return scene { objects = { box { size = {2, 2, 2} } + "
                                "sphere { radius = 0.5 } } }")
        self.assertIn("operands that add no surface, by 256 lines each: 1 (sphere)\n",
                      self.succeed("check", "scene.lua").stdout)

    def test_overlaps_count_between_opaque_bodies(self):
        self.write("scene.lua", "local a = box { size = {2, 2, 2} } - sphere { radius = 0.9 }\n"
                                "local core = sphere { radius = %s }:material(%s):name 'core'\n"
                                "return scene { objects = { a:name 'shell', core } }")
        text = (self.folder / "scene.lua").read_text()
        for radius, material, overlap in (("0.9", "matte {}", False), ("1.1", "matte {}", True),
                                          ("1.1", "glass(1.5)", False)):
            self.write("scene.lua", text % (radius, material))
            shared = "share a part" in self.succeed("check", "scene.lua").stdout
            self.assertEqual(shared, overlap, (radius, material))

    def test_warns_of_what_is_empty_and_of_a_buried_camera(self):
        self.write("scene.lua", "local cube = box { size = {2, 2, 2} }\n"
                                "return scene { camera = perspective { from = {0, 0, 0}, "
                                "at = {1, 0, 0} },\n objects = { cube - ~cube,\n"
                                "(cube - cube):name 'gone' }, "
                                "render = { size = {4, 4}, samples = 1 } }")
        for verb in ("check", "render"):
            errors = self.succeed(verb, "scene.lua").stderr
            self.assertIn("warning: scene.lua:4: nothing is left of the difference 'gone'", errors)
            self.assertRegex(errors, "warning: scene.lua:2: the camera stands inside of the "
                                     "difference, which is opaque; .* ~box")
            self.assertEqual(errors.count("warning"), 2, errors)

    def test_a_camera_in_a_room_is_fine(self):
        self.write("scene.lua", "return scene { camera = perspective { from = {0, 0, 0}, "
                                "at = {1, 0, 0} }, objects = { ~box { size = {2, 2, 2} } } }")
        self.assertEqual(self.succeed("check", "scene.lua").stderr, "")

    def test_refuses_what_a_renderer_refuses(self):
        self.write("bad.lua", "return scene { objects = { sphere { radius = -1 } } }")
        self.fail_with(3, "check", "bad.lua")


class Probe(ProgramTest):
    SCENE = """
    local hole = cylinder { from = {0, 0, -5}, to = {0, 0, 5}, radius = 0.5 }
    return scene { objects = {
      (box { size = {4, 2, 2} } - hole):name 'plate',
      sphere { center = {5, 0, 0}, radius = 1, material = glass "N-BK7", name = "ball" },
      disk { center = {7, 0, 0}, normal = {-1, 0, 0}, radius = 1, name = "screen" } } }
    """

    def hits(self, *arguments):
        return [json.loads(line)["hits"]
                for line in self.succeed("probe", *arguments).stdout.splitlines()]

    def test_lists_every_surface_along_a_ray(self):
        self.write("a.lua", self.SCENE)
        hits = self.hits("a.lua", "--ray", "-10,0,0,2,0,0")[0]
        self.assertEqual(hits[0], {
            "t": 4, "object": "plate", "leaf": 0, "kind": "box", "normal": [-1, 0, 0],
            "enter": True, "medium_before": "outside", "medium_after": "plate"})
        self.assertEqual([h["t"] for h in hits], [4, 4.75, 5.25, 6, 7, 8, 8.5])
        self.assertEqual([h["enter"] for h in hits], [True, False, True, False, True, False, True])
        self.assertEqual([h["leaf"] for h in hits], [0, 1, 1, 0, 0, 0, 0])
        self.assertEqual(hits[4]["medium_after"], "N-BK7")
        self.assertEqual(hits[6], {
            "t": 8.5, "object": "screen", "leaf": 0, "kind": "disk", "normal": [-1, 0, 0],
            "enter": True, "medium_before": "outside", "medium_after": "outside"})

    def test_reads_many_rays(self):
        self.write("a.lua", self.SCENE)
        self.write("rays.txt", "0 0 9 0 0 -1\n\n-10,0,0,1,0,0\r\n  1 0 9  0 0 -3")
        hits = self.hits("a.lua", "--rays", "rays.txt")
        self.assertEqual([len(h) for h in hits], [0, 7, 2])
        self.assertEqual(self.succeed("probe", "a.lua", "--ray", "0,0,9,0,0,-1").stdout,
                         '{"hits":[]}\n')

    def test_a_bare_mesh_stands_in_no_studio(self):
        self.write("shape.obj", TETRAHEDRON)
        hits = self.hits("shape.obj", "--up", "z", "--ray", "0.2,0.2,9,0,0,-1")[0]
        self.assertEqual([h["kind"] for h in hits], ["triangle"] * 2)
        self.assertAlmostEqual(hits[0]["t"], 9 - 0.6, 6)
        self.assertAlmostEqual(hits[1]["t"], 9, 6)

    def test_bad_rays_get_one_clear_error(self):
        self.write("a.lua", self.SCENE)
        for ray in ("1,2,3,4,5", "1,2,3,0,0,0", "up", "", "1,2,3,4,5,nan"):
            self.assertIn("--ray takes", self.fail_with(2, "probe", "a.lua", "--ray", ray))
        self.fail_with(2, "probe", "a.lua")
        self.write("r.txt", "0 0 0 0 0 1\n")
        self.fail_with(2, "probe", "a.lua", "--ray", "0,0,0,0,0,1", "--rays", "r.txt")
        self.fail_with(3, "probe", "gone.lua", "--ray", "0,0,0,0,0,1")
        for text, where in (("", "r.txt: "), (" \n\n", "r.txt: "), ("hello", "r.txt:1: "),
                            ("0 0 0 0 0 1\n\n1 2 3 4 5\n", "r.txt:3: "),
                            ("0 0 0 0 0 1\n0 0 0 0 0 0", "r.txt:2: ")):
            self.write("r.txt", text)
            self.assertIn("error: " + where, self.fail_with(3, "probe", "a.lua", "--rays", "r.txt"))
        self.fail_with(3, "probe", "a.lua", "--rays", "gone.txt")
        self.fail_with(3, "probe", "a.lua", "--rays", ".")


class Interrupt(ProgramTest):
    def test_ends_with_the_picture_so_far(self):
        self.write("ball.lua", BALL)
        program = self.start("render", "ball.lua", "--samples", "16000000", "--progress", "json",
                             "--stats", "s.json", "--threads", "2")
        self.addCleanup(program.kill)
        self.wait_for_block(program)
        program.send_signal(signal.SIGINT)
        errors = program.communicate(timeout=60)[1]
        self.assertEqual(program.returncode, 4)
        event = json.loads(errors.splitlines()[-1])
        self.assertEqual((event["event"], event["ended"]), ("picture", "interrupted"))
        self.assertEqual(png_size(self.folder / "ball.png"), (24, 16))
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(stats["ended"], "interrupted")
        self.assertEqual(stats["threads"], 2)
        self.assertGreater(stats["samples_per_pixel"], 0)

    def test_asked_twice_it_ends_at_once(self):
        self.write("ball.lua", BALL)
        program = self.start("render", "ball.lua", "--samples", "16000000", "--size", "400x300",
                             "--progress", "json")
        self.addCleanup(program.kill)
        self.wait_for_block(program)
        program.send_signal(signal.SIGINT)
        time.sleep(0.02)
        program.send_signal(signal.SIGINT)
        program.communicate(timeout=60)
        self.assertEqual(program.returncode, 4)

    def test_leaves_nothing_temporary_behind(self):
        self.write("ball.lua", BALL)
        program = self.start("render", "ball.lua", "--samples", "16000000", "--progress", "json")
        self.addCleanup(program.kill)
        self.wait_for_block(program)
        program.send_signal(signal.SIGTERM)
        program.communicate(timeout=60)
        self.assertEqual(sorted(os.listdir(self.folder)),
                         ["ball.checkpoint.exr", "ball.lua", "ball.png"])


if __name__ == "__main__":
    LAPIDARY = os.path.abspath(sys.argv.pop(1))
    unittest.main()
