// Small texts with random damage: each is a sound mesh or one Error that names the file.

#include <array>

#include <gtest/gtest.h>

#include "import/obj.h"
#include "obj_test_support.h"
#include "support/random.h"

namespace lapidary::import {
namespace {

const std::array<std::string, 5> seeds{
    "mtllib a.mtl\no box\n" + cube_text(),
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\ng a b\nusemtl m\ns 1\n"
    "f 1/1/1 2/2/1 3/1/1 4/2/1\ns off\nf -4//-1 -2//-1 -1//-1\n",
    "# x\r\nv .5 -1e2 +3.25E-1 1.0\r\nv 1 2 3 nan\r\nv 4 5 7\r\nf 1 2 \\\r\n3\r\nl 1 2\r\np 1\r\n",
    "f 1/1 2/2 3/3 4/4 5/5\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\n"
    "vt 0 0\nvt 1\nvt 1 1 1\nvt 0 1\nvt .5 .5\ncurv 0 1 2\n",
    "v 8219.83 6406.93 9.6\rv 8219.63 6406.58 9.6\rv 8219.64 6406.58 9.1\rusemtl x y\rf 1 2 3\r"
    "usemtl z\rf 3 2 1\r"};

// Bytes that mean something to the reader, more often than others.
char random_byte(test::Random& random) {
  constexpr std::string_view meaningful = "0123456789-+.eE/ \t\n\r\\#fvntgsolpum";
  return random.index(5) == 0 ? static_cast<char>(random.index(256))
                              : meaningful[random.index(meaningful.size())];
}

std::string damaged(std::string text, test::Random& random) {
  for (std::uint64_t i = 0, count = 1 + random.index(4); i < count && !text.empty(); ++i) {
    const std::size_t at = random.index(text.size());
    switch (random.index(5)) {
      case 0:
        text[at] = random_byte(random);
        break;
      case 1:
        text.insert(at, 1 + random.index(3), random_byte(random));
        break;
      case 2:
        text.erase(at, 1 + random.index(5));
        break;
      case 3:
        text.resize(at);
        break;
      default:
        text.insert(at, text.substr(random.index(text.size()), random.index(40)));
        break;
    }
  }
  return text;
}

TEST(ObjFuzz, DamagedTextsAreMeshesOrErrors) {
  test::Random random(2024);
  const std::array sources{ObjNormals::automatic, ObjNormals::as_file, ObjNormals::smooth,
                           ObjNormals::flat};
  int meshes = 0, errors = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::string text = damaged(seeds[random.index(seeds.size())], random);
    WarningLog log;
    try {
      expect_sound(parse(text, {.warnings = &log, .normals = sources[random.index(4)]}));
      ++meshes;
    } catch (const Error& error) {
      EXPECT_EQ(error.where().file, "test.obj");
      EXPECT_FALSE(error.problem().empty());
      ++errors;
    }
    if (HasFailure()) FAIL() << "text " << i << ":\n" << text;
  }
  EXPECT_GT(meshes, 500);
  EXPECT_GT(errors, 1000);
}

TEST(ObjFuzz, TruncatedTextsAreMeshesOrErrors) {
  for (const std::string& seed : seeds) {
    for (std::size_t length = 0; length <= seed.size(); ++length) {
      try {
        expect_sound(parse(seed.substr(0, length)));
      } catch (const Error& error) {
        EXPECT_EQ(error.where().file, "test.obj");
      }
    }
  }
}

TEST(ObjFuzz, DamagedMaterialsAreMaterialsOrErrors) {
  const std::string seed =
      "newmtl a b\nKd 1 0.5 .25\nKs 0.5\nd -halo 0.5\nTr 0.5\nillum 2\nNs 1e2\nNi 1.5\n"
      "map_Kd -o 1 2 3 -mm 0 1 a b.png -bm 1\nnewmtl c\nTf 1 1 1\nPr .5\nPm 1\n";
  test::Random random(99);
  for (int i = 0; i < 3000; ++i) {
    try {
      for (const MtlMaterial& m : parse_mtl(damaged(seed, random), "t.mtl", nullptr)) {
        EXPECT_TRUE(std::isfinite(m.shininess) && std::isfinite(m.dissolve));
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.where().file, "t.mtl");
    }
  }
}

}  // namespace
}  // namespace lapidary::import
