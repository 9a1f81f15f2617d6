#include "description/camera_parameters.h"

namespace lapidary::description {

void check_view(const View& view, const schema::Context& context) {
  if (view.from == view.at) {
    context.at("at").fail("must differ from 'from'", "the camera stands at what it looks at");
  }
  if (length(view.up) == 0.0) context.at("up").fail("must not be zero");
  const Vec3d forward = normalize(view.at - view.from);
  // Within a millionth of a degree of it, no digit of the horizon would be left.
  if (length(cross(forward, normalize(view.up))) < 1e-8) {
    context.at("up").fail("must not be parallel to the view",
                          "looking straight down or up, say up = {0, 1, 0}");
  }
}

}  // namespace lapidary::description
