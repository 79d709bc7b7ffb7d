#include "rtcore/io/import/mesh/equal_triangles.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace rtcore {

namespace {

constexpr std::size_t kKept = 2;

class Remover {
  public:
    explicit Remover(ModelBuffers& model) : model_(model), removed_(model.triangles.size()) {}

    std::uint64_t run() {
        sortByFirstCorner();
        for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
            const auto triangles = std::span(sorted_).subspan(first_[v], first_[v + 1] - first_[v]);
            if (anyEqual(triangles)) mark(triangles);
        }
        const auto count = static_cast<std::uint64_t>(std::count(removed_.begin(), removed_.end(), 1));
        if (count > 0) compact();
        return count;
    }

  private:
    /// A counting sort: `sorted_` has the triangles of vertex v from first_[v], ascending, of vertices that
    /// have more than stay.
    void sortByFirstCorner() {
        const auto& triangles = model_.triangles;
        first_.assign(model_.vertices.size() + 1, 0);
        for (const Triangle& t : triangles) ++first_[t.v[0] + 1];
        std::uint32_t end = 0;
        for (std::size_t v = 1; v < first_.size(); ++v) first_[v] = end += first_[v] > kKept ? first_[v] : 0;
        std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
        sorted_.resize(end);
        for (std::uint32_t t = 0; t < triangles.size(); ++t) {
            const std::uint32_t v = triangles[t].v[0];
            if (first_[v + 1] > first_[v]) sorted_[at[v]++] = t;
        }
    }

    /// Mostly not, and this is sooner known than their order.
    bool anyEqual(std::span<const std::uint32_t> triangles) const {
        constexpr std::size_t kMany = 16;
        if (triangles.size() > kMany) return true;
        for (std::size_t i = 1; i < triangles.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (model_.triangles[triangles[i]] == model_.triangles[triangles[j]]) return true;
            }
        }
        return false;
    }

    /// Twice the number of parts that begin up to here, less 1 inside of the last of them.
    std::size_t partOf(std::uint32_t triangle) const {
        const auto behind =
            std::upper_bound(model_.parts.begin(), model_.parts.end(), triangle,
                             [](std::uint32_t t, const ModelPart& part) { return t < part.firstTriangle; });
        const auto begun = static_cast<std::size_t>(behind - model_.parts.begin());
        if (begun == 0) return 0;
        const ModelPart& part = model_.parts[begun - 1];
        return 2 * begun - (triangle - part.firstTriangle < part.triangleCount ? 1 : 0);
    }

    auto keyOf(std::uint32_t t) const {
        const Triangle& triangle = model_.triangles[t];
        return std::tuple(triangle.v[1], triangle.v[2], model_.shading[t].material, partOf(t));
    }

    void mark(std::span<std::uint32_t> triangles) {
        std::stable_sort(triangles.begin(), triangles.end(),
                         [this](std::uint32_t a, std::uint32_t b) { return keyOf(a) < keyOf(b); });
        std::size_t run = 0; // where the equal ones begin
        for (std::size_t i = 1; i < triangles.size(); ++i) {
            if (keyOf(triangles[i]) != keyOf(triangles[run])) run = i;
            if (i - run >= kKept) removed_[triangles[i]] = 1;
        }
    }

    void compact() {
        std::vector<std::uint32_t> before(removed_.size() + 1); // how many stay before each
        std::uint32_t kept = 0;
        for (std::size_t t = 0; t < removed_.size(); ++t) {
            before[t] = kept;
            if (removed_[t] != 0) continue;
            model_.triangles[kept] = model_.triangles[t];
            model_.shading[kept] = model_.shading[t];
            ++kept;
        }
        before.back() = kept;
        model_.triangles.resize(kept);
        model_.shading.resize(kept);
        for (ModelPart& part : model_.parts) {
            const std::uint32_t end = before[part.firstTriangle + part.triangleCount];
            part.firstTriangle = before[part.firstTriangle];
            part.triangleCount = end - part.firstTriangle;
        }
    }

    ModelBuffers& model_;
    std::vector<char> removed_;
    std::vector<std::uint32_t> first_, sorted_;
};

} // namespace

std::uint64_t removeEqualTriangles(ModelBuffers& model) { return Remover(model).run(); }

} // namespace rtcore
