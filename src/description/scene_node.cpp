#include <fmt/format.h>

#include "description/node_readers.h"
#include "description/nodes.h"
#include "description/scene_description.h"
#include "description/settings_readers.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Value;

struct LengthUnit {
  std::string_view name;
  double metres;
};
constexpr std::array<LengthUnit, 8> length_units{{{"m", 1},
                                                  {"dm", 1e-1},
                                                  {"cm", 1e-2},
                                                  {"mm", 1e-3},
                                                  {"um", 1e-6},
                                                  {"km", 1e3},
                                                  {"in", 0.0254},
                                                  {"ft", 0.3048}}};

constexpr auto unit_names = [] {
  std::array<std::string_view, length_units.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = length_units[i].name;
  return names;
}();

struct UnitReader {
  static std::string type() { return schema::join_or_quoted(unit_names); }
  static double read(const Value& value, const Context& context) {
    return length_units[schema::read_word(value, unit_names, context)].metres;
  }
  static std::string text(double metres) {
    for (const LengthUnit& unit : length_units) {
      if (unit.metres == metres) return fmt::format("\"{}\"", unit.name);
    }
    return "";
  }
};

/// The entries of `lights`: those without a surface, and objects that give light.
struct LightList {
  std::vector<Light> lights;
  std::vector<ObjectPtr> objects;
};

struct LightListReader {
  static std::string type() { return "lights, in lists that may nest"; }
  static LightList read(const Value& value, const Context& context) {
    LightList list;
    collect(value, context, list);
    return list;
  }
  static std::string text(const LightList&) { return ""; }

 private:
  static void collect(const Value& value, const Context& context, LightList& list) {
    if (value.kind() == schema::ValueKind::table && value.table().fields.empty()) {
      const auto items = value.table().items;
      for (std::size_t i = 0; i < items.size(); ++i) collect(items[i], context.at(i), list);
    } else if (const auto light = schema::node_as<Light>(value)) {
      list.lights.push_back(*light);
    } else if (const auto object = schema::node_as<Object>(value)) {
      if (!gives_light({&object, 1})) {
        context.fail(fmt::format("is {} that gives no light", value.describe()),
                     "make it wear an emissive material, or move it to 'objects'");
      }
      list.objects.push_back(object);
    } else {
      schema::fail_type("a light", value, context);
    }
  }
};

struct SceneParameters : SceneDescription {
  LightList light_list;
};

}  // namespace

schema::NodeKind scene_kind() {
  using S = SceneParameters;
  schema::Declaration<S> d(
      {.name = "scene",
       .doc = "Everything to render; a scene file returns one.",
       .section = "scene",
       .examples = {"scene { objects = { sphere {}, plane { point = { 0, 0, -1 } } } }"}});
  d.parameter("camera", &S::camera, {.doc = "Who looks; frames the objects when left out."})
      .parameter<LightListReader>("lights", &S::light_list,
                                  {.doc = "What gives light; a studio's when left out."})
      .parameter<ObjectListReader>("objects", &S::objects, {.doc = "What there is to see."})
      .parameter<SolidReader>("section", &S::section,
                              {.doc = "A solid to take away from all others but those that are "
                                      "lights, to show their insides; the faces wear its material, "
                                      "if it has one."})
      .parameter("render", &S::render,
                 {.doc = "Size, samples and more; see `lapidary help render`."})
      .parameter("film", &S::film, {.doc = "Exposure and tone; see `lapidary help film`."})
      .parameter<UnitReader>("unit", &S::metres_per_unit,
                             {.doc = "How long a unit of length is; moves nothing."});
  return node_kind(std::move(d), [](S&& s, const Context& context) {
    s.where = context.call().where;
    s.lights = std::move(s.light_list.lights);
    s.objects.insert(s.objects.end(), s.light_list.objects.begin(), s.light_list.objects.end());
    auto scene = std::make_shared<const SceneDescription>(std::move(s));
    return schema::Node::of<SceneDescription>(context.call().node, std::move(scene),
                                              sizeof(SceneDescription));
  });
}

}  // namespace lapidary::description
