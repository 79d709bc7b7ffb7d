// Frames of a real server in the same process, encoded as they are wanted.
#include "bridge/stream/frame_source.h"

#include "bridge/clock.h"
#include "ipc/endpoint/client.h"
#include "ipc/layout/limits.h"
#include "process/bridge/png_pixels.h"
#include "unit/bridge/served_instance.h"

#include <gtest/gtest.h>

#include <list>
#include <mutex>

namespace {

using bridge::Codec;
using bridge::FrameDemand;
using bridge::FrameSet;
using bridge::SharedFrame;

std::vector<std::uint8_t> rgbOf(const SharedFrame& still) {
    return test::rgbOf(std::string(still->bytes.begin(), still->bytes.end()));
}

class SourceOfFrames : public testing::Test {
  protected:
    void SetUp() override { instance.start(); }
    FrameSet newest() {
        const std::lock_guard lock(mutex_);
        return newest_;
    }
    SharedFrame newestOf(int rung) { return newest().byRung[static_cast<std::size_t>(rung)]; }
    int deliveries() {
        const std::lock_guard lock(mutex_);
        return deliveries_;
    }
    std::vector<std::string> failures() {
        const std::lock_guard lock(mutex_);
        return failures_;
    }
    std::vector<bridge::PreviewProgress> progress() {
        const std::lock_guard lock(mutex_);
        return progress_;
    }
    /// All frames above this number, of the stream that came last.
    FrameDemand above(std::uint64_t number, int rung = bridge::kFirstRung) {
        FrameDemand demand;
        demand.anyone = true;
        demand.stream = newest().stream;
        demand.above[static_cast<std::size_t>(rung)] = number;
        return demand;
    }
    bool comes(std::uint64_t number) {
        return instance.until([&] { return newest().number >= number; });
    }

    test::ServedInstance instance;

  private:
    std::mutex mutex_;
    FrameSet newest_;
    int deliveries_ = 0;
    std::vector<std::string> failures_;
    std::vector<bridge::PreviewProgress> progress_;

