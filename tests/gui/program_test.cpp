/// GUI as a program: its command line, its exit codes, what it leaves behind.
#include "gui/gui_support.h"

#include "gui/models/preferences.h"
#include "gui/session/server_list.h"

#include <csignal>

namespace {

using namespace test;
using namespace gui;

class ProgramTest : public GuiTest {
  protected:
    ProgramResult run(const std::vector<std::string>& words) const {
        return runProgram(programPath("GUI"), words, {.folder = folder().path(), .timeoutSeconds = 60});
    }
    std::vector<std::string> named(std::vector<std::string> words) const {
        words.push_back("--instance=" + instance.name());
        return words;
    }
};

TEST_F(ProgramTest, AnswersQuestionsWithoutAScreen) {
    const ProgramResult help = run({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_NE(help.output.find("Usage: GUI [SCENE] [OPTION]..."), std::string::npos) << help.output;
    EXPECT_EQ(run({"--version"}).output.rfind("GUI ", 0), 0U);
}

TEST_F(ProgramTest, RefusesAWrongCommandLine) {
    EXPECT_EQ(run({"--nonsense"}).exitCode, 2);
    EXPECT_EQ(run({"room.obj", "room.obj"}).exitCode, 2);
    EXPECT_EQ(run({"room.obj", "--connect"}).exitCode, 2);
    EXPECT_EQ(run({"--instance=a/b"}).exitCode, 2);
}

// Started by an icon, where nobody sees stderr; in a terminal it ends with 66.
TEST_F(ProgramTest, AFileThatIsNotThereIsToldInTheWindow) {
    for (const char* file : {"nothing.obj", "."}) {
        RunningProgram window(programPath("GUI"), {file}, {.folder = folder().path()});
        ASSERT_TRUE(window.waitForError(file)) << window.wait().error;
        QTest::qWait(300);
        window.send(SIGTERM);
        EXPECT_EQ(window.wait().exitCode, 143) << "it was still there";
    }
    if (runProgram("/usr/bin/env", {"script", "--version"}).exitCode != 0)
        GTEST_SKIP() << "skipped: no script(1)";
    const ProgramResult shell = runProgram(
        "/usr/bin/env", {"script", "-qec", programPath("GUI").string() + " nothing.obj", "/dev/null"},
        {.folder = folder().path(), .timeoutSeconds = 60});
    EXPECT_EQ(shell.exitCode, 66);
    EXPECT_NE(shell.output.find("nothing.obj"), std::string::npos) << shell.output;
}

TEST_F(ProgramTest, SaysSoWhenThereIsNoScreen) {
    const ProgramResult result =
        runProgram(programPath("GUI"), {},
                   {.folder = folder().path(),
                    .environment = {{"QT_QPA_PLATFORM", "xcb"}, {"DISPLAY", ":987"}, {"WAYLAND_DISPLAY", ""}},
                    .timeoutSeconds = 60});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.error.find("screen"), std::string::npos) << result.error;
}

TEST_F(ProgramTest, AModelOnTheCommandLineIsServedUntilASignalComes) {
    RunningProgram window(programPath("GUI"), named({"room.obj"}), {.folder = folder().path()});
    Session session;
    session.connectTo(name(), std::chrono::seconds(20));
    ASSERT_TRUE(shows(session));
    session.leave();
    ASSERT_TRUE(comes([&] { return clientsOf(name()) == 1; }));
    window.send(SIGTERM);
    const ProgramResult result = window.wait();
    EXPECT_EQ(result.exitCode, 143) << result.error;
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(ProgramTest, AKilledWindowsServerEndsWithTheLastWhoLooks) {
    RunningProgram window(programPath("GUI"), named({"room.obj"}), {.folder = folder().path()});
    Session session;
    session.connectTo(name(), std::chrono::seconds(20));
    ASSERT_TRUE(shows(session));
    window.send(SIGKILL);
    window.wait();
    ASSERT_TRUE(comes([&] { return clientsOf(name()) == 1; }));
    QTest::qWait(500);
    EXPECT_TRUE(ask(session, QStringLiteral("ping")).done) << "it is ours now";
    session.leave();
    EXPECT_TRUE(comes([&] { return instance.segments().empty(); }));
}

TEST_F(ProgramTest, TwoWindowsAndACommandAtOnce) {
    RunningProgram first(programPath("GUI"), named({"room.obj"}), {.folder = folder().path()});
    ASSERT_TRUE(comes([&] { return clientsOf(name()) == 1; }));
    RunningProgram second(programPath("GUI"), named({"--connect"}), {.folder = folder().path()});
    ASSERT_TRUE(comes([&] { return clientsOf(name()) == 2; }));
    const auto cui = [&](std::vector<std::string> words) {
        return runProgram(programPath("CUI"), named(std::move(words)), {.timeoutSeconds = 60});
    };
    EXPECT_EQ(cui({"camera", "set", "1", "2", "5", "0", "0", "-1", "50"}).exitCode, 0);
    EXPECT_EQ(cui({"key", "press", "w", "--for=200"}).exitCode, 0);
    first.send(SIGTERM);
    EXPECT_EQ(first.wait().exitCode, 143);
    EXPECT_EQ(cui({"ping"}).exitCode, 0) << "the other window is there";
    second.send(SIGTERM);
    EXPECT_EQ(second.wait().exitCode, 143);
    EXPECT_TRUE(comes([&] { return instance.segments().empty(); }))
        << "and the server goes with the last one";
}

TEST_F(ProgramTest, AKeptServerOutlivesAKilledWindow) {
    for (const bool keptFromTheStart : {true, false}) {
        QSettings settings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("rtsuite"),
                           QStringLiteral("GUI"));
        settings.setValue(QLatin1String(pref::keepServers.name), keptFromTheStart);
        settings.sync();
        RunningProgram window(programPath("GUI"), named({"room.obj"}), {.folder = folder().path()});
        Session session;
        session.connectTo(name(), std::chrono::seconds(20));
        ASSERT_TRUE(shows(session));
        if (!keptFromTheStart) {
            EXPECT_TRUE(ask(session, QStringLiteral("parent none")).done);
        }
        session.leave();
        window.send(SIGKILL);
        window.wait();
        QTest::qWait(1000);
        const auto cui = [&](const char* word) {
            return runProgram(programPath("CUI"), {"--instance=" + instance.name(), word}).exitCode;
        };
        EXPECT_EQ(cui("ping"), 0);
        EXPECT_EQ(cui("exit"), 0);
    }
}

TEST_F(ProgramTest, ConnectsToAServerAndLeavesIt) {
    startServer();
    RunningProgram window(programPath("GUI"), named({"--connect"}), {.folder = folder().path()});
    ASSERT_TRUE(comes([&] { return clientsOf(name()) == 1; }));
    window.send(SIGINT);
    EXPECT_EQ(window.wait().exitCode, 130);
    EXPECT_TRUE(comes([&] { return clientsOf(name()) == 0; }));
    EXPECT_EQ(runProgram(programPath("CUI"), {"--instance=" + instance.name(), "ping"}).exitCode, 0);
}

} // namespace
