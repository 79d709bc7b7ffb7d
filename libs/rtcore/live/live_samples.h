/// Samples of traced light with the points that it comes from, kept from frame to frame.
#pragma once

#include "rtcore/live/image_plane.h"
#include "rtcore/math/packed_light.h"
#include "rtcore/math/vec.h"
#include "rtcore/platform/large_vector.h"
#include "rtcore/render/seen_point.h"
#include "rtcore/sampling/pixel_turn.h"
#include "rtcore/shading/light/light_visibility.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// One sample of the scene, as it was traced.
struct LiveSample {
    /// Where it seems to be, in the scene; of the background its direction, in a parallel view any point of
    /// its ray.
    Vec3 position = {};
    Colour light = {}; ///< radiance towards the eye that it was traced from
    LightVisibility lights = {};
    bool background = false;
    bool mirrors = false;    ///< mirrors or lets through other light, which is not in `light`
    bool unreliable = false; ///< its position is a guess: how it moves with the eye is not known
    std::uint8_t age = 0;    ///< frames since it was traced
};

/// A value for each pixel, with room for whole vectors behind the last. Large arrays begin at a page: walked
/// together they would all compete for the same few lines of a cache. Therefore each begins some lines later
/// than the one before it.
template <typename T>
class PixelArray {
  public:
    explicit PixelArray(std::size_t number) : before_(number * kApart / sizeof(T)) {}
    void resize(std::size_t pixels) { resizeLarge(values_, before_ + pixels + kRoom); }
    /// Sets the pixels from `from` on, and the room behind them.
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

/// A sample for each pixel of a frame, or none: 28 bytes per pixel, and 16 more where it follows indirect
/// light. Values that are used together lie together.
class LiveSamples {
  public:
    struct Point {
        Vec3 position;           ///< LiveSample::position
        std::uint32_t state = 0; ///< 0: there is no sample
    };
    struct Light {
        std::uint32_t radiance = 0; ///< packLight()
        LightVisibility lights;
    };
    using Matter = SeenMatter;
    static_assert(sizeof(Point) == 16 && sizeof(Light) == 12 && sizeof(Matter) == 16);

    // Bits of Point::state.
    static constexpr std::uint32_t kAge = 0xFF; ///< frames since it was traced, at most 255
    static constexpr std::uint32_t kKnown = 0x100, kBackground = 0x200, kMirrors = 0x400, kUnreliable = 0x800;

    LiveSamples() { clear({}); }
    /// Forgets all samples; keeps its memory.
    void clear(const ImagePlane& plane) {
        resize(plane);
        points.fill(0, {});
    }
    /// For samples that are all to be written.
    void resize(const ImagePlane& plane) {
        plane_ = plane;
        points.resize(size());
        lights.resize(size());
        points.fill(size(), {});
    }
    void set(std::size_t i, const LiveSample& sample) {
        const std::uint32_t state = kKnown | sample.age | (sample.background ? kBackground : 0U) |
                                    (sample.mirrors ? kMirrors : 0U) | (sample.unreliable ? kUnreliable : 0U);
        points[i] = {sample.position, state};
        lights[i] = {packLight(sample.light), sample.lights};
    }

    const ImagePlane& plane() const { return plane_; }
    std::size_t size() const {
        return static_cast<std::size_t>(plane_.width) * static_cast<std::size_t>(plane_.height);
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(plane_.width) +
               static_cast<std::size_t>(column);
    }
    void forget(std::size_t i) { points[i].state = 0; }
    bool known(std::size_t i) const { return points[i].state != 0; }
    static bool mirrors(const Point& point) { return (point.state & kMirrors) != 0; }
    bool mirrors(std::size_t i) const { return mirrors(points[i]); }
    bool background(std::size_t i) const { return (points[i].state & kBackground) != 0; }
    int age(std::size_t i) const { return static_cast<int>(points[i].state & kAge); }
    Colour light(std::size_t i) const { return unpackLight(lights[i].radiance); }

    PixelArray<Point> points{0};
    PixelArray<Light> lights{1};
    PixelArray<Matter> matter{12}; ///< kept by LiveLayers, of the surface layer

  private:
    ImagePlane plane_;
};

/// The light of a frame in two layers. What is mirrored moves differently from the surface that mirrors it:
/// in a flat mirror as if it were behind that, where it appears. So it has samples of its own, wherever
/// surfaces mirror.
struct LiveLayers {
    LiveSamples surface; ///< what surfaces emit and scatter themselves, and the background
    /// Light that they mirror and let through, before they tint it; undefined where they do not.
    LiveSamples specular;
    /// By sample of `surface`: packLight() of SeenPoint::tint; undefined where `specular` is.
    PixelArray<std::uint32_t> tints{10};
    bool mirrors = false;      ///< false: no surface does, and neither of the last two is kept
    bool updatesLight = false; ///< surface.matter is kept

    /// `mirrors` is to be set before.
    void resize(const ImagePlane& plane) {
        surface.resize(plane);
        if (updatesLight) surface.matter.resize(surface.size());
        if (mirrors) resizeSpecular(plane);
    }
    /// Of samples that are there, none of which has matter.
    void beginUpdating() {
        updatesLight = true;
        surface.matter.resize(surface.size());
        surface.matter.fill(0, {});
    }
    void resizeSpecular(const ImagePlane& plane) {
        specular.resize(plane);
        tints.resize(specular.size());
    }
    void clear() {
        surface.clear({});
        specular.clear({});
        mirrors = false;
    }
    /// Whether all of a pixel's light is known.
    bool known(std::size_t i) const { return surface.known(i) && (!surface.mirrors(i) || specular.known(i)); }
};

} // namespace rtcore
