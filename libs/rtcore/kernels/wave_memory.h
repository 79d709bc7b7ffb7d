/// Memory of many equally long arrays of floats, as vector code likes it: each begins on a cache line and has
/// room for whole blocks of 64.
#pragma once

#include "rtcore/kernels/arrays_of_3.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// Values of a wave are worked on in blocks of so many: no vector is longer, and a block's data stay in the
/// first cache. Arrays of waves have room for whole blocks.
inline constexpr std::size_t kWaveBlock = 64;

class WaveMemory {
  public:
    /// Makes room for `arrays` arrays of `count` values. What they held is lost, and undefined; allocates
    /// only when more is needed than ever before.
    void resize(std::size_t arrays, std::size_t count) {
        // One line more than needed, so that the arrays do not fall on the same sets of the cache.
        stride_ = (count + kWaveBlock - 1) / kWaveBlock * (kWaveBlock / kLine) + 1;
        if (lines_.size() < arrays * stride_) lines_.resize(arrays * stride_);
    }
    float* array(std::size_t i) { return lines_[i * stride_].values; }
    ArraysOf3 arraysOf3(std::size_t first) { return {array(first), array(first + 1), array(first + 2)}; }

  private:
    static constexpr std::size_t kLine = 16;
    struct alignas(64) Line {
        float values[kLine];
    };
    std::vector<Line> lines_;
    std::size_t stride_ = 0;
};

} // namespace rtcore
