#include "scene/solid_writer.h"

#include <fmt/format.h>

#include "base/error.h"
#include "scene/hash.h"

namespace lapidary::scene {
namespace {

using description::Combination;
using description::Cut;
using description::Group;
using description::MaterialPtr;
using description::Object;
using description::ObjectPtr;
using description::SetOperation;
using geometry::Expression;

bool takes_away(SetOperation operation) {
  return operation == SetOperation::subtract || operation == SetOperation::section;
}

[[noreturn]] void refuse(const Object& operand) {
  throw Error(operand.where.location(), "a flat sheet encloses nothing that could be combined",
              "use a thin box or a flat cylinder");
}

[[noreturn]] void refuse_motion(const Object& operand) {
  throw Error(operand.where.location(), "what moves cannot be a part of a combination",
              "let the whole combination move: (a - b):motion { ... }");
}

}  // namespace

std::size_t SolidWriter::HashOfPlace::operator()(const Place& place) const {
  std::size_t hash = mixed(place.operands, place.content);
  hash = mixed(hash, place.world_from_object);
  if (const Transform* wearer = place.wear.world_from_wearer) hash = mixed(hash, *wearer);
  return mixed(mixed(hash, place.wear.worn()), place.wear.cut);
}

SolidWriter::Term SolidWriter::write(const Object& region, const Transform& world_from_region,
                                     const Cut* cut) {
  // That the region wears its material is what leaves inherit.
  const Wear wear{.cut = cut};
  if (const geometry::Solid* solid = solid_of(region)) {
    write_leaf(region, *solid, world_from_region, wear);
  } else {
    open(region, world_from_region, wear, Use::once);
  }
  return finish();
}

SolidWriter::Term SolidWriter::write_removed(const Object& removed,
                                             const Transform& world_from_parent,
                                             const Object& region,
                                             const Transform& world_from_region) {
  const Difference cut{region, world_from_region, region.material, world_from_region};
  enter(removed, world_from_parent, wear_of_cutters(cut, {}), Use::once);
  return finish();
}

SolidWriter::Term SolidWriter::finish() {
  while (!levels_.empty()) {
    Level& level = levels_.back();
    if (level.next < level.operands.objects.size()) {
      const bool cutter = level.next > 0 && takes_away(level.place.operation);
      const ObjectPtr& operand = level.operands.objects[level.next++];
      const bool shared = level.operands.shared || operand.use_count() > 1;
      // Entering may move the levels: what it is given must not lie in one.
      const Transform world_from_parent = level.place.world_from_object;
      const Wear wear = cutter ? level.cutters : level.place.wear;
      enter(*operand, world_from_parent, wear, shared ? Use::shared : Use::once);
      continue;
    }
    const Term term = close(level);
    if (level.use == Use::shared) written_.emplace(level.place, term);
    terms_.resize(level.first_term);
    terms_.push_back(term);
    levels_.pop_back();
  }
  const Term whole = terms_.back();
  terms_.pop_back();
  return whole;
}

void SolidWriter::enter(const Object& object, const Transform& world_from_parent, const Wear& above,
                        Use use) {
  if (object.motion) refuse_motion(object);
  const Transform world_from_object =
      object.placement ? world_from_parent * *object.placement : world_from_parent;
  Wear wear = above;
  if (object.material && !wear.forced) wear_material(wear, object.material, world_from_object);
  if (object.attributes && object.attributes->cut) wear.cut = &*object.attributes->cut;
  const geometry::Solid* solid = solid_of(object);
  if (!solid) return open(object, world_from_object, wear, use);
  if (use == Use::once) return write_leaf(object, *solid, world_from_object, wear);
  const Place place{&object, 0, SetOperation::unite, world_from_object, wear};
  const auto found = written_.find(place);
  if (found != written_.end()) return terms_.push_back(found->second);
  write_leaf(object, *solid, world_from_object, wear);
  written_.emplace(place, terms_.back());
}

void SolidWriter::open(const Object& object, const Transform& world_from_object, const Wear& wear,
                       Use use) {
  Level level;
  level.place = {nullptr, 0, SetOperation::unite, world_from_object, wear};
  if (const Combination* combination = object.combination()) {
    level.place.content = combination->list();
    level.place.operation = combination->operation();
  } else if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.content)) {
    level.place.content = group->get();
  } else {
    refuse(object);
  }
  level.operands = parts_of(object);
  level.place.operands = level.operands.objects.size();
  // Objects that differ in what they are told may be made of the same operands.
  if (use == Use::shared || level.operands.shared) level.use = Use::shared;
  if (takes_away(level.place.operation)) {
    const Object& minuend = *level.operands.objects.front();
    const Transform world_from_minuend = world_from_object * minuend.parent_from_object();
    level.cutters =
        wear_of_cutters({minuend, world_from_minuend, object.material, world_from_object}, wear);
    if (level.place.operation == SetOperation::section) level.cutters.cut = nullptr;
  }
  const std::size_t leaves = expression_.leaves().size(), more = level.place.operands;
  // Of many operands most are leaves; fewer must not make room, or it would be made too often.
  if (more > leaves) expression_.reserve(leaves + more, expression_.nodes().size() + 1);
  level.first_term = terms_.size();
  if (level.use == Use::shared) {
    const auto found = written_.find(level.place);
    if (found != written_.end()) return terms_.push_back(found->second);
  }
  levels_.push_back(std::move(level));
}

