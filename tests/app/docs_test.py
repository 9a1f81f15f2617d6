#!/usr/bin/env python3
"""Runs the commands that a page of the documentation shows, on a small scene.

usage: docs_test.py PATH/TO/lapidary PAGE.md

Those are the blocks between ```sh and ```, run one after the other in a folder with scene.lua.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

SCENE = """
return scene {
  camera = perspective { from = {0, -5, 1}, at = {0, 0, 0}, fov = 40 },
  lights = { sphere_light { center = {0, 0, 6}, radius = 0.5, power = 300 } },
  objects = { sphere {}, plane { point = {0, 0, -1} } },
  render = { size = {24, 16} },
}
"""


def main(program, page):
    blocks = re.findall(r"^```sh\n(.*?)^```$", pathlib.Path(page).read_text(encoding="utf-8"),
                        flags=re.S | re.M)
    if not blocks:
        raise SystemExit(f"{page}: no commands to run")
    program = pathlib.Path(program).resolve()
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "scene.lua").write_text(SCENE, encoding="utf-8")
        for block in blocks:
            subprocess.run(["bash", "-euxc", block], cwd=folder, env=environment, check=True,
                           stdin=subprocess.DEVNULL)


if __name__ == "__main__":
    main(*sys.argv[1:])
