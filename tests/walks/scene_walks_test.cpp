// The walk-through mode in real rooms: our own nave, and, where RT_TEST_SCENES names their folder, Sibenik
// and Sponza. RT_WALKS sets the number of random walks through each.
#include "rtcore/io/scene_loader.h"
#include "rtcore/motion/player.h"
#include "support/key_script.h"
#include "support/walk_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using rtcore::Vec3d;

struct Place {
    const char* name;
    fs::path file;
    bool ours;
    double metresPerUnit;
    Vec3d lo, hi; ///< walks begin in this box: inside the building; metres, z up
    friend std::ostream& operator<<(std::ostream& out, const Place& place) { return out << place.name; }
};

const Place kPlaces[] = {
    {"nave", fs::path(RT_SOURCE_FOLDER) / "data/nave/generated/nave.glb", true, 1, {-9, -20, 0}, {9, 20, 14}},
    {"sibenik", "sibenik/sibenik.ply", false, 1, {-20, -8, -15}, {20, 8, 12}},
    {"sponza", "sponza_crytek/sponza.obj", false, 0.01, {-19, -11, -1}, {18, 11, 14}},
};

int walks(int usual) {
    const char* const wanted = std::getenv("RT_WALKS");
    return wanted != nullptr ? std::atoi(wanted) : usual;
}

/// The player of the tests of mechanics: fast, and jumps high.
rtcore::WalkParameters sportsman() {
    rtcore::WalkParameters parameters;
    parameters.speed = 3;
    parameters.jumpHeight = 0.6F;
    return parameters;
}

rtcore::BuildOptions quickTree() {
    rtcore::BuildOptions options;
    options.method = rtcore::BuildMethod::Fast;
    options.threads = 1;
    return options;
}

class SceneWalk : public testing::TestWithParam<Place> {
  protected:
    void SetUp() override {
        fs::path file = GetParam().file;
        if (!GetParam().ours) {
            const char* const folder = std::getenv("RT_TEST_SCENES");
            if (folder == nullptr) GTEST_SKIP() << "RT_TEST_SCENES is not set";
            file = folder / file;
            if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
        }
        ASSERT_TRUE(fs::exists(file)) << file << " is missing: scripts/make_data.sh makes it";
        rtcore::LoadOptions options;
        options.build = quickTree();
        scene_ = std::make_unique<rtcore::LoadedScene>(rtcore::loadScene(file, options));
    }

    const rtcore::KdTree& tree() const { return scene_->tree; }
    const rtcore::Mesh& mesh() const { return scene_->scene.mesh(); }
    rtcore::WorldFrame frame() const { return {{0, 1, 0}, GetParam().metresPerUnit}; }
    rtcore::WalkShape shape() const { return rtcore::WalkShape(sportsman()); }

    Vec3d anywhere(test::Random& random) const {
        const Vec3d lo = GetParam().lo, size = GetParam().hi - lo;
        const double x = test::fraction(random), y = test::fraction(random);
        return lo + Vec3d{size.x * x, size.y * y, size.z * test::fraction(random)};
    }

    void walkAtRandom(int count);
    void enterAnywhere(int count);
    void playAtAnyFrameRate();
    void walkInAnyOrder(int count);
    void toggleAnywhere(int count);
    void pressOnAnywhere(int count);

  private:
    std::unique_ptr<rtcore::LoadedScene> scene_;
};

