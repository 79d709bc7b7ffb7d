#include "rtserver/commands/side_work.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/threads.h"

#include <algorithm>
#include <utility>

namespace rtserver {

namespace {

constexpr std::size_t kMax = 64; ///< twice as many as there can be clients

Finish resultOf(DetachedTask<Finish>& task) {
    try {
        return task.take();
    } catch (...) {
        return [error = std::current_exception()]() -> std::string { std::rethrow_exception(error); };
    }
}

} // namespace

int threadsBeside(int threads) { return std::max(1, rtcore::threadsFor(threads) / 2); }

void SideWork::start(const ipc::Command& command, Work work, StopFlag stop, const std::string& shared) {
    if (!shared.empty() && joins(command, shared)) return;
    if (jobs_.size() >= kMax) {
        throw rtcore::FileError(rtcore::FailureKind::TryAgain, "",
                                "too many commands before it wait for files that do not answer");
    }
    jobs_.emplace_back(command, std::move(work), std::move(stop), shared);
}

bool SideWork::joins(const ipc::Command& command, const std::string& shared) {
    std::size_t others = 0;
    for (Job& job : jobs_) {
        others += job.shared.empty() ? 0 : 1;
        if (job.shared != shared || !job.isWanted()) continue; // one that was given up answers no more
        job.commands.push_back(command);
        return true;
    }
    if (others >= kMaxShared)
        throw rtcore::FileError(rtcore::FailureKind::TryAgain, "",
                                "others are being found out; ask again when they are there");
    return false;
}

void SideWork::stopWhere(const std::function<bool(const ipc::Command&)>& unwanted) const {
    for (const Job& job : jobs_) {
        if (job.stop && std::ranges::all_of(job.commands, unwanted)) *job.stop = true;
    }
}

bool SideWork::anyDone() const {
    return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& job) { return job.task.done(); });
}

std::vector<SideWork::Done> SideWork::takeDone() {
    std::vector<Done> done;
    std::erase_if(jobs_, [&](Job& job) {
        if (!job.task.done()) return false;
        const Finish finish = resultOf(job.task);
        for (ipc::Command& command : job.commands) done.push_back({std::move(command), finish});
        return true;
    });
    return done;
}

void SideWork::waitFor(std::chrono::nanoseconds time) const {
    const auto end = std::chrono::steady_clock::now() + time;
    for (const Job& job : jobs_) job.task.wait(end - std::chrono::steady_clock::now());
}

} // namespace rtserver
