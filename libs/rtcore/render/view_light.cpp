#include "rtcore/render/view_light.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// Steps: at most; so many if records are as good as kGoodError then; and those in which all pixels have
/// their turn. Of images that are measured, not seen: so many.
constexpr std::uint32_t kMaxSteps = 96, kMinSteps = 48, kSweep = 16, kStepsOfSmall = 8;
constexpr double kGoodError = 0.04; ///< IndirectLight::Learned::error; several records are mixed
constexpr int kSmall = 64 * 64;     ///< pixels
/// Of a step of an image of kUsual pixels. Of others by the root of that, within bounds: a small one sees as
/// much of the scene, and a large one lacks records at edges alone.
constexpr GatherBudget kBudget{65536, 6144};
constexpr GatherBudget kOfSmall{16384, 1536};
constexpr std::uint32_t kEnough = 4; ///< passes of records that kept light lacks
constexpr double kUsual = 1024 * 621, kMinOfUsual = 0.25, kMaxOfUsual = 4;

GatherBudget budgetOf(const RenderSettings& settings) {
    const double pixels = double{static_cast<float>(settings.width)} * settings.height;
    const double times = std::clamp(std::sqrt(pixels / kUsual), kMinOfUsual, kMaxOfUsual);
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
    const std::uint32_t steps = small ? kStepsOfSmall : kMaxSteps, sweep = std::min(steps, kSweep);
    const std::uint32_t min = small ? kStepsOfSmall : kMinSteps;
    const GatherBudget budget = small ? kOfSmall : budgetOf(view.settings);
    for (std::uint32_t step = 0; step < steps; ++step) {
        if (!steps_.stepOfTurn(view, step % sweep, sweep, budget, control, light_)) return false;
        done_ = static_cast<float>(step + 1) / static_cast<float>(steps);
        if (step + 1 >= min && light_.learned().error < kGoodError) break;
    }
    return true;
}

} // namespace rtcore
