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
          scale_(scaleOf(sky)), sunlight_(sunlightOf(sky, up, sun)), haze_(sky.haze),
          albedo_(groundAlbedo(sky)) {}

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
        if (haze_) addHaze(image);
        addGround(image, across);
        if (haze_) fadeGround(image);
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
        const Colour irradiance = fromSky() + sunlight_ * std::max(dot(sun_, up_), 0.0F);
        const Colour ground = irradiance * (albedo_ / kPi);
        for (int y = 0; y < kHeight; ++y) {
            const float polar = (static_cast<float>(y) + 0.5F) * kTexel;
            const float ring = portableSin(polar), height = portableCos(polar);
            for (int x = 0; x < kSkyWidth; ++x) {
                const Vec2 a = across[static_cast<std::size_t>(x)];
                image.at(x, y) += ground * (1 - partOfSky({ring * a.x, height, ring * a.y}));
            }
        }
    }

    /// On level ground, of the sky as far as it is painted.
    Colour fromSky() const {
        return {static_cast<float>(onGround_[0]), static_cast<float>(onGround_[1]),
                static_cast<float>(onGround_[2])};
    }

    /// What the sun and the sky light of the haze along a ray, which is white where enough of it is passed.
    void addHaze(HdrImage& image) {
        constexpr float kThickness = 0.025F; // straight up
        const Colour lit = (sunlight_ + fromSky() * 3.0F) / (4 * kPi);
        for (int y = 0; y < kHeight; ++y) {
            const float polar = (static_cast<float>(y) + 0.5F) * kTexel;
            const float ring = portableSin(polar), height = portableCos(polar);
            const float part = std::clamp(0.5F + height / kTexel, 0.0F, 1.0F);
            if (part == 0) break;
            const Colour added = lit * ((1 - portableExp(-kThickness * airMass(height))) * part);
            const double weight =
                kSkyWidth * static_cast<double>(std::max(height, 0.0F) * ring * kTexel * kTexel);
            onGround_[0] += weight * static_cast<double>(added.r);
            onGround_[1] += weight * static_cast<double>(added.g);
            onGround_[2] += weight * static_cast<double>(added.b);
            for (int x = 0; x < kSkyWidth; ++x) image.at(x, y) += added;
        }
    }
    /// How much more air a ray passes than one straight up. (Rozenberg 1966)
    static float airMass(float height) {
        const float sine = std::max(height, 0.0F);
        return 1 / (sine + 0.025F * portableExp(-11 * sine));
    }

    /// Towards the horizon, into what is seen just above it.
    static void fadeGround(HdrImage& image) {
        constexpr float kDepth = 0.026F; // sine of 1.5 degrees
        for (int y = kHeight / 2; y < kHeight; ++y) {
            const float polar = (static_cast<float>(y) + 0.5F) * kTexel;
            const float faded = portableExp(portableCos(polar) / kDepth);
            for (int x = 0; x < kSkyWidth; ++x) {
                const Colour sky = image.at(x, kHeight / 2 - 1);
                image.at(x, y) += (sky - image.at(x, y)) * faded;
            }
        }
    }

    Vec3 up_, sun_, aboveHorizon_;
    ClearSky air_;
    float scale_;
    Colour sunlight_;
    bool haze_;
    float albedo_;
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
