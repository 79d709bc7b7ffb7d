/// Commands whose answer is due when something has happened: a scene stands, the frame is idle, a key is up.
#pragma once

#include "common/process/exit_codes.h"

#include "ipc/endpoint/server.h"

#include "rtcore/platform/sentence.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rtserver {

/// Where answers go.
class Replies {
  public:
    virtual ~Replies() = default;
    /// `detail`: as of Result.
    virtual void answer(const ipc::Command& command, const std::string& text, const std::string& detail) = 0;
    virtual void refuse(const ipc::Command& command, int code, const rtcore::Sentence& why) = 0;
    /// Whether the client that sent the command is still there.
    virtual bool isConnected(const ipc::Command& command) const = 0;
};

/// One thread. Each command is answered or refused once, then forgotten; what wants no answer, too.
class Requests {
  public:
    /// `replies` must outlive it.
    explicit Requests(Replies& replies) : replies_(replies) {}

    void addForLoad(const ipc::Command& command) { loader_ = command; }
    void addForIdle(const ipc::Command& command);
    /// `press`: of Keyboard::pressFor().
    void addForKey(const ipc::Command& command, std::uint64_t press);

    /// The scene stands: answers, if a client asked for it.
    void loaded();
    /// It does not: refuses, if a client asked for it.
    void loadFailed(int code, const rtcore::Sentence& why);
    bool waitsForLoad() const { return loader_.has_value(); }

    bool waitForIdle() const { return !idle_.empty(); }
    /// All is shown: answers each that waits for it.
    void idle();
    /// It will not be shown: refuses each.
    void refuseIdle(app::ExitCode code, const rtcore::Sentence& why);

    bool waitForKeys() const { return !keys_.empty(); }
    /// Their time does not go on: refuses each, and ends its press by `release`.
    void refuseKeys(app::ExitCode code, const rtcore::Sentence& why,
                    const std::function<void(std::uint64_t press)>& release);
    /// Answers those whose key is no longer `down`. A stopped or killed client holds no key: `release` is
    /// called for its press.
    void answerReleased(const std::function<bool(std::uint64_t press)>& down,
                        const std::function<void(std::uint64_t press)>& release);

  private:
    struct KeyRequest {
        ipc::Command command;
        std::uint64_t press;
    };

    Replies& replies_;
    std::optional<ipc::Command> loader_;
    std::vector<ipc::Command> idle_;
    std::vector<KeyRequest> keys_;
};

} // namespace rtserver
