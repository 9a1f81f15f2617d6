#include <string_view>

#include <fmt/core.h>

#include "app/commands.h"
#include "image/compare.h"
#include "image/image_io.h"

namespace lapidary::app {
namespace {

std::string_view name_of(image::Metric metric) {
  switch (metric) {
    case image::Metric::relmse:
      return "relmse";
    case image::Metric::mse:
      return "mse";
    case image::Metric::mae:
      return "mae";
    case image::Metric::energy:
      return "energy";
    case image::Metric::flip:
      return "flip";
  }
  return "";
}

}  // namespace

ExitCode run(const CompareCommand& command) {
  const image::Image picture = image::read_image(command.image);
  const image::Image reference = image::read_image(command.reference);
  const double difference = image::compare(picture, reference, command.options);
  fmt::print("{} {}\n", name_of(command.options.metric), difference);
  return ExitCode::done;
}

}  // namespace lapidary::app
