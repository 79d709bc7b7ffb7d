/// Servers that the window starts: their deaths, their restarts, their end.
#include "gui/gui_support.h"

#include "gui/session/server_list.h"

#include <QElapsedTimer>
#include <QSignalSpy>

#include <csignal>

namespace {

using namespace test;
using namespace gui;

class KeeperTest : public GuiTest {
  protected:
    void start() {
        keeper.start(request());
        ASSERT_TRUE(shows(session)) << keeper.server().log().toStdString();
    }
    static bool lives(qint64 process) { return ::kill(static_cast<pid_t>(process), 0) == 0; }

    Session session;
    ServerKeeper keeper{session};
    QSignalSpy deaths{&keeper, &ServerKeeper::died};
};

TEST_F(KeeperTest, AModelIsShownByAServerOfOurOwn) {
    QSignalSpy ready(&keeper, &ServerKeeper::ready);
    start();
    EXPECT_TRUE(keeper.ours());
    EXPECT_EQ(session.serverProcess(), keeper.server().process());
    EXPECT_EQ(session.frame().size(), QSize(64, 48));
    EXPECT_EQ(ready.count(), 1);
    EXPECT_TRUE(comes([&] { return keeper.server().log().contains(QStringLiteral("ready: ")); }));
}

TEST_F(KeeperTest, AModelThatCannotBeReadIsExplained) {
    writeText(folder() / "broken.glb", "no model at all");
    ServerRequest request = this->request();
    request.scene = file("broken.glb");
    keeper.start(request);
    ASSERT_TRUE(comes([&] { return deaths.count() == 1; }));
    const QString text = deaths[0][0].toString();
    EXPECT_TRUE(text.contains(QStringLiteral("broken.glb"))) << text.toStdString();
    EXPECT_FALSE(session.live());
}

TEST_F(KeeperTest, ADeadServerIsExplainedWithinASecondAndRestartedWhereItWas) {
    start();
    ASSERT_TRUE(ask(session, QStringLiteral("camera set 1 2 5 0 0 -1 50")).done);
    ASSERT_TRUE(comes([&] { return session.lastView().eye == QVector3D(1, 2, 5); }));
    const qint64 first = keeper.server().process();
    QElapsedTimer clock;
    clock.start();
    ::kill(static_cast<pid_t>(first), SIGKILL);
    ASSERT_TRUE(comes([&] { return deaths.count() == 1; }));
    EXPECT_LT(clock.elapsed(), 1000);
    EXPECT_FALSE(deaths[0][0].toString().isEmpty());
    ASSERT_TRUE(keeper.canRestart());

    keeper.restart();
    ASSERT_TRUE(comes([&] { return session.live() && session.status().view.eye == QVector3D(1, 2, 5); }));
    EXPECT_NE(keeper.server().process(), first);
    EXPECT_FLOAT_EQ(session.status().view.fieldOfView, 50);
    EXPECT_EQ(deaths.count(), 1);
}

TEST_F(KeeperTest, AServerComesBackWithAViewWithoutPerspective) {
    start();
    ASSERT_TRUE(ask(session, QStringLiteral("camera orthographic 1 2 5 0 0 -1 7.5")).done);
    ASSERT_TRUE(comes([&] { return session.lastView().eye == QVector3D(1, 2, 5); }));
    ::kill(static_cast<pid_t>(keeper.server().process()), SIGKILL);
    ASSERT_TRUE(comes([&] { return deaths.count() == 1; }));
    keeper.restart();
    ASSERT_TRUE(comes([&] { return session.live() && session.status().view.eye == QVector3D(1, 2, 5); }));
    EXPECT_FLOAT_EQ(session.status().view.parallelWidth, 7.5F);
    EXPECT_EQ(session.status().view.fieldOfView, 0);
}

TEST_F(KeeperTest, AnEndThatIsAskedForIsNoDeath) {
    start();
    keeper.stop();
    ASSERT_TRUE(comes([&] { return session.state() == SessionState::Lost && !keeper.server().running(); }));
    EXPECT_EQ(deaths.count(), 0);
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(KeeperTest, AServerOfOthersIsToldOfWhenItDies) {
    startServer();
    keeper.connectTo(name());
    ASSERT_TRUE(shows(session));
    EXPECT_FALSE(keeper.ours());
    server->send(SIGKILL);
    ASSERT_TRUE(comes([&] { return deaths.count() == 1; }));
    EXPECT_FALSE(keeper.canRestart());
}

TEST_F(KeeperTest, ATakenNameGetsANumber) {
    startServer();
    start();
    EXPECT_EQ(session.instance(), name() + QStringLiteral("-2"));
    keeper.close();
}

TEST_F(KeeperTest, TheSecondSceneReplacesTheFirstServer) {
    start();
    const qint64 first = keeper.server().process();
    start();
    EXPECT_NE(keeper.server().process(), first);
    EXPECT_FALSE(lives(first));
    EXPECT_EQ(session.instance(), name());
    EXPECT_EQ(deaths.count(), 0);
}

// A window that closes: its own session and keeper, which end with the block.
struct Window {
    Session session;
    ServerKeeper keeper{session};
};

TEST_F(KeeperTest, ClosingStopsOurServer) {
    qint64 process = 0;
    {
        Window window;
        window.keeper.start(request());
        ASSERT_TRUE(shows(window.session));
        process = window.keeper.server().process();
        window.keeper.close();
    }
    EXPECT_FALSE(lives(process));
    EXPECT_TRUE(instance.segments().empty());
}

TEST_F(KeeperTest, ClosingLeavesAServerThatIsSharedOrKept) {
    for (const bool shared : {true, false}) {
        {
            Window window;
            window.keeper.start(request());
            ASSERT_TRUE(shows(window.session));
            if (shared) {
                session.connectTo(name());
                ASSERT_TRUE(shows(session));
                ASSERT_TRUE(comes([&] { return clientsOf(name()) == 2; }));
            }
            window.keeper.keepServers(!shared);
            window.keeper.close();
        }
        if (!shared) session.connectTo(name());
        ASSERT_TRUE(shows(session));
        const qint64 process = session.serverProcess();
        EXPECT_TRUE(lives(process));
        EXPECT_TRUE(ask(session, QStringLiteral("exit")).done);
        EXPECT_TRUE(comes([&] { return session.state() == SessionState::Lost; }));
        session.leave();
    }
}

// As from the dialog, while it runs.
TEST_F(KeeperTest, WhoseServerItIsCanBeChosenAnew) {
    start();
    QSignalSpy failures(&session, &Session::commandFailed);
    keeper.keepServers(true);
    keeper.keepServers(false);
    EXPECT_TRUE(ask(session, QStringLiteral("ping")).done);
    EXPECT_TRUE(failures.isEmpty());
}

} // namespace
