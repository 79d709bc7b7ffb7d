/// Random bytes over the segments of a running server: nobody crashes, reads out of bounds, or hangs. Spared
/// are the semaphores and the queues, whose insides belong to the C library and to Boost.
#include "ipc/channel/message.h"
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "ipc/layout/control_block.h"
#include "ipc/layout/frame_segment.h"
#include "ipc/platform/boost_interprocess.h"
#include "ipc/platform/owner_lock.h"
#include "support/ipc_instance.h"

#include <boost/interprocess/ipc/message_queue.hpp>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace ipc;
using namespace std::chrono_literals;

int rounds() {
    const char* asked = std::getenv("RT_MUTATIONS");
    return asked == nullptr ? 300 : std::max(1, std::atoi(asked) / 100);
}

bool isBell(std::size_t offset) {
    constexpr std::size_t size = sizeof(Doorbell);
    if (offset >= offsetof(ControlBlock, bell) && offset < offsetof(ControlBlock, bell) + size) return true;
    if (offset < offsetof(ControlBlock, slots)) return false;
    const std::size_t inSlot = (offset - offsetof(ControlBlock, slots)) % sizeof(ClientSlot);
    return inSlot >= offsetof(ClientSlot, bell) && inSlot < offsetof(ClientSlot, bell) + size;
}

// Mostly where the words are, not the reply texts.
std::size_t randomOffset(std::mt19937_64& random) {
    while (true) {
        std::size_t offset = random() % offsetof(ControlBlock, slots);
        if (random() % 2 == 0) {
            offset = offsetof(ControlBlock, slots) + random() % 2 * sizeof(ClientSlot) +
                     random() % (offsetof(ClientSlot, replies) + 256);
        }
        if (!isBell(offset)) return offset;
    }
}

TEST(Scribble, OverTheControlSegment) {
    std::mt19937_64 random(11);
    test::IpcInstance instance;
    for (int round = 0; round < rounds(); ++round) {
        Server server({.instance = instance.name(), .width = 16, .height = 16, .patience = 100ms});
        Client client(instance.name());
        Viewer viewer(instance.name());
        client.send("hello");
        server.takeCommands();
        const auto control = Segment::open(instance.names().control(), Access::Write, sizeof(ControlBlock));
        ASSERT_TRUE(control);
        auto* bytes = static_cast<unsigned char*>(control->data());
        for (int step = 0; step < 40; ++step) {
            for (std::uint64_t n = random() % 16; n > 0; --n)
                bytes[randomOffset(random)] = static_cast<unsigned char>(random());
            Frame frame;
            try {
                server.beginFrame(16, 16);
                server.publishFrame();
                for (const Command& command : server.takeCommands())
                    server.answer(command, AnswerStatus::Done, "yes");
                server.keys();
                viewer.readFrame(frame);
                viewer.status();
                Ticket ticket = 0;
                client.send("x", &ticket);
                client.pressKey(3);
                client.readFrame(frame);
                client.wait(ticket, 0s);
            } catch (const Error&) {
                break; // said so: that is all one can ask
            }
        }
    }
}

TEST(Scribble, OverTheFrameSegment) {
    std::mt19937_64 random(12);
    test::IpcInstance instance;
    Server server({.instance = instance.name(), .width = 32, .height = 32});
    const auto frames =
        Segment::open(instance.names().frames(server.epoch(), 1), Access::Write, kPixelsOffset);
    ASSERT_TRUE(frames);
    auto* bytes = static_cast<unsigned char*>(frames->data());
    for (int round = 0; round < 20 * rounds(); ++round) {
        Viewer viewer(instance.name());
        Frame frame;
        for (int step = 0; step < 5; ++step) {
            for (std::uint64_t n = random() % 8; n > 0; --n) {
                bytes[random() % sizeof(FrameSegment)] = static_cast<unsigned char>(random());
            }
            server.beginFrame(32, 32);
            server.publishFrame();
            viewer.readFrame(frame);
        }
    }
}

// A program of the same user that writes nonsense into its queue, beside a good client.
TEST(Scribble, MalformedCommandsAreCountedAndEndTheirSender) {
    test::IpcInstance instance;
    Server server({.instance = instance.name(), .width = 16, .height = 16});
    Client good(instance.name());
    good.send("first");
    EXPECT_EQ(server.takeCommands().size(), 1u);

    const auto control = Segment::open(instance.names().control(), Access::Write, sizeof(ControlBlock));
    ASSERT_TRUE(control);
    ClientSlot& slot = static_cast<ControlBlock*>(control->data())->slots[1];
    const OwnerLock lock = std::move(*OwnerLock::tryTake(instance.names().clientLock(lockFolder(), 1)));
    const std::string name = instance.names().queue(1, 99);
    namespace bi = boost::interprocess;
    bi::message_queue queue(bi::create_only, name.c_str(), kCommandQueueLength, kMaxMessageBytes,
                            bi::permissions(0600));
    slot.clientTag = 99;
    server.takeCommands();
    EXPECT_EQ(slot.servedTag, 99u);

    std::mt19937_64 random(13);
    int sent = 0;
    for (int i = 0; i < 400 && slot.droppedTag != 99u; ++i) {
        std::vector<std::byte> bytes(random() % (kMaxMessageBytes + 1));
        for (auto& byte : bytes) byte = static_cast<std::byte>(random());
        sent += queue.try_send(bytes.data(), bytes.size(), 0);
        if (i % 8 == 7) {
            EXPECT_TRUE(server.takeCommands().empty());
        }
    }
    EXPECT_EQ(slot.droppedTag, 99u);
    EXPECT_EQ(slot.dropReason, DropReason::Malformed);
    EXPECT_EQ(server.malformed(), 101u);
    EXPECT_GE(sent, 101);
    good.send("second");
    EXPECT_EQ(server.takeCommands().size(), 1u);
}

TEST(Scribble, AQueueOfOtherDimensionsIsRefused) {
    test::IpcInstance instance;
    Server server({.instance = instance.name(), .width = 16, .height = 16});
    const auto control = Segment::open(instance.names().control(), Access::Write, sizeof(ControlBlock));
    ClientSlot& slot = static_cast<ControlBlock*>(control->data())->slots[0];
    const OwnerLock lock = std::move(*OwnerLock::tryTake(instance.names().clientLock(lockFolder(), 0)));
    namespace bi = boost::interprocess;
    const std::string wide = instance.names().queue(0, 5);
    bi::message_queue queue(bi::create_only, wide.c_str(), 2 * kCommandQueueLength, kMaxMessageBytes,
                            bi::permissions(0600));
    for (const std::uint64_t tag : {std::uint64_t{5}, std::uint64_t{6}}) { // 6: there is no such queue
        slot.clientTag = tag;
        server.takeCommands();
        EXPECT_EQ(slot.droppedTag, tag);
        EXPECT_EQ(slot.dropReason, DropReason::NoQueue);
        EXPECT_EQ(server.clients(), 0);
    }
}

} // namespace
