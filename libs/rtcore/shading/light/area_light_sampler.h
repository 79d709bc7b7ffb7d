/// The samples of an area light for the points of a wave.
#pragma once

#include "rtcore/kernels/wave_memory.h"
#include "rtcore/sampling/sample_id.h"
#include "rtcore/shading/light/light_wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// All samples of a pixel together follow Roberts' sequence R2 (2018), shifted at random for each pixel, so
/// that any number of them is spread evenly over the light. Keeps its memory from wave to wave.
class AreaLightSampler {
  public:
    /// For `count` points with `samples` light samples each, for each of the `subs` samples of a pixel.
    /// `name(i)` gives the SampleId of point i; `pathKey(i)` distinguishes the points of one sample: 0 for
    /// directly visible ones, other numbers behind mirrors.
    template <typename Name, typename PathKey>
    void begin(std::size_t count, int samples, int subs, std::uint32_t light, Name&& name,
               PathKey&& pathKey) {
        weight_ = 1.0F / static_cast<float>(samples);
        ofAll_ = weight_ / static_cast<float>(subs);
        u_.resize(count + kWaveBlock);
        v_.resize(count + kWaveBlock);
        for (std::size_t i = 0; i < count; ++i) {
            const SampleId id = name(i);
            const SquarePoint first =
                randomShift({id.x, id.y, 0}, SampleDimension::AreaLight, light ^ mixBits(pathKey(i)) >> 8);
            const std::uint32_t before = id.sub * static_cast<std::uint32_t>(samples);
            u_[i] = bits(first.u) + before * kStepU;
            v_[i] = bits(first.v) + before * kStepV;
        }
    }
    /// 0 <= sample < samples
    LightStrata strata(int sample) const {
        const auto k = static_cast<std::uint32_t>(sample);
        return {u_.data(), v_.data(), k * kStepU, k * kStepV, weight_, ofAll_};
    }

  private:
    /// 2^32 times 0.7548776662 and its square: 1 / p and 1 / p^2 where p^3 = p + 1.
    static constexpr std::uint32_t kStepU = 3242174889U, kStepV = 2447445414U;
    static std::uint32_t bits(float unit) { return static_cast<std::uint32_t>(unit * 0x1p24F) << 8; }

    float weight_ = 1, ofAll_ = 1;
    std::vector<std::uint32_t> u_, v_;
};

} // namespace rtcore
