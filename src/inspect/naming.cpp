#include "inspect/naming.h"

#include <variant>

#include <fmt/format.h>

#include "spectrum/refractive_index.h"

namespace lapidary::inspect {
namespace {

struct KindOf {
  std::string operator()(const geometry::Solid& solid) const { return std::visit(*this, solid); }
  std::string operator()(const geometry::Sheet& sheet) const { return std::visit(*this, sheet); }
  std::string operator()(const description::Mesh&) const { return "mesh"; }
  std::string operator()(const std::shared_ptr<const description::Group>&) const { return "group"; }
  std::string operator()(const description::Combination& combination) const {
    switch (combination.operation()) {
      case description::SetOperation::unite:
        return "union";
      case description::SetOperation::intersect:
        return "intersection";
      case description::SetOperation::complement:
        return "complement";
      case description::SetOperation::subtract:
      case description::SetOperation::section:
        break;
    }
    return "difference";
  }
  std::string operator()(const geometry::Sphere&) const { return "sphere"; }
  std::string operator()(const geometry::Box&) const { return "box"; }
  std::string operator()(const geometry::Cylinder&) const { return "cylinder"; }
  std::string operator()(const geometry::Cone&) const { return "cone"; }
  std::string operator()(const geometry::Torus&) const { return "torus"; }
  std::string operator()(const geometry::Quadric&) const { return "quadric"; }
  std::string operator()(const geometry::HalfSpace&) const { return "half-space"; }
  std::string operator()(const geometry::MeshBody&) const { return "mesh"; }
  std::string operator()(const geometry::Polyhedron&) const { return "polyhedron"; }
  std::string operator()(const geometry::Prism&) const { return "prism"; }
  std::string operator()(const geometry::Lathe&) const { return "lathe"; }
  std::string operator()(const geometry::Superellipsoid&) const { return "superellipsoid"; }
  std::string operator()(const geometry::Rectangle&) const { return "rectangle"; }
  std::string operator()(const geometry::Disk&) const { return "disk"; }
};

}  // namespace

std::string kind_of(const description::Object& object) {
  return std::visit(KindOf{}, object.content);
}

std::string kind_of(const geometry::Solid& solid) {
  return std::visit(KindOf{}, solid);
}

std::string kind_of(const geometry::Sheet& sheet) {
  return std::visit(KindOf{}, sheet);
}

std::string label_of(const description::Leaf& leaf) {
  if (!leaf.name.empty()) return std::string(leaf.name);
  const std::string where = to_string(leaf.object.where.location());
  return where.empty() ? kind_of(leaf.object) : fmt::format("{} ({})", kind_of(leaf.object), where);
}

std::string glass_name(const description::Material& material) {
  if (!material.name.empty()) return material.name;
  const description::Glass* glass = description::as_glass(material);
  if (glass == nullptr) return "";
  for (const std::string& name : glass_names()) {
    if (find_glass(name) == glass->index) return name;
  }
  return "";
}

}  // namespace lapidary::inspect
