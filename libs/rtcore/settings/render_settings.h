/// How a scene is rendered. Every field is described once more, with its range and help, by settings_table.h;
/// files, command lines and dialogs read that table, the renderer reads this struct.
#pragma once

namespace rtcore {

enum class ExposureMode { Automatic, Fixed };
/// Luminance keeps hue and saturation (bright colours fade to white only at the very top), Channels maps each
/// of red, green and blue by itself.
enum class ToneMapping { Luminance, Channels };
enum class EnvironmentFilter { Bilinear, Nearest };

struct AmbientOcclusionSettings {
    bool on = false;
    int samples = 9;    ///< rays per point
    float distance = 0; ///< scene units; 0 = 15 % of the scene's diagonal
};

struct ExposureSettings {
    ExposureMode mode = ExposureMode::Automatic;
    float value = 1;   ///< Fixed: the constant c of L = Y / (Y + c), in units of radiance
    float key = 0.18F; ///< Automatic: c = average / key, so a larger key makes the picture brighter
};

struct RenderSettings {
    int width = 640;      ///< pixels
    int height = 480;     ///< pixels
    int antialiasing = 1; ///< N: N x N samples a pixel
    bool shadows = true;
    bool reflections = true;
    bool refractions = true;
    bool textures = true;
    int maxDepth = 5;               ///< bounces by mirrors and glass
    float minContribution = 0.004F; ///< a ray that adds less than this share to its pixel is not traced
    AmbientOcclusionSettings ambientOcclusion;
    int bloom = 0; ///< radius of the blur in pixels; 0 = off
    ExposureSettings exposure;
    ToneMapping toneMapping = ToneMapping::Luminance;
    bool dithering = true;
    EnvironmentFilter environmentFilter = EnvironmentFilter::Bilinear;
};

} // namespace rtcore
