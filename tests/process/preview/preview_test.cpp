/// Renderer --preview: what is shown, in which order, and how it ends.
#include "process/preview/live_preview.h"

#include "common/frames/error_byte.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/neural/net_files.h"

#include <cmath>
#include <cstring>
#include <span>

#include <sys/types.h>

namespace {

using namespace test;

using Previewing = LivePreview;

bool samePixels(const ipc::Frame& frame, const rtcore::LdrImage& picture) {
    return frame.info.width == static_cast<std::uint32_t>(picture.width) &&
           frame.info.height == static_cast<std::uint32_t>(picture.height) &&
           std::memcmp(frame.pixels.data(), picture.pixels.data(), frame.pixels.size()) == 0;
}

// The fourth byte of a pixel tells whether it has samples of its own.
bool isColour(std::size_t byte) { return byte % 4 != 3; }

int ownSamples(const ipc::Frame& frame) {
    int count = 0;
    for (std::size_t i = 3; i < frame.pixels.size(); i += 4) {
        EXPECT_TRUE(frame.pixels[i] == std::byte{0} || frame.pixels[i] == std::byte{255});
        if (frame.pixels[i] != std::byte{0}) ++count;
    }
    return count;
}

double meanOf(const ipc::Frame& frame) {
    double sum = 0;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        if (isColour(i)) sum += std::to_integer<int>(frame.pixels[i]);
    }
    return sum / static_cast<double>(frame.pixels.size());
}

double differenceOf(const ipc::Frame& a, const ipc::Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        if (!isColour(i)) continue;
        sum += std::abs(std::to_integer<int>(a.pixels[i]) - std::to_integer<int>(b.pixels[i]));
    }
    return sum / static_cast<double>(a.pixels.size());
}

// So many samples that even two fast processors are at it for half a second.
TEST_F(Previewing, BecomesFinerUpToThePictureItself) {
    start({"-w", "403", "-h", "301", "-a", "8", "--threads=2", "-o", "a.png", "--run-id=41"});
    look();
    const std::vector<ipc::Frame> frames = watch();
    ASSERT_GE(frames.size(), 3U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const ipc::FrameInfo& info = frames[i].info;
        EXPECT_EQ(info.width, 403U);
        EXPECT_EQ(info.height, 301U);
        EXPECT_EQ(info.run, 41U);
        if (i > 0) {
            EXPECT_GT(info.tag, frames[i - 1].info.tag);
            EXPECT_GE(info.samples, frames[i - 1].info.samples);
        }
    }
    const ipc::Frame& last = frames.back();
    EXPECT_EQ(last.info.tag, ipc::kPreviewDone);
    EXPECT_EQ(last.info.samples, 64U);
    EXPECT_LT(frames.front().info.samples, 64U);
    for (std::size_t i = 1; i < frames.size(); ++i)
        EXPECT_GE(ownSamples(frames[i]), ownSamples(frames[i - 1]));
    // The first image is gone when we come late.
    if (frames.front().info.samples == 0) {
        EXPECT_EQ(ownSamples(frames.front()), 0) << "all are interpolated";
    }
    EXPECT_EQ(ownSamples(last), 403 * 301);

    // No jump of the exposure, and always nearer to the last.
    for (const ipc::Frame& frame : frames) EXPECT_NEAR(meanOf(frame), meanOf(last), 1.5) << frame.info.tag;
    EXPECT_GT(differenceOf(frames.front(), last), 0);
    for (std::size_t i = 1; i < frames.size(); ++i) {
        EXPECT_LE(differenceOf(frames[i], last), differenceOf(frames[i - 1], last) + 0.05) << i;
    }

    const ipc::Status status = viewer->status();
    EXPECT_EQ(status.progress, 1);
    EXPECT_EQ(status.idle, 1U);
    EXPECT_EQ(status.width, 403U);
    EXPECT_GT(status.frameSeconds, 0);
    const ProgramResult result = program->wait();
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.error, "");
    EXPECT_TRUE(samePixels(last, rtcore::readLdrImage(folder() / "a.png")));
    EXPECT_TRUE(instance.segments().empty());

    ASSERT_EQ(renderer({"room.bsp", "-w", "403", "-h", "301", "-a", "8", "-o", "plain.png"},
                       {.folder = folder().path()})
                  .exitCode,
              0);
    EXPECT_TRUE(readBytes(folder() / "a.png") == readBytes(folder() / "plain.png"));
}

