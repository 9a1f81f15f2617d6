#include <array>
#include <span>

#include "spectrum/catalogue_name.h"
#include "spectrum/refractive_index.h"

namespace lapidary {
namespace {

// All as collected by refractiveindex.info (public domain, CC0). Its formula 1 gives the
// wavelengths of the resonances, formula 2 their squares.

/// Sellmeier's equation with resonances at wavelengths, in micrometres.
RefractiveIndex with_resonances(std::array<double, 3> b, std::array<double, 3> um) {
  return RefractiveIndex::sellmeier({0.0, b, {um[0] * um[0], um[1] * um[1], um[2] * um[2]}});
}

/// SCHOTT, Zemax catalogue of 2017-01-20, in air at 20 degrees Celsius; 0.3-2.5 um.
RefractiveIndex n_bk7() {
  return RefractiveIndex::sellmeier(
      {0.0, {1.03961212, 0.231792344, 1.01046945}, {0.00600069867, 0.0200179144, 103.560653}});
}

/// SCHOTT, as above; 0.37-2.5 um.
RefractiveIndex n_sf11() {
  return RefractiveIndex::sellmeier(
      {0.0, {1.73759695, 0.313747346, 1.89878101}, {0.013188707, 0.0623068142, 155.23629}});
}

/// Malitson 1965, J. Opt. Soc. Am. 55, 1205-1208; 0.21-3.71 um, 20 degrees Celsius.
RefractiveIndex fused_silica() {
  return with_resonances({0.6961663, 0.4079426, 0.8974794}, {0.0684043, 0.1162414, 9.896161});
}

/// Peter 1923, Zeitschrift fuer Physik 15, 358-368; 0.226-0.760 um.
RefractiveIndex diamond() {
  return with_resonances({0.3306, 4.3356, 0.0}, {0.1750, 0.1060, 0.0});
}

/// Ordinary ray: Malitson & Dodge 1972, J. Opt. Soc. Am. 62, 1405; Dodge 1986, Handbook of Laser
/// Science and Technology IV, p. 30; 0.2-5 um, 20 degrees Celsius.
RefractiveIndex sapphire() {
  return with_resonances({1.4313493, 0.65054713, 5.3414021}, {0.0726631, 0.1193242, 18.028251});
}

/// Hale & Querry 1973, Applied Optics 12, 555-563; 25 degrees Celsius.
RefractiveIndex water() {
  return RefractiveIndex::table(
      {350.0, 25.0, {1.343f, 1.341f, 1.339f, 1.338f, 1.337f, 1.336f, 1.335f,
                     1.334f, 1.333f, 1.333f, 1.332f, 1.332f, 1.331f, 1.331f,
                     1.331f, 1.330f, 1.330f, 1.330f, 1.329f, 1.329f, 1.329f}});
}

struct Glass {
  std::string_view name;
  std::string_view alias;  ///< as `catalogue_key` makes it; empty when there is none
  RefractiveIndex (*index)();
};

constexpr Glass glasses[] = {
    {"N-BK7", "bk7", n_bk7},  {"N-SF11", "", n_sf11},     {"fused silica", "silica", fused_silica},
    {"diamond", "", diamond}, {"sapphire", "", sapphire}, {"water", "", water},
};

}  // namespace

std::optional<RefractiveIndex> find_glass(std::string_view name) {
  const std::string key = catalogue_key(name);
  for (const Glass& glass : glasses) {
    if (key == catalogue_key(glass.name) || (!key.empty() && key == glass.alias)) {
      return glass.index();
    }
  }
  return std::nullopt;
}

std::vector<std::string> glass_names() {
  std::vector<std::string> names;
  for (const Glass& glass : glasses) names.emplace_back(glass.name);
  return names;
}

}  // namespace lapidary
