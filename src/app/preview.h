#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "app/outputs.h"
#include "render/canvas.h"

namespace lapidary::app {

/// A picture on disk that shows how far a running render has come, for a viewer that looks at it
/// anew when it changes. It is replaced at once: a reader never sees half of one.
class Preview {
 public:
  using Clock = std::chrono::steady_clock;

  /// The origin must outlive this.
  Preview(std::string file, const render::Origin& origin)
      : file_(std::move(file)), origin_(origin) {}

  using Warn = std::function<void(const std::string&)>;

  /// To be called between blocks: writes the picture after the first one, then each 2 seconds, or
  /// as seldom as keeps it within 2 % of the time. Where that fails `warn` gets a text, once until
  /// it works again.
  void block_done(const render::Canvas& canvas, const Warn& warn);

  /// To be called at the end: writes it as it is.
  void finish(const render::Canvas& canvas, const Warn& warn) { write(canvas, warn); }

 private:
  void write(const render::Canvas& canvas, const Warn& warn);

  std::string file_;
  const render::Origin& origin_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
  bool is_failing_ = false;
};

}  // namespace lapidary::app
