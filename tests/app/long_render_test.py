#!/usr/bin/env python3
"""Renders that are stopped, killed, gone on with and put together, as users run them.

usage: long_render_test.py PATH/TO/lapidary [unittest's arguments]
"""

import contextlib
import hashlib
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import time
import unittest

import program_test
from program_test import ProgramTest

# Light focused by a ball of glass on a floor; a picture that is noisy in places.
SCENE = """
local lib = require "lib.floor"
return scene {
  camera = perspective { from = {0, -5, 2.5}, at = {0, 0, 0.3}, fov = 40 },
  lights = { sphere_light { center = {-2, 1, 4}, radius = 0.3, power = 300 } },
  objects = {
    lib.floor(param("shade", 0.6)),
    sphere { center = {0, 0, 0.8}, radius = 0.8, material = glass "N-BK7" },
    mesh { file = "shape.obj" }:translate {1.4, 0, 0},
  },
  render = { size = {40, 30}, samples = 64, sampling = "SAMPLING", caustics = "CAUSTICS" },
}
"""
FLOOR = """
return { floor = function(shade)
  return plane { material = matte { color = {shade, shade, shade} } }
end }
"""

BLOCK = 4  # samples of a block


def without_seconds(path):
    """The bytes of an OpenEXR file, but for the time that it took."""
    data = path.read_bytes()
    return re.sub(rb"(seconds\0double\0.{4}).{8}", rb"\1", data, flags=re.S)


class LongRenderTest(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "lib").mkdir()
        self.write("lib/floor.lua", FLOOR)
        self.write("shape.obj", program_test.TETRAHEDRON)
        self.write_scene("adaptive")

    def write_scene(self, sampling, caustics="paths"):
        self.write("scene.lua",
                   SCENE.replace("SAMPLING", sampling).replace("CAUSTICS", caustics))

    def render(self, output, *arguments):
        return self.succeed("render", "scene.lua", "-o", output, *arguments)

    def assert_same(self, *names):
        """All bits of all layers, and of what could be gone on with."""
        first = without_seconds(self.folder / names[0])
        for name in names[1:]:
            self.assertEqual(hashlib.sha256(without_seconds(self.folder / name)).digest(),
                             hashlib.sha256(first).digest(), name)

    def refuse(self, code, *arguments):
        """The message of a run that fails and changes no file."""
        before = {p: p.read_bytes() for p in self.folder.iterdir() if p.is_file()}
        message = self.fail_with(code, *arguments)
        self.assertEqual({p: p.read_bytes() for p in self.folder.iterdir() if p.is_file()}, before)
        return message


class Kill(LongRenderTest):
    def test_killed_at_twenty_moments_it_is_the_same_picture(self):
        self.write_scene("adaptive", "photons")
        begin = time.monotonic()
        self.render("whole.exr", "--threads", "2", "--samples", "120")
        whole = time.monotonic() - begin
        moments = random.Random(20)
        resumed = 0
        for i in range(20):
            program = self.start("render", "scene.lua", "-o", "a.exr", "--resume", "--checkpoint",
                                 "0.001", "--threads", "123"[i % 3], "--samples", "120")
            with contextlib.suppress(subprocess.TimeoutExpired):
                program.wait(moments.uniform(0.0, 0.5) * whole)
            program.kill()
            resumed += "going on from" in program.communicate()[1]
        self.assertGreater(resumed, 2)
        done = self.render("a.exr", "--resume", "--samples", "120")
        self.assertIn("a.exr: going on from", done.stderr)
        self.assert_same("a.exr", "whole.exr")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()),
                         ["a.exr", "lib", "scene.lua", "shape.obj", "whole.exr"])


