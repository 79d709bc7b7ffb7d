#include "rtcore/io/import/scan/scan_import.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/inspection/cut_off.h"
#include "rtcore/io/import/inspection/exporter_notes.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/materials/material_mapping.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/mesh/near_zero.h"
#include "rtcore/io/import/scan/ply_elements.h"
#include "rtcore/io/import/scan/ply_file.h"
#include "rtcore/io/import/scan/point_discs.h"
#include "rtcore/io/import/scan/point_text.h"
#include "rtcore/io/import/scan/stl_file.h"
#include "rtcore/io/import/scan/stl_text.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/paths.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

/// Meshes and what Assimp says about their format.
struct Scan {
    std::vector<ScanPart> parts;
    const char* format;
    const char* material; ///< its name
    Colour colour = kWhite;
};

Scan ofOne(ScanMesh mesh, const char* format, const char* material) {
    Scan scan{{}, format, material};
    scan.parts.push_back({"", std::move(mesh)});
    return scan;
}

/// Nothing in files of STL, XYZ and PTS says what they are.
bool isNamed(const std::filesystem::path& path, std::string_view ending) {
    return inSmallLetters(path.extension().string()) == ending;
}

/// Before they are read: heads tell how many there are.
void refuseManyPlyPoints(const PlyHeader& header, std::uint64_t memoryLimit) {
    std::uint64_t points = 0;
    for (const PlyElement& element : header.elements) {
        if (element.name == "vertex") points = element.count;
        const bool surface = element.name == "face" || element.name == "tristrips";
        if (surface && element.count > 0) return;
    }
    refuseManyPoints(points, memoryLimit);
}

Scan readPoints(const std::filesystem::path& path, const FileImportOptions& options, ImportReport& report) {
    refuseMisnamed(path);
    PointText text = readPointText(path, options.origin, report, options.alive);
    refuseManyPoints(text.count, options.memoryLimit);
    const bool coloured = !text.points.colours.empty();
    Scan scan = ofOne(std::move(text.points), "Point cloud (XYZ, PTS)", "");
    scan.colour = coloured ? kWhite : kUnsetDiffuse;
    return scan;
}

std::optional<Scan> readStlScan(const std::filesystem::path& path, const InputFile& file,
                                const LocalOrigin& origin, ImportReport& report,
                                const std::function<void()>& alive) {
    constexpr const char* kFormat = "Stereolithography (STL) Importer";
    constexpr const char* kMaterial = "DefaultMaterial";
    if (auto stl = readStl(file, origin, alive)) {
        Scan scan = ofOne(std::move(stl->mesh), kFormat, kMaterial);
        scan.colour = stl->colour;
        return scan;
    }
    auto solids = readTextStl(path, origin, report, alive);
    if (!solids) return {};
    return Scan{std::move(*solids), kFormat, kMaterial};
}

std::optional<Scan> readScan(const std::filesystem::path& path, const FileImportOptions& options,
                             ImportReport& report) {
    if (!std::filesystem::is_regular_file(path)) return {};
    if (isNamed(path, ".xyz") || isNamed(path, ".pts")) return readPoints(path, options, report);
    const std::function<void()>& alive = options.alive;
    InputFile file(path);
    const std::span<const std::byte> head = file.head(kMaxPlyHeader);
    const std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    const auto header = readPlyHeader(text);
    constexpr const char* kPly = "Stanford Polygon Library (PLY) Importer";
    if (header) refuseManyPlyPoints(*header, options.memoryLimit);
    if (header && (isPlyCloud(*header) || (isScan(*header) && !hasFaceColours(*header))))
        return ofOne(readPly(file, *header, options.origin, alive), kPly, "");
    if (header && isPlyMesh(*header))
        return ofOne(readPlyMesh(file, *header, options.origin, alive), kPly, "");
    if (header && header->isText) refuseCutOffText(file, *header, alive);
    // Assimp takes a tenth of a millisecond for a line of it, and looks for an end that is not there for
    // ever.
    if (endsInPlyHeader(text)) refuseDamaged(say("its head does not end within {0} bytes", head.size()));
    if (!isNamed(path, ".stl")) return {};
    return readStlScan(path, file, options.origin, report, alive);
}

