#pragma once

#include <vector>

#include "image/compare.h"
#include "image/image.h"

namespace lapidary::image {

/// LDR-FLIP: for each pixel of the crop, how strongly a viewer notices the difference when the two
/// images alternate in place, from 0 to 1; the viewer sees 67 pixels per degree (0.7 m from a
/// 0.7 m wide screen of 3840 pixels). Symmetric.
///
/// FLIP compares pictures on a display, so the linear light is cut off to [0, 1] first, which is
/// Tone::none with clipped negatives: highlights beyond 1 do not count. The filters repeat the
/// border pixels of the crop. Precondition: images of one size, three channels or more, the crop
/// inside. Accuracy: float, about 1e-4.
///
/// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: FLIP: A Difference Evaluator
/// for Alternating Images, HPG 2020, sections 4.1 to 4.4.
std::vector<float> flip_map(const Image& image, const Image& reference, const Crop& crop);

}  // namespace lapidary::image
