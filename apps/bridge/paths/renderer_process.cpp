#include "bridge/paths/renderer_process.h"

#include "bridge/helper_program.h"

#include "common/cli/instance_option.h"
#include "common/process/resting_image.h"

#include "ipc/endpoint/instances.h"
#include "ipc/platform/error.h"
#include "ipc/platform/system.h"

#include <fmt/core.h>

#include <cstdlib>
#include <utility>
#include <vector>

namespace bridge {

namespace {

constexpr double kKept = 600; ///< seconds for which a Renderer holds its model for the next image

std::string nextInstance() {
    static int number = 0; // of the thread of the sockets
    return fmt::format("{}{}-{}", app::kPreviewPrefix, ipc::processId(), ++number);
}

std::filesystem::path folderOfSession() {
    const char* const session = std::getenv("XDG_RUNTIME_DIR"); // NOLINT(concurrency-mt-unsafe)
    return session != nullptr && *session == '/' ? std::filesystem::path(session)
                                                 : std::filesystem::temp_directory_path();
}

} // namespace

RendererProcess::RendererProcess(const Clock& clock) : clock_(clock), instance_(nextInstance()) {}

RendererProcess::~RendererProcess() {
    if (!process_) return;
    process_.reset();
    try {
        ipc::freeInstance(instance_); // of one that was killed
    } catch (const ipc::Error&) {
        return; // it lives, or the next one of that name will do it
    }
}

std::string RendererProcess::file(const std::string& name) {
    if (!folder_) folder_ = std::make_unique<rtcore::TemporaryFolder>(folderOfSession(), "rtsuite-page-");
    std::string& path = files_[name];
    if (path.empty()) path = folder_->file(name).string();
    return path;
}

void RendererProcess::render(std::uint64_t run, const std::string& scene, const std::string& camera) {
    used_ = clock_.seconds();
    if (!process_) return launch({run, scene, camera});
    if (!ending_ && process_->write(app::standByRequest(run, scene, camera))) return;
    order_ = {run, scene, camera};
    end();
}

void RendererProcess::launch(const Order& order) {
    std::vector<std::string> words = app::standByOptions(instance_, ipc::processId());
    for (const std::string& each : app::restingPathOptions(app::kRestingFilter, true)) words.push_back(each);
    words.insert(words.end(),
                 {fmt::format("--run-id={}", order.run), "--camera=" + order.camera, "--", order.scene});
    process_ = std::make_unique<app::StartedProcess>(helperProgram("Renderer", "RT_RENDERER"), words,
                                                     app::StartedProcess::Role::Helper);
    ending_ = false;
}

void RendererProcess::giveUp() {
    order_.reset();
    if (process_ && !ending_) process_->write(app::kNoRequest);
}

void RendererProcess::end() {
    if (!std::exchange(ending_, true)) process_->askToStop();
}

int RendererProcess::tick(bool wanted) {
    if (wanted) used_ = clock_.seconds();
    if (!process_) return 0;
    const std::optional<int> code = process_->ended();
    if (!code) {
        if (clock_.seconds() - used_ > kKept) end();
        return 0;
    }
    process_.reset();
    const bool wasAsked = std::exchange(ending_, false);
    if (order_) launch(*std::exchange(order_, std::nullopt));
    return wasAsked ? 0 : *code;
}

} // namespace bridge
