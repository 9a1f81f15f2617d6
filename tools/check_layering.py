#!/usr/bin/env python3
"""Checks what docs/architecture.md promises about src/.

Its two tables are the only statement of the rows and parts. Prints one line per violation,
"file:line: what", and exits with 1 if there are any.

usage: check_layering.py [ROOT]        ROOT is the project's folder, by default this one's parent
"""

import fnmatch
import pathlib
import re
import sys

MAX_LINES = 500
MAX_COLUMNS = 100
SOURCES = (".cpp", ".h")
DATA_FILE = re.compile(r"_(data|tables?)\.(cpp|h)$")  # tables of numbers may be long

# Headers of other people's that stay behind a fence: pattern, the folder that may include them.
FENCES = (
    (re.compile(r"^(OpenEXR/|Imf|Iex|png\.h|jpeglib\.h|turbojpeg\.h)"), "image"),
    (re.compile(r"^(lua5\.4/)?(lua\.hpp|lua\.h|lauxlib\.h|lualib\.h|luaconf\.h)"), "lua"),
    (re.compile(r"^embree\d/"), "geometry"),
    (re.compile(r"^(tbb|oneapi/tbb)/"), "base"),
    (re.compile(r"^mpi\.h"), "distributed"),
    (re.compile(r"^httplib\.h"), "preview"),
)
# Of these, one file alone.
ONE_FILE = {"Embree": FENCES[2][0], "MPI": FENCES[4][0]}

# What only app/ may do.
OUTSIDE_WORLD = (
    (re.compile(r"\bstd::(cout|cerr|clog)\b"), "prints"),
    (re.compile(r"\b(printf|puts|putchar|perror|fmt::print|std::print|vprintf)\s*\("), "prints"),
    (re.compile(r"\bfprintf\s*\(\s*(stdout|stderr)\b"), "prints"),
    (re.compile(r"\b(exit|_exit|quick_exit|abort|terminate)\s*\("), "ends the process"),
)

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


class House:
    """The rows of folders and the order of parts inside a folder, as the page states them."""

    def __init__(self, page):
        self.rows = {}  # folder -> row
        self.reserved = set()  # folders that are to come
        self.parts = {}  # folder -> [(part, patterns)], lowest first
        for line in page.splitlines():
            cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
            if not line.startswith("|") or len(cells) != 3:
                continue
            if cells[0].isdigit():
                folder = cells[1].strip("`")
                self.rows[folder] = int(cells[0])
                if cells[2].startswith("*reserved*"):
                    self.reserved.add(folder)
            elif cells[0].strip("`") in self.rows:
                patterns = re.findall(r"`([^`]+)`", cells[2])
                self.parts.setdefault(cells[0].strip("`"), []).append((cells[1], patterns))
        if not self.rows:
            raise SystemExit("docs/architecture.md: no table of rows found")

    def part(self, folder, name):
        """The index and name of the part of `folder` that the file `name` belongs to."""
        parts = self.parts[folder]
        everything_else = next(i for i, (_, patterns) in enumerate(parts) if not patterns)
        named = [i for i, (_, patterns) in enumerate(parts)
                 if any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)]
        index = named[-1] if named else everything_else
        return index, parts[index][0]

    def objection(self, folder, name, target):
        """Why the file folder/name may not include "target", or None."""
        to = target.split("/")[0]
        if "/" not in target:
            return f'includes "{target}" without its folder'
        if to not in self.rows:
            return f'includes "{target}", whose folder has no row'
        if to == folder:
            return self.objection_inside(folder, name, target.split("/", 1)[1])
        if self.rows[to] >= self.rows[folder]:
            relation = "its sibling" if self.rows[to] == self.rows[folder] else "the higher row"
            return f'{folder}/ (row {self.rows[folder]}) includes "{target}" of {relation} {to}/'
        return None

    def objection_inside(self, folder, name, target):
        if folder not in self.parts:
            return None
        mine, mine_name = self.part(folder, name)
        other, other_name = self.part(folder, target)
        if other <= mine:
            return None
        return f'"{folder}/{target}" ({other_name}) is of a later part than this file ({mine_name})'


def blank(match):
    """As many line breaks as the text had, so that line numbers stay right."""
    return "\n" * match.group(0).count("\n") or " "


def without_comments(text):
    return re.sub(r'//[^\n]*|/\*.*?\*/|(?P<s>"(?:\\.|[^"\\\n])*")',
                  lambda m: m.group("s") or blank(m), text, flags=re.S)


def without_strings(text):
    text = re.sub(r'R"(\w*)\(.*?\)\1"', blank, text, flags=re.S)
    return re.sub(r'"(?:\\.|[^"\\\n])*"', '""', text)


def includes(code):
    for number, line in enumerate(code.splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1), match.group(2)


def check_size(path, text, report):
    lines = text.splitlines()
    if len(lines) > MAX_LINES and not DATA_FILE.search(path.name):
        report(path, len(lines), f"{len(lines)} lines, more than {MAX_LINES}")
    for number, line in enumerate(lines, 1):
        if len(line) > MAX_COLUMNS:
            report(path, number, f"{len(line)} columns, more than {MAX_COLUMNS}")


def check_includes(path, folder, code, house, report):
    """Returns those of ONE_FILE that the file includes."""
    used = set()
    for number, quote, target in includes(code):
        objection = house.objection(folder, path.name, target) if quote == '"' else None
        for pattern, owner in FENCES:
            if pattern.match(target) and folder != owner:
                objection = f"includes <{target}>, which only {owner}/ may"
        used |= {name for name, pattern in ONE_FILE.items() if pattern.match(target)}
        if objection:
            report(path, number, objection)
    return used


def check_outside_world(path, code, report):
    for number, line in enumerate(without_strings(code).splitlines(), 1):
        for pattern, deed in OUTSIDE_WORLD:
            if pattern.search(line):
                report(path, number, f"{deed}, which only app/ may")


def check_folders(root, house, report):
    """The page and src/ agree on which folders there are."""
    folders = {p.name for p in (root / "src").iterdir() if p.is_dir()}
    for name in sorted(folders - set(house.rows)):
        report(root / "src" / name, 0, "this folder has no row in docs/architecture.md")
    for name in sorted(folders & house.reserved):
        report(root / "src" / name, 0, "docs/architecture.md calls this folder reserved")
    for name in sorted(set(house.rows) - folders - house.reserved):
        report(root / "src" / name, 0, "docs/architecture.md has this folder, src/ has not")
    return sorted(folders & set(house.rows))


def sources_under(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in SOURCES)


def violations(root):
    """All violations of the project at `root` as lines of text."""
    found = []

    def report(path, line, what):
        found.append(f"{path.relative_to(root)}:{line}: {what}")

    page = root / "docs" / "architecture.md"
    house = House(page.read_text(encoding="utf-8"))
    users = {name: [] for name in ONE_FILE}
    for folder in check_folders(root, house, report):
        for path in sources_under(root / "src" / folder):
            code = without_comments(path.read_text(encoding="utf-8"))
            for name in check_includes(path, folder, code, house, report):
                users[name].append(path)
            if folder != "app":
                check_outside_world(path, code, report)
    for name, paths in users.items():
        for path in paths[1:]:
            report(path, 0, f"includes {name}, as {paths[0].name} does: one file may")
    for name in ("src", "tests", "bench", "tools"):
        for path in sources_under(root / name):
            check_size(path, path.read_text(encoding="utf-8"), report)
    return found


def main(arguments):
    here = pathlib.Path(__file__).resolve().parent.parent
    found = violations(pathlib.Path(arguments[0]).resolve() if arguments else here)
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
