/// The storeys of a building, by the heights of its floors.
#pragma once

#include "rtcore/scene/scene.h"

#include <vector>

namespace rtcore {

struct Storey {
    double height = 0; ///< of its floor along the up axis, in scene units
    double area = 0;   ///< of faces at that height that look up, in square scene units
};

/// From the lowest up. Where faces that look up have far more area than at heights near by, and a person has
/// room between that and the top of the model; two floors are two metres apart at least. Empty for a model
/// that has none. Hidden parts do not count.
std::vector<Storey> storeysOf(const Scene& scene);

} // namespace rtcore
