#pragma once

#include <cstddef>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "description/object.h"

namespace lapidary::description {

/// Computes something for `root` from the same for its parts, bottom up:
///
///   Result leaf(const Object&)                                 what has no parts: solids,
///   meshes... Result join(const Object&, std::span<const Result> parts)  groups and combinations
///   Parts parts(const Object&)                                 those that matter, if not all
///
/// Without recursion, since combinations nest to any depth, and once for each part, however often
/// it is used. The result for an object is in the coordinates of what holds it.
template <typename Result, typename LeafOf, typename Join, typename PartsOf = decltype(&parts_of)>
Result fold(const Object& root, LeafOf leaf, Join join, PartsOf parts_that_matter = parts_of) {
  struct Level {
    const Object* object;
    Parts parts;
    std::size_t next;   ///< part to visit
    std::size_t first;  ///< of its parts' results
    bool keep;          ///< somebody may ask again
  };
  std::vector<Level> levels;
  std::vector<Result> results;
  std::unordered_map<const Object*, Result> known;
  const auto enter = [&](const Object& object, bool keep) {
    const bool is_leaf = !object.combination() &&
                         !std::holds_alternative<std::shared_ptr<const Group>>(object.content);
    if (is_leaf) return results.push_back(leaf(object));
    const auto found = keep ? known.find(&object) : known.end();
    if (found != known.end()) return results.push_back(found->second);
    levels.push_back({&object, parts_that_matter(object), 0, results.size(), keep});
  };
  enter(root, false);
  while (!levels.empty()) {
    Level& level = levels.back();
    if (level.next < level.parts.objects.size()) {
      const ObjectPtr& part = level.parts.objects[level.next++];
      enter(*part, level.parts.shared || part.use_count() > 1);
      continue;
    }
    const Level done = level;
    levels.pop_back();
    Result result = join(*done.object, std::span<const Result>(results).subspan(done.first));
    results.resize(done.first);
    if (done.keep) known.emplace(done.object, result);
    results.push_back(std::move(result));
  }
  return std::move(results.back());
}

}  // namespace lapidary::description
