#include "import/mtl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lapidary::import {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<MtlMaterial> parse(std::string_view text, WarningLog* warnings = nullptr) {
  return parse_mtl(text, "folder/test.mtl", warnings);
}

MtlMaterial parse_one(std::string_view body) {
  const auto materials = parse("newmtl m\n" + std::string(body));
  EXPECT_EQ(materials.size(), 1);
  return materials.at(0);
}

std::string texture(std::string_view statement) {
  const auto textures = parse_one(statement).textures;
  return textures.size() == 1 ? textures[0].file.string() : "not one texture";
}

TEST(Mtl, ReadsAllStatements) {
  const MtlMaterial m = parse_one(
      "Ka 1 1 1\nKd 0.25 0.5 0.75\nKs 1 0 0\nKe 0 2e1 0\nTf 0.5 0.5 1\nNs 96.5\nNi 1.45\n"
      "d 0.25\nillum 7\nPr 0.3\nPm 1\nPs 0.1\naniso 0.2\n");
  EXPECT_EQ(m.name, "m");
  EXPECT_EQ(m.diffuse, (Rgb{0.25F, 0.5F, 0.75F}));
  EXPECT_EQ(m.specular, (Rgb{1, 0, 0}));
  EXPECT_EQ(m.emission, (Rgb{0, 20, 0}));
  EXPECT_EQ(m.transmission, (Rgb{0.5F, 0.5F, 1}));
  EXPECT_EQ(m.shininess, 96.5);
  EXPECT_EQ(m.index, 1.45);
  EXPECT_EQ(m.dissolve, 0.25);
  EXPECT_EQ(m.illum, 7);
  EXPECT_EQ(m.roughness, 0.3);
  EXPECT_EQ(m.metallic, 1.0);
  EXPECT_EQ(m.where, (Location{.file = "folder/test.mtl", .line = 1, .column = 1}));
}

TEST(Mtl, LeavesDefaultsForWhatIsNotStated) {
  const MtlMaterial m = parse_one("");
  EXPECT_EQ(m.diffuse, (Rgb{0.8F, 0.8F, 0.8F}));
  EXPECT_EQ(m.specular, Rgb{});
  EXPECT_EQ(m.transmission, (Rgb{1, 1, 1}));
  EXPECT_EQ(m.dissolve, 1);
  EXPECT_FALSE(m.index || m.illum || m.roughness || m.metallic);
}

TEST(Mtl, ReadsSeveralMaterialsAndNamesWithBlanks) {
  const auto materials =
      parse("# head\r\nnewmtl  red paint \r\n\tKd 1 0 0\r\n newmtl 1\r\nKd 0 1 0");
  ASSERT_EQ(materials.size(), 2);
  EXPECT_EQ(materials[0].name, "red paint");
  EXPECT_EQ(materials[0].diffuse, (Rgb{1, 0, 0}));
  EXPECT_EQ(materials[1].name, "1");
  EXPECT_EQ(materials[1].diffuse, (Rgb{0, 1, 0}));
  EXPECT_EQ(parse("\xEF\xBB\xBFnewmtl a\n").at(0).name, "a");
}

TEST(Mtl, TakesOneNumberForGrey) {
  EXPECT_EQ(parse_one("Kd 0.5\n").diffuse, (Rgb{0.5F, 0.5F, 0.5F}));
  EXPECT_EQ(parse_one("Kd 0.5 # grey\n").diffuse, (Rgb{0.5F, 0.5F, 0.5F}));
}

TEST(Mtl, DissolveOutranksTransparency) {
  EXPECT_EQ(parse_one("Tr 0.75\n").dissolve, 0.25);
  EXPECT_EQ(parse_one("d 0.75\nTr 0.5\n").dissolve, 0.75);
  EXPECT_EQ(parse_one("Tr 0.5\nd 0.75\n").dissolve, 0.75);
  EXPECT_EQ(parse_one("d -halo 0.5\n").dissolve, 0.5);
  const auto two = parse("newmtl a\nd 0.5\nnewmtl b\nTr 0.75\n");
  EXPECT_EQ(two.at(1).dissolve, 0.25);
}

TEST(Mtl, KnowsTheChannelsOfTextures) {
  using enum MtlChannel;
  const MtlMaterial m = parse_one(
      "map_Ka a\nmap_Kd b\nmap_Ks c\nmap_Ke d\nmap_Ns e\nmap_d f\nmap_Bump g\nbump h\nnorm i\n"
      "disp j\ndecal k\nrefl l\nmap_Pr m\nmap_Pm n\nmap_Ps o\n");
  std::vector<MtlChannel> channels;
  for (const MtlTexture& t : m.textures) channels.push_back(t.channel);
  EXPECT_THAT(channels,
              ElementsAre(ambient, diffuse, specular, emission, shininess, dissolve, bump, bump,
                          normal, displacement, decal, reflection, roughness, metallic, sheen));
  EXPECT_EQ(m.textures[2].where.line, 4);
}

