/// The animation that a pose is taken from.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/scene/pose_choice.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace rtcore {

/// Its number in `names`, where "" is one without a name; nothing for the pose of rest, and with a warning
/// where the first is asked for and there is none. Throws FileError BadData, with those that there are, for
/// one that is not there.
std::optional<std::size_t> animationOf(const PoseChoice& pose, std::span<const std::string> names,
                                       ImportReport& report);

} // namespace rtcore
