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

/// An environment `name` of the light of a shell, as seen from the middle of the model without it; where the
/// shell is open, its mean. Nothing where no piece is of it, and where it emits no light or the same
/// everywhere: that is a colour and no picture. `pieces`: one value for each of Model::parts, not 0 where it
/// is of the shell; `tree`: of the model's mesh. Some 0.2 s, by all threads; the same bits for every number
/// of them.
std::optional<Environment> pictureOfShell(const Scene& scene, const KdTree& tree,
                                          std::span<const std::uint8_t> pieces, std::string name);

} // namespace rtcore
