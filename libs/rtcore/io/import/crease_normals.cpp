#include "rtcore/io/import/crease_normals.h"

#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/math/constants.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/platform/threads.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>

namespace rtcore {

namespace {

/// acos within 7e-5 (Abramowitz and Stegun 4.4.45): enough for a weight, and there are three in every
/// triangle.
float roughAcos(float x) {
    const float a = std::min(std::fabs(x), 1.0F);
    const float r = std::sqrt(1 - a) * (1.5707288F + a * (-0.2121144F + a * (0.0742610F + a * -0.0187293F)));
    return x < 0 ? kPi - r : r;
}

/// For slivers whose area is lost in float.
Vec3 carefulNormal(Vec3 a, Vec3 b, Vec3 c) {
    const double ux = double{b.x} - a.x, uy = double{b.y} - a.y, uz = double{b.z} - a.z;
    const double vx = double{c.x} - a.x, vy = double{c.y} - a.y, vz = double{c.z} - a.z;
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double largest = std::fmax(std::fabs(nx), std::fmax(std::fabs(ny), std::fabs(nz)));
    if (!(largest > 0)) return {};
    return normalize({static_cast<float>(nx / largest), static_cast<float>(ny / largest),
                      static_cast<float>(nz / largest)});
}

/// Normal and corner angles of one triangle. Without initial values, so that a list of them costs nothing
/// until it is written.
struct Facet {
    float x, y, z;
    float angle[3];

    Vec3 normal() const { return {x, y, z}; }
    Vec3 weighted(std::uint32_t corner) const { return normal() * angle[corner]; }
};

Facet facetOf(const ModelBuffers& model, const Triangle& t) {
    const Vec3 a = model.vertices[t.v[0]].position();
    const Vec3 b = model.vertices[t.v[1]].position();
    const Vec3 c = model.vertices[t.v[2]].position();
    const Vec3 ab = normalize(b - a), bc = normalize(c - b), ca = normalize(a - c);
    // From unit edges, so that the products of small ones do not vanish; the shortest cross product is the
    // worst.
    const Vec3 atA = cross(ca, ab), atB = cross(ab, bc);
    Vec3 normal = normalize(dot(atA, atA) > dot(atB, atB) ? atA : atB);
    if (normal == Vec3{}) normal = carefulNormal(a, b, c);
    return {normal.x,
            normal.y,
            normal.z,
            {roughAcos(-dot(ca, ab)), roughAcos(-dot(ab, bc)), roughAcos(-dot(bc, ca))}};
}

class Smoother {
  public:
    Smoother(ModelBuffers& model, float creaseAngle)
        : model_(model), flat_(creaseAngle <= 0), cosCrease_(cosine(creaseAngle) - kSlack),
          cosHalf_(cosine(creaseAngle / 2) + kSlack) {}

    void run() {
        const auto missing = [](const Vec3& normal) { return normal == Vec3{}; };
        if (std::none_of(model_.normals.begin(), model_.normals.end(), missing)) return;
        allLack_ = std::all_of(model_.normals.begin(), model_.normals.end(), missing);
        sharp_.assign(model_.vertices.size(), flat_ ? 1 : 0);
        measureFacets();
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
        for (std::uint32_t t = 0; t < model_.triangles.size(); ++t) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t v = model_.triangles[t].v[i];
                if (v - first < end - first && lacks(3 * t + i)) use(t, i, v);
            }
        }
    }

    /// The vertices in as many ranges as there are threads: sums of normals depend on their order, so that a
    /// vertex is the work of one thread. All of them go through all triangles.
    template <typename Work>
    void forEachRange(const Work& work) {
        const std::size_t count = model_.vertices.size();
        constexpr std::size_t kWorthThreads = 20'000;
        const auto ranges = static_cast<std::size_t>(count > kWorthThreads ? threadsFor(0) : 1);
#pragma omp parallel for schedule(static, 1)
        for (std::size_t r = 0; r < ranges; ++r) work(count * r / ranges, count * (r + 1) / ranges);
    }

    void measureFacets() {
        facets_ = UninitializedArray<Facet>(model_.triangles.size());
#pragma omp parallel for schedule(static)
        for (std::size_t t = 0; t < model_.triangles.size(); ++t)
            facets_.data()[t] = facetOf(model_, model_.triangles[t]);
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
        entry = added_.back().entry;
    }

    struct Added {
        std::uint32_t original, entry;
    };

    ModelBuffers& model_;
    bool flat_; ///< nothing is smoothed, not even what rounding leaves of one plane
    float cosCrease_, cosHalf_;
    bool allLack_ = false; ///< no corner has a normal
    UninitializedArray<Facet> facets_;
    std::vector<std::uint8_t> sharp_;            ///< by vertex
    std::vector<std::uint32_t> first_, corners_; ///< at sharp vertices; corner = 3 * triangle + 0..2
    std::vector<Added> added_;                   ///< entries added at this vertex
};

} // namespace

void computeMissingNormals(ModelBuffers& model, float creaseAngle) { Smoother(model, creaseAngle).run(); }

} // namespace rtcore
