#include "rtcore/io/import/gltf/triangles.h"

#include <algorithm>
#include <utility>

namespace rtcore::gltf {

namespace {

bool isConnected(const Triangle& t, std::uint64_t vertices) {
    return t.v[0] < vertices && t.v[1] < vertices && t.v[2] < vertices;
}

/// `corner(i)`: the number of the i-th vertex.
template <typename Corner>
TriangleList listOf(Mode mode, std::uint64_t corners, std::uint64_t vertices, Corner corner) {
    TriangleList list;
    const std::uint64_t faces = facesOf(mode, corners);
    if (mode != Mode::Triangles && mode != Mode::TriangleStrip && mode != Mode::TriangleFan) {
        list.pointsAndLines = faces;
        return list;
    }
    list.triangles.reserve(faces);
    const auto add = [&](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
        const Triangle t{{corner(a), corner(b), corner(c)}};
        if (isConnected(t, vertices)) {
            list.triangles.push_back(t);
        } else {
            ++list.unconnected;
        }
    };
    for (std::uint64_t i = 0; i < faces; ++i) {
        if (mode == Mode::Triangles) {
            add(3 * i, 3 * i + 1, 3 * i + 2);
        } else if (mode == Mode::TriangleFan) {
            add(0, i + 1, i + 2);
        } else if (i % 2 == 0) {
            add(i, i + 1, i + 2);
        } else {
            add(i + 1, i, i + 2);
        }
    }
    return list;
}

} // namespace

Mode modeOf(const Json& primitive) {
    const Json& stated = member(primitive, "mode");
    if (stated.is_null()) return Mode::Triangles;
    const auto mode = wholeNumber(stated);
    return mode && *mode <= 6 ? static_cast<Mode>(*mode) : Mode::Points;
}

std::uint64_t facesOf(Mode mode, std::uint64_t corners) {
    switch (mode) {
    case Mode::Points:
        break;
    case Mode::Lines:
        return corners / 2;
    case Mode::LineLoop:
        return corners > 1 ? corners : 0;
    case Mode::LineStrip:
        return corners > 1 ? corners - 1 : 0;
    case Mode::Triangles:
        return corners / 3;
    case Mode::TriangleStrip:
    case Mode::TriangleFan:
        return corners > 2 ? corners - 2 : 0;
    }
    return corners;
}

TriangleList trianglesOf(Mode mode, std::span<const std::uint32_t> corners, std::uint64_t vertices) {
    return listOf(mode, corners.size(), vertices, [&](std::uint64_t i) { return corners[i]; });
}

TriangleList trianglesOf(Mode mode, std::uint64_t vertices) {
    return listOf(mode, vertices, vertices, [](std::uint64_t i) { return static_cast<std::uint32_t>(i); });
}

TriangleList connected(std::vector<Triangle> triangles, std::uint64_t vertices) {
    const bool all =
        std::ranges::all_of(triangles, [&](const Triangle& t) { return isConnected(t, vertices); });
    const std::uint64_t unconnected =
        all ? 0 : std::erase_if(triangles, [&](const Triangle& t) { return !isConnected(t, vertices); });
    return {std::move(triangles), unconnected, 0};
}

} // namespace rtcore::gltf
