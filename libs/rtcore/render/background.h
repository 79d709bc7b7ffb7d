/// Treatments of the background of an image.
#pragma once

#include "rtcore/scene/scene.h"

#include <optional>

namespace rtcore {

/// Treatments of the background that is seen in a straight line, past holes and panes. Mirrors, and what
/// bends light, always show it.
enum class Background {
    Shown,
    Apart, ///< in Frame::behind, if it has one colour: what takes noise away leaves it as it is; else Shown
    Hidden ///< Frame::transmitted tells where it would be seen
};

inline bool isHidden(Background background, const Scene& scene) {
    return background == Background::Hidden ||
           (background == Background::Apart && scene.environment() == nullptr);
}

/// Frame::behind.
inline std::optional<Colour> colourBehind(Background background, const Scene& scene) {
    if (background != Background::Apart || scene.environment() != nullptr) return std::nullopt;
    return scene.background;
}

} // namespace rtcore
