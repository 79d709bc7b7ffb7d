#include "rtcore/io/debug/obj_sketch.h"

#include "rtcore/settings/number_text.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace rtcore {

namespace {

void addNumber(std::string& text, float number) { text.append(1, ' ').append(shortestText(number)); }

void addFace(std::string& text, std::initializer_list<std::uint64_t> corners) {
    text += 'f';
    for (const std::uint64_t corner : corners) text += fmt::format(" {}", corner);
    text += '\n';
}

} // namespace

ObjSketch::ObjSketch(std::string_view materials) { text_.append("mtllib ").append(materials).append("\n"); }

void ObjSketch::object(std::string_view name, Colour colour) {
    text_.append("o ").append(name).append("\nusemtl ").append(name).append("\n");
    materials_.append("newmtl ").append(name).append("\nillum 1\nKd");
    for (const float channel : {colour.r, colour.g, colour.b}) addNumber(materials_, channel);
    materials_ += "\n\n";
}

std::uint64_t ObjSketch::vertex(Vec3 p) {
    text_ += 'v';
    for (const float coordinate : {p.x, p.y, p.z}) addNumber(text_, coordinate);
    text_ += '\n';
    return ++vertices_;
}

void ObjSketch::bar(Vec3 from, Vec3 to, float thickness) {
    const Vec3 axis = normalize(to - from);
    if (axis == Vec3{} || !isFinite(from) || !isFinite(to)) return;
    const auto [t, b] = basisAround(axis);
    const float half = thickness * 0.5F, root = 0.8660254F;
    const std::array<Vec3, 3> around{t * half, b * (root * half) - t * (0.5F * half),
                                     b * (-root * half) - t * (0.5F * half)};
    const std::uint64_t first = vertices_ + 1;
    for (const Vec3 end : {from, to}) {
        for (const Vec3 side : around) vertex(end + side);
    }
    for (std::uint64_t i = 0; i < 3; ++i) {
        const std::uint64_t next = (i + 1) % 3;
        addFace(text_, {first + i, first + next, first + 3 + next, first + 3 + i});
    }
    addFace(text_, {first + 2, first + 1, first});
    addFace(text_, {first + 3, first + 4, first + 5});
}

void ObjSketch::edges(const Box3& box, float thickness) {
    const auto corner = [&](int i) {
        return Vec3{(i & 1) != 0 ? box.hi.x : box.lo.x, (i & 2) != 0 ? box.hi.y : box.lo.y,
                    (i & 4) != 0 ? box.hi.z : box.lo.z};
    };
    for (int i = 0; i < 8; ++i) {
        for (const int axis : {1, 2, 4}) {
            if ((i & axis) == 0) bar(corner(i), corner(i | axis), thickness);
        }
    }
}

void ObjSketch::triangle(Vec3 a, Vec3 b, Vec3 c) {
    if (!isFinite(a) || !isFinite(b) || !isFinite(c)) return;
    const std::uint64_t first = vertex(a);
    vertex(b);
    vertex(c);
    addFace(text_, {first, first + 1, first + 2});
}

void ObjSketch::octahedron(Vec3 centre, float radius) {
    if (!isFinite(centre)) return;
    const std::uint64_t first = vertices_ + 1;
    for (const Vec3 side : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}})
        vertex(centre + side * radius);
    const std::uint64_t front = vertex(centre + Vec3{0, 0, radius}),
                        back = vertex(centre - Vec3{0, 0, radius});
    for (std::uint64_t i = 0; i < 4; ++i) {
        const std::uint64_t next = (i + 1) % 4;
        addFace(text_, {first + i, first + next, front});
        addFace(text_, {first + next, first + i, back});
    }
}

} // namespace rtcore
