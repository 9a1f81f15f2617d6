#!/usr/bin/env python3
"""Renders that several processes share, as users start them: with mpirun.

usage: ranks_test.py PATH/TO/lapidary [unittest's arguments]
"""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

import program_test
from long_render_test import LongRenderTest

# More ranks than processors, by whoever runs the tests. Sanitizers see what MPI never frees.
LAUNCHER = ["mpirun", "--oversubscribe", "--bind-to", "none"]
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "ASAN_OPTIONS": "detect_leaks=0"}


def children(pid):
    """The processes that one has started, in the order in which it did."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            text = stat.read_text()
            if int(text.rpartition(")")[2].split()[1]) == pid:
                found.append(int(stat.parent.name))
    return sorted(found)


class RanksTest(LongRenderTest):
    def setUp(self):
        super().setUp()
        if shutil.which("mpirun") is None:
            self.skipTest("there is no mpirun")
        done = self.share(2, "render", "scene.lua", "-o", "probe.png", "--samples", "1")
        if "without MPI" in done.stderr:
            self.skipTest("lapidary was built without MPI")
        (self.folder / "probe.png").unlink()

    def launch(self, *command):
        process = subprocess.Popen([*LAUNCHER, *command], cwd=self.folder, env=ENVIRONMENT,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return process

    def finish(self, process):
        out, err = process.communicate(timeout=120)
        return subprocess.CompletedProcess(process.args, process.returncode, out, err)

    def share(self, ranks, *arguments):
        return self.finish(self.launch("-n", str(ranks), program_test.LAPIDARY, *arguments,
                                       "--threads", "1"))

    def share_with(self, folder, *arguments):
        """One rank here, and another one in `folder`."""
        rank = [program_test.LAPIDARY, *arguments, "--threads", "1"]
        return self.finish(self.launch("-n", "1", *rank, ":", "-n", "1", "-wdir",
                                       str(self.folder / folder), *rank))

    def share_well(self, ranks, *arguments):
        done = self.share(ranks, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done


class Same(RanksTest):
    def test_picture_for_any_number_of_ranks(self):
        self.write_scene("adaptive", "photons")
        self.render("one.exr", "--threads", "2", "--samples", "70")
        for ranks in (1, 2, 4):
            done = self.share_well(ranks, "render", "scene.lua", "-o", f"{ranks}.exr", "--samples",
                                   "70", "--stats", "s.json")
            self.assertIn(f"{ranks}.exr: 40x30, 70 samples per pixel", done.stderr)
            self.assertEqual(json.loads((self.folder / "s.json").read_text())["ranks"], ranks)
        self.assert_same("one.exr", "1.exr", "2.exr", "4.exr")

    def test_picture_when_it_goes_on(self):
        self.render("one.exr", "--samples", "64")
        self.render("a.exr", "--samples", "14")
        done = self.share_well(3, "render", "scene.lua", "-o", "a.exr", "--samples", "64",
                               "--resume")
        self.assertIn("a.exr: going on from 12 samples per pixel", done.stderr)
        self.assert_same("one.exr", "a.exr")

    def test_picture_at_the_noise_that_was_asked_for(self):
        self.render("one.exr", "--noise", "0.1")
        self.share_well(3, "render", "scene.lua", "-o", "a.exr", "--noise", "0.1")
        self.assert_same("one.exr", "a.exr")

    def test_maps_of_illumination(self):
        options = ("--integrator", "illumination", "--samples", "8", "--render",
                   "map_photons=5000")
        self.render("one.exr", *options)
        self.share_well(2, "render", "scene.lua", "-o", "a.exr", *options)
        self.assert_same("one.exr", "a.exr")


class Binding(RanksTest):
    def test_to_few_processors_is_told(self):
        if os.cpu_count() < 2:
            self.skipTest("there is one processor anyway")
        one = ["env", "OMPI_COMM_WORLD_LOCAL_SIZE=1", "taskset", "--cpu-list",
               str(min(os.sched_getaffinity(0))), program_test.LAPIDARY, "render", "scene.lua",
               "--samples", "1"]
        for more, warnings in (([], 1), (["--threads", "1"], 0)):
            done = self.finish(self.launch("-n", "2", *one, *more))
            self.assertEqual(done.stderr.count("warning: mpirun lets this rank have 1 of"),
                             warnings, done.stderr)


class Files(RanksTest):
    """What other ranks know of the scene's files."""

    def setUp(self):
        super().setUp()
        (self.folder / "elsewhere").mkdir()

    def write_scene_of_many_files(self):
        self.succeed("render", "scene.lua", "-o", "sky.hdr", "--samples", "1")
        (self.folder / "paints").mkdir()
        self.succeed("render", "scene.lua", "-o", "paints/Red.png", "--samples", "1")
        (self.folder / "link").symlink_to("paints")
        (self.folder / "broken.png").write_bytes(b"\x89PNG\r\n\x1a\n and no more")
        (self.folder / "empty.mtl").write_text("")
        self.write("shape.mtl", "newmtl red\nKd 1 0 0\nmap_Kd LINK\\red.PNG\nmap_Ks none.png\n"
                                "newmtl blue\nKd 0 0 1\nmap_Kd broken.png\n")
        self.write("shape.obj", "mtllib empty.mtl nix.mtl SHAPE.mtl\nvt 0 0\nvt 1 0\nvt 0 1\n" +
                   program_test.TETRAHEDRON.replace("f 1 3 2", "usemtl red\nf 1/1 3/2 2/3")
                   .replace("f 1 2 4", "usemtl blue\nf 1 2 4"))
        self.write("lamp.ies", (program_test.EXAMPLES / "downlight.ies").read_text())
        (self.folder / "allowed").mkdir()
        self.write("allowed/more.lua", "return sphere { center = {0, 1, 0}, radius = 0.3 }")
        (self.folder / "scenes").mkdir()
        self.write("scenes/many.lua", """
          return scene { camera = perspective { from = {0, -5, 2.5}, at = {0, 0, 0.3}, fov = 40 },
                         lights = { environment { file = "sky.hdr" },
                                    point_light { profile = "lamp.ies", position = {0, 0, 3} } },
                         objects = { mesh { file = "shape.obj" }, require "more",
                                     box { size = {1, 1, 1},
                                           material = matte { color = image "link/Red.png" } }
                                       :translate {-1.5, 0, 0} },
                         render = { size = {40, 30} } }""")
        return ("render", "scenes/many.lua", "--allow", ".", "--allow", "allowed", "--samples",
                "24")

    def test_are_sent_to_those_who_have_none(self):
        options = self.write_scene_of_many_files()
        one = self.succeed(*options, "-o", "one.exr")
        self.assertIn("broken.png", one.stderr, "it is left out, with a warning")
        done = self.share_with("elsewhere", *options, "-o", "a.exr")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("warning:"), one.stderr.count("warning:"))
        self.assert_same("one.exr", "a.exr")
        self.assertEqual(list((self.folder / "elsewhere").iterdir()), [])

    def test_of_a_bare_mesh_are_sent(self):
        self.succeed("render", "shape.obj", "-o", "one.exr", "--samples", "8")
        done = self.share_with("elsewhere", "render", "shape.obj", "-o", "a.exr", "--samples", "8")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same("one.exr", "a.exr")

    def test_that_are_shared_are_read_by_all(self):
        options = ("render", "scene.lua", "-o", "a.exr", "--samples", "16", "--shared-files")
        self.render("one.exr", "--samples", "16")
        self.share_well(2, *options)
        self.assert_same("one.exr", "a.exr")
        (self.folder / "a.exr").unlink()
        done = self.share_with("elsewhere", *options)
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"error: rank 1 on \S+: scene.lua: does not exist")
        shutil.copytree(self.folder / "lib", self.folder / "elsewhere/lib")
        shutil.copy(self.folder / "scene.lua", self.folder / "elsewhere")
        self.write("elsewhere/shape.obj", program_test.TETRAHEDRON + "v 0 0 0\n")
        done = self.share_with("elsewhere", *options)
        self.assertRegex(done.stderr, r"error: rank 1 on \S+ would render another picture")
        self.assertRegex(done.stderr, r"\n  file shape.obj: SHA-256 \w{64} there, SHA-256 \w{64} "
                                      r"on rank 0\n")
        self.assertEqual(done.stderr.count("error:"), 1, done.stderr)
        self.assertNotIn("setting", done.stderr)
        self.assertFalse((self.folder / "a.exr").exists())

    def test_that_are_wrong_are_told_once(self):
        for arguments, text in ((("render", "nix.lua"), "nix.lua: does not exist"),
                                (("render", "scene.lua", "--sampels", "3"), "unknown option")):
            done = self.share(3, *arguments)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(text, done.stderr)
            self.assertEqual(done.stderr.count("error:"), 1, done.stderr)


