// Frames of a room: who gets which, who waits, and what is asked of the source.
#include "bridge/room/room_stream.h"

#include "unit/bridge/room_world.h"

#include <gtest/gtest.h>

namespace {

using bridge::FrameDemand;
using bridge::FrameSet;
using bridge::SessionId;
using test::frameSet;
using test::PageOutlet;

class FramesOfARoom : public testing::Test {
  protected:
    using Page = std::shared_ptr<PageOutlet>;
    explicit FramesOfARoom(bridge::StreamOptions options = {}) : options_(options) {}
    Page join(SessionId id, const bridge::PageView& view = {}) {
        auto page = std::make_shared<PageOutlet>();
        stream.join(id, view, page);
        stream.serve(id);
        return page;
    }
    void ack(SessionId id, std::uint64_t number, bool part = false) {
        stream.acked(id, {part, 0, 1, number});
    }
    /// A frame that is published just now.
    bool frame(std::uint64_t number, std::size_t bytes = 1000) {
        return stream.newFrames(frameSet(number, bytes, clock.nanoseconds()));
    }
    static std::vector<std::uint64_t> numbers(const Page& page) {
        std::vector<std::uint64_t> all;
        for (const PageOutlet::Binary& each : page->binaries) all.push_back(each.number());
        return all;
    }
    using Numbers = std::vector<std::uint64_t>;

  private:
    bridge::StreamOptions options_; // before what is made by them

