#include "schema/node_info.h"

namespace lapidary::schema {

std::string_view to_string(Unit unit) {
  switch (unit) {
    case Unit::none:
      break;
    case Unit::length:
      return "scene units";
    case Unit::degrees:
      return "degrees";
    case Unit::seconds:
      return "s";
    case Unit::pixels:
      return "pixels";
    case Unit::watts:
      return "W";
    case Unit::radiance:
      return "W/(m2 sr)";
    case Unit::intensity:
      return "W/sr";
    case Unit::irradiance:
      return "W/m2";
    case Unit::lumens:
      return "lm";
    case Unit::candela:
      return "cd";
    case Unit::lux:
      return "lx";
    case Unit::nits:
      return "cd/m2";
    case Unit::kelvin:
      return "K";
    case Unit::nanometres:
      return "nm";
  }
  return "";
}

}  // namespace lapidary::schema
