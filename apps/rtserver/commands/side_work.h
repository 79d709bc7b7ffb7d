/// Commands that read and write files, done beside the server, which answers meanwhile.
#pragma once

#include "rtserver/detached_task.h"

#include "ipc/endpoint/server.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

/// An answer to a client, and the same for programs (ipc::Reply), "" where they need nothing but the text.
struct Answer {
    Answer(std::string told = {}, std::string forPrograms = {})
        : text(std::move(told)), detail(std::move(forPrograms)) {}
    std::string text, detail;
};

/// In the server's thread, when the work is over; gives the answer. Both may throw what a command may throw.
using Finish = std::function<Answer()>;
/// In a thread of its own: owns what it uses.
using Work = std::function<Finish()>;
/// Set by the server's thread: the work is wanted no more, and ends soon. May be null.
using StopFlag = std::shared_ptr<std::atomic<bool>>;

/// How many of a server's threads (0: all cores) long work beside the walk takes: half of them.
int threadsBeside(int threads);

/// One thread.
class SideWork {
  public:
    /// Throws rtcore::FileError TryAgain when too many are under way, which then wait for something that
    /// does not come. Where `shared` is not "", work of that name that is under way answers this command,
    /// too, whose own is dropped; and kMaxShared works of such names are under way at most.
    void start(const ipc::Command& command, Work work, StopFlag stop = {}, const std::string& shared = {});
    static constexpr std::size_t kMaxShared = 6;
    /// Gives up the work for commands of which `unwanted` says so: of all that it answers.
    void stopWhere(const std::function<bool(const ipc::Command&)>& unwanted) const;
    bool underWay() const { return !jobs_.empty(); }
    bool anyDone() const;

    struct Done {
        ipc::Command command;
        Finish finish; ///< throws what the work threw, if it did
    };
    std::vector<Done> takeDone();
    /// Waits at most so long for all of them.
    void waitFor(std::chrono::nanoseconds time) const;

  private:
    struct Job {
        Job(const ipc::Command& of, Work work, StopFlag flag, std::string sharedName)
            : commands{of}, task(std::move(work)), stop(std::move(flag)), shared(std::move(sharedName)) {}
        bool isWanted() const { return !stop || !stop->load(); }
        std::vector<ipc::Command> commands; ///< one at least
        DetachedTask<Finish> task;
        StopFlag stop;
        std::string shared; ///< the name of start()
    };
    bool joins(const ipc::Command& command, const std::string& shared);

    std::list<Job> jobs_;
};

} // namespace rtserver
