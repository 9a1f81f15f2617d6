#include "import/mtl_material.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lapidary::import {
namespace {

using description::Emissive;
using description::Glass;
using description::Matte;
using description::Metal;

description::MaterialPtr material_of(std::string_view mtl, WarningLog* warnings = nullptr) {
  const auto materials = parse_mtl("newmtl m\n" + std::string(mtl), "a.mtl", nullptr);
  return to_material(materials.at(0), {.warnings = warnings});
}

template <typename Model>
Model model_of(std::string_view mtl) {
  return std::get<Model>(material_of(mtl)->model);
}

double at(double nm, const texture::Color& color) {
  return color.constant()->spectrum.at(nm);
}

TEST(MtlMaterial, DiffuseIsMatte) {
  const auto matte = model_of<Matte>("Kd 0.2 0.4 0.6\nKs 0.5 0.5 0.5\nNs 100\nillum 2\n");
  EXPECT_LT(at(650.0, matte.color), at(450.0, matte.color));
  EXPECT_NEAR(at(550.0, model_of<Matte>("").color), 0.8, 1e-3);
  EXPECT_LE(at(550.0, model_of<Matte>("Kd 3 3 3\n").color), 1.0);
  EXPECT_GE(at(550.0, model_of<Matte>("Kd -1 -1 -1\n").color), 0.0);
}

TEST(MtlMaterial, WhatGlowsIsEmissive) {
  const auto glow = model_of<Emissive>("Kd 0.5 0.5 0.5\nKe 2 2 2\nd 0.5\n");
  EXPECT_EQ(glow.emission.quantity, description::Quantity::radiance);
  EXPECT_NEAR(glow.emission.spectrum.integral(), 2.0, 1e-3);
}

TEST(MtlMaterial, WhatLetsLightPassIsGlass) {
  EXPECT_EQ(model_of<Glass>("Ni 1.7\nd 0.1\n").index.at(500.0), 1.7);
  EXPECT_EQ(model_of<Glass>("Ni 1.33\nillum 7\n").index.at(500.0), 1.33);
  EXPECT_EQ(model_of<Glass>("d 0\n").index.at(500.0), 1.5);
  EXPECT_EQ(model_of<Glass>("Ni 1\nd 0\n").index.at(500.0), 1.5) << "1 would be air";
  EXPECT_EQ(model_of<Glass>("Tr 0.9\nPr 0.4\n").roughness.at({}), 0.4);
  EXPECT_EQ(model_of<Glass>("d 0\nNs 10\n").roughness.at({}), 0.0);
}

TEST(MtlMaterial, WhatOnlyReflectsIsMetal) {
  EXPECT_EQ(model_of<Metal>("Pm 1\nPr 0.25\nKd 1 0.8 0.3\n").roughness.at({}), 0.25);
  const auto mirror = model_of<Metal>("Kd 0 0 0\nKs 0.9 0.9 0.9\nillum 3\n");
  EXPECT_EQ(mirror.roughness.at({}), 0.0);
  EXPECT_NEAR(at(550.0, std::get<texture::Color>(mirror.surface)), 0.9, 1e-3);
  // alpha^2 = 2 / (Ns + 2), and roughness^2 = alpha.
  EXPECT_NEAR(model_of<Metal>("Kd 0 0 0\nKs 1 1 1\nNs 30\n").roughness.at({}),
              std::sqrt(std::sqrt(2.0 / 32.0)), 1e-12);
  EXPECT_NO_THROW(model_of<Matte>("Pm 0\nKd 0 0 0\nKs 1 1 1\n"));
  EXPECT_NO_THROW(model_of<Matte>("Kd 0 0 0\n"));
}

TEST(MtlMaterial, TexturesThatCannotBeReadAreReported) {
  WarningLog log;
  const auto material = material_of("Kd 0 0 0\nmap_Kd wood.png\n", &log);
  EXPECT_NEAR(at(550.0, std::get<Matte>(material->model).color), 0.8, 1e-3);
  const auto warnings = log.take();
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(to_string(warnings[0]),
              testing::HasSubstr("material 'm': 1 of its textures is left out"));
}

TEST(MtlMaterial, KeepsNameAndPlace) {
  const auto material = material_of("");
  EXPECT_EQ(material->name, "m");
  EXPECT_EQ(material->where.location().file, "a.mtl");
  EXPECT_EQ(material->where.location().line, 1);
}

}  // namespace
}  // namespace lapidary::import
