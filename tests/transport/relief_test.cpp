#include "transport/relief.h"

#include <random>

#include <gtest/gtest.h>

#include "texture/texture.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

constexpr Vec3d up{0, 0, 1};

/// A plane through the origin with u along x and v along y.
struct Ground {
  geometry::Surface surface;
  transport::SurfaceLookup lookup;

  Ground() {
    surface.geometric_normal = surface.shading_normal = up;
    lookup.dpdx = lookup.at.dpdx = {0.01, 0, 0};
    lookup.dpdy = lookup.at.dpdy = {0, 0.01, 0};
    lookup.at.duvdx = {0.01, 0};
    lookup.at.duvdy = {0, 0.01};
    lookup.dpdu = {1, 0, 0};
    lookup.dpdv = {0, 1, 0};
  }
  Vec3d normal(const bsdf::SurfaceDetail& detail, Vec3d direction = {0, 0, -1}) const {
    return transport::relief_normal(detail, surface, lookup, direction);
  }
};

texture::Color picture_of(Vec3d n) {
  const auto code = [](double x) { return static_cast<float>(0.5 * x + 0.5); };
  return Spectrum::reflectance({code(n.x), code(n.y), code(n.z)});
}

TEST(Relief, PicturesOfNormalsAreInTheTangentFrame) {
  const Vec3d stated = normalize(Vec3d{0.3, -0.2, 0.9});
  bsdf::SurfaceDetail detail;
  detail.normal = picture_of(stated);
  Ground ground;
  EXPECT_NEAR(length(ground.normal(detail) - stated), 0.0, 1e-6);
  // Turned texture coordinates turn it along, mirrored ones mirror it.
  ground.lookup.dpdu = {0, 2, 0}, ground.lookup.dpdv = {-2, 0, 0};
  EXPECT_NEAR(length(ground.normal(detail) - Vec3d{-stated.y, stated.x, stated.z}), 0.0, 1e-6);
  ground.lookup.dpdu = {1, 0, 0}, ground.lookup.dpdv = {0, -1, 0};
  EXPECT_NEAR(length(ground.normal(detail) - Vec3d{stated.x, -stated.y, stated.z}), 0.0, 1e-6);
}

TEST(Relief, IsNeverSeenFromBehind) {
  bsdf::SurfaceDetail detail;
  detail.normal = picture_of(normalize(Vec3d{0.9, 0, 0.3}));
  const Vec3d grazing = normalize(Vec3d{1, 0, -0.05});
  const Vec3d n = Ground().normal(detail, grazing);
  EXPECT_LT(dot(n, grazing), 0.0);
  EXPECT_NEAR(length(n), 1.0, 1e-12);
}

// With how little care the colour is looked at makes no slopes.
TEST(Relief, OfPicturesIsNoMatterOfChance) {
  image::Image grain(64, 64, 1);
  std::mt19937 random(4);
  for (float& v : grain.pixels) v = static_cast<float>(random() >> 24) / 255.0f;
  const texture::Picture picture{std::make_shared<const texture::Pyramid>(grain)};
  bsdf::SurfaceDetail detail;
  detail.bump = texture::Number(std::make_shared<const texture::Texture>(picture));
  Ground ground;
  ground.lookup.at.uv = {0.34, 0.61};
  ground.lookup.at.duvdx = {0.08, 0};
  ground.lookup.at.duvdy = {0, 0.04};
  const Vec3d mean = ground.normal(detail);
  EXPECT_NE(mean, up);
  for (const auto care : {texture::Lookup::Care::draw, texture::Lookup::Care::glance}) {
    ground.lookup.at.care = care;
    EXPECT_EQ(ground.normal(detail), mean);
  }
}

TEST(Relief, OfConstantHeightIsNone) {
  bsdf::SurfaceDetail detail;
  detail.bump = texture::Number(0.7);
  EXPECT_EQ(Ground().normal(detail), up);
}

// A mirror that looks flat to rays but is tilted for light: the sky is seen where the picture of
// normals says.
TEST(Relief, TurnsReflections) {
  const Vec3d stated = normalize(Vec3d{0.2, 0.1, 1.0});
  auto mirror = std::make_shared<description::Material>(*metal(1.0));
  mirror->detail.normal = picture_of(stated);
  TinyScene tiny;
  tiny.add(geometry::Rectangle{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, mirror);
  const Vec3d incoming{0, 0, -1};
  const Vec3d outgoing = incoming - stated * (2.0 * dot(incoming, stated));
  tiny.add(geometry::Sphere{outgoing * 10.0, 0.2}, lamp(4.0));
  const RunningMean seen =
      radiance(tiny.build(), ray({0, 0, 3}, incoming), {.pixels = 4, .samples = 4});
  EXPECT_NEAR(seen.mean(), 4.0, 1e-3);
}

// The factor that softens the terminator never adds light and is 1 where normals agree.
TEST(Relief, SofteningTakesOnlyLightAway) {
  transport::Vertex vertex;
  vertex.surface.geometric_normal = up;
  vertex.frame = Frame::from_normal(normalize(Vec3d{0.5, 0, 1}));
  vertex.wo = vertex.frame.to_local(up);
  for (double angle = 0.01; angle < 1.57; angle += 0.05) {
    const Vec3d wi{std::sin(angle), 0, std::cos(angle)};
    const double share = transport::terminator_share(vertex, wi, vertex.frame.to_local(wi));
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    if (angle > 1.5) {
      EXPECT_LT(share, 0.3) << "near the horizon of the shape";
    }
  }
  vertex.frame = Frame::from_normal(up);
  EXPECT_EQ(transport::terminator_share(vertex, {0.6, 0, 0.8}, {0.6, 0, 0.8}), 1.0);
}

}  // namespace
}  // namespace lapidary::test
