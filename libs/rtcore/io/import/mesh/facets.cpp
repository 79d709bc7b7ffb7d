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

/// Of up to `lanes()` triangles, the last of which fills up.
HWY_INLINE Columns cornersOf(const Vertex* vertices, const Triangle* triangles, std::size_t count) {
    Columns corners;
    for (std::size_t i = 0; i < lanes(); ++i) {
        const Triangle& t = triangles[std::min(i, count - 1)];
        for (int corner = 0; corner < 3; ++corner) {
            const Vertex& v = vertices[t.v[corner]];
            corners.numbers[3 * corner][i] = v.x;
            corners.numbers[3 * corner + 1][i] = v.y;
            corners.numbers[3 * corner + 2][i] = v.z;
        }
    }
    return corners;
}

/// Unit vectors along the edges of as many triangles as there are lanes.
struct Edges {
    HWY_INLINE explicit Edges(const Columns& corners) {
        const Float3 a = corners.vectorAt(0), b = corners.vectorAt(3), c = corners.vectorAt(6);
        ab = normalize(b - a);
        bc = normalize(c - b);
        ca = normalize(a - c);
    }
    /// The shortest cross product is the worst.
    HWY_INLINE Float3 normal() const {
        const Float3 atA = cross(ca, ab), atB = cross(ab, bc);
        return normalize(select(dot(atA, atA) > dot(atB, atB), atA, atB));
    }
    Float3 ab, bc, ca; ///< of length 1, so that the products of small ones do not vanish
};

void setNormal(Facet& facet, Vec3 normal) {
    facet.x = normal.x;
    facet.y = normal.y;
    facet.z = normal.z;
}
void setNormal(Vec3& facet, Vec3 normal) { facet = normal; }

/// The normals of up to `lanes()` triangles.
template <typename Out>
HWY_INLINE void storeNormals(const Vertex* vertices, const Triangle* triangles, std::size_t count,
                             const Edges& edges, Out* facets) {
    const Float3 normal = edges.normal();
    HWY_ALIGN float n[3][kLanes];
    store(normal, n[0], n[1], n[2]);
    for (std::size_t i = 0; i < count; ++i) setNormal(facets[i], {n[0][i], n[1][i], n[2][i]});
    if (!any(isZero(normal))) return;
    for (std::size_t i = 0; i < count; ++i) {
        if (Vec3{n[0][i], n[1][i], n[2][i]} != Vec3{}) continue;
        const auto corner = [&](int k) { return vertices[triangles[i].v[k]].position(); };
        setNormal(facets[i], carefulNormal(corner(0), corner(1), corner(2)));
    }
}

HWY_INLINE void storeAngles(std::size_t count, const Edges& edges, Facet* facets) {
    HWY_ALIGN float angles[3][kLanes];
    store(roughAcos(-dot(edges.ca, edges.ab)), angles[0]);
    store(roughAcos(-dot(edges.ab, edges.bc)), angles[1]);
    store(roughAcos(-dot(edges.bc, edges.ca)), angles[2]);
    for (std::size_t i = 0; i < count; ++i)
        for (int corner = 0; corner < 3; ++corner) facets[i].angle[corner] = angles[corner][i];
}

HWY_INLINE void storeAngles(std::size_t, const Edges&, Vec3*) {}

template <typename Out>
void measureAll(const Vertex* vertices, const Triangle* triangles, std::size_t count, Out* facets) {
    for (std::size_t first = 0; first < count; first += lanes()) {
        const std::size_t some = std::min(lanes(), count - first);
        HWY_ALIGN const Columns corners = cornersOf(vertices, triangles + first, some);
        const Edges edges(corners);
        storeNormals(vertices, triangles + first, some, edges, facets + first);
        storeAngles(some, edges, facets + first);
    }
}

void measureFacets(const Vertex* vertices, const Triangle* triangles, std::size_t count, Facet* facets) {
    measureAll(vertices, triangles, count, facets);
}

void measureNormals(const Vertex* vertices, const Triangle* triangles, std::size_t count, Vec3* normals) {
    measureAll(vertices, triangles, count, normals);
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(measureFacets);
HWY_EXPORT(measureNormals);

void measureFacets(std::span<const Vertex> vertices, std::span<const Triangle> triangles, Facet* facets) {
    HWY_DYNAMIC_DISPATCH(measureFacets)(vertices.data(), triangles.data(), triangles.size(), facets);
}

void measureNormals(std::span<const Vertex> vertices, std::span<const Triangle> triangles, Vec3* normals) {
    HWY_DYNAMIC_DISPATCH(measureNormals)(vertices.data(), triangles.data(), triangles.size(), normals);
}

} // namespace rtcore
#endif
