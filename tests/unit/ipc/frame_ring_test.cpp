/// The frame ring in memory of the test: what a reader gets while a writer is at any point.
#include "ipc/channel/frame_ring.h"
#include "ipc/channel/shared_copy.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <thread>

namespace {

using namespace ipc;

constexpr std::uint64_t kEpoch = 77, kGeneration = 5;

struct Ring {
    Ring(std::uint32_t slotCount, std::size_t frameBytes)
        : bytes(frameSegmentBytes(frameBytes, slotCount)), memory(std::aligned_alloc(4096, bytes), std::free),
          writer(zeroed(), frameBytes, slotCount, kEpoch, kGeneration, 1) {}
    void* zeroed() {
        std::memset(memory.get(), 0, bytes);
        return new (memory.get()) FrameSegment;
    }
    FrameRingReader reader(FrameRingReader::Copy copy = {}) const {
        return {memory.get(), bytes, std::move(copy)};
    }

    std::size_t bytes;
    std::unique_ptr<void, decltype(&std::free)> memory;
    FrameRingWriter writer;
};

constexpr std::uint32_t kSide = 16;
const FrameInfo kSmall{.width = kSide, .height = kSide};
constexpr std::size_t kSmallBytes = 4 * kSide * kSide;

void fill(std::span<std::byte> target, std::uint64_t number) {
    const std::vector<std::byte> bytes(target.size(), static_cast<std::byte>(number));
    copyToShared(target.data(), bytes.data(), bytes.size());
}
void publish(FrameRingWriter& writer, FrameInfo info = kSmall) {
    fill(writer.begin().first(pixelBytes(info)), writer.nextNumber());
    writer.publish(info);
}
bool isFrame(const FrameInfo& info, const std::vector<std::byte>& pixels) {
    const auto value = static_cast<std::byte>(info.number);
    return pixels.size() == pixelBytes(info) &&
           std::all_of(pixels.begin(), pixels.end(), [&](std::byte b) { return b == value; });
}

TEST(FrameRing, GivesTheNewestFrameOnce) {
    Ring ring(3, kSmallBytes);
    FrameInfo info;
    std::vector<std::byte> pixels;
    const auto reader = ring.reader();
    EXPECT_TRUE(reader.ready(kEpoch, kGeneration));
    EXPECT_EQ(reader.read(info, pixels), FrameRead::Old);
    for (std::uint64_t number = 1; number < 20; ++number) {
        publish(ring.writer,
                {.run = 9, .width = kSide, .height = 1 + static_cast<std::uint32_t>(number) % kSide});
        ASSERT_EQ(reader.read(info, pixels), FrameRead::New);
        EXPECT_EQ(info.number, number);
        EXPECT_EQ(info.run, 9u);
        EXPECT_TRUE(isFrame(info, pixels));
        EXPECT_EQ(reader.read(info, pixels), FrameRead::Old);
    }
}

TEST(FrameRing, AFrameThatIsBegunIsNotSeen) {
    Ring ring(3, kSmallBytes);
    publish(ring.writer);
    FrameInfo info;
    std::vector<std::byte> pixels;
    const auto reader = ring.reader();
    ASSERT_EQ(reader.read(info, pixels), FrameRead::New);
    fill(ring.writer.begin(), 200);
    EXPECT_EQ(reader.read(info, pixels), FrameRead::Old);
    // Another reader, that has not seen frame 1 yet.
    FrameInfo fresh;
    ASSERT_EQ(reader.read(fresh, pixels), FrameRead::New);
    EXPECT_EQ(fresh.number, 1u);
    EXPECT_TRUE(isFrame(fresh, pixels));
}

// The writer comes round while the reader copies; it is `steps` half-frames further then.
FrameRead readWhileWritten(Ring& ring, int steps, FrameInfo& info, std::vector<std::byte>& pixels) {
    bool once = true;
    const auto reader = ring.reader([&](void* to, const void* from, std::size_t bytes) {
        copyFromShared(to, from, bytes / 2);
        for (int step = 0; once && step < steps; ++step) {
            if (step % 2 == 0) fill(ring.writer.begin().first(kSmallBytes), ring.writer.nextNumber());
            if (step % 2 == 1) ring.writer.publish(kSmall);
        }
        once = false;
        copyFromShared(static_cast<char*>(to) + bytes / 2, static_cast<const char*>(from) + bytes / 2,
                       bytes - bytes / 2);
    });
    return reader.read(info, pixels);
}

TEST(FrameRing, NeverGivesAMixture) {
    for (int steps = 0; steps <= 12; ++steps) {
        Ring ring(3, kSmallBytes);
        for (int i = 0; i < 4; ++i) publish(ring.writer);
        FrameInfo info;
        std::vector<std::byte> pixels;
        const FrameRead result = readWhileWritten(ring, steps, info, pixels);
        ASSERT_EQ(result, FrameRead::New) << steps;
        EXPECT_TRUE(isFrame(info, pixels)) << steps << " half-frames during the copy: frame " << info.number;
        // The slot of frame 4 is written again from the third frame on.
        EXPECT_EQ(info.number, steps < 5 ? 4u : 4u + static_cast<std::uint64_t>(steps) / 2) << steps;
    }
}

TEST(FrameRing, SurvivesThreads) {
    Ring ring(3, kSmallBytes);
    std::atomic<bool> stop{false};
    std::thread writer([&] {
        for (int i = 0; i < 20000; ++i) {
            publish(ring.writer);
            if (i % 64 == 0) std::this_thread::yield();
        }
        stop = true;
    });
    int frames = 0, torn = 0;
    FrameInfo info;
    std::vector<std::byte> pixels;
    const auto reader = ring.reader();
    std::uint64_t last = 0;
    while (!stop || frames == 0) {
        if (reader.read(info, pixels) != FrameRead::New) continue;
        ++frames;
        torn += isFrame(info, pixels) && info.number > last ? 0 : 1;
        last = info.number;
    }
    writer.join();
    EXPECT_EQ(torn, 0) << "of " << frames;
}

TEST(FrameRing, IsNotReadyForAnotherEpochOrWhenTooSmall) {
    Ring ring(3, kSmallBytes);
    EXPECT_FALSE(ring.reader().ready(kEpoch + 1, kGeneration));
    EXPECT_FALSE(ring.reader().ready(kEpoch, kGeneration + 1));
    EXPECT_FALSE(FrameRingReader(ring.memory.get(), 64).ready(kEpoch, kGeneration));
}

TEST(FrameRing, BelievesNoSizes) {
    FrameInfo info;
    std::vector<std::byte> pixels;
    const auto broken = [&](auto change) {
        Ring ring(3, kSmallBytes);
        publish(ring.writer);
        auto& segment = *static_cast<FrameSegment*>(ring.memory.get());
        change(segment);
        info = {};
        return ring.reader().read(info, pixels) == FrameRead::Broken;
    };
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slotCount = 0; }));
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slotCount = 9; }));
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slotBytes = ~std::uint64_t{0}; }));
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slot[1].info.width = 0; }));
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slot[1].info.width = 0xFFFFFFFF; }));
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slot[1].info.height = kMaxFrameSide; }));
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slot[1].info.format = PixelFormat{7}; }));
    EXPECT_TRUE(broken([](FrameSegment& s) { s.slot[1].info.number = 2; }));
}

} // namespace
