#include "ipc/channel/reply_channel.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <thread>

namespace {

using namespace ipc;

struct Ring {
    Ring() { writer.reset(*ring); }
    std::unique_ptr<ReplyRing> ring = std::make_unique<ReplyRing>();
    ReplyWriter writer;
    ReplyReader reader;
};

TEST(Replies, ComeInOrderAndWrapAround) {
    Ring r;
    ReplyRecord reply;
    for (std::uint64_t i = 1; i < 500; ++i) {
        const std::string text(i * 37 % 3000, static_cast<char>('a' + i % 26));
        ASSERT_EQ(r.writer.write(*r.ring, {i, static_cast<std::uint16_t>(i % 2), text, {}}),
                  RingResult::Done);
        ASSERT_EQ(r.reader.read(*r.ring, reply), RingResult::Done);
        EXPECT_EQ(reply.sequence, i);
        EXPECT_EQ(reply.code, i % 2);
        EXPECT_EQ(reply.text, text);
        EXPECT_EQ(r.reader.read(*r.ring, reply), RingResult::Nothing);
    }
}

TEST(Replies, TheLargestFillsTheRing) {
    Ring r;
    ReplyRecord reply;
    const std::string text(kMaxAnswerText, 'x');
    ASSERT_EQ(r.writer.write(*r.ring, {1, 0, text, {}}), RingResult::Done);
    EXPECT_EQ(r.writer.write(*r.ring, {2, 0, "", {}}), RingResult::Nothing);
    ASSERT_EQ(r.reader.read(*r.ring, reply), RingResult::Done);
    EXPECT_EQ(reply.text, text);
    EXPECT_EQ(r.writer.write(*r.ring, {2, 0, "", {}}), RingResult::Done);
}

TEST(Replies, HaveATextAndADetail) {
    Ring r;
    ReplyRecord reply;
    for (std::uint64_t i = 1; i < 500; ++i) {
        const std::string text(i * 37 % 3000, 'a'), detail(i * 41 % 3000, 'b');
        ASSERT_EQ(r.writer.write(*r.ring, {i, 1, text, detail}), RingResult::Done);
        ASSERT_EQ(r.reader.read(*r.ring, reply), RingResult::Done);
        EXPECT_EQ(reply.text, text);
        EXPECT_EQ(reply.detail, detail);
    }
}

TEST(Replies, NonsenseIsNoticedByBothSides) {
    ReplyRecord reply;
    {
        Ring r;
        r.ring->head = kReplyBytes + 16;
        EXPECT_EQ(r.reader.read(*r.ring, reply), RingResult::Broken);
    }
    {
        Ring r;
        r.ring->head = 8;
        EXPECT_EQ(r.reader.read(*r.ring, reply), RingResult::Broken);
    }
    {
        Ring r;
        ASSERT_EQ(r.writer.write(*r.ring, {1, 0, "text", {}}), RingResult::Done);
        const ReplyHeader wrong{1, 0, 0, 0xFFFFFFF0};
        std::memcpy(r.ring->bytes, &wrong, sizeof(wrong));
        EXPECT_EQ(r.reader.read(*r.ring, reply), RingResult::Broken);
        const ReplyHeader more{1, 0, 13, 4};
        std::memcpy(r.ring->bytes, &more, sizeof(more));
        EXPECT_EQ(r.reader.read(*r.ring, reply), RingResult::Broken)
            << "the detail has bytes that are not there";
    }
    {
        Ring r;
        r.ring->tail = 5000;
        EXPECT_EQ(r.writer.write(*r.ring, {1, 0, "text", {}}), RingResult::Broken);
    }
}

TEST(Replies, SurviveThreads) {
    Ring r;
    constexpr std::uint64_t kReplies = 20000;
    std::thread writer([&] {
        for (std::uint64_t i = 1; i <= kReplies;) {
            const std::string text(i % 1000, static_cast<char>('a' + i % 26));
            if (r.writer.write(*r.ring, {i, 0, text, {}}) == RingResult::Done) {
                ++i;
            } else {
                std::this_thread::yield();
            }
        }
    });
    int wrong = 0;
    for (std::uint64_t i = 1; i <= kReplies;) {
        ReplyRecord reply;
        if (r.reader.read(*r.ring, reply) != RingResult::Done) {
            std::this_thread::yield();
            continue;
        }
        const std::string text(i % 1000, static_cast<char>('a' + i % 26));
        wrong += reply.sequence != i || reply.text != text;
        ++i;
    }
    writer.join();
    EXPECT_EQ(wrong, 0);
}

} // namespace
