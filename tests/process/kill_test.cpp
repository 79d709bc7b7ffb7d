/// kill -9 at any moment: a .bsp or a .light is the old one, or none, or a whole new one. RT_KILLS sets how
/// often (20).
#include "process/sample_scene.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/light/light_file.h"
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <thread>

namespace {

int kills() {
    const char* asked = std::getenv("RT_KILLS");
    return asked == nullptr ? 20 : std::max(1, std::atoi(asked));
}

class KilledBuilder : public testing::Test {
  protected:
    void SetUp() override {
        test::writeWaves(folder / "waves.obj", 120);
        const auto start = std::chrono::steady_clock::now();
        ASSERT_EQ(build({}).exitCode, 0);
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        exact_ = test::readBytes(folder / "waves.bsp");
        ASSERT_EQ(build({"-f"}).exitCode, 0);
        fast_ = test::readBytes(folder / "waves.bsp");
        ASSERT_TRUE(exact_ != fast_);
    }
    test::ProgramResult build(std::vector<std::string> extra) {
        extra.insert(extra.begin(), {"waves.obj", "waves.bsp"});
        return test::bspBuilder(extra, {.folder = folder.path()});
    }
    // Half of the kills fall anywhere, half into the end, where the file is written.
    void killOnce() {
        test::RunningProgram program(test::programPath("BSPBuilder"),
                                     {"waves.obj", "waves.bsp", "--progress=json"},
                                     {.folder = folder.path()});
        double delay = std::uniform_real_distribution<double>(0, 1.1 * seconds_)(random_);
        if (random_() % 2 == 0 && program.waitForError("\"writing\"")) {
            delay = std::uniform_real_distribution<double>(0, 0.02)(random_);
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(delay));
        program.send(SIGKILL);
        program.wait();
    }

    test::TemporaryFolder folder;
    std::string exact_, fast_;
    double seconds_ = 0;
    std::mt19937 random_{20100601};
};

TEST_F(KilledBuilder, LeavesTheOldFileOrTheNewOne) {
    int old = 0, replaced = 0;
    for (int i = 0; i < kills(); ++i) {
        test::writeText(folder / "waves.bsp", fast_);
        killOnce();
        const std::string now = test::readBytes(folder / "waves.bsp");
        ASSERT_TRUE(now == fast_ || now == exact_) << "kill " << i << ": " << now.size() << " bytes";
        (now == fast_ ? old : replaced)++;
    }
    RecordProperty("old", old);
    RecordProperty("new", replaced);
    EXPECT_GT(old, 0);
}

TEST_F(KilledBuilder, LeavesNoFileOrTheNewOne) {
    for (int i = 0; i < kills(); ++i) {
        std::filesystem::remove(folder / "waves.bsp");
        killOnce();
        if (!std::filesystem::exists(folder / "waves.bsp")) continue;
        ASSERT_TRUE(test::readBytes(folder / "waves.bsp") == exact_) << "kill " << i;
    }
    EXPECT_EQ(build({}).exitCode, 0);
    EXPECT_NO_THROW(rtcore::readBsp(folder / "waves.bsp"));
}

class KilledLight : public testing::Test {
  protected:
    void SetUp() override {
        test::writeRoom(folder / "room.obj");
        test::writeCamera(folder / "a.cam", 0);
        const auto start = std::chrono::steady_clock::now();
        test::RunningProgram maker = make();
        ASSERT_EQ(maker.wait().exitCode, 0);
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        old_ = test::readBytes(folder / "room.light");
    }
    /// Goes on with the file that there is, or begins one.
    test::RunningProgram make() const {
        return {test::programPath("Renderer"),
                {"room.obj", "--setting=indirect.mode=live", "--make-light=room.light", "--camera=a.cam",
                 "-w", "32", "-h", "24", "--progress=json"},
                {.folder = folder.path()}};
    }
    /// Half of the kills fall anywhere, half where the file may be written.
    void killOnce() {
        test::RunningProgram maker = make();
        const double earliest = random_() % 2 == 0 ? 0 : 0.8;
        const double delay = std::uniform_real_distribution<double>(earliest, 1.1)(random_) * seconds_;
        std::this_thread::sleep_for(std::chrono::duration<double>(delay));
        maker.send(SIGKILL);
        maker.wait();
    }
    /// Its checksum is that of all its bytes.
    bool isWhole() const {
        try {
            rtcore::readLightFile(folder / "room.light", {});
            return true;
        } catch (const rtcore::FileError&) {
            return false;
        }
    }

    test::TemporaryFolder folder;
    std::string old_;
    double seconds_ = 0;
    std::mt19937 random_{20261129};
};

TEST_F(KilledLight, LeavesTheOldFileOrAWholeOne) {
    int replaced = 0;
    for (int i = 0; i < kills(); ++i) {
        test::writeText(folder / "room.light", old_);
        killOnce();
        ASSERT_TRUE(isWhole()) << "kill " << i;
        if (test::readBytes(folder / "room.light") != old_) ++replaced;
    }
    RecordProperty("new", replaced);
    EXPECT_EQ(make().wait().exitCode, 0);
}

TEST_F(KilledLight, LeavesNoFileOrAWholeOne) {
    for (int i = 0; i < kills(); ++i) {
        std::filesystem::remove(folder / "room.light");
        killOnce();
        if (!std::filesystem::exists(folder / "room.light")) continue;
        ASSERT_TRUE(isWhole()) << "kill " << i;
    }
    EXPECT_EQ(make().wait().exitCode, 0);
}

} // namespace
