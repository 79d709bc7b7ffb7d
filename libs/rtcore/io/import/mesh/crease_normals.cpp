#include "rtcore/io/import/mesh/crease_normals.h"

#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/io/import/mesh/facets.h"
#include "rtcore/math/constants.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/platform/threads.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>

namespace rtcore {

namespace {

struct VertexRange {
    std::uint32_t first, last;
};

VertexRange verticesOf(std::span<const Triangle> triangles) {
    VertexRange range{0xFFFFFFFFU, 0};
    for (const Triangle& t : triangles) {
        range.first = std::min({range.first, t.v[0], t.v[1], t.v[2]});
        range.last = std::max({range.last, t.v[0], t.v[1], t.v[2]});
    }
    return range;
}

bool sameNumbers(const Triangle& a, const ShadingTriangle& b) {
    return a.v[0] == b.v[0] && a.v[1] == b.v[1] && a.v[2] == b.v[2];
}

class Smoother {
  public:
    Smoother(ModelBuffers& model, float creaseAngle)
        : model_(model),
          furtherSets_(model.normals.empty() ? 0 : model.furtherTexcoords.size() / model.normals.size()),
          flat_(creaseAngle <= 0), cosCrease_(cosine(creaseAngle) - kSlack),
          cosHalf_(cosine(creaseAngle / 2) + kSlack) {}

    void run() {
        if (flat_ && model_.normals.empty()) return giveEachItsOwn();
        const auto missing = [](const Vec3& normal) { return normal == Vec3{}; };
        if (std::none_of(model_.normals.begin(), model_.normals.end(), missing)) return;
        allLack_ = std::all_of(model_.normals.begin(), model_.normals.end(), missing);
        if (flat_ && allLack_ && isPlain()) return giveEachItsOwn();
        sharp_.assign(model_.vertices.size(), flat_ ? 1 : 0);
        measure();
        if (!flat_) smoothWhatIsRound();
        if (std::find(sharp_.begin(), sharp_.end(), 1) == sharp_.end()) return;
        collectSharpCorners();
        for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
            const std::span<const std::uint32_t> corners(corners_.data() + first_[v],
                                                         first_[v + 1] - first_[v]);
            if (!corners.empty()) smoothSharp(corners);
        }
    }

  private:
    /// Rounding of a dot product of normals: triangles of one plane stay together whatever the crease angle.
    static constexpr float kSlack = 1e-5F;
    static constexpr std::size_t kExact = 64;    ///< more triangles at a vertex are put into clusters instead
    static constexpr std::size_t kSearched = 64; ///< entries looked through for one that can be shared
    static constexpr std::size_t kBlock = 4096;  ///< of triangles

    bool isPlain() const {
        return model_.texcoords.empty() && model_.colours.empty() && model_.alphas.empty();
    }

    /// One entry for each triangle.
    void giveEachItsOwn() {
        model_.normals.clear();
        resizeLarge(model_.normals, model_.triangles.size());
        blocks_.resize((model_.triangles.size() + kBlock - 1) / kBlock);
#pragma omp parallel for schedule(static)
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            const std::size_t first = block * kBlock;
            const auto own = std::span<const Triangle>(model_.triangles).subspan(first, endOf(block) - first);
            measureNormals(model_.vertices, own, model_.normals.data() + first);
            for (std::size_t i = 0; i < own.size(); ++i) {
                const auto entry = static_cast<std::uint32_t>(first + i);
                model_.normals[entry] = normalize(model_.normals[entry]);
                for (std::uint32_t& v : model_.shading[entry].v) v = entry;
            }
        }
    }

    static float cosine(float degrees) {
        return portableCos(std::clamp(degrees, 0.0F, 180.0F) * (kPi / 180));
    }
    std::uint32_t& entryOf(std::uint32_t corner) { return model_.shading[corner / 3].v[corner % 3]; }
    const Facet& facetOfCorner(std::uint32_t corner) const { return facets_.data()[corner / 3]; }
    Vec3 facetNormal(std::uint32_t corner) const { return facetOfCorner(corner).normal(); }
    Vec3 weighted(std::uint32_t corner) const { return facetOfCorner(corner).weighted(corner % 3); }
    bool lacks(std::uint32_t corner) const {
        return allLack_ || model_.normals[model_.shading[corner / 3].v[corner % 3]] == Vec3{};
    }

