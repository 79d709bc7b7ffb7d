/// Normals of all that the samples of one wave see, also in mirrors and behind glass.
#pragma once

#include "rtcore/math/vec.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <span>
#include <vector>

namespace rtcore {

/// Sample i is that of primary ray i. One for each thread; keeps its memory from wave to wave. The order of
/// the sums is that of the rays.
class NormalSums {
  public:
    /// Begins the sums of so many samples.
    void start(std::size_t samples) { sums_.assign(samples, {}); }

    /// Adds the shading normals of a wave whose light is divided: each by the fraction of its sample's light
    /// that its surface neither mirrors nor lets through.
    void add(const Wave& wave);

    /// In the scene's axes; of length 1 at most, shorter where a sample sees several things, 0 where none.
    std::span<const Vec3> normals() const { return sums_; }

  private:
    std::vector<Vec3> sums_;
};

} // namespace rtcore
