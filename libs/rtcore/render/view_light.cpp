#include "rtcore/render/view_light.h"

#include "rtcore/sampling/pixel_turn.h"

#include <algorithm>

namespace rtcore {

namespace {

/// Steps, and those in which all pixels have their turn; of images that are measured, not seen, too.
constexpr std::uint32_t kSteps = 48, kSweep = 16, kStepsOfSmall = 8;
constexpr int kSmall = 64 * 64; ///< pixels
/// Of a step of an image of kUsual pixels; of others by their size, within bounds.
constexpr GatherBudget kBudget{65536, 6144};
constexpr GatherBudget kOfSmall{16384, 1536};
constexpr double kUsual = 1024 * 621, kMinOfUsual = 0.25, kMaxOfUsual = 4;

GatherBudget budgetOf(const RenderSettings& settings) {
    const double pixels = double{static_cast<float>(settings.width)} * settings.height;
    const double times = std::clamp(pixels / kUsual, kMinOfUsual, kMaxOfUsual);
    return {static_cast<std::uint32_t>(kBudget.rays * times),
            static_cast<std::uint32_t>(kBudget.paths * times)};
}

/// The view whose points alone are wanted, not their light.
Scene unlit(const Scene& scene) {
    Scene dark = scene;
    dark.lights.clear();
    dark.fog = {};
    return dark;
}
RenderSettings oneSample(const RenderSettings& settings) {
    RenderSettings one = settings;
    one.antialiasing = 1;
    one.sampling = SamplingPattern::Grid;
    one.adaptive = 0;
    return one;
}

/// Those of an image whose turn it is, square by square: what is near follows each other.
std::vector<SampleId> pixelsOfTurn(const RenderSettings& settings, std::uint32_t turn, std::uint32_t turns) {
    constexpr int kSide = 8;
    std::vector<SampleId> pixels;
    const int width = settings.width, height = settings.height;
    for (int top = 0; top < height; top += kSide) {
        for (int left = 0; left < width; left += kSide) {
            for (int y = top; y < std::min(top + kSide, height); ++y) {
                for (int x = left; x < std::min(left + kSide, width); ++x) {
                    if (turnOf(x, y) * turns / kTurns == turn)
                        pixels.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), 0});
                }
            }
        }
    }
    return pixels;
}

} // namespace

bool ViewSteps::step(const View& view, std::span<const SampleId> pixels, const GatherBudget& budget,
                     RenderControl& control, IndirectLight& light) {
    const Scene dark = unlit(view.scene);
    const RenderSettings settings = oneSample(view.settings);
    renderer_.lightIndirectlyFrom(&light.cache());
    radiance_.resize(pixels.size());
    RayStatistics statistics;
    if (!renderer_.renderPixels({dark, view.tracer, view.camera, settings}, pixels, control, {radiance_},
                                statistics))
        return false;
    const std::span<const IndirectTap> taps = renderer_.taps();
    receivers_.resize(taps.size());
    arriving_.resize(taps.size());
    std::ranges::transform(taps, receivers_.begin(), &IndirectTap::receiver);
    return light.step(receivers_, arriving_, budget, control.threads, &control.cancel);
}

bool ViewLight::learn(const View& view, RenderControl& control) {
    done_ = 0;
    light_.begin(view.scene, view.tracer, view.settings);
    const bool small = view.settings.width * static_cast<std::int64_t>(view.settings.height) <= kSmall;
    const std::uint32_t steps = small ? kStepsOfSmall : kSteps, sweep = std::min(steps, kSweep);
    const GatherBudget budget = small ? kOfSmall : budgetOf(view.settings);
    for (std::uint32_t step = 0; step < steps; ++step) {
        const std::vector<SampleId> pixels = pixelsOfTurn(view.settings, step % sweep, sweep);
        if (!steps_.step(view, pixels, budget, control, light_)) return false;
        done_ = static_cast<float>(step + 1) / static_cast<float>(steps);
    }
    return true;
}

} // namespace rtcore
