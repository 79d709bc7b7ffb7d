#include "rtcore/sky/sky_light.h"

#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"
#include "rtcore/sky/atmosphere.h"
#include "rtcore/sky/sun_position.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

constexpr int kHeight = kSkyWidth / 2;
constexpr float kTexel = kPi / kHeight; ///< radians

/// Of each texel of a row, across; unit.
std::vector<Vec2> azimuths() {
    std::vector<Vec2> all;
    for (int x = 0; x < kSkyWidth; ++x) {
        const float angle = (static_cast<float>(x) + 0.5F) * kTexel - kPi;
        all.push_back({portableSin(angle), -portableCos(angle)});
    }
    return all;
}

float scaleOf(const Sky& sky) { return sky.strength / kLuminanceOfOne; }

/// On a surface that faces it. `sun`: unit vector to it.
Colour sunlightOf(const Sky& sky, Vec3 up, Vec3 sun) {
    return sunIlluminance(dot(sun, up), sky.turbidity) * scaleOf(sky);
}

/// Draws the map. A texel that the horizon crosses has parts of sky and ground.
class SkyPainter {
  public:
    SkyPainter(const Sky& sky, Vec3 up, Vec3 sun)
        : up_(up), sun_(sun), aboveHorizon_(onOrAbove(sun, up)), air_(dot(sun, up), sky.turbidity),
          scale_(scaleOf(sky)), sunlight_(sunlightOf(sky, up, sun)) {}

    HdrImage paint() {
        HdrImage image(kSkyWidth, kHeight);
        const std::vector<Vec2> across = azimuths();
        for (int y = 0; y < kHeight; ++y) {
            const float polar = (static_cast<float>(y) + 0.5F) * kTexel;
            const float ring = portableSin(polar), height = portableCos(polar);
            for (int x = 0; x < kSkyWidth; ++x) {
                const Vec2 a = across[static_cast<std::size_t>(x)];
                image.at(x, y) = skyIn({ring * a.x, height, ring * a.y}, ring);
            }
        }
        addGround(image, across);
        return image;
    }

  private:
    /// The sun, or the point of the horizon below which it is.
    static Vec3 onOrAbove(Vec3 sun, Vec3 up) {
        const float height = dot(sun, up);
        const Vec3 across = normalize(sun - up * height);
        return height >= 0 || across == Vec3{} ? sun : across;
    }

    float partOfSky(Vec3 direction) const {
        return std::clamp(0.5F + dot(direction, up_) / kTexel, 0.0F, 1.0F);
    }

    /// The sky's part of a texel; adds what it throws on the ground.
    Colour skyIn(Vec3 direction, float ring) {
        const float part = partOfSky(direction);
        if (part == 0) return {};
        const float height = dot(direction, up_);
        if (height != lastHeight_) last_ = air_.height(height);
        lastHeight_ = height;
        const Colour sky = air_.luminance(last_, dot(direction, aboveHorizon_)) * (scale_ * part);
        const double weight = static_cast<double>(std::max(height, 0.0F) * ring * kTexel * kTexel);
        onGround_[0] += weight * static_cast<double>(sky.r);
        onGround_[1] += weight * static_cast<double>(sky.g);
        onGround_[2] += weight * static_cast<double>(sky.b);
        return sky;
    }

    void addGround(HdrImage& image, const std::vector<Vec2>& across) const {
        const Colour fromSky{static_cast<float>(onGround_[0]), static_cast<float>(onGround_[1]),
                             static_cast<float>(onGround_[2])};
        const Colour irradiance = fromSky + sunlight_ * std::max(dot(sun_, up_), 0.0F);
        const Colour ground = irradiance * (kGroundAlbedo / kPi);
        for (int y = 0; y < kHeight; ++y) {
            const float polar = (static_cast<float>(y) + 0.5F) * kTexel;
            const float ring = portableSin(polar), height = portableCos(polar);
            for (int x = 0; x < kSkyWidth; ++x) {
                const Vec2 a = across[static_cast<std::size_t>(x)];
                image.at(x, y) += ground * (1 - partOfSky({ring * a.x, height, ring * a.y}));
            }
        }
    }

    Vec3 up_, sun_, aboveHorizon_;
    ClearSky air_;
    float scale_;
    Colour sunlight_;
    double onGround_[3] = {};
    float lastHeight_ = -2;
    ClearSky::Height last_{};
};

} // namespace

Light sunOfSky(const Sky& sky, Vec3 up) {
    const Vec3 sun = sunDirection(sky, up);
    Light light;
    light.kind = LightKind::Directional;
    light.direction = sun * -1.0F;
    light.intensity = sunlightOf(sky, up, sun);
    light.discSine = kSunSine;
    return light;
}

SkyLight skyLightOf(const Sky& sky, Vec3 up) {
    HdrImage map = SkyPainter(sky, up, sunDirection(sky, up)).paint();
    return {std::make_shared<const Environment>(Environment::fromEquirectangular(std::move(map), "sky")),
            sunOfSky(sky, up)};
}

} // namespace rtcore
