/// Server and clients in one process, through the public headers alone.
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/server.h"
#include "ipc/endpoint/viewer.h"
#include "support/ipc_instance.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <thread>

namespace {

using namespace ipc;
using namespace std::chrono_literals;

template <class Endpoint>
bool becomes(Endpoint& endpoint, LinkState state) {
    const auto deadline = Clock::now() + 1s;
    while (endpoint.update() != state) {
        if (Clock::now() > deadline) return false;
        std::this_thread::sleep_for(1ms);
    }
    return true;
}

class ServerClient : public testing::Test {
  protected:
    std::unique_ptr<Server> start(std::uint32_t side = 16) {
        return std::make_unique<Server>(
            ServerOptions{.instance = instance.name(), .width = side, .height = side, .patience = 100ms});
    }
    // Commands that arrive within a second, answered with "did <text>".
    static std::vector<Command> serve(Server& server, std::size_t count) {
        std::vector<Command> all;
        const auto deadline = Clock::now() + 1s;
        while (all.size() < count && Clock::now() < deadline) {
            for (Command& command : server.takeCommands()) {
                server.answer(command, "did " + command.text);
                all.push_back(std::move(command));
            }
        }
        return all;
    }
    test::IpcInstance instance;
};

TEST_F(ServerClient, CommandsComeInOrderAndAreAnswered) {
    const auto server = start();
    Client client(instance.name());
    std::vector<Ticket> tickets(20);
    for (std::size_t i = 0; i < tickets.size(); ++i) {
        ASSERT_EQ(client.send("command " + std::to_string(i), &tickets[i]), SendStatus::Sent);
    }
    EXPECT_FALSE(client.flush(0s));
    const auto commands = serve(*server, tickets.size());
    ASSERT_EQ(commands.size(), tickets.size());
    EXPECT_TRUE(client.flush(0s));
    for (std::size_t i = 0; i < tickets.size(); ++i) {
        EXPECT_EQ(commands[i].text, "command " + std::to_string(i));
        const Reply reply = client.wait(tickets[i], 1s);
        EXPECT_EQ(reply.status, ReplyStatus::Done);
        EXPECT_EQ(reply.text, "did command " + std::to_string(i));
    }
    EXPECT_EQ(client.wait(tickets[0], 0s).status, ReplyStatus::Lost); // each answer is given once
}

TEST_F(ServerClient, AnswersMayComeLateAndInAnyOrder) {
    const auto server = start();
    Client client(instance.name());
    Ticket slow = 0, quick = 0;
    client.send("slow", &slow);
    client.send("quick", &quick);
    std::vector<Command> commands;
    while (commands.size() < 2) {
        for (auto& command : server->takeCommands()) commands.push_back(command);
    }
    server->refuse(commands[1], 66, "no", "[]");
    EXPECT_EQ(client.wait(slow, 20ms).status, ReplyStatus::TimedOut);
    const Reply refused = client.wait(quick, 1s);
    EXPECT_EQ(refused.status, ReplyStatus::Failed);
    EXPECT_EQ(refused.code, 66);
    EXPECT_EQ(refused.text, "no");
    EXPECT_EQ(refused.detail, "[]");
    server->answer(commands[0]);
    server->refuse(commands[0], 1, "twice");
    EXPECT_EQ(client.wait(slow, 1s).status, ReplyStatus::Done);
}

TEST_F(ServerClient, LongAnswersAreDeliveredOneAfterTheOther) {
    const auto server = start();
    Client client(instance.name());
    std::vector<Ticket> tickets(5);
    for (Ticket& ticket : tickets) client.send("long", &ticket);
    std::atomic<bool> stop{false};
    std::thread serving([&] {
        while (!stop) {
            server->wait(5ms);
            for (const Command& command : server->takeCommands()) {
                server->answer(command, std::string(70000, static_cast<char>('a' + command.sequence)));
            }
        }
    });
    for (const Ticket ticket : tickets) {
        const Reply reply = client.wait(ticket, 5s);
        EXPECT_EQ(reply.status, ReplyStatus::Done);
        EXPECT_EQ(reply.text, std::string(65520, static_cast<char>('a' + ticket)));
    }
    stop = true;
    serving.join();
}

TEST_F(ServerClient, AFullQueueSaysSoAtOnce) {
    const auto server = start();
    Client client(instance.name());
    int sent = 0;
    while (client.send("x") == SendStatus::Sent && sent < 1000) ++sent;
    EXPECT_EQ(sent, 32);
    const auto before = Clock::now();
    EXPECT_EQ(client.send("x"), SendStatus::Full);
    EXPECT_LT(Clock::now() - before, 500ms);
    EXPECT_EQ(client.request("x", 10ms).status, ReplyStatus::NotSent);
    server->takeCommands();
    EXPECT_EQ(client.send("x"), SendStatus::Sent);
}

TEST_F(ServerClient, ImpossibleCommandsAreRefused) {
    const auto server = start();
    Client client(instance.name());
    EXPECT_THROW(client.send(std::string(8193, 'x')), Error);
    EXPECT_THROW(client.send(std::string_view("a\0b", 3)), Error);
    EXPECT_EQ(client.send(std::string(8192, 'x')), SendStatus::Sent);
    EXPECT_EQ(serve(*server, 1).at(0).text.size(), 8192u);
}

TEST_F(ServerClient, OneClientCannotKeepTheOthersFromBeingServed) {
    const auto server = start();
    Client flood(instance.name()), modest(instance.name());
    while (flood.send("flood") == SendStatus::Sent) {
    }
    modest.send("modest");
    const auto commands = server->takeCommands();
    EXPECT_EQ(commands.size(), 17u);
    EXPECT_EQ(commands.back().text, "modest");
}

TEST_F(ServerClient, AClientThatReadsNoAnswersIsNotServedWithoutEnd) {
    const auto server = start();
    Client client(instance.name());
    std::size_t taken = 0;
    for (int i = 0; i < 1000; ++i) {
        Ticket ticket = 0;
        client.send("x", &ticket);
        taken += server->takeCommands().size(); // never answered
    }
    EXPECT_EQ(taken, 64u);
}

TEST_F(ServerClient, LastWordsAreHeard) {
    const auto server = start();
    {
        Client client(instance.name());
        server->takeCommands();
        client.pressKey(3);
        client.send("goodbye");
    }
    const auto commands = server->takeCommands();
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_EQ(commands[0].text, "goodbye");
    EXPECT_EQ(server->clients(), 0);
    EXPECT_TRUE(server->keys().down.none());
    EXPECT_EQ(instance.segments().size(), 2u);
}

TEST_F(ServerClient, ThirtyTwoClientsAndAnyNumberOfViewers) {
    const auto server = start();
    std::vector<std::unique_ptr<Client>> clients;
    for (int i = 0; i < 32; ++i) clients.push_back(std::make_unique<Client>(instance.name()));
    const auto before = Clock::now();
    try {
        const Client extra(instance.name());
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.problem, Problem::NoSlot);
    }
    EXPECT_LT(Clock::now() - before, 500ms);
    std::vector<std::unique_ptr<Viewer>> viewers;
    for (int i = 0; i < 40; ++i) viewers.push_back(std::make_unique<Viewer>(instance.name()));
    for (const auto& client : clients) EXPECT_EQ(client->send("here"), SendStatus::Sent);
    EXPECT_EQ(serve(*server, 32).size(), 32u);
    EXPECT_EQ(server->clients(), 32);
    clients.pop_back();
    server->takeCommands();
    EXPECT_EQ(server->clients(), 31);
    EXPECT_NO_THROW(Client(instance.name()));
}