  protected:
    test::HandClock clock;
    FrameDemand demand;
    bridge::RoomStream stream{options_, clock, [this](const FrameDemand& wanted) { demand = wanted; }};
};

TEST_F(FramesOfARoom, BeginWithAPingAndWhatIsThere) {
    const Page first = join(1);
    EXPECT_EQ(first->pings, 1);
    EXPECT_TRUE(first->binaries.empty());
    frame(4);
    const Page second = join(2);
    EXPECT_EQ(numbers(first), Numbers{4});
    EXPECT_EQ(numbers(second), Numbers{4}) << "one that comes later gets the newest";
}

TEST_F(FramesOfARoom, GoToThoseThatAreReadyAndSlowOnesSkip) {
    const Page quick = join(1), slow = join(2);
    slow->staysBusy = true;
    for (std::uint64_t number = 1; number <= 5; ++number) {
        clock.pass(0.03);
        frame(number);
        ack(1, number);
    }
    EXPECT_EQ(numbers(quick), (Numbers{1, 2, 3, 4, 5}));
    EXPECT_EQ(numbers(slow), Numbers{1});
    slow->isBusy = false;
    stream.writable(2);
    EXPECT_EQ(numbers(slow), (Numbers{1, 5})) << "the newest wins";
    bridge::RoomFigures figures;
    stream.addTo(figures);
    ASSERT_EQ(figures.sessions.size(), 2U);
    EXPECT_EQ(figures.sessions[0].skipped, 0U);
    EXPECT_EQ(figures.sessions[1].skipped, 3U);
    EXPECT_EQ(figures.sent[bridge::kFirstRung], 7U);
}

TEST_F(FramesOfARoom, WaitForAcknowledgements) {
    const Page page = join(1);
    for (std::uint64_t number = 1; number <= 6; ++number) frame(number);
    EXPECT_EQ(numbers(page), (Numbers{1, 2}));
    clock.pass(0.02);
    ack(1, 1);
    EXPECT_EQ(numbers(page), (Numbers{1, 2, 6}));
}

TEST_F(FramesOfARoom, ThatAreOlderAreLeftOut) {
    const Page page = join(1);
    EXPECT_TRUE(frame(5));
    EXPECT_FALSE(frame(4));
    EXPECT_FALSE(frame(5)) << "more of the same one is not newer";
    EXPECT_EQ(numbers(page), Numbers{5});
    EXPECT_TRUE(stream.newFrames(frameSet(1, 1000, 0, 2))) << "of another server";
    EXPECT_EQ(numbers(page), (Numbers{5, 1}));
}

TEST_F(FramesOfARoom, AreAskedForAboveWhatWasSent) {
    EXPECT_FALSE(demand.anyone);
    const Page page = join(1);
    EXPECT_TRUE(demand.anyone && demand.still);
    EXPECT_EQ(demand.above[bridge::kFirstRung], 0U);
    frame(3);
    EXPECT_EQ(demand.stream, 1U);
    EXPECT_EQ(demand.above[bridge::kFirstRung], 3U);
    page->isBusy = true;
    stream.ponged(1, 0.01);
    stream.serve(1);
    EXPECT_EQ(demand.above[bridge::kFirstRung], FrameDemand::kNothing) << "it waits for nothing now";
    stream.leave(1);
    EXPECT_FALSE(demand.anyone);
}

TEST_F(FramesOfARoom, StopForAHiddenPage) {
    const Page page = join(1);
    stream.setView(1, {.visible = false});
    EXPECT_FALSE(demand.anyone);
    frame(1);
    EXPECT_TRUE(page->binaries.empty());
    stream.setView(1, {.visible = true});
    EXPECT_EQ(numbers(page), Numbers{1});
}

TEST_F(FramesOfARoom, OfARungThatAPageChoosesAreAskedFor) {
    join(1, {.rung = 4});
    EXPECT_EQ(demand.above[4], 0U);
    EXPECT_EQ(demand.above[bridge::kFirstRung], FrameDemand::kNothing);
}

TEST_F(FramesOfARoom, AtRestAreFollowedByTheExactImage) {
    const Page page = join(1), without = join(2, {.noStill = true});
    FrameSet set = frameSet(1);
    stream.newFrames(set);
    ack(1, 1);
    ack(2, 1);
    set.still = test::encodedFrame(1, 50'000);
    stream.newFrames(set);
    std::size_t bytes = 0;
    for (int i = 0; i < 100 && bytes < 50'000; ++i) {
        bytes = 0;
        for (const PageOutlet::Binary& each : page->binaries) {
            if (!each.shipment->part) continue;
            EXPECT_EQ(each.shipment->offset, bytes) << "in order, without a gap";
            bytes += each.shipment->size;
        }
        clock.pass(0.01);
        ack(1, 1, true);
    }
    EXPECT_EQ(bytes, 50'000U);
    EXPECT_EQ(without->binaries.size(), 1U) << "who wants none gets none";
}

TEST_F(FramesOfARoom, SayWhichInputWasBeforeThemAndHowOldTheyAre) {
    const Page page = join(1);
    frame(1);
    stream.gaveInput(1, 41);
    clock.pass(0.01);
    stream.gaveInput(1, 42);
    const std::int64_t published = clock.nanoseconds();
    clock.pass(0.02);
    stream.gaveInput(1, 43);
    stream.newFrames(frameSet(2, 1000, published));
    ASSERT_EQ(page->binaries.size(), 2U);
    EXPECT_EQ(page->binaries[0].field(24), 0U) << "nothing was given before it";
    EXPECT_EQ(page->binaries[1].field(24), 42U);
    EXPECT_EQ(page->binaries[1].field(28), 20'000U);
}

TEST_F(FramesOfARoom, AreCountedFromPublishingToTheSocket) {
    const Page page = join(1);
    clock.pass(1);
    page->staysBusy = true;
    frame(1);
    clock.pass(0.004);
    page->isBusy = false;
    stream.writable(1);
    bridge::RoomFigures figures;
    stream.addTo(figures);
    EXPECT_EQ(figures.publishToSocket.count(), 1U);
    EXPECT_EQ(figures.bytes, bridge::kHeaderBytes + 1000);
}

TEST_F(FramesOfARoom, AreToldAsFiguresOfTheLinkEachSecond) {
    const Page page = join(1);
    frame(1);
    clock.pass(0.5);
    ack(1, 1);
    stream.tellLinks();
    EXPECT_EQ(page->count("link"), 0U);
    clock.pass(0.6);
    stream.tellLinks();
    ASSERT_EQ(page->count("link"), 1U);
    EXPECT_EQ(page->last("link")["sent"], 1);
    EXPECT_EQ(page->last("link")["rung"], bridge::kFirstRung);
    clock.pass(1.1);
    stream.tellLinks();
    EXPECT_EQ(page->count("link"), 1U) << "nothing was sent since";
}

TEST_F(FramesOfARoom, ArePingedAboutButNotBehindAFrame) {
    const Page page = join(1);
    frame(1);
    clock.pass(20);
    stream.tellLinks();
    EXPECT_EQ(page->pings, 1) << "a frame is under way";
    ack(1, 1);
    stream.tellLinks();
    EXPECT_EQ(page->pings, 2) << "after silence";
    stream.tellLinks();
    EXPECT_EQ(page->pings, 2);
}

TEST_F(FramesOfARoom, OfAPageThatLeftStayCounted) {
    const Page page = join(1);
    page->staysBusy = true;
    for (std::uint64_t number = 1; number <= 4; ++number) frame(number);
    stream.leave(1);
    bridge::RoomFigures figures;
    stream.addTo(figures);
    EXPECT_TRUE(figures.sessions.empty());
    EXPECT_EQ(figures.skipped, 3U);
    EXPECT_EQ(figures.sent[bridge::kFirstRung], 1U);
    EXPECT_TRUE(join(2)->binaries.empty()) << "a frame from before is old";
}

class LimitedFramesOfARoom : public FramesOfARoom {
  protected:
    static constexpr double kBits = 1e6;
    LimitedFramesOfARoom() : FramesOfARoom({.quality = {}, .maxBits = kBits}) {}
    std::vector<Page> pages{join(1), join(2)};
};

TEST_F(LimitedFramesOfARoom, WaitWhereTheyWouldBeMoreThanTheShare) {
    frame(1, 200'000);
    for (const SessionId id : {1U, 2U}) ack(id, 1);
    clock.pass(0.03);
    frame(2);
    EXPECT_EQ(numbers(pages[0]), Numbers{1});
    EXPECT_EQ(demand.above[bridge::kFirstRung], FrameDemand::kNothing) << "nothing is encoded meanwhile";
    clock.pass(10);
    stream.serveWaiting();
    for (const Page& page : pages) EXPECT_EQ(numbers(page), (Numbers{1, 2})) << "what waited comes";
}

TEST_F(LimitedFramesOfARoom, GetCoarserForThoseThatTakeMoreThanTheirShareAndFinerAgain) {
    stream.setView(2, {.visible = false});
    frame(1, 300'000);
    ack(1, 1);
    stream.shareLimit();
    stream.setView(2, {.visible = true});
    clock.pass(20);
    stream.serveWaiting();
    stream.newFrames(frameSet(2, 10));
    bridge::RoomFigures figures;
    stream.addTo(figures);
    ASSERT_EQ(figures.sessions.size(), 2U);
    EXPECT_EQ(figures.sessions[0].link.rung, bridge::kFirstRung + 1);
    EXPECT_EQ(figures.sessions[1].link.rung, bridge::kFirstRung);
    for (int i = 0; i < bridge::kRungCount; ++i) stream.shareLimit();
    bridge::RoomFigures later;
    stream.addTo(later);
    EXPECT_EQ(later.sessions[0].link.rung, bridge::kFirstRung) << "there is room again";
}

} // namespace
