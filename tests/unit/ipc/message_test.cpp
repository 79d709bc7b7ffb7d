#include "ipc/channel/message.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <random>

namespace {

using namespace ipc;

constexpr std::uint64_t kEpoch = 0x1234567890ABCDEF;

int mutations() {
    const char* asked = std::getenv("RT_MUTATIONS");
    return asked == nullptr ? 100000 : std::max(1, std::atoi(asked));
}

TEST(Message, SurvivesTheWay) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{100}, kMaxCommandText}) {
        const Message sent{7, size % 2 == 0, std::string(size, 'x')};
        Message received;
        ASSERT_TRUE(decode(encode(sent, kEpoch), kEpoch, 6, received)) << size;
        EXPECT_EQ(received.sequence, 7u);
        EXPECT_EQ(received.wantsAnswer, sent.wantsAnswer);
        EXPECT_EQ(received.text, sent.text);
    }
}

TEST(Message, IsForOneEpochAndComesOnce) {
    const auto bytes = encode({7, true, "ping"}, kEpoch);
    Message message{1, false, "untouched"};
    EXPECT_FALSE(decode(bytes, kEpoch + 1, 0, message));
    EXPECT_FALSE(decode(bytes, kEpoch, 7, message));
    EXPECT_FALSE(decode(bytes, kEpoch, 8, message));
    EXPECT_EQ(message.text, "untouched");
    EXPECT_TRUE(decode(bytes, kEpoch, 6, message));
}

TEST(Message, ASingleWrongBitIsNoticed) {
    const auto bytes = encode({7, true, "set bloom.radius 3"}, kEpoch);
    Message message;
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        auto wrong = bytes;
        wrong[bit / 8] ^= static_cast<std::byte>(1 << (bit % 8));
        EXPECT_FALSE(decode(wrong, kEpoch, 0, message)) << "bit " << bit;
    }
}

TEST(Message, EveryTruncationIsNoticed) {
    const auto bytes = encode({7, true, "export camera /tmp/a.cam 640 480"}, kEpoch);
    Message message;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_FALSE(decode(std::span(bytes).first(size), kEpoch, 0, message)) << size;
    }
}

TEST(Message, TextHasNoNul) {
    Message message;
    EXPECT_FALSE(decode(encode({1, true, std::string("a\0b", 3)}, kEpoch), kEpoch, 0, message));
}

TEST(Message, ChecksumIsTheUsualOne) {
    const std::string text = "123456789";
    EXPECT_EQ(crc32(std::as_bytes(std::span(text))), 0xCBF43926u);
}

// Buffers of exact size, so that the address sanitizer sees the first byte too far.
TEST(Message, MutatedBytesAreThrownAway) {
    std::mt19937_64 random(1);
    int accepted = 0;
    for (int i = 0; i < mutations(); ++i) {
        std::vector<std::byte> bytes, intact;
        if (i % 2 == 0) {
            bytes.resize(random() % (sizeof(MessageHeader) + 64));
            for (auto& byte : bytes) byte = static_cast<std::byte>(random());
        } else {
            bytes = encode({1 + random() % 9, true, std::string(random() % 64, 'a')}, kEpoch);
            intact = bytes;
            for (std::uint64_t n = 1 + random() % 4; n > 0; --n) {
                bytes[random() % bytes.size()] ^= static_cast<std::byte>(1 + random() % 255);
            }
            if (random() % 4 == 0) bytes.resize(random() % (bytes.size() + 1));
        }
        bytes.shrink_to_fit();
        Message message;
        accepted += decode(bytes, kEpoch, 0, message) && bytes != intact;
    }
    EXPECT_EQ(accepted, 0);
}

} // namespace
