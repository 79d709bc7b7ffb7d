/// Reading of models that may lie far from their file's zero.
#pragma once

#include "rtcore/io/import/file_import.h"
#include "rtcore/io/import/mesh/geometry_finish.h"

#include <filesystem>
#include <optional>

namespace rtcore {

/// Says what was taken off, and warns where the file's own positions are too coarse.
void noteOrigin(const LocalOrigin& origin, FileImport& import);
inline void noteOrigin(const LocalOrigin& origin, std::optional<FileImport>& import) {
    if (import) noteOrigin(origin, *import);
}

/// What `read` makes of the file; where finishGeometry() wants an origin taken off, it is asked once more,
/// with that. Each reader of models is called by way of this. Throws what `read` throws.
template <typename Read>
auto readNearZero(const Read& read, const std::filesystem::path& path, FileImportOptions options) {
    try {
        return read(path, options);
    } catch (const FarFromZero& far) {
        options.origin = far.origin;
    }
    auto import = read(path, options);
    noteOrigin(options.origin, import);
    return import;
}

} // namespace rtcore
