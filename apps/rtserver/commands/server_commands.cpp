// Commands to the server itself.
#include "rtserver/commands/command_call.h"

#include "rtcore/platform/sentence.h"

#include <array>
#include <stdexcept>

namespace rtserver {

namespace {

Result ping(const Call&) { return {.answer = "pong"}; }

Result pause(const Call& call) {
    call.state.paused = true;
    return {};
}

Result resume(const Call& call) {
    call.state.paused = false;
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
    call.host.setParent(integer(call[0]));
    return {};
}

Result idle(const Call& call) {
    call.state.idles = flag(call[0]);
    return {};
}

Result frameTime(const Call& call) {
    const float milliseconds = call[0] == "off" ? 0 : number(call[0]);
    call.state.frameSeconds = static_cast<double>(milliseconds) * 1e-3;
    return {};
}

Result restLight(const Call& call) {
    call.state.restsInWalkLight = call[0] == "walk";
    return {};
}

Result waitIdle(const Call& call) {
    if (!call.state.idles) throw rtcore::Refusal("the server never idles; 'idle on' lets it");
    if (call.state.paused) throw rtcore::Refusal("the server is paused; resume it first");
    return {.when = ReplyWhen::WhenIdle};
}

Result messages(const Call& call) {
    const int known = call.size() > 0 ? integer(call[0]) : 0;
    const Messages& all = call.host.messages();
    const auto number = static_cast<std::uint32_t>(known);
    return {.answer = all.since(number), .detail = all.detailsSince(number)};
}

constexpr std::array kServerFunctions{
    CommandFunction{app::CommandId::Ping, ping},
    CommandFunction{app::CommandId::Quit, quit},
    CommandFunction{app::CommandId::Exit, quit},
    CommandFunction{app::CommandId::Parent, parent},
    CommandFunction{app::CommandId::Pause, pause},
    CommandFunction{app::CommandId::Resume, resume},
    CommandFunction{app::CommandId::Idle, idle},
    CommandFunction{app::CommandId::FrameTime, frameTime},
    CommandFunction{app::CommandId::RestLight, restLight},
    CommandFunction{app::CommandId::Messages, messages},
    CommandFunction{app::CommandId::WaitIdle, waitIdle},
};

} // namespace

std::span<const CommandFunction> serverFunctions() { return kServerFunctions; }

} // namespace rtserver
