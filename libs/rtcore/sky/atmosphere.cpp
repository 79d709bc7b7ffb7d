#include "rtcore/sky/atmosphere.h"

#include "rtcore/math/constants.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr float kDegree = kPi / 180;
constexpr float kDegreesToTenth = 2.5F; ///< of the sun below the horizon
constexpr float kDiscRadius = 0.2666F;  ///< of the sun, degrees

float square(float x) { return x * x; }

/// CIE XYZ as linear sRGB (IEC 61966-2-1); what lies outside of its triangle loses its negative part.
Colour colourOf(double x, double y, double z) {
    const double r = 3.2404542 * x - 1.5371385 * y - 0.4985314 * z;
    const double g = -0.9692660 * x + 1.8760108 * y + 0.0415560 * z;
    const double b = 0.0556434 * x - 0.2040259 * y + 1.0572252 * z;
    return {static_cast<float>(std::max(r, 0.0)), static_cast<float>(std::max(g, 0.0)),
            static_cast<float>(std::max(b, 0.0))};
}

float elevationOf(float sinElevation) { return 90 - portableAcos(sinElevation) / kDegree; }

/// A cubic of the sun's zenith angle.
float cubic(float t, float c3, float c2, float c1, float c0) { return ((c3 * t + c2) * t + c1) * t + c0; }

float zenithX(float sun, float turbidity) {
    return cubic(sun, 0.00166F, -0.00375F, 0.00209F, 0) * square(turbidity) +
           cubic(sun, -0.02903F, 0.06377F, -0.03202F, 0.00394F) * turbidity +
           cubic(sun, 0.11693F, -0.21196F, 0.06052F, 0.25886F);
}

float zenithY(float sun, float turbidity) {
    return cubic(sun, 0.00275F, -0.00610F, 0.00317F, 0) * square(turbidity) +
           cubic(sun, -0.04214F, 0.08970F, -0.04153F, 0.00516F) * turbidity +
           cubic(sun, 0.15346F, -0.26756F, 0.06670F, 0.26688F);
}

/// A lobe with another width on either side.
double lobe(double nanometres, double middle, double below, double above) {
    const double t = (nanometres - middle) / (nanometres < middle ? below : above);
    return static_cast<double>(portableExp(static_cast<float>(-0.5 * t * t)));
}

struct Xyz {
    double x, y, z;
};

/// The CIE 1931 observer: Wyman, Sloan and Shirley, "Simple Analytic Approximations to the CIE XYZ Color
/// Matching Functions", JCGT 2 (2), 2013.
Xyz observer(double nanometres) {
    return {1.056 * lobe(nanometres, 599.8, 37.9, 31.0) + 0.362 * lobe(nanometres, 442.0, 16.0, 26.7) -
                0.065 * lobe(nanometres, 501.1, 20.4, 26.2),
            0.821 * lobe(nanometres, 568.8, 46.9, 40.5) + 0.286 * lobe(nanometres, 530.9, 16.3, 31.1),
            1.217 * lobe(nanometres, 437.0, 11.8, 36.0) + 0.681 * lobe(nanometres, 459.0, 26.0, 13.8)};
}

/// Irradiance above the air, W/m^2 for each nanometre.
double sunlight(double nanometres) {
    constexpr double kSolidAngle = 6.794e-5, kTemperature = 5778;
    const double metres = nanometres * 1e-9;
    const double power = metres * metres * metres * metres * metres;
    const double exponent = 0.014387769 / (metres * kTemperature);
    const double radiance =
        1.191042972e-16 / power / (static_cast<double>(portableExp(static_cast<float>(exponent))) - 1);
    return radiance * kSolidAngle * 1e-9;
}

constexpr int kFirst = 380, kLast = 780, kStep = 10; ///< nanometres

/// 1/cm, from 440 to 780 nanometres (table 2 of the paper); below that none.
constexpr std::array<float, 35> kOzone{0,      0.003F, 0.006F, 0.009F, 0.014F, 0.021F, 0.030F, 0.040F, 0.048F,
                                       0.063F, 0.075F, 0.085F, 0.103F, 0.120F, 0.120F, 0.115F, 0.125F, 0.120F,
                                       0.105F, 0.090F, 0.079F, 0.067F, 0.057F, 0.048F, 0.036F, 0.028F, 0.023F,
                                       0.018F, 0.014F, 0.011F, 0.010F, 0.009F, 0.007F, 0.004F, 0};
constexpr int kFirstOzone = 440;

/// Transmittance by cause.
struct Transmittance {
    float air, haze, ozone;
};

Transmittance transmittanceOf(int nanometres, float airMass, float turbidity) {
    const float micrometres = static_cast<float>(nanometres) * 1e-3F;
    const float air = 0.008735F * portablePow(micrometres, -4.08F);
    const float haze = (0.04608F * turbidity - 0.04586F) * portablePow(micrometres, -1.3F);
    const int row = (nanometres - kFirstOzone) / kStep;
    const float ozone = nanometres < kFirstOzone ? 0 : 0.35F * kOzone[static_cast<std::size_t>(row)];
    return {portableExp(-air * airMass), portableExp(-haze * airMass), portableExp(-ozone * airMass)};
}

/// Times the air above, of a sun that is not below the horizon.
float airMassOf(float sinElevation) {
    const float elevation = elevationOf(sinElevation);
    return 1 / (sinElevation + 0.15F * portablePow(3.885F + elevation, -1.253F));
}

