/// No descriptors left, for a while: nobody is taken for dead, and nobody throws what it does not promise.
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "ipc/layout/control_block.h"
#include "support/child_process.h"
#include "support/ipc_instance.h"

#include <gtest/gtest.h>

#include <optional>
#include <thread>

#include <sys/resource.h>

namespace {

using namespace ipc;
using namespace std::chrono_literals;

class WithoutDescriptors {
  public:
    WithoutDescriptors() {
        ::getrlimit(RLIMIT_NOFILE, &before_);
        const rlimit none{3, before_.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &none);
    }
    ~WithoutDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before_); }

  private:
    rlimit before_{};
};

class Shortage : public testing::Test {
  protected:
    // For so long, and a little more when it is asked to answer.
    void serve(Clock::duration time) {
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            server->wait(2ms);
            for (const Command& command : server->takeCommands()) server->answer(command, command.text);
        }
    }
    // The server serves in a thread of its own meanwhile.
    ReplyStatus ask(Client& client, std::chrono::milliseconds timeout = 1s) {
        const std::jthread serving([&](const std::stop_token& stop) {
            while (!stop.stop_requested()) serve(5ms);
        });
        return client.request("question", timeout).status;
    }

    test::IpcInstance instance;
    std::optional<Server> server{ServerOptions{.instance = instance.name(), .width = 16, .height = 16}};
};

TEST_F(Shortage, AServerTakesNobodyForDead) {
    if (test::kSanitized)
        GTEST_SKIP() << "a sanitizer makes pipes to look at memory, and calls failing ones a fault";
    Client client(instance.name());
    serve(20ms);
    const std::uint64_t epoch = server->epoch();
    {
        const WithoutDescriptors shortage;
        serve(1200ms); // over its housekeeping, too
        EXPECT_EQ(server->clients(), 1);
        EXPECT_EQ(ask(client), ReplyStatus::Done);
    }
    EXPECT_EQ(ask(client), ReplyStatus::Done);
    EXPECT_EQ(server->epoch(), epoch);
}

TEST_F(Shortage, ARequestAnswersWithinItsContract) {
    if (test::kSanitized) GTEST_SKIP() << "as above";
    Client client(instance.name());
    serve(20ms);
    {
        const WithoutDescriptors shortage;
        std::this_thread::sleep_for(50ms); // silence makes the client look whether the server lives
        EXPECT_EQ(client.request("question", 200ms).status, ReplyStatus::TimedOut);
        EXPECT_EQ(client.update(), LinkState::Connected) << "silent, but with its lock";
    }
    EXPECT_EQ(ask(client), ReplyStatus::Done);
    {
        const WithoutDescriptors shortage;
        server.reset();
        EXPECT_EQ(client.request("question", 100ms).status, ReplyStatus::NotSent);
    }
    server.emplace(ServerOptions{.instance = instance.name(), .width = 16, .height = 16});
    {
        const WithoutDescriptors shortage;
        EXPECT_EQ(ask(client, 100ms), ReplyStatus::NotSent) << "it cannot attach now";
        Frame frame;
        EXPECT_FALSE(client.readFrame(frame));
    }
    EXPECT_EQ(ask(client), ReplyStatus::Done);
}

// However it came about: whoever is not in the slot any more learns it, and attaches again.
TEST_F(Shortage, AClientThatWasTakenForDeadComesBack) {
    Client client(instance.name());
    client.pressKey(5);
    serve(20ms);
    const auto control = Segment::open(instance.names().control(), Access::Write, sizeof(ControlBlock));
    auto& block = *static_cast<ControlBlock*>(control->data());
    EXPECT_EQ(server->keys().presses[5], 1U);
    block.clients[0].clientTag = 0;
    serve(60ms);
    EXPECT_EQ(server->clients(), 0);
    EXPECT_EQ(ask(client), ReplyStatus::Done);
    const KeyState keys = server->keys();
    EXPECT_TRUE(keys.down[5]);
    EXPECT_EQ(keys.presses[5], 0U) << "that was before";
}

} // namespace
