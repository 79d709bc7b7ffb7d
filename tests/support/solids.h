/// Models of closed and open solids, whose triangles have vertices in common.
#pragma once

#include "rtcore/math/constants.h"
#include "rtcore/scene/scene.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test {

class Solids {
  public:
    using Move = std::function<rtcore::Vec3(rtcore::Vec3)>;

    /// What is added from now on is of this part, in a material of its own of that colour.
    void begin(const std::string& name, rtcore::Colour colour) {
        endPart();
        parts_.push_back({buffers_.addName(name), static_cast<std::uint32_t>(buffers_.triangles.size()), 0});
        rtcore::Material material;
        material.diffuse = colour;
        buffers_.materials.push_back(material);
    }

    /// Its faces look outwards; inwards where it is `hollow`. `open`: without its side towards +z.
    void box(rtcore::Vec3 lo, rtcore::Vec3 hi, bool hollow = false, bool open = false,
             const Move& move = {}) {
        const std::uint32_t first = count();
        for (int i = 0; i < 8; ++i)
            vertex({(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z},
                   move);
        const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
            triangle(first + a, first + b, first + c, hollow);
            triangle(first + a, first + c, first + d, hollow);
        };
        quad(0, 2, 3, 1);
        if (!open) quad(4, 5, 7, 6);
        quad(0, 1, 5, 4);
        quad(2, 6, 7, 3);
        quad(0, 4, 6, 2);
        quad(1, 3, 7, 5);
    }

    /// A ring around the z axis: tubes of radius `r` around a circle of radius `R`.
    void ring(float R, float r, std::uint32_t around, std::uint32_t across, const Move& move = {}) {
        const std::uint32_t first = count();
        for (std::uint32_t i = 0; i < around; ++i) {
            for (std::uint32_t k = 0; k < across; ++k) {
                const float a = turn(i, around), b = turn(k, across), d = R + r * std::cos(b);
                vertex({d * std::cos(a), d * std::sin(a), r * std::sin(b)}, move);
            }
        }
        const auto at = [&](std::uint32_t i, std::uint32_t k) {
            return first + i % around * across + k % across;
        };
        for (std::uint32_t i = 0; i < around; ++i) {
            for (std::uint32_t k = 0; k < across; ++k) {
                triangle(at(i, k), at(i + 1, k), at(i + 1, k + 1), false);
                triangle(at(i, k), at(i + 1, k + 1), at(i, k + 1), false);
            }
        }
    }

    /// Equal vertices become one.
    void weld() {
        std::map<std::array<float, 3>, std::uint32_t> known;
        std::vector<std::uint32_t> numbers;
        for (const rtcore::Vertex& v : buffers_.vertices)
            numbers.push_back(
                known.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(numbers.size())).first->second);
        for (rtcore::Triangle& t : buffers_.triangles)
            for (std::uint32_t& v : t.v) v = numbers[v];
    }

    rtcore::Scene scene() {
        endPart();
        buffers_.parts = parts_;
        rtcore::Scene scene;
        scene.model = rtcore::makeModel(buffers_);
        scene.materials.assign(scene.model.materials.begin(), scene.model.materials.end());
        return scene;
    }

  private:
    static float turn(std::uint32_t i, std::uint32_t of) {
        return 2 * rtcore::kPi * static_cast<float>(i) / static_cast<float>(of);
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(buffers_.vertices.size()); }
    void vertex(rtcore::Vec3 p, const Move& move) {
        if (move) p = move(p);
        buffers_.vertices.push_back({p.x, p.y, p.z, 0});
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool hollow) {
        if (hollow) std::swap(b, c);
        buffers_.triangles.push_back({{a, b, c}});
        buffers_.shading.push_back({{0, 0, 0}, static_cast<std::uint32_t>(buffers_.materials.size() - 1)});
        if (buffers_.normals.empty()) buffers_.normals.push_back({0, 0, 1});
    }
    void endPart() {
        if (!parts_.empty())
            parts_.back().triangleCount =
                static_cast<std::uint32_t>(buffers_.triangles.size()) - parts_.back().firstTriangle;
    }

    rtcore::ModelBuffers buffers_;
    std::vector<rtcore::ModelPart> parts_;
};

/// Turns around an axis, then shifts.
inline Solids::Move turned(rtcore::Vec3 axis, float degrees, rtcore::Vec3 shift = {}) {
    const rtcore::Vec3 k = normalize(axis);
    const float a = degrees * rtcore::kPi / 180;
    return [=](rtcore::Vec3 p) {
        return p * std::cos(a) + cross(k, p) * std::sin(a) + k * (dot(k, p) * (1 - std::cos(a))) + shift;
    };
}

} // namespace test
