#include "rtcore/render/view_steps.h"

#include "rtcore/sampling/pixel_turn.h"

#include <algorithm>

namespace rtcore {

namespace {

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
    renderer_.lightIndirectlyFrom(&light);
    radiance_.resize(pixels.size());
    RayStatistics statistics;
    if (!renderer_.renderPixels({dark, view.tracer, view.camera, settings}, pixels, control, {radiance_},
                                statistics))
        return false;
    const std::span<const IndirectTap> taps = renderer_.taps();
    receivers_.resize(taps.size());
    arriving_.resize(taps.size());
    std::ranges::transform(taps, receivers_.begin(), &IndirectTap::receiver);
    if (!light.step(receivers_, arriving_, budget, control.threads, &control.cancel)) return false;
    alongLobes_.resize(renderer_.lobes().size());
    light.learnLobes(renderer_.lobes(), alongLobes_, budget.lobePaths(), control.threads);
    return true;
}

bool ViewSteps::stepOfTurn(const View& view, std::uint32_t turn, std::uint32_t turns,
                           const GatherBudget& budget, RenderControl& control, IndirectLight& light) {
    return step(view, pixelsOfTurn(view.settings, turn, turns), budget, control, light);
}

bool ViewSteps::learnEnough(const View& view, const GatherBudget& budget, RenderControl& control,
                            IndirectLight& light) {
    constexpr std::uint32_t kMaxSteps = 32;
    constexpr double kPixels = 1 << 16; // of a step, about
    constexpr std::uint32_t kFew = 16;  // part of the rays: some places never have records enough
    const double pixels = double{static_cast<float>(view.settings.width)} * view.settings.height;
    const auto turns = static_cast<std::uint32_t>(std::clamp(pixels / kPixels, 1.0, double{kMaxSteps}));
    for (std::uint32_t i = 0; i < kMaxSteps; ++i) {
        if (!stepOfTurn(view, i % turns, turns, budget, control, light)) return false;
        if (light.learned().rays < budget.rays / kFew) break;
    }
    return true;
}

} // namespace rtcore
