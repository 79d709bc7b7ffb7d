/// Loads a scene while the server goes on.
#pragma once

#include "rtserver/detached_task.h"
#include "rtserver/document/world.h"

#include "rtcore/accel/builder.h"
#include "rtcore/io/scene_loader.h"

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

namespace rtserver {

/// A thread of its own loads; all functions are for the one thread that has the object. The destructor gives
/// the load up, and waits a little for its end, but not for a file that does not answer.
class SceneLoad {
  public:
    /// `cachedModel`: as in rtcore::LoadOptions.
    SceneLoad(const std::filesystem::path& path, const std::optional<std::filesystem::path>& cachedModel,
              const rtcore::ImportOptions& import, const rtcore::LightingOptions& lighting, int threads);
    ~SceneLoad();
    SceneLoad(const SceneLoad&) = delete;
    SceneLoad& operator=(const SceneLoad&) = delete;

    bool done() const { return task_.done(); }
    float fraction() const; ///< of the tree that is being built, 0..1
    /// Once, when done(). Throws what rtcore::loadScene throws.
    std::unique_ptr<World> take() { return task_.take(); }

  private:
    /// Shared with the thread.
    struct Progress {
        std::atomic<bool> stop{false};
        rtcore::BuildProgress build;
    };
    static std::unique_ptr<World> load(Progress& progress, const std::filesystem::path& path,
                                       const std::optional<std::filesystem::path>& cachedModel,
                                       const rtcore::ImportOptions& import,
                                       const rtcore::LightingOptions& lighting, int threads);

    std::shared_ptr<Progress> progress_;
    DetachedTask<std::unique_ptr<World>> task_;
};

} // namespace rtserver
