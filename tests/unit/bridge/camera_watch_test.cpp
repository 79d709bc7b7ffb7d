// Whose movement it is: one's own keys never count as another client's, however slow frames are.
#include "bridge/control/camera_watch.h"

#include <gtest/gtest.h>

namespace {

constexpr std::uint32_t kFly = 0, kWalk = 1;

/// A server that draws a frame each `frameSeconds`, and what a bridge sees of it.
class Watched : public testing::Test {
  protected:
    /// Draws a frame; true when its movement is taken for another's.
    bool frame() {
        now += seconds;
        status.frameSeconds = seconds + 1e-6 * ++drawn;
        return watch.moved(status, now);
    }
    bool go() {
        status.eye[0] += 1;
        return frame();
    }
    bool turn() {
        std::swap(status.forward[0], status.forward[2]);
        return frame();
    }
    void rest() {
        status.idle = 1;
        frame();
    }
    /// Own movement is over.
    void settle() {
        for (int i = 0; i < 8; ++i) frame();
        rest();
        status.idle = 0;
    }

    bridge::CameraWatch watch;
    ipc::Status status;
    double now = 100, seconds = 0.03;
    int drawn = 0;
};

class WatchedAt : public Watched, public testing::WithParamInterface<double> {
  protected:
    void SetUp() override {
        seconds = GetParam();
        settle();
    }
};

TEST_P(WatchedAt, OwnKeysAreOnesOwn) {
    for (const std::uint32_t mode : {kFly, kWalk}) {
        status.mode = mode;
        for (int i = 0; i < 20; ++i) {
            watch.acted(now); // held
            EXPECT_FALSE(go());
        }
        // Let go: the frame that is under way, and the one after it, still show it.
        for (int i = 0; i < 3; ++i) EXPECT_FALSE(go()) << i;
        settle();
    }
}

TEST_P(WatchedAt, AFallAfterAWalkIsOnesOwn) {
    status.mode = kWalk;
    watch.acted(now);
    for (int i = 0; i < 100; ++i) {
        status.eye[1] -= 1;
        EXPECT_FALSE(frame());
    }
}

TEST_P(WatchedAt, ATurnThatIsAppliedLateIsOnesOwn) {
    watch.acted(now);
    status.idle = 1; // the server has not noticed it
    EXPECT_FALSE(watch.moved(status, now + 0.1));
    status.idle = 0;
    EXPECT_FALSE(frame());
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(turn()) << i;
}

TEST_P(WatchedAt, AnothersMovementIsTold) {
    for (const std::uint32_t mode : {kFly, kWalk}) {
        status.mode = mode;
        EXPECT_TRUE(go());
        EXPECT_TRUE(turn());
        watch.acted(now);
        EXPECT_FALSE(go());
        settle();
        EXPECT_TRUE(go()) << "after one's own";
        EXPECT_TRUE(turn());
    }
}

// It goes on where one's own has ended, without a rest between.
TEST_P(WatchedAt, AnothersMovementIsToldWithoutARest) {
    status.mode = kFly;
    watch.acted(now);
    int told = 0;
    for (int i = 0; i < 20; ++i) told += go() ? 1 : 0;
    EXPECT_GT(told, 10);
    status.mode = kWalk;
    watch.acted(now);
    told = 0;
    for (int i = 0; i < 20; ++i) told += turn() ? 1 : 0;
    EXPECT_GT(told, 10);
}

// Such as a key against a wall.
TEST_P(WatchedAt, AfterKeysWithoutEffectAnothersJumpIsTold) {
    rest();
    watch.acted(now);
    now += 4 * seconds + 5;
    EXPECT_TRUE(go());
}

TEST_P(WatchedAt, NothingIsToldOfAStandingCamera) {
    for (int i = 0; i < 20; ++i) EXPECT_FALSE(frame());
}

TEST_P(WatchedAt, AnotherServerBeginsAnew) {
    watch.restart(now);
    status.eye[0] = 77;
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(go()) << "its scene is loaded";
    settle();
    EXPECT_TRUE(go());
}

INSTANTIATE_TEST_SUITE_P(SecondsPerFrame, WatchedAt, testing::Values(0.005, 0.03, 1.0, 7.0, 60.0));

} // namespace
