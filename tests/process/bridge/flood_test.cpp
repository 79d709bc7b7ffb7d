// Bad clients harm nobody else.
#include "process/bridge/bridge_fixture.h"
#include "support/holdings.h"

#include <fmt/core.h>

namespace {

using namespace test;

class Floods : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({"--clients=120"});
    }

  protected:
    using Clients = std::vector<std::unique_ptr<WebClient>>;

    /// 50 that read all and acknowledge nothing, 50 that read nothing after their welcome.
    Clients badClients(Clients& readers) {
        Clients deaf;
        for (int i = 0; i < 50; ++i) {
            readers.push_back(join(kViewer));
            deaf.push_back(join(kViewer));
        }
        return deaf;
    }
    /// The fraction of the frames published by the server that an honest client gets, 1 is all.
    double fractionWithin(WebClient& client, std::chrono::seconds time, Clients& readers) {
        int frames = 0;
        std::size_t turn = 0;
        const std::size_t before = server->published();
        for (const auto end = Clock::now() + time; Clock::now() < end;) {
            const auto frame = client.binary(1, 5ms);
            if (frame) client.acknowledge(*frame);
            frames += frame ? 1 : 0;
            if (!readers.empty()) readers[turn++ % readers.size()]->next(0ms);
        }
        return frames / static_cast<double>(std::max<std::size_t>(server->published() - before, 1));
    }
};

// RT_BRIDGE_FLOOD asks for that many seconds, and then for nearly all frames.
TEST_F(Floods, OfViewersThatNeitherReadNorAcknowledge) {
    const int time = asked("RT_BRIDGE_FLOOD", 2);
    const bool full = time > 2;
    const auto honest = join();
    Clients readers, deaf = badClients(readers);
    server->show(640, 360);
    server->move(20);
    fractionWithin(*honest, 1s, readers);
    const std::size_t before = holdingsOf(bridge.process()).privateBytes;
    const double fraction = fractionWithin(*honest, std::chrono::seconds(time), readers);
    const std::size_t after = holdingsOf(bridge.process()).privateBytes;
    RecordProperty("fraction", std::to_string(fraction));
    if (full)
        fmt::print("100 bad clients: {:.1f} % of the frames, {:.1f} MB\n", 100 * fraction,
                   static_cast<double>(after) / 1e6);
    EXPECT_GE(fraction, full ? 0.95 : 0.3);
    if (kSanitized) return;
    EXPECT_LT(after, before + 16'000'000) << "nothing is queued";
    EXPECT_LT(after, 64'000'000U);
}

// The second message comes while the connection is being closed for the first one, or for too many pings.
TEST_F(Floods, OfWrongAndTooLargeMessagesLeaveNobody) {
    std::string pings;
    for (int i = 0; i < 600; ++i) pings += webFrame(0x89, "");
    const std::string large = webFrame(0x81, std::string(6000, 'x'));
    Clients open; // some do not leave
    for (int i = 0; i < 130; ++i) {
        auto client = std::make_unique<WebClient>(port);
        ASSERT_EQ(client->status(), 101) << i;
        client->socket().write((i % 10 == 0 ? pings : webFrame(0x81, "wrong")) + large);
        if (i % 20 == 0 || i % 21 == 0) open.push_back(std::move(client));
    }
    EXPECT_TRUE(eventually([&] { return visitors() == 0; }, 20s)) << visitors();
}

// The half of it that is no text comes while the connection is being closed since no hello came.
TEST_F(Floods, OfHalfMessagesThatTurnOutWrongLeaveNobody) {
    const std::string message = webFrame(0x81, std::string(50, 'x') + std::string(50, '\xff'));
    const std::size_t half = message.size() - 50;
    WebClient client(port);
    client.socket().write(message.substr(0, half));
    EXPECT_EQ(client.closeCode(10s), 4001);
    client.socket().write(message.substr(half));
    EXPECT_TRUE(eventually([&] { return visitors() == 0; }, 20s)) << visitors();
}

TEST_F(Floods, OfMessagesCloseTheirOwnConnection) {
    const auto honest = join(), bad = join(kViewer);
    for (int i = 0; i < 2000; ++i)
        if (!bad->sendBinary({3, 1, 255, 0, 0, 5, 0xD0, 2})) break;
    const int code = bad->closeCode();
    EXPECT_TRUE(code == 4008 || code == 0) << code;
    EXPECT_EQ(honest->request({{"do", "walk"}})["ok"], true);
}

// A link that is gone without a word keeps nothing.
TEST_F(Floods, OfPingsWithoutAPongEndTheConnection) {
    if (asked("RT_BRIDGE_IDLE", 0) == 0) GTEST_SKIP() << "RT_BRIDGE_IDLE is not set: it takes half a minute";
    const auto client = join();
    client->answersPings = false;
    const auto begin = Clock::now();
    EXPECT_NE(client->closeCode(60s), -1);
    EXPECT_GT(Clock::now() - begin, 20s);
    EXPECT_TRUE(eventually([&] { return visitors() == 0; }, 10s));
}

