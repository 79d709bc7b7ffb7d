#include "rtcore/io/bsp/model_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

using Finding = std::optional<std::string>;

/// No branch and no early end, so that the compiler makes vector code of it.
bool allWithin(std::span<const float> values, float lo, float hi) {
    unsigned bad = 0;
    for (const float v : values) {
        const bool good = static_cast<int>(v >= lo) & static_cast<int>(v <= hi); // false for NaN
        bad |= static_cast<unsigned>(!good);
    }
    return bad == 0;
}

template <typename T>
std::span<const float> floatsOf(std::span<const T> elements) {
    static_assert(sizeof(T) % sizeof(float) == 0 && alignof(T) >= alignof(float));
    return {reinterpret_cast<const float*>(elements.data()), elements.size() * (sizeof(T) / sizeof(float))};
}

Finding checkNumbers(const char* section, std::span<const float> values, std::size_t perElement, float lo,
                     float hi) {
    if (allWithin(values, lo, hi)) return {};
    const auto bad =
        std::find_if(values.begin(), values.end(), [&](float v) { return !(v >= lo && v <= hi); });
    const auto element = static_cast<std::size_t>(bad - values.begin()) / perElement;
    return fmt::format("{}: a number of element {} is not a number or out of range", section, element);
}

Finding checkNormals(std::span<const Vec3> normals) {
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const float square = dot(normals[i], normals[i]);
        if (!(std::fabs(square - 1) < 1e-3F) && normals[i] != Vec3{}) {
            return fmt::format("normals: element {} is not of unit length", i);
        }
    }
    return {};
}

bool indicesBelow(std::span<const Triangle> triangles, std::size_t limit) {
    std::uint32_t largest = 0;
    for (const Triangle& t : triangles) {
        for (const std::uint32_t i : t.v) largest = std::max(largest, i);
    }
    return triangles.empty() || largest < limit;
}

bool indicesBelow(std::span<const ShadingTriangle> triangles, std::size_t normals, std::size_t materials) {
    std::uint32_t largest = 0, largestMaterial = 0;
    for (const ShadingTriangle& t : triangles) {
        for (const std::uint32_t i : t.v) largest = std::max(largest, i);
        largestMaterial = std::max(largestMaterial, t.material);
    }
    return triangles.empty() || (largest < normals && largestMaterial < materials);
}

Finding checkSizes(const Model& model) {
    const Mesh& mesh = model.mesh;
    constexpr std::size_t limit = std::numeric_limits<std::uint32_t>::max();
    for (const std::size_t size : {mesh.vertices.size(), mesh.triangles.size(), mesh.normals.size(),
                                   model.materials.size(), model.textures.size(), model.strings.size()}) {
        if (size >= limit) return "sizes: a section has more than 2^32 elements";
    }
    if (mesh.shading.size() != mesh.triangles.size())
        return "shading: there must be one element per triangle";
    if (!mesh.texcoords.empty() && mesh.texcoords.size() != mesh.normals.size()) {
        return "texcoords: there must be none or one per normal";
    }
    if (!mesh.colours.empty() && mesh.colours.size() != mesh.normals.size()) {
        return "colours: there must be none or one per normal";
    }
    if (model.materials.empty()) return "materials: there must be at least one";
    return {};
}

Finding checkParts(const Model& model) {
    std::uint64_t end = 0;
    for (const ModelPart& part : model.parts) {
        if (part.nameOffset >= model.strings.size()) return "parts: a name lies outside of the strings";
        if (part.firstTriangle < end) return "parts: two overlap, or they do not ascend";
        end = std::uint64_t{part.firstTriangle} + part.triangleCount;
        if (end > model.mesh.triangles.size()) return "parts: one names a triangle that does not exist";
    }
    return {};
}

Finding checkStrings(std::span<const char> strings) {
    if (strings.empty() || strings.front() != 0) return "strings: the first name must be empty";
    if (strings.back() != 0) return "strings: the last name does not end";
    return {};
}

Finding checkMesh(const Model& model) {
    const Mesh& mesh = model.mesh;
    if (!indicesBelow(mesh.triangles, mesh.vertices.size()))
        return "triangles: one names a vertex that does not exist";
    if (!indicesBelow(mesh.shading, mesh.normals.size(), model.materials.size())) {
        return "shading: an element names a normal or a material that does not exist";
    }
    constexpr float most = kLargestNumber;
    if (Finding f = checkNumbers("vertices", floatsOf(mesh.vertices), 4, -most, most)) return f;
    if (Finding f = checkNumbers("texcoords", floatsOf(mesh.texcoords), 2, -most, most)) return f;
    if (Finding f = checkNumbers("colours", floatsOf(mesh.colours), 3, 0, most)) return f;
    return checkNormals(mesh.normals);
}

} // namespace

std::optional<std::string> checkModel(const Model& model) {
    if (Finding f = checkSizes(model)) return f;
    if (Finding f = checkStrings(model.strings)) return f;
    if (Finding f = checkMesh(model)) return f;
    if (Finding f = checkParts(model)) return f;
    if (Finding f = checkMaterials(model)) return f;
    if (Finding f = checkTextures(model)) return f;
    if (Finding f = checkLights(model)) return f;
    return checkCameras(model);
}

} // namespace rtcore