TEST(Mtl, FindsTextureNamesAmongOptions) {
  EXPECT_EQ(texture("map_Kd a.png"), "folder/a.png");
  EXPECT_EQ(texture("map_Kd  my file 01.png \n"), "folder/my file 01.png");
  EXPECT_EQ(texture("map_Kd -clamp on a.png"), "folder/a.png");
  EXPECT_EQ(texture("map_Kd -o 0.1 a.png"), "folder/a.png");
  EXPECT_EQ(texture("map_Kd -s 1 2 -t 1 2 3 -mm 0 1 a  b.png"), "folder/a  b.png");
  EXPECT_EQ(texture("map_bump -imfchan r a.png -bm 1.5"), "folder/a.png");
  EXPECT_EQ(texture("refl -type cube_top cube_top"), "folder/cube_top");
  EXPECT_EQ(texture("map_Kd ..\\maps\\a.png"), "maps/a.png");
  EXPECT_EQ(texture("map_Kd -texres 512 01.png"), "folder/01.png");
}

TEST(Mtl, TellsWhatItIgnores) {
  WarningLog log;
  const auto materials =
      parse("newmtl a\nKd spectral file.rfl 1\nKs xyz 1 1 1\nillum 99\nmap_Kd -bm 1\n", &log);
  EXPECT_EQ(materials.at(0).diffuse, (Rgb{0.8F, 0.8F, 0.8F}));
  EXPECT_TRUE(materials[0].textures.empty());
  EXPECT_EQ(log.take().size(), 4);
}

TEST(Mtl, IgnoresStatementsThatBelongToNoMaterialOrMeanNothing) {
  EXPECT_TRUE(parse("Kd 1 0 0\nnonsense\n").empty());
  EXPECT_EQ(parse("newmtl a\nxyzzy 1 2 3\n").size(), 1);
  EXPECT_TRUE(parse("").empty());
}

TEST(Mtl, RefusesNumbersThatAreNone) {
  for (const char* body : {"Kd 1 2", "Kd red", "Kd", "Ns", "Ni nan", "d inf", "Kd 1 2,5 3",
                           "Pr 1e99", "illum two", "Kd 1 1 1x"}) {
    try {
      parse_one(body);
      ADD_FAILURE() << body;
    } catch (const Error& error) {
      EXPECT_EQ(error.where().file, "folder/test.mtl");
      EXPECT_EQ(error.where().line, 2) << body;
      EXPECT_GT(error.where().column, 1) << body;
    }
  }
}

TEST(Mtl, NamesTheMissingFile) {
  try {
    read_mtl("no/such.mtl", nullptr);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no/such.mtl"));
  }
}

TEST(Mtl, TextureOptions) {
  const auto options = [](std::string_view statement) {
    return parse_one(statement).textures.at(0).options;
  };
  const auto all =
      options("map_Kd -s 2 3 1 -o 0.5 -mm 0.1 0.9 -clamp on -imfchan g -bm 0.3 a b.png");
  EXPECT_EQ(all.scale, (Vec2d{2, 3}));
  EXPECT_EQ(all.offset, (Vec2d{0.5, 0}));
  EXPECT_EQ(all.base, 0.1);
  EXPECT_EQ(all.gain, 0.9);
  EXPECT_TRUE(all.clamp);
  EXPECT_EQ(all.scalar_channel, 'g');
  EXPECT_EQ(all.bump_multiplier, 0.3);
  const auto none = options("map_Kd a.png");
  EXPECT_EQ(none.scale, (Vec2d{1, 1}));
  EXPECT_EQ(none.gain, 1);
  EXPECT_FALSE(none.clamp);
  EXPECT_FALSE(none.bump_multiplier);
  EXPECT_EQ(options("map_Kd -s 2 a.png").scale, (Vec2d{2, 1}));
  EXPECT_EQ(options("bump a.png -bm 0.5").bump_multiplier, 0.5);
  EXPECT_EQ(parse_one("map_Kd -s 2 ..\\maps\\a b.png -clamp on").textures.at(0).stated,
            "..\\maps\\a b.png");
}

}  // namespace
}  // namespace lapidary::import