void SceneWalk::walkAtRandom(int count) {
    constexpr int kTicks = 240, kEnough = 20;
    const test::Obstacles all(mesh(), frame());
    const test::WalkJudge judge(all, shape());
    int walked = 0, putBack = 0, lost = 0, refused = 0, wrong = 0;
    test::WalkClearance min;
    int places = 0;
    for (int walk = 0; walked < count && walk < 2 * count && wrong < kEnough; ++walk) {
        ++places;
        test::Random random(static_cast<std::uint64_t>(walk));
        rtcore::Walker walker(tree(), mesh(), frame(), shape());
        if (!walker.enter(anywhere(random))) continue;
        test::RandomKeys keys(random);
        const test::WalkRecord record = test::recordWalk(walker, kTicks, [&] { return keys.next(); });
        const test::WalkClearance clearance = judge.judge(record, random);
        ++walked;
        putBack += record.putBack;
        refused += record.refused;
        lost += record.lost ? 1 : 0;
        EXPECT_GE(clearance.atEnds, shape().radius - 1e-9)
            << "walk " << walk << " tick " << clearance.endsTick;
        EXPECT_GE(clearance.onTheWay, shape().radius - 0.005)
            << "walk " << walk << " tick " << clearance.wayTick;
        EXPECT_GE(clearance.ofEye, 0.05) << "walk " << walk << " tick " << clearance.eyeTick;
        const bool failed = clearance.atEnds < shape().radius - 1e-9 ||
                            clearance.onTheWay < shape().radius - 0.005 || clearance.ofEye < 0.05;
        wrong += failed ? 1 : 0;
        min.atEnds = std::min(min.atEnds, clearance.atEnds);
        min.onTheWay = std::min(min.onTheWay, clearance.onTheWay);
        min.ofEye = std::min(min.ofEye, clearance.ofEye);
    }
    std::printf("%s: %d walks of %d places; put back %d times, lost %d, refused steps %d, wrong %d; least "
                "clearance %.9f, on the way %.6f, of the eye %.4f\n",
                GetParam().name, walked, places, putBack, lost, refused, wrong, min.atEnds, min.onTheWay,
                min.ofEye);
    EXPECT_EQ(walked, count);
}

void SceneWalk::enterAnywhere(int count) {
    const test::Obstacles all(mesh(), frame());
    test::Random random(11);
    rtcore::Walker walker(tree(), mesh(), frame(), shape());
    int entered = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3d eye = anywhere(random);
        const rtcore::WalkState before = walker.state();
        if (!walker.enter(eye)) {
            EXPECT_EQ(walker.state(), before);
            continue;
        }
        ++entered;
        const rtcore::WalkState& now = walker.state();
        const double reach = shape().radius + shape().skin;
        const rtcore::UprightLine core{now.feet + Vec3d{0, 0, reach}, now.height - 2 * reach};
        ASSERT_TRUE(isFinite(now.feet));
        EXPECT_GE(all.clearance(core, reach), shape().radius - 1e-9);
        EXPECT_LE(length(walker.eye() - eye), 1 + 1e-9);
    }
    EXPECT_GT(entered, count / 10);
}

void SceneWalk::playAtAnyFrameRate() {
    rtcore::PlayerOptions options;
    options.metresPerUnit = GetParam().metresPerUnit;
    options.walk = sportsman();
    test::Random places(5);
    rtcore::Camera start;
    constexpr std::int64_t kUntil = 8 * test::kSecond;
    const auto events = test::randomEvents(9, kUntil);
    const auto play = [&](auto&& nextFrame) {
        rtcore::Player player(tree(), mesh(), options);
        player.setCamera(start);
        EXPECT_TRUE(player.setMode(rtcore::MotionMode::Walk));
        return test::playKeys(player, events, kUntil, nextFrame);
    };
    for (int i = 0; i < 2; ++i) {
        start.eye = frame().toScene(anywhere(places));
        const auto expected = play([] { return test::kSecond / 60; });
        for (const double rate : {5.0, 7.3, 24.0, 59.94, 144.0, 500.0}) {
            const auto frames = static_cast<std::int64_t>(test::kSecond / rate);
            EXPECT_EQ(play([=] { return frames; }), expected) << rate;
        }
        test::Random random(77);
        EXPECT_EQ(play([&] { return std::int64_t(1 + random.index(test::kSecond / 5)); }), expected);
    }
}

void SceneWalk::walkInAnyOrder(int count) {
    std::vector<rtcore::Triangle> triangles(mesh().triangles.begin(), mesh().triangles.end());
    test::Random order(3);
    for (std::size_t i = triangles.size(); i > 1; --i) std::swap(triangles[i - 1], triangles[order.index(i)]);
    rtcore::Mesh shuffled = mesh();
    shuffled.triangles = triangles;
    const rtcore::KdTree other = rtcore::buildKdTree(shuffled, quickTree());
    double farthest = 0;
    for (int walk = 0; walk < count; ++walk) {
        std::vector<Vec3d> feet[2];
        for (int k = 0; k < 2; ++k) {
            test::Random random(static_cast<std::uint64_t>(walk));
            rtcore::Walker walker(k == 0 ? tree() : other, k == 0 ? mesh() : shuffled, frame(), shape());
            if (!walker.enter(anywhere(random))) continue;
            test::RandomKeys keys(random);
            for (int tick = 0; tick < 240 && walker.tick(keys.next()); ++tick)
                feet[k].push_back(walker.state().feet);
        }
        ASSERT_EQ(feet[0].size(), feet[1].size());
        for (std::size_t i = 0; i < feet[0].size(); ++i)
            farthest = std::max(farthest, length(feet[0][i] - feet[1][i]));
        ASSERT_LT(farthest, 1e-9) << "walk " << walk;
    }
}

