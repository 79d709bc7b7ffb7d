/// Radiance of the samples of one wave of primary rays, summed over all rays that follow from them.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One element for each sample. One for each thread; keeps its memory from wave to wave. The order of
/// the sums is that of the rays, so that the bits do not depend on anything else.
class SampleSums {
  public:
    /// Begins the sums of a wave of primary rays: `background` where the ray missed, else zero. Sets the
    /// samples' hits, and surfaces.weight to 1.
    void start(Colour background, Wave& wave) {
        resize(wave.size());
        startPart(background, wave);
    }
    /// The same in parts that follow each other: room for all of them, then each of the parts before anything
    /// is added to it.
    void resize(std::size_t count);
    void startPart(Colour background, Wave& wave);
    /// Sums of nothing yet, of samples that hit nothing.
    void startEmpty(std::size_t count);

    /// Whether the next sums keep transmitted(): to be said before they start. The background is none of
    /// theirs then.
    void keepTransmitted(bool on) { keepsTransmitted_ = on; }
    bool keepsTransmitted() const { return keepsTransmitted_; }

    /// Adds surfaces.contribution.
    void add(const Wave& wave);
    void add(std::size_t sample, Colour radiance) {
        radiance_.set(sample, radiance_.colourAt(sample) + radiance);
    }
    /// Adds the part of the background that a ray sees in a straight line, past holes and panes.
    void addTransmitted(std::size_t sample, Colour part) {
        transmitted_.set(sample, transmitted_.colourAt(sample) + part);
    }
    void setHit(std::size_t sample, bool hit) { hit_[sample] = hit ? 1 : 0; }

    /// With room for whole blocks of kWaveBlock.
    const ArraysOf3& radiance() const { return radiance_; }
    /// The part of the background that is seen, 1 where nothing is before it; where it is kept, and with the
    /// same room.
    const ArraysOf3& transmitted() const { return transmitted_; }
    /// 1 where the sample hit something, else 0; with room for whole blocks of kWaveBlock.
    const std::vector<std::uint8_t>& hit() const { return hit_; }

  private:
    WaveMemory memory_;
    ArraysOf3 radiance_, transmitted_;
    bool keepsTransmitted_ = false;
    std::vector<std::uint8_t> hit_;
};

} // namespace rtcore
