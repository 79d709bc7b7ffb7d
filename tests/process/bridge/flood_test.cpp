// Bad clients harm nobody else.
#include "process/bridge/bridge_fixture.h"

#include <fmt/core.h>

namespace {

using namespace test;

class Floods : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({"--clients=120"});
    }

  protected:
    std::size_t memoryKb() const {
        std::ifstream status(fmt::format("/proc/{}/status", bridge.process()));
        for (std::string line; std::getline(status, line);)
            if (line.starts_with("VmRSS:")) return std::stoul(line.substr(6));
        return 0;
    }
    int framesWithin(WebClient& client, std::chrono::milliseconds time) {
        int frames = 0;
        const auto end = Clock::now() + time;
        while (Clock::now() < end) {
            const auto frame = client.binary(1, 100ms);
            if (!frame) continue;
            client.acknowledge(*frame);
            ++frames;
        }
        return frames;
    }
};

TEST_F(Floods, OfViewersThatNeitherReadNorAcknowledge) {
    const auto honest = join();
    std::vector<std::unique_ptr<WebClient>> bad;
    for (int i = 0; i < 100; ++i) {
        bad.push_back(std::make_unique<WebClient>(port));
        bad.back()->hello(kViewer);
        if (i % 2 == 0) bad.back()->event("welcome");
    }
    server->move(20);
    framesWithin(*honest, 500ms);
    const std::size_t before = memoryKb();
    EXPECT_GE(framesWithin(*honest, 2s), 10);
    EXPECT_LT(memoryKb(), before + 16'000) << "nothing is queued";
    if (!kSanitized) {
        EXPECT_LT(memoryKb(), 100'000U);
    }
}

TEST_F(Floods, OfMessagesCloseTheirOwnConnection) {
    const auto honest = join(), bad = join(kViewer);
    for (int i = 0; i < 2000; ++i)
        if (!bad->sendBinary({3, 1, 255, 0, 0, 5, 0xD0, 2})) break;
    const int code = bad->closeCode();
    EXPECT_TRUE(code == 4008 || code == 0) << code;
    EXPECT_EQ(honest->request({{"do", "walk"}})["ok"], true);
}

TEST_F(Floods, OfRequestsAreAnsweredInTurn) {
    const auto client = join();
    for (int i = 0; i < 100; ++i) client->sendText(fmt::format(R"({{"id":{},"do":"walk"}})", i));
    int answers = 0;
    while (answers < 100 && !client->event("answer").is_null()) ++answers;
    EXPECT_EQ(answers, 100) << "each gets one, be it a refusal";
}

TEST_F(Floods, OfSlowRequestsLeaveTheDoorOpen) {
    std::vector<RawSocket> slow;
    for (int i = 0; i < 300; ++i) {
        slow.emplace_back(port);
        slow.back().write("GET / HT");
    }
    const auto start = Clock::now();
    const auto honest = join();
    EXPECT_EQ(honest->request({{"do", "walk"}})["ok"], true);
    for (int i = 0; i < 11; ++i) {
        for (RawSocket& each : slow) each.write("x");
        std::this_thread::sleep_for(1s);
        EXPECT_TRUE(i != 5 || page("/health").starts_with("HTTP/1.1 200"));
    }
    std::size_t closed = 0;
    for (RawSocket& each : slow) {
        each.read(0ms);
        each.read(0ms);
        closed += each.closed() ? 1U : 0U;
    }
    EXPECT_EQ(closed, slow.size()) << "each had ten seconds";
    EXPECT_GE(Clock::now() - start, 10s);
}

TEST_F(Floods, OfOpenedPagesEndAtTheLimit) {
    std::vector<std::unique_ptr<WebClient>> all;
    int refused = 0;
    for (int i = 0; i < 130; ++i) {
        all.push_back(std::make_unique<WebClient>(port));
        refused += all.back()->status() == 503 ? 1 : 0;
    }
    EXPECT_EQ(refused, 10);
    all.clear();
    EXPECT_TRUE(eventually([&] { return WebClient(port).status() == 101; }, 5s));
}

} // namespace
