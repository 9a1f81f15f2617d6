"""The layering check finds what it is there to find, in projects made up for it."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import check_layering  # noqa: E402

PAGE = """
| row | folder | holds |
| --- | --- | --- |
| 3 | `app` | |
| 2 | `lua` | |
| 2 | `image` | |
| 2 | `distributed` | |
| 2 | `preview` | *reserved*: to come |
| 1 | `geometry` | |
| 0 | `base` | |
| 0 | `math` | |

| folder | part | files |
| --- | --- | --- |
| `geometry` | solid | everything else |
| `geometry` | mesh | `*mesh*` |
"""


class CheckLayering(unittest.TestCase):
    def violations(self, **files):
        """What the check says about src/ holding `files`, named folder__file with .cpp left out."""
        with tempfile.TemporaryDirectory() as name:
            root = pathlib.Path(name)
            (root / "docs").mkdir()
            (root / "docs/architecture.md").write_text(PAGE)
            for folder in ("app", "lua", "image", "distributed", "geometry", "base", "math"):
                (root / "src" / folder).mkdir(parents=True)
            for file, text in files.items():
                path = root / "src" / (file.replace("__", "/") + ".cpp")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return check_layering.violations(root)

    def assert_one(self, found, *fragments):
        self.assertEqual(len(found), 1, found)
        for fragment in fragments:
            self.assertIn(fragment, found[0])

    def test_accepts_a_tidy_project(self):
        self.assertEqual([], self.violations(
            app__main='#include "lua/load.h"\n#include <cstdio>\nint main() { std::printf("hi"); }',
            lua__load='#include <lua.hpp>\n#include "geometry/mesh.h"\n',
            image__png='#include <png.h>\n#include "base/error.h"\nvoid f() { snprintf(b, 1, ""); }',
            geometry__mesh='#include "geometry/solid.h"\n#include <embree3/rtcore.h>\n',
            base__error='// never calls exit()\nconst char* text = "std::cout << printf()";\n'))

    def test_rejects_a_higher_row(self):
        self.assert_one(self.violations(base__a='\n#include "lua/load.h"\n'),
                        "src/base/a.cpp:2:", "higher row")

    def test_rejects_a_sibling(self):
        self.assert_one(self.violations(lua__a='#include "image/png.h"\n'), "sibling")

    def test_rejects_a_later_part(self):
        self.assert_one(self.violations(geometry__sphere='#include "geometry/mesh.h"\n'),
                        "later part", "(mesh)", "(solid)")

    def test_rejects_a_folder_without_row(self):
        self.assert_one(self.violations(misc__a=""), "src/misc:0:", "no row")
        self.assert_one(self.violations(app__a='#include "misc/a.h"'), "no row")

    def test_the_page_says_which_folders_there_are(self):
        self.assert_one(self.violations(preview__a=""), "src/preview:0:", "reserved")
        page = check_layering.House(PAGE)
        self.assertEqual({"preview"}, page.reserved)

    def test_rejects_an_include_without_folder(self):
        self.assert_one(self.violations(base__a='#include "error.h"'), "without its folder")

    def test_keeps_libraries_behind_their_fences(self):
        for header in ("OpenEXR/ImfRgbaFile.h", "png.h", "lua.hpp", "embree4/rtcore.h", "tbb/task.h"):
            self.assert_one(self.violations(math__a=f"#include <{header}>"), header)

    def test_allows_one_user_of_embree(self):
        header = "#include <embree3/rtcore.h>"
        self.assert_one(self.violations(geometry__a=header, geometry__b=header), "src/geometry/b.cpp")

    def test_allows_one_user_of_mpi(self):
        header = "#include <mpi.h>"
        self.assert_one(self.violations(distributed__a=header, distributed__b=header),
                        "src/distributed/b.cpp")
        self.assert_one(self.violations(lua__a=header), "which only distributed/ may")

    def test_rejects_printing_and_ending_the_process(self):
        for code in ("std::cerr << 1;", 'std::printf("x");', 'fmt::print("x");', "std::exit(1);",
                     'fprintf(stderr, "x");', "std::abort();"):
            self.assert_one(self.violations(lua__a=code), "which only app/ may")

    def test_limits_the_size_of_files(self):
        self.assert_one(self.violations(base__a="\n" * 501), "501 lines")
        self.assertEqual([], self.violations(base__glass_data="\n" * 501))
        self.assert_one(self.violations(base__a="// " + "x" * 98), "101 columns")


if __name__ == "__main__":
    unittest.main()
