/// Which elements of a long list are the same.
#pragma once

#include "rtcore/accel/uninitialized_array.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

/// Groups elements by their hashes, so that equal ones are found in memory that stays in the cache.
template <typename HashOf, typename Same>
class FirstOfSame {
  public:
    FirstOfSame(std::size_t count, const HashOf& hashOf, const Same& same)
        : hashOf_(hashOf), same_(same), count_(count), groups_(std::bit_ceil(count / kGroup + 1)),
          parts_(count > kGroup ? static_cast<std::size_t>(threadsFor(0)) : 1) {}

    std::vector<std::uint32_t> run() {
        group();
        std::vector<std::uint32_t> first;
        resizeLarge(first, count_);
        std::iota(first.begin(), first.end(), 0U);
        std::vector<std::vector<std::uint32_t>> tables(parts_);
        bool any = false;
#pragma omp parallel for schedule(dynamic, 1) reduction(|| : any) if (parts_ > 1)
        for (std::size_t g = 0; g < groups_; ++g) {
            const Waiting *const begin = waiting_.data() + begins_[g * parts_], *const end =
                                                                                    waiting_.data() +
                                                                                    begins_[(g + 1) * parts_];
            auto& table = tables[static_cast<std::size_t>(threadNumber()) % parts_];
            any = compare({begin, end}, table, first) || any;
        }
        if (!any) first.clear();
        return first;
    }

  private:
    static constexpr std::size_t kGroup = 8192;

    struct Waiting {
        std::uint32_t hash; ///< its upper half
        std::uint32_t number;
    };

    /// Calls `use` for each element of a part that has a hash, in their order.
    template <typename Use>
    void forEach(std::size_t part, const Use& use) const {
        const std::size_t end = count_ * (part + 1) / parts_;
        for (std::size_t i = count_ * part / parts_; i < end; ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            if (const std::optional<std::uint64_t> hash = hashOf_(number)) use(*hash, number);
        }
    }
    std::size_t groupOf(std::uint64_t hash) const { return (hash >> 20U) & (groups_ - 1); }

    /// A counting sort by several threads: `begins_` has a number for each part of each group.
    void group() {
        begins_.assign(groups_ * parts_ + 1, 0);
#pragma omp parallel for schedule(static, 1) if (parts_ > 1)
        for (std::size_t part = 0; part < parts_; ++part) {
            std::vector<std::size_t> counts(groups_);
            forEach(part, [&](std::uint64_t hash, std::uint32_t) { ++counts[groupOf(hash)]; });
            for (std::size_t g = 0; g < groups_; ++g) begins_[g * parts_ + part + 1] = counts[g];
        }
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        waiting_ = UninitializedArray<Waiting>(begins_.back());
#pragma omp parallel for schedule(static, 1) if (parts_ > 1)
        for (std::size_t part = 0; part < parts_; ++part) {
            std::vector<std::size_t> at(groups_);
            for (std::size_t g = 0; g < groups_; ++g) at[g] = begins_[g * parts_ + part];
            forEach(part, [&](std::uint64_t hash, std::uint32_t number) {
                waiting_.data()[at[groupOf(hash)]++] = {static_cast<std::uint32_t>(hash >> 32U), number};
            });
        }
    }

    /// By an open hash table of positions in the group, in which numbers ascend; whether two are the same.
    bool compare(std::span<const Waiting> group, std::vector<std::uint32_t>& table,
                 std::vector<std::uint32_t>& first) const {
        constexpr std::uint32_t kNone = 0xFFFFFFFFU;
        const std::size_t mask = std::bit_ceil(group.size() * 2 + 1) - 1;
        table.assign(mask + 1, kNone);
        bool any = false;
        for (std::uint32_t i = 0; i < group.size(); ++i) {
            const auto [hash, number] = group[i];
            const auto differs = [&](std::uint32_t other) {
                return group[other].hash != hash || !same_(group[other].number, number);
            };
            std::size_t slot = (hash >> 8U) & mask;
            while (table[slot] != kNone && differs(table[slot])) slot = (slot + 1) & mask;
            if (table[slot] == kNone) {
                table[slot] = i;
            } else {
                first[number] = group[table[slot]].number;
                any = true;
            }
        }
        return any;
    }

    const HashOf& hashOf_;
    const Same& same_;
    std::size_t count_, groups_, parts_;
    std::vector<std::size_t> begins_;
    UninitializedArray<Waiting> waiting_;
};

/// For each of `count` elements, at most 2^32 - 1, the number of the first that is the same; no numbers at
/// all where all differ. `hashOf(i)`: a std::uint64_t in which all bits depend on the element, or nothing for
/// one that is the same as no other one. 12 bytes of memory for each. By the threads of OpenMP; the result
/// does not depend on them.
template <typename HashOf, typename Same>
std::vector<std::uint32_t> firstOfSame(std::size_t count, const HashOf& hashOf, const Same& same) {
    return FirstOfSame(count, hashOf, same).run();
}

} // namespace rtcore
