#include <cmath>

#include "description/node_readers.h"
#include "description/nodes.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::Node;
using schema::NodeKind;
using schema::Shorthand;
using schema::Unit;

constexpr auto section = "spectra";

struct TableParameters {
  double from = 400;
  double step = 10;
  std::vector<double> values;
};

struct BlackbodyParameters {
  double temperature = 6500;
};

Node spectrum_node(Spectrum spectrum, const Context& context, std::size_t bytes) {
  return Node::of<Spectrum>(context.call().node,
                            std::make_shared<const Spectrum>(std::move(spectrum)), bytes);
}

NodeKind spectrum() {
  Declaration<TableParameters> d({.name = "spectrum",
                                  .doc = "Values over wavelength, straight lines in between and "
                                         "constant beyond the ends.",
                                  .section = section,
                                  .examples = {"spectrum { from = 400, step = 100, values = { 0.1, "
                                               "0.3, 0.8, 0.9 } }"}});
  d.parameter("from", &TableParameters::from,
              {.doc = "Wavelength of the first value.",
               .unit = Unit::nanometres,
               .range = schema::positive})
      .parameter("step", &TableParameters::step,
                 {.doc = "From one value to the next.",
                  .unit = Unit::nanometres,
                  .range = {.min = 0.01, .max = 1000}})
      .parameter("values", &TableParameters::values,
                 {.doc = "At least one number.",
                  .range = {.min = 0, .max = 1e30},
                  .need = schema::Need::required,
                  .shorthand = Shorthand::yes});
  return node_kind(std::move(d), [](TableParameters&& t, const Context& context) {
    if (t.values.empty()) context.at("values").fail("must not be empty");
    const std::size_t bytes = t.values.size() * sizeof(float) + sizeof(Spectrum);
    std::vector<float> values(t.values.begin(), t.values.end());
    return spectrum_node(Spectrum::table({t.from, t.step, std::move(values)}), context, bytes);
  });
}

NodeKind blackbody() {
  Declaration<BlackbodyParameters> d({.name = "blackbody",
                                      .doc = "Light of a glowing body, of total 1.",
                                      .section = section,
                                      .examples = {"blackbody(2700)"}});
  d.parameter("temperature", &BlackbodyParameters::temperature,
              {.doc = "A candle has 1900, a light bulb 2700, the sun 5800.",
               .unit = Unit::kelvin,
               .range = {.min = 500, .max = 100000},
               .need = schema::Need::required,
               .shorthand = Shorthand::yes});
  return node_kind(std::move(d), [](BlackbodyParameters&& b, const Context& context) {
    return spectrum_node(Spectrum::blackbody(b.temperature), context, sizeof(Spectrum));
  });
}

}  // namespace

std::vector<NodeKind> spectrum_kinds() {
  return {spectrum(), blackbody()};
}

}  // namespace lapidary::description