class Resume(LongRenderTest):
    def test_adds_samples_to_a_picture(self):
        for samples, more in (("16", "37"), ("18", "64"), ("3", "8"), ("37", "41")):
            self.render("a.exr", "--samples", samples)
            done = self.render("a.exr", "--samples", more, "--resume", "--stats", "s.json")
            before = int(samples) // BLOCK * BLOCK
            self.assertIn(f"going on from {before} samples per pixel", done.stderr)
            self.assertEqual(json.loads((self.folder / "s.json").read_text())["samples_before"],
                             before)
            self.render("b.exr", "--samples", more)
            self.assert_same("a.exr", "b.exr")

    def test_of_a_picture_that_is_complete_changes_nothing(self):
        self.render("a.exr", "--samples", "12")
        (self.folder / "b.exr").write_bytes((self.folder / "a.exr").read_bytes())
        self.render("a.exr", "--samples", "12", "--resume")
        self.assert_same("a.exr", "b.exr")
        self.assertIn("12 samples per pixel",
                      self.render("a.exr", "--samples", "4", "--resume").stderr)

    def test_starts_from_the_beginning_where_there_is_nothing(self):
        done = self.render("a.exr", "--samples", "4", "--resume")
        self.assertIn("a.exr: not there, starting from the beginning\n", done.stderr)
        self.assertEqual(self.render("c.exr", "--samples", "4", "--resume", "--quiet").stderr, "")

    def test_after_an_interruption(self):
        for signal_number in (signal.SIGINT, signal.SIGTERM):
            program = self.start("render", "scene.lua", "-o", "a.png", "--progress", "json",
                                 "--samples", "16000000")
            self.addCleanup(program.kill)
            for _ in range(3):
                self.wait_for_block(program)
            program.send_signal(signal_number)
            program.communicate(timeout=60)
            self.assertEqual(program.returncode, 4)
            beside = self.folder / "a.checkpoint.exr"
            self.assertTrue(beside.exists())
            done = self.render("a.png", "--samples", "12", "--resume")
            self.assertIn("a.checkpoint.exr: going on from", done.stderr)
            self.assertFalse(beside.exists(), "it has served")

    def test_time_is_that_of_this_run(self):
        self.render("a.exr", "--time", "0.3")
        done = self.render("a.exr", "--time", "0.3", "--resume", "--stats", "s.json")
        stats = json.loads((self.folder / "s.json").read_text())
        self.assertGreater(stats["samples_per_pixel"], stats["samples_before"], done.stderr)

    def test_runs_out_of_time_with_a_checkpoint_beside(self):
        run = ("a.png", "--samples", "100000", "--time", "0.3", "--resume", "--stats", "s.json")
        self.render(*run)
        before = json.loads((self.folder / "s.json").read_text())["samples_per_pixel"]
        self.assertTrue((self.folder / "a.checkpoint.exr").exists())
        self.render(*run)
        self.assertEqual(json.loads((self.folder / "s.json").read_text())["samples_before"], before)
        self.render("b.png", "--time", "0.3")
        self.assertFalse((self.folder / "b.checkpoint.exr").exists())

    def test_the_last_of_two_assignments_counts(self):
        self.render("a.exr", "--samples", "4", "--set", "shade=0.2", "--set", "shade=0.5")
        self.render("a.exr", "--samples", "8", "--resume", "--set", "shade=0.5")

    def test_leaves_files_of_others_alone(self):
        self.write("a.checkpoint.exr", "not ours")
        self.render("a.png", "--samples", "4")
        self.assertEqual((self.folder / "a.checkpoint.exr").read_text(), "not ours")
        self.render("b.exr", "--samples", "4", "--checkpoint", "0")
        self.render("c.exr", "--samples", "4")
        self.assertNotIn(b"checkpoint", (self.folder / "b.exr").read_bytes())
        self.assertEqual(self.succeed("compare", "b.exr", "c.exr", "--metric", "mse").stdout,
                         "mse 0\n")