std::size_t openDescriptors() {
    const std::filesystem::directory_iterator folder("/proc/self/fd");
    return static_cast<std::size_t>(std::distance(begin(folder), end(folder)));
}

TEST_F(ServerClient, NothingIsLostByComingAndGoing) {
    const auto server = start();
    std::vector<std::unique_ptr<Client>> clients(32);
    for (std::uint32_t round = 0; round < 100; ++round) server->beginFrame(16 + round, 16);
    const std::size_t before = openDescriptors();
    for (std::size_t round = 0; round < 1000; ++round) {
        auto& client = clients[round * 7 % 32];
        client ? client.reset() : void(client = std::make_unique<Client>(instance.name()));
        if (round % 3 == 0) server->takeCommands();
    }
    clients.clear();
    server->takeCommands();
    EXPECT_EQ(server->clients(), 0);
    EXPECT_EQ(openDescriptors(), before);
    EXPECT_EQ(instance.segments().size(), 2u);
}

TEST_F(ServerClient, KeysAreUnitedAndCounted) {
    const auto server = start();
    Client one(instance.name()), two(instance.name());
    one.pressKey(10);
    two.pressKey(20);
    two.releaseKey(20);
    two.pressKey(999);
    server->takeCommands();
    const KeyState keys = server->keys();
    EXPECT_TRUE(keys.down[10]);
    EXPECT_FALSE(keys.down[20]);
    EXPECT_EQ(keys.presses[10], 1u);
    EXPECT_EQ(keys.presses[20], 1u);
    one.releaseAllKeys();
    EXPECT_TRUE(server->keys().down.none());
}

