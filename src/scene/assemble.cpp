#include "scene/assemble.h"

#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "base/error.h"
#include "description/fold.h"
#include "description/leaves.h"
#include "description/solids.h"
#include "scene/hash.h"
#include "scene/solid_writer.h"

namespace lapidary::scene {
namespace {

using description::Combination;
using description::Leaf;
using description::Material;
using description::MaterialPtr;
using description::Object;
using description::SetOperation;
using geometry::Expression;

/// Whether it is there to give light: not cut open by the scene's section, which shows insides.
bool is_lamp(const Leaf& leaf) {
  if (leaf.object.combination() == nullptr) return gives_light(leaf);
  return std::holds_alternative<description::Emissive>(leaf.material->model);
}

/// Numbers what fills bodies.
class Media {
 public:
  explicit Media(std::vector<MaterialPtr>& list) : list_(list) { list_.push_back(nullptr); }

  std::uint32_t number(const MaterialPtr& material) {
    const auto [known, is_new] = by_material_.try_emplace(material.get(), next());
    if (!is_new) return known->second;
    if (const auto* glass = description::as_glass(*material)) {
      const auto [equal, is_new_glass] = find_equal(*glass);
      known->second = equal;
      if (!is_new_glass) return equal;
    }
    list_.push_back(material);
    return known->second;
  }

  /// Whether a body of the one continues in a body of the other.
  static bool same(const Material& a, const Material& b) {
    const auto *p = description::as_glass(a), *q = description::as_glass(b);
    if (!p || !q) return !p && !q;  // nobody sees into opaque ones
    return p->index == q->index && p->absorption == q->absorption;
  }

 private:
  std::uint32_t next() const { return static_cast<std::uint32_t>(list_.size()); }

  /// The number of the medium that equals `glass`, or the next one; and whether it is new.
  std::pair<std::uint32_t, bool> find_equal(const description::Glass& glass) {
    constexpr double yellow_nm = 589.3;  // enough to tell most glasses apart
    const double index = glass.index.at(yellow_nm);
    const auto [begin, end] = glasses_.equal_range(index);
    for (auto it = begin; it != end; ++it) {
      const description::Glass& other = *description::as_glass(*list_[it->second]);
      if (other.index == glass.index && other.absorption == glass.absorption) {
        return {it->second, false};
      }
    }
    glasses_.emplace(index, next());
    return {next(), true};
  }

  std::vector<MaterialPtr>& list_;
  std::map<const Material*, std::uint32_t> by_material_;
  std::multimap<double, std::uint32_t> glasses_;
};

/// What the parts of a solid say that it is filled with.
struct Filling {
  const MaterialPtr* material = nullptr;  ///< null: they do not say
  bool disputed = false;

  friend Filling operator+(const Filling& a, const Filling& b) {
    if (!a.material || !b.material) return a.material ? a : b;
    return {a.material, a.disputed || b.disputed || !Media::same(**a.material, **b.material)};
  }
};

}  // namespace

// Parts wear what the leaf does where they wear nothing themselves.
const MaterialPtr& filling_of(const Leaf& leaf) {
  if (leaf.interior) return leaf.interior;
  if (leaf.object.material || !leaf.object.combination()) return leaf.material;
  const auto own = [&](const Object& part) -> const MaterialPtr* {
    if (part.attributes && part.attributes->interior) return &part.attributes->interior;
    return part.material ? &part.material : nullptr;
  };
  const auto of_leaf = [&](const Object& part) {
    const MaterialPtr* material = own(part);
    return Filling{material ? material : &leaf.material};
  };
  const auto join = [&](const Object& whole, std::span<const Filling> parts) {
    if (const MaterialPtr* material = own(whole)) return Filling{material};
    Filling sum;
    for (const Filling& part : parts) sum = sum + part;
    return sum;
  };
  const Filling filling =
      description::fold<Filling>(leaf.object, of_leaf, join, description::inner_parts_of);
  if (filling.disputed) {
    throw Error(leaf.object.where.location(),
                "the parts of this solid disagree about what fills it: some wear a glass that "
                "others do not",
                "let the whole of it wear one material, or give it an 'interior'");
  }
  return filling.material ? *filling.material : leaf.material;
}

namespace {

/// Which uses of a combination are alike but for their places.
struct Design {
  const void* list;
  std::size_t operands;
  SetOperation operation;
  const description::Cut* cut;
  bool has_material;  ///< then what is cut wears it, and else what was cut