/// What a highlight would need is not in the file.
void addMaterial(const Scan& scan, const std::filesystem::path& path, const FileImportOptions& options,
                 FileImport& import) {
    const NoEmbeddedPictures none;
    TextureStore textures(import.model, import.report, path.parent_path(), none, options.alive);
    SourceMaterial source;
    source.diffuse = source.specular = scan.colour;
    Material material = mapMaterial(source, textures);
    material.nameOffset = import.model.addName(scan.material);
    import.model.materials.push_back(material);
}

double coarsenessOf(const ScanMesh& mesh) {
    FileBounds bounds;
    if (mesh.inFloats && !mesh.origin.isZero())
        for (const Vec3 p : mesh.positions) bounds.extend(mesh.origin.inFile(p));
    return bounds.empty() ? 0 : coarsenessAt(bounds.farthest());
}

/// Which may take the lists.
SourceMesh viewOf(ScanMesh& mesh) {
    SourceMesh view{mesh.positions, mesh.normals, mesh.texcoords, mesh.colours, {}, mesh.triangles};
    view.spare = {&mesh.positions, &mesh.normals, &mesh.texcoords, &mesh.triangles};
    return view;
}

/// Vertices without faces.
void showPoints(ScanMesh points, const std::filesystem::path& path, const FileImportOptions& options,
                FileImport& import) {
    const std::uint64_t count = points.positions.size();
    refuseManyPoints(count, options.memoryLimit);
    refuseFar(points.positions, options.origin);
    const LostPoints lost = addDiscs(std::move(points), import.model, options.alive);
    if (import.model.triangles.empty())
        throw FileError(FailureKind::BadData, "",
                        say("the coordinates of all of its {0} points are no numbers or beyond 1e12", count));
    import.model.parts.push_back({0, 0, static_cast<std::uint32_t>(import.model.triangles.size())});
    if (const auto cut = cutOff(path)) addWarning(import.report, *cut);
    if (lost.nonFinite > 0)
        addWarning(import.report, say(import_forms::kDamagedPoints, lost.nonFinite, count));
    if (lost.equal > 0) addWarning(import.report, say(import_forms::kEqualPoints, lost.equal, count));
    warnOfOutliers(import.model, import.report);
}

std::optional<FileImport> scanAsItLies(const std::filesystem::path& path, const FileImportOptions& options) {
    FileImport import;
    std::optional<Scan> scan = readScan(path, options, import.report);
    if (!scan) return {};
    options.alive();
    import.report.origin = {scan->format, exporterNotes(path), {}, {}};
    addFile(import.report, plainPath(path).string());
    addMaterial(*scan, path, options, import);

    MeshAssembler assembler;
    std::uint64_t vertices = 0, triangles = 0;
    for (const ScanPart& part : scan->parts) {
        vertices += part.mesh.positions.size();
        triangles += part.mesh.triangles.size();
        import.report.ignoredPrimitives += part.mesh.ignoredPrimitives;
        import.report.unconnectedTriangles += part.mesh.unconnectedTriangles;
        import.coarseness = std::max(import.coarseness, coarsenessOf(part.mesh));
    }
    const bool bare = import.report.ignoredPrimitives + import.report.unconnectedTriangles == 0;
    if (triangles == 0 && vertices > 0 && bare && scan->parts.size() == 1) {
        showPoints(std::move(scan->parts[0].mesh), path, options, import);
        return import;
    }
    makeRoomFor({0, vertices, triangles}, options.memoryLimit, assembler);
    for (ScanPart& part : scan->parts) {
        if (part.mesh.triangles.empty() && scan->parts.size() > 1) continue;
        const std::uint32_t first = assembler.triangleCount();
        assembler.add(viewOf(part.mesh));
        import.model.parts.push_back(
            {import.model.addName(part.name), first, assembler.triangleCount() - first});
        part.mesh = {};
        options.alive();
    }
    const std::size_t meshes = scan->parts.size();
    scan.reset();
    finishGeometry(assembler, options.creaseAngle, options.origin, import);
    const std::optional<Sentence> cut = cutOff(path);
    if (cut && import.model.triangles.empty()) throw FileError(FailureKind::BadData, "", *cut);
    refuseUseless(assembler, meshes, import);
    if (cut) addWarning(import.report, *cut);
    warnOfLostTriangles(import.model, import.report);
    warnOfOutliers(import.model, import.report);
    return import;
}

} // namespace

std::optional<FileImport> importScan(const std::filesystem::path& path, const FileImportOptions& options) {
    return readNearZero(scanAsItLies, path, options);
}

} // namespace rtcore
