#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace lapidary::app {

/// Checkpoints are of another picture than what is to be made with them.
class DifferentPicture : public std::runtime_error {
 public:
  /// `differences` as render::differences states them.
  DifferentPicture(const std::string& problem, const std::vector<std::string>& differences,
                   std::string hint);

  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

}  // namespace lapidary::app
