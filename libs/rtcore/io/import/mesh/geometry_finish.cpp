#include "rtcore/io/import/mesh/geometry_finish.h"

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

} // namespace

void refuseTooMuch(std::uint64_t vertices, std::uint64_t triangles, std::uint64_t memoryLimit,
                   MeshAssembler& assembler) {
    constexpr std::uint64_t kBytesPerTriangle = 100;
    const std::uint64_t max = memoryLimit > 0 ? memoryLimit / kBytesPerTriangle : ~std::uint64_t{0};
    if (triangles > max || vertices / 4 > max) {
        refuseMesh(
            say("with all instances it has {0} faces, more than fit into the memory that it may use; raise "
                "the limit or simplify the model",
                triangles));
    }
    assembler.reserve(vertices, triangles);
}

void refusePoints(std::uint64_t count) {
    refuseMesh(say(
        "it is a cloud of {0} points, which has no surfaces; make a mesh of it (CloudCompare, MeshLab) and "
        "save that as PLY",
        count));
}

void finishGeometry(MeshAssembler& assembler, float creaseAngle, FileImport& import) {
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