class ResumeRefused(LongRenderTest):
    def refusal(self, *arguments):
        return self.refuse(5, "render", "scene.lua", "-o", "a.exr", "--resume", "--samples", "64",
                           *arguments)

    def test_names_what_differs(self):
        self.render("a.exr", "--samples", "4")
        message = self.refusal("--render", "max_depth=3", "--set", "shade=0.5", "--seed", "4")
        self.assertIn("\n  setting max_depth: 16, now 3\n", message)
        self.assertIn("\n  setting seed: 0, now 4\n", message)
        self.assertIn("\n  parameter shade: none, now 0.5\n", message)
        self.assertNotIn("samples:", message)
        self.assertIn("size: {40, 30}, now {8, 8}", self.refusal("--size", "8x8"))

    def test_names_files_that_changed(self):
        self.render("a.exr", "--samples", "4")
        self.write("lib/floor.lua", FLOOR + "-- changed")
        self.assertIn("\n  file lib/floor.lua: has other content now\n", self.refusal())
        self.write("lib/floor.lua", FLOOR)
        self.write("shape.obj", program_test.TETRAHEDRON + "v 0 0 0\n")
        self.assertIn("\n  file shape.obj: has other content now\n", self.refusal())
        (self.folder / "other.obj").write_text(program_test.TETRAHEDRON)
        self.write("scene.lua", (self.folder / "scene.lua").read_text().replace("shape", "other"))
        message = self.refusal()
        self.assertIn("\n  file other.obj: was not read then\n", message)
        self.assertIn("\n  file shape.obj: is not read now\n", message)

    def test_takes_the_scene_from_another_folder(self):
        self.render("a.exr", "--samples", "4")
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        for name in ("scene.lua", "shape.obj", "lib"):
            (self.folder / name).rename(elsewhere / name)
        self.succeed("render", "elsewhere/scene.lua", "-o", "a.exr", "--samples", "8", "--resume")

    def test_every_kind_of_file_counts(self):
        self.succeed("render", "scene.lua", "-o", "sky.hdr", "--samples", "1")
        self.write("paint.png", "")
        self.succeed("render", "scene.lua", "-o", "paint.png", "--samples", "1")
        self.write("shape.mtl", "newmtl red\nKd 1 0 0\nmap_Kd paint.png\n")
        self.write("shape.obj", "mtllib shape.mtl\nvt 0 0\n" +
                   program_test.TETRAHEDRON.replace("f 1 3 2", "usemtl red\nf 1/1 3/1 2/1"))
        self.write("lamp.ies", (program_test.EXAMPLES / "downlight.ies").read_text())
        self.write("scene.lua", """
          return scene { lights = { environment { file = "sky.hdr" },
                                    point_light { profile = "lamp.ies", position = {0, 0, 3} } },
                         objects = { mesh { file = "shape.obj" } },
                         render = { size = {8, 6} } }""")
        self.render("a.exr", "--samples", "4")
        names = ["lamp.ies", "paint.png", "scene.lua", "shape.mtl", "shape.obj", "sky.hdr"]
        listing = "".join(
            f"{hashlib.sha256((self.folder / name).read_bytes()).hexdigest()}  {name}\n"
            for name in names)
        self.assertIn(listing.encode(), (self.folder / "a.exr").read_bytes())

    def test_files_that_are_no_checkpoint(self):
        self.render("a.exr", "--samples", "4")
        whole = (self.folder / "a.exr").read_bytes()
        resume = ("render", "scene.lua", "-o", "a.exr", "--samples", "8", "--resume")
        for size in (0, 1, 100, 1000, len(whole) // 2, len(whole) - 1):
            (self.folder / "a.exr").write_bytes(whole[:size])
            self.assertIn("a.exr", self.refuse(3, *resume))
        (self.folder / "a.exr").write_text("hello")
        self.assertIn("not a picture", self.refuse(3, *resume))
        self.render("a.exr", "--samples", "4", "--checkpoint", "0")
        self.assertIn("a.exr: holds no checkpoint", self.refuse(3, *resume))
        version = self.succeed("--version").stdout.split()[1].encode()
        stated = b"lapidary\0string\0" + bytes([len(version), 0, 0, 0])
        self.assertIn(stated + version, whole)
        (self.folder / "a.exr").write_bytes(whole.replace(stated + version, stated + b"9.9.9"))
        self.assertIn("\n  Lapidary 9.9.9, now " + version.decode(), self.refuse(5, *resume))
        (self.folder / "part.exr").write_bytes(
            whole.replace(stated + version, stated + b"9.9.9"))
        self.assertIn("\n  Lapidary 9.9.9, now " + version.decode(),
                      self.refuse(5, "merge", "part.exr", "-o", "whole.exr"))
        format_1 = b"checkpoint\0double\0\x08\0\0\0" + b"\0\0\0\0\0\0\xf0\x3f"
        self.assertIn(format_1, whole)
        (self.folder / "a.exr").write_bytes(
            whole.replace(format_1, format_1[:-8] + b"\0\0\0\0\0\0\0\x40"))
        self.assertIn("format 2", self.refuse(3, *resume))


class Merge(LongRenderTest):
    def blocks(self, output, numbers, *arguments):
        return self.render(output, "--blocks", numbers, *arguments)

    def test_three_parts_are_the_whole(self):
        self.write_scene("uniform")
        self.render("whole.exr")
        for threads, numbers in (("1", "1-3"), ("2", "4-11"), ("3", "12-16")):
            self.blocks(numbers + ".exr", numbers, "--threads", threads)
        self.succeed("merge", "4-11.exr", "12-16.exr", "1-3.exr", "-o", "sum.exr", "-o", "sum.png")
        self.assert_same("sum.exr", "whole.exr")
        self.render("sum.exr", "--resume", "--samples", "70")
        self.render("whole.exr", "--samples", "70")
        self.assert_same("sum.exr", "whole.exr")

    def test_adaptive_parts_follow_a_plan(self):
        self.write_scene("adaptive", "photons")
        self.render("whole.exr")
        self.render("first.exr", "--samples", "16", "--checkpoint", "1")
        for numbers in ("5-8", "9-12", "13-16"):
            self.blocks(numbers + ".exr", numbers, "--plan", "first.exr")
        self.succeed("merge", "13-16.exr", "5-8.exr", "first.exr", "9-12.exr", "-o", "sum.exr")
        self.render("sum.exr", "--resume")  # says how many samples there are to be, and no more
        self.assert_same("sum.exr", "whole.exr")
        self.render("sum.exr", "--resume", "--samples", "132")
        self.render("whole.exr", "--samples", "132")
        self.assert_same("sum.exr", "whole.exr")

    def test_a_part_is_resumed(self):
        self.render("first.exr", "--samples", "8")
        self.blocks("whole.exr", "3-8", "--plan", "first.exr")
        program = self.start("render", "scene.lua", "-o", "a.exr", "--blocks", "3-8", "--plan",
                             "first.exr", "--progress", "json", "--threads", "1")
        self.wait_for_block(program)
        program.send_signal(signal.SIGTERM)
        program.communicate(timeout=60)
        self.blocks("a.exr", "3-8", "--resume")
        self.assert_same("a.exr", "whole.exr")

    def test_blocks_without_a_plan(self):
        for numbers in ("5-8", "3"):
            self.assertIn("--plan", self.refuse(2, "render", "scene.lua", "-o", "a.exr",
                                                "--blocks", numbers))
        self.blocks("a.exr", "1-6")  # from the beginning it takes its own decisions
        self.render("b.exr", "--samples", "24")
        self.assertEqual(self.succeed("compare", "a.exr", "b.exr", "--metric", "mse").stdout,
                         "mse 0\n")
        self.assertIn("cannot go beyond 64", self.refuse(
            2, "render", "scene.lua", "-o", "c.exr", "--blocks", "17-18", "--plan", "a.exr"))

    def test_gaps_are_told_and_filled(self):
        self.write_scene("uniform")
        self.render("whole.exr")
        self.blocks("a.exr", "1-4")
        self.blocks("b.exr", "9-16")
        done = self.succeed("merge", "b.exr", "a.exr", "-o", "sum.exr")
        self.assertIn("warning: samples 17 to 32 of each pixel are missing", done.stderr)
        self.render("sum.exr", "--resume")
        self.assert_same("sum.exr", "whole.exr")

    def test_gaps_end_what_adaptive_sampling_can_decide(self):
        self.render("whole.exr")
        self.render("first.exr", "--samples", "16")
        self.blocks("last.exr", "9-16", "--plan", "first.exr")
        done = self.succeed("merge", "first.exr", "last.exr", "-o", "sum.exr")
        self.assertIn("warning: samples 17 to 32 of each pixel are missing", done.stderr)
        self.assertIn("up to 64 samples per pixel and no further", done.stderr)
        self.render("sum.exr", "--resume")
        self.assertEqual(self.succeed("compare", "sum.exr", "whole.exr", "--metric", "mse").stdout,
                         "mse 0\n")
        self.assertIn("cannot go beyond 64", self.refuse(
            3, "render", "scene.lua", "-o", "sum.exr", "--resume", "--samples", "68"))

    def test_what_does_not_belong_together(self):
        self.write_scene("uniform")
        self.blocks("a.exr", "1-2")
        self.blocks("b.exr", "2-4")
        self.blocks("c.exr", "3-4", "--seed", "2")
        self.render("plain.exr", "--samples", "4", "--checkpoint", "0")
        message = self.refuse(3, "merge", "a.exr", "b.exr", "-o", "sum.exr")
        self.assertIn("b.exr: has samples 5 to 16, and a.exr has samples 1 to 8", message)
        self.refuse(3, "merge", "a.exr", "a.exr", "-o", "sum.exr")
        self.assertIn("\n  setting seed: 0, now 2",
                      self.refuse(5, "merge", "a.exr", "c.exr", "-o", "sum.exr"))
        self.refuse(3, "merge", "a.exr", "plain.exr", "-o", "sum.exr")
        self.refuse(3, "merge", "a.exr", "gone.exr", "-o", "sum.exr")
        self.refuse(2, "merge", "a.exr")
        self.refuse(2, "merge", "-o", "sum.exr")

    def test_wrong_options(self):
        for numbers in ("0-3", "4-3", "1-", "-2", "a-b", "1-2-3", "", "1-99999999999"):
            self.refuse(2, "render", "scene.lua", "--blocks=" + numbers)
        for arguments in (("--blocks", "1-2", "--samples", "8"),
                          ("--blocks", "1-2", "--render", "time=8"), ("--plan", "a.exr"),
                          ("--blocks", "1-2", "-o", "a.png"), ("--blocks", "1-2"),
                          ("--blocks", "1-2", "-o", "a.exr", "--checkpoint", "0"),
                          ("--resume", "--checkpoint", "0"), ("--checkpoint", "-1"), ("--checkpoint", "soon")):
            self.refuse(2, "render", "scene.lua", *arguments)


class Disk(LongRenderTest):
    @contextlib.contextmanager
    def small_disk(self, size):
        """A disk of so many bytes in the folder `disk`."""
        if os.geteuid() != 0:
            self.skipTest("mounting a small disk takes root rights")
        disk = self.folder / "disk"
        disk.mkdir()
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(disk)],
                              check=False, capture_output=True, text=True)
        if done.returncode != 0:
            self.skipTest("no small disk can be mounted here: " + done.stderr)
        try:
            yield disk
        finally:
            subprocess.run(["umount", str(disk)], check=True)

    def test_that_is_full_keeps_the_checkpoint_before(self):
        with self.small_disk("1m") as disk:
            self.render("disk/a.exr", "--samples", "8")
            before = (disk / "a.exr").read_bytes()
            with open(disk / "filler", "wb") as filler:
                with contextlib.suppress(OSError):
                    while True:
                        os.write(filler.fileno(), b"x" * 4096)
            done = self.run_program("render", "scene.lua", "-o", "disk/a.exr", "-o", "b.png",
                                    "--resume", "--samples", "64", "--checkpoint", "0.001")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertEqual(done.stderr.count("warning: disk/a.exr: could not be written: No space "
                                               "left on device"), 1, done.stderr)
            self.assertEqual(done.stderr.count("error: disk/a.exr: could not be written"), 1)
            self.assertEqual((disk / "a.exr").read_bytes(), before)
            self.assertEqual(sorted(os.listdir(disk)), ["a.exr", "filler"])
            self.assertEqual(program_test.png_size(self.folder / "b.png"), (40, 30))
            (disk / "filler").unlink()
            self.render("disk/a.exr", "--resume")
            self.render("whole.exr")
            self.assert_same("disk/a.exr", "whole.exr")

    def test_that_is_read_only_is_found_before_rendering(self):
        with self.small_disk("1m") as disk:
            subprocess.run(["mount", "-o", "remount,ro", str(disk)], check=True)
            self.assertIn("cannot write in the folder",
                          self.fail_with(3, "render", "scene.lua", "-o", "disk/a.exr",
                                         "--samples", "16000000"))


