#pragma once

#include <initializer_list>
#include <optional>

#include "description/color_readers.h"
#include "description/emission.h"
#include "schema/declaration.h"

namespace lapidary::description {

/// The ways in which scenes say how bright something is: four quantities in watts, and the same
/// four as the eye weighs them.
enum class Strength { radiance, power, intensity, irradiance, nits, lumens, candela, lux };

/// How scenes say how bright something is: one strength, and its colour where the strength is a
/// number.
struct EmissionParameters {
  std::optional<Spectrum> radiance;
  std::optional<double> power, intensity, irradiance;
  std::optional<double> nits, lumens, candela, lux;
  std::optional<Spectrum> color;
  std::optional<double> temperature;
};

/// The spectrum and quantity said; fails through `context` unless exactly one strength is given,
/// and where light that nobody sees is to be so and so bright to the eye. `allowed` names the
/// strengths that the node declares.
Emission to_emission(const EmissionParameters& e, std::initializer_list<Strength> allowed,
                     const schema::Context& context);

/// The same where the strength may be left out, too: nothing then.
std::optional<Emission> to_stated_emission(const EmissionParameters& e,
                                           std::initializer_list<Strength> allowed,
                                           const schema::Context& context);

/// The intensity [W/(sr nm)] that is one candela of the colour said; fails as `to_emission`.
Spectrum one_candela(const EmissionParameters& e, const schema::Context& context);

/// What is to be known of a strength that is a number.
struct StrengthInfo {
  std::string_view name;
  std::optional<double> EmissionParameters::*number;  ///< null for radiance, a colour
  schema::Unit unit;
};
StrengthInfo info_of(Strength strength);

/// What help says about a strength where `allowed` are to choose from.
std::string strength_doc(Strength strength, std::initializer_list<Strength> allowed);

/// Declares the strengths `allowed` and the colour of light for T, which derives from
/// EmissionParameters.
template <typename T>
schema::Declaration<T>& declare_emission(schema::Declaration<T>& d,
                                         std::initializer_list<Strength> allowed) {
  using E = EmissionParameters;
  using schema::Unit;
  for (const Strength strength : allowed) {
    const StrengthInfo info = info_of(strength);
    std::string doc = strength_doc(strength, allowed);
    if (info.number == nullptr) {
      d.template parameter<Optional<LightReader>>(std::string(info.name), &E::radiance,
                                                  {.doc = std::move(doc), .unit = info.unit});
    } else {
      d.parameter(std::string(info.name), info.number,
                  {.doc = std::move(doc), .unit = info.unit, .range = schema::non_negative});
    }
  }
  return d
      .template parameter<Optional<LightReader>>(
          "color", &E::color,
          {.doc = "Colour of the light, of any brightness, where its strength is a number; "
                  "daylight (D65) when left out."})
      .parameter("temperature", &E::temperature,
                 {.doc = "Colour of a glowing body, instead of 'color'.",
                  .unit = Unit::kelvin,
                  .range = {.min = 500, .max = 100000}});
}

}  // namespace lapidary::description
