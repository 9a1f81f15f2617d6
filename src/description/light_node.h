#pragma once

#include <memory>
#include <utility>

#include "description/light.h"
#include "schema/context.h"
#include "schema/value.h"

namespace lapidary::description {

constexpr auto light_section = "lights";

/// The node of a light that is no object.
template <typename Model>
schema::Node light_node(Model model, const schema::Context& context) {
  auto light = std::make_shared<Light>(Light{std::move(model), context.call().where});
  return schema::Node::of<Light>(context.call().node, std::move(light), sizeof(Light));
}

}  // namespace lapidary::description
