/// Under which name a run shows its image while it refines.
#pragma once

#include <cstdint>
#include <string>

namespace renderer {

struct PreviewOptions {
    std::string instance;
    std::uint64_t run = 0; ///< marks all its frames
    double linger = 2;     ///< seconds for which the last frame can be found
};

} // namespace renderer
