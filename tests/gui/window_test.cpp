/// The whole window with a real server.
#include "gui/window_support.h"

#include "gui/dialogs/recording_dialog.h"
#include "gui/view/input_capture.h"

#include <QClipboard>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>

#include <csignal>
#include <filesystem>

namespace {

using namespace test;
using namespace gui;

class WindowTest : public WindowFixture {};

TEST_F(WindowTest, AModelStartsAServerAndIsShown) {
    EXPECT_FALSE(action(ActionId::StopServer)->isEnabled());
    const QImage empty = grabbed();
    open();
    EXPECT_TRUE(comes([&] { return window->session().status().idle; }));
    EXPECT_NE(grabbed(), empty);
    EXPECT_TRUE(window->windowTitle().contains(QStringLiteral("room.obj")));
    EXPECT_TRUE(action(ActionId::StopServer)->isEnabled());
    EXPECT_EQ(window->preferences().recentFiles(), QStringList{file("room.obj")});
}

TEST_F(WindowTest, ADroppedModelIsShown) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file("room.obj"))});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&*window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&*window, &drop);
    EXPECT_TRUE(shows(window->session()));
}

TEST_F(WindowTest, KeysWalkAndThePictureChanges) {
    open();
    ASSERT_TRUE(comes([&] { return window->session().status().idle; }));
    const QImage before = grabbed();
    const View view = window->session().status().view;
    QTest::keyPress(&window->view(), Qt::Key_W);
    EXPECT_TRUE(comes([&] { return window->session().status().view != view; }));
    QTest::keyRelease(&window->view(), Qt::Key_W);
    ASSERT_TRUE(comes([&] { return window->session().status().idle; }));
    EXPECT_NE(grabbed(), before);
}

TEST_F(WindowTest, TheMouseTurnsTheCamera) {
    open();
    const View view = window->session().status().view;
    emit window->view().input().turned(20, 0);
    EXPECT_TRUE(comes([&] { return window->session().status().view.forward != view.forward; }));
}

TEST_F(WindowTest, TheServerDrawsAsManyPixelsAsTheWindowHas) {
    window->preferences().set(pref::pictureScale, 50);
    open();
    const QSize wanted = window->view().devicePixels() * 50 / 100;
    EXPECT_TRUE(comes([&] { return window->session().status().resolution == wanted; }));
    QSignalSpy asked(&window->view(), &FrameView::resolutionWanted);
    for (int i = 0; i < 10; ++i) {
        window->resize(420 + i, 360);
        QTest::qWait(5);
    }
    const QSize larger = window->view().devicePixels() * 50 / 100;
    EXPECT_TRUE(comes([&] { return window->session().status().resolution == larger; }));
    EXPECT_EQ(asked.count(), 1) << "once the user has come to rest";
}

TEST_F(WindowTest, AKilledServerIsExplainedAndRestartedByAButton) {
    open();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 2 5 0 0 -1 50")).done);
    ASSERT_TRUE(comes([&] { return window->session().lastView().eye == QVector3D(1, 2, 5); }));
    const auto explained = [&] {
        return window->notice().isVisible() && window->notice().text().contains(QStringLiteral("server"));
    };
    EXPECT_FALSE(explained());
    QElapsedTimer clock;
    clock.start();
    ::kill(static_cast<pid_t>(window->session().serverProcess()), SIGKILL);
    ASSERT_TRUE(comes(explained));
    EXPECT_LT(clock.elapsed(), 1000);
    EXPECT_TRUE(comes([&] { return !window->session().live(); }));
    QPushButton* restart = window->notice().findChild<QPushButton*>();
    ASSERT_NE(restart, nullptr);
    restart->click();
    EXPECT_TRUE(shows(window->session()));
    EXPECT_FALSE(explained());
    EXPECT_TRUE(comes([&] { return status().view.eye == QVector3D(1, 2, 5); })) << "where it was";
    EXPECT_EQ(ask(window->session(), QStringLiteral("scene")).text, file("room.obj"));
}

