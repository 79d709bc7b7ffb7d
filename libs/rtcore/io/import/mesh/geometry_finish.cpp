#include "rtcore/io/import/mesh/geometry_finish.h"

#include "rtcore/io/import/mesh/equal_triangles.h"
#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <algorithm>

namespace rtcore {

namespace {

[[noreturn]] void refuseMesh(const std::string& message) {
    throw FileError(FailureKind::BadData, "", message);
}

void refuseEmpty(const ImportReport& report, std::size_t meshes, const ModelBuffers& model) {
    if (!model.triangles.empty()) return;
    refuseMesh(
        fmt::format("it holds no triangles ({} points and lines, {} triangles without area, {} with broken "
                    "coordinates, {} with corners that do not exist, {} meshes); give a model with surfaces",
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
    refuseMesh(
        fmt::format("it is only {:g} units large, too small to be traced; scale it up by a factor of {:.0e}",
                    largest, 1 / std::max(double{largest}, 1e-45)));
}

} // namespace

void refuseTooMuch(std::uint64_t vertices, std::uint64_t triangles, std::uint64_t memoryLimit,
                   MeshAssembler& assembler) {
    constexpr std::uint64_t kBytesPerTriangle = 100;
    const std::uint64_t max = memoryLimit > 0 ? memoryLimit / kBytesPerTriangle : ~std::uint64_t{0};
    if (triangles > max || vertices / 4 > max) {
        refuseMesh(fmt::format(
            "with all instances it has {} faces, more than fit into the memory that it may use; raise "
            "the limit or simplify the model",
            triangles));
    }
    assembler.reserve(vertices, triangles);
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
