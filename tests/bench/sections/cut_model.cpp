#include "bench/sections/cut_model.h"

#include "rtcore/kernels/section_clip.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace rtbench {

namespace {

using namespace rtcore;

/// Indices of a corner's position and of its shading.
struct Corner {
    std::uint32_t position, shading;
};

template <typename T>
std::vector<T> listOf(std::span<const T> span) {
    return {span.begin(), span.end()};
}

class Cutter {
  public:
    Cutter(const Model& model, const SectionPlane& plane) : model_(model), normal_(normalize(plane.normal)) {
        const Mesh& mesh = model.mesh;
        offset_ = dot(normal_, plane.point) + roundingOf(mesh.bounds());
        out_.vertices = listOf(mesh.vertices);
        out_.normals = listOf(mesh.normals);
        out_.texcoords = listOf(mesh.texcoords);
        out_.colours = listOf(mesh.colours);
        out_.alphas = listOf(mesh.alphas);
        out_.furtherTexcoords = listOf(mesh.furtherTexcoords);
        out_.parts = listOf(model.parts);
    }

    Model cut() {
        const auto count = static_cast<std::uint32_t>(model_.mesh.triangles.size());
        std::vector<std::uint32_t> first;
        for (std::uint32_t i = 0; i < count; ++i) {
            first.push_back(static_cast<std::uint32_t>(out_.triangles.size()));
            addLeft(i);
        }
        first.push_back(static_cast<std::uint32_t>(out_.triangles.size()));
        for (ModelPart& part : out_.parts) {
            const std::uint32_t begin = first[part.firstTriangle],
                                end = first[part.firstTriangle + part.triangleCount];
            part.firstTriangle = begin;
            part.triangleCount = end - begin;
        }
        out_.materials = listOf(model_.materials);
        Model made = makeModel(std::move(out_));
        made.textures = model_.textures;
        made.texels = model_.texels;
        made.blocks = model_.blocks;
        made.strings = model_.strings;
        return made;
    }

  private:
    float above(std::uint32_t position) const {
        return dot(normal_, out_.vertices[position].position()) - offset_;
    }

    void addLeft(std::uint32_t triangle) {
        const Triangle& corners = model_.mesh.triangles[triangle];
        const ShadingTriangle& shading = model_.mesh.shading[triangle];
        std::vector<Corner> kept;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            const Corner from{corners.v[i], shading.v[i]}, to{corners.v[next], shading.v[next]};
            const float a = above(from.position), b = above(to.position);
            if (a <= 0) kept.push_back(from);
            if ((a < 0 && b > 0) || (a > 0 && b < 0)) kept.push_back(between(from, to, a / (a - b)));
        }
        for (std::size_t i = 2; i < kept.size(); ++i) {
            const std::array<Corner, 3> c{kept[0], kept[i - 1], kept[i]};
            out_.triangles.push_back({{c[0].position, c[1].position, c[2].position}});
            out_.shading.push_back({{c[0].shading, c[1].shading, c[2].shading}, shading.material});
        }
    }

    template <typename T>
    static T mixed(const T& from, const T& to, float part) {
        return from * (1 - part) + to * part;
    }
    static Vec2 mixed(const Vec2& from, const Vec2& to, float part) {
        return {mixed(from.x, to.x, part), mixed(from.y, to.y, part)};
    }
    template <typename T>
    static void mix(std::vector<T>& list, std::size_t from, std::size_t to, float part) {
        if (!list.empty()) list.push_back(mixed(list[from], list[to], part));
    }

    Corner between(const Corner& from, const Corner& to, float part) {
        const Corner made{static_cast<std::uint32_t>(out_.vertices.size()),
                          static_cast<std::uint32_t>(out_.normals.size())};
        const Vec3 a = out_.vertices[from.position].position(), b = out_.vertices[to.position].position();
        const Vec3 position = a + (b - a) * part;
        out_.vertices.push_back({position.x, position.y, position.z});
        const std::size_t sets = model_.mesh.furtherSets();
        mix(out_.normals, from.shading, to.shading, part);
        out_.normals.back() = normalize(out_.normals.back());
        mix(out_.texcoords, from.shading, to.shading, part);
        mix(out_.colours, from.shading, to.shading, part);
        mix(out_.alphas, from.shading, to.shading, part);
        for (std::size_t set = 0; set < sets; ++set)
            mix(out_.furtherTexcoords, from.shading * sets + set, to.shading * sets + set, part);
        return made;
    }

    const Model& model_;
    Vec3 normal_;
    float offset_ = 0;
    ModelBuffers out_;
};

} // namespace

Model cutModel(const Model& model, const SectionPlane& plane) { return Cutter(model, plane).cut(); }

} // namespace rtbench
