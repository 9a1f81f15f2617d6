#include "description/emission_parameters.h"

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "spectrum/color.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Unit;

enum class Weighed { by_power, by_the_eye };

struct StrengthRow {
  Strength strength;
  StrengthInfo info;
  Quantity quantity;
  Weighed weighed;
  std::string_view meaning;
};

using E = EmissionParameters;

constexpr std::array<StrengthRow, 8> table{{
    {Strength::radiance,
     {"radiance", nullptr, Unit::radiance},
     Quantity::radiance,
     Weighed::by_power,
     "What every point gives in every direction; {1, 1, 1} shows as white"},
    {Strength::power,
     {"power", &E::power, Unit::watts},
     Quantity::power,
     Weighed::by_power,
     "All the light it gives"},
    {Strength::intensity,
     {"intensity", &E::intensity, Unit::intensity},
     Quantity::intensity,
     Weighed::by_power,
     "What it gives in a direction"},
    {Strength::irradiance,
     {"irradiance", &E::irradiance, Unit::irradiance},
     Quantity::irradiance,
     Weighed::by_power,
     "What a surface that faces it receives"},
    {Strength::nits,
     {"nits", &E::nits, Unit::nits},
     Quantity::radiance,
     Weighed::by_the_eye,
     "Its luminance: how bright it looks, from wherever"},
    {Strength::lumens,
     {"lumens", &E::lumens, Unit::lumens},
     Quantity::power,
     Weighed::by_the_eye,
     "Its luminous flux, as the packages of lamps state it"},
    {Strength::candela,
     {"candela", &E::candela, Unit::candela},
     Quantity::intensity,
     Weighed::by_the_eye,
     "Its luminous intensity in a direction"},
    {Strength::lux,
     {"lux", &E::lux, Unit::lux},
     Quantity::irradiance,
     Weighed::by_the_eye,
     "The illuminance of a surface that faces it; the sun gives up to 100000"},
}};

const StrengthRow& row_of(Strength strength) {
  for (const StrengthRow& row : table) {
    if (row.strength == strength) return row;
  }
  return table.front();
}

bool given(const EmissionParameters& e, const StrengthRow& row) {
  return row.info.number == nullptr ? e.radiance.has_value() : (e.*row.info.number).has_value();
}

std::string choice_of(const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  return schema::join_or(views);
}

std::string quoted(const StrengthRow& row) {
  return fmt::format("'{}'", row.info.name);
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

/// Lumens per watt. Fails where a lumen would take hundreds of watts: such light lies at the very
/// ends of what can be seen, and nobody means it to look bright.
double efficacy(const Spectrum& shape, const StrengthRow& row, const Context& context) {
  constexpr double least = 0.01;
  const double lumens_per_watt = luminous_efficacy(shape);
  if (lumens_per_watt < least) {
    context.fail(
        fmt::format("gives no light that can be seen, so {} cannot say how much", quoted(row)),
        "state it in watts: as 'power', 'radiance', 'intensity' or 'irradiance'");
  }
  return lumens_per_watt;
}

/// The one strength that is given; null for none.
const StrengthRow* the_strength(const EmissionParameters& e,
                                std::initializer_list<Strength> allowed, const Context& context) {
  std::vector<std::string> said;
  const StrengthRow* chosen = nullptr;
  for (const Strength strength : allowed) {
    const StrengthRow& row = row_of(strength);
    if (!given(e, row)) continue;
    said.push_back(quoted(row));
    chosen = &row;
  }
  if (said.size() > 1) {
    context.fail(fmt::format("takes either {}, not {}", choice_of(said),
                             said.size() == 2 ? "both" : "several of them"));
  }
  return chosen;
}

}  // namespace

StrengthInfo info_of(Strength strength) {
  return row_of(strength).info;
}

std::string strength_doc(Strength strength, std::initializer_list<Strength> allowed) {
  const std::string text(row_of(strength).meaning);
  std::vector<std::string> choice{"this"};
  for (const Strength other : allowed) {
    if (other != strength) choice.push_back(quoted(row_of(other)));
  }
  if (choice.size() == 1) return text + "; must be given.";
  return fmt::format("{}; {} must be given.", text, choice_of(choice));
}

std::optional<Emission> to_stated_emission(const EmissionParameters& e,
                                           std::initializer_list<Strength> allowed,
                                           const Context& context) {
  const StrengthRow* row = the_strength(e, allowed, context);
  if (row == nullptr) return std::nullopt;
  if (row->info.number == nullptr) {
    if (!e.color && !e.temperature) return Emission{row->quantity, *e.radiance};
    const double total = e.radiance->integral();
    return Emission{row->quantity, shape(e, context).scaled(static_cast<float>(total))};
  }
  const Spectrum unit = shape(e, context);
  double watts = *(e.*row->info.number);
  if (row->weighed == Weighed::by_the_eye) watts /= efficacy(unit, *row, context);
  return Emission{row->quantity, unit.scaled(static_cast<float>(watts))};
}

Emission to_emission(const EmissionParameters& e, std::initializer_list<Strength> allowed,
                     const Context& context) {
  if (const auto emission = to_stated_emission(e, allowed, context)) return *emission;
  std::vector<std::string> names;
  for (const Strength strength : allowed) names.push_back(quoted(row_of(strength)));
  context.fail("needs " + choice_of(names));
}

Spectrum one_candela(const EmissionParameters& e, const Context& context) {
  const Spectrum unit = shape(e, context);
  const double watts = 1.0 / efficacy(unit, row_of(Strength::candela), context);
  return unit.scaled(static_cast<float>(watts));
}

}  // namespace lapidary::description
