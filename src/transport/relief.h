#pragma once

#include "bsdf/surface_detail.h"
#include "transport/lookup.h"

namespace lapidary::transport {

/// The shading normal of a surface that has relief, on the side of its geometric normal, bent so
/// that a ray along `direction` sees the side that it meets. Bumps are as coarse as what the lookup
/// covers. Source: Blinn 1978, "Simulation of Wrinkled Surfaces".
Vec3d relief_normal(const bsdf::SurfaceDetail& detail, const geometry::Surface& surface,
                    const SurfaceLookup& lookup, Vec3d direction);

}  // namespace lapidary::transport
