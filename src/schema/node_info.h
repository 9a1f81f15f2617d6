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
  lumens,
  candela,
  lux,
  nits,
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

/// How a word of the scene language is used: as `name { ... }`, as a plain table `name = { ... }`
/// where another node has it, as `object:name { ... }`, or in a way of its own that only its
/// examples show.
enum class Form { constructor, table, method, other };

/// A kind of node, or another word of the scene language, as help and messages show it.
struct NodeInfo {
  std::string name;
  std::string doc;      ///< one line
  std::string section;  ///< of the index and the reference: "solid"
  /// Each as a scene may hold it: an expression, for a table with its name and '='. Methods are
  /// those of an object `ball`.
  std::vector<std::string> examples = {};
  Form form = Form::constructor;
  std::vector<ParameterInfo> parameters;
};

}  // namespace lapidary::schema
