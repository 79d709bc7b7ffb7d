#include "rtcore/io/import/file_import.h"

#include "rtcore/io/import/assimp/assimp_import.h"
#include "rtcore/io/import/gltf/gltf_import.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/obj/obj_import.h"
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

/// Readers of our own, in the order in which they are asked.
constexpr std::array kReaders{importScan, importGltf, importObj, importThreeMf};

} // namespace

FileImport importFile(const std::filesystem::path& path, const FileImportOptions& options) {
    if (const auto sentence = unreadFormat(path)) throw FileError(FailureKind::BadData, "", *sentence);
    std::optional<FileImport> own;
    for (const auto read : kReaders)
        if (!own) own = read(path, options);
    FileImport import = own ? std::move(*own) : importWithAssimp(path, options);
    greyWhereNoColourIs(import);
    return import;
}

} // namespace rtcore
