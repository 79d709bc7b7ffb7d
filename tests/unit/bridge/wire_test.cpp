#include "bridge/stream/wire.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(Wire, PutsAFramesHeaderAsDocumented) {
    auto frame = std::make_shared<bridge::EncodedFrame>();
    frame->facts = {0x01020304, 0x1122334455667788, 640, 360, 1280, 720, 0};
    frame->bytes.resize(70'000);
    frame->codec = bridge::Codec::Png;
    frame->exact = true;
    const bridge::Header header = bridge::headerOf({frame, true, 65536, 70'000 - 65536}, 9, 1000);
    const Bytes expected{2,    1,    7,    0, 4,    3, 2, 1, 0x88, 0x77, 0x66, 0x55, 0x44, 0x33,
                         0x22, 0x11, 0x80, 2, 0x68, 1, 0, 5, 0xD0, 2,    9,    0,    0,    0,
                         0xE8, 3,    0,    0, 0,    0, 1, 0, 0x70, 0x11, 1,    0};
    EXPECT_EQ(Bytes(header.begin(), header.end()), expected);
    const bridge::Header whole = bridge::headerOf({frame, false, 0, frame->bytes.size()}, 0, 0);
    EXPECT_EQ(whole[0], 1);
    EXPECT_EQ(whole[2] & 4, 0);
}

TEST(Wire, ReadsWhatPagesSend) {
    const Bytes ack{1, 0, 0x2C, 1, 5, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0};
    const auto message = bridge::parseClientMessage(ack);
    ASSERT_TRUE(message && std::holds_alternative<bridge::AckMessage>(*message));
    EXPECT_NEAR(std::get<bridge::AckMessage>(*message).decodeSeconds, 0.03, 1e-9);
    EXPECT_EQ(std::get<bridge::AckMessage>(*message).number, 7U);

    const Bytes input{2, 2, 1, 0, 3, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 10, 0, 0, 0, 'W', 132, ' '};
    const auto keys = bridge::parseClientMessage(input);
    ASSERT_TRUE(keys && std::holds_alternative<bridge::InputMessage>(*keys));
    const auto& said = std::get<bridge::InputMessage>(*keys);
    EXPECT_EQ(said.sequence, 3U);
    EXPECT_EQ(said.right, -1);
    EXPECT_EQ(said.up, 10);
    EXPECT_EQ(said.held, (Bytes{'W', 132}));
    EXPECT_EQ(said.taps, Bytes{' '});

    const Bytes view{3, 1, 255, 1, 0x80, 2, 0x68, 1};
    const auto page = bridge::parseClientMessage(view);
    ASSERT_TRUE(page && std::holds_alternative<bridge::PageView>(*page));
    EXPECT_EQ(std::get<bridge::PageView>(*page).width, 640);
    EXPECT_TRUE(std::get<bridge::PageView>(*page).saveData);
    EXPECT_FALSE(std::get<bridge::PageView>(*page).rung);
}

TEST(Wire, RefusesOtherLengthsAndTypes) {
    const std::vector<Bytes> wrong{{},
                                   {0},
                                   {9, 0, 0, 0},
                                   Bytes(15, 1),
                                   Bytes(17, 1),
                                   {3, 2, 255, 0, 0, 0, 0, 0},
                                   {3, 1, 6, 0, 0, 0, 0, 0},
                                   {3, 1, 255, 0, 0, 0, 0},
                                   {2, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
                                   Bytes{2, 17, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1,
                                         1, 1,  1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1},
                                   {2, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0x7F, 0, 0, 0, 0},
                                   {5, 0, 0, 0}};
    for (const Bytes& bytes : wrong)
        EXPECT_FALSE(bridge::parseClientMessage(bytes)) << testing::PrintToString(bytes);
}

TEST(Wire, SurvivesAnyBytes) {
    std::mt19937 random(1);
    for (int i = 0; i < 100'000; ++i) {
        Bytes bytes(random() % 48);
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % (i % 2 == 0 ? 256 : 20));
        const auto message = bridge::parseClientMessage(bytes);
        if (!message || !std::holds_alternative<bridge::InputMessage>(*message)) continue;
        const auto& input = std::get<bridge::InputMessage>(*message);
        ASSERT_EQ(16 + input.held.size() + input.taps.size(), bytes.size());
        ASSERT_LE(std::abs(input.right), 360'000);
    }
}

} // namespace
