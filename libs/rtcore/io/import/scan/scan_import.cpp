#include "rtcore/io/import/scan/scan_import.h"

#include "rtcore/io/import/inspection/exporter_notes.h"
#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/scan/ply_elements.h"
#include "rtcore/io/import/scan/ply_file.h"
#include "rtcore/io/import/scan/stl_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/paths.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

/// A mesh and what Assimp says about its format.
struct Scan {
    ScanMesh mesh;
    const char* format;
    const char* material; ///< its name
};

/// Nothing in an STL file says what it is.
bool isNamedStl(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".stl";
}

std::optional<Scan> readScan(const std::filesystem::path& path, const std::function<void()>& alive) {
    if (!std::filesystem::is_regular_file(path)) return {};
    InputFile file(path);
    const std::span<const std::byte> head = file.head(kMaxPlyHeader);
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    const auto header = readPlyHeader(text);
    if (header && isScan(*header))
        return Scan{readPly(file, *header, alive), "Stanford Polygon Library (PLY) Importer", ""};
    if (header && header->isText) refuseCutOffText(file, *header, alive);
    // Assimp takes a tenth of a millisecond for a line of it, and looks for an end that is not there for
    // ever.
    if (endsInPlyHeader(text)) refuseDamaged(say("its head does not end within {0} bytes", head.size()));
    if (!isNamedStl(path)) return {};
    auto mesh = readStl(file, alive);
    if (!mesh) return {};
    return Scan{std::move(*mesh), "Stereolithography (STL) Importer", "DefaultMaterial"};
}

/// White; what a highlight would need is not in the file.
void addMaterial(const char* name, const std::filesystem::path& path, const FileImportOptions& options,
                 FileImport& import) {
    const NoEmbeddedPictures none;
    TextureStore textures(import.model, import.report, path.parent_path(), none, options.alive);
    SourceMaterial source;
    source.diffuse = source.specular = kWhite;
    Material material = mapMaterial(source, textures);
    material.nameOffset = import.model.addName(name);
    import.model.materials.push_back(material);
}

SourceMesh viewOf(const ScanMesh& mesh) {
    return {mesh.positions, mesh.normals, mesh.texcoords, mesh.colours, {}, mesh.triangles};
}

} // namespace

std::optional<FileImport> importScan(const std::filesystem::path& path, const FileImportOptions& options) {
    std::optional<Scan> scan = readScan(path, options.alive);
    if (!scan) return {};
    options.alive();
    FileImport import;
    import.report.origin = {scan->format, exporterNotes(path), {}, {}};
    import.report.ignoredPrimitives = scan->mesh.ignoredPrimitives;
    addFile(import.report, plainPath(path).string());
    addMaterial(scan->material, path, options, import);

    MeshAssembler assembler;
    refuseTooMuch(scan->mesh.positions.size(), scan->mesh.triangles.size(), options.memoryLimit, assembler);
    assembler.add(viewOf(scan->mesh));
    scan.reset();
    import.model.parts.push_back({0, 0, assembler.triangleCount()});
    options.alive();
    finishGeometry(assembler, options.creaseAngle, import);
    refuseUseless(assembler, 1, import);
    warnOfLostTriangles(import.model, import.report);
    warnOfOutliers(import.model, import.report);
    return import;
}

} // namespace rtcore
