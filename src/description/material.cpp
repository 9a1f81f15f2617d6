#include "description/material.h"

namespace lapidary::description {

MaterialPtr default_material() {
  static const MaterialPtr material = std::make_shared<const Material>();
  return material;
}

}  // namespace lapidary::description
