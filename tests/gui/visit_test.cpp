/// A visit: what people do in the window, one thing after the other, with a real server.
#include "gui/dialog_support.h"
#include "gui/lit_scene.h"
#include "gui/processes_of.h"
#include "gui/window_support.h"

#include "gui/dialogs/recording_dialog.h"
#include "gui/dialogs/statistics_dialog.h"
#include "gui/session/preview_reader.h"
#include "gui/view/recording_mark.h"
#include "support/other_version.h"

#include <QLabel>
#include <QMessageBox>

#include <unistd.h>

namespace {

using namespace test;
using namespace gui;

class VisitTest : public WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        writeLitScene(folder());
        window->preferences().set(pref::progressiveRendering, false);
    }
    QString answer(const char* command) { return ask(window->session(), QLatin1String(command)).text; }
    bool becomes(const char* command, const char* text) {
        return comes([&] { return answer(command).contains(QLatin1String(text)); });
    }
    void press(Qt::Key key) { QTest::keyPress(&window->view(), key); }
    void release(Qt::Key key) { QTest::keyRelease(&window->view(), key); }
    void click(Qt::Key key) { QTest::keyClick(&window->view(), key); }
    QImage rested() {
        EXPECT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
        QTest::qWait(50);
        return window->session().frame().copy(); // without words on it
    }
};

TEST_F(VisitTest, TheStatisticsMoveWithTheWalker) {
    openAndRest();
    action(ActionId::Statistics)->trigger();
    auto* dialog = window->findChild<StatisticsDialog*>();
    ASSERT_NE(dialog, nullptr);
    const auto* eye = field<QLabel>(*dialog, "Eye");
    const auto* state = field<QLabel>(*dialog, "State");
    const auto* frames = field<QLabel>(*dialog, "Displayed");
    ASSERT_TRUE(comes([&] { return state->text() == QStringLiteral("complete"); }));
    ASSERT_TRUE(comes([&] { return frames->text().startsWith(QStringLiteral("0.0")); }));
    const QString before = eye->text();
    press(Qt::Key_W);
    EXPECT_TRUE(comes([&] {
        return eye->text() != before && state->text() == QStringLiteral("drawing") &&
               !frames->text().startsWith(QStringLiteral("0.0"));
    })) << eye->text().toStdString();
    release(Qt::Key_W);
    EXPECT_TRUE(comes([&] { return state->text() == QStringLiteral("complete"); }));
}

TEST_F(VisitTest, CapsLockAndArrowsRotate) {
    openAndRest();
    const View before = status().view;
    press(Qt::Key_CapsLock);
    press(Qt::Key_Left);
    EXPECT_TRUE(comes([&] { return status().view.forward != before.forward; }));
    EXPECT_EQ(status().view.eye, before.eye);
    release(Qt::Key_Left);
    release(Qt::Key_CapsLock);
}

TEST_F(VisitTest, DigitsToggleLights) {
    openAndRest("lit.scn");
    const QImage before = rested();
    click(Qt::Key_1);
    EXPECT_TRUE(becomes("lights", "1 off"));
    EXPECT_NE(rested(), before);
    click(Qt::Key_1);
    EXPECT_TRUE(becomes("lights", "1 on"));
    EXPECT_EQ(rested(), before);
}

TEST_F(VisitTest, MAndADigitChooseTheSky) {
    openAndRest("lit.scn");
    const QImage before = rested();
    press(Qt::Key_M);
    click(Qt::Key_2);
    release(Qt::Key_M);
    EXPECT_TRUE(becomes("environments", "2 active"));
    EXPECT_TRUE(answer("lights").contains(QStringLiteral("1 on"))) << "the digit is no light's then";
    EXPECT_NE(rested(), before);
}

TEST_F(VisitTest, BTogglesBloom) {
    openAndRest();
    const QString before = answer("get bloom");
    click(Qt::Key_B);
    EXPECT_TRUE(comes([&] { return answer("get bloom") != before; }));
    click(Qt::Key_B);
    EXPECT_TRUE(comes([&] { return answer("get bloom") == before; }));
}

