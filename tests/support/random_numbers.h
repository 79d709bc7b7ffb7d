/// Random numbers that are the same with every standard library.
#pragma once

#include "rtcore/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <random>

namespace test {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// In [lo, hi].
    float number(float lo, float hi) {
        return lo + (hi - lo) * (static_cast<float>(engine_() >> 40U) / 16777216.0F);
    }
    /// In [0, count).
    std::uint32_t index(std::size_t count) { return static_cast<std::uint32_t>(engine_() % count); }
    bool coin() { return (engine_() & 1U) != 0; }
    /// In the cube [-size, size]^3.
    rtcore::Vec3 vector(float size) {
        const float x = number(-size, size);
        const float y = number(-size, size);
        return {x, y, number(-size, size)};
    }
    rtcore::Vec3 unitVector() {
        while (true) {
            const rtcore::Vec3 v = vector(1);
            const float square = dot(v, v);
            if (square <= 1 && square > 1e-4F) return normalize(v);
        }
    }

  private:
    std::mt19937_64 engine_;
};

} // namespace test
