#include "description/object.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace lapidary::description {
namespace {

const Combination* section_of(const Object& object) {
  const Combination* combination = object.combination();
  return combination && combination->operation() == SetOperation::section ? combination : nullptr;
}

/// Applies `change` to a copy of `object`; of a section, to the object that it shows.
template <typename Change>
ObjectPtr changed(const Object& object, Change change) {
  std::vector<const Object*> sections;
  const Object* shown = &object;
  while (const Combination* section = section_of(*shown)) {
    sections.push_back(shown);
    shown = section->operands().front().get();
  }
  auto copy = std::make_shared<Object>(*shown);
  change(*copy);
  for (; !sections.empty(); sections.pop_back()) {
    const auto operands = section_of(*sections.back())->operands();
    std::vector<ObjectPtr> list(operands.begin(), operands.end());
    list.front() = std::move(copy);
    copy = std::make_shared<Object>(*sections.back());
    copy->content = Combination(SetOperation::section, std::move(list));
  }
  return copy;
}

bool is_plain(const Object& object) {
  return !object.placement && !object.material && !object.attributes && !object.motion;
}

}  // namespace

const Transform& Object::parent_from_object() const {
  static const Transform identity;
  return placement ? *placement : identity;
}

const std::string& Object::name() const {
  static const std::string none;
  return attributes ? attributes->name : none;
}

void Attributes::complete_with(const Attributes& other) {
  if (name.empty()) name = other.name;
  if (!interior) interior = other.interior;
  if (!priority) priority = other.priority;
  if (!cut) cut = other.cut;
}

Parts parts_of(const Object& object) {
  if (const auto* combination = std::get_if<Combination>(&object.content)) {
    return {combination->operands(), combination->is_shared()};
  }
  if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.content)) {
    return {(*group)->children, group->use_count() > 1};
  }
  return {};
}

Parts inner_parts_of(const Object& object) {
  Parts parts = parts_of(object);
  const Combination* combination = object.combination();
  if (!combination) return parts;
  switch (combination->operation()) {
    case SetOperation::unite:
    case SetOperation::intersect:
      break;
    case SetOperation::subtract:
    case SetOperation::section:
      parts.objects = parts.objects.first(1);
      break;
    case SetOperation::complement:
      parts.objects = {};
      break;
  }
  return parts;
}

bool is_solid(const Object& object) {
  const Object* shown = &object;
  while (const Combination* section = section_of(*shown)) shown = section->operands().front().get();
  if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&shown->content)) {
    return (*group)->solid;
  }
  return !std::holds_alternative<geometry::Sheet>(shown->content);
}

ObjectPtr moved(const Object& object, const Transform& motion) {
  const Transform whole = motion * object.parent_from_object();
  // The product keeps both inverses' errors; only what can be inverted afresh is worth keeping.
  if (!Transform::affine(whole.linear(), whole.offset())) return nullptr;
  auto copy = std::make_shared<Object>(object);
  copy->placement = std::make_shared<const Transform>(whole);
  if (object.motion) {
    ObjectMotion carried = *object.motion;
    carried.parent_from_moving = motion * carried.parent_from_moving;
    copy->motion = std::make_shared<const ObjectMotion>(carried);
  }
  return copy;
}

ObjectPtr with_motion(const Object& object, geometry::Motion motion) {
  auto copy = std::make_shared<Object>(object);
  motion.center = object.parent_from_object().offset();
  copy->motion =
      std::make_shared<const ObjectMotion>(ObjectMotion{object.parent_from_object(), motion, {}});
  return copy;
}

ObjectPtr with_material(const Object& object, MaterialPtr material) {
  return changed(object, [&](Object& copy) {
    copy.material = std::move(material);
    if (auto* mesh = std::get_if<Mesh>(&copy.content)) mesh->materials.clear();
  });
}

ObjectPtr with_material_everywhere(const Object& object, MaterialPtr material) {
  const ObjectPtr copy = with_material(object, material);
  const auto* group = std::get_if<std::shared_ptr<const Group>>(&copy->content);
  if (!group) return copy;
  auto children = (*group)->children;
  for (ObjectPtr& child : children) child = with_material_everywhere(*child, material);
  auto dressed = std::make_shared<Object>(*copy);
  dressed->content =
      std::make_shared<const Group>(std::move(children), (*group)->depth, (*group)->solid);
  return dressed;
}

ObjectPtr with_attributes(const Object& object, Attributes changes) {
  return changed(object, [&](Object& copy) {
    if (copy.attributes) changes.complete_with(*copy.attributes);
    copy.attributes = std::make_shared<const Attributes>(std::move(changes));
  });
}

ObjectPtr with_section(ObjectPtr object, ObjectPtr removed) {
  schema::CallSite where = object->where;
  return combined(SetOperation::section, std::move(object), std::move(removed), std::move(where));
}

ObjectPtr make_group(std::vector<ObjectPtr> children, schema::CallSite where) {
  int depth = 1;
  bool solid = true;
  for (const ObjectPtr& child : children) {
    solid = solid && is_solid(*child);
    if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&child->content)) {
      depth = std::max(depth, (*group)->depth + 1);
    }
  }
  if (depth > max_group_depth) {
    throw Error(where.location(), "groups are nested too deeply",
                "collect the objects in one list and group it once");
  }
  auto object = std::make_shared<Object>();
  object->content = std::make_shared<const Group>(std::move(children), depth, solid);
  object->where = std::move(where);
  return object;
}

ObjectPtr combined(SetOperation operation, ObjectPtr left, ObjectPtr right,
                   schema::CallSite where) {
  if (is_plain(*left) && left->combination() && left->combination()->operation() == operation) {
    if (auto longer = left->combination()->appended(right)) {
      return std::make_shared<const Object>(
          Object{*std::move(longer), nullptr, nullptr, nullptr, std::move(where)});
    }
  }
  return make_combination(operation, {std::move(left), std::move(right)}, std::move(where));
}

ObjectPtr complemented(ObjectPtr object, schema::CallSite where) {
  return make_combination(SetOperation::complement, {std::move(object)}, std::move(where));
}

ObjectPtr make_combination(SetOperation operation, std::vector<ObjectPtr> operands,
                           schema::CallSite where) {
  return std::make_shared<const Object>(Object{Combination(operation, std::move(operands)), nullptr,
                                               nullptr, nullptr, std::move(where)});
}

}  // namespace lapidary::description
