// Frames: each is whole, no older than it says, and exact at rest.
#include "process/bridge/bridge_fixture.h"
#include "process/bridge/png_pixels.h"

#include <array>

namespace {

using namespace test;

class Frames : public BridgeTest {};

class LimitedFrames : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({"--max-mbit=6"});
    }
};

TEST_F(Frames, BeginWithWhatIsShown) {
    const auto client = join();
    const auto frame = client->binary(1);
    ASSERT_TRUE(frame);
    const FrameHeader header = headerOf(frame->payload);
    EXPECT_EQ(header.width, 320);
    EXPECT_EQ(header.shownHeight, 200);
    EXPECT_EQ(header.total, frame->payload.size() - 40);
    EXPECT_EQ(frame->payload.substr(40, 2), "\xFF\xD8");
}

TEST_F(Frames, AtRestAreExactAtEveryRung) {
    for (const int rung : {255, 0, 3, 5}) {
        const auto client = join();
        client->sendBinary({3, 1, static_cast<std::uint8_t>(rung), 0, 0, 5, 0xD0, 2});
        server->show(301, 199);
        EXPECT_TRUE(eventually([&] { return server->pixels().size() == 301U * 199 * 4; }));
        std::vector<std::uint8_t> shown;
        // What is learned of indirect light is shown before its last image.
        for (int i = 0; i < 6 && !areSame(shown, server->pixels()); ++i) shown = rgbOf(stillOf(*client));
        EXPECT_TRUE(areSame(shown, server->pixels())) << "rung " << rung;
    }
}

TEST_F(Frames, AreFollowedBySilenceAtRest) {
    const auto client = join();
    stillOf(*client);
    for (int i = 0; i < 20 && client->next(1200ms); ++i) { // figures of what was sent
    }
    EXPECT_FALSE(client->next(1500ms));
}

TEST_F(Frames, OfTheSameRungAreTheSameBytesForAll) {
    const auto first = join(), second = join(kViewer);
    const auto a = first->binary(1), b = second->binary(1);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->payload.substr(40), b->payload.substr(40));
}

TEST_F(Frames, WaitForAcknowledgements) {
    const auto client = join();
    server->move(100);
    int frames = 0;
    while (frames < 50) {
        const auto frame = client->next(400ms);
        if (!frame) break;
        if (frame->opcode == 2 && headerOf(frame->payload).type == 1) ++frames;
    }
    EXPECT_GE(frames, 2);
    EXPECT_LE(frames, 6) << "without an acknowledgement";
}

TEST_F(Frames, SkipTheOldOnes) {
    const auto client = join();
    server->move(100);
    std::uint64_t last = 0;
    int skips = 0;
    for (int i = 0; i < 15; ++i) {
        const auto frame = client->binary(1);
        ASSERT_TRUE(frame);
        const FrameHeader header = headerOf(frame->payload);
        EXPECT_GT(header.number, last);
        skips += header.number > last + 1 ? 1 : 0;
        last = header.number;
        std::this_thread::sleep_for(50ms);
        client->acknowledge(*frame);
    }
    EXPECT_GT(skips, 3);
}

TEST_F(Frames, StopForAHiddenPageAndGoOnWithTheNewest) {
    const auto client = join();
    server->move(50);
    ASSERT_TRUE(client->binary(1));
    client->sendBinary({3, 0, 255, 0, 0, 0, 0, 0});
    while (client->binary(1, 300ms)) {
    }
    client->sendBinary({3, 1, 255, 0, 0, 0, 0, 0});
    EXPECT_TRUE(client->binary(1));
}

TEST_F(Frames, LeaveTheServerAloneWithoutViewers) {
    {
        const auto client = join();
        ASSERT_TRUE(client->binary(1));
        EXPECT_TRUE(eventually([&] { return server->clients() == 2; }));
    }
    EXPECT_TRUE(eventually([&] { return server->clients() == 0; }, 5s));
}

TEST_F(Frames, OfAnotherSizeAreAnotherStream) {
    const auto client = join();
    const auto first = client->binary(1);
    ASSERT_TRUE(first);
    client->acknowledge(*first);
    server->show(64, 48);
    FrameHeader header = headerOf(first->payload);
    while (header.shownWidth != 64) {
        const auto next = client->binary(1);
        ASSERT_TRUE(next);
        client->acknowledge(*next);
        header = headerOf(next->payload);
    }
    EXPECT_NE(header.stream, headerOf(first->payload).stream);
}

TEST_F(Frames, TellWhichInputWasBeforeThem) {
    const auto client = join();
    server->move(50);
    client->input({}, 1000, 0);
    for (int i = 0; i < 100; ++i) {
        const auto frame = client->binary(1);
        ASSERT_TRUE(frame);
        client->acknowledge(*frame);
        if (headerOf(frame->payload).input == 1) return;
    }
    FAIL() << "no frame tells of the input";
}

TEST_F(LimitedFrames, OfAllPagesTogetherKeepTheLimit) {
    constexpr double kMbit = 6;
    const auto one = join(), other = join(kViewer);
    server->show(1280, 720);
    server->move(40);
    // Bytes of both within a time.
    const auto received = [&](std::chrono::milliseconds time) {
        std::array<double, 2> bytes{};
        for (const auto end = Clock::now() + time; Clock::now() < end;)
            for (std::size_t i = 0; i < bytes.size(); ++i)
                if (const auto frame = (i == 0 ? one : other)->binary(1, 5ms)) {
                    bytes[i] += static_cast<double>(frame->payload.size());
                    (i == 0 ? one : other)->acknowledge(*frame);
                }
        return bytes;
    };
    received(3s); // until coarser frames are chosen
    const auto bytes = received(4s);
    EXPECT_LT(8e-6 * (bytes[0] + bytes[1]) / 4, 1.3 * kMbit);
    EXPECT_GT(bytes[0], 0.2 * bytes[1]) << "both are served";
    EXPECT_GT(bytes[1], 0.2 * bytes[0]);
    server->finish();
    for (WebClient* const client : {one.get(), other.get()}) {
        const std::vector<std::uint8_t> still = rgbOf(stillOf(*client));
        EXPECT_TRUE(areSame(still, server->pixels())) << "what waited comes";
    }
}

TEST_F(Frames, PingsComeBack) {
    const auto client = join();
    client->sendBinary({5, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8});
    const auto echo = client->binary(3);
    ASSERT_TRUE(echo);
    EXPECT_EQ(headerOf(echo->payload).number, 0x0807060504030201U);
}

} // namespace
