#include "renderer/light_making.h"

#include "rtcore/io/light/light_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <filesystem>

namespace renderer {

namespace {

/// Goes on from the file, if that is of this scene. One that is no file of light is not written over.
void takeUp(const std::filesystem::path& path, const rtcore::LightKey& key, rtcore::LearnedLight& light,
            app::Progress& progress) {
    if (!std::filesystem::exists(path)) return;
    const rtcore::LightFile file = rtcore::readLightFile(path, key);
    if (file.match == rtcore::LightMatch::Same) {
        light.restore(file.light);
        progress.print(fmt::format("going on with {}", path.string()));
    } else {
        progress.tell(rtcore::say(
            "warning: {0}", rtcore::say("{0} is of another scene or light; it is made anew", path.string())));
    }
}

} // namespace

void makeLight(const std::filesystem::path& path, const LitScene& lit, std::span<const LightView> views,
               const LightBounds& bounds, int threads, app::Progress& progress) {
    const rtcore::LightKey key = rtcore::lightKeyOf(lit.scene, lit.tracer.bounds(), lit.settings);
    rtcore::LearnedLight light;
    light.begin(lit.scene, lit.tracer, lit.settings);
    takeUp(path, key, light, progress);
    const auto keep = [&] { rtcore::writeLightFile(path, key, light.state()); };
    const LearnedViews learned = learnViews(light, lit, views, bounds, threads, progress, keep);
    keep();
    progress.print(fmt::format("wrote {}: {} of {} views, {} records, {:.1f} MB", path.string(),
                               learned.views, views.size(), light.records(),
                               1e-6 * static_cast<double>(std::filesystem::file_size(path))));
    if (learned.stopped)
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "",
                                "stopped; what was learned is kept, and the same command goes on");
}

} // namespace renderer
