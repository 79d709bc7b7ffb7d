#include "rtcore/sampling/alias_table.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace rtcore {

namespace {

constexpr std::uint64_t kAllBits = std::uint64_t{1} << 32U;

bool canBeSampled(std::span<const double> weights) {
    const auto fits = [](double w) { return std::isfinite(w) && w >= 0; };
    return std::all_of(weights.begin(), weights.end(), fits) &&
           std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0; });
}

/// How many of all 2^32 numbers select each of `rows` indices: 1 for each weight above 0, the rest in
/// proportion. They add up to 2^32.
std::vector<std::uint64_t> countsOf(std::span<const double> weights, std::size_t rows) {
    const double max = *std::max_element(weights.begin(), weights.end()); // against overflow of the sum
    double total = 0;
    std::uint64_t positive = 0;
    for (const double w : weights) {
        total += w / max;
        positive += w > 0 ? 1 : 0;
    }
    const auto toDivide = static_cast<double>(kAllBits - positive);
    std::vector<std::uint64_t> counts(rows, 0);
    double sum = 0;
    std::uint64_t divided = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i] / max;
        const auto now = static_cast<std::uint64_t>(sum / total * toDivide);
        if (weights[i] > 0) counts[i] = now - divided + 1;
        divided = now;
    }
    return counts;
}

} // namespace

AliasTable::AliasTable(std::span<const double> weights) {
    assert(weights.size() <= std::size_t{1} << 24U);
    if (!canBeSampled(weights)) return;
    const std::size_t rows = std::bit_ceil(std::max<std::size_t>(weights.size(), 2));
    shift_ = 32 - std::countr_zero(rows);
    std::vector<std::uint64_t> counts = countsOf(weights, rows);
    probability_.resize(rows);
    for (std::size_t i = 0; i < rows; ++i) probability_[i] = static_cast<float>(counts[i]) * 0x1p-32F;

    // Each row has room for as many numbers: what one lacks, another gives.
    const std::uint64_t room = kAllBits / rows;
    threshold_.assign(rows, static_cast<std::uint32_t>(room));
    other_.assign(rows, 0);
    std::vector<std::uint32_t> small, large;
    for (std::uint32_t i = 0; i < rows; ++i) (counts[i] < room ? small : large).push_back(i);
    while (!small.empty()) {
        const std::uint32_t taker = small.back(), giver = large.back();
        small.pop_back();
        threshold_[taker] = static_cast<std::uint32_t>(counts[taker]);
        other_[taker] = giver;
        counts[giver] -= room - counts[taker];
        if (counts[giver] >= room) continue;
        large.pop_back();
        small.push_back(giver);
    }
}

} // namespace rtcore
