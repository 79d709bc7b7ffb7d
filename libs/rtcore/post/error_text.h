/// The words for an error that is left in an image, in texts of files and on command lines.
#pragma once

#include <fmt/core.h>

#include <string>

namespace rtcore {

/// Such as "+-0.60 of 255, largest 2.1", in ASCII: those of net_mix.h, in codes of 255.
inline std::string errorText(float error, float largest) {
    return fmt::format("+-{:.2f} of 255, largest {:.1f}", error, largest);
}

} // namespace rtcore