TEST_F(Previewing, WritesNoFileUnlessAsked) {
    start({"-w", "64", "-h", "48", "--linger=10"});
    look();
    const std::vector<ipc::Frame> frames = watch();
    ASSERT_FALSE(frames.empty());
    EXPECT_EQ(frames.back().info.run, 0U);
    // All is done: the signal only ends the waiting.
    program->send(SIGTERM);
    EXPECT_EQ(program->wait().exitCode, 0);
    EXPECT_EQ(filesIn(folder().path()), (Names{"room.bsp", "room.obj"}));
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Previewing, TheLastFrameStaysForThoseWhoHaveIt) {
    start({"-w", "64", "-h", "48", "--linger=0.5"});
    look();
    ipc::Frame frame;
    ASSERT_TRUE(viewer->waitForFrame(frame, std::chrono::seconds(20)));
    EXPECT_EQ(program->wait().exitCode, 0);
    EXPECT_TRUE(instance.segments().empty());
    // The memory is that of the viewer, too.
    (void)viewer->readFrame(frame);
    EXPECT_EQ(frame.info.tag, ipc::kPreviewDone);
    EXPECT_EQ(viewer->update(), ipc::LinkState::Gone);
}

TEST_F(Previewing, TellsProgressWhileItRenders) {
    start({"-w", "3000", "-h", "3000", "-a", "16", "--setting=indirect.mode=off"});
    look();
    ASSERT_TRUE(within(30, [&] { return viewer->status().progress > 0; }));
    const float first = viewer->status().progress;
    EXPECT_TRUE(within(30, [&] { return viewer->status().progress > first; }));
    EXPECT_LT(viewer->status().progress, 1);
    EXPECT_EQ(viewer->status().idle, 0U);
    EXPECT_EQ(viewer->status().polygons, 168U);
    EXPECT_NE(viewer->update(), ipc::LinkState::Gone);
    const ProgramResult answer =
        runProgram(programPath("CUI"), {"--instance=" + instance.name(), "get", "width"}, {});
    EXPECT_EQ(answer.exitCode, 1);
    EXPECT_NE(answer.error.find("takes no commands"), std::string::npos) << answer.error;
    program->send(SIGINT);
    EXPECT_EQ(program->wait().exitCode, 130);
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Previewing, AModelThatIsStillLoaded) {
    writeWaves(folder() / "waves.obj", 300);
    program.emplace(programPath("Renderer"),
                    Names{"waves.obj", "--preview=" + instance.name(), "-w", "64", "-h", "48"},
                    ProgramSettings{.folder = folder().path()});
    look();
    EXPECT_EQ(viewer->status().progress, 0) << "it can be found before it has anything to show";
    program->send(SIGTERM);
    EXPECT_EQ(program->wait().exitCode, 143);
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Previewing, TheNameIsTaken) {
    start({"-w", "3000", "-h", "3000", "-a", "16", "--setting=indirect.mode=off"});
    look();
    const ProgramResult second = run({"-w", "8", "-h", "8"});
    EXPECT_EQ(second.exitCode, 75);
    EXPECT_NE(second.error.find("Renderer: "), std::string::npos) << second.error;
    EXPECT_NE(viewer->update(), ipc::LinkState::Gone) << "the first one goes on";
    program->send(SIGTERM);
    EXPECT_EQ(program->wait().exitCode, 143);
}

TEST_F(Previewing, TellsTheErrorThatANetLeaves) {
    if (rtcore::findNet(rtcore::fileOf(rtcore::Net::Base), {}, programPath("Renderer").parent_path())
            .file.empty())
        GTEST_SKIP() << "skipped: there are no weights beside the build";
    start({"-w", "64", "-h", "48", "--integrator=path", "--look=sky", "--samples=32", "--denoise=base", "-o",
           "a.png"});
    look();
    const std::vector<ipc::Frame> frames = watch();
    ASSERT_FALSE(frames.empty());
    for (const ipc::Frame& frame : frames) {
        const bool known = frame.info.format == ipc::PixelFormat::Rgb8Error8;
        EXPECT_EQ(known, frame.info.samples >= 16) << frame.info.samples;
        EXPECT_EQ(frame.info.error > 0, known);
        EXPECT_GE(frame.info.largestError, frame.info.error);
    }
    const ipc::Frame& last = frames.back();
    double squares = 0;
    for (std::size_t i = 3; i < last.pixels.size(); i += 4) {
        const auto error =
            static_cast<double>(app::errorOfByte(std::to_integer<std::uint8_t>(last.pixels[i])));
        squares += error * error;
    }
    const auto whole = static_cast<double>(app::errorOfThousandths(last.info.error));
    EXPECT_NEAR(std::sqrt(squares / (64 * 48)), whole, 0.03 * whole + 0.01);
    EXPECT_EQ(program->wait().exitCode, 0);
    const rtcore::LdrImage written = rtcore::readLdrImage(folder() / "a.png");
    const std::span<const std::byte> bytes = std::as_bytes(std::span(written.pixels));
    ASSERT_EQ(bytes.size(), last.pixels.size());
    for (std::size_t i = 0; i < bytes.size(); ++i)
        EXPECT_TRUE(!isColour(i) || last.pixels[i] == bytes[i]) << i;
}

