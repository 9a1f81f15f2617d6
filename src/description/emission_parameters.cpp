#include "description/emission_parameters.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace lapidary::description {
namespace {

using schema::Context;

std::string_view name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::radiance:
      return "radiance";
    case Quantity::power:
      return "power";
    case Quantity::intensity:
      return "intensity";
    case Quantity::irradiance:
      break;
  }
  return "irradiance";
}

std::string_view meaning_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::radiance:
      return "What every point gives in every direction; {1, 1, 1} shows as white";
    case Quantity::power:
      return "All the light it gives";
    case Quantity::intensity:
      return "What it gives in a direction";
    case Quantity::irradiance:
      break;
  }
  return "What a surface that faces it receives";
}

bool given(const EmissionParameters& e, Quantity quantity) {
  switch (quantity) {
    case Quantity::radiance:
      return e.radiance.has_value();
    case Quantity::power:
      return e.power.has_value();
    case Quantity::intensity:
      return e.intensity.has_value();
    case Quantity::irradiance:
      break;
  }
  return e.irradiance.has_value();
}

/// The spectrum said, scaled to a total of 1.
Spectrum shape(const EmissionParameters& e, const Context& context) {
  if (e.color && e.temperature) context.fail("takes either 'color' or 'temperature', not both");
  if (e.temperature) return Spectrum::blackbody(*e.temperature);
  if (!e.color) return Spectrum::illuminant({1, 1, 1});
  const double total = e.color->integral();
  if (!(total > 0.0)) context.at("color").fail("must not be black", "use a small strength instead");
  return e.color->scaled(static_cast<float>(1.0 / total));
}

}  // namespace

std::string strength_doc(Quantity quantity, std::initializer_list<Quantity> allowed) {
  std::string text(meaning_of(quantity));
  std::vector<std::string> others;
  for (const Quantity other : allowed) {
    if (other != quantity) others.push_back(fmt::format("'{}'", name_of(other)));
  }
  if (others.empty()) return text + "; must be given.";
  return fmt::format("{}; this or {} must be given.", text, fmt::join(others, " or "));
}

Emission to_emission(const EmissionParameters& e, std::initializer_list<Quantity> allowed,
                     const Context& context) {
  std::vector<std::string> names;
  std::vector<Quantity> said;
  for (const Quantity quantity : allowed) {
    names.push_back(fmt::format("'{}'", name_of(quantity)));
    if (given(e, quantity)) said.push_back(quantity);
  }
  if (said.size() != 1) {
    const std::string choice = fmt::format("{}", fmt::join(names, " or "));
    context.fail(said.empty() ? fmt::format("needs {}", choice)
                              : fmt::format("takes either {}, not both", choice));
  }
  const Quantity quantity = said.front();
  if (quantity == Quantity::radiance) {
    if (!e.color && !e.temperature) return {quantity, *e.radiance};
    const double total = e.radiance->integral();
    return {quantity, shape(e, context).scaled(static_cast<float>(total))};
  }
  const double strength = quantity == Quantity::power       ? *e.power
                          : quantity == Quantity::intensity ? *e.intensity
                                                            : *e.irradiance;
  return {quantity, shape(e, context).scaled(static_cast<float>(strength))};
}

}  // namespace lapidary::description
