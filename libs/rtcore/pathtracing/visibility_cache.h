/// The visibility of lights from the points of a scene, learned from samples before an image: of its
/// surroundings by direction, of lights one by one. So a room samples the sky through its windows, and no
/// light of another room. The idea is that of Guo, Eisemann and Eisemann 2020 ("Next Event Estimation++"),
/// with cells that follow the samples as those of Mueller, Gross and Novak 2017 do.
#pragma once

#include "rtcore/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// The lights that a point saw.
struct VisibilitySample {
    static constexpr std::uint8_t kAll = 254, kUntried = 255;
    static constexpr std::uint32_t kLights = 4; ///< that a point looks for at most

    /// A direction to the surroundings.
    struct Try {
        std::uint8_t bin = 0;  ///< row times kSide, and column
        std::uint8_t seen = 0; ///< its cosine, times what arrives, of kAll
    };

    Vec3 position;
    Vec3 normal;              ///< unit
    std::uint32_t number = 0; ///< of its random numbers; says which lights are tried
    std::array<Try, 32> sky{};
    std::array<std::uint8_t, kLights> light{}; ///< what arrives, of kAll; or kUntried

    /// Which of `lights` lights it tries as the k-th, k < min(lights, kLights).
    std::size_t lightOf(std::uint32_t k, std::size_t lights) const {
        return (std::size_t{number} * kLights + k) % lights;
    }
};

/// Arrays for vector code (visibility_cache-inl.h). Cells are the leaves of six binary trees, one for each
/// axis and sign that a normal may be nearest to.
struct VisibilityRows {
    static constexpr int kSide = 16; ///< the surroundings' numbers (EnvironmentPoint) have kSide^2 bins
    static constexpr std::uint32_t kLeaf = 1U << 31; ///< of a link: the rest is a cell
    static constexpr std::uint32_t kAxis = 3;        ///< else: the axis, and above it the first of two nodes

    const std::uint32_t* links = nullptr; ///< of nodes; the first six are the trees' roots
    const float* splits = nullptr;        ///< of nodes: coordinates from here on belong to the second
    /// As in EnvironmentRows, by cell: kSide rows, and kSide bins in each of them.
    const std::uint32_t *rowStarts = nullptr, *columnStarts = nullptr;
    const float* surroundings = nullptr; ///< by cell: luminance of what arrives of them on a surface
    const float* lights = nullptr; ///< by cell and light (LightRows): about how much of it arrives, above 0
    std::int32_t cells = 0;
    std::int32_t lightCount = 0;

    bool known() const { return links != nullptr; }
};

/// Immutable once built; safe from many threads. 1.2 KB for each cell, and 4 bytes for each of its lights.
class VisibilityCache {
  public:
    /// From the first `tries` directions of samples in any order. `lights`: how many are known one by one.
    /// `scalarIrradiance`: luminance of the surroundings' light from all directions.
    void build(std::span<const VisibilitySample> samples, std::size_t tries, std::size_t lights,
               double scalarIrradiance);

    bool empty() const { return tables_.links.empty(); }
    VisibilityRows rows() const;

    /// As in VisibilityRows.
    struct Tables {
        std::vector<std::uint32_t> links, rowStarts, columnStarts;
        std::vector<float> splits, surroundings, lights;
    };

  private:
    std::size_t lightCount_ = 0;
    Tables tables_;
};

} // namespace rtcore
