#include "rtserver/scene_load.h"

#include "common/threads.h"

#include "rtcore/platform/error.h"

#include <chrono>
#include <utility>

namespace rtserver {

SceneLoad::SceneLoad(std::filesystem::path path, std::optional<std::filesystem::path> built,
                     const rtcore::ImportOptions& import, int threads)
    : result_(std::async(std::launch::async, [this, path = std::move(path), built = std::move(built), import,
                                              threads] { return load(path, built, import, threads); })) {}

SceneLoad::~SceneLoad() {
    cancel();
    if (result_.valid()) result_.wait();
}

void SceneLoad::cancel() {
    stop_ = true;
    build_.cancel = true;
}

bool SceneLoad::done() const {
    return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

float SceneLoad::fraction() const {
    const std::uint64_t all = build_.triangles.load();
    return all == 0 ? 0.0F : static_cast<float>(build_.finished.load()) / static_cast<float>(all);
}

std::unique_ptr<World> SceneLoad::load(std::filesystem::path path, std::optional<std::filesystem::path> built,
                                       rtcore::ImportOptions import, int threads) {
    app::useThreads(threads);
    rtcore::LoadOptions options;
    options.build.threads = threads;
    options.buildProgress = &build_;
    options.primaryRays = 1; // the first frame is waited for; the exact tree comes after it
    options.built = std::move(built);
    options.import = import;
    options.import.stop = &stop_;
    options.onPhase = [this](rtcore::LoadPhase) {
        if (stop_) throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    };
    try {
        rtcore::LoadedScene loaded = rtcore::loadScene(path, options);
        return std::make_unique<World>(std::move(loaded), std::move(path), import);
    } catch (const rtcore::BuildCancelled&) {
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    }
}

} // namespace rtserver