TEST_F(VisitTest, RRendersAsItIsAndWithLBetter) {
    openAndRest();
    window->preferences().set(pref::stillAntialiasing, 4);
    const auto rendered = [&] {
        return comes([&] { return window->view().activity() == QStringLiteral("refined"); });
    };
    click(Qt::Key_R);
    ASSERT_TRUE(rendered()) << window->notice().text().toStdString();
    const QImage once = window->view().picture();
    EXPECT_EQ(once, window->session().frame()) << "one sample per pixel, as the live frame";
    press(Qt::Key_R);
    press(Qt::Key_L);
    release(Qt::Key_L);
    release(Qt::Key_R);
    ASSERT_TRUE(comes([&] { return window->view().showsLive(); }));
    ASSERT_TRUE(rendered()) << window->notice().text().toStdString();
    EXPECT_NE(window->view().picture(), once);
}

TEST_F(VisitTest, AServerIsStoppedAndStartedAgain) {
    open();
    const qint64 first = window->session().serverProcess();
    for (const char* answer : {"Cancel", "Stop"}) {
        QTest::keyClick(&window->view(), Qt::Key_K, Qt::ControlModifier);
        auto* question = window->findChild<QMessageBox*>();
        ASSERT_NE(question, nullptr);
        EXPECT_TRUE(window->session().live()) << "it is asked first";
        ASSERT_TRUE(test::press(*question, answer));
        ASSERT_TRUE(comes([&] { return window->findChild<QMessageBox*>() == nullptr; }));
        window->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
    }
    ASSERT_TRUE(comes([&] { return !window->session().live() && !window->keeper().server().running(); }));
    EXPECT_FALSE(window->notice().isVisible()) << "it was asked for";
    EXPECT_TRUE(instance.segments().empty());
    open();
    EXPECT_NE(window->session().serverProcess(), first);
}

TEST_F(VisitTest, AWalkIsRecordedAndPlayed) {
    openAndRest();
    action(ActionId::Recording)->trigger();
    auto* dialog = window->findChild<RecordingDialog*>();
    ASSERT_NE(dialog, nullptr);
    ASSERT_TRUE(test::press(*dialog, "Start"));
    ASSERT_TRUE(comes([&] { return status().recording; }));
    window->activateWindow();
    const QVector3D start = status().view.eye;
    press(Qt::Key_W);
    ASSERT_TRUE(comes([&] { return status().view.eye != start; }));
    QTest::qWait(200);
    release(Qt::Key_W);
    (void)rested();
    const QVector3D end = status().view.eye;
    ASSERT_TRUE(comes([&] { return test::press(*dialog, "Stop"); }));
    ASSERT_TRUE(comes([&] { return !status().recording; }));

    const auto playedBy = [&](const std::function<void()>& player) {
        EXPECT_TRUE(ask(window->session(), QStringLiteral("camera set 0 9 9 0 0 -1")).done);
        EXPECT_TRUE(comes([&] { return status().view.eye == QVector3D(0, 9, 9); }));
        player();
        EXPECT_TRUE(comes([&] { return status().view.eye != QVector3D(0, 9, 9); }));
        const QVector3D seen = status().view.eye; // the first moments may pass unseen
        EXPECT_LT((seen - start).length() + (seen - end).length(), (end - start).length() + 0.05F);
        EXPECT_TRUE(comes([&] { return (status().view.eye - end).length() < 0.01F && status().idle; }));
    };
    playedBy([&] { ASSERT_TRUE(comes([&] { return test::press(*dialog, "Play"); })); });
    playedBy([&] { window->open(file("walk-0001.lst")); });
}

