#include "cui/conversation.h"

#include "common/process/stop.h"

#include "ipc/endpoint/instances.h"

#include <algorithm>
#include <thread>

namespace cui {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kSlice = 100ms; ///< after which a signal is heeded

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
        throw CommandFailure(static_cast<app::ExitCode>(reply.code), reply.text);
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
