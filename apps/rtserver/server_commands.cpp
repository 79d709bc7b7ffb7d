// Commands to the server itself.
#include "rtserver/command_call.h"

#include "common/cli/command_line.h"

#include <array>
#include <stdexcept>

namespace rtserver {

namespace {

Result ping(const Call&) { return {.answer = "pong"}; }

Result pause(const Call& call) {
    call.session.paused = true;
    return {};
}

Result resume(const Call& call) {
    call.session.paused = false;
    return {};
}

Result quit(const Call& call) {
    call.host.quit();
    return {};
}

Result parent(const Call& call) {
    if (call[0] == "none") {
        call.host.setParent(std::nullopt);
        return {};
    }
    const int process = integer(call[0]);
    if (process < 1) throw app::UsageError("a process has a number from 1 on; none is nobody");
    call.host.setParent(process);
    return {};
}

Result idle(const Call& call) {
    call.session.idles = flag(call[0]);
    return {};
}

Result frameTime(const Call& call) {
    const float milliseconds = call[0] == "off" ? 0 : number(call[0]);
    constexpr float kMost = 10000;
    if (!(milliseconds >= 0 && milliseconds <= kMost))
        throw app::UsageError("a frame may take up to 10000 milliseconds; off is any time");
    call.session.frameSeconds = static_cast<double>(milliseconds) * 1e-3;
    return {};
}

Result waitIdle(const Call& call) {
    if (!call.session.idles) throw std::runtime_error("the server never idles; 'idle on' lets it");
    if (call.session.paused) throw std::runtime_error("the server is paused; resume it first");
    return {.turn = Turn::WhenIdle};
}

Result messages(const Call& call) {
    const int known = call.size() > 0 ? integer(call[0]) : 0;
    if (known < 0) throw app::UsageError("messages are counted from 1; 0 asks for all");
    return {.answer = call.host.messages().since(static_cast<std::uint32_t>(known))};
}

constexpr std::array kCommands{
    Command{"ping", 0, 0, "", false, ping, Effect::Tells},
    Command{"quit", 0, 0, "", false, quit},
    Command{"exit", 0, 0, "", false, quit},
    Command{"parent", 1, 1, "PID|none", false, parent},
    Command{"pause", 0, 0, "", false, pause},
    Command{"resume", 0, 0, "", false, resume},
    Command{"idle", 1, 1, "on|off", false, idle},
    Command{"frame-time", 1, 1, "MILLISECONDS|off", false, frameTime},
    Command{"messages", 0, 1, "[KNOWN]", false, messages, Effect::Tells},
    Command{"wait-idle", 0, 0, "", true, waitIdle, Effect::Waits},
};

} // namespace

std::span<const Command> serverCommands() { return kCommands; }

} // namespace rtserver
