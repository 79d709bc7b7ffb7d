#include "renderer/list_follower.h"

#include "common/process/stop.h"
#include "common/progress/progress.h"

#include "rtcore/io/recording/camera_list.h"
#include "rtcore/platform/error.h"

#include <chrono>
#include <thread>
#include <utility>

namespace renderer {

namespace {

using namespace std::chrono_literals;

constexpr auto kLook = 50ms;

} // namespace

ListFollower::ListFollower(std::filesystem::path list, double timeoutSeconds)
    : list_(std::move(list)), timeoutSeconds_(timeoutSeconds) {}

std::vector<std::filesystem::path> ListFollower::waitBeyond(std::size_t known, app::Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    const app::ProgressScope scope(progress, {"waiting for frames", {}, nullptr});
    while (true) {
        app::throwIfStopped();
        rtcore::GrowingCameraList list = rtcore::readGrowingCameraList(list_);
        if (list.cameras.size() < known) {
            throw rtcore::FileError(rtcore::FailureKind::BadData, list_.string(),
                                    "the list has become shorter while it was followed; start again");
        }
        ended_ = list.ended;
        const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - start;
        if (ended_ || list.cameras.size() > known || waited.count() >= timeoutSeconds_) {
            return std::move(list.cameras);
        }
        std::this_thread::sleep_for(kLook);
    }
}

} // namespace renderer
