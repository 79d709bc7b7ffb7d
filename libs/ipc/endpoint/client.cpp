#include "ipc/endpoint/client.h"

#include "ipc/channel/message.h"
#include "ipc/channel/sequenced_value.h"
#include "ipc/endpoint/attachment.h"
#include "ipc/endpoint/frame_feed.h"
#include "ipc/endpoint/open_link.h"

#include <algorithm>
#include <map>
#include <set>
#include <thread>

namespace ipc {

namespace {

// The end of a killed server is noticed after such a slice at the latest.
constexpr auto kBellSlice = std::chrono::milliseconds(10);
constexpr auto kRetry = std::chrono::milliseconds(1);
constexpr std::size_t kKeptAnswers = 1024;

} // namespace

struct Client::State {
    State(const std::string& instance, Clock::time_point deadline, std::uint32_t keyRestraint)
        : names(instance), link(openLink(names, Access::Write, deadline)), restraint(keyRestraint),
          feed(names) {
        attach();
    }

    // The old attachment goes first: it points into the link.
    void attach() {
        attachment.reset();
        if (slot < 0) slot = takeSlot(names, link);
        ++attachments;
        attachment.emplace(names, link, slot, keys, restraint);
    }
    void follow(Link next) {
        attachment.reset();
        link = std::move(next);
        slot = -1;
        attachAgain();
    }
    void attachAgain() {
        loseAll();
        try {
            attach();
        } catch (const Error& error) {
            if (error.problem != Problem::System) throw; // short of descriptors: the next call tries again
        }
    }
    void loseAll() {
        for (const Ticket ticket : open)
            keep(ticket, {ReplyStatus::Lost, "the server ended before it answered"});
        open.clear();
    }
    void keep(Ticket ticket, Reply reply) {
        answers[ticket] = std::move(reply);
        if (answers.size() > kKeptAnswers) answers.erase(answers.begin());
    }

    void wantFrames(std::uint32_t wanted) {
        if (attachment) attachment->slot().wantsFrames.store(wanted, std::memory_order_relaxed);
    }

    LinkState update();
    void collectAnswers();
    KeyBoard* board() { return attachment ? &attachment->slot().keys : nullptr; }
    void waitForBell(Clock::time_point deadline, std::chrono::milliseconds slice = kBellSlice) {
        const Clock::time_point until = std::min(deadline, Clock::now() + slice);
        attachment ? void(waitUntil(attachment->slot().bell, until)) : std::this_thread::sleep_until(until);
    }

