/// The commands of clients: run in their order, answered now or when what they wait for is there.
#pragma once

#include "rtserver/commands/command_book.h"
#include "rtserver/commands/commands.h"
#include "rtserver/commands/requests.h"
#include "rtserver/commands/side_work.h"
#include "rtserver/failure.h"
#include "rtserver/frames/arrivals.h"
#include "rtserver/walk/workspace.h"

#include "common/process/exit_codes.h"

#include "ipc/endpoint/server.h"

#include "rtcore/platform/sentence.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rtserver {

/// One thread at a time: the server's, and the guard's while a frame is drawn. Knows nothing of shared
/// memory: commands are handed in, answers go to Replies.
class CommandService {
  public:
    /// The parts of the server that the service reports to, or asks.
    struct Services {
        Host& host;
        Replies& replies;
        std::function<void()> publishStatus; ///< before each answer: its receiver sees no outdated idle flag
    };
    /// All must outlive it.
    CommandService(Workspace& state, Messages& messages, Services services);
    /// Gives long work up, and waits a little for files that are being written.
    ~CommandService();
    CommandService(const CommandService&) = delete;
    CommandService& operator=(const CommandService&) = delete;

    // --- In the server's turn ---

    /// Clients that have sent so much that their further commands stay in their queues.
    ipc::ClientSet full() const;
    /// Commands for the next serve().
    void add(std::vector<ipc::Command> commands);
    /// Takes commands and runs all that can be run now, those that wait for a frame included.
    void serve(std::vector<ipc::Command> commands);
    /// Answers what is done beside the server, and gives up long work whose client has left.
    void finishSideWork();
    /// A load is over, by that failure if any.
    void loaded(const std::optional<Failure>& failure);
    /// Answers those that wait for keys or for idleness, which is there or not.
    void answerRequests(bool idle);
    /// Refuses those that wait for a frame for which there is no memory.
    void refuseWaiting(const rtcore::Sentence& why);
    /// Refuses those that wait for a frame while more commands wait behind them.
    void refuseObstructing(const rtcore::Sentence& why);

    /// As of the last serve(): a command needs the whole frame of what is shown.
    bool waits() const { return commands_.waits(); }
    bool hasNew() const { return commands_.hasNew(); }
    bool worksBeside() const { return sideWork_.underWay(); }
    bool worksApart() const { return longWork_.underWay() || tellingWork_.underWay(); }

    // --- While a frame is drawn ---

    /// Answers what only asks something, at once or when it is found out beside the frame, runs what Keeps
    /// something (app::CommandEffect), and takes the others for the next serve().
    Arrivals addDuringFrame(std::vector<ipc::Command> commands);

  private:
    using Act = std::function<std::optional<Answer>()>;

    Served serveOne(const ipc::Command& command);
    std::optional<Answer> begin(const ipc::Command& command, Result result, Served& served);
    void answerBy(const ipc::Command& command, const Act& act);
    void tell(const ipc::Command& command);
    void startApart(const ipc::Command& command, Result result);
    void answerTelling();
    void refuseFor(const ipc::Command& command, const std::exception& error);
    void refuseAll(const std::vector<ipc::Command>& commands, const rtcore::Sentence& why);

    Workspace& state_;
    Messages& messages_;
    Services services_;
    CommandBook commands_;
    Requests requests_;
    SideWork sideWork_;
    SideWork longWork_;    ///< no client's further commands wait for it
    SideWork tellingWork_; ///< the same of commands that only tell something: no frame is left for its answer
};

} // namespace rtserver
