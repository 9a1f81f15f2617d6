#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "description/camera.h"
#include "description/light.h"
#include "description/object.h"
#include "schema/reader.h"

namespace lapidary::texture {
struct Texture;
}

namespace lapidary::schema {

/// What a message calls a node of type T: "a material"; `hint` names some where people who do not
/// know them yet may look for something else.
template <typename T>
struct NodeWord;
template <>
struct NodeWord<description::Object> {
  static constexpr std::string_view type = "object";
  static constexpr std::string_view wanted = "an object";
  static constexpr std::string_view hint = "";
};
template <>
struct NodeWord<description::Material> {
  static constexpr std::string_view type = "material";
  static constexpr std::string_view wanted = "a material";
  static constexpr std::string_view hint =
      "materials are matte, metal, glass, principled and others, as in metal \"gold\"";
};
template <>
struct NodeWord<description::Light> {
  static constexpr std::string_view type = "light";
  static constexpr std::string_view wanted = "a light";
  static constexpr std::string_view hint = "";
};
template <>
struct NodeWord<description::Camera> {
  static constexpr std::string_view type = "camera";
  static constexpr std::string_view wanted = "a camera";
  static constexpr std::string_view hint =
      "cameras are perspective, orthographic, panorama and fisheye, as in perspective { from = { "
      "4, -7, 4 } }";
};
template <>
struct NodeWord<texture::Texture> {
  static constexpr std::string_view type = "texture";
  static constexpr std::string_view wanted = "a texture";
  static constexpr std::string_view hint =
      "textures are made as in checker { \"white\", \"black\" }";
};
template <>
struct NodeWord<Spectrum> {
  static constexpr std::string_view type = "spectrum";
  static constexpr std::string_view wanted = "a spectrum";
  static constexpr std::string_view hint = "spectra are spectrum { ... } and blackbody(kelvin)";
};

/// Null when `value` is no node of type T.
template <typename T>
std::shared_ptr<const T> node_as(const Value& value) {
  return value.kind() == ValueKind::node ? value.node().as<T>() : nullptr;
}

/// Nodes that are shared.
template <typename T>
requires requires {
  NodeWord<T>::type;
}
struct Reader<std::shared_ptr<const T>> {
  static std::string type() { return std::string(NodeWord<T>::type); }
  static std::shared_ptr<const T> read(const Value& value, const Context& context) {
    auto node = node_as<T>(value);
    if (!node) fail_type(NodeWord<T>::wanted, value, context, NodeWord<T>::hint);
    return node;
  }
  static std::string text(const std::shared_ptr<const T>&) { return ""; }
};

/// Nodes that are copied.
template <typename T>
requires requires {
  NodeWord<T>::type;
}
struct Reader<T> {
  static std::string type() { return std::string(NodeWord<T>::type); }
  static T read(const Value& value, const Context& context) {
    return *Reader<std::shared_ptr<const T>>::read(value, context);
  }
  static std::string text(const T&) { return ""; }
};

}  // namespace lapidary::schema

namespace lapidary::description {

/// Objects in lists of lists, as loops and functions make them, flattened.
struct ObjectListReader {
  static std::string type() { return "objects, in lists that may nest"; }
  static std::vector<ObjectPtr> read(const schema::Value& value, const schema::Context& context);
  static std::string text(const std::vector<ObjectPtr>&) { return ""; }
};

/// What is wrong with `value` as an operand of Boolean operations, as "a rectangle encloses
/// nothing: use a thin box"; empty when it is a solid.
std::string why_no_solid(const schema::Value& value);

/// An object that encloses something.
struct SolidReader {
  static std::string type() { return "solid"; }
  static ObjectPtr read(const schema::Value& value, const schema::Context& context);
  static std::string text(const ObjectPtr&) { return ""; }
};

/// Solids in lists of lists, flattened.
struct SolidListReader {
  static std::string type() { return "solids, in lists that may nest"; }
  static std::vector<ObjectPtr> read(const schema::Value& value, const schema::Context& context);
  static std::string text(const std::vector<ObjectPtr>&) { return ""; }
};

/// A material that can fill a solid.
struct InteriorReader {
  static std::string type() { return "glass"; }
  static MaterialPtr read(const schema::Value& value, const schema::Context& context);
  static std::string text(const MaterialPtr&) { return ""; }
};

struct CutReader {
  static std::string type() { return "\"cutter\", \"inherit\" or material"; }
  static std::optional<Cut> read(const schema::Value& value, const schema::Context& context);
  static std::string text(const std::optional<Cut>&) { return ""; }
};

}  // namespace lapidary::description
