/// Which parts of a lamp with a size the points of a wave look at.
#pragma once

#include "rtcore/kernels/wave_memory.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/shading/light/light_wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Of each pixel, all samples together follow Roberts' sequence R2 (2018) from a place of the pixel's own on;
/// whatever their number, their parts lie evenly on the lamp. Keeps its memory from wave to wave.
class LampDraw {
  public:
    /// For `count` points that draw `samples` parts each, for each of the `subs` samples of a pixel.
    /// `name(i)` gives the SampleId of point i, `way(i)` tells apart the points of one sample: 0 where it
    /// looks directly, other numbers behind mirrors.
    template <typename Name, typename Way>
    void begin(std::size_t count, int samples, int subs, std::uint32_t light, Name&& name, Way&& way) {
        share_ = 1.0F / static_cast<float>(samples);
        ofAll_ = share_ / static_cast<float>(subs);
        u_.resize(count + kWaveBlock);
        v_.resize(count + kWaveBlock);
        for (std::size_t i = 0; i < count; ++i) {
            const SampleId id = name(i);
            const SquarePoint first = randomShift({id.x, id.y, 0}, Draw::Lamp, light ^ mixBits(way(i)) >> 8);
            const std::uint32_t before = id.sub * static_cast<std::uint32_t>(samples);
            u_[i] = bits(first.u) + before * kStepU;
            v_[i] = bits(first.v) + before * kStepV;
        }
    }
    /// 0 <= sample < samples
    LampPart part(int sample) const {
        const auto k = static_cast<std::uint32_t>(sample);
        return {u_.data(), v_.data(), k * kStepU, k * kStepV, share_, ofAll_};
    }

  private:
    /// 2^32 times 0.7548776662 and its square: 1 / p and 1 / p^2 where p^3 = p + 1.
    static constexpr std::uint32_t kStepU = 3242174889U, kStepV = 2447445414U;
    static std::uint32_t bits(float unit) { return static_cast<std::uint32_t>(unit * 0x1p24F) << 8; }

    float share_ = 1, ofAll_ = 1;
    std::vector<std::uint32_t> u_, v_;
};

} // namespace rtcore