    /// Calls `use` for each triangle and corner that lacks a normal at one of the vertices [first, end),
    /// ascending.
    template <typename Use>
    void forEachCorner(std::size_t first, std::size_t end, const Use& use) {
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            if (blocks_[block].last < first || blocks_[block].first >= end) continue;
            const auto from = static_cast<std::uint32_t>(block * kBlock);
            for (std::uint32_t t = from; t < endOf(block); ++t) {
                for (std::uint32_t i = 0; i < 3; ++i) {
                    const std::uint32_t v = model_.triangles[t].v[i];
                    if (v - first < end - first && lacks(3 * t + i)) use(t, i, v);
                }
            }
        }
    }
    std::size_t endOf(std::size_t block) const {
        return std::min(model_.triangles.size(), (block + 1) * kBlock);
    }

    /// The vertices in as many ranges as there are threads: sums of normals depend on their order, so that a
    /// vertex is the work of one thread. They go through the same triangles where their vertices come.
    template <typename Work>
    void forEachRange(const Work& work) {
        const std::size_t count = model_.vertices.size();
        constexpr std::size_t kWorthThreads = 20'000;
        const auto ranges = static_cast<std::size_t>(count > kWorthThreads ? threadsFor(0) : 1);
#pragma omp parallel for schedule(static, 1)
        for (std::size_t r = 0; r < ranges; ++r) work(count * r / ranges, count * (r + 1) / ranges);
    }

    void measure() {
        facets_ = UninitializedArray<Facet>(model_.triangles.size());
        blocks_.resize((model_.triangles.size() + kBlock - 1) / kBlock);
        bool same = allLack_;
#pragma omp parallel for schedule(static) reduction(&& : same)
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            const std::size_t first = block * kBlock;
            const auto own = std::span<const Triangle>(model_.triangles).subspan(first, endOf(block) - first);
            measureFacets(model_.vertices, own, facets_.data() + first);
            blocks_[block] = verticesOf(own);
            for (std::size_t t = first; same && t < endOf(block); ++t)
                same = sameNumbers(model_.triangles[t], model_.shading[t]);
        }
        entriesAreVertices_ = same;
    }

    /// Vertices whose triangles are all within half the angle of their mean: then all are within the angle of
    /// each other. The others are sharp.
    void smoothWhatIsRound() {
        std::vector<Vec3> means;
        resizeLarge(means, model_.vertices.size());
        forEachRange([&](std::size_t first, std::size_t end) {
            const Facet* const facets = facets_.data();
            forEachCorner(first, end, [&](std::uint32_t t, std::uint32_t i, std::uint32_t v) {
                means[v] += facets[t].weighted(i);
            });
            for (std::size_t v = first; v < end; ++v) means[v] = normalize(means[v]);
            forEachCorner(first, end, [&](std::uint32_t t, std::uint32_t, std::uint32_t v) {
                if (!(dot(facets[t].normal(), means[v]) >= cosHalf_)) sharp_[v] = 1;
            });
            for (std::size_t v = first; v < end; ++v) means[v] = normalize(means[v]);
            if (entriesAreVertices_) {
                for (std::size_t v = first; v < end; ++v) {
                    if (sharp_[v] == 0) model_.normals[v] = means[v];
                }
                return;
            }
            forEachCorner(first, end, [&](std::uint32_t t, std::uint32_t i, std::uint32_t v) {
                if (sharp_[v] == 0) model_.normals[model_.shading[t].v[i]] = means[v];
            });
        });
    }

    /// Corners without a normal at sharp vertices, sorted by vertex (a counting sort).
    void collectSharpCorners() {
        first_.assign(model_.vertices.size() + 1, 0);
        const auto forEachSharp = [this](const auto& use) {
            forEachCorner(0, model_.vertices.size(), [&](std::uint32_t t, std::uint32_t i, std::uint32_t v) {
                if (sharp_[v] != 0) use(3 * t + i, v);
            });
        };
        forEachSharp([&](std::uint32_t, std::uint32_t v) { ++first_[v + 1]; });
        for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
        corners_.resize(first_.back());
        std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
        forEachSharp([&](std::uint32_t corner, std::uint32_t v) { corners_[at[v]++] = corner; });
    }

    void smoothSharp(std::span<const std::uint32_t> corners) {
        added_.clear();
        if (flat_) {
            for (const std::uint32_t c : corners) assign(c, facetNormal(c));
        } else if (corners.size() <= kExact) {
            smoothByNeighbours(corners);
        } else {
            smoothByClusters(corners);
        }
    }

    void smoothByNeighbours(std::span<const std::uint32_t> corners) {
        for (const std::uint32_t c : corners) {
            Vec3 sum;
            for (const std::uint32_t d : corners) {
                if (d == c || dot(facetNormal(c), facetNormal(d)) >= cosCrease_) sum += weighted(d);
            }
            assign(c, sum);
        }
    }

    /// A cluster is what is within the angle of its first triangle: time stays linear for the tip of a cone
    /// of a million triangles.
    void smoothByClusters(std::span<const std::uint32_t> corners) {
        struct Cluster {
            Vec3 axis, sum;
        };
        std::vector<Cluster> clusters;
        std::vector<std::size_t> home(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec3 n = facetNormal(corners[i]);
            const auto near = std::find_if(clusters.begin(), clusters.end(),
                                           [&](const Cluster& k) { return dot(k.axis, n) >= cosCrease_; });
            home[i] = static_cast<std::size_t>(near - clusters.begin());
            if (near == clusters.end() && clusters.size() < kExact) clusters.push_back({n, {}});
            if (home[i] < clusters.size()) clusters[home[i]].sum += weighted(corners[i]);
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            assign(corners[i], home[i] < clusters.size() ? clusters[home[i]].sum : facetNormal(corners[i]));
        }
    }

    /// Points the corner at an entry with this normal (any length) and its own other attributes.
    void assign(std::uint32_t corner, Vec3 direction) {
        Vec3 normal = normalize(direction);
        if (normal == Vec3{}) normal = facetNormal(corner);
        std::uint32_t& entry = entryOf(corner);
        if (model_.normals[entry] == Vec3{}) model_.normals[entry] = normal;
        if (model_.normals[entry] == normal) return;
        const std::size_t from = added_.size() > kSearched ? added_.size() - kSearched : 0;
        for (std::size_t i = added_.size(); i-- > from;) {
            if (added_[i].original == entry && model_.normals[added_[i].entry] == normal) {
                entry = added_[i].entry;
                return;
            }
        }
        added_.push_back({entry, static_cast<std::uint32_t>(model_.normals.size())});
        model_.normals.push_back(normal);
        if (!model_.texcoords.empty()) model_.texcoords.push_back(Vec2(model_.texcoords[entry]));
        if (!model_.colours.empty()) model_.colours.push_back(Colour(model_.colours[entry]));
        if (!model_.alphas.empty()) model_.alphas.push_back(float{model_.alphas[entry]});
        for (std::size_t set = 0; set < furtherSets_; ++set)
            model_.furtherTexcoords.push_back(Vec2(model_.furtherTexcoords[entry * furtherSets_ + set]));
        entry = added_.back().entry;
    }

    struct Added {
        std::uint32_t original, entry;
    };

    ModelBuffers& model_;
    std::size_t furtherSets_; ///< of texture coordinates
    bool flat_;               ///< nothing is smoothed, not even what rounding leaves of one plane
    float cosCrease_, cosHalf_;
    bool allLack_ = false;            ///< no corner has a normal
    bool entriesAreVertices_ = false; ///< and all have the numbers of their vertices
    UninitializedArray<Facet> facets_;
    std::vector<VertexRange> blocks_;            ///< vertices of each block of triangles
    std::vector<std::uint8_t> sharp_;            ///< by vertex
    std::vector<std::uint32_t> first_, corners_; ///< at sharp vertices; corner = 3 * triangle + 0..2
    std::vector<Added> added_;                   ///< entries added at this vertex
};

} // namespace

void computeMissingNormals(ModelBuffers& model, float creaseAngle) {
    if (model.normals.empty() && creaseAngle > 0) resizeLarge(model.normals, model.vertices.size());
    Smoother(model, creaseAngle).run();
}

} // namespace rtcore
