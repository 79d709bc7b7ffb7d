/// Sampling of an index in proportion to weights, in constant time: Walker's alias method, with Vose's
/// way to build the table (1991).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// A table's arrays for vector code (alias-inl.h).
struct AliasRows {
    const std::uint32_t* threshold = nullptr; ///< of the bits below `shift` that keep to the row's own index
    const std::uint32_t* other = nullptr;     ///< the index for the rest of them
    const float* probability = nullptr;
    int shift = 31; ///< the bits from here on are the row
};

/// Immutable once made; safe from many threads.
class AliasTable {
  public:
    /// Empty: has nothing to sample.
    AliasTable() = default;
    /// For at most 2^24 weights. Empty if one of them is negative or not finite, or if all are 0.
    explicit AliasTable(std::span<const double> weights);

    bool empty() const { return probability_.empty(); }
    /// The probability of `index`: 0 for the weight 0, otherwise at least 2^-32; the fraction of all `bits`
    /// that select it, rounded to a float. `index` is below the number of weights.
    float probability(std::uint32_t index) const { return probability_[index]; }
    AliasRows rows() const { return {threshold_.data(), other_.data(), probability_.data(), shift_}; }

  private:
    std::vector<std::uint32_t> threshold_, other_;
    std::vector<float> probability_;
    int shift_ = 31;
};

} // namespace rtcore
