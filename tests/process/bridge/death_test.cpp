// Server and bridge may die at any moment, and come again. RT_BRIDGE_DEATHS asks for more rounds.
#include "process/bridge/bridge_fixture.h"

#include "ipc/endpoint/client.h"

#include <memory>
#include <random>
#include <thread>
#include <vector>

namespace {

using namespace test;
using nlohmann::json;

class Deaths : public BridgeTest {
  protected:
    static int rounds() { return asked("RT_BRIDGE_DEATHS", 10); }
    static bool becomes(WebClient& client, const std::string& state) {
        for (json event = client.event("server", 10s); !event.is_null(); event = client.event("server", 10s))
            if (event["state"] == state) return true;
        return false;
    }
    void tapWithoutServer(WebClient& client) {
        for (int k = 0; k < 5; ++k) client.input({}, 10'000, 0, {'F', 'B'});
        std::this_thread::sleep_for(300ms); // the bridge looks for a server meanwhile
        startServer();
        ASSERT_TRUE(becomes(client, "there"));
        client.input({'W'}, 0, 0, {'J'});
        EXPECT_TRUE(eventually([&] { return server->isHeld('W') && server->presses('J') == 1; }));
        EXPECT_EQ(server->presses('F') + server->presses('B'), 0U);
        EXPECT_TRUE(server->commands().empty()) << "no turn either";
    }
};

TEST_F(Deaths, OfTheServerAreToldAndItsSuccessorIsFound) {
    const auto client = join();
    std::mt19937 random(5);
    ASSERT_TRUE(becomes(*client, "there"));
    for (int round = 0; round < rounds(); ++round) {
        server->move(50);
        client->input({'W'});
        ASSERT_TRUE(client->binary(1)) << round;
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 50));
        server.reset();
        ASSERT_TRUE(becomes(*client, "gone")) << round;
        startServer();
        ASSERT_TRUE(becomes(*client, "there")) << round;
        client->input({});
        server->move(50);
        const auto frame = client->binary(1);
        ASSERT_TRUE(frame) << round;
        client->acknowledge(*frame);
        EXPECT_EQ(client->request({{"do", "walk"}})["ok"], true) << round;
        EXPECT_TRUE(eventually([&] { return !server->anyHeld(); }));
    }
}

TEST_F(Deaths, OfTheBridgeLeaveNothingBehind) {
    const std::string listen = "127.0.0.1:" + std::to_string(port);
    for (int round = 0; round < rounds() / 2; ++round) {
        const auto client = join();
        ASSERT_TRUE(becomes(*client, "there")) << round;
        client->input({'W'});
        ASSERT_TRUE(eventually([&] { return server->isHeld('W'); })) << round;
        bridge.kill();
        EXPECT_TRUE(eventually([&] { return !server->anyHeld() && server->clients() == 0; }, 3s)) << round;
        startBridge({}, listen);
    }
    EXPECT_TRUE(join()->binary(1));
}

TEST_F(Deaths, BeforeAServerThereIsAPageAndNoHealth) {
    server.reset();
    EXPECT_TRUE(eventually([&] { return page("/health").starts_with("HTTP/1.1 503"); }, 5s));
    EXPECT_TRUE(page("/").starts_with("HTTP/1.1 200"));
    const auto client = join();
    EXPECT_EQ(client->request({{"do", "walk"}})["ok"], false);
    startServer();
    EXPECT_TRUE(client->binary(1, 10s));
}

TEST_F(Deaths, LeaveNothingThatWasTappedMeanwhileToTheSuccessor) {
    const auto client = join();
    ASSERT_TRUE(becomes(*client, "there"));
    server.reset();
    ASSERT_TRUE(becomes(*client, "gone"));
    tapWithoutServer(*client);
}

TEST_F(Deaths, LeaveNothingThatWasTappedBeforeTheFirstServerToIt) {
    server.reset();
    startBridge();
    const auto client = join();
    ASSERT_TRUE(becomes(*client, "gone"));
    tapWithoutServer(*client);
}

TEST_F(Deaths, OfTheServerAnswerWhatWasUnderWay) {
    const auto client = join();
    ASSERT_TRUE(becomes(*client, "there"));
    server->fallSilent();
    std::thread killer([&] {
        eventually([&] { return !server->commands().empty(); });
        server.reset();
    });
    const json answer = client->request({{"do", "walk"}}, 20s);
    killer.join();
    ASSERT_TRUE(answer.is_object());
    EXPECT_FALSE(answer.value("ok", true)) << answer;
    EXPECT_EQ(answer.value("text", ""), "the server ended before it answered");
    startServer();
    ASSERT_TRUE(becomes(*client, "there"));
    EXPECT_EQ(client->request({{"do", "walk"}})["ok"], true);
}

TEST_F(Deaths, OfNoneButNoPlaceIsToldUntilThereIsOne) {
    std::vector<std::unique_ptr<ipc::Client>> others;
    const auto takeAll = [&] {
        for (;;) others.push_back(std::make_unique<ipc::Client>(instance.name(), 0ns));
    };
    EXPECT_THROW(takeAll(), ipc::Error);
    const auto client = join();
    ASSERT_TRUE(becomes(*client, "refused"));
    EXPECT_EQ(client->request({{"do", "walk"}})["ok"], false);
    EXPECT_TRUE(page("/health").starts_with("HTTP/1.1 503"));
    others.clear();
    ASSERT_TRUE(becomes(*client, "there"));
    server->move(50);
    EXPECT_TRUE(client->binary(1));
}

TEST_F(Deaths, InGoodOrderAreToldToPages) {
    const auto client = join();
    bridge.send(SIGTERM);
    EXPECT_EQ(client->closeCode(), 1001);
    const int status = bridge.wait(5s);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 143);
}

} // namespace