TEST_F(Previewing, BadCommandLines) {
    const auto code = [&](const Names& all) {
        return runProgram(programPath("Renderer"), all, {.folder = folder().path()}).exitCode;
    };
    EXPECT_EQ(code({"room.bsp", "--preview=a/b"}), 2);
    EXPECT_EQ(code({"room.bsp", "--preview=a", "--list=b.lst"}), 2);
    EXPECT_EQ(code({"room.bsp", "--run-id=3"}), 2);
    EXPECT_EQ(code({"room.bsp", "--linger=3"}), 2);
    EXPECT_EQ(code({"room.bsp", "--preview=a", "--run-id=-1"}), 2);
    EXPECT_EQ(code({"room.bsp", "--parent=0"}), 2);
    EXPECT_EQ(run({"-o", "no-such-folder/a.png"}).exitCode, 73);
    EXPECT_TRUE(instance.segments().empty());
}

class Orphaned : public LivePreview {
  protected:
    static std::string parentLine(pid_t process) {
        const std::string status = readBytes("/proc/" + std::to_string(process) + "/status");
        const std::size_t begin = std::min(status.size(), status.find("PPid:"));
        return status.substr(begin, status.find('\n', begin) - begin);
    }
    /// Gone, or waiting for a system process that reaps orphans, which a container may lack.
    static bool ended(pid_t process) {
        const std::string stat = readBytes("/proc/" + std::to_string(process) + "/stat");
        return stat.empty() || stat.find(") Z ") != std::string::npos;
    }
    /// A shell that starts a Renderer of many minutes and waits for it.
    void startByShell(const std::string& options) {
        const std::string command = "'" + programPath("Renderer").string() +
                                    "' room.bsp -w 3000 -h 3000 -a 16 --setting=indirect.mode=off " +
                                    options + " --progress=none & wait";
        program.emplace("/bin/sh", Names{"-c", command}, ProgramSettings{.folder = folder().path()});
    }
};

TEST_F(Orphaned, EndsWithTheParent) {
    startByShell("--preview=" + instance.name());
    look();
    ipc::Frame frame;
    ASSERT_TRUE(viewer->waitForFrame(frame, std::chrono::seconds(30)));
    const auto renderer = static_cast<pid_t>(viewer->serverProcess());
    program->send(SIGKILL);
    const Clock::time_point killed = Clock::now();
    EXPECT_TRUE(within(10, [&] { return !alive(); }));
    RecordProperty("milliseconds", static_cast<int>(1000 * secondsSince(killed)));
    EXPECT_LT(secondsSince(killed), 1);
    EXPECT_TRUE(within(1, [&] { return ended(renderer); }));
    EXPECT_TRUE(instance.segments().empty());
    EXPECT_EQ(viewer->update(), ipc::LinkState::Gone);
}

// As from a window that is closed: of the two reasons to stop the second must not cut the cleaning up short.
TEST_F(Orphaned, EndsWithTheParentEvenAfterASignal) {
    startByShell("--preview=" + instance.name());
    look();
    const auto renderer = static_cast<pid_t>(viewer->serverProcess());
    ::kill(renderer, SIGTERM);
    program->send(SIGKILL);
    EXPECT_TRUE(within(10, [&] { return !alive(); }));
    EXPECT_TRUE(within(1, [&] { return ended(renderer); }));
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Orphaned, EndsWithTheParentEvenBeforeASignal) {
    for (int pause = 0; pause < 5; ++pause) {
        startByShell("--preview=" + instance.name());
        look();
        ipc::Frame frame;
        ASSERT_TRUE(viewer->waitForFrame(frame, std::chrono::seconds(30)));
        const auto renderer = static_cast<pid_t>(viewer->serverProcess());
        const std::string shell = parentLine(renderer);
        program->send(SIGKILL);
        ASSERT_TRUE(within(10, [&] { return parentLine(renderer) != shell; }));
        std::this_thread::sleep_for(std::chrono::milliseconds(pause));
        ::kill(renderer, SIGTERM);
        EXPECT_TRUE(within(10, [&] { return !alive(); }));
        EXPECT_TRUE(within(1, [&] { return ended(renderer); }));
        EXPECT_TRUE(instance.segments().empty());
    }
}

TEST_F(Orphaned, TheParentDiedBefore) {
    // Its starter is this test, not the process 1.
    const ProgramResult result = run({"--parent=1", "-w", "3000", "-h", "3000", "-a", "16"});
    EXPECT_EQ(result.exitCode, 143);
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(Orphaned, WithoutAPreview) {
    const ProgramResult done =
        renderer({"room.bsp", "-o", "a.png", "-w", "8", "-h", "8", "--parent=" + std::to_string(::getpid())},
                 {.folder = folder().path()});
    EXPECT_EQ(done.exitCode, 0) << done.error;
    const ProgramResult stopped =
        renderer({"room.bsp", "-o", "b.png", "-w", "3000", "-h", "3000", "-a", "16", "--parent=1"},
                 {.folder = folder().path()});
    EXPECT_EQ(stopped.exitCode, 143);
    EXPECT_FALSE(std::filesystem::exists(folder() / "b.png"));
}

} // namespace
