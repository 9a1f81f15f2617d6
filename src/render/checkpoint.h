#pragma once

#include <filesystem>
#include <string_view>

#include "image/image_io.h"
#include "render/canvas.h"
#include "render/origin.h"

namespace lapidary::render {

/// A render written down between two blocks: going on from it gives the same bits as never having
/// stopped.
///
/// It travels as the second part of an OpenEXR file whose first part is the picture. Its channels
/// are whole numbers of 32 bits: "sum.R.hi" and "sum.R.lo" are the two halves of the 64-bit sum of
/// R, and so on for each layer; "square.R.hi", ... those that the variance follows from; "samples",
/// "object" and "hits" of each pixel; "counts.0" has samples a pass less one of the first eight
/// epochs of adaptive sampling, 4 bits each from the lowest on, "counts.1" those of the next.
/// Attributes say the rest as text.
struct Checkpoint {
  Origin origin;
  Canvas canvas;
};

/// The name of the part.
inline constexpr std::string_view checkpoint_part = "checkpoint";

/// What `read_checkpoint` reads. It refers to the canvas, which must stay as it is until the file
/// is written. Films that wait for a decision are left out, and so is what was cut short.
image::Attachment checkpoint_of(const Origin& origin, const Canvas& canvas);

/// Throws Error for a file that cannot be read, is no checkpoint or one of another format, or
/// contradicts itself.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace lapidary::render
