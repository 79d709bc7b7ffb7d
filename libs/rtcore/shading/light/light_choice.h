/// Which of many lights are traced at each point of a wave, where there is no time for all.
#pragma once

#include "rtcore/kernels/arrays_of_3.h"
#include "rtcore/kernels/wave_memory.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// By what each light adds unshadowed: those that add at least a step of it, one kSteps-th, are taken, and of
/// the others some by chance, in proportion to what they add, at equal steps along the sum (systematic
/// sampling: Madow and Madow 1944). Weighed by the reciprocal of their chance, the mean over all chances is
/// the light of all; without shadows the light itself is. One for each thread; keeps its memory.
class LightChoice {
  public:
    /// So many lights are never chosen from: all of them are taken.
    static constexpr std::size_t kAll = 32;
    /// The sum is walked in so many: no more lights are taken at a point, but for one.
    static constexpr float kSteps = 16;

    /// Begins a wave; `shift(i)` is the random number of point i, 0 <= . < 1.
    template <typename Shift>
    void begin(std::size_t points, std::size_t lights, Shift&& shift) {
        resize(points, lights);
        for (std::size_t i = 0; i < points; ++i) passed_[i] = shift(i);
    }
    /// What the next light adds, in the order in which next() takes them.
    void weigh(const ArraysOf3& contribution);
    /// All are weighed.
    void end();

    /// Points that take one light.
    struct Taken {
        std::span<const std::uint32_t> points; ///< in ascending order
        std::span<const float> weights;        ///< factors on its light
    };
    /// Of the next light. Valid until the next call.
    Taken next();

  private:
    void resize(std::size_t points, std::size_t lights);
    float* row(std::size_t light) { return added_.data() + light * stride_; }

    std::size_t count_ = 0, stride_ = 0, weighed_ = 0, taken_ = 0;
    std::vector<float> added_;  ///< luminance, by light and point
    std::vector<float> sum_;    ///< of all lights, by point; then what a light needs to be taken, inverse
    std::vector<float> passed_; ///< part of a step since the last light that was taken by chance, by point
    std::vector<std::uint32_t> points_;
    std::vector<float> weights_;
};

} // namespace rtcore
