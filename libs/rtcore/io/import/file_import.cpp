#include "rtcore/io/import/file_import.h"

#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/io/import/gltf/gltf_import.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/obj/obj_import.h"
#include "rtcore/io/import/pose/animation_choice.h"
#include "rtcore/io/import/scan/scan_import.h"
#include "rtcore/io/import/threemf/threemf_import.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

/// Formats of scans have shapes, and seldom colours: their readers make a white of it that scatters all
/// light, as nothing does, and in which no shape can be told in full light.
void greyWhereNoColourIs(FileImport& import) {
    constexpr std::array<std::string_view, 2> kScans{"Stereolithography", "Stanford"};
    const bool scan = std::ranges::any_of(kScans, [&](std::string_view format) {
        return import.report.origin.format.find(format) != std::string::npos;
    });
    if (!scan || !import.model.colours.empty()) return;
    for (Material& m : import.model.materials)
        if (m.diffuse == kWhite && m.diffuseTexture == kNoTexture) m.diffuse = kUnsetDiffuse;
}

/// Models of formats in which nothing moves.
std::optional<FileImport> importStill(const std::filesystem::path& path, const FileImportOptions& options) {
    std::optional<FileImport> import = importScan(path, options);
    if (!import) import = importObj(path, options);
    if (!import) import = importThreeMf(path, options);
    if (import) animationOf(options.pose, {}, import->report);
    return import;
}

/// Readers of our own, in the order in which they are asked.
constexpr std::array kReaders{importStill, importGltf};

FileImport readFile(const std::filesystem::path& path, const FileImportOptions& options) {
    for (const auto read : kReaders)
        if (auto own = read(path, options)) return std::move(*own);
    return importWithAssimp(path, options);
}

} // namespace

FileImport importFile(const std::filesystem::path& path, const FileImportOptions& options) {
    if (const auto sentence = unreadFormat(path)) throw FileError(FailureKind::BadData, "", *sentence);
    FileImport import = readFile(path, options);
    greyWhereNoColourIs(import);
    return import;
}

} // namespace rtcore
