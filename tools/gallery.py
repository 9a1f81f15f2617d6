#!/usr/bin/env python3
"""Renders scenes of examples/ into docs/gallery/*.jpg and writes the page that shows them.

A scene's leading comment is its label: a title, a colon, and the caption up to an empty comment
line or the end of the comment. What a picture took is kept in docs/gallery/seconds.json, so that
rendering some anew leaves the rest of the page as it is.
"""

import argparse
import dataclasses
import html
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "examples"
GALLERY = ROOT / "docs" / "gallery"
SECONDS = GALLERY / "seconds.json"


@dataclasses.dataclass(frozen=True)
class Scene:
    path: str  # below examples/, without .lua
    options: tuple = ()  # of lapidary render

    @property
    def name(self):
        return pathlib.PurePath(self.path).name

    @property
    def file(self):
        return EXAMPLES / f"{self.path}.lua"


def of_gallery(*names):
    """Scenes made for the gallery."""
    return tuple(Scene(f"gallery/{name}") for name in names)


@dataclasses.dataclass(frozen=True)
class Wing:
    title: str
    intro: str
    scenes: tuple


WINGS = (
    Wing("The course",
         "Lapidary began as the ray tracer of a course. These are its exercises, each with the one "
         "thing that it teaches.",
         of_gallery("meshes", "spheres", "sphere_mapping", "triangle_coordinates", "csg",
                    "cylinders", "lights")),
    Wing("Light that was bent",
         "What glass, water and gold do to light. Paths and photons share the work by themselves: "
         "there is nothing to tune.",
         (Scene("caustics", ("--size", "640x480", "--samples", "64")),
          Scene("rainbow", ("--size", "640x480", "--samples", "160")),
          Scene("ring", ("--size", "640x480", "--samples", "80")),
          Scene("pool", ("--size", "640x480", "--samples", "32")),
          Scene("gem", ("--size", "640x512", "--samples", "96")),
          Scene("photon_blur", ("--size", "640x360", "--samples", "64")))),
    Wing("Showpieces",
         "What exact solids, patterns that fill them, media that overlap and thousands of lights "
         "are good for.",
         of_gallery("puzzle", "terrace", "lamp", "street")),
)

STYLE = """
:root {
  color-scheme: light dark;
  --page: #f6f4f0; --card: #fff; --text: #23211e; --quiet: #68635b; --line: #e1dcd3;
  --link: #8a4b12;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #161615; --card: #1f1f1e; --text: #e9e6e0; --quiet: #a29c92; --line: #32312f;
    --link: #e2a868;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 3rem clamp(1rem, 4vw, 3rem); max-width: 96rem;
  background: var(--page); color: var(--text); font: 1rem/1.55 system-ui, sans-serif;
}
h1, h2, h3 { font-weight: 600; line-height: 1.2; margin: 0; }
h1 { font-size: 2.2rem; }
h2 { font-size: 1.5rem; }
h3 { font-size: 1.1rem; }
header p, section > p { max-width: 42rem; margin: 0.6rem 0 0; color: var(--quiet); }
section { margin-top: 3.5rem; }
a { color: var(--link); }
.pictures {
  display: grid; gap: 1.75rem; margin-top: 1.5rem;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 24rem), 1fr));
}
figure {
  margin: 0; display: flex; flex-direction: column; overflow: hidden;
  background: var(--card); border: 1px solid var(--line); border-radius: 0.5rem;
}
figure img { display: block; width: 100%; height: auto; }
figcaption { display: flex; flex-direction: column; flex: 1; padding: 1rem 1.2rem 1.1rem; }
figcaption p { margin: 0.45rem 0 0.9rem; }
figcaption .facts { margin: auto 0 0; color: var(--quiet); font-size: 0.875rem; }
code { font-size: 0.92em; }
"""


def fail(problem):
    sys.exit(f"gallery: {problem}")


@dataclasses.dataclass(frozen=True)
class Label:
    title: str
    caption: str


