#include "rtcore/gathering/connected_surfaces.h"

#include "rtcore/math/box.h"
#include "rtcore/scene/weld.h"

#include <cstddef>

namespace rtcore {

void ConnectedSurfaces::find(const Mesh& mesh) {
    constexpr float kMinSize = 0.01F;
    constexpr std::uint32_t kNumbers = 65535; // beyond, some are used again
    DisjointSets sets(mesh.vertices.size());
    for (const auto& triangle : mesh.triangles) {
        sets.join(triangle.v[0], triangle.v[1]);
        sets.join(triangle.v[0], triangle.v[2]);
    }
    std::vector<Box3> boxes(mesh.vertices.size());
    Box3 all;
    for (const auto& triangle : mesh.triangles) {
        Box3& box = boxes[sets.find(triangle.v[0])];
        for (const std::uint32_t v : triangle.v) box.extend(mesh.vertices[v].position());
        all.extend(box);
    }
    const float min = kMinSize * all.diagonal();
    std::vector<std::uint16_t> ofSet(boxes.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty() && boxes[i].diagonal() >= min)
            ofSet[i] = static_cast<std::uint16_t>(1 + count++ % kNumbers);
    numbers_.resize(mesh.triangles.size());
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = ofSet[sets.find(mesh.triangles[i].v[0])];
}

} // namespace rtcore
