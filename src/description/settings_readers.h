#pragma once

#include "description/settings.h"
#include "schema/declaration.h"

namespace lapidary::description {

const schema::Declaration<RenderSettings>& render_declaration();
const schema::Declaration<FilmSettings>& film_declaration();

}  // namespace lapidary::description

namespace lapidary::schema {

template <>
struct Reader<description::RenderSettings> {
  static std::string type() { return "table"; }
  static description::RenderSettings read(const Value& value, const Context& context) {
    return description::render_declaration().read(value, context);
  }
  static std::string text(const description::RenderSettings&) { return ""; }
};

template <>
struct Reader<description::FilmSettings> {
  static std::string type() { return "table"; }
  static description::FilmSettings read(const Value& value, const Context& context) {
    return description::film_declaration().read(value, context);
  }
  static std::string text(const description::FilmSettings&) { return ""; }
};

}  // namespace lapidary::schema