/// Illuminance by sunlight of which fraction(transmittance) arrives; lux.
template <typename Fraction>
Xyz illuminance(float airMass, float turbidity, Fraction fraction) {
    Xyz sum{};
    for (int nanometres = kFirst; nanometres <= kLast; nanometres += kStep) {
        const double part = static_cast<double>(fraction(transmittanceOf(nanometres, airMass, turbidity)));
        const double light = sunlight(nanometres) * part * kStep * kLumensPerWatt;
        const Xyz seen = observer(nanometres);
        sum = {sum.x + light * seen.x, sum.y + light * seen.y, sum.z + light * seen.z};
    }
    return sum;
}

/// 0..1: how much of the disc is above the horizon.
float visiblePart(float elevation) { return std::clamp(0.5F + 0.5F * elevation / kDiscRadius, 0.0F, 1.0F); }

} // namespace

ClearSky::ClearSky(float sinElevation, float turbidity) {
    const float elevation = elevationOf(sinElevation), t = turbidity;
    const float sun = (90 - std::max(elevation, 0.0F)) * kDegree;
    const float night = portablePow(10, std::min(elevation, 0.0F) / kDegreesToTenth);
    perez_[0] = {0.1787F * t - 1.4630F, -0.3554F * t + 0.4275F, -0.0227F * t + 5.3251F,
                 0.1206F * t - 2.5771F, -0.0670F * t + 0.3703F, 1};
    perez_[1] = {-0.0193F * t - 0.2592F, -0.0665F * t + 0.0008F, -0.0004F * t + 0.2125F,
                 -0.0641F * t - 0.8989F, -0.0033F * t + 0.0452F, zenithX(sun, t)};
    perez_[2] = {-0.0167F * t - 0.2608F, -0.0950F * t + 0.0092F, -0.0079F * t + 0.2102F,
                 -0.0441F * t - 1.6537F, -0.0109F * t + 0.0529F, zenithY(sun, t)};
    for (Perez& p : perez_) p.scale /= (1 + p.a * portableExp(p.b)) * p.aroundSun(sun, portableCos(sun));
    const float shape = levelIlluminance(sun);
    perez_[0].scale *= night * skyIlluminance(std::max(sinElevation, 0.0F), t) / shape;
}

float ClearSky::Perez::aroundSun(float angle, float cosine) const {
    return 1 + c * portableExp(d * angle) + e * square(cosine);
}

float ClearSky::levelIlluminance(float sun) const {
    constexpr int kRows = 32, kColumns = 32; ///< of a quarter of all directions
    const float cosSun = portableCos(sun), sinSun = portableSin(sun);
    double sum = 0;
    for (int row = 0; row < kRows; ++row) {
        const float polar = (static_cast<float>(row) + 0.5F) * (kPi / 2 / kRows);
        const float across = portableSin(polar), above = portableCos(polar);
        const float part = height(above).part[0];
        for (int column = 0; column < kColumns; ++column) {
            const float azimuth = (static_cast<float>(column) + 0.5F) * (kPi / kColumns);
            const float cosine = above * cosSun + across * sinSun * portableCos(azimuth);
            sum += static_cast<double>(part * perez_[0].aroundSun(portableAcos(cosine), cosine) * above *
                                       across);
        }
    }
    return static_cast<float>(sum * (2 * double{kPi} / kColumns) * (double{kPi} / 2 / kRows));
}

ClearSky::Height ClearSky::height(float cosZenith) const {
    Height height{};
    for (std::size_t i = 0; i < 3; ++i)
        height.part[i] =
            perez_[i].scale * (1 + perez_[i].a * portableExp(perez_[i].b / std::max(cosZenith, 1e-3F)));
    return height;
}

Colour ClearSky::luminance(const Height& height, float cosSun) const {
    const float angle = portableAcos(cosSun);
    std::array<double, 3> value{};
    for (std::size_t i = 0; i < 3; ++i)
        value[i] =
            static_cast<double>(height.part[i]) * static_cast<double>(perez_[i].aroundSun(angle, cosSun));
    const auto [y, chromaX, chromaY] = value;
    return colourOf(chromaX / chromaY * y, y, (1 - chromaX - chromaY) / chromaY * y);
}

Colour sunIlluminance(float sinElevation, float turbidity) {
    const float visible = visiblePart(elevationOf(sinElevation));
    if (visible == 0) return {};
    const Xyz seen = illuminance(airMassOf(std::max(sinElevation, 0.0F)), turbidity,
                                 [](Transmittance t) { return t.air * t.haze * t.ozone; });
    return colourOf(seen.x, seen.y, seen.z) * visible;
}

// Near the horizon the inverse of the air mass, which does not vanish, stands for the sine.
float skyIlluminance(float sinElevation, float turbidity) {
    constexpr float kDownOfAir = 0.5F, kDownOfHaze = 0.84F, kOfBeam = 0.79F;
    const float mass = airMassOf(sinElevation);
    const Xyz seen = illuminance(mass, turbidity, [](Transmittance t) {
        return t.ozone * (kDownOfAir * (1 - t.air) + kDownOfHaze * (1 - t.haze));
    });
    return kOfBeam * static_cast<float>(seen.y) / mass / (1 - mass + portablePow(mass, 1.02F));
}

} // namespace rtcore
