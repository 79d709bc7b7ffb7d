/// How much indirect light is learned for a file of it.
#pragma once

#include <limits>

namespace renderer {

struct LightBounds {
    double seconds = std::numeric_limits<double>::infinity();
    double megabytes = std::numeric_limits<double>::infinity(); ///< of the file
};

} // namespace renderer
