#include "rtcore/lights/emitter_clusters.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numbers>
#include <tuple>

namespace rtcore {

namespace {

/// Divides triangles into parts of about as many, which lie together.
class Divider {
  public:
    Divider(const Mesh& mesh, std::span<const std::uint32_t> triangles) : order_(triangles.size()) {
        centres_.reserve(triangles.size());
        for (const std::uint32_t t : triangles)
            centres_.push_back((mesh.position(t, 0) + mesh.position(t, 1) + mesh.position(t, 2)) / 3);
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<std::uint32_t>(i);
    }

    /// use(members) with each of them, ascending.
    template <typename Use>
    void divide(std::size_t parts, Use&& use) {
        divide(order_, parts, use);
    }

  private:
    template <typename Use>
    void divide(std::span<std::uint32_t> members, std::size_t parts, Use&& use) {
        if (parts == 1) {
            std::ranges::sort(members);
            use(members);
            return;
        }
        Box3 middles;
        for (const std::uint32_t i : members) middles.extend(centres_[i]);
        const Vec3 size = middles.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t half = parts / 2, first = members.size() * half / parts;
        // Of those at one place by number, so that the parts do not depend on a library.
        std::ranges::nth_element(members, members.begin() + static_cast<std::ptrdiff_t>(first), {},
                                 [&](std::uint32_t i) { return std::tuple(centres_[i][axis], i); });
        divide(members.first(first), half, use);
        divide(members.subspan(first), parts - half, use);
    }

    std::vector<Vec3> centres_;
    std::vector<std::uint32_t> order_;
};

} // namespace

void EmitterClusters::prepare(const Mesh& mesh, std::span<const std::uint32_t> triangles,
                              std::span<const double> powers) {
    *this = {};
    const std::size_t parts = std::min(triangles.size(), kMaxClusters);
    if (parts == 0) return;
    const std::size_t largest = (triangles.size() + parts - 1) / parts;
    rowBits_ = std::countr_zero(std::bit_ceil(std::max<std::size_t>(largest, 2)));
    rowOf_.resize(triangles.size());
    Divider(mesh, triangles).divide(parts, [&](std::span<const std::uint32_t> members) {
        addCluster(mesh, triangles, powers, members);
    });
    tree_.prepare(clusters_);
    clusters_ = {};
}

void EmitterClusters::addCluster(const Mesh& mesh, std::span<const std::uint32_t> triangles,
                                 std::span<const double> powers, std::span<const std::uint32_t> members) {
    const std::size_t count = std::size_t{1} << rowBits_, first = threshold_.size();
    LightCluster cluster;
    cluster.cosSpread = -1; // both sides shine
    std::vector<double> weights(count);
    double power = 0;
    triangles_.resize(first + count, triangles[members[0]]);
    for (std::size_t row = 0; row < members.size(); ++row) {
        const std::uint32_t index = members[row], triangle = triangles[index];
        for (int corner = 0; corner < 3; ++corner) cluster.box.extend(mesh.position(triangle, corner));
        weights[row] = powers[index];
        power += powers[index];
        triangles_[first + row] = triangle;
        rowOf_[index] = static_cast<std::uint32_t>(first + row);
    }
    const double intensity = power / (4 * std::numbers::pi);
    cluster.intensity =
        static_cast<float>(std::min(intensity, static_cast<double>(std::numeric_limits<float>::max())));
    clusters_.push_back(cluster);
    const AliasTable own(weights);
    const AliasRows table = own.rows();
    threshold_.insert(threshold_.end(), table.threshold, table.threshold + count);
    other_.insert(other_.end(), table.other, table.other + count);
    probability_.insert(probability_.end(), table.probability, table.probability + count);
}

} // namespace rtcore
