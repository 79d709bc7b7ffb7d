#include "rtcore/io/import/mesh/facets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/io/import/mesh/facets.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/constants.h"
#include "rtcore/math/float3-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// acos within 7e-5 (Abramowitz and Stegun 4.4.45): enough for a weight, and there are three in every
/// triangle.
HWY_INLINE Float roughAcos(Float x) {
    const Float a = min(abs(x), 1.0F);
    const Float r = sqrt(1.0F - a) * (1.5707288F + a * (-0.2121144F + a * (0.0742610F + a * -0.0187293F)));
    return select(x < 0.0F, kPi - r, r);
}

/// For slivers whose area is lost in float.
Vec3 carefulNormal(Vec3 a, Vec3 b, Vec3 c) {
    const double ux = double{b.x} - a.x, uy = double{b.y} - a.y, uz = double{b.z} - a.z;
    const double vx = double{c.x} - a.x, vy = double{c.y} - a.y, vz = double{c.z} - a.z;
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double largest = std::fmax(std::fabs(nx), std::fmax(std::fabs(ny), std::fabs(nz)));
    if (!(largest > 0)) return {};
    return rtcore::normalize(Vec3{static_cast<float>(nx / largest), static_cast<float>(ny / largest),
                                  static_cast<float>(nz / largest)});
}

/// Numbers of as many triangles as there are lanes.
struct Columns {
    float numbers[9][kLanes];

    HWY_INLINE Float3 vectorAt(int first) const {
        return load(numbers[first], numbers[first + 1], numbers[first + 2]);
    }
};

/// Up to `lanes()` triangles.
void measureSome(const Vertex* vertices, const Triangle* triangles, std::size_t count, Facet* facets) {
    HWY_ALIGN Columns corners;
    for (std::size_t i = 0; i < lanes(); ++i) {
        const Triangle& t = triangles[std::min(i, count - 1)];
        for (int corner = 0; corner < 3; ++corner) {
            const Vertex& v = vertices[t.v[corner]];
            corners.numbers[3 * corner][i] = v.x;
            corners.numbers[3 * corner + 1][i] = v.y;
            corners.numbers[3 * corner + 2][i] = v.z;
        }
    }
    const Float3 a = corners.vectorAt(0), b = corners.vectorAt(3), c = corners.vectorAt(6);
    const Float3 ab = normalize(b - a), bc = normalize(c - b), ca = normalize(a - c);
    // From unit edges, so that the products of small ones do not vanish; the shortest cross product is the
    // worst.
    const Float3 atA = cross(ca, ab), atB = cross(ab, bc);
    const Float3 normal = normalize(select(dot(atA, atA) > dot(atB, atB), atA, atB));
    HWY_ALIGN Columns out;
    store(normal, out.numbers[0], out.numbers[1], out.numbers[2]);
    store(roughAcos(-dot(ca, ab)), out.numbers[3]);
    store(roughAcos(-dot(ab, bc)), out.numbers[4]);
    store(roughAcos(-dot(bc, ca)), out.numbers[5]);
    const bool careful = any(isZero(normal));
    for (std::size_t i = 0; i < count; ++i) {
        const auto& n = out.numbers;
        facets[i] = {n[0][i], n[1][i], n[2][i], {n[3][i], n[4][i], n[5][i]}};
        if (!careful || facets[i].normal() != Vec3{}) continue;
        const auto corner = [&](int k) { return vertices[triangles[i].v[k]].position(); };
        const Vec3 own = carefulNormal(corner(0), corner(1), corner(2));
        facets[i] = {own.x, own.y, own.z, {n[3][i], n[4][i], n[5][i]}};
    }
}

void measureFacets(const Vertex* vertices, const Triangle* triangles, std::size_t count, Facet* facets) {
    for (std::size_t i = 0; i < count; i += lanes())
        measureSome(vertices, triangles + i, std::min(lanes(), count - i), facets + i);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(measureFacets);

void measureFacets(std::span<const Vertex> vertices, std::span<const Triangle> triangles, Facet* facets) {
    HWY_DYNAMIC_DISPATCH(measureFacets)(vertices.data(), triangles.data(), triangles.size(), facets);
}

} // namespace rtcore
#endif
