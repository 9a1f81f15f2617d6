#include <cmath>

#include <gmock/gmock.h>

#include "image/image_io.h"
#include "import/mtl_material.h"
#include "temp_folder.h"

namespace lapidary::import {
namespace {

using description::Matte;
using description::Metal;
using testing::HasSubstr;

class MtlTextureTest : public testing::Test {
 protected:
  /// The material of an MTL file in the folder.
  description::MaterialPtr material(std::string_view mtl) {
    const auto file = folder_.path() / "a.mtl";
    const auto materials = parse_mtl("newmtl m\n" + std::string(mtl), file, nullptr);
    return to_material(materials.at(0), {&warnings_, &images_});
  }
  Rgb matte_color(std::string_view mtl, Vec2d uv = {0.25, 0.25}) {
    return std::get<Matte>(material(mtl)->model).color.rgb_at({.uv = uv});
  }
  double metal_roughness(std::string_view mtl) {
    return std::get<Metal>(material(mtl)->model).roughness.at({.uv = {0.25, 0.25}});
  }
  std::string warning() {
    const auto all = warnings_.take();
    return all.size() == 1 ? to_string(all[0]) : std::to_string(all.size()) + " warnings";
  }
  /// Two by two pixels, linear: red and green above, blue and white below.
  void write_picture(const std::string& name) {
    image::Image picture(2, 2);
    picture.pixels = {0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 1, 1, 1};
    image::write_image(folder_.path() / name, picture);
  }

  TempFolder folder_;
  WarningLog warnings_;
  ImageFiles images_;
};

TEST_F(MtlTextureTest, ColorsAreThoseOfThePicture) {
  write_picture("p.exr");
  for (const char* kd : {"", "Kd 0 0 0\n", "Kd 0.8 0.8 0.8\n", "Kd 1 1 1\n"}) {
    EXPECT_EQ(matte_color(std::string(kd) + "map_Kd p.exr\n", {0.25, 0.25}), (Rgb{0, 0, 0.5f}))
        << kd;
    EXPECT_EQ(matte_color(std::string(kd) + "map_Kd p.exr\n", {0.25, 0.75}), (Rgb{0.5f, 0, 0}))
        << kd;
  }
  EXPECT_NEAR(matte_color("Kd 0.5 0.5 0.5\nmap_Kd p.exr\n").b, 0.25f, 1e-5f);
  EXPECT_EQ(warning(), "0 warnings");
}

TEST_F(MtlTextureTest, OptionsPlaceThem) {
  write_picture("p.exr");
  EXPECT_EQ(matte_color("map_Kd -o 0.5 p.exr\n"), (Rgb{1, 1, 1}));
  EXPECT_EQ(matte_color("map_Kd -o 0 0.5 p.exr\n"), (Rgb{0.5f, 0, 0}));
  EXPECT_EQ(matte_color("map_Kd -s 3 1 p.exr\n"), (Rgb{1, 1, 1}));
  EXPECT_EQ(matte_color("map_Kd -clamp on p.exr\n", {-3, 0.25}), (Rgb{0, 0, 0.5f}));
  EXPECT_NEAR(matte_color("map_Kd -mm 0.25 0.5 p.exr\n").b, 0.5f, 1e-5f);
}

TEST_F(MtlTextureTest, AreFoundAsProgramsWriteThem) {
  std::filesystem::create_directories(folder_.path() / "Maps");
  write_picture("Maps/P.exr");
  EXPECT_EQ(matte_color("map_Kd maps\\p.EXR\n"), (Rgb{0, 0, 0.5f}));
}

TEST_F(MtlTextureTest, MetalsHaveColorsAndRoughness) {
  write_picture("p.exr");
  const auto metal = material("Pm 1\nmap_Kd p.exr\nmap_Pr -imfchan b p.exr\n");
  const auto& surface = std::get<texture::Color>(std::get<Metal>(metal->model).surface);
  EXPECT_EQ(surface.rgb_at({.uv = {0.25, 0.25}}), (Rgb{0, 0, 0.5f}));
  EXPECT_NEAR(metal_roughness("Pm 1\nmap_Pr -imfchan b p.exr\n"), 0.5, 1e-6);
  // The exponent is 60 times the picture's 0.5.
  EXPECT_NEAR(metal_roughness("Pm 1\nNs 60\nmap_Ns -imfchan b p.exr\n"), std::pow(2.0 / 32, 0.25),
              1e-6);
  EXPECT_EQ(warning(), "0 warnings");
}

TEST_F(MtlTextureTest, SurfacesHaveGapsBumpsAndNormals) {
  write_picture("p.exr");
  const auto leaf = material("map_d -imfchan b p.exr\nbump -bm 0.1 -imfchan b p.exr\nnorm p.exr\n");
  const texture::Lookup blue{.uv = {0.25, 0.25}};
  EXPECT_NEAR(leaf->detail.opacity.at(blue), 0.5, 1e-6);
  EXPECT_NEAR(leaf->detail.bump->at(blue), 0.05, 1e-6);
  EXPECT_EQ(leaf->detail.normal->rgb_at(blue), (Rgb{0, 0, 0.5f}));
  EXPECT_FALSE(material("map_Kd p.exr\n")->detail.has_relief());
  EXPECT_EQ(warning(), "0 warnings");
}

TEST_F(MtlTextureTest, ColorsWithAlphaAreTheGaps) {
  image::Image picture(1, 1, 4);
  picture.pixels = {0.5f, 0.25f, 0.125f, 0.75f};
  image::write_image(folder_.path() / "leaf.exr", picture);
  const auto leaf = material("map_Kd leaf.exr\nmap_d leaf.exr\n");
  EXPECT_NEAR(leaf->detail.opacity.at({}), 0.75, 1e-6);
  EXPECT_EQ(std::get<Matte>(leaf->model).color.rgb_at({}), (Rgb{0.5f, 0.25f, 0.125f}));
}

TEST_F(MtlTextureTest, WhatGlowsHasAPattern) {
  write_picture("p.exr");
  const auto sign = material("Ke 3 3 3\nmap_Ke p.exr\n");
  const auto& glow = std::get<description::Emissive>(sign->model);
  EXPECT_EQ(glow.pattern.rgb_at({.uv = {0.25, 0.25}}), (Rgb{0, 0, 0.5f}));
}

TEST_F(MtlTextureTest, WhatIsWrongIsReported) {
  folder_.write("text.png", "no picture");
  EXPECT_NEAR(matte_color("map_Kd none.png\n").g, 0.8f, 1e-5f);
  EXPECT_THAT(warning(), HasSubstr("a.mtl:2:1: texture 'none.png' of material 'm' is not there"));
  matte_color("map_Kd text.png\n");
  EXPECT_THAT(warning(), HasSubstr("is not a picture in a known format; it is left out"));
  write_picture("p.exr");
  matte_color("map_Kd p.exr\nmap_Ka p.exr\ndisp p.exr\n");
  EXPECT_THAT(warning(), HasSubstr("material 'm': 2 of its textures are left out"));
}

}  // namespace
}  // namespace lapidary::import
