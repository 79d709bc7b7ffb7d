/// Light that was traced, with the points that it comes from: what is kept from frame to frame.
#pragma once

#include "rtcore/live/image_plane.h"
#include "rtcore/live/packed_light.h"
#include "rtcore/math/vec.h"
#include "rtcore/shading/light/light_visibility.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One sample of the scene, as it was traced.
struct LiveSample {
    Vec3 position = {}; ///< of the surface, in the scene; of the background its direction
    Colour light = {};  ///< radiance towards the eye that it was traced from
    LightVisibility lights = {};
    float mirrored = 0; ///< 0..1: the fraction of the light that comes by mirrors and glass
    bool background = false;
    std::uint8_t age = 0; ///< frames since it was traced
};

/// A value for each pixel, with room for whole vectors behind the last. Large arrays begin at a page, and so
/// would all fall into the same few lines of a cache when they are walked together; therefore each begins so
/// many lines later than that before it.
template <typename T>
class PixelArray {
  public:
    explicit PixelArray(std::size_t number) : before_(number * kApart / sizeof(T)) {}
    void resize(std::size_t pixels) { values_.resize(before_ + pixels + kRoom); }
    /// Of the pixels, and of the room behind them.
    void fill(std::size_t from, T value) {
        std::fill(values_.begin() + static_cast<std::ptrdiff_t>(before_ + from), values_.end(), value);
    }
    T& operator[](std::size_t i) { return values_[before_ + i]; }
    const T& operator[](std::size_t i) const { return values_[before_ + i]; }

  private:
    static constexpr std::size_t kRoom = 64;      ///< no vector has more lanes
    static constexpr std::size_t kApart = 5 * 64; ///< bytes
    std::size_t before_;
    std::vector<T> values_;
};

/// A sample for each pixel of a frame, or none: 24 bytes a pixel.
class LiveSamples {
  public:
    // Of a state. 0: there is no sample.
    static constexpr std::uint32_t kAge = 0xFF; ///< frames since it was traced, at most 255
    static constexpr std::uint32_t kMirrored = 0xFF00, kMirroredShift = 8;
    static constexpr std::uint32_t kKnown = 0x10000, kBackground = 0x20000;

    LiveSamples() { clear({}); }
    /// Forgets all samples; keeps its memory.
    void clear(const ImagePlane& plane) {
        resize(plane);
        states.fill(0, 0);
    }
    /// For samples that are all to be written.
    void resize(const ImagePlane& plane) {
        plane_ = plane;
        for (PixelArray<float>* const values : {&x, &y, &z}) values->resize(size());
        for (PixelArray<std::uint32_t>* const values : {&light, &lights, &states}) values->resize(size());
        states.fill(size(), 0);
    }
    void set(std::size_t i, const LiveSample& sample) {
        x[i] = sample.position.x;
        y[i] = sample.position.y;
        z[i] = sample.position.z;
        light[i] = packLight(sample.light);
        lights[i] = std::bit_cast<std::uint32_t>(sample.lights);
        const float mirrored = std::clamp(sample.mirrored, 0.0F, 1.0F);
        states[i] = kKnown | sample.age | (sample.background ? kBackground : 0U) |
                    static_cast<std::uint32_t>(mirrored * 255 + 0.5F) << kMirroredShift;
    }

    const ImagePlane& plane() const { return plane_; }
    std::size_t size() const {
        return static_cast<std::size_t>(plane_.width) * static_cast<std::size_t>(plane_.height);
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width) +
               static_cast<std::size_t>(column);
    }
    bool known(std::size_t i) const { return states[i] != 0; }
    LightVisibility visibility(std::size_t i) const { return std::bit_cast<LightVisibility>(lights[i]); }

    PixelArray<float> x{0}, y{1}, z{2};  ///< LiveSample::position
    PixelArray<std::uint32_t> light{3};  ///< packLight()
    PixelArray<std::uint32_t> lights{4}; ///< the bits of a LightVisibility
    PixelArray<std::uint32_t> states{5};

  private:
    ImagePlane plane_;
};

/// 0..63: the turn of a pixel among its neighbours, which are far apart in time. (Bayer 1973)
constexpr std::uint32_t turnOf(int x, int y) {
    std::uint32_t turn = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const std::uint32_t a = static_cast<std::uint32_t>(x) >> bit & 1U;
        const std::uint32_t b = static_cast<std::uint32_t>(y) >> bit & 1U;
        turn = turn << 2 | (a ^ b) << 1 | b;
    }
    return turn;
}
inline constexpr std::uint32_t kTurns = 64;

} // namespace rtcore
