/// How long something took, counted by size, for reports.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace bridge {

/// One thread. A copy is a snapshot.
class Histogram {
  public:
    /// The upper ends of all buckets but the last one, which has none; seconds, inclusive.
    static constexpr std::array<double, 22> kBounds{
        0.0001, 0.0002, 0.0003, 0.0005, 0.00075, 0.001, 0.0015, 0.002, 0.0025, 0.003, 0.004,
        0.005,  0.006,  0.008,  0.01,   0.015,   0.02,  0.03,   0.05,  0.1,    0.25,  1};

    void add(double seconds) {
        const auto bucket = std::ranges::lower_bound(kBounds, seconds) - kBounds.begin();
        ++counts_[static_cast<std::size_t>(bucket)];
        ++count_;
        sum_ += seconds;
    }
    std::uint64_t count() const { return count_; }
    double sum() const { return sum_; } ///< seconds
    /// How many are in the buckets up to this one: at most kBounds[bucket].
    std::uint64_t upTo(std::size_t bucket) const {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i <= bucket; ++i) sum += counts_[i];
        return sum;
    }
    /// The value that this part of them, 0..1, is below; within a bucket they count as spread evenly. 0
    /// without any; in the last bucket its lower end.
    double quantile(double part) const {
        const double rank = part * static_cast<double>(count_);
        double before = 0;
        for (std::size_t i = 0; count_ > 0 && i < kBounds.size(); ++i) {
            const auto here = static_cast<double>(counts_[i]);
            const double low = i == 0 ? 0 : kBounds[i - 1];
            if (here > 0 && before + here >= rank)
                return low + (kBounds[i] - low) * std::max(0.0, rank - before) / here;
            before += here;
        }
        return count_ > 0 ? kBounds.back() : 0;
    }

  private:
    std::array<std::uint64_t, kBounds.size() + 1> counts_{};
    std::uint64_t count_ = 0;
    double sum_ = 0;
};

} // namespace bridge
