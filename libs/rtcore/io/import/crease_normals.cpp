#include "rtcore/io/import/crease_normals.h"

#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <array>

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

/// Normal and corner angles of one triangle.
struct Facet {
    Vec3 normal;
    std::array<float, 3> angle{};
};

Facet facetOf(const ModelBuffers& model, const Triangle& t) {
    const Vec3 a = model.vertices[t.v[0]].position();
    const Vec3 b = model.vertices[t.v[1]].position();
    const Vec3 c = model.vertices[t.v[2]].position();
    const Vec3 ab = normalize(b - a), bc = normalize(c - b), ca = normalize(a - c);
    Facet facet;
    // From unit edges, so that the products of small ones do not vanish; the shortest cross product is the
    // worst.
    const Vec3 atA = cross(ca, ab), atB = cross(ab, bc);
    facet.normal = normalize(dot(atA, atA) > dot(atB, atB) ? atA : atB);
    if (facet.normal == Vec3{}) facet.normal = carefulNormal(a, b, c);
    facet.angle = {roughAcos(-dot(ca, ab)), roughAcos(-dot(ab, bc)), roughAcos(-dot(bc, ca))};
    return facet;
}

class Smoother {
  public:
    Smoother(ModelBuffers& model, float creaseAngle)
        : model_(model), flat_(creaseAngle <= 0), cosCrease_(cosine(creaseAngle) - kSlack),
          cosHalf_(cosine(creaseAngle / 2) + kSlack) {}

    void run() {
        collectCorners();
        if (corners_.empty()) return;
        measureFacets();
        for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
            const std::span<const std::uint32_t> corners(corners_.data() + first_[v],
                                                         first_[v + 1] - first_[v]);
            if (!corners.empty()) smoothVertex(corners);
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
    const Vec3& facetNormal(std::uint32_t corner) const { return facets_[corner / 3].normal; }
    Vec3 weighted(std::uint32_t corner) const {
        const Facet& facet = facets_[corner / 3];
        return facet.normal * facet.angle[corner % 3];
    }

    /// Corners without a normal, sorted by vertex (a counting sort).
    void collectCorners() {
        first_.assign(model_.vertices.size() + 1, 0);
        const auto count = static_cast<std::uint32_t>(model_.triangles.size() * 3);
        const auto lacks = [this](std::uint32_t corner) { return model_.normals[entryOf(corner)] == Vec3{}; };
        for (std::uint32_t c = 0; c < count; ++c) {
            if (lacks(c)) ++first_[model_.triangles[c / 3].v[c % 3] + 1];
        }
        for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
        corners_.resize(first_.back());
        std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
        for (std::uint32_t c = 0; c < count; ++c) {
            if (lacks(c)) corners_[at[model_.triangles[c / 3].v[c % 3]]++] = c;
        }
    }

    void measureFacets() {
        facets_.resize(model_.triangles.size());
#pragma omp parallel for schedule(static)
        for (std::size_t t = 0; t < facets_.size(); ++t) facets_[t] = facetOf(model_, model_.triangles[t]);
    }

    void smoothVertex(std::span<const std::uint32_t> corners) {
        added_.clear();
        if (flat_) {
            for (const std::uint32_t c : corners) assign(c, facetNormal(c));
            return;
        }
        Vec3 sum;
        for (const std::uint32_t c : corners) sum += weighted(c);
        const Vec3 mean = normalize(sum);
        // All within half the angle of their mean: then all are within the angle of each other.
        const bool smooth = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) {
            return dot(facetNormal(c), mean) >= cosHalf_;
        });
        if (smooth) {
            for (const std::uint32_t c : corners) assign(c, mean);
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
    std::vector<std::uint32_t> first_, corners_; ///< corner = 3 * triangle + 0..2
    std::vector<Facet> facets_;
    std::vector<Added> added_; ///< entries added at this vertex
};

} // namespace

void computeMissingNormals(ModelBuffers& model, float creaseAngle) { Smoother(model, creaseAngle).run(); }

} // namespace rtcore
