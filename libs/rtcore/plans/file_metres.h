/// Lengths of a scene in metres, as people write them.
#pragma once

#include "rtcore/scene/scene.h"

namespace rtcore {

/// Scene::metresPerUnit as it was written: 0.001, which no float is.
double exactMetresPerUnit(const Scene& scene);

/// A height along the up axis, from scene units to metres in the coordinates of the model's file, and the way
/// back.
double heightInFile(const Scene& scene, double height);
double heightInScene(const Scene& scene, double metres);

} // namespace rtcore
