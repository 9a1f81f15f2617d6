#include "app/different_picture.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lapidary::app {

DifferentPicture::DifferentPicture(const std::string& problem,
                                   const std::vector<std::string>& differences, std::string hint)
    : std::runtime_error(fmt::format("{}:\n  {}", problem, fmt::join(differences, "\n  "))),
      hint_(std::move(hint)) {}

}  // namespace lapidary::app