TEST_F(VisitTest, OneKeyRecordsTheWalk) {
    openAndRest();
    auto* mark = window->findChild<RecordingMark*>();
    ASSERT_NE(mark, nullptr);
    EXPECT_FALSE(mark->isVisible());
    press(Qt::Key_W);
    QTest::keyClick(&window->view(), Qt::Key_F3);
    ASSERT_TRUE(comes([&] { return status().recording && mark->isVisible(); }));
    EXPECT_TRUE(action(ActionId::RecordWalk)->isChecked());
    EXPECT_FALSE(action(ActionId::RecordWalk)->autoRepeat()) << "a held key would start and stop it";
    EXPECT_TRUE(mark->time().startsWith(QStringLiteral("0:0"))) << mark->time().toStdString();
    ASSERT_TRUE(comes([&] { return mark->time() != QStringLiteral("0:00"); })) << "it counts";
    QTest::keyClick(&window->view(), Qt::Key_F3);
    release(Qt::Key_W);
    ASSERT_TRUE(comes([&] { return !status().recording && !mark->isVisible(); }));
    EXPECT_FALSE(action(ActionId::RecordWalk)->isChecked());
    EXPECT_TRUE(QFileInfo::exists(file("walk-0001.lst")));
    // The next one is another.
    QTest::keyClick(&window->view(), Qt::Key_F3);
    ASSERT_TRUE(comes([&] { return status().recording; }));
    QTest::keyClick(&window->view(), Qt::Key_F3);
    ASSERT_TRUE(comes([&] { return !status().recording; }));
    EXPECT_TRUE(QFileInfo::exists(file("walk-0002.lst")));
}

TEST_F(VisitTest, AServerOfAnotherVersionIsExplained) {
    const ServerOfAnotherVersion other(instance);
    window->connectToServer();
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    EXPECT_TRUE(window->notice().text().contains(QStringLiteral("version")))
        << window->notice().text().toStdString();
    EXPECT_FALSE(action(ActionId::StopServer)->isEnabled());
}

TEST_F(VisitTest, TwoWindowsAndACommandSeeTheSame) {
    open();
    MainWindow other(name());
    other.show();
    other.connectToServer();
    ASSERT_TRUE(shows(other.session()));
    RunningProgram cui(programPath("CUI"), {"--instance=" + instance.name(), "camera", "set", "1", "2", "5",
                                            "0", "0", "-1", "50"});
    EXPECT_EQ(cui.wait().exitCode, 0);
    for (MainWindow* each : {&*window, &other})
        EXPECT_TRUE(comes([&] { return each->session().status().view.eye == QVector3D(1, 2, 5); }));
    other.session().pressKey('W');
    EXPECT_TRUE(comes([&] { return status().view.eye != QVector3D(1, 2, 5); }));
    window->close();
    window.reset();
    EXPECT_TRUE(ask(other.session(), QStringLiteral("ping")).done) << "the other one is still there";
    EXPECT_TRUE(ask(other.session(), QStringLiteral("exit")).done);
    EXPECT_TRUE(comes([&] { return instance.segments().empty(); }));
    other.close();
}

TEST_F(VisitTest, ClosedWhileItRendersNothingStays) {
    window->preferences().set(pref::stillAntialiasing, 16);
    window->preferences().set(pref::progressiveRendering, true);
    open();
    ASSERT_TRUE(comes([&] { return !childrenOf(::getpid(), QStringLiteral("Renderer")).isEmpty(); }));
    ASSERT_TRUE(comes([&] { return !window->view().showsLive(); }));
    window->close();
    window.reset();
    for (const char* program : {"Renderer", "RTServer", "BSPBuilder"})
        EXPECT_TRUE(childrenOf(::getpid(), QLatin1String(program)).isEmpty()) << program;
    EXPECT_TRUE(instance.segments().empty());
    std::string previews = ipc::Names("preview-" + std::to_string(::getpid())).prefix();
    previews.back() = '-';
    EXPECT_TRUE(ipc::segmentNames(previews).empty()) << ipc::segmentNames(previews).front();
    EXPECT_TRUE(folder().path().empty() ||
                QDir(file(".")).entryList({QStringLiteral("rtsuite-view-*")}, QDir::Dirs).isEmpty());
}

} // namespace
