#include "ipc/channel/command_queue.h"

#include "ipc/channel/queue_check.h"
#include "ipc/layout/message_headers.h"
#include "ipc/platform/boost_interprocess.h"
#include "ipc/platform/error.h"
#include "ipc/platform/fault_point.h"
#include "ipc/platform/names.h"
#include "ipc/platform/rules.h"
#include "ipc/platform/segment.h"
#include "ipc/platform/system.h"

#include <fmt/core.h>

#include <boost/interprocess/ipc/message_queue.hpp>

namespace ipc {

namespace bi = boost::interprocess;

namespace {

// Nearly what a queue takes, and a margin: before Boost 1.81 its memory was not reserved when it was made.
constexpr std::size_t kQueueBytes = kCommandQueueLength * (kMaxMessageBytes + 64) + 65536;

struct NameRemover {
    std::string name;
    ~NameRemover() {
        if (keeps("an opened queue loses its name")) Segment::remove(name);
    }
};

bool isSound(const Segment& queue) {
    return isSoundQueue(queue) || !keeps("queues are checked before they are used");
}

} // namespace

struct CommandSender::State {
    explicit State(const std::string& queueName)
        : name(queueName), queue(bi::create_only, queueName.c_str(), kCommandQueueLength, kMaxMessageBytes,
                                 bi::permissions(0600)) {}
    ~State() { Segment::remove(name); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    std::string name;
    bi::message_queue queue;
};

CommandSender::CommandSender(const std::string& name) {
    requireSpace(kQueueBytes);
    try {
        state_ = std::make_unique<State>(name);
        if constexpr (BOOST_VERSION < 108100) Segment::reserve(name);
    } catch (const bi::interprocess_exception& error) {
        const Problem problem =
            error.get_error_code() == bi::already_exists_error ? Problem::NotYours : Problem::System;
        throw Error(problem, "command queue {0}: {1}", {name, error.what()});
    }
}

CommandSender::~CommandSender() = default;
CommandSender::CommandSender(CommandSender&&) noexcept = default;
CommandSender& CommandSender::operator=(CommandSender&&) noexcept = default;

QueueResult CommandSender::trySend(std::span<const std::byte> message) {
    try {
        if (!keeps("sending does not wait")) {
            state_->queue.send(message.data(), message.size(), 0);
            return QueueResult::Done;
        }
        return state_->queue.try_send(message.data(), message.size(), 0) ? QueueResult::Done
                                                                         : QueueResult::Nothing;
    } catch (const bi::interprocess_exception&) {
        return QueueResult::Broken;
    }
}

struct CommandReceiver::State {
    State(Segment map, const std::string& name)
        : memory(std::move(map)), queue(bi::open_only, name.c_str()) {}
    Segment memory; ///< to look at what Boost believes
    bi::message_queue queue;
    std::vector<std::byte> buffer = std::vector<std::byte>(kMaxMessageBytes);
};

CommandReceiver::CommandReceiver() = default;
CommandReceiver::~CommandReceiver() = default;
CommandReceiver::CommandReceiver(CommandReceiver&&) noexcept = default;
CommandReceiver& CommandReceiver::operator=(CommandReceiver&&) noexcept = default;

QueueResult CommandReceiver::open(const std::string& name, CommandReceiver& receiver) {
    try {
        // Boost does not validate what it opens, so it is checked here first. It is the same segment: no
        // other process removes the new name, so no other segment can take it.
        const std::string ours = fmt::format("{}-{}", name, randomTag());
        renameSegment(name, ours);
        const NameRemover remover{ours};
        std::optional<Segment> memory = Segment::open(ours, Access::Read, 1);
        if (!memory || !isSound(*memory)) return QueueResult::Broken;
        auto state = std::make_unique<State>(std::move(*memory), ours);
        faultPoint("queue opened");
        receiver.state_ = std::move(state);
        return QueueResult::Done;
    } catch (const bi::interprocess_exception&) {
        return QueueResult::Broken;
    } catch (const Error&) {
        return QueueResult::Broken;
    }
}

QueueResult CommandReceiver::tryReceive(std::vector<std::byte>& message) {
    if (!isSound(state_->memory)) return QueueResult::Broken;
    try {
        bi::message_queue::size_type bytes = 0;
        unsigned priority = 0;
        std::vector<std::byte>& buffer = state_->buffer;
        if (!keeps("receiving does not wait")) {
            state_->queue.receive(buffer.data(), buffer.size(), bytes, priority);
        } else if (!state_->queue.try_receive(buffer.data(), buffer.size(), bytes, priority)) {
            return QueueResult::Nothing;
        }
        if (bytes > buffer.size()) return QueueResult::Broken;
        message.assign(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(bytes));
        return QueueResult::Done;
    } catch (const bi::interprocess_exception&) {
        return QueueResult::Broken;
    }
}

} // namespace ipc
