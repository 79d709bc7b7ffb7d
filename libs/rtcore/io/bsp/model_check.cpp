#include "rtcore/io/bsp/model_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

using Finding = std::optional<Sentence>;

/// Elements: fewer are looked through sooner than a thread wakes up on a busy machine.
constexpr std::size_t kWorthThreads = 4'000'000;

/// No branch and no early end, so that the compiler makes vector code of it.
bool allWithin(std::span<const float> values, float lo, float hi) {
    unsigned bad = 0;
#pragma omp parallel for schedule(static) reduction(| : bad) if (values.size() > kWorthThreads)
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool good =
            static_cast<int>(values[i] >= lo) & static_cast<int>(values[i] <= hi); // false for NaN
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
    return say("{0}: a number of element {1} is not a number or out of range", std::string_view(section),
               element);
}

bool isNormal(Vec3 normal) { return std::fabs(dot(normal, normal) - 1) < 1e-3F || normal == Vec3{}; }

Finding checkNormals(std::span<const Vec3> normals) {
    unsigned bad = 0;
#pragma omp parallel for schedule(static) reduction(| : bad) if (normals.size() > kWorthThreads)
    for (std::size_t i = 0; i < normals.size(); ++i) bad |= isNormal(normals[i]) ? 0 : 1;
    if (bad == 0) return {};
    const auto at = std::find_if_not(normals.begin(), normals.end(), isNormal);
    return say("normals: element {0} is not of unit length", at - normals.begin());
}

bool indicesBelow(std::span<const Triangle> triangles, std::size_t limit) {
    std::uint32_t largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest) if (triangles.size() > kWorthThreads)
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const std::uint32_t i : triangles[t].v) largest = std::max(largest, i);
    }
    return triangles.empty() || largest < limit;
}

bool indicesBelow(std::span<const ShadingTriangle> triangles, std::size_t normals, std::size_t materials) {
    std::uint32_t largest = 0, largestMaterial = 0;
#pragma omp parallel for schedule(static)                                                                    \
    reduction(max                                                                                            \
              : largest, largestMaterial) if (triangles.size() > kWorthThreads)
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const std::uint32_t i : triangles[t].v) largest = std::max(largest, i);
        largestMaterial = std::max(largestMaterial, triangles[t].material);
    }
    return triangles.empty() || (largest < normals && largestMaterial < materials);
}

Finding checkSizes(const Model& model) {
    const Mesh& mesh = model.mesh;
    constexpr std::size_t limit = std::numeric_limits<std::uint32_t>::max();
    for (const std::size_t size : {mesh.vertices.size(), mesh.triangles.size(), mesh.normals.size(),
                                   model.materials.size(), model.textures.size(), model.strings.size()}) {
        if (size >= limit) return form("sizes: a section has more than 2^32 elements");
    }
    if (mesh.shading.size() != mesh.triangles.size())
        return form("shading: there must be one element per triangle");
    if (!mesh.texcoords.empty() && mesh.texcoords.size() != mesh.normals.size()) {
        return form("texcoords: there must be none or one per normal");
    }
    if (!mesh.colours.empty() && mesh.colours.size() != mesh.normals.size()) {
        return form("colours: there must be none or one per normal");
    }
    if (!mesh.alphas.empty() && mesh.alphas.size() != mesh.normals.size()) {
        return form("alphas: there must be none or one per normal");
    }
    const std::size_t further = mesh.furtherTexcoords.size();
    if (further > 0 &&
        (mesh.texcoords.empty() || mesh.furtherSets() == 0 || mesh.furtherSets() > kMaxFurtherSets ||
         further != mesh.furtherSets() * mesh.normals.size())) {
        return form("texcoordsets: there must be none or as many for each normal");
    }
    if (model.materials.empty()) return form("materials: there must be at least one");
    return {};
}

Finding checkParts(const Model& model) {
    std::uint64_t end = 0;
    for (const ModelPart& part : model.parts) {
        if (part.nameOffset >= model.strings.size()) return form("parts: a name lies outside of the strings");
        if (part.firstTriangle < end) return form("parts: two overlap, or they do not ascend");
        end = std::uint64_t{part.firstTriangle} + part.triangleCount;
        if (end > model.mesh.triangles.size()) return form("parts: one names a triangle that does not exist");
    }
    return {};
}

Finding checkStrings(std::span<const char> strings) {
    if (strings.empty() || strings.front() != 0) return form("strings: the first name must be empty");
    if (strings.back() != 0) return form("strings: the last name does not end");
    return {};
}

Finding checkMesh(const Model& model) {
    const Mesh& mesh = model.mesh;
    if (!indicesBelow(mesh.triangles, mesh.vertices.size()))
        return form("triangles: one names a vertex that does not exist");
    if (!indicesBelow(mesh.shading, mesh.normals.size(), model.materials.size())) {
        return form("shading: an element names a normal or a material that does not exist");
    }
    constexpr float max = kLargestNumber;
    if (Finding f = checkNumbers("vertices", floatsOf(mesh.vertices), 4, -max, max)) return f;
    if (Finding f = checkNumbers("texcoords", floatsOf(mesh.texcoords), 2, -max, max)) return f;
    if (Finding f = checkNumbers("texcoordsets", floatsOf(mesh.furtherTexcoords), 2, -max, max)) return f;
    if (Finding f = checkNumbers("colours", floatsOf(mesh.colours), 3, 0, max)) return f;
    if (Finding f = checkNumbers("alphas", floatsOf(mesh.alphas), 1, 0, 1)) return f;
    return checkNormals(mesh.normals);
}

} // namespace

std::optional<Sentence> checkModel(const Model& model) {
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
