#include "common/cli/import_options.h"

#include <cstdint>

namespace app {

rtcore::ImportOptions readImportOptions(const Arguments& arguments) {
    rtcore::ImportOptions options;
    if (const auto angle = arguments.number("crease-angle")) options.creaseAngle = static_cast<float>(*angle);
    if (arguments.has("flip-textures")) options.flipTextures = true;
    if (const auto limit = arguments.integer("memory-limit")) {
        options.memoryLimit = static_cast<std::uint64_t>(*limit) * 1'000'000;
    }
    if (const auto limit = arguments.number("time-limit")) options.timeLimit = *limit;
    return options;
}

} // namespace app