TEST_F(ServerClient, WaitEndsWithACommandAKeyAClient) {
    const auto server = start();
    EXPECT_FALSE(server->wait(1ms));
    Client client(instance.name());
    EXPECT_TRUE(server->wait(1s));
    server->takeCommands();
    while (server->wait(0s)) {
    }
    const auto wakes = [&](auto act) {
        std::thread actor([&] {
            std::this_thread::sleep_for(20ms);
            act();
        });
        const bool woken = server->wait(5s);
        actor.join();
        server->takeCommands();
        while (server->wait(0s)) {
        }
        return woken;
    };
    EXPECT_TRUE(wakes([&] { client.pressKey(1); }));
    EXPECT_TRUE(wakes([&] { client.send("x"); }));
}

TEST_F(ServerClient, FramesFollowEverySize) {
    const auto server = start();
    Viewer viewer(instance.name());
    Client client(instance.name());
    Frame frame, other;
    EXPECT_FALSE(viewer.readFrame(frame));
    const std::uint32_t sizes[][2] = {{16, 16}, {8, 4}, {64, 64}, {200, 100}, {1, 1}, {200, 100}, {300, 300}};
    std::uint64_t number = 0;
    for (const auto& size : sizes) {
        const auto pixels = server->beginFrame(size[0], size[1]);
        ASSERT_EQ(pixels.size(), 4u * size[0] * size[1]);
        std::fill(pixels.begin(), pixels.end(), static_cast<std::byte>(number));
        EXPECT_EQ(server->publishFrame({.run = 4, .tag = number}), number + 1);
        ASSERT_TRUE(viewer.readFrame(frame));
        ASSERT_TRUE(client.waitForFrame(other, 1s));
        for (const Frame* seen : {&frame, &other}) {
            EXPECT_EQ(seen->info.width, size[0]);
            EXPECT_EQ(seen->info.height, size[1]);
            EXPECT_EQ(seen->info.number, number + 1);
            EXPECT_EQ(seen->info.tag, number);
            EXPECT_EQ(seen->pixels.size(), pixels.size());
            EXPECT_EQ(seen->pixels.back(), static_cast<std::byte>(number));
        }
        EXPECT_FALSE(viewer.readFrame(frame));
        ++number;
        EXPECT_EQ(instance.segments().size(),
                  2u + (number == 1)); // the old size is gone; the queue's name, at first
        server->takeCommands();
    }
    EXPECT_THROW(server->beginFrame(0, 5), Error);
    EXPECT_THROW(server->beginFrame(20000, 5), Error);
}

TEST_F(ServerClient, AFrameTooLargeForMemoryLeavesTheLastOneStanding) {
    const auto server = start();
    const std::vector<std::byte> pixels(4 * 16 * 16, std::byte{7});
    server->publishFrame({.width = 16, .height = 16}, pixels);
    if (std::filesystem::space("/dev/shm").available > 3ull * 4 * 16384 * 16384) {
        GTEST_SKIP() << "shared memory has room for the largest frames";
    }
    EXPECT_THROW(server->beginFrame(16384, 16384), Error);
    Viewer viewer(instance.name());
    Frame frame;
    EXPECT_TRUE(viewer.readFrame(frame));
    EXPECT_EQ(frame.pixels, pixels);
}

TEST_F(ServerClient, WaitingForAFrameEndsWhenItComes) {
    const auto server = start();
    Client client(instance.name());
    server->takeCommands();
    std::thread publisher([&] {
        std::this_thread::sleep_for(30ms);
        server->beginFrame(16, 16);
        server->publishFrame();
    });
    Frame frame;
    EXPECT_FALSE(client.waitForFrame(frame, 1ms));
    EXPECT_TRUE(client.waitForFrame(frame, 5s));
    publisher.join();
}

TEST_F(ServerClient, StatusIsPassedOn) {
    const auto server = start();
    Viewer viewer(instance.name());
    EXPECT_EQ(viewer.status(), Status{});
    const Status status{
        .frameSeconds = 0.25, .raysPerSecond = 1e9, .polygons = 66450, .exposure = 0.5f, .idle = 1};
    server->setStatus(status);
    EXPECT_EQ(viewer.status(), status);
}

TEST_F(ServerClient, ASilentServerIsBusyNotGone) {
    const auto server = start();
    Client client(instance.name());
    server->takeCommands();
    EXPECT_EQ(client.update(), LinkState::Connected);
    std::this_thread::sleep_for(200ms); // a slow frame
    EXPECT_EQ(client.update(), LinkState::Connected);
    EXPECT_TRUE(becomes(client, LinkState::Busy));
    server->takeCommands();
    EXPECT_EQ(client.update(), LinkState::Connected);
}

