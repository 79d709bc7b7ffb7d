/// Loads a scene while the server goes on.
#pragma once

#include "rtserver/world.h"

#include "rtcore/accel/builder.h"

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>

namespace rtserver {

/// A thread of its own loads; all functions are for the one thread that has the object. The destructor gives
/// the load up.
class SceneLoad {
  public:
    /// `built`: as in rtcore::LoadOptions.
    SceneLoad(std::filesystem::path path, std::optional<std::filesystem::path> built,
              const rtcore::ImportOptions& import, int threads);
    ~SceneLoad();
    SceneLoad(const SceneLoad&) = delete;
    SceneLoad& operator=(const SceneLoad&) = delete;

    bool done() const;
    float fraction() const; ///< of the tree that is being built, 0..1
    /// Once, when done(). Throws what rtcore::loadScene throws.
    std::unique_ptr<World> take() { return result_.get(); }
    void cancel();

  private:
    std::unique_ptr<World> load(std::filesystem::path path, std::optional<std::filesystem::path> built,
                                rtcore::ImportOptions import, int threads);

    std::atomic<bool> stop_{false};
    rtcore::BuildProgress build_;
    std::future<std::unique_ptr<World>> result_; ///< last: its thread uses the others
};

} // namespace rtserver
