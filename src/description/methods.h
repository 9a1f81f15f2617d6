#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "description/object.h"
#include "schema/node_kind.h"

namespace lapidary::texture {
struct Texture;
}

namespace lapidary::description {

/// Something a T can be asked for that gives another; the first stays.
template <typename T>
struct MethodOf {
  schema::NodeInfo info;
  std::function<std::shared_ptr<const T>(const T& thing, const schema::Value& argument,
                                         const schema::Call& call)>
      apply;
};
using Method = MethodOf<Object>;
using TextureMethod = MethodOf<texture::Texture>;

/// material, interior, priority, cut, section, name, all moves, and motion.
std::vector<Method> object_methods();
/// All moves: of the pattern in space, and on a surface with (u, v) for (x, y).
std::vector<TextureMethod> texture_methods();

}  // namespace lapidary::description