  auto operator<=>(const Design&) const = default;
};

std::optional<Design> design_of(const Leaf& leaf) {
  const Combination* combination = leaf.object.combination();
  if (!combination || !leaf.removed.empty()) return std::nullopt;
  return Design{combination->list(), combination->operands().size(), combination->operation(),
                leaf.cut, leaf.object.material != nullptr};
}

/// A material where it is worn.
struct Worn {
  const Material* material;
  TextureFrame frame;

  bool operator==(const Worn&) const = default;
};

struct HashOfWorn {
  std::size_t operator()(const Worn& worn) const {
    return mixed(mixed(0, worn.material), worn.frame.wearer_from_base);
  }
};

/// Takes the leaves of a scene one by one.
class Assembler {
 public:
  Assembler(const description::SceneDescription& scene, MeshSolids& meshes, std::size_t most)
      : scene_(scene), most_(most), media_(solids_.media), meshes_(meshes) {}

  Solids assemble() {
    std::size_t bodies = 0, lone = 0;
    for_each_leaf([&](const Leaf& leaf) {
      if (const auto design = design_of(leaf); design && !cut_by_scene_) ++uses_[*design].count;
      if (!is_body(leaf)) return;
      ++bodies;
      if (leaf.object.combination() == nullptr) ++lone;
    });
    solids_.regions.reserve(bodies);
    solids_.slots.reserve(bodies);
    solids_.expression.reserve(lone, 0);
    for_each_leaf([this](const Leaf& leaf) {
      if (is_body(leaf)) add(leaf);
    });
    return std::move(solids_);
  }

 private:
  struct Uses {
    std::size_t count = 0;
    std::optional<std::uint32_t> assembly;
  };

  template <typename Visit>
  void for_each_leaf(Visit visit) {
    object_ = 0;
    description::for_each_leaf(scene_.objects, [&](const Leaf& leaf) {
      cut_by_scene_ = scene_.section && !is_lamp(leaf);
      visit(leaf);
      ++object_;
    });
  }

  /// Whether it takes part in Boolean operations; an uncut mesh need not.
  bool is_body(const Leaf& leaf) const {
    if (std::holds_alternative<geometry::Sheet>(leaf.object.content)) return false;
    if (!std::holds_alternative<description::Mesh>(leaf.object.content)) return true;
    return !leaf.removed.empty() || cut_by_scene_;
  }

  void add(const Leaf& leaf);
  std::optional<std::uint32_t> assembly_of(const Leaf& leaf);
  std::uint32_t new_assembly(const Leaf& leaf);
  void refuse_sections(const Leaf& leaf) const;
  Expression::Term root_of(const Leaf& leaf, SolidWriter& writer);
  std::uint32_t slot(const MaterialPtr& material, const TextureFrame& frame);
  SolidWriter::TagOf tags(TextureFrame::Base base);

