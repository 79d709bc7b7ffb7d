#include "rtcore/accel/mesh_bounds.h"

#include "rtcore/accel/float4.h"
#include "rtcore/accel/task_loop.h"

#include <algorithm>
#include <vector>

namespace rtcore {

Box3 boundsInTasks(const Mesh& mesh) {
    constexpr std::size_t kChunk = 65'536;
    const Bounds4 nothing{set4(Box3::kHuge), set4(-Box3::kHuge)};
    std::vector<Bounds4> parts((mesh.triangles.size() + kChunk - 1) / kChunk);
    forEachInTasks(parts.size(), [&](std::size_t chunk) {
        const std::size_t end = std::min(mesh.triangles.size(), (chunk + 1) * kChunk);
        Bounds4 part = nothing;
        for (std::size_t i = chunk * kChunk; i < end; ++i) part = extended(part, boundsOf(mesh, i));
        parts[chunk] = part;
    });
    Bounds4 all = nothing;
    for (const Bounds4& part : parts) all = extended(all, part);
    return boxOf(all);
}

} // namespace rtcore