class Frames(LongRenderTest):
    def setUp(self):
        super().setUp()
        scene = (self.folder / "scene.lua").read_text()
        self.write("scene.lua", scene.replace("{1.4, 0, 0}", "{1.4 + time, 0.01 * frame, 0}"))

    def frames(self, frames, output, *arguments):
        return self.succeed("render", "scene.lua", "--frames", frames, "-o", output, "--samples",
                            "8", *arguments)

    def test_are_what_each_is_by_itself(self):
        self.frames("9-11", "all_###.exr")
        for frame in ("009", "010", "011"):
            self.succeed("render", "scene.lua", "--frame", frame, "-o", f"one_{frame}.exr",
                         "--samples", "8")
            self.assert_same(f"all_{frame}.exr", f"one_{frame}.exr")
        self.assertNotEqual(without_seconds(self.folder / "all_009.exr"),
                            without_seconds(self.folder / "all_010.exr"))

    # Solids that stay, in one place and in several, cut and fused; then what a frame changes of them.
    SOLIDS = """
    local f = frame - 1
    local red, blue = matte "#c03020", matte "#3050c0"
    local ball = { 0, 0, 0.9 }
    local cutter, worn, spread, from = 0.3, red, 1.6, { 0, -6, 3 }
    local lamp, tip, inner = 40, 1, {}
    %s
    local wall = box { min = { -2, 0.5, 0 }, max = { 2, 0.8, 2 } }
      - union { cylinder { from = { -1, 0, 1 }, to = { -1, 1, 1 }, radius = 0.3 },
                sphere { center = { 1, 0.5, 1 }, radius = cutter, material = blue } }
    local gem = intersection {
      plane { point = { 0, 0, 0.6 * tip } }, plane { point = { 0.3, 0, 0 }, normal = { 1, 0, 0.5 } },
      plane { point = { -0.3, 0, 0 }, normal = { -1, 0, 0.5 } },
      plane { point = { 0, 0.3, 0 }, normal = { 0, 1, 0.5 } },
      plane { point = { 0, -0.3, 0 }, normal = { 0, -1, 0.5 } },
      plane { point = { 0, 0, 0.1 }, normal = { 0, 0, -1 } } }
    local holes = {}
    for i = 1, 12 do
      holes[i] = sphere { center = { 0.1 * (i - 6), 0.05 * (i %% 3), 0.2 }, radius = 0.06 }
    end
    local piece = difference { box { min = { -0.7, -0.1, 0 }, max = { 0.7, 0.2, 0.2 } }, holes }
    return scene {
      camera = perspective { from = from, at = { 0, 0, 0.6 }, fov = 40 },
      objects = {
        plane {}, wall:material(worn), gem:translate { 0.9, -0.6, 0 }, inner,
        sphere { center = ball, radius = 0.25 },
        piece:translate { -0.9, -1.1, 0 }, piece:translate { spread - 0.7, -1.6, 0 },
      },
      lights = { sphere_light { center = { 2, -3, 5 }, radius = 0.2, power = lamp } },
      render = { size = { 48, 32 } },
    }
    """
    CHANGES = {
        "camera": "from[1] = 0.2 * f",
        "light": "lamp = 40 + 10 * f",
        "ball": "ball[1] = 0.3 * f",
        "operand": "cutter = 0.3 + 0.05 * f",
        "instance": "spread = 1.6 + 0.2 * f",
        "material": "worn = f % 2 == 0 and red or blue",
        "materials of parts": "if f % 2 == 1 then blue = matte(checker { 'white', 'black' }) end",
        "half-space": "tip = 1 - 0.1 * f",
        "one more": "if f == 1 then inner = { sphere { radius = 0.2 } } end",
        "nothing": "",
    }

    def test_of_solids_are_what_each_is_by_itself(self):
        for number, (what, change) in enumerate(self.CHANGES.items()):
            with self.subTest(what=what):
                self.write("scene.lua", self.SOLIDS % change)
                self.frames("1-3", f"all_{number}_#.exr")
                for frame in range(1, 4):
                    alone = f"one_{number}_{frame}.exr"
                    self.succeed("render", "scene.lua", "--frame", str(frame), "-o", alone,
                                 "--samples", "8")
                    self.assert_same(f"all_{number}_{frame}.exr", alone)
                compared = self.succeed("compare", f"all_{number}_1.exr", f"all_{number}_2.exr")
                self.assertEqual("relmse 0\n" in compared.stdout, what == "nothing")

    def test_time_is_that_of_the_scene(self):
        self.write("tell.lua", "print(frame, time)\n" + (self.folder / "scene.lua").read_text())
        for options, told in (((), "1\t0\n"), (("--frame", "1"), "1\t0\n"),
                              (("--frame", "25"), "25\t1\n"),
                              (("--frame", "26", "--fps", "50"), "26\t0.5")):
            done = self.succeed("render", "tell.lua", "--samples", "1", "-o", "a.png", *options)
            self.assertIn(told, done.stderr)

    def test_that_are_there_are_skipped_on_resume(self):
        for extension in ("png", "exr"):
            self.frames("1-2", f"a_#.{extension}")
            before = {p: p.read_bytes() for p in self.folder.glob(f"a_*.{extension}")}
            done = self.frames("1-3", f"a_#.{extension}", "--resume")
            self.assertIn(f"a_3.{extension}: ", done.stderr)
            for picture, content in before.items():
                if extension == "png":
                    self.assertEqual(picture.read_bytes(), content)
            self.frames("3", f"b_#.{extension}")
            if extension == "exr":
                self.assert_same("a_3.exr", "b_3.exr")
        self.assertIn("a_1.png: there already", self.frames("1", "a_#.png", "--resume").stderr)

    def test_of_another_scene_are_refused_where_the_picture_tells(self):
        self.frames("1-2", "a_#.exr")
        message = self.refuse(5, "render", "scene.lua", "--frames", "1-2", "-o", "a_#.exr",
                              "--samples", "8", "--resume", "--fps", "50")
        self.assertIn("--fps", message)
        self.assertIn("--frame: 1, now 2",
                      self.refuse(5, "render", "scene.lua", "--frame", "2", "-o", "a_1.exr",
                                  "--samples", "8", "--resume"))

    def test_after_an_interruption_go_on(self):
        program = self.start("render", "scene.lua", "--frames", "1-3", "-o", "a_#.png",
                             "--progress", "json", "--samples", "16000000")
        self.addCleanup(program.kill)
        self.wait_for_block(program)
        program.send_signal(signal.SIGINT)
        program.communicate(timeout=60)
        self.assertEqual(program.returncode, 4)
        self.assertEqual(sorted(p.name for p in self.folder.glob("a_*")),
                         ["a_1.checkpoint.exr", "a_1.png"])
        self.succeed("render", "scene.lua", "--frames", "1-3", "-o", "a_#.png", "--resume",
                     "--samples", "4")
        self.assertEqual(sorted(p.name for p in self.folder.glob("a_*")),
                         ["a_1.png", "a_2.png", "a_3.png"])

    def test_an_error_says_in_which_frame(self):
        self.write("bad.lua", "if frame == 2 then error('no way') end\n"
                   + (self.folder / "scene.lua").read_text())
        done = self.run_program("render", "bad.lua", "--frames", "1-3", "-o", "a_#.png",
                                "--samples", "1")
        self.assertEqual(done.returncode, 3)
        self.assertIn("frame 2: ", done.stderr)
        self.assertTrue((self.folder / "a_1.png").exists())


