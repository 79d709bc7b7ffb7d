/// The import itself, as it runs in the importer program. Everything else asks importModel (model_import.h),
/// since Assimp may crash, hang or eat all memory on a damaged file.
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/scene/model.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

namespace rtcore {

struct AssimpOptions {
    float creaseAngle = 40;              ///< degrees, for normals that the file does not have
    std::uint64_t memoryLimit = 0;       ///< bytes; a model that cannot fit is refused early; 0 = none
    std::function<void()> alive = [] {}; ///< called now and then as long as there is progress
};

struct AssimpResult {
    ModelBuffers model;
    ImportReport report;
    std::shared_ptr<const void> source; ///< Assimp's own data; a program that ends anyway need not free it
};

/// Reads any format that Assimp knows: all meshes under all nodes, materials, lights, cameras. Order of
/// triangles: nodes depth first, then meshes, then faces as in the file. Throws FileError BadData with a
/// message without the name of the file, and std::bad_alloc.
AssimpResult importWithAssimp(const std::filesystem::path& path, const AssimpOptions& options);

} // namespace rtcore
