#include "renderer/light_learning.h"

#include "common/process/seconds_since.h"

#include "rtcore/io/light/light_file.h"

#include <atomic>
#include <chrono>

namespace renderer {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kKeepEvery = 60; ///< seconds
constexpr double kMegabyte = 1e6;

double megabytesOf(const rtcore::LearnedLight& light) {
    return static_cast<double>(rtcore::lightFileBytes(light.records(), light.cells())) / kMegabyte;
}

} // namespace

LearnedViews learnViews(rtcore::LearnedLight& light, const LitScene& lit, std::span<const LightView> views,
                        const LightBounds& bounds, int threads, app::Progress& progress,
                        const std::function<void()>& keep) {
    rtcore::RenderControl control{.threads = threads};
    std::atomic<std::size_t> done = 0;
    const auto all = static_cast<double>(views.size());
    const app::ProgressScope scope(progress, {.name = "learning indirect light",
                                              .fraction = [&] { return static_cast<double>(done) / all; },
                                              .cancel = &control.cancel});
    const Clock::time_point begun = Clock::now();
    Clock::time_point kept = begun;
    rtcore::RenderSettings settings = lit.settings;
    for (const LightView& view : views) {
        if (app::secondsSince(begun) >= bounds.seconds || megabytesOf(light) >= bounds.megabytes) break;
        settings.width = view.width;
        settings.height = view.height;
        if (!light.learn({lit.scene, lit.tracer, view.camera, settings}, control))
            return {.views = done, .stopped = true};
        ++done;
        if (!keep || app::secondsSince(kept) < kKeepEvery) continue;
        keep();
        kept = Clock::now();
    }
    return {.views = done, .stopped = false};
}

} // namespace renderer
