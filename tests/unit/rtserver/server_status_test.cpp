#include "rtserver/loop/server_status.h"

#include "shown_room.h"

#include <gtest/gtest.h>

namespace rtserver {
namespace {

using ServerStatus = test::ShownRoom;

TEST_F(ServerStatus, TellsOfTheStateAndItsFrame) {
    FrameMaker frames(1);
    test::draw(frames, state);
    walk.setWalking(true);
    const ipc::Status status =
        statusOf(state, frames, {.progress = 0.5F, .framesPerSecond = 20, .messages = 3, .idle = true});
    EXPECT_EQ(status.width, 32U);
    EXPECT_EQ(status.height, 24U);
    EXPECT_EQ(status.polygons, document.scene()->mesh().triangles.size());
    EXPECT_EQ(status.eye[1], document.camera().eye.y);
    EXPECT_EQ(status.mode, 1U);
    EXPECT_EQ(status.exposure, frames.exposure());
    EXPECT_GT(status.frameSeconds, 0);
    EXPECT_GT(status.raysPerSecond, 0);
    EXPECT_EQ(status.progress, 0.5F);
    EXPECT_EQ(status.framesPerSecond, 20);
    EXPECT_EQ(status.messages, 3U);
    EXPECT_EQ(status.idle, 1U);
    EXPECT_EQ(status.paused, 0U);
    EXPECT_EQ(status.recording, 0U);
    state.paused = true;
    EXPECT_EQ(statusOf(state, frames, {}).paused, 1U);
    EXPECT_EQ(statusOf(state, frames, {}).idle, 0U);
}

TEST_F(ServerStatus, TellsWhichPartOfALiveFrameIsKept) {
    FrameMaker frames(1);
    state.frameSeconds = 0.03;
    test::draw(frames, state);
    EXPECT_EQ(statusOf(state, frames, {}).kept, 0);
    walk.turn(1, 0);
    test::draw(frames, state, {1, true, 0.1});
    EXPECT_GT(statusOf(state, frames, {}).kept, 0.7F);
    EXPECT_LT(statusOf(state, frames, {}).kept, 1);
    test::draw(frames, state);
    EXPECT_EQ(statusOf(state, frames, {}).kept, 0);
}

TEST_F(ServerStatus, TellsHowSureIndirectLightIs) {
    FrameMaker frames(1);
    state.frameSeconds = 0.03;
    test::draw(frames, state);
    EXPECT_EQ(statusOf(state, frames, {}).lightError, 0) << "there is none";
    rtcore::RenderSettings settings = document.settings();
    settings.indirect.mode = rtcore::IndirectMode::Live;
    document.setSettings(settings);
    test::draw(frames, state);
    walk.turn(1, 0);
    test::draw(frames, state, {1, true, 0.1});
    EXPECT_GT(statusOf(state, frames, {}).lightError, 0);
    EXPECT_LT(statusOf(state, frames, {}).lightError, 1);
}

TEST_F(ServerStatus, WithoutASceneTellsWhatIsKnown) {
    const Workspace fresh(options, {}, messages);
    const ipc::Status status = statusOf(fresh, FrameMaker(1), {.progress = 0.25F});
    EXPECT_EQ(status.progress, 0.25F);
    EXPECT_EQ(status.width, 0U);
    EXPECT_EQ(status.idle, 0U);
}

} // namespace
} // namespace rtserver
