#include "rtcore/sky/sky_light.h"

#include "rtcore/math/constants.h"
#include "rtcore/scene/sphere_texels.h"
#include "rtcore/simd/portable_math.h"
#include "rtcore/sky/atmosphere.h"
#include "rtcore/sky/sun_position.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr int kHeight = kSkyWidth / 2;
constexpr float kTexel = kPi / kHeight; ///< radians

/// Calls paint(texel, direction, ring) for all texels of an equirectangular map, row by row; `direction` is
/// of unit length, `ring` the sine of its angle to the y axis.
template <typename Paint>
void forEachTexel(HdrImage& image, Paint&& paint) {
    const SphereTexels texels(image.height);
    for (int y = 0; y < image.height; ++y) {
        const SphereTexels::Row row = texels.row(y);
        for (int x = 0; x < image.width; ++x) paint(image.at(x, y), texels.direction(row, x), row.ring);
    }
}

/// The one that is seen in that direction.
Colour nearestTexel(const HdrImage& image, Vec3 direction) {
    const float texel = kPi / static_cast<float>(image.height);
    const float polar =
        portableAtan2(std::sqrt(direction.x * direction.x + direction.z * direction.z), direction.y);
    const float azimuth = portableAtan2(direction.x, -direction.z);
    const auto at = [&](float angle, int count) {
        return std::clamp(static_cast<int>(angle / texel), 0, count - 1);
    };
    return image.at(at(azimuth + kPi, image.width), at(polar, image.height));
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
        forEachTexel(image,
                     [&](Colour& texel, Vec3 direction, float ring) { texel = skyIn(direction, ring); });
        if (haze_) addHaze(image);
        addGround(image);
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

    void addGround(HdrImage& image) const {
        const Colour irradiance = fromSky() + sunlight_ * std::max(dot(sun_, up_), 0.0F);
        const Colour ground = irradiance * (albedo_ / kPi);
        forEachTexel(image, [&](Colour& texel, Vec3 direction, float) {
            texel += ground * (1 - partOfSky(direction));
        });
    }

    /// On level ground, of the sky as far as it is painted.
    Colour fromSky() const {
        return {static_cast<float>(onGround_[0]), static_cast<float>(onGround_[1]),
                static_cast<float>(onGround_[2])};
    }

    /// Adds the light of sun and sky that haze scatters along a ray; it is white where enough haze is passed.
    void addHaze(HdrImage& image) {
        const Colour lit = (sunlight_ + fromSky() * 3.0F) / (4 * kPi);
        forEachTexel(
            image, [&](Colour& texel, Vec3 direction, float) { texel += hazeIn(lit, dot(direction, up_)); });
        const SphereTexels texels(kHeight);
        for (int y = 0; y < kHeight; ++y) {
            const auto [ring, height] = texels.row(y);
            const Colour added = hazeIn(lit, height);
            const double weight =
                kSkyWidth * static_cast<double>(std::max(height, 0.0F) * ring * kTexel * kTexel);
            onGround_[0] += weight * static_cast<double>(added.r);
            onGround_[1] += weight * static_cast<double>(added.g);
            onGround_[2] += weight * static_cast<double>(added.b);
        }
    }
    /// Along a ray that rises by `height`; nothing below the horizon.
    static Colour hazeIn(Colour lit, float height) {
        constexpr float kThickness = 0.025F; // straight up
        const float part = std::clamp(0.5F + height / kTexel, 0.0F, 1.0F);
        if (part == 0) return {};
        return lit * ((1 - portableExp(-kThickness * airMass(height))) * part);
    }
    /// How much more air a ray passes than one straight up. (Rozenberg 1966)
    static float airMass(float height) {
        const float sine = std::max(height, 0.0F);
        return 1 / (sine + 0.025F * portableExp(-11 * sine));
    }

    /// Towards the horizon, into what is seen just above it.
    void fadeGround(HdrImage& image) const {
        constexpr float kDepth = 0.026F; // sine of 1.5 degrees
        const HdrImage sky = image;
        forEachTexel(image, [&](Colour& texel, Vec3 direction, float) {
            const float height = dot(direction, up_);
            if (!(height < 0)) return;
            const Vec3 above = normalize(direction - up_ * height) + up_ * (0.5F * kTexel);
            texel += (nearestTexel(sky, above) - texel) * portableExp(height / kDepth);
        });
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

/// By height alone: floor and walls of radiance 1, which fade into a ceiling that leaves room for what lights
/// show of themselves in lacquer and chrome.
HdrImage studioMap(float strength, Vec3 up) {
    constexpr int kStudioHeight = 128;
    constexpr float kCeiling = 0.18F, kWallEnds = 0.05F, kCeilingBegins = 0.75F; // heights: sines
    HdrImage image(2 * kStudioHeight, kStudioHeight);
    forEachTexel(image, [&](Colour& texel, Vec3 direction, float) {
        const float t =
            std::clamp((dot(direction, up) - kWallEnds) / (kCeilingBegins - kWallEnds), 0.0F, 1.0F);
        texel = kWhite * (strength * (1 + (kCeiling - 1) * t * t * (3 - 2 * t)));
    });
    return image;
}

std::shared_ptr<const Environment> environmentOf(const HdrImage& map, const char* name) {
    return std::make_shared<const Environment>(Environment::fromEquirectangular(map, name));
}

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
    if (sky.studio) return {environmentOf(studioMap(sky.strength, up), "studio"), std::nullopt};
    return {environmentOf(SkyPainter(sky, up, sunDirection(sky, up)).paint(), "sky"), sunOfSky(sky, up)};
}

} // namespace rtcore
