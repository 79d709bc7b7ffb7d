/// The session with real servers, without a window.
#include "gui/gui_support.h"

#include "gui/session/server_list.h"
#include "support/other_version.h"

#include <QElapsedTimer>
#include <QSignalSpy>

#include <cmath>
#include <csignal>

namespace {

using namespace test;
using namespace gui;
using namespace std::chrono_literals;

class SessionTest : public GuiTest {
  protected:
    void connect() {
        session.connectTo(name());
        ASSERT_TRUE(shows(session)) << session.reason().toStdString();
    }
    /// The server of this test among all that run.
    RunningServer listed() const {
        for (const RunningServer& each : runningServers()) {
            if (each.instance == name()) return each;
        }
        return {};
    }
    Session session;
};

TEST_F(SessionTest, SaysThatThereIsNoServerWhenItsPatienceEnds) {
    session.connectTo(name(), 100ms);
    EXPECT_EQ(session.state(), SessionState::Connecting);
    ASSERT_TRUE(comes([&] { return session.state() == SessionState::Disconnected; }));
    EXPECT_TRUE(session.reason().contains(name())) << session.reason().toStdString();
    EXPECT_FALSE(ask(session, QStringLiteral("ping")).done);
}

TEST_F(SessionTest, ShowsFramesAndStatus) {
    startServer();
    connect();
    EXPECT_EQ(session.frame().size(), QSize(64, 48));
    EXPECT_EQ(session.status().resolution, QSize(64, 48));
    EXPECT_GT(session.status().polygons, 0U);
    EXPECT_FALSE(session.status().view.walking);
    EXPECT_EQ(ask(session, QStringLiteral("resolution 40 30")).done, true);
    EXPECT_TRUE(comes([&] { return session.frame().size() == QSize(40, 30); }));
}

TEST_F(SessionTest, AFrameIsTheServersPicture) {
    startServer();
    connect();
    ASSERT_TRUE(ask(session, QStringLiteral("wait-idle")).done);
    ASSERT_TRUE(ask(session, command::screenshot(file("a b.png").toStdString())).done);
    QTest::qWait(50);
    const QImage saved = QImage(file("a b.png")).convertToFormat(QImage::Format_RGB32);
    EXPECT_EQ(session.frame().convertToFormat(QImage::Format_RGB32), saved);
}

TEST_F(SessionTest, KeysMoveTheCamera) {
    startServer();
    connect();
    const QVector3D before = session.status().view.eye;
    session.pressKey('W');
    EXPECT_TRUE(comes([&] { return session.status().view.eye != before; }));
    session.releaseKey('W');
    EXPECT_TRUE(comes([&] { return session.status().idle; }));
    session.pressKey('W');
    session.releaseAllKeys();
    EXPECT_TRUE(comes([&] { return session.status().idle; }));
}

TEST_F(SessionTest, TurnsAddUpWhateverTheFrameRate) {
    startServer();
    connect();
    ASSERT_TRUE(ask(session, QStringLiteral("camera set 0 1 4 0 0 -1")).done);
    ASSERT_TRUE(comes([&] { return session.status().view.forward == QVector3D(0, 0, -1); }));
    const QVector3D before = session.status().view.forward;
    for (int i = 0; i < 300; ++i) {
        session.turn(0.1, 0);
        if (i % 10 == 0) QTest::qWait(1);
    }
    const auto angle = [&] {
        const float cosine = QVector3D::dotProduct(before, session.status().view.forward);
        return std::acos(std::clamp(cosine, -1.0F, 1.0F)) * 180 / 3.14159265F;
    };
    EXPECT_TRUE(comes([&] { return std::abs(angle() - 30) < 0.05F; })) << angle();
}

TEST_F(SessionTest, FailuresComeWithTheirReasonAndWithoutTheExitCode) {
    startServer();
    connect();
    const Answer answer = ask(session, QStringLiteral("load camera /nowhere/a.cam"));
    EXPECT_FALSE(answer.done);
    EXPECT_FALSE(answer.text.isEmpty());
    EXPECT_FALSE(answer.text.front().isDigit()) << answer.text.toStdString();
    QSignalSpy failures(&session, &Session::commandFailed);
    session.send("nonsense");
    EXPECT_TRUE(comes([&] { return failures.count() == 1; }));
}

TEST_F(SessionTest, NobodyIsCalledWhoIsGone) {
    startServer();
    connect();
    bool called = false;
    {
        const QObject context;
        session.send(command::ping(), &context, [&](const Answer&) { called = true; });
    }
    EXPECT_TRUE(ask(session, QStringLiteral("ping")).done);
    EXPECT_FALSE(called);
}

TEST_F(SessionTest, MoreCommandsThanTheQueueTakesAreAllAnswered) {
    startServer();
    connect();
    int done = 0;
    for (int i = 0; i < 200; ++i)
        session.send(command::ping(), &session, [&](const Answer& answer) { done += answer.done ? 1 : 0; });
    EXPECT_TRUE(comes([&] { return done == 200; })) << done;
}

TEST_F(SessionTest, AKilledServerIsLostWithinASecondAndItsLastFrameStays) {
    startServer();
    connect();
    bool told = false;
    server->send(SIGSTOP); // so that the command is still open
    session.send(command::ping(), &session, [&](const Answer& answer) { told = !answer.done; });
    QTest::qWait(20);
    QElapsedTimer clock;
    clock.start();
    server->send(SIGKILL);
    ASSERT_TRUE(comes([&] { return session.state() == SessionState::Lost; }));
    EXPECT_LT(clock.elapsed(), 1000);
    EXPECT_TRUE(told);
    EXPECT_FALSE(session.frame().isNull());
    EXPECT_FALSE(session.live());
}

TEST_F(SessionTest, TheNextServerOfTheNameIsTaken) {
    startServer();
    connect();
    server->send(SIGKILL);
    ASSERT_TRUE(comes([&] { return session.state() == SessionState::Lost; }));
    server.reset();
    startServer();
    EXPECT_TRUE(comes([&] { return session.state() == SessionState::Connected; }));
    EXPECT_TRUE(ask(session, QStringLiteral("ping")).done);
}

TEST_F(SessionTest, AServerThatIsStoppedIsBusyNotDead) {
    startServer();
    connect();
    server->send(SIGSTOP);
    EXPECT_TRUE(comes([&] { return session.state() == SessionState::Busy; }));
    server->send(SIGCONT);
    EXPECT_TRUE(comes([&] { return session.state() == SessionState::Connected; }));
}

TEST_F(SessionTest, TwoSessionsSeeTheSameServer) {
    startServer();
    connect();
    Session other;
    other.connectTo(name());
    ASSERT_TRUE(shows(other));
    EXPECT_TRUE(comes([&] { return clientsOf(name()) == 2; }));
    session.pressKey('W');
    const QVector3D before = other.status().view.eye;
    EXPECT_TRUE(comes([&] { return other.status().view.eye != before; }));
    session.leave();
    EXPECT_EQ(session.state(), SessionState::Disconnected);
    EXPECT_TRUE(comes([&] { return other.status().idle; })) << "the keys of who leaves are released";
}

TEST_F(SessionTest, AServerOfAnotherVersionIsRefused) {
    const ServerOfAnotherVersion other(instance);
    session.connectTo(name());
    ASSERT_TRUE(comes([&] { return session.state() == SessionState::Refused; }));
    EXPECT_TRUE(session.reason().contains(QStringLiteral("version"))) << session.reason().toStdString();
    EXPECT_EQ(listed().instance, name());
    EXPECT_FALSE(listed().trouble.isEmpty());
}

TEST_F(SessionTest, RunningServersAreListedWithTheirClients) {
    startServer();
    connect();
    EXPECT_TRUE(comes([&] { return listed().clients == 1; }));
    EXPECT_EQ(listed().resolution, QSize(64, 48));
    EXPECT_EQ(listed().process, session.serverProcess());
    EXPECT_EQ(freeInstanceName(name()), name() + QStringLiteral("-2"));
    EXPECT_EQ(freeInstanceName(QStringLiteral("nobody-has-this")), QStringLiteral("nobody-has-this"));
}

} // namespace
