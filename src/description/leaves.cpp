#include "description/leaves.h"

namespace lapidary::description {
namespace {

/// What groups and sections hand down.
struct Inherited {
  Transform world_from_parent;
  MaterialPtr material = default_material();
  Transform world_from_wearer;
  std::string_view name;
  MaterialPtr interior;
  std::int32_t priority = 0;
  const Cut* cut = nullptr;
  std::shared_ptr<const geometry::MovingTransform> motion;
};

/// Null if nothing moves it.
std::shared_ptr<const geometry::MovingTransform> motion_of(const Object& object,
                                                           const Inherited& above) {
  if (!object.motion && !(above.motion && object.placement)) return above.motion;
  auto motion = above.motion ? std::make_shared<geometry::MovingTransform>(*above.motion)
                             : std::make_shared<geometry::MovingTransform>(above.world_from_parent);
  if (object.motion) {
    motion->append(object.motion->parent_from_moving);
    motion->append(object.motion->motion);
    motion->append(object.motion->moving_from_object);
  } else {
    motion->append(*object.placement);
  }
  return motion;
}

Inherited inside(const Object& object, const Inherited& above) {
  Inherited here = above;
  here.motion = motion_of(object, above);
  if (object.placement) here.world_from_parent = above.world_from_parent * *object.placement;
  if (object.material) {
    here.material = object.material;
    here.world_from_wearer = here.world_from_parent;
  }
  const Attributes* own = object.attributes.get();
  if (!own) return here;
  if (!own->name.empty()) here.name = own->name;
  if (own->interior) here.interior = own->interior;
  if (own->priority) here.priority = *own->priority;
  if (own->cut) here.cut = &*own->cut;
  return here;
}

/// Whether it hands down anything but what is above it.
bool adds_something(const Object& object) {
  return object.motion || object.placement || object.material || object.attributes;
}

class LeafWalk {
 public:
  explicit LeafWalk(const std::function<void(const Leaf&)>& visit) : visit_(visit) {}

  void walk(std::span<const ObjectPtr> objects) {
    levels_.push_back({objects, {}, 0});
    while (!levels_.empty()) {
      Level& level = levels_.back();
      removed_.resize(level.removed);
      if (level.rest.empty()) {
        levels_.pop_back();
        continue;
      }
      const Object& object = *level.rest.front();
      level.rest = level.rest.subspan(1);
      if (adds_something(object)) {
        enter(object, inside(object, level.inherited));
      } else {
        enter(object, level.inherited);
      }
    }
  }

 private:
  struct Level {
    std::span<const ObjectPtr> rest;
    Inherited inherited;
    std::size_t removed;  ///< by the sections around this level
  };

  /// `here` may be that of a level: it does not outlive another.
  void enter(const Object& object, const Inherited& here) {
    if (const auto* group = std::get_if<std::shared_ptr<const Group>>(&object.content)) {
      levels_.push_back(Level{(*group)->children, here, removed_.size()});
      return;
    }
    const Combination* combination = object.combination();
    if (combination && combination->operation() == SetOperation::section) {
      const auto operands = combination->operands();
      for (const ObjectPtr& removed : operands.subspan(1)) {
        removed_.push_back({removed, here.world_from_parent});
      }
      levels_.push_back(Level{operands.first(1), here, removed_.size()});
      return;
    }
    visit_({object, here.world_from_parent, here.material, here.world_from_wearer, here.name,
            here.interior, here.priority, here.cut, removed_, here.motion});
  }

  const std::function<void(const Leaf&)>& visit_;
  std::vector<Level> levels_;
  std::vector<Removed> removed_;
};

}  // namespace

void for_each_leaf(std::span<const ObjectPtr> objects,
                   const std::function<void(const Leaf&)>& visit) {
  LeafWalk(visit).walk(objects);
}

}  // namespace lapidary::description
