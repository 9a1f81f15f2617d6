#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "schema/range.h"

namespace lapidary::schema {

/// What a number measures; angles are in degrees, lengths in scene units.
enum class Unit {
  none,
  length,
  degrees,
  seconds,
  pixels,
  watts,
  radiance,
  intensity,
  irradiance,
  kelvin,
  nanometres,
};
std::string_view to_string(Unit unit);  ///< "W/(m2 sr)"; empty for none

enum class Need { optional, required };

/// Whether a value given alone, as in `glass "N-BK7"`, is this parameter.
enum class Shorthand { no, yes };

/// A parameter as help and messages show it.
struct ParameterInfo {
  std::string name;
  std::string type;
  std::string doc;
  std::string default_text;  ///< as a scene would write it; empty: none, the doc says what happens
  Unit unit = Unit::none;
  Range range;
  Need need = Need::optional;
  Shorthand shorthand = Shorthand::no;
};

/// How a node is written: as `name { ... }`, as a plain table where another node has it, or as
/// `object:name { ... }`; what is no call has its whole text for a name.
enum class Form { constructor, table, method, expression };

/// A kind of node as help and messages show it.
struct NodeInfo {
  std::string name;
  std::string doc;      ///< one line
  std::string section;  ///< of the index and the reference: "solid"
  Form form = Form::constructor;
  std::vector<ParameterInfo> parameters;
};

}  // namespace lapidary::schema
