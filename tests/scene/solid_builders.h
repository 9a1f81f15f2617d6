#pragma once

#include <memory>
#include <utility>

#include "description/object.h"
#include "geometry/solid.h"

namespace lapidary::test {

// Solids as the operators of the scene language make them.

inline description::ObjectPtr solid(auto shape, description::MaterialPtr worn = nullptr) {
  return std::make_shared<const description::Object>(
      description::Object{geometry::Solid(shape), nullptr, std::move(worn), nullptr, {}});
}
inline description::ObjectPtr ball(description::MaterialPtr worn = nullptr) {
  return solid(geometry::Sphere{{}, 1}, std::move(worn));
}
inline description::ObjectPtr unite(description::ObjectPtr a, description::ObjectPtr b) {
  return combined(description::SetOperation::unite, std::move(a), std::move(b), {});
}
inline description::ObjectPtr intersect(description::ObjectPtr a, description::ObjectPtr b) {
  return combined(description::SetOperation::intersect, std::move(a), std::move(b), {});
}
inline description::ObjectPtr subtract(description::ObjectPtr a, description::ObjectPtr b) {
  return combined(description::SetOperation::subtract, std::move(a), std::move(b), {});
}
inline description::ObjectPtr at(double x, const description::ObjectPtr& object) {
  return moved(*object, Transform::translation({x, 0, 0}));
}
inline description::ObjectPtr dressed(const description::ObjectPtr& object,
                                      description::MaterialPtr material) {
  return with_material(*object, std::move(material));
}
inline description::ObjectPtr with_cut(const description::ObjectPtr& object,
                                       description::Cut::Rule rule,
                                       description::MaterialPtr material = nullptr) {
  return with_attributes(*object, {.cut = description::Cut{rule, std::move(material)}});
}

}  // namespace lapidary::test
