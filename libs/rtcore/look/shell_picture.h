/// Skies that were modelled around everything, as environments in their place.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/scene/environment.h"
#include "rtcore/scene/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace rtcore {

/// What a shell gives off to all sides, as seen from the middle of what is not part of it, and named `name`;
/// where it is open, its mean. Nothing where no piece is of it, and where it gives off no light or the same
/// everywhere: that is a colour and no picture. `pieces`: one value for each of Model::parts, not 0 where it
/// is of the shell; `tree`: of the model's mesh. Some 0.2 s, by all threads; the same bits for every number
/// of them.
std::optional<Environment> pictureOfShell(const Scene& scene, const KdTree& tree,
                                          std::span<const std::uint8_t> pieces, std::string name);

} // namespace rtcore