TEST_F(Floods, OfNamesAreToldNowAndThen) {
    const auto honest = join(), bad = join(kViewer);
    for (int i = 0; i < 200; ++i) bad->sendText(fmt::format(R"({{"id":{},"do":"name","name":"{}"}})", i, i));
    int answers = 0, refused = 0;
    for (; answers < 200; ++answers) {
        const auto answer = bad->event("answer");
        if (answer.is_null()) break;
        refused += answer["ok"] == false ? 1 : 0;
    }
    EXPECT_EQ(answers, 200);
    EXPECT_GT(refused, 150);
    int told = 0;
    while (!honest->event("roles", 300ms).is_null()) ++told;
    EXPECT_LT(told, 40) << "the others are told of some";
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
    Clients all;
    for (int i = 0; i < 120; ++i) all.push_back(join(kViewer));
    for (int i = 0; i < 10; ++i) EXPECT_EQ(WebClient(port).status(), 503) << i;
    all.clear();
    EXPECT_TRUE(eventually([&] { return WebClient(port).status() == 101; }, 5s));
}

// None of its parts makes a message.
TEST_F(Floods, OfPartsOfAMessageThatNeverEndsAreClosed) {
    const auto honest = join();
    std::string parts;
    for (int i = 0; i < 5000; ++i) parts += webFrame(0x00, "");
    for (const bool welcome : {true, false}) {
        auto bad = welcome ? join(kViewer) : std::make_unique<WebClient>(port);
        bad->socket().write(webFrame(0x01, ""));
        const auto end = Clock::now() + 15s;
        while (Clock::now() < end && bad->socket().write(parts)) {
        }
        const int code = bad->closeCode(1s);
        EXPECT_TRUE(code == 4008 || code == 0) << code;
        EXPECT_LT(Clock::now(), end);
    }
    EXPECT_EQ(honest->request({{"do", "walk"}})["ok"], true);
    EXPECT_TRUE(eventually([&] { return visitors() == 1; }, 10s)) << visitors();
}

TEST_F(Floods, OfPartsThatComeSlowlyEndTooButThoseOfAWholeMessageAreRight) {
    const auto bad = join(kViewer);
    bad->socket().write(webFrame(0x01, ""));
    std::string parts;
    for (int i = 0; i < 1000; ++i) parts += webFrame(0x00, "");
    int code = -1;
    for (int i = 0; i < 200 && code == -1; ++i) { // a fifth of the bytes that may come in a second
        bad->socket().write(parts);
        code = bad->closeCode(30ms);
    }
    EXPECT_EQ(code, 4008);
    // As many parts, and more bytes, as the longest message can have.
    const auto good = join(kViewer);
    const std::string request = R"({"id":7,"do":"parts","x":")" + std::string(8000, 'x') + "\"}";
    for (int round = 0; round < 10; ++round) {
        std::string cut;
        for (std::size_t i = 0; i < request.size(); ++i)
            cut += webFrame((i == 0 ? 1 : 0) | (i + 1 == request.size() ? 0x80 : 0), request.substr(i, 1));
        good->socket().write(cut);
        EXPECT_EQ(good->event("answer")["id"], 7) << round;
    }
}

/// Those that say nothing hold no place that another one needs.
class SilentCrowds : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({"--clients=12"});
    }

  protected:
    using Clients = std::vector<std::unique_ptr<WebClient>>;

    Clients silent(int count) const {
        Clients all;
        for (int i = 0; i < count; ++i) all.push_back(std::make_unique<WebClient>(port));
        return all;
    }
    static std::size_t thatAreOpen(Clients& clients) {
        return static_cast<std::size_t>(std::ranges::count_if(
            clients, [](const auto& each) { return each->status() == 101 && each->closeCode(10ms) == -1; }));
    }
};

TEST_F(SilentCrowds, KeepNobodyOut) {
    const auto honest = join();
    Clients all = silent(40);
    EXPECT_EQ(thatAreOpen(all), 11U) << "the others made room, each at once";
    const auto late = join(kViewer);
    EXPECT_EQ(thatAreOpen(all), 10U);
    EXPECT_EQ(late->request({{"do", "walk"}})["ok"], false) << "a viewer";
    EXPECT_EQ(honest->request({{"do", "walk"}})["ok"], true);
    Clients viewers;
    for (int i = 0; i < 10; ++i) viewers.push_back(join(kViewer));
    EXPECT_EQ(thatAreOpen(all), 0U);
    EXPECT_EQ(WebClient(port).status(), 503) << "those that are in have their places";
}

TEST_F(SilentCrowds, WithWrongTokensKeepNobodyOut) {
    Clients all = silent(20);
    for (auto& each : all) each->hello("wrong");
    for (int i = 0; i < 20; ++i) page("/status", "Authorization: Bearer wrong\r\n");
    EXPECT_FALSE(join()->event("roles").is_null());
    EXPECT_TRUE(page("/status", "Authorization: Bearer " + std::string(kDriver) + "\r\n")
                    .starts_with("HTTP/1.1 200"));
}

} // namespace
