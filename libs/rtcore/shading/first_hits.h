/// What the samples of a wave see first, before anything is mirrored or let through.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

struct FirstHit {
    Vec3 position;
    Vec3 normal;   ///< the shading normal, unit, on the side of the viewer
    Colour albedo; ///< share of light that the surface scatters, mirrors or lets through
    Colour direct; ///< radiance by the light of lights, once scattered
    Colour
        soft; ///< radiance of the light that is sampled, and so grainy: of lamps with a size, from everywhere
    float arriving = 0, whole = 0; ///< light from everywhere, and what there would be without occlusion
    std::uint32_t wave = 0;        ///< of the sample, in which it was hit; 0: nothing was

    bool any() const { return wave != 0; }
};

/// One for each thread; keeps its memory.
class FirstHits {
  public:
    /// Forgets the hits; `samples` are to come, wave after wave.
    void start(std::size_t samples) {
        hits_.assign(samples, {});
        wave_ = 0;
    }
    void beginWave() { ++wave_; }

    bool missing(std::size_t sample) const { return !hits_[sample].any(); }
    /// Takes the first hit of a sample, which the present wave found.
    void take(std::size_t sample, const FirstHit& hit) {
        hits_[sample] = hit;
        hits_[sample].wave = wave_;
    }
    /// The hit of a sample, or null when it was not found by the present wave.
    FirstHit* present(std::size_t sample) {
        FirstHit& hit = hits_[sample];
        return hit.wave == wave_ ? &hit : nullptr;
    }

    const FirstHit& operator[](std::size_t sample) const { return hits_[sample]; }
    std::size_t size() const { return hits_.size(); }

  private:
    std::vector<FirstHit> hits_;
    std::uint32_t wave_ = 0;
};

} // namespace rtcore
