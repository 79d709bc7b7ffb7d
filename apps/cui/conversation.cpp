#include "cui/conversation.h"

#include "common/cli/command_line.h"
#include "common/process/stop.h"

#include "ipc/endpoint/instances.h"

#include <algorithm>
#include <thread>

namespace cui {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kSlice = 100ms; ///< after which a signal is heeded

// A server's failure begins with the exit code that suits it.
[[noreturn]] void throwFailure(const std::string& answer) {
    const std::size_t blank = answer.find(' ');
    const auto code = app::parseInteger(std::string_view(answer).substr(0, blank));
    if (!code || *code < 1 || *code > 125 || blank == std::string::npos)
        throw CommandFailure(app::ExitCode::Failed, answer);
    throw CommandFailure(static_cast<app::ExitCode>(*code), answer.substr(blank + 1));
}

} // namespace

ipc::Client& Conversation::client() {
    if (client_ == nullptr)
        client_ = std::make_unique<ipc::Client>(instance_, std::min<std::chrono::nanoseconds>(timeout_, 2s));
    return *client_;
}

ipc::Reply Conversation::ask(std::string_view command, std::chrono::nanoseconds work) {
    const Clock::time_point deadline = Clock::now() + timeout_ + work;
    ipc::Ticket ticket = 0;
    while (true) {
        const ipc::SendStatus sent = client().send(command, &ticket);
        if (sent == ipc::SendStatus::Sent) break;
        app::throwIfStopped();
        if (Clock::now() >= deadline) return {};
        std::this_thread::sleep_for(1ms);
    }
    while (true) {
        const auto left = std::clamp<Clock::duration>(deadline - Clock::now(), 0ns, kSlice);
        ipc::Reply reply = client().wait(ticket, left);
        if (reply.status != ipc::ReplyStatus::TimedOut || Clock::now() >= deadline) return reply;
        app::throwIfStopped();
    }
}

std::string Conversation::request(std::string_view command, std::chrono::nanoseconds work) {
    const ipc::Reply reply = ask(command, work);
    const std::string server = "the server '" + instance_ + "' ";
    switch (reply.status) {
    case ipc::ReplyStatus::Done:
        return reply.text;
    case ipc::ReplyStatus::Failed:
        throwFailure(reply.text);
    case ipc::ReplyStatus::Lost:
        throw CommandFailure(app::ExitCode::TryAgain, server + "ended before it answered");
    case ipc::ReplyStatus::TimedOut:
        throw CommandFailure(app::ExitCode::TryAgain,
                             server + "did not answer in time; --timeout waits longer");
    case ipc::ReplyStatus::NotSent:
        break;
    }
    throw CommandFailure(app::ExitCode::TryAgain, server + "took no command in time");
}

void Conversation::quit(std::string_view command) {
    const Clock::time_point deadline = Clock::now() + timeout_;
    const std::int64_t process = client().serverProcess();
    const ipc::Reply reply = ask(command, 0ns);
    const bool understood = reply.status == ipc::ReplyStatus::Done || reply.status == ipc::ReplyStatus::Lost;
    if (!understood)
        throw CommandFailure(app::ExitCode::TryAgain,
                             "the server '" + instance_ + "' did not answer in time");
    client_.reset();
    const auto runs = [&] {
        const std::vector<ipc::Instance> all = ipc::listInstances();
        return std::any_of(all.begin(), all.end(), [&](const ipc::Instance& each) {
            return each.name == instance_ && each.running && each.process == process;
        });
    };
    while (runs()) {
        app::throwIfStopped();
        if (Clock::now() >= deadline)
            throw CommandFailure(app::ExitCode::TryAgain,
                                 "the server '" + instance_ + "' has not ended in time");
        std::this_thread::sleep_for(5ms);
    }
}

} // namespace cui
