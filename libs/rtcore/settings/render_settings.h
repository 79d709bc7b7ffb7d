/// How a scene is rendered. Every field is described once more, with its range and help, by settings_table.h;
/// files, command lines and dialogs read that table, the renderer reads this struct.
#pragma once

#include "rtcore/settings/texel_filter.h"

namespace rtcore {

/// The method that follows the light: Whitted's rays (mirrors and glass, direct light), or paths, which also
/// bring the light that surfaces send to each other. Paths are for stills.
enum class Integrator { Whitted, Path };
/// Whether surfaces that emit light light others. Automatic: unless lights of the scene stand in their place.
enum class EmitterLight { Automatic, On, Off };
/// Live: light that surfaces send to each other, and that of the surroundings, is learned while one walks.
enum class IndirectMode { Off, Live };
/// Automatic: by the brightness of what is seen; Incident: by the light that falls on it, however dark or
/// bright it is itself.
enum class ExposureMode { Automatic, Fixed, Incident };
/// The use of the exposure in a .cam file, which suits Whitted's image: paths find more light. Scaled:
/// multiplied by the mean by paths over that by Whitted, both of the list's first frame.
enum class RecordedExposure { Scaled, Exact, Automatic };
enum class LightQuantity {
    Luminance,
    Illuminance ///< of the surface that a ray of the camera meets first, on the side that is seen
};
/// Luminance keeps hue and saturation (bright colours fade to white only at the very top), Channels maps each
/// of red, green and blue by itself; AgX (Sobotka 2022) is like film, with soft and pale lights, Neutral
/// (Khronos PBR Neutral, 2024) keeps the colours of all but the brightest.
enum class ToneMapping { Luminance, Channels, AgX, Neutral };
/// Where the samples of a pixel lie. (thesis figure 5.1)
enum class SamplingPattern { Grid, Random, Jittered, Rotated, Poisson };
/// Where the rays of a point go: a regular pattern turned and shifted for each point, the same for all
/// points, or anywhere. (thesis 7.1.5)
enum class OcclusionPattern { Rotated, Regular, Random };
enum class BloomKernel { Gaussian, Airy };
/// Trained nets that take the noise of paths away, from quick to good. Automatic: one that is there, else the
/// filter; only for images that no other machine has to repeat.
enum class DenoiseNet { Off, Small, Base, Large, Automatic };

struct AmbientOcclusionSettings {
    bool on = false;
    int samples = 9;    ///< rays per point
    float distance = 0; ///< scene units; 0 = 15 % of the scene's diagonal
    OcclusionPattern pattern = OcclusionPattern::Rotated;
    float light = 0; ///< radiance of ambient light; 0 = the scene's, or one that suits it when it has none

    friend bool operator==(const AmbientOcclusionSettings&, const AmbientOcclusionSettings&) = default;
};

/// Light that reaches surfaces from the environment, as far as nothing is in its way; in place of ambient
/// light and its occlusion.
struct SkyLightSettings {
    bool on = false;
    int samples = 16; ///< rays per point

    friend bool operator==(const SkyLightSettings&, const SkyLightSettings&) = default;
};

/// Settings of Integrator::Path.
struct PathSettings {
    int samples = 256;       ///< paths per pixel
    int bounces = 16;        ///< of a path, at most
    int rouletteFrom = 1;    ///< bounce from which a weak path may end by chance; what remains counts more
    float clampIndirect = 0; ///< radiance that a sample gets from one bounce after the first; 0 = any
    bool caustics = false;   ///< light that reaches a surface by way of mirrors and glass
    EmitterLight emitters = EmitterLight::Automatic;
    int seed = 0;              ///< another one gives other noise
    bool seedPerFrame = false; ///< of a list: its number is added to the seed, so that noise is not static
    int filter = 0;            ///< passes of the filter that smooths noise; 0 = DenoiseSettings::passes

    friend bool operator==(const PathSettings&, const PathSettings&) = default;
};

/// Light by way of surfaces in images by Whitted's rays, in place of ambient light, its occlusion and the
/// light of the sky.
struct IndirectSettings {
    IndirectMode mode = IndirectMode::Off;

    friend bool operator==(const IndirectSettings&, const IndirectSettings&) = default;
};

/// A thin lens on a film 36 mm wide.
struct DepthOfFieldSettings {
    bool on = false;
    float fNumber = 2.8F; ///< focal length over diameter of the lens
    float focus = 0;      ///< scene units along the axis to what is sharp; 0 = what is in the middle
    int blades = 0;       ///< corners of the aperture; 0 = round

    friend bool operator==(const DepthOfFieldSettings&, const DepthOfFieldSettings&) = default;
};

/// The fog itself is the scene's.
struct FogSettings {
    bool on = true;
    int shafts = 0; ///< shadow rays along each ray to each light; 0 = light in the fog is not shadowed

    friend bool operator==(const FogSettings&, const FogSettings&) = default;
};

/// Lights with a size, which throw soft shadows.
struct AreaLightSettings {
    int samples = 4; ///< shadow rays to each; 0 = they are points

