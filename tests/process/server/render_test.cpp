/// CUI render: the Renderer at work on the server's view.
#include "process/server/live_server.h"

#include <filesystem>

namespace {

using namespace test;
namespace fs = std::filesystem;

class RenderCommand : public LiveServer {
  protected:
    void SetUp() override {
        LiveServer::SetUp();
        fs::create_directory(folder() / "tmp");
        settings.folder = folder().path();
        settings.environment = {{"TMPDIR", (folder() / "tmp").string()}};
    }
    ProgramResult render(const Names& words) const {
        return runProgram(programPath("CUI"), all(words), settings);
    }
    Names all(const Names& words) const {
        Names line{"--instance=" + instance.name(), "render"};
        line.insert(line.end(), words.begin(), words.end());
        return line;
    }
    void expectNothingLeft() const { EXPECT_EQ(filesIn(folder() / "tmp"), Names{}); }

    ProgramSettings settings;
};

TEST_F(RenderCommand, MakesThePictureOfTheExportedFiles) {
    start();
    ask({"camera", "look-at", "1", "2", "7.5", "-0.5", "0.3", "0", "71"});
    ask({"light", "1", "off"});
    ask({"wait-idle"}); // the exposure stands still
    for (const Names& options : {Names{}, Names{"-a", "3", "-w", "90", "-h", "70"}}) {
        Names words{"view.png"};
        if (!options.empty()) words.emplace_back("--");
        words.insert(words.end(), options.begin(), options.end());
        const ProgramResult result = render(words);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        ask({"export", "camera", "same.cam"});
        ask({"export", "scene", "same.scn"});
        Names again{"same.scn", "--camera=same.cam", "-o", "same.png", "--force"};
        again.insert(again.end(), options.begin(), options.end());
        ASSERT_EQ(renderer(again, {.folder = folder().path()}).exitCode, 0);
        EXPECT_FALSE(bytes("view.png").empty());
        EXPECT_TRUE(bytes("view.png") == bytes("same.png"));
    }
    EXPECT_EQ(pngSize(bytes("view.png")), (PictureSize{90, 70}));
    expectNothingLeft();
}

TEST_F(RenderCommand, PassesTheStreamsOn) {
    start();
    const ProgramResult result = render({"-", "--", "--progress=json"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(pngSize(result.output), (PictureSize{64, 48}));
    EXPECT_NE(result.error.find("\"rendering\""), std::string::npos) << result.error;
}

TEST_F(RenderCommand, FailsAsTheRendererDoes) {
    start();
    const ProgramResult usage = render({"view.png", "--", "--nonsense"});
    EXPECT_EQ(usage.exitCode, 2);
    EXPECT_NE(usage.error.find("Renderer: unknown option '--nonsense'"), std::string::npos) << usage.error;
    EXPECT_NE(usage.error.find("CUI: the Renderer failed with exit code 2"), std::string::npos)
        << usage.error;
    EXPECT_EQ(render({"view.png", "--", "--model=none.obj"}).exitCode, 66);
    EXPECT_EQ(render({"none/view.png"}).exitCode, 73);
    EXPECT_EQ(render({}).exitCode, 2);
    writeText(folder() / "commands", "# two lines\nrender view.png --threads=-1\n");
    const ProgramResult script = cui({"script", "commands"});
    EXPECT_EQ(script.exitCode, 2);
    EXPECT_NE(script.error.find("CUI: commands:2: the Renderer failed"), std::string::npos) << script.error;
    EXPECT_EQ(bytes("view.png"), "");
    expectNothingLeft();
}

TEST_F(RenderCommand, WithoutAServerOrARenderer) {
    EXPECT_EQ(render({"view.png"}).exitCode, 75);
    start();
    settings.environment.emplace_back("RT_RENDERER", (folder() / "none").string());
    const ProgramResult result = render({"view.png"});
    EXPECT_EQ(result.exitCode, 66);
    EXPECT_NE(result.error.find("the Renderer is missing"), std::string::npos) << result.error;
    expectNothingLeft();
}

TEST_F(RenderCommand, IsStoppedWithTheRenderer) {
    start();
    for (const std::vector<int>& signals : {std::vector{SIGINT}, {SIGTERM}, {SIGINT, SIGINT, SIGINT}}) {
        RunningProgram program(
            programPath("CUI"),
            all({"view.png", "--", "-w", "3000", "-h", "3000", "-a", "16", "--progress=json"}), settings);
        ASSERT_TRUE(program.waitForError("\"rendering\""));
        for (const int signal : signals) program.send(signal);
        const ProgramResult result = program.wait(); // that is, until nobody has its streams any more
        EXPECT_EQ(result.exitCode, 128 + signals.front()) << result.error;
        EXPECT_FALSE(result.timedOut);
        EXPECT_EQ(bytes("view.png"), "");
        expectNothingLeft();
    }
}

TEST_F(RenderCommand, KilledItLeavesNoRenderer) {
    start();
    {
        RunningProgram program(
            programPath("CUI"),
            all({"view.png", "--", "-w", "3000", "-h", "3000", "-a", "16", "--progress=json"}), settings);
        ASSERT_TRUE(program.waitForError("\"rendering\""));
        program.send(SIGKILL);
        const ProgramResult result = program.wait();
        EXPECT_EQ(result.signal, SIGKILL);
        EXPECT_FALSE(result.timedOut);
    }
    EXPECT_EQ(filesIn(folder() / "tmp").size(), 1U);
    EXPECT_EQ(render({"view.png"}).exitCode, 0) << "and the next one removes the folder";
    expectNothingLeft();
}

} // namespace
