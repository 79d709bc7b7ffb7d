#include "renderer/frame_check.h"

#include "common/process/stop.h"
#include "common/progress/progress.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

namespace renderer {

namespace {

std::optional<FileFlaw> flawOf(int frame, const std::filesystem::path& file) {
    std::error_code ignored;
    if (isStandardOutput(file) || !std::filesystem::exists(file, ignored))
        return FileFlaw{frame, file, true, {}};
    try {
        const rtcore::FileBytes content = rtcore::openFileBytes(file);
        if (rtcore::isHdrFormat(file)) {
            rtcore::decodeHdrImage(content.bytes, "");
        } else {
            rtcore::decodeLdrImage(content.bytes, "");
        }
    } catch (const rtcore::FileError& error) {
        if (error.kind == rtcore::FailureKind::TryAgain)
            throw rtcore::FileError(error.kind, file.string(), error.sentence());
        return FileFlaw{frame, file, false, error.sentence()};
    }
    return std::nullopt;
}

std::vector<FileFlaw> flawsOf(const FrameTask& frame) {
    std::vector<FileFlaw> flaws;
    for (const std::filesystem::path& file : frame.outputs) {
        if (auto flaw = flawOf(frame.number, file)) flaws.push_back(std::move(*flaw));
    }
    return flaws;
}

// Frames are handed out one by one, since some take longer than others.
class Check {
  public:
    explicit Check(std::span<const FrameTask> frames) : frames_(frames), flaws_(frames.size()) {}

    void run(int threads) {
        std::vector<std::jthread> helpers;
        for (int i = 1; i < threads; ++i) helpers.emplace_back([this] { work(); });
        work();
        helpers.clear();
        if (error_) std::rethrow_exception(error_);
        app::throwIfStopped();
    }
    double fraction() const {
        return static_cast<double>(std::min(next_.load(), frames_.size())) /
               static_cast<double>(frames_.size());
    }
    std::vector<FileFlaw> take() {
        std::vector<FileFlaw> all;
        for (auto& flaws : flaws_) std::move(flaws.begin(), flaws.end(), std::back_inserter(all));
        return all;
    }

  private:
    void work() {
        try {
            for (std::size_t i = next_++; i < frames_.size() && !app::stopRequested(); i = next_++) {
                flaws_[i] = flawsOf(frames_[i]);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            error_ = std::current_exception();
            next_ = frames_.size();
        }
    }

    std::span<const FrameTask> frames_;
    std::vector<std::vector<FileFlaw>> flaws_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr error_;
};

} // namespace

std::vector<FileFlaw> findFlaws(std::span<const FrameTask> frames, int threads, app::Progress& progress) {
    if (frames.empty()) return {};
    if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    Check check(frames);
    const app::ProgressScope scope(progress, {"checking", [&] { return check.fraction(); }, nullptr});
    check.run(threads);
    return check.take();
}

} // namespace renderer