  const description::SceneDescription& scene_;
  std::size_t most_;  ///< leaves of an expression
  Solids solids_;
  Media media_;
  MeshSolids& meshes_;
  std::map<Design, Uses> uses_;
  bool cut_by_scene_ = false;  ///< whether the current leaf is
  std::uint32_t object_ = 0;   ///< number of the current leaf
  /// Of the current leaf; those of a material with textures are one for each place. Most have one.
  std::optional<std::pair<Worn, std::uint32_t>> first_slot_;
  std::unordered_map<Worn, std::uint32_t, HashOfWorn> own_slots_;
};

std::uint32_t Assembler::slot(const MaterialPtr& material, const TextureFrame& frame) {
  const auto next = static_cast<std::uint32_t>(solids_.slots.size());
  const Worn worn{material.get(), frame};
  if (!first_slot_) {
    first_slot_ = {worn, next};
  } else {
    if (first_slot_->first == worn) return first_slot_->second;
    const auto [found, is_new] = own_slots_.try_emplace(worn, next);
    if (!is_new) return found->second;
  }
  solids_.slots.push_back({object_, material, frame});
  return next;
}

SolidWriter::TagOf Assembler::tags(TextureFrame::Base base) {
  return [this, base](const MaterialPtr& material, const Transform* base_from_wearer) {
    return slot(material, base_from_wearer ? TextureFrame{base_from_wearer->inverse(), base}
                                           : TextureFrame{});
  };
}

void Assembler::add(const Leaf& leaf) {
  first_slot_.reset();
  own_slots_.clear();
  SolidRegion added;
  added.object = object_;
  added.where = leaf.object.where;
  geometry::Region& region = added.region;
  const bool textured = description::is_textured(*leaf.material);
  region.tag = slot(leaf.material,
                    textured ? TextureFrame{leaf.world_from_wearer.inverse()} : TextureFrame{});
  const MaterialPtr& filling = filling_of(leaf);
  region.medium = media_.number(filling);
  region.priority = leaf.priority;
  region.opacity =
      description::as_glass(*filling) ? geometry::Opacity::transparent : geometry::Opacity::opaque;
  if (const auto assembly = assembly_of(leaf)) {
    region.instance = static_cast<std::uint32_t>(solids_.instances.size());
    solids_.instances.push_back({*assembly, leaf.world_from_object, leaf.motion});
  } else {
    SolidWriter writer(solids_.expression, meshes_, tags(TextureFrame::Base::world), most_);
    region.root = root_of(leaf, writer);
  }
  solids_.regions.push_back(std::move(added));
}

Expression::Term Assembler::root_of(const Leaf& leaf, SolidWriter& writer) {
  std::vector<Expression::Term> terms{writer.write(leaf.object, leaf.world_from_object, leaf.cut)};
  for (const description::Removed& removed : leaf.removed) {
    terms.push_back(~writer.write_removed(*removed.solid, removed.world_from_parent, leaf.object,
                                          leaf.world_from_object));
  }
  if (cut_by_scene_) {
    terms.push_back(
        ~writer.write_removed(*scene_.section, {}, leaf.object, leaf.world_from_object));
  }
  return terms.size() == 1 ? terms.front()
                           : solids_.expression.add(geometry::Operation::intersect, terms);
}

std::uint32_t Assembler::new_assembly(const Leaf& leaf) {
  geometry::Assembly assembly;
  SolidWriter writer(assembly.expression, meshes_, tags(TextureFrame::Base::place), most_);
  assembly.root = writer.write(leaf.object, {}, leaf.cut);
  solids_.assemblies.push_back(std::move(assembly));
  return static_cast<std::uint32_t>(solids_.assemblies.size() - 1);
}

/// What `leaf` is an instance of: it moves, or stands in several places.
std::optional<std::uint32_t> Assembler::assembly_of(const Leaf& leaf) {
  if (leaf.motion) refuse_sections(leaf);
  const auto design = design_of(leaf);
  if (!design) return leaf.motion ? std::optional(new_assembly(leaf)) : std::nullopt;
  if (cut_by_scene_) return std::nullopt;
  Uses& uses = uses_.at(*design);
  if (uses.assembly) return uses.assembly;
  if (!leaf.motion) {
    if (uses.count < 2) return std::nullopt;
    if (description::operand_count(leaf.object) <= largest_copied) {
      uses.count = 1;  // not asked again
      return std::nullopt;
    }
  }
  uses.assembly = new_assembly(leaf);
  return uses.assembly;
}

void Assembler::refuse_sections(const Leaf& leaf) const {
  if (leaf.removed.empty() && !cut_by_scene_) return;
  throw Error(
      leaf.object.where.location(), "a section cannot cut what moves",
      "leave out the motion, or subtract the solid from the object: (a - b):motion { ... }");
}

}  // namespace

geometry::SolidScene::Parts geometry_parts(Solids&& solids) {
  geometry::SolidScene::Parts parts;
  parts.expression = std::move(solids.expression);
  parts.assemblies = std::move(solids.assemblies);
  parts.instances = std::move(solids.instances);
  for (const SolidRegion& region : solids.regions) parts.regions.push_back(region.region);
  return parts;
}

Solids assemble(const description::SceneDescription& scene, MeshSolids& meshes, std::size_t most) {
  meshes.begin_scene();
  Solids solids = Assembler(scene, meshes, most).assemble();
  meshes.end_scene();
  return solids;
}

Solids assemble(const description::SceneDescription& scene, std::size_t most) {
  MeshSolids meshes;
  return assemble(scene, meshes, most);
}

}  // namespace lapidary::scene
