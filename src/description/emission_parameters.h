#pragma once

#include <initializer_list>
#include <optional>

#include "description/color_readers.h"
#include "description/emission.h"
#include "schema/declaration.h"

namespace lapidary::description {

/// How scenes say how bright something is: one strength, and its colour where the strength is a
/// number.
struct EmissionParameters {
  std::optional<Spectrum> radiance;
  std::optional<double> power, intensity, irradiance;
  std::optional<Spectrum> color;
  std::optional<double> temperature;
};

/// The spectrum and quantity said; fails through `context` unless exactly one strength is given.
/// `allowed` names the strengths that the node declares.
Emission to_emission(const EmissionParameters& e, std::initializer_list<Quantity> allowed,
                     const schema::Context& context);

/// What help says about a strength where `allowed` are to choose from.
std::string strength_doc(Quantity quantity, std::initializer_list<Quantity> allowed);

/// Declares the strengths `allowed` and the colour of light for T, which derives from
/// EmissionParameters.
template <typename T>
schema::Declaration<T>& declare_emission(schema::Declaration<T>& d,
                                         std::initializer_list<Quantity> allowed) {
  using E = EmissionParameters;
  using schema::Unit;
  for (const Quantity quantity : allowed) {
    switch (quantity) {
      case Quantity::radiance:
        d.template parameter<Optional<LightReader>>(
            "radiance", &E::radiance,
            {.doc = strength_doc(quantity, allowed), .unit = Unit::radiance});
        break;
      case Quantity::power:
        d.parameter("power", &E::power,
                    {.doc = strength_doc(quantity, allowed),
                     .unit = Unit::watts,
                     .range = schema::non_negative});
        break;
      case Quantity::intensity:
        d.parameter("intensity", &E::intensity,
                    {.doc = strength_doc(quantity, allowed),
                     .unit = Unit::intensity,
                     .range = schema::non_negative});
        break;
      case Quantity::irradiance:
        d.parameter("irradiance", &E::irradiance,
                    {.doc = strength_doc(quantity, allowed),
                     .unit = Unit::irradiance,
                     .range = schema::non_negative});
        break;
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
