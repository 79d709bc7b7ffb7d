#include "rtcore/io/import/mesh/equal_positions.h"

#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace rtcore {

namespace {

/// A position that waits in its group.
struct Waiting {
    float x, y, z;
    std::uint32_t number;

    Vec3 position() const { return {x, y, z}; }
};

/// Groups positions by their hashes, so that equal ones are found in memory that stays in the cache.
class EqualPositions {
  public:
    explicit EqualPositions(std::span<const Vec3> positions)
        : positions_(positions), groups_(std::bit_ceil(positions.size() / kGroup + 1)),
          parts_(positions.size() > kGroup ? static_cast<std::size_t>(threadsFor(0)) : 1) {}

    std::vector<std::uint32_t> run() {
        resizeLarge(first_, positions_.size());
        std::iota(first_.begin(), first_.end(), 0U);
        group();
        std::vector<Table> tables(parts_);
#pragma omp parallel for schedule(dynamic, 1) if (parts_ > 1)
        for (std::size_t g = 0; g < groups_; ++g) {
            compare({waiting_.data() + begins_[g * parts_], waiting_.data() + begins_[(g + 1) * parts_]},
                    tables[static_cast<std::size_t>(threadNumber()) % parts_]);
        }
        return std::move(first_);
    }

  private:
    static constexpr std::size_t kGroup = 8192;
    using Table = std::vector<std::uint32_t>;

    std::size_t groupOf(Vec3 p) const { return (hashOfPosition(p) >> 20U) & (groups_ - 1); }

    /// Calls `use` for each usable position in a part of all, in their order.
    template <typename Use>
    void forEachUsable(std::size_t part, const Use& use) const {
        const std::size_t end = positions_.size() * (part + 1) / parts_;
        for (std::size_t i = positions_.size() * part / parts_; i < end; ++i) {
            const Vec3 p = withoutTraces(positions_[i]);
            if (isUsablePosition(p)) use(p, static_cast<std::uint32_t>(i));
        }
    }

    /// A counting sort by several threads: `begins_` has a number for each part of each group.
    void group() {
        begins_.assign(groups_ * parts_ + 1, 0);
#pragma omp parallel for schedule(static, 1) if (parts_ > 1)
        for (std::size_t part = 0; part < parts_; ++part) {
            std::vector<std::size_t> counts(groups_);
            forEachUsable(part, [&](Vec3 p, std::uint32_t) { ++counts[groupOf(p)]; });
            for (std::size_t g = 0; g < groups_; ++g) begins_[g * parts_ + part + 1] = counts[g];
        }
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        waiting_ = UninitializedArray<Waiting>(begins_.back());
#pragma omp parallel for schedule(static, 1) if (parts_ > 1)
        for (std::size_t part = 0; part < parts_; ++part) {
            std::vector<std::size_t> at(groups_);
            for (std::size_t g = 0; g < groups_; ++g) at[g] = begins_[g * parts_ + part];
            forEachUsable(part, [&](Vec3 p, std::uint32_t number) {
                waiting_.data()[at[groupOf(p)]++] = {p.x, p.y, p.z, number};
            });
        }
    }

    /// By an open hash table of places in the group, in which numbers ascend.
    void compare(std::span<const Waiting> group, Table& table) {
        constexpr std::uint32_t kNone = 0xFFFFFFFFU;
        const std::size_t mask = std::bit_ceil(group.size() * 2 + 1) - 1;
        table.assign(mask + 1, kNone);
        for (std::uint32_t i = 0; i < group.size(); ++i) {
            const Vec3 p = group[i].position();
            std::size_t slot = (hashOfPosition(p) >> 40U) & mask;
            while (table[slot] != kNone && group[table[slot]].position() != p) slot = (slot + 1) & mask;
            if (table[slot] == kNone) {
                table[slot] = i;
            } else {
                first_[group[i].number] = group[table[slot]].number;
            }
        }
    }

    std::span<const Vec3> positions_;
    std::size_t groups_, parts_;
    std::vector<std::size_t> begins_;
    UninitializedArray<Waiting> waiting_;
    std::vector<std::uint32_t> first_;
};

} // namespace

std::vector<std::uint32_t> firstOfEqualPositions(std::span<const Vec3> positions) {
    return EqualPositions(positions).run();
}

} // namespace rtcore