    Names names;
    Link link;
    int slot = -1; ///< ours, locked in the link; -1: none yet
    KeyWriter keys;
    std::uint32_t restraint;
    std::optional<Attachment> attachment; ///< empty while attaching failed
    FrameFeed feed;
    std::uint64_t lastSequence = 0;
    std::uint64_t attachments = 0; ///< how often attached
    std::uint64_t lastSentIn = 0;  ///< the attachment in which was sent last
    std::set<Ticket> open;         ///< sent, without an answer
    std::map<Ticket, Reply> answers;
    Status status;
    Clock::time_point lastLook;
};

LinkState Client::State::update() {
    const LinkState now = link.check();
    if (now != LinkState::Gone && attachment && attachment->accepted()) {
        keys.repair(attachment->slot().keys);
        return now;
    }
    collectAnswers(); // the last words of a server that ended in good order
    if (now == LinkState::Gone) {
        attachment.reset();
        loseAll();
    }
    if (Clock::now() - lastLook < kLookEvery) return LinkState::Gone;
    lastLook = Clock::now();
    if (now != LinkState::Gone) {
        attachAgain();
        return now;
    }
    std::optional<Link> next = link.successor(Access::Write);
    if (!next) return LinkState::Gone;
    follow(std::move(*next));
    return LinkState::Connected;
}

void Client::State::collectAnswers() {
    ReplyRecord record;
    while (attachment) {
        const RingResult result = attachment->tryReceive(record);
        if (result == RingResult::Nothing) return;
        if (result == RingResult::Broken) return attachAgain();
        if (attachment->slot().repliesWait.load(std::memory_order_relaxed) != 0) ring(link.block().bell);
        if (open.erase(record.sequence) == 0) continue;
        const ReplyStatus given = record.code == 0 ? ReplyStatus::Done : ReplyStatus::Failed;
        constexpr int kMax = 255;
        keep(record.sequence,
             {given, std::move(record.text), std::min(int{record.code}, kMax), std::move(record.detail)});
    }
}

Client::Client(const std::string& instance, std::chrono::nanoseconds patience, std::uint32_t keyRestraint)
    : state_(std::make_unique<State>(instance, Clock::now() + patience, keyRestraint)) {}

Client::~Client() { state_->keys.releaseAll(state_->board()); }

LinkState Client::update() {
    const LinkState now = state_->update();
    state_->collectAnswers();
    return now;
}

std::uint64_t Client::epoch() const { return state_->link.epoch(); }
std::int64_t Client::serverProcess() const { return state_->link.serverProcess(); }

SendStatus Client::send(std::string_view command, Ticket* ticket) {
    if (command.size() > kMaxCommandText || command.find('\0') != std::string_view::npos) {
        throw Error(Problem::TooLarge, "a command has up to {0} bytes, none of them NUL; this one has {1}",
                    {std::to_string(kMaxCommandText), std::to_string(command.size())});
    }
    State& state = *state_;
    if (update() == LinkState::Gone || !state.attachment) return SendStatus::NoServer;
    const Message message{state.lastSequence + 1, ticket != nullptr, std::string(command)};
    const QueueResult result = state.attachment->trySend(encode(message, state.link.epoch()));
    if (result == QueueResult::Nothing) return SendStatus::Full;
    if (result == QueueResult::Broken) {
        state.attachAgain();
        return SendStatus::NoServer;
    }
    state.lastSequence = message.sequence;
    state.lastSentIn = state.attachments;
    if (ticket != nullptr) {
        *ticket = message.sequence;
        state.open.insert(*ticket);
    }
    return SendStatus::Sent;
}

Reply Client::wait(Ticket ticket, std::chrono::nanoseconds timeout) {
    State& state = *state_;
    const Clock::time_point deadline = Clock::now() + timeout;
    while (true) {
        update();
        if (auto answer = state.answers.extract(ticket)) return std::move(answer.mapped());
        if (!state.open.contains(ticket)) return {ReplyStatus::Lost, "there is no such command under way"};
        if (Clock::now() >= deadline) return {ReplyStatus::TimedOut, "the server did not answer in time"};
        state.waitForBell(deadline);
    }
}

Reply Client::request(std::string_view command, std::chrono::nanoseconds timeout) {
    const Clock::time_point deadline = Clock::now() + timeout;
    while (true) {
        Ticket ticket = 0;
        const SendStatus sent = send(command, &ticket);
        if (sent == SendStatus::Sent) return wait(ticket, deadline - Clock::now());
        if (Clock::now() >= deadline) {
            return {ReplyStatus::NotSent,
                    sent == SendStatus::Full ? "the server does not take commands" : "there is no server"};
        }
        state_->waitForBell(deadline, kRetry);
    }
}

bool Client::flush(std::chrono::nanoseconds timeout) {
    State& state = *state_;
    const Clock::time_point deadline = Clock::now() + timeout;
    if (state.lastSequence == 0) return true;
    while (state.attachments == state.lastSentIn && state.attachment) {
        if (state.attachment->taken() >= state.lastSequence) return true;
        if (update() == LinkState::Gone || Clock::now() >= deadline) return false;
        state.waitForBell(deadline, kRetry);
    }
    return false;
}

void Client::pressKey(int key) {
    update();
    state_->keys.press(state_->board(), key);
    ring(state_->link.block().bell);
}

void Client::releaseKey(int key) {
    update();
    state_->keys.release(state_->board(), key);
    ring(state_->link.block().bell);
}

void Client::releaseAllKeys() {
    update();
    state_->keys.releaseAll(state_->board());
    ring(state_->link.block().bell);
}

bool Client::readFrame(Frame& frame) {
    update();
    return state_->feed.read(state_->link, frame);
}

bool Client::waitForFrame(Frame& frame, std::chrono::nanoseconds timeout) {
    const Clock::time_point deadline = Clock::now() + timeout;
    bool found = readFrame(frame);
    while (!found && Clock::now() < deadline) {
        state_->wantFrames(1);
        found = readFrame(frame); // it may have come just before
        if (!found) state_->waitForBell(deadline);
    }
    state_->wantFrames(0);
    return found;
}

Status Client::status() {
    update();
    read(state_->link.block().status, state_->status);
    return state_->status;
}

} // namespace ipc
