#include "rtserver/frames/scene_load.h"

#include "common/process/threads.h"

#include "rtcore/platform/error.h"

#include <chrono>
#include <cstdint>
#include <utility>

namespace rtserver {

namespace {
constexpr auto kImportPatience = std::chrono::seconds(1);
} // namespace

SceneLoad::SceneLoad(const std::filesystem::path& path,
                     const std::optional<std::filesystem::path>& cachedModel,
                     const rtcore::ImportOptions& import, const rtcore::LightingOptions& lighting,
                     int threads)
    : progress_(std::make_shared<Progress>()),
      task_([progress = progress_, path, cachedModel, import, lighting, threads] {
          return load(*progress, path, cachedModel, import, lighting, threads);
      }) {}

SceneLoad::~SceneLoad() {
    progress_->stop = true;
    progress_->build.cancel = true;
    task_.wait(kImportPatience);
}

float SceneLoad::fraction() const {
    const rtcore::BuildProgress& build = progress_->build;
    const std::uint64_t all = build.triangles.load();
    return all == 0 ? 0.0F : static_cast<float>(build.finished.load()) / static_cast<float>(all);
}

std::unique_ptr<World> SceneLoad::load(Progress& progress, const std::filesystem::path& path,
                                       const std::optional<std::filesystem::path>& cachedModel,
                                       const rtcore::ImportOptions& import,
                                       const rtcore::LightingOptions& lighting, int threads) {
    app::useThreads(threads);
    rtcore::LoadOptions options;
    options.build.threads = threads;
    options.buildProgress = &progress.build;
    options.primaryRays = 1; // the first frame is waited for; the exact tree comes after it
    options.cachedModel = cachedModel;
    options.import = import;
    options.lighting = lighting;
    options.import.stop = &progress.stop;
    options.onPhase = [&progress](rtcore::LoadPhase) {
        if (progress.stop) throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    };
    try {
        rtcore::LoadedScene loaded = rtcore::loadScene(path, options);
        return std::make_unique<World>(std::move(loaded), path, import);
    } catch (const rtcore::BuildCancelled&) {
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    }
}

} // namespace rtserver
