#include "scene/prepare_light.h"

#include <fmt/format.h>

#include "image/image_io.h"
#include "light/ies_file.h"
#include "light/sky.h"

namespace lapidary::scene {
namespace {

using description::Emission;
using description::Quantity;

Spectrum divided(const Spectrum& spectrum, double divisor) {
  return spectrum.scaled(static_cast<float>(1.0 / divisor));
}

light::Light prepare(const description::PointLight& p, const LightPreparation& with) {
  // Transport measures distances in scene units, so intensity is per square scene unit.
  const double square = with.metres * with.metres;
  const double to_intensity = p.emission.quantity == Quantity::power ? 4.0 * pi : 1.0;
  return light::PointLight{p.position, divided(p.emission.spectrum, to_intensity * square)};
}

light::Light prepare(const description::ProfileLight& p, const LightPreparation& with) {
  auto profile = std::make_shared<const light::PhotometricWeb>(light::read_ies(p.file, with.files));
  const double to_candela = p.emission.quantity == Quantity::power ? profile->flux() : 1.0;
  return light::ProfileLight({p.position, p.axis, p.up}, std::move(profile),
                             divided(p.emission.spectrum, to_candela * with.metres * with.metres));
}

light::Light prepare(const description::SpotLight& s, const LightPreparation& with) {
  const double outer = radians(0.5 * s.angle);
  const light::SpotLight::Cone cone{s.at - s.from, outer * (1.0 - s.penumbra), outer};
  const double square = with.metres * with.metres;
  const double to_intensity =
      s.emission.quantity == Quantity::power ? light::SpotLight::effective_solid_angle(cone) : 1.0;
  return light::SpotLight(s.from, cone, divided(s.emission.spectrum, to_intensity * square));
}

light::Light prepare(const description::DistantLight& d, const LightPreparation&) {
  return light::DistantLight({-d.direction, radians(0.5 * d.angle)}, d.emission.spectrum);
}

light::Light prepare(const description::ConstantEnvironment& e, const LightPreparation&) {
  return light::ConstantEnvironment{e.radiance};
}

light::Light prepare(const description::ImageEnvironment& e, const LightPreparation& with) {
  const image::Image image = image::read_image(e.file, {.files = with.files});
  light::ImageEnvironment::Picture picture;
  picture.width = static_cast<std::size_t>(image.width);
  picture.rotation = radians(e.rotate);
  picture.pixels.reserve(picture.width * static_cast<std::size_t>(image.height));
  const auto scale = static_cast<float>(e.scale);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Rgb c = image.rgb(x, y);
      if (!std::isfinite(c.r) || !std::isfinite(c.g) || !std::isfinite(c.b)) {
        throw file_error(e.file.string(),
                         fmt::format("pixel ({}, {}) is not a finite colour", x, y),
                         "an environment needs a radiance in every direction");
      }
      picture.pixels.push_back({c.r * scale, c.g * scale, c.b * scale});
    }
  }
  return light::ImageEnvironment(std::move(picture));
}

std::vector<light::Light> prepare(const description::Sky& s, const LightPreparation&) {
  light::Sky sky = light::make_sky({s.to_sun, {s.turbidity, s.ground_albedo}, s.scale});
  std::vector<light::Light> lights{light::ImageEnvironment(std::move(sky.picture))};
  const bool is_up = sky.sun.influence().strength > 0.0;
  if (s.sun == description::Sky::Sun::shines && is_up) lights.emplace_back(std::move(sky.sun));
  return lights;
}

std::vector<light::Light> as_list(light::Light light) {
  return {std::move(light)};
}
std::vector<light::Light> as_list(std::vector<light::Light> lights) {
  return lights;
}

}  // namespace

std::vector<light::Light> prepare_lights(const description::Light& light,
                                         const LightPreparation& preparation) {
  return std::visit([&](const auto& model) { return as_list(prepare(model, preparation)); },
                    light.model);
}

Spectrum SurfaceLights::radiance(const Emission& emission, double area) const {
  if (emission.quantity != Quantity::power) return emission.spectrum;
  return divided(emission.spectrum, pi * area * metres_ * metres_);
}

light::Light SurfaceLights::solid(const geometry::PlacedSolid& solid, const Emission& emission,
                                  const schema::CallSite& where) const {
  const double area = geometry::area(solid);
  if (!std::isfinite(area)) {
    throw Error(where.location(), "a solid without bounds cannot be a light",
                "give a bounded solid the emissive material, or use an environment");
  }
  const Spectrum L = radiance(emission, area);
  const auto* sphere = std::get_if<geometry::Sphere>(&solid.shape());
  if (sphere != nullptr && solid.space() == geometry::PlacedSolid::Space::world) {
    return light::SphereLight(sphere->center, sphere->radius, L);
  }
  return light::SolidLight(solid, L);
}

light::Light SurfaceLights::combination(std::shared_ptr<const geometry::CompoundSurface> surface,
                                        const light::CombinationLight::Place& place, double area,
                                        const Emission& emission) const {
  const bool is_dark = emission.quantity == Quantity::power && !(area > 0.0);
  return light::CombinationLight(std::move(surface), place, area,
                                 is_dark ? Spectrum::constant(0.0f) : radiance(emission, area));
}

light::Light SurfaceLights::sheet(const geometry::Sheet& sheet, const Emission& emission) const {
  const Spectrum L = radiance(emission, geometry::area(sheet));
  if (const auto* rectangle = std::get_if<geometry::Rectangle>(&sheet)) {
    return light::RectangleLight(*rectangle, L);
  }
  return light::DiskLight(std::get<geometry::Disk>(sheet), L);
}

light::Light SurfaceLights::mesh(const geometry::MeshPlacement& placement,
                                 std::span<const std::uint32_t> chosen,
                                 const Emission& emission) const {
  const geometry::TriangleMesh& mesh = *placement.mesh;
  double area = 0.0;
  for (const std::uint32_t triangle : chosen) {
    const auto& corner = mesh.triangles[triangle];
    const Transform& world = placement.world_from_mesh;
    const Vec3d p0 = world.point(mesh.position(corner[0]));
    area += 0.5 * length(cross(world.point(mesh.position(corner[1])) - p0,
                               world.point(mesh.position(corner[2])) - p0));
  }
  const Spectrum L = area > 0.0 ? radiance(emission, area) : Spectrum::constant(0.0f);
  return light::MeshLight(mesh, chosen, placement.world_from_mesh, L);
}

}  // namespace lapidary::scene