TEST_F(WindowTest, AFileThatIsNotThereIsExplained) {
    window->open(file("nothing.obj"));
    EXPECT_TRUE(window->notice().isVisible());
    EXPECT_TRUE(window->notice().text().contains(QStringLiteral("nothing.obj")));
}

TEST_F(WindowTest, PauseIsShownWhoeverPaused) {
    open();
    action(ActionId::PauseServer)->trigger();
    EXPECT_TRUE(comes([&] { return window->session().status().paused; }));
    window->session().send(command::resume());
    EXPECT_TRUE(comes([&] { return !action(ActionId::PauseServer)->isChecked(); }));
}

TEST_F(WindowTest, TheKeyEExportsTheCameraAndF12ThePicture) {
    open();
    QTest::keyClick(&window->view(), Qt::Key_E);
    EXPECT_TRUE(comes([&] { return QFile::exists(file("camera-0001.cam")); }));
    QTest::keyClick(&window->view(), Qt::Key_H);
    EXPECT_TRUE(comes([&] { return QFile::exists(file("camera-0002.cam")); }));
    EXPECT_NE(readBytes(file("camera-0002.cam").toStdString()).find("1920"), std::string::npos);
    QTest::keyClick(&*window, Qt::Key_F12);
    EXPECT_TRUE(comes([&] { return QFile::exists(file("screenshot-0001.png")); }));
}

