/// A Renderer that is interrupted again and again, as by who moves while it refines. RT_PREVIEW_KILLS sets
/// how often (40).
#include "process/preview/live_preview.h"

#include <algorithm>
#include <cstdlib>
#include <random>

namespace {

using namespace test;

int kills() {
    const char* asked = std::getenv("RT_PREVIEW_KILLS");
    return asked == nullptr ? 40 : std::max(1, std::atoi(asked));
}

class Interrupted : public LivePreview {
  protected:
    /// How long this machine takes until a first frame is there.
    double timeToShow() {
        const Clock::time_point begin = Clock::now();
        start({"-w", "1600", "-h", "1200", "-a", "16", "--setting=indirect.mode=off", "--run-id=0"});
        look();
        EXPECT_TRUE(within(60, [&] { return viewer->readFrame(frame_); }));
        const double seconds = secondsSince(begin);
        program->send(SIGTERM);
        EXPECT_EQ(program->wait().exitCode, 143);
        EXPECT_TRUE(instance.segments().empty());
        return seconds;
    }

    /// Looks at what is shown for so long. Once a frame of this run was there, no other may follow.
    void lookFor(double seconds, std::uint64_t run) {
        const Clock::time_point begin = Clock::now();
        bool mine = false;
        while (secondsSince(begin) < seconds) {
            if (!viewer) {
                try {
                    viewer.emplace(instance.name(), std::chrono::milliseconds(1));
                } catch (const ipc::Error&) {
                    continue;
                }
            }
            if (viewer->readFrame(frame_)) {
                ASSERT_LE(frame_.info.run, run);
                ASSERT_TRUE(!mine || frame_.info.run == run) << "an old image";
                mine = frame_.info.run == run;
                ++frames_;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    std::mt19937 random_{20101120};
    ipc::Frame frame_;
    int frames_ = 0;
};

TEST_F(Interrupted, LeavesNothingAndTheNextOneWorks) {
    const double shown = timeToShow();
    std::uniform_real_distribution<double> anyMoment(0, 2 * shown);
    std::vector<double> endings;
    for (int i = 1; i <= kills(); ++i) {
        const std::vector<std::string> left = instance.segments();
        // More than any machine draws in that time: what is complete ends well in spite of the signal.
        start({"-w", "1600", "-h", "1200", "-a", "16", "--setting=indirect.mode=off",
               "--run-id=" + std::to_string(i)});
        ASSERT_NO_FATAL_FAILURE(lookFor(anyMoment(random_), static_cast<std::uint64_t>(i)));
        const bool gently = random_() % 2 == 0;
        const Clock::time_point begin = Clock::now();
        program->send(gently ? SIGTERM : SIGKILL);
        const ProgramResult result = program->wait();
        if (!gently) {
            ASSERT_EQ(result.signal, SIGKILL) << i;
            continue;
        }
        endings.push_back(secondsSince(begin));
        // Before main() took the signal over, it ends the process by itself.
        ASSERT_TRUE(result.exitCode == 143 || result.signal == SIGTERM)
            << i << ": exit " << result.exitCode << ", signal " << result.signal << ", " << result.error;
        // One that was stopped before it showed anything leaves what the killed one before it left.
        if (result.exitCode == 143) {
            ASSERT_TRUE(instance.segments().empty() || instance.segments() == left) << i;
        }
    }
    EXPECT_GT(frames_, 0);
    ASSERT_FALSE(endings.empty());
    std::sort(endings.begin(), endings.end());
    std::printf("%d frames seen; %zu times SIGTERM: gone after %.1f ms, at most %.1f ms\n", frames_,
                endings.size(), 1000 * endings[endings.size() / 2], 1000 * endings.back());
    EXPECT_LT(endings.back(), 30) << "it waits for something";

    // The remains of the killed ones do not hold up the last.
    start({"-w", "64", "-h", "48", "--run-id=" + std::to_string(kills() + 1)});
    if (!viewer) look();
    std::uint64_t tag = 0;
    EXPECT_TRUE(within(30, [&] {
        if (viewer->readFrame(frame_) && frame_.info.run == static_cast<std::uint64_t>(kills()) + 1)
            tag = frame_.info.tag;
        return tag == ipc::kPreviewDone;
    }));
    EXPECT_EQ(program->wait().exitCode, 0);
    EXPECT_TRUE(instance.segments().empty());
}

} // namespace