class Preview(LongRenderTest):
    def test_is_there_while_rendering_and_at_the_end(self):
        program = self.start("render", "scene.lua", "-o", "a.png", "--preview", "p.png",
                             "--progress", "json", "--samples", "16000000")
        self.addCleanup(program.kill)
        self.wait_for_block(program)
        self.assertTrue((self.folder / "p.png").exists())
        program.send_signal(signal.SIGINT)
        program.communicate(timeout=60)
        self.assertIn("\nrelmse 0", "\n" + self.succeed("compare", "p.png", "a.png").stdout)

    def test_nowhere_to_write_it_is_told_before_the_work(self):
        self.refuse(3, "render", "scene.lua", "-o", "a.png", "--preview", "none/p.png")
        self.refuse(3, "render", "scene.lua", "-o", "a.png", "--preview", "p.txt")
        for preview in ("a.exr", "./a.exr", "../" + self.folder.name + "/a.exr"):
            self.assertIn("are one file", self.refuse(2, "render", "scene.lua", "-o", "a.exr",
                                                      "--preview", preview))
        self.refuse(2, "render", "scene.lua", "-o", "c.png", "--preview", "c.checkpoint.exr")


if __name__ == "__main__":
    program_test.LAPIDARY = os.path.abspath(sys.argv.pop(1))
    unittest.main()