void SceneWalk::toggleAnywhere(int count) {
    rtcore::PlayerOptions options;
    options.metresPerUnit = GetParam().metresPerUnit;
    options.walk = sportsman();
    rtcore::Player player(tree(), mesh(), options);
    test::Random random(21);
    rtcore::Camera camera;
    const test::Obstacles all(mesh(), frame());
    rtcore::ActionSet held;
    int walking = 0;
    for (int i = 0; i < count; ++i) {
        camera.eye = frame().toScene(anywhere(random));
        player.setCamera(camera);
        held.set(static_cast<rtcore::Action>(random.index(14)));
        player.hold(held);
        const bool walks = player.setMode(rtcore::MotionMode::Walk);
        EXPECT_EQ(player.mode() == rtcore::MotionMode::Walk, walks);
        player.advance(std::chrono::milliseconds(random.index(200)));
        const rtcore::Vec3 eye = player.camera().eye;
        ASSERT_TRUE(isFinite(eye));
        if (player.mode() == rtcore::MotionMode::Walk) {
            ++walking;
            EXPECT_GE(all.clearance({frame().toMetres(eye), 0}, 0.1), 0.05) << i;
        }
        if (random.coin()) player.setMode(rtcore::MotionMode::View);
        if (random.coin()) held = {};
    }
    EXPECT_GT(walking, count / 10);
}

void SceneWalk::pressOnAnywhere(int count) {
    constexpr int kTicks = 600, kLast = 120, kTurnsAllowed = 3;
    constexpr double kVisible = 5e-4; // metres a step
    int trembled = 0;
    for (int walk = 0; walk < count; ++walk) {
        test::Random random(static_cast<std::uint64_t>(walk));
        rtcore::Walker walker(tree(), mesh(), frame(), shape());
        if (!walker.enter(anywhere(random))) continue;
        rtcore::WalkInput input;
        const double angle = 6.28 * test::fraction(random);
        input.ahead = {std::sin(angle), std::cos(angle), 0};
        bool inWorld = true;
        for (int i = 0; i < kTicks && inWorld; ++i) inWorld = walker.tick({}); // he falls first
        input.forward = 1;
        int turns = 0;
        Vec3d last;
        for (int i = 0; i < kTicks && inWorld; ++i) {
            const Vec3d before = walker.state().feet;
            inWorld = walker.tick(input);
            const Vec3d way = walker.state().feet - before;
            if (length(way) < kVisible) continue;
            if (i >= kTicks - kLast && dot(way, last) < 0) ++turns;
            last = way;
        }
        if (!inWorld || turns <= kTurnsAllowed) continue;
        ++trembled;
        const Vec3d feet = walker.state().feet;
        std::printf("%s: walk %d: %d turns in a second at %.3f %.3f %.3f, ahead %.1f degrees\n",
                    GetParam().name, walk, turns, feet.x, feet.y, feet.z, angle * 57.29578);
    }
    EXPECT_LE(trembled, count / 100);
}

std::string nameOf(const testing::TestParamInfo<Place>& place) { return place.param.name; }

} // namespace

TEST_P(SceneWalk, NothingIsEverInsideThePlayer) { walkAtRandom(walks(20)); }
TEST_P(SceneWalk, TakesTheSamePathAtAnyFrameRate) { playAtAnyFrameRate(); }
TEST_P(SceneWalk, TakesTheSamePathInAnyOrderOfTriangles) { walkInAnyOrder(walks(20)); }
TEST_P(SceneWalk, StartsOrRefusesAnywhere) { toggleAnywhere(walks(100)); }
TEST_P(SceneWalk, DoesNotTrembleAgainstWalls) { pressOnAnywhere(walks(40)); }
TEST_P(SceneWalk, EntersWhereThereIsRoom) { enterAnywhere(walks(100)); }

INSTANTIATE_TEST_SUITE_P(Scenes, SceneWalk, testing::ValuesIn(kPlaces), nameOf);