TEST_F(WindowTest, TheCameraTravelsByTheClipboard) {
    open();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 2 5 0 0 -1 50")).done);
    QGuiApplication::clipboard()->clear();
    action(ActionId::CopyCamera)->trigger();
    ASSERT_TRUE(comes([] { return !QGuiApplication::clipboard()->text().isEmpty(); }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 0 1 4 0 0 -1 60")).done);
    action(ActionId::PasteCamera)->trigger();
    EXPECT_TRUE(comes([&] { return window->session().status().view.eye == QVector3D(1, 2, 5); }));
}

TEST_F(WindowTest, QuickRenderShowsABetterPictureUntilSomethingMoves) {
    open();
    ASSERT_TRUE(comes([&] { return window->session().status().idle; }));
    action(ActionId::QuickRender)->trigger();
    ASSERT_TRUE(comes([&] { return !window->view().showsLive(); })) << window->notice().text().toStdString();
    EXPECT_EQ(window->view().picture().size(), window->session().status().resolution);
    QTest::keyPress(&window->view(), Qt::Key_W);
    EXPECT_TRUE(window->view().showsLive());
    QTest::keyRelease(&window->view(), Qt::Key_W);
}

TEST_F(WindowTest, BindingsOfTheUserAreTheServers) {
    window->preferences().set(pref::bindings, QStringLiteral("Z forward\n"));
    open();
    const View view = window->session().status().view;
    QTest::keyPress(&window->view(), Qt::Key_Z);
    EXPECT_TRUE(comes([&] { return window->session().status().view != view; }));
    QTest::keyRelease(&window->view(), Qt::Key_Z);
}

TEST_F(WindowTest, CloseStopsTheServer) {
    open();
    const auto process = static_cast<pid_t>(window->session().serverProcess());
    window->close();
    window.reset();
    EXPECT_NE(::kill(process, 0), 0);
    EXPECT_TRUE(instance.segments().empty());
    window.emplace(name());
}

TEST_F(WindowTest, FullScreenIsThePictureAlone) {
    for (const ActionId panel : {ActionId::SettingsPanel, ActionId::Jobs}) action(panel)->trigger();
    const auto panels = [&] {
        QStringList seen;
        for (const QDockWidget* each : window->findChildren<QDockWidget*>()) {
            if (!each->isHidden()) seen.append(each->objectName());
        }
        seen.sort();
        return seen;
    };
    const QStringList before = panels();
    ASSERT_EQ(before.size(), 2);
    action(ActionId::FullScreen)->trigger();
    ASSERT_TRUE(comes([&] { return window->isFullScreen(); }));
    EXPECT_TRUE(panels().isEmpty());
    EXPECT_TRUE(window->menuBar()->isHidden());
    EXPECT_TRUE(action(ActionId::FullScreen)->isChecked());
    QTest::keyClick(&*window, Qt::Key_F11);
    ASSERT_TRUE(comes([&] { return !window->isFullScreen(); }));
    EXPECT_EQ(panels(), before);
    EXPECT_FALSE(window->menuBar()->isHidden());
    // Closed in full screen, the next window has all of it.
    action(ActionId::FullScreen)->trigger();
    window->close();
    window.emplace(name());
    window->show();
    EXPECT_FALSE(window->isFullScreen());
    EXPECT_EQ(panels(), before);
}

TEST_F(WindowTest, EveryWindowIsTitledByTheScene) {
    open();
    MainWindow other(name());
    other.show();
    other.connectToServer();
    ASSERT_TRUE(shows(other.session()));
    EXPECT_TRUE(comes([&] { return other.windowTitle().contains(QStringLiteral("room.obj")); }))
        << other.windowTitle().toStdString();
    std::filesystem::copy(folder() / "room.obj", folder() / "hall.obj");
    window->open(file("hall.obj"));
    EXPECT_TRUE(comes([&] { return other.windowTitle().contains(QStringLiteral("hall.obj")); }))
        << other.windowTitle().toStdString();
    other.close();
}

TEST_F(WindowTest, ASceneThatCannotBeLoadedIsNotLoadingAnyMore) {
    open();
    writeText(folder() / "broken.obj", "nothing of a model\n");
    window->open(file("broken.obj"));
    EXPECT_TRUE(window->view().told().contains(QStringLiteral("broken.obj")));
    ASSERT_TRUE(comes([&] { return window->notice().text().contains(QStringLiteral("broken.obj")); }));
    EXPECT_EQ(window->view().told(), QString());
}

TEST_F(WindowTest, TheRecordingDialogLeavesWithItsScene) {
    std::filesystem::copy_file(folder() / "room.obj", folder() / "other.obj");
    open();
    ASSERT_TRUE(comes([&] { return !window->editor().scene().isEmpty(); }));
    action(ActionId::Recording)->trigger();
    const auto dialog = [&] { return window->findChild<RecordingDialog*>(); };
    ASSERT_NE(dialog(), nullptr);
    window->editor().refresh();
    QTest::qWait(300);
    EXPECT_NE(dialog(), nullptr) << "of this scene";
    window->open(file("other.obj"));
    EXPECT_TRUE(comes([&] { return dialog() == nullptr; }));
    action(ActionId::Recording)->trigger();
    EXPECT_NE(dialog(), nullptr);
}

TEST_F(WindowTest, AFirstWindowAndADamagedOneFitIntoTheScreen) {
    const QRect room = window->screen()->availableGeometry();
    const QByteArray good = window->saveGeometry();
    window->preferences().set(pref::geometry, QByteArray());
    const auto fits = [&] {
        MainWindow other(name());
        EXPECT_LE(other.width(), room.width());
        EXPECT_LE(other.height(), room.height());
        EXPECT_TRUE(!other.testAttribute(Qt::WA_Moved) || room.contains(other.geometry()));
        return !testing::Test::HasFailure();
    };
    EXPECT_TRUE(fits());
    // Each byte of it spoilt.
    for (qsizetype at = 0; at < good.size(); ++at) {
        QByteArray spoilt = good;
        spoilt[at] = '\x7f';
        window->preferences().set(pref::geometry, spoilt);
        ASSERT_TRUE(fits()) << "byte " << at;
    }
}

TEST_F(WindowTest, TheWheelChangesTheSpeed) {
    open();
    QSignalSpy failures(&window->session(), &Session::commandFailed);
    emit window->view().input().wheelTurned(2);
    EXPECT_TRUE(ask(window->session(), QStringLiteral("ping")).done);
    EXPECT_TRUE(failures.isEmpty());
}

} // namespace
