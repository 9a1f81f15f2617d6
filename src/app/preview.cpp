#include "app/preview.h"

#include <algorithm>
#include <new>
#include <string_view>

#include <fmt/core.h>

#include "base/error.h"
#include "film/develop.h"
#include "image/image_io.h"

namespace lapidary::app {

void Preview::write(const render::Canvas& canvas, const Warn& warn) {
  const auto fail = [&](std::string_view why) {
    if (!is_failing_) warn(fmt::format("{}; the preview stays as it was", why));
    is_failing_ = true;
  };
  const std::chrono::duration<double> so_far = Clock::now() - start_;
  try {
    image::write_image(file_, film::develop(canvas.picture()),
                       write_options(canvas, {origin_, so_far.count()}));
    is_failing_ = false;
  } catch (const Error& error) {
    fail(error.what());
  } catch (const std::bad_alloc&) {
    fail("there is not enough memory for the preview");
  }
}

void Preview::block_done(const render::Canvas& canvas, const Warn& warn) {
  using namespace std::chrono_literals;
  constexpr int least_share = 50;  // of the time, one part for this
  const Clock::time_point begin = Clock::now();
  if (begin < next_) return;
  write(canvas, warn);
  const Clock::time_point end = Clock::now();
  next_ = end + std::max<Clock::duration>(2s, least_share * (end - begin));
}

}  // namespace lapidary::app
