/// Random bytes over the segments of a running server: nobody crashes, reads out of bounds, or hangs. Spared
/// are the queues, whose insides belong to Boost.
#include "ipc/channel/message.h"
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "ipc/layout/control_block.h"
#include "ipc/layout/frame_segment.h"
#include "ipc/platform/boost_interprocess.h"
#include "support/ipc_instance.h"

#include <boost/interprocess/ipc/message_queue.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <optional>
#include <random>
#include <thread>

namespace {

using namespace ipc;
using namespace std::chrono_literals;

int mutations(int quick) {
    const char* asked = std::getenv("RT_MUTATIONS");
    return asked == nullptr ? quick : std::max(1, std::atoi(asked));
}

// Mostly where the words are, not the reply texts.
std::size_t randomOffset(std::mt19937_64& random) {
    const std::size_t slot = random() % 4 == 0 ? random() % kMaxClients : random() % 2;
    switch (random() % 8) {
    case 0:
        return random() % sizeof(ControlBlock);
    case 1:
    case 2:
    case 3:
        return random() % offsetof(ControlBlock, clients);
    default:
        return offsetof(ControlBlock, clients) + slot * sizeof(ClientSlot) +
               random() % (offsetof(ClientSlot, replies) + 256);
    }
}

// Serves as a server does until it is destroyed.
class Serving {
  public:
    explicit Serving(const std::string& instance)
        : server_({.instance = instance, .width = 16, .height = 16}) {}

  private:
    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            server_.wait(2ms);
            server_.beginFrame(16, 16);
            server_.publishFrame();
            for (const Command& command : server_.takeCommands()) server_.answer(command, command.text);
            server_.keys();
        }
    }
    Server server_;
    std::jthread thread_{[this](const std::stop_token& stop) { run(stop); }};
};

// One of the clients is answered within a second; it may be told meanwhile that the server is of another
// version, which is what the bytes say then.
bool recovers(std::optional<Client>& client, const std::string& instance, const std::string& question) {
    const auto deadline = Clock::now() + 1s;
    while (Clock::now() < deadline) {
        try {
            if (!client) client.emplace(instance, 100ms);
            Frame frame;
            client->readFrame(frame);
            client->pressKey(3);
            client->releaseKey(3);
            if (client->request(question, 50ms).text == question) return true;
        } catch (const Error&) {
            client.reset();
        }
    }
    return false;
}

// Bells, tags, counters, the header: a buggy client writes bytes anywhere, and is no worse off than others.
TEST(Scribble, HonestClientsRecoverWithinASecond) {
    std::mt19937_64 random(11);
    test::IpcInstance instance;
    std::optional<Client> clients[2];
    const Serving server(instance.name());
    Viewer viewer(instance.name());
    const auto control = Segment::open(instance.names().control(), Access::Write, sizeof(ControlBlock));
    ASSERT_TRUE(control);
    auto* bytes = static_cast<unsigned char*>(control->data());
    constexpr int kBurst = 50;
    Clock::duration longest{};
    for (int round = 0; round < (mutations(1000) + kBurst - 1) / kBurst; ++round) {
        const std::string question = "question " + std::to_string(round);
        for (auto& client : clients) ASSERT_TRUE(recovers(client, instance.name(), question)) << round;
        for (int i = 0; i < kBurst; ++i) {
            bytes[randomOffset(random)] = static_cast<unsigned char>(random());
            if (i % 10 == 0) std::this_thread::yield();
        }
        const auto start = Clock::now();
        for (auto& client : clients) ASSERT_TRUE(recovers(client, instance.name(), question)) << round;
        longest = std::max(longest, Clock::now() - start);
        Frame frame;
        viewer.readFrame(frame);
        viewer.status();
    }
    std::printf("the longest recovery took %.0f ms\n",
                std::chrono::duration<double, std::milli>(longest).count());
    const Client newcomer(instance.name(), 1s);
    EXPECT_LE(instance.segments().size(), 2U + 1U) << "no queue but the newcomer's";
}

TEST(Scribble, OverTheFrameSegment) {
    std::mt19937_64 random(12);
    test::IpcInstance instance;
    Server server({.instance = instance.name(), .width = 32, .height = 32});
    const auto frames =
        Segment::open(instance.names().frames(server.epoch(), 1), Access::Write, kPixelsOffset);
    ASSERT_TRUE(frames);
    auto* bytes = static_cast<unsigned char*>(frames->data());
    for (int round = 0; round < mutations(30000) / 5; ++round) {
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

// The frame and the status of a server that draws nothing more are repaired, too.
TEST(Scribble, OverTheFrameSegmentOfAnIdleServer) {
    test::IpcInstance instance;
    Server server({.instance = instance.name(), .width = 32, .height = 32});
    const std::vector<std::byte> pixels(4 * 32 * 32, std::byte{9});
    server.publishFrame({.width = 32, .height = 32, .tag = 5}, pixels);
    server.setStatus({.polygons = 6});
    const auto frames =
        Segment::open(instance.names().frames(server.epoch(), 1), Access::Write, kPixelsOffset);
    const auto control = Segment::open(instance.names().control(), Access::Write, sizeof(ControlBlock));
    std::memset(frames->data(), 0xA5, sizeof(FrameSegment));
    std::memset(static_cast<std::byte*>(control->data()) + offsetof(ControlBlock, status), 0xA5,
                sizeof(Sequenced<Status>));
    for (int i = 0; i < 10; ++i) server.wait(10ms);
    Viewer viewer(instance.name());
    Frame frame;
    EXPECT_TRUE(viewer.readFrame(frame));
    EXPECT_EQ(frame.info.tag, 5U);
    EXPECT_EQ(frame.pixels, pixels);
    EXPECT_EQ(viewer.status().polygons, 6U);
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
    ClientSlot& slot = static_cast<ControlBlock*>(control->data())->clients[1];
    ASSERT_TRUE(control->tryLock(clientLock(1)));
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
    ClientSlot& slot = static_cast<ControlBlock*>(control->data())->clients[0];
    ASSERT_TRUE(control->tryLock(clientLock(0)));
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
