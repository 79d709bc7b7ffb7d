#include "rtserver/commands/requests.h"

#include "rtcore/platform/sentence.h"

#include <utility>

namespace rtserver {

void Requests::addForIdle(const ipc::Command& command) {
    if (command.wantsAnswer) idle_.push_back(command);
}

void Requests::addForKey(const ipc::Command& command, std::uint64_t press) {
    if (command.wantsAnswer) keys_.push_back({command, press});
}

void Requests::loaded() {
    const std::optional<ipc::Command> loader = std::exchange(loader_, std::nullopt);
    if (loader) replies_.answer(*loader, {}, {});
}

void Requests::loadFailed(int code, const rtcore::Sentence& why) {
    const std::optional<ipc::Command> loader = std::exchange(loader_, std::nullopt);
    if (loader) replies_.refuse(*loader, code, why);
}

void Requests::idle() {
    for (const ipc::Command& command : std::exchange(idle_, {})) replies_.answer(command, {}, {});
}

void Requests::refuseIdle(app::ExitCode code, const rtcore::Sentence& why) {
    for (const ipc::Command& command : std::exchange(idle_, {}))
        replies_.refuse(command, static_cast<int>(code), why);
}

void Requests::refuseKeys(app::ExitCode code, const rtcore::Sentence& why,
                          const std::function<void(std::uint64_t)>& release) {
    for (const KeyRequest& request : std::exchange(keys_, {})) {
        release(request.press);
        replies_.refuse(request.command, static_cast<int>(code), why);
    }
}

void Requests::answerReleased(const std::function<bool(std::uint64_t)>& down,
                              const std::function<void(std::uint64_t)>& release) {
    std::erase_if(keys_, [&](const KeyRequest& request) {
        if (!replies_.isConnected(request.command)) {
            release(request.press);
            return true;
        }
        if (down(request.press)) return false;
        replies_.answer(request.command, {}, {});
        return true;
    });
}

} // namespace rtserver