TEST_F(ServerClient, ClientsFindTheNextServerWithTheirKeysDown) {
    auto server = start();
    Client client(instance.name());
    Viewer viewer(instance.name());
    client.pressKey(42);
    const std::uint64_t first = client.epoch();
    Ticket ticket = 0;
    client.send("unanswered", &ticket);
    server.reset();
    EXPECT_EQ(client.wait(ticket, 1s).status, ReplyStatus::Lost);
    EXPECT_EQ(client.update(), LinkState::Gone);
    EXPECT_EQ(viewer.update(), LinkState::Gone);
    EXPECT_EQ(client.send("x"), SendStatus::NoServer);
    EXPECT_TRUE(instance.segments().empty());
    server = start();
    std::this_thread::sleep_for(10ms);
    EXPECT_EQ(client.update(), LinkState::Connected);
    EXPECT_EQ(viewer.update(), LinkState::Connected);
    EXPECT_NE(client.epoch(), first);
    EXPECT_EQ(viewer.epoch(), server->epoch());
    server->takeCommands();
    EXPECT_TRUE(server->keys().down[42]);
    EXPECT_EQ(client.send("again"), SendStatus::Sent);
    EXPECT_EQ(serve(*server, 1).size(), 1u);
}

TEST_F(ServerClient, TheLastAnswerOfAServerArrives) {
    auto server = start();
    Client client(instance.name());
    Ticket ticket = 0;
    client.send("exit", &ticket);
    serve(*server, 1);
    server.reset();
    EXPECT_EQ(client.wait(ticket, 1s).status, ReplyStatus::Done);
}

TEST_F(ServerClient, RemovedNamesArePublishedAnew) {
    const auto server = start();
    Client client(instance.name());
    Viewer viewer(instance.name());
    const std::vector<std::byte> pixels(4 * 16 * 16, std::byte{7});
    server->publishFrame({.width = 16, .height = 16, .tag = 3}, pixels);
    server->setStatus({.polygons = 5});
    client.pressKey(9);
    server->takeCommands();
    const std::uint64_t first = server->epoch();
    for (const std::string& name : instance.segments()) Segment::remove(name);
    client.send("before");
    std::vector<Command> commands;
    const auto deadline = Clock::now() + 2s;
    while (server->epoch() == first && Clock::now() < deadline) {
        server->wait(10ms);
        for (auto& command : server->takeCommands()) commands.push_back(command);
    }
    ASSERT_NE(server->epoch(), first);
    EXPECT_EQ(commands.size(), 1u);
    std::this_thread::sleep_for(10ms);
    EXPECT_EQ(client.update(), LinkState::Connected);
    EXPECT_EQ(client.epoch(), server->epoch());
    EXPECT_EQ(client.send("after"), SendStatus::Sent);
    EXPECT_EQ(serve(*server, 1).size(), 1u);
    EXPECT_TRUE(server->keys().down[9]);
    Viewer late(instance.name());
    Frame frame;
    EXPECT_TRUE(late.readFrame(frame));
    EXPECT_EQ(frame.info.tag, 3u);
    EXPECT_EQ(frame.pixels, pixels);
    EXPECT_EQ(viewer.status().polygons, 5u);
}

// Nothing but the control segment tells who lives, and its name is looked after.
TEST_F(ServerClient, ARivalThatTookTheRemovedNameEndsTheServer) {
    const auto server = start();
    for (const std::string& name : instance.segments()) Segment::remove(name);
    const auto rival = start();
    const auto deadline = Clock::now() + 3s;
    const auto ends = [&] {
        try {
            while (Clock::now() < deadline) server->wait(10ms);
        } catch (const Error& error) {
            return error.problem == Problem::AlreadyRunning;
        }
        return false;
    };
    EXPECT_TRUE(ends());
    EXPECT_EQ(Viewer(instance.name()).epoch(), rival->epoch());
    EXPECT_EQ(instance.segments().size(), 2U);
}

TEST_F(ServerClient, ARemovedFrameNameComesBackUnderTheSameEpoch) {
    const auto server = start();
    const std::vector<std::byte> pixels(4 * 16 * 16, std::byte{7});
    server->publishFrame({.width = 16, .height = 16, .tag = 3}, pixels);
    const std::uint64_t epoch = server->epoch();
    Segment::remove(instance.names().frames(epoch, 1));
    const auto deadline = Clock::now() + 3s;
    while (instance.segments().size() < 2 && Clock::now() < deadline) server->wait(10ms);
    Viewer viewer(instance.name());
    Frame frame;
    EXPECT_TRUE(viewer.readFrame(frame));
    EXPECT_EQ(frame.info.tag, 3U);
    EXPECT_EQ(viewer.epoch(), epoch);
}

} // namespace
