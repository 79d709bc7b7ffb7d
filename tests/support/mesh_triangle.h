/// The leaf test of one triangle of a mesh.
#pragma once

#include "rtcore/kernels/watertight.h"
#include "rtcore/scene/mesh.h"

#include <cstdint>

namespace test {

template <int Kz>
bool testTriangle(const rtcore::Mesh& mesh, std::uint32_t index, const rtcore::Ray& ray,
                  const rtcore::RayShear& shear, rtcore::Hit& hit) {
    const rtcore::Triangle& t = mesh.triangles[index];
    return rtcore::testTriangle<Kz>(
        {mesh.vertices[t.v[0]], mesh.vertices[t.v[1]], mesh.vertices[t.v[2]], index}, ray, shear, hit,
        rtcore::noiseByCorners);
}

} // namespace test
