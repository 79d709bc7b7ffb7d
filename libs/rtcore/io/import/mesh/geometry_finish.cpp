#include "rtcore/io/import/mesh/geometry_finish.h"

#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/mesh/equal_positions.h"
#include "rtcore/io/import/mesh/equal_triangles.h"
#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <algorithm>

namespace rtcore {

namespace {

[[noreturn]] void refuseMesh(const Sentence& message) { throw FileError(FailureKind::BadData, "", message); }

void refuseEmpty(const ImportReport& report, std::size_t meshes, const ModelBuffers& model) {
    if (!model.triangles.empty()) return;
    refuseMesh(say("it holds no triangles ({0} points and lines, {1} triangles without area, {2} with broken "
                   "coordinates, {3} with corners that do not exist, {4} meshes); give a model with surfaces",
                   report.ignoredPrimitives, report.degenerateTriangles, report.nonFiniteTriangles,
                   report.unconnectedTriangles, meshes));
}

/// Smaller models would vanish in the rounding of products of their coordinates.
void refuseTooSmall(const Box3& bounds) {
    constexpr float kMinSize = 1e-12F;
    if (bounds.empty()) return;
    const Vec3 size = bounds.size();
    const float largest = std::max({size.x, size.y, size.z});
    if (largest == 0 || largest >= kMinSize) return;
    refuseMesh(say("it is only {0} units large, too small to be traced; scale it up by a factor of {1}",
                   fmt::format("{:g}", largest),
                   fmt::format("{:.0e}", 1 / std::max(double{largest}, 1e-45))));
}

FileBounds boundsOf(const Box3& box) {
    FileBounds bounds;
    if (box.empty()) return bounds;
    bounds.extend(box.lo);
    bounds.extend(box.hi);
    return bounds;
}

/// That of all, else of nearly all: a corner that was left at zero does not keep a house on its grid.
template <typename Point>
void refuseFarAt(const FileBounds& bounds, std::span<const Point> points, const LocalOrigin& taken) {
    constexpr double kFine = 1e-6, kSeen = 1e-4; // of the size
    if (!taken.isZero()) return;
    LocalOrigin wanted = originOf(bounds, kFine);
    if (wanted.isZero() && !points.empty()) wanted = originOf(boundsOf(bulkOf(points)), kSeen);
    if (!wanted.isZero()) throw FarFromZero{wanted};
}

} // namespace

void refuseTooMuch(const ExpandedCount& count, std::uint64_t memoryLimit, std::uint64_t bytesOfPart) {
    constexpr std::uint64_t kMaxParts = 50'000'000, kBytesOfTriangle = 100, kMega = 1'000'000;
    if (count.parts > kMaxParts)
        refuseMesh(say("with all instances it has {0} parts, more than {1}; export fewer instances",
                       count.parts, kMaxParts));
    const ExpandedCount triangles{0, 0, std::max(count.triangles, count.vertices / 4)};
    const std::uint64_t bytes = count.parts * bytesOfPart + triangles.times(kBytesOfTriangle).triangles;
    if (memoryLimit == 0 || bytes <= memoryLimit) return;
    if (count.parts == 0)
        refuseMesh(
            say("its {0} triangles take {1} MB of memory, more than the {2} MB that the importer may use; "
                "raise that (--memory-limit), else simplify the model",
                triangles.triangles, bytes / kMega, memoryLimit / kMega));
    refuseMesh(
        say("with all instances it has {0} parts and {1} triangles, which take {2} MB of memory, more than "
            "the {3} MB that the importer may use; raise that (--memory-limit), else export fewer instances "
            "or simplify the model",
            count.parts, count.triangles, bytes / kMega, memoryLimit / kMega));
}

void makeRoomFor(const ExpandedCount& count, std::uint64_t memoryLimit, MeshAssembler& assembler) {
    refuseTooMuch(count, memoryLimit);
    assembler.reserve(count.vertices, count.triangles);
}

void refuseFar(std::span<const Vec3> positions, const LocalOrigin& taken) {
    FileBounds bounds;
    for (const Vec3 p : positions)
        if (isUsablePosition(p)) bounds.extend(p);
    refuseFarAt(bounds, positions, taken);
}

void refusePoints(std::uint64_t count) {
    refuseMesh(say(
        "it is a cloud of {0} points, which has no surfaces; make a mesh of it (CloudCompare, MeshLab) and "
        "save that as PLY",
        count));
}

void finishGeometry(MeshAssembler& assembler, float creaseAngle, const LocalOrigin& origin,
                    FileImport& import) {
    assembler.weld();
    refuseFarAt(boundsOf(assembler.bounds()), assembler.vertices(), origin);
    assembler.finish(import.model, creaseAngle);
    import.report.degenerateTriangles = assembler.degenerateTriangles();
    import.report.nonFiniteTriangles = assembler.nonFiniteTriangles();
}

void refuseUseless(const MeshAssembler& assembler, std::size_t meshes, FileImport& import) {
    refuseTooSmall(assembler.bounds());
    refuseEmpty(import.report, meshes, import.model);
    import.report.equalTriangles = removeEqualTriangles(import.model);
}

} // namespace rtcore