  protected:
    bridge::FrameSource source{instance.name(),
                               bridge::kRungs,
                               {.deliver =
                                    [this](FrameSet set) {
                                        const std::lock_guard lock(mutex_);
                                        newest_ = std::move(set);
                                        ++deliveries_;
                                    },
                                .failed =
                                    [this](std::string why) {
                                        const std::lock_guard lock(mutex_);
                                        failures_.push_back(std::move(why));
                                    },
                                .preview =
                                    [this](const bridge::PreviewProgress& progress) {
                                        const std::lock_guard lock(mutex_);
                                        progress_.push_back(progress);
                                    }}}; // last: its threads tell this
};

TEST_F(SourceOfFrames, EncodesWhatIsWantedAndNothingElse) {
    const std::uint64_t first = instance.publish(64, 48);
    FrameDemand demand = above(0);
    demand.above[3] = 0;
    source.setDemand(demand);
    ASSERT_TRUE(comes(first));
    const FrameSet set = newest();
    for (int rung = 0; rung < bridge::kRungCount; ++rung)
        EXPECT_EQ(newestOf(rung) != nullptr, rung == bridge::kFirstRung || rung == 3) << rung;
    const bridge::EncodedFrame& frame = *set.byRung[bridge::kFirstRung];
    EXPECT_EQ(frame.codec, Codec::Jpeg);
    EXPECT_EQ(frame.facts.number, first);
    EXPECT_EQ(frame.facts.stream, set.stream);
    EXPECT_EQ(frame.facts.width, 64);
    EXPECT_EQ(set.byRung[3]->facts.width, 32) << "coded at half the size";
    EXPECT_EQ(set.byRung[3]->facts.shownWidth, 64);
    EXPECT_GT(frame.facts.publishedNs, 0);
    EXPECT_EQ(source.figures().encode[bridge::kFirstRung].count(), 1U);
}

TEST_F(SourceOfFrames, GoesOnWithTheNewestAboveWhatWasSent) {
    const std::uint64_t first = instance.publish();
    source.setDemand(above(0));
    ASSERT_TRUE(comes(first));
    source.setDemand(above(first));
    instance.publish();
    const std::uint64_t last = instance.publish();
    ASSERT_TRUE(comes(last));
    EXPECT_EQ(newest().number, last);
    EXPECT_LE(source.figures().encode[bridge::kFirstRung].count(), 3U);
}

TEST_F(SourceOfFrames, LeavesTheServerAloneWithoutAnyone) {
    instance.publish();
    EXPECT_EQ(instance.server().clients(), 0);
    source.setDemand(above(0));
    EXPECT_TRUE(instance.until([&] { return instance.server().clients() == 1; }));
    source.setDemand({});
    EXPECT_TRUE(instance.until([&] { return instance.server().clients() == 0; }));
}

TEST_F(SourceOfFrames, GivesWhatIsEncodedAlreadyToOneThatComesLater) {
    const std::uint64_t first = instance.publish();
    source.setDemand(above(0));
    ASSERT_TRUE(comes(first));
    source.setDemand(above(first));
    const std::uint64_t second = instance.publish();
    ASSERT_TRUE(comes(second));
    const SharedFrame before = newestOf(bridge::kFirstRung);
    const int delivered = deliveries();
    source.setDemand(above(0));
    ASSERT_TRUE(instance.until([&] { return deliveries() > delivered; }));
    EXPECT_EQ(newestOf(bridge::kFirstRung), before) << "not encoded twice";
}

TEST_F(SourceOfFrames, AddsTheExactImageAtRest) {
    const std::uint64_t first = instance.publish(64, 48, true);
    FrameDemand demand = above(0);
    demand.still = true;
    source.setDemand(demand);
    ASSERT_TRUE(instance.until([&] { return newest().still != nullptr; }));
    const FrameSet set = newest();
    EXPECT_EQ(set.still->codec, Codec::Png);
    EXPECT_TRUE(set.still->exact);
    EXPECT_EQ(set.still->facts.number, first);
    EXPECT_EQ(set.fine, nullptr) << "no one asked for it";
    EXPECT_GE(source.figures().still.count(), 1U);
}

TEST_F(SourceOfFrames, AddsAFinerOneForNarrowLinks) {
    instance.publish(64, 48, true);
    FrameDemand demand = above(0);
    demand.still = demand.fine = true;
    source.setDemand(demand);
    ASSERT_TRUE(instance.until([&] { return newest().fine != nullptr && newest().still != nullptr; }));
    EXPECT_EQ(newest().fine->codec, Codec::Jpeg);
    EXPECT_FALSE(newest().fine->exact);
}

TEST_F(SourceOfFrames, IsAnotherStreamAfterAnotherSizeOrServer) {
    const std::uint64_t first = instance.publish(64, 48);
    source.setDemand(above(0));
    ASSERT_TRUE(comes(first));
    const std::uint32_t stream = newest().stream;
    source.setDemand(above(first));
    instance.publish(32, 24);
    ASSERT_TRUE(instance.until([&] { return newest().stream != stream; }));
    EXPECT_EQ(newestOf(bridge::kFirstRung)->facts.width, 32);
    const std::uint32_t second = newest().stream;
    instance.stop();
    instance.start();
    instance.publish(32, 24);
    source.setDemand(above(first + 1));
    ASSERT_TRUE(instance.until([&] { return newest().stream != second; }));
}

TEST_F(SourceOfFrames, TellsOnceWhyItTakesNone) {
    instance.publish();
    std::list<ipc::Client> others;
    for (std::size_t i = 0; i < ipc::kMaxClients; ++i) others.emplace_back(instance.name());
    source.setDemand(above(0));
    ASSERT_TRUE(instance.until([&] { return !failures().empty(); }));
    EXPECT_FALSE(failures().front().empty());
    others.pop_front();
    EXPECT_TRUE(instance.until([&] { return newest().number > 0; })) << "a slot is free";
    EXPECT_EQ(failures().size(), 1U);
}

TEST_F(SourceOfFrames, SaysNothingOfAServerThatIsGone) {
    instance.stop();
    source.setDemand(above(0));
    instance.start();
    instance.publish();
    EXPECT_TRUE(instance.until([&] { return newest().number > 0; }));
    EXPECT_TRUE(failures().empty());
}

/// A Renderer that shows an image of a run, in one colour.
class PreviewOfARenderer : public SourceOfFrames {
  protected:
    void SetUp() override {
        SourceOfFrames::SetUp();
        first = instance.publish(64, 48, true);
        source.setDemand(all());
        ASSERT_TRUE(instance.until([&] { return newest().still != nullptr; }));
        source.setPreview(bridge::PreviewRun{renderer.name(), 7, bridge::steadyClock().nanoseconds()});
        server = std::make_unique<ipc::Server>(
            ipc::ServerOptions{.instance = renderer.name(), .width = 64, .height = 48});
    }
    FrameDemand all() {
        FrameDemand demand = above(newest().number);
        demand.still = true;
        return demand;
    }
    void shows(std::uint8_t grey, std::uint8_t alpha, std::uint64_t tag, std::uint32_t samples,
               std::uint64_t run = 7) {
        std::vector<std::byte> pixels(std::size_t{4} * 64 * 48, std::byte{grey});
        for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = std::byte{alpha};
        ipc::FrameInfo info;
        info.width = 64;
        info.height = 48;
        info.run = run;
        info.tag = tag;
        info.samples = samples;
        server->publishFrame(info, pixels);
    }
    /// The exact image that comes next, once it is in that colour everywhere.
    bool becomes(std::uint8_t grey) {
        return instance.until([&] {
            source.setDemand(all());
            const FrameSet set = newest();
            if (!set.still) return false;
            const std::vector<std::uint8_t> rgb = rgbOf(set.still);
            return std::ranges::all_of(rgb, [&](std::uint8_t each) { return each == grey; });
        });
    }

