/// The interface of all readers of models, inside of the importer program. Everything else calls importModel
/// (model_import.h).
#pragma once

#include "rtcore/io/import/import_report.h"
#include "rtcore/scene/model.h"
#include "rtcore/scene/pose_choice.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

namespace rtcore {

struct FileImportOptions {
    float creaseAngle = 40;        ///< degrees, for normals that the file does not have
    float deflection = 0.0005F;    ///< of CAD's surfaces: how far triangles may lie off, by the diagonal
    PoseChoice pose = {};          ///< of what the file animates
    std::uint64_t memoryLimit = 0; ///< bytes; a model that cannot fit is refused early; 0 = none
    LocalOrigin origin = {};       ///< what to take off all positions, before they become floats
    std::function<void()> alive = [] {}; ///< called now and then as long as there is progress
};

struct FileImport {
    ModelBuffers model;
    ImportReport report;
    double coarseness = 0; ///< of the floats in which the file has its positions, if they are; looked at
                           ///< where an origin was taken off
    std::shared_ptr<const void>
        source; ///< the reader's own data; a program that ends anyway need not free it
};

/// Reads a model by the reader that fits: scans by importScan (scan_import.h), all else by importWithAssimp
/// (assimp_import.h). Order of triangles: nodes depth first, then meshes, then faces as in the file.
/// A model far from its file's zero is read a second time, with its middle taken off (local_origin.h). Throws
/// FileError BadData with a message without the name of the file, and std::bad_alloc.
FileImport importFile(const std::filesystem::path& path, const FileImportOptions& options);

} // namespace rtcore