def label_of(scene):
    """The title and caption in the leading comment of a scene's file."""
    lines = []
    for line in scene.file.read_text().splitlines():
        text = line.removeprefix("--").strip()
        if not line.startswith("--") or not text:
            break
        lines.append(text)
    title, colon, caption = " ".join(lines).partition(": ")
    if not colon:
        fail(f"{scene.file.relative_to(ROOT)} does not begin with a comment 'Title: caption'")
    return Label(title, caption[0].upper() + caption[1:])


def check_wings():
    """All scenes, by name: those made for the gallery hang in one wing each."""
    hung = [scene for wing in WINGS for scene in wing.scenes]
    names = [scene.name for scene in hung]
    if len(names) != len(set(names)):
        fail("WINGS has two scenes of the same name")
    missing = {path.stem for path in (EXAMPLES / "gallery").glob("*.lua")} - set(names)
    missing |= {scene.path for scene in hung if not scene.file.exists()}
    if missing:
        fail(f"WINGS and examples differ in: {', '.join(sorted(missing))}")
    return {scene.name: scene for scene in hung}


def render(program, scene, options):
    """Renders a scene; what it took, in seconds of one core, and the picture's size."""
    with tempfile.TemporaryDirectory() as folder:
        stats = pathlib.Path(folder) / "stats.json"
        picture = GALLERY / f"{scene.name}.jpg"
        done = subprocess.run([program, "render", scene.file, "-o", picture, "--stats", stats,
                               "--quiet", *scene.options, *options])
        if done.returncode != 0:
            fail(f"could not render {scene.name}")
        numbers = json.loads(stats.read_text())
    return {"seconds": round(numbers["cpu_seconds"], 1), "size": numbers["size"]}


def figure(scene, took):
    label = label_of(scene)
    width, height = took["size"]
    title = html.escape(label.title)
    how = "".join(f"<code>{html.escape(' '.join(pair))}</code> " for pair in
                  zip(scene.options[::2], scene.options[1::2]))
    return f"""<figure>
<img src="{scene.name}.jpg" width="{width}" height="{height}" alt="{title}" loading="lazy">
<figcaption>
<h3>{title}</h3>
<p>{html.escape(label.caption)}</p>
<p class="facts"><a href="../../examples/{scene.path}.lua"><code>{scene.name}.lua</code></a>
{how}· {took["seconds"]:.0f} s</p>
</figcaption>
</figure>
"""


def page(taken):
    """The page, of those pictures that have been taken."""
    wings = "".join(f"""<section>
<h2>{wing.title}</h2>
<p>{wing.intro}</p>
<div class="pictures">
{"".join(figure(scene, taken[scene.name]) for scene in wing.scenes if scene.name in taken)}</div>
</section>
""" for wing in WINGS)
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Lapidary: the gallery</title>
<style>{STYLE}</style>
</head>
<body>
<header>
<h1>Lapidary: the gallery</h1>
<p>Solids and light. Every picture is rendered from the Lua file named below it, with the options
that stand there; the seconds are those of one core, loading included. <code>./dev gallery</code>
renders them anew.</p>
</header>
<main>
{wings}</main>
</body>
</html>
"""


def main():
    parser = argparse.ArgumentParser(prog="./dev gallery", description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="scenes to render (all)")
    parser.add_argument("--program", default=ROOT / "build" / "release" / "lapidary",
                        help="the lapidary to render with")
    parser.add_argument("--threads", help="threads to render with (all)")
    arguments = parser.parse_args()

    hung = check_wings()
    for name in arguments.names:
        if name not in hung:
            fail(f"no scene '{name}'; there are {', '.join(hung)}")
    GALLERY.mkdir(parents=True, exist_ok=True)
    options = ["--threads", arguments.threads] if arguments.threads else []

    taken = json.loads(SECONDS.read_text()) if SECONDS.exists() else {}
    taken = {name: took for name, took in taken.items() if name in hung}
    for name in arguments.names or hung:
        took = render(arguments.program, hung[name], options)
        taken[name] = took
        print(f"{name}: {took['seconds']} s", flush=True)
        SECONDS.write_text(json.dumps(taken, indent=2, sort_keys=True) + "\n")
        (GALLERY / "index.html").write_text(page(taken))


if __name__ == "__main__":
    main()