    test::IpcInstance renderer;
    std::unique_ptr<ipc::Server> server;
    std::uint64_t first = 0;
};

TEST_F(PreviewOfARenderer, IsShownInPlaceOfTheFrameThatRests) {
    const std::uint32_t stream = newest().stream;
    shows(90, 255, 400, 1);
    EXPECT_TRUE(becomes(90));
    shows(91, 255, ipc::kPreviewDone, 16);
    EXPECT_TRUE(becomes(91));
    EXPECT_EQ(newest().stream, stream) << "pages go on with the same image";
    EXPECT_GT(newest().number, first);
    ASSERT_EQ(progress().size(), 2U);
    EXPECT_EQ(progress().back().samples, 16U);
    EXPECT_TRUE(progress().back().done);
    EXPECT_LT(progress().back().error, 0) << "not known";
}

TEST_F(PreviewOfARenderer, GivesWayToTheServersNextFrame) {
    shows(90, 255, 400, 1);
    ASSERT_TRUE(becomes(90));
    const std::uint64_t before = newest().number;
    instance.publish(64, 48, true);
    source.setDemand(all());
    ASSERT_TRUE(comes(before + 1));
    const std::uint64_t moved = newest().number;
    shows(92, 255, 500, 2);
    // Another of the server's frames: had the Renderer's come, its number would lie between.
    instance.publish(64, 48, true);
    source.setDemand(all());
    ASSERT_TRUE(comes(moved + 1));
    EXPECT_EQ(progress().size(), 1U);
    EXPECT_FALSE(newest().still && rgbOf(newest().still).front() == 92);
}

TEST_F(PreviewOfARenderer, OfAnotherRunIsPassedOver) {
    shows(90, 255, ipc::kPreviewDone, 16, 6);
    shows(91, 255, 400, 1);
    EXPECT_TRUE(becomes(91));
}

TEST_F(PreviewOfARenderer, ShowsTheServersPixelsWhereItHasNone) {
    const FrameSet before = newest();
    shows(90, 0, 10, 0);
    ASSERT_TRUE(instance.until([&] {
        source.setDemand(all());
        return newest().number > before.number && newest().still;
    }));
    EXPECT_EQ(rgbOf(newest().still), rgbOf(before.still));
}

} // namespace
