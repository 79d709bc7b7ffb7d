/// Servers for the tests of the window, and patience.
#pragma once

#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "process/sample_scene.h"
#include "support/ipc_instance.h"
#include "support/run_program.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <QTest>

#include <optional>
#include <string>
#include <vector>

namespace test {

constexpr int kPatience = 20000; ///< milliseconds, for what must come, on a busy machine

/// Runs the event loop until `condition` holds.
template <typename Condition>
bool comes(Condition condition, int milliseconds = kPatience) {
    return QTest::qWaitFor(condition, milliseconds);
}

/// With the release that QTest::mouseDClick() leaves out: its button would stay down for all tests after it.
inline void doubleClick(QWidget* widget, Qt::KeyboardModifiers keys = {}, const QPoint& at = {}) {
    QTest::mouseDClick(widget, Qt::LeftButton, keys, at);
    QTest::mouseRelease(widget, Qt::LeftButton, keys, at);
}

/// Fixture: a folder with room.obj, an instance name, and at most one server that is nobody's child.
class GuiTest : public testing::Test {
  protected:
    void SetUp() override {
        writeRoom(folder() / "room.obj");
        // With a unit that is known, no notice offers another and takes room from the image.
        writeText(folder() / "room.obj", "# units = metres\n" + readBytes(folder() / "room.obj"));
        QSettings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("rtsuite"),
                  QStringLiteral("GUI"))
            .clear();
    }

    const TemporaryFolder& folder() const { return instance.folder(); }
    QString file(const std::string& name) const { return QString::fromStdString((folder() / name).string()); }
    QString name() const { return QString::fromStdString(instance.name()); }

    /// A server of the instance, with its first frame.
    void startServer(const std::vector<std::string>& options = {}) {
        std::vector<std::string> words{"room.obj", "--instance=" + instance.name(), "--resolution=64x48"};
        words.insert(words.end(), options.begin(), options.end());
        server.emplace(programPath("RTServer"), words, ProgramSettings{.folder = folder().path()});
        ASSERT_TRUE(server->waitForError("ready: ")) << server->wait().error;
    }
    gui::ServerRequest request() const {
        return {file("room.obj"), name(), QSize(64, 48), {QStringLiteral("--threads=1")}};
    }
    /// Connected, with a frame.
    static bool shows(const gui::Session& session) {
        return comes(
            [&] { return session.state() == gui::SessionState::Connected && !session.frame().isNull(); });
    }
    /// The answer to a command, waited for.
    static gui::Answer ask(gui::Session& session, const QString& command) {
        return ask(session, command.toStdString());
    }
    static gui::Answer ask(gui::Session& session, const std::string& command) {
        std::optional<gui::Answer> answer;
        session.send(command, &session, [&](const gui::Answer& given) { answer = given; });
        EXPECT_TRUE(comes([&] { return answer.has_value(); })) << command;
        return answer.value_or(gui::Answer());
    }

    IpcInstance instance;
    std::optional<RunningProgram> server;
};

} // namespace test
