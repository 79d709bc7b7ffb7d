#include "bench/rtbench/scene_loading.h"

#include "common/process/stop.h"

#include "rtcore/platform/error.h"

#include <atomic>

namespace rtbench {

rtcore::LoadedScene loadForBench(const std::filesystem::path& path, const BenchOptions& options,
                                 app::Progress& progress) {
    std::atomic<bool> stopImport{false};
    rtcore::BuildProgress build;
    rtcore::LoadOptions load;
    if (options.fast) load.build.method = rtcore::BuildMethod::Fast;
    load.buildProgress = &build;
    load.import = options.import;
    load.import.stop = &stopImport;
    const std::string name = path.filename().string();
    load.onPhase = [&](rtcore::LoadPhase phase) {
        app::throwIfStopped();
        if (phase == rtcore::LoadPhase::ImportingModel)
            progress.begin({"importing " + name, {}, &stopImport});
        if (phase == rtcore::LoadPhase::BuildingTree)
            progress.begin({"building the tree of " + name, {}, &build.cancel});
    };
    try {
        rtcore::LoadedScene loaded = rtcore::loadScene(path, load);
        progress.end();
        return loaded;
    } catch (const rtcore::BuildCancelled&) {
        progress.end(false);
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    } catch (...) {
        progress.end(false);
        throw;
    }
}

} // namespace rtbench