    friend bool operator==(const AreaLightSettings&, const AreaLightSettings&) = default;
};

/// Smooths noise, but not edges.
struct DenoiseSettings {
    int passes = 0;                   ///< of the filter; 0 = off
    DenoiseNet net = DenoiseNet::Off; ///< in place of the filter, of Integrator::Path
    bool mix = true; ///< the net's image with the sampled one, by the errors of both: keepsHalves()

    friend bool operator==(const DenoiseSettings&, const DenoiseSettings&) = default;
};

/// Light that is spread around bright spots.
struct BloomSettings {
    int radius = 0; ///< standard deviation of the blur in pixels; 0 = off
    BloomKernel kernel = BloomKernel::Gaussian;
    float share = 0.15F; ///< of the light that is spread

    friend bool operator==(const BloomSettings&, const BloomSettings&) = default;
};

struct ExposureSettings {
    ExposureMode mode = ExposureMode::Automatic;
    float value = 1; ///< Fixed: the constant c of L = Y / (Y + c), in units of radiance
    float key =
        0.18F; ///< not Fixed: c is in inverse proportion to it, so a larger key makes the image brighter
    float brighterSeconds = 0.1F; ///< Automatic: time in which an eye gets used to 63 % of more light
    float darkerSeconds = 0.4F;   ///< and of less
    float local = 0;              ///< 0..1: how much of the exposure follows a pixel's own surroundings
    RecordedExposure recorded = RecordedExposure::Scaled; ///< of stills from .cam files

    friend bool operator==(const ExposureSettings&, const ExposureSettings&) = default;
};

/// Luminance or illuminance by the colours of a scale, in place of tone mapping, bloom and local exposure.
/// Ends of the scale are in cd/m^2 or lux where the light has an absolute unit, else radiance or irradiance.
struct FalseColourSettings {
    bool on = false;
    LightQuantity quantity = LightQuantity::Luminance;
    float from = 0; ///< 0 = by what is seen; so is an end that leaves less than the other one
    float to = 0;
    bool isolines = true;
    bool legend = true;

    /// Whether rays of the camera see white matte paper on all surfaces.
    bool seesWhite() const { return on && quantity == LightQuantity::Illuminance; }
    friend bool operator==(const FalseColourSettings&, const FalseColourSettings&) = default;
};

struct RenderSettings {
    int width = 640;      ///< pixels
    int height = 480;     ///< pixels
    int antialiasing = 1; ///< N: N x N samples per pixel
    SamplingPattern sampling = SamplingPattern::Grid;
    /// 0..1 of the display's range: a pixel whose samples and neighbours differ less gets a quarter of its
    /// samples; 0 = all alike.
    float adaptive = 0;
    bool shadows = true;
    bool reflections = true;
    bool refractions = true;
    bool textures = true;
    int maxDepth = 5;               ///< bounces by mirrors and glass
    float minContribution = 0.004F; ///< a ray that adds less than this fraction to its pixel is not traced
    Integrator integrator = Integrator::Whitted;
    PathSettings path;
    IndirectSettings indirect;
    AmbientOcclusionSettings ambientOcclusion;
    SkyLightSettings skyLight;
    DepthOfFieldSettings depthOfField;
    FogSettings fog;
    AreaLightSettings areaLights;
    DenoiseSettings denoise;
    BloomSettings bloom;
    ExposureSettings exposure;
    ToneMapping toneMapping = ToneMapping::Luminance;
    float toneContrast = 0; ///< 0..3, of ToneMapping::AgX: 0 its base, 1 its look "punchy", and beyond
    bool dithering = true;
    FalseColourSettings falseColours;
    TexelFilter environmentFilter = TexelFilter::Bilinear;

    friend bool operator==(const RenderSettings&, const RenderSettings&) = default;
};

/// Whether a net takes the noise of an image of those settings away.
inline bool denoisesByNet(const RenderSettings& settings) {
    return settings.integrator == Integrator::Path && settings.denoise.net != DenoiseNet::Off;
}

/// Samples of a pixel from which on the error of an image by a net is estimated.
inline constexpr int kEstimatedSamples = 16;
/// The same from which on it is mixed with the sampled one: the noise of fewer misses rare light.
inline constexpr int kMixedSamples = 64;

/// The same from which on a net's image is mixed with a steady one by the errors of both.
inline constexpr int kSteadySamples = 4;

/// Whether a net's image is mixed with a steady one: Whitted's rays with indirect light.
inline bool mixesSteadyImage(const RenderSettings& settings) {
    return denoisesByNet(settings) && settings.denoise.mix && settings.indirect.mode == IndirectMode::Live;
}

/// Whether the samples of an image of those settings are kept in halves, by which a net's error is known.
inline bool keepsHalves(const RenderSettings& settings) {
    const int minimum = mixesSteadyImage(settings) ? kSteadySamples : kEstimatedSamples;
    return denoisesByNet(settings) && settings.denoise.mix && settings.path.samples >= minimum;
}

/// Passes of the filter that smooths the noise of an image of those settings.
inline int filterPasses(const RenderSettings& settings) {
    if (denoisesByNet(settings)) return 0;
    const bool own = settings.integrator == Integrator::Path && settings.path.filter > 0;
    return own ? settings.path.filter : settings.denoise.passes;
}

} // namespace rtcore