/// Null unless it is a single solid or a mesh.
const geometry::Solid* SolidWriter::solid_of(const Object& object) {
  if (std::holds_alternative<description::Mesh>(object.content)) return &meshes_.of(object);
  return std::get_if<geometry::Solid>(&object.content);
}

void SolidWriter::write_leaf(const Object& object, const geometry::Solid& solid,
                             const Transform& world_from_object, const Wear& worn) {
  Wear wear = worn;
  const auto* mesh = std::get_if<description::Mesh>(&object.content);
  if (mesh && !wear.forced) {
    if (const MaterialPtr* own = own_material(object, *mesh)) {
      wear_material(wear, *own, world_from_object);
    }
  }
  if (expression_.leaves().size() >= most_) {
    throw Error(object.where.location(),
                fmt::format("the solids have more than {} parts, all copies counted", most_),
                "do copies of copies double it over and over?");
  }
  const geometry::SurfaceTag tag =
      wear.material ? tag_of_(*wear.material, wear.world_from_wearer) : geometry::inherited_surface;
  terms_.push_back(expression_.add(geometry::PlacedSolid(solid, world_from_object), tag));
}

void SolidWriter::wear_material(Wear& wear, const MaterialPtr& material,
                                const Transform& world_from_wearer) {
  wear.material = &material;
  wear.world_from_wearer = nullptr;
  if (!description::is_textured(*material)) return;
  const bool is_known = !wearers_.empty() && wearers_.front() == world_from_wearer;
  if (!is_known) wearers_.push_front(world_from_wearer);
  wear.world_from_wearer = &wearers_.front();
}

/// What those wear that are taken from the minuend by a difference that is itself to wear `wear`.
Wear SolidWriter::wear_of_cutters(const Difference& difference, const Wear& wear) {
  if (wear.forced) return wear;
  Wear cutters = wear;
  if (!difference.own) {
    const Surface surface = surface_of(difference.minuend);
    if (surface.material != nullptr) {
      wear_material(cutters, *surface.material,
                    difference.world_from_minuend * surface.object_from_wearer);
    }
  }
  if (!wear.cut || wear.cut->rule == Cut::Rule::cutter) return cutters;
  cutters.forced = true;
  if (wear.cut->rule == Cut::Rule::material) {
    wear_material(cutters, wear.cut->material, difference.world_from_difference);
  }
  return cutters;
}

/// What `object` wears by itself, without what is around it: its own material or that of what it is
/// cut from.
SolidWriter::Surface SolidWriter::surface_of(const Object& object) {
  std::vector<const Object*> cut;  // on the way down to what has an answer
  const Object* at = &object;
  Surface surface;
  for (;;) {
    const auto known = surfaces_.find(at);
    if (known != surfaces_.end()) {
      surface = known->second;
      break;
    }
    if (at->material) surface.material = &at->material;
    const Combination* combination = at->combination();
    if (surface.material || !combination || !takes_away(combination->operation())) break;
    cut.push_back(at);
    at = combination->operands().front().get();
  }
  for (; !cut.empty(); cut.pop_back()) {
    if (at->placement) surface.object_from_wearer = *at->placement * surface.object_from_wearer;
    at = cut.back();
    surfaces_.emplace(at, surface);
  }
  return surface;
}

SolidWriter::Term SolidWriter::close(const Level& level) {
  const std::span<Term> terms = std::span(terms_).subspan(level.first_term);
  const SetOperation operation = level.place.operation;
  if (operation == SetOperation::complement) return ~terms.front();
  if (takes_away(operation)) {
    for (Term& term : terms.subspan(1)) term = ~term;
  }
  if (terms.size() == 1) return terms.front();
  const bool unites = operation == SetOperation::unite;
  return expression_.add(unites ? geometry::Operation::unite : geometry::Operation::intersect,
                         terms);
}

}  // namespace lapidary::scene
