#include "rtcore/render/view_light.h"

#include <algorithm>

namespace rtcore {

namespace {

/// Steps, and those in which all pixels have their turn; of images that are measured, not seen, too.
constexpr std::uint32_t kSteps = 48, kSweep = 16, kStepsOfSmall = 8;
constexpr int kSmall = 64 * 64; ///< pixels
/// Of a step of an image of kUsual pixels; of others by their size, within bounds.
constexpr GatherBudget kBudget{65536, 6144};
constexpr GatherBudget kOfSmall{16384, 1536};
constexpr std::uint32_t kEnough = 4; ///< passes of records that kept light lacks
constexpr double kUsual = 1024 * 621, kMinOfUsual = 0.25, kMaxOfUsual = 4;

GatherBudget budgetOf(const RenderSettings& settings) {
    const double pixels = double{static_cast<float>(settings.width)} * settings.height;
    const double times = std::clamp(pixels / kUsual, kMinOfUsual, kMaxOfUsual);
    return {static_cast<std::uint32_t>(kBudget.rays * times),
            static_cast<std::uint32_t>(kBudget.paths * times)};
}

} // namespace

bool ViewLight::learn(const View& view, RenderControl& control) {
    done_ = 0;
    light_.begin(view.scene, view.tracer, view.settings);
    return kept_ != nullptr ? learnWhatLacks(view, control) : learnAll(view, control);
}

bool ViewLight::learnWhatLacks(const View& view, RenderControl& control) {
    light_.restore(*kept_);
    const GatherBudget budget{kBudget.rays, kBudget.paths, kEnough};
    if (!steps_.learnEnough(view, budget, control, light_)) return false;
    done_ = 1;
    return true;
}

bool ViewLight::learnAll(const View& view, RenderControl& control) {
    const bool small = view.settings.width * static_cast<std::int64_t>(view.settings.height) <= kSmall;
    const std::uint32_t steps = small ? kStepsOfSmall : kSteps, sweep = std::min(steps, kSweep);
    const GatherBudget budget = small ? kOfSmall : budgetOf(view.settings);
    for (std::uint32_t step = 0; step < steps; ++step) {
        if (!steps_.stepOfTurn(view, step % sweep, sweep, budget, control, light_)) return false;
        done_ = static_cast<float>(step + 1) / static_cast<float>(steps);
    }
    return true;
}

} // namespace rtcore