class Stop(RanksTest):
    def begin(self, ranks):
        """A render without end, once it has some samples."""
        process = self.launch("-n", str(ranks), program_test.LAPIDARY, "render", "scene.lua", "-o",
                              "a.exr", "--samples", "16000000", "--progress", "json", "--threads",
                              "1")
        for _ in range(3):
            self.wait_for_block(process)
        return process

    def assert_goes_on(self):
        self.assertFalse([p.name for p in self.folder.iterdir() if p.name.startswith(".")])
        held = self.render("a.exr", "--resume", "--samples", "1", "--stats", "s.json").stderr
        self.assertIn("a.exr: going on from", held)
        samples = json.loads((self.folder / "s.json").read_text())["samples_per_pixel"]
        more = str(2 * samples + 64)  # there may be gaps
        self.render("a.exr", "--resume", "--samples", more)
        self.render("one.exr", "--samples", more)
        self.assert_same("one.exr", "a.exr")

    def test_of_the_launcher_keeps_what_there_is(self):
        for signal_number in (signal.SIGTERM, signal.SIGINT):
            process = self.begin(2)
            process.send_signal(signal_number)
            done = self.finish(process)
            self.assertIn("samples per pixel, --resume goes on with it", done.stderr)
            self.assert_goes_on()

    def test_by_a_rank_that_is_killed_keeps_what_there_is(self):
        process = self.begin(3)
        ranks = children(process.pid)
        self.assertEqual(len(ranks), 3)
        os.kill(ranks[2], signal.SIGKILL)
        done = self.finish(process)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("samples per pixel, --resume goes on with it", done.stderr)
        self.assertIn("rank 2", done.stderr, "mpirun says who it was")
        self.assert_goes_on()

    def test_at_the_end_of_the_time(self):
        begin = time.monotonic()
        self.share_well(2, "render", "scene.lua", "-o", "a.exr", "--time", "1")
        self.assertLess(time.monotonic() - begin, 60)
        self.render("a.exr", "--samples", "1", "--resume", "--stats", "s.json")
        samples = json.loads((self.folder / "s.json").read_text())["samples_before"]
        self.assertGreater(samples, 0)
        for name, resume in (("a.exr", ["--resume"]), ("one.exr", [])):
            self.render(name, "--samples", str(samples), *resume)
        self.assert_same("one.exr", "a.exr")


if __name__ == "__main__":
    program_test.LAPIDARY = os.path.abspath(sys.argv.pop(1))
    unittest.main()
