#include "cui/conversation.h"

#include "common/process/stop.h"

#include "ipc/endpoint/instances.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace cui {

namespace {

using namespace std::chrono_literals;

constexpr auto kSlice = 100ms; ///< after which a signal is heeded

} // namespace

ipc::Client& Conversation::client() {
    if (client_ == nullptr)
        client_ = std::make_unique<ipc::Client>(instance_, std::min<std::chrono::nanoseconds>(timeout_, 2s));
    return *client_;
}

// 0: it took none in time.
ipc::Ticket Conversation::send(std::string_view command, Clock::time_point deadline) {
    ipc::Ticket ticket = 0;
    while (client().send(command, &ticket) != ipc::SendStatus::Sent) {
        app::throwIfStopped();
        if (Clock::now() >= deadline) return 0;
        std::this_thread::sleep_for(1ms);
    }
    return ticket;
}

ipc::Reply Conversation::ask(std::string_view command, std::chrono::nanoseconds work) {
    const Clock::time_point deadline = Clock::now() + timeout_ + work;
    const ipc::Ticket ticket = send(command, deadline);
    if (ticket == 0) return {};
    while (true) {
        const auto left = std::clamp<Clock::duration>(deadline - Clock::now(), 0ns, kSlice);
        ipc::Reply reply = client().wait(ticket, left);
        if (reply.status != ipc::ReplyStatus::TimedOut || Clock::now() >= deadline) return reply;
        app::throwIfStopped();
    }
}

std::string Conversation::request(std::string_view command, std::chrono::nanoseconds work) {
    return textOf(ask(command, work));
}

std::string Conversation::attend(std::string_view command, const LongWork& work) {
    Clock::time_point deadline = Clock::now() + timeout_;
    const ipc::Ticket ticket = send(command, deadline);
    if (ticket == 0) return textOf({});
    bool givenUp = false;
    while (true) {
        const ipc::Reply reply = client().wait(ticket, 2 * kSlice);
        const bool open = reply.status == ipc::ReplyStatus::TimedOut;
        if (!open) app::throwIfStopped();
        if (!open || Clock::now() >= deadline) return textOf(reply);
        if (app::stopRequested()) {
            if (!std::exchange(givenUp, true)) client().send(work.giveUp);
            continue;
        }
        work.show(request(work.progress));
        deadline = Clock::now() + timeout_;
    }
}

std::string Conversation::textOf(const ipc::Reply& reply) const {
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
