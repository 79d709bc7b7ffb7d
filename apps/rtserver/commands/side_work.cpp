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

void SideWork::start(const ipc::Command& command, Work work, StopFlag stop) {
    if (jobs_.size() >= kMax) {
        throw rtcore::FileError(rtcore::FailureKind::TryAgain, "",
                                "too many commands before it wait for files that do not answer");
    }
    jobs_.emplace_back(command, std::move(work), std::move(stop));
}

void SideWork::stopWhere(const std::function<bool(const ipc::Command&)>& unwanted) const {
    for (const Job& job : jobs_) {
        if (job.stop && unwanted(job.command)) *job.stop = true;
    }
}

bool SideWork::anyDone() const {
    return std::any_of(jobs_.begin(), jobs_.end(), [](const Job& job) { return job.task.done(); });
}

std::vector<SideWork::Done> SideWork::takeDone() {
    std::vector<Done> done;
    std::erase_if(jobs_, [&](Job& job) {
        if (!job.task.done()) return false;
        done.push_back({std::move(job.command), resultOf(job.task)});
        return true;
    });
    return done;
}

void SideWork::waitFor(std::chrono::nanoseconds time) const {
    const auto end = std::chrono::steady_clock::now() + time;
    for (const Job& job : jobs_) job.task.wait(end - std::chrono::steady_clock::now());
}

} // namespace rtserver
