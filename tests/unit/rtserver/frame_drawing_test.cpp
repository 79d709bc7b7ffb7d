#include "rtserver/frames/frame_drawing.h"

#include "shown_room.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

namespace rtserver {
namespace {

using rtcore::Change;
using Outcome = FrameDrawing::Outcome;

class FrameDrawingTest : public test::ShownRoom {
  protected:
    Outcome draw(bool waitedFor = false) { return drawing.draw(waitedFor).outcome; }
    void change() { switchLight(document, 1, std::nullopt); }
    /// Whole frames take long, and coarse ones come before them.
    void makeSlow() {
        document.assign({{"width", 600}, {"height", 400}, {"antialiasing", 3}});
        state.frameSeconds = 0.02;
    }
    void fixExposure() { document.assign({{"exposure.mode", "fixed"}}); }

    std::function<Arrivals()> poll = [] { return Arrivals{}; };
    bool memory = true;
    std::vector<ipc::FrameInfo> published;
    SceneUpkeep upkeep{options, state.document, messages};
    FrameDrawing drawing{state,
                         upkeep,
                         {.poll = [this] { return poll(); },
                          .publish =
                              [this](const ipc::FrameInfo& info, const rtcore::LdrImage&) {
                                  if (!memory) throw std::bad_alloc();
                                  published.push_back(info);
                              }},
                         1,
                         0};
};

// Also where a quick one is shown first, and while it is not there yet.
TEST_F(FrameDrawingTest, TellsWhatAWholeFrameTakes) {
    EXPECT_EQ(drawing.wholeSeconds(), 0);
    makeSlow();
    double underWay = 0;
    poll = [&] {
        underWay = std::max(underWay, drawing.wholeSeconds());
        return Arrivals{};
    };
    while (!drawing.frames().whole() || drawing.frames().stale(document)) draw();
    const double took = drawing.wholeSeconds();
    EXPECT_GT(took, 0);
    EXPECT_DOUBLE_EQ(took, drawing.frames().seconds());
    EXPECT_GT(underWay, 0);
    change();
    // One that would take too long is left, and a coarser one begun.
    while (drawing.frames().stale(document)) draw();
    ASSERT_FALSE(drawing.frames().whole()) << "a quick one comes first";
    EXPECT_GE(drawing.wholeSeconds(), took) << "that is no other whole one";
}

TEST_F(FrameDrawingTest, DrawsWhatTheStateShowsAndIdles) {
    fixExposure();
    EXPECT_TRUE(drawing.wantsFrame(false));
    EXPECT_FALSE(drawing.idle());
    EXPECT_FALSE(drawing.pace().complete);
    EXPECT_EQ(draw(), Outcome::Published);
    ASSERT_EQ(published.size(), 1U);
    EXPECT_EQ(published[0].width, 32U);
    EXPECT_EQ(published[0].height, 24U);
    EXPECT_EQ(published[0].samples, 1U);
    EXPECT_EQ(drawing.frames().revision(), document.revisions().revision());
    EXPECT_FALSE(drawing.wantsFrame(false));
    EXPECT_TRUE(drawing.idle());
    EXPECT_TRUE(drawing.pace().complete);
    EXPECT_GT(drawing.pace().seconds, 0);
}

TEST_F(FrameDrawingTest, EachKindOfChangeWantsAFrame) {
    fixExposure();
    const std::vector<std::function<void()>> edits = {
        [&] { walk.turn(1, 0); }, [&] { change(); }, [&] { setEnvironment(document, 1); },
        [&] {
            document.assign({{"antialiasing", 2}});
        },
        [&] { document.show(test::worldOf(test::makeRoom())); }};
    draw();
    for (const auto& edit : edits) {
        EXPECT_FALSE(drawing.wantsFrame(false));
        edit();
        EXPECT_TRUE(drawing.wantsFrame(false));
        fixExposure();
        draw();
    }
}

TEST_F(FrameDrawingTest, WithoutIdlingEveryFrameIsDrawn) {
    fixExposure();
    state.idles = false;
    draw();
    EXPECT_TRUE(drawing.wantsFrame(false));
    EXPECT_FALSE(drawing.idle());
}

TEST_F(FrameDrawingTest, APausedStateKeepsItsImage) {
    state.paused = true;
    drawing.noticePause(false);
    EXPECT_TRUE(drawing.wantsFrame(false)) << "there is none yet";
    draw();
    drawing.noticePause(false);
    change();
    EXPECT_FALSE(drawing.wantsFrame(false));
    state.paused = false;
    drawing.noticePause(false);
    EXPECT_TRUE(drawing.wantsFrame(false));
}

TEST_F(FrameDrawingTest, ACoarseFrameComesFirstWhereTheWholeOneTakesLong) {
    makeSlow();
    EXPECT_EQ(draw(), Outcome::Published);
    EXPECT_EQ(published.back().samples, 0U);
    EXPECT_LT(published.back().width, 600U);
    EXPECT_FALSE(drawing.frames().stale(document));
    EXPECT_FALSE(drawing.pace().complete);
    EXPECT_GT(drawing.pace().coarsest, 0);
    EXPECT_TRUE(drawing.wantsFrame(false)) << "the whole one";
    EXPECT_EQ(draw(), Outcome::Published);
    EXPECT_EQ(published.back().samples, 9U);
    document.show(test::worldOf(test::makeRoom()));
    EXPECT_EQ(drawing.pace().coarsest, 0) << "nothing is known of another scene";
}

/// Where frames may take any time, a moving camera does not wait for the light of each of its views.
TEST_F(FrameDrawingTest, WhileTheCameraMovesWholeFramesShowTheLightOfTheWalk) {
    fixExposure();
    document.assign({{"indirect.mode", "live"}});
    state.walk.keyboard().press('W');
    state.walk.move(std::chrono::milliseconds(10), {}, [](const rtcore::ActionTap&) {});
    ASSERT_FALSE(state.walk.atRest());
    draw();
    EXPECT_EQ(published.back().samples, 1U);
    EXPECT_EQ(drawing.frames().detail().indirect, IndirectOf::Walk);
    EXPECT_FALSE(drawing.wantsFrame(false)) << "until it has moved";
    state.walk.keyboard().releaseAll();
    while (!state.walk.atRest())
        state.walk.move(std::chrono::milliseconds(100), {}, [](const rtcore::ActionTap&) {});
    EXPECT_FALSE(drawing.idle());
    draw();
    EXPECT_TRUE(drawing.frames().exact());
    EXPECT_TRUE(drawing.idle());
}

TEST_F(FrameDrawingTest, TheImageGoesOverToAWholeFrameInSteps) {
    fixExposure();
    makeSlow();
    draw();
    document.assign({{"antialiasing", 6}});
    draw();
    ASSERT_EQ(published.size(), 2U);
    EXPECT_EQ(published.back().samples, 0U);
    EXPECT_EQ(draw(), Outcome::Published);
    ASSERT_GT(published.size(), 3U) << "of hundreds of milliseconds";
    for (std::size_t i = 2; i + 1 < published.size(); ++i) {
        EXPECT_EQ(published[i].samples, 0U);
        EXPECT_EQ(published[i].width, 600U);
        EXPECT_EQ(published[i].height, 400U);
    }
    EXPECT_EQ(published.back().samples, 36U);
    EXPECT_TRUE(drawing.idle());
}

TEST_F(FrameDrawingTest, AWholeFrameOfAnotherViewComesAtOnce) {
    fixExposure();
    makeSlow();
    draw();
    state.frameSeconds = 0;
    walk.turn(20, 0);
    EXPECT_EQ(draw(), Outcome::Published);
    ASSERT_EQ(published.size(), 2U);
    EXPECT_EQ(published.back().samples, 9U);
}

TEST_F(FrameDrawingTest, AWholeFrameThatIsSeenIsKeptFromThenOnInAPause) {
    fixExposure();
    state.paused = true;
    draw();
    change(); // before the next turn
    drawing.noticePause(false);
    EXPECT_FALSE(drawing.wantsFrame(false));
}

TEST_F(FrameDrawingTest, AWholeFrameIsLeftForAChangeAndStaysWanted) {
    makeSlow();
    draw();
    poll = [] { return Arrivals{.change = true}; };
    EXPECT_EQ(draw(), Outcome::Left);
    EXPECT_EQ(published.size(), 1U);
    EXPECT_TRUE(drawing.changeWaits());
    EXPECT_TRUE(drawing.takeChange());
    EXPECT_FALSE(drawing.changeWaits());
    EXPECT_TRUE(drawing.wantsFrame(false));
    poll = [] { return Arrivals{}; };
    EXPECT_EQ(draw(), Outcome::Published);
    EXPECT_EQ(published.back().samples, 9U);
}

TEST_F(FrameDrawingTest, AFrameIsLeftForTheEnd) {
    makeSlow();
    draw();
    poll = [] { return Arrivals{.end = true}; };
    EXPECT_EQ(draw(true), Outcome::Left);
    EXPECT_FALSE(drawing.changeWaits());
}

TEST_F(FrameDrawingTest, WhatFailsDuringAFrameIsThrownAfterIt) {
    makeSlow();
    draw();
    poll = []() -> Arrivals { throw std::runtime_error("the instance is lost"); };
    EXPECT_THROW(draw(), std::runtime_error);
}

TEST_F(FrameDrawingTest, WithoutMemoryItGoesBackToTheLastWholeFrame) {
    draw();
    document.assign({{"width", 64}});
    memory = false;
    const FrameDrawing::Drawn drawn = drawing.draw(true);
    EXPECT_EQ(drawn.outcome, Outcome::NoMemory);
    EXPECT_EQ(drawn.why.english(),
              "not enough memory for frames of 64 x 24 at these settings; back to those of the "
              "last frame, 32 x 24");
    EXPECT_EQ(document.settings().width, 32);
    EXPECT_TRUE(drawing.wantsFrame(false)) << "its memory is gone, too";
    EXPECT_LE(drawing.due(), FrameDrawing::Clock::now());
    EXPECT_EQ(draw(), Outcome::NoMemory);
    EXPECT_GT(drawing.due(), FrameDrawing::Clock::now()) << "not at once again";
    memory = true;
    EXPECT_EQ(draw(), Outcome::Published);
}

TEST_F(FrameDrawingTest, WithoutMemoryForTheFirstFrameThereIsNothingToGoBackTo) {
    memory = false;
    EXPECT_THROW(draw(), std::bad_alloc);
}

} // namespace
} // namespace rtserver
