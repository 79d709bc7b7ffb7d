/// Keys and mouse of the image, without a server.
#include "gui/gui_support.h"

#include "gui/view/input_capture.h"

#include "rtcore/motion/key_codes.h"

#include <gtest/gtest.h>

#include <QMainWindow>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTest>

namespace {

using namespace gui;

class InputTest : public testing::Test {
  protected:
    void SetUp() override {
        view->setFocusPolicy(Qt::StrongFocus);
        window.setCentralWidget(view);
        QAction* start =
            window.menuBar()->addMenu(QStringLiteral("Menu"))->addAction(QStringLiteral("Start"));
        start->setShortcuts({QKeySequence(QStringLiteral("Ctrl+S")), QKeySequence(QStringLiteral("Ctrl+B")),
                             QKeySequence(QStringLiteral("Alt+1")), QKeySequence(QStringLiteral("Ctrl+Home")),
                             QKeySequence(QStringLiteral("Ctrl+Shift+C")),
                             QKeySequence(QStringLiteral("Ctrl+Shift+R"))});
        QObject::connect(start, &QAction::triggered, &window, [this] { ++shortcuts; });
        window.resize(400, 300);
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
        view->setFocus();
    }
    QList<int> codes(const QSignalSpy& spy) const {
        QList<int> all;
        for (const QList<QVariant>& each : spy) all.append(each.front().toInt());
        return all;
    }

    // Without those of the modifiers.
    QList<int> keys() const {
        QList<int> all = codes(pressed);
        all.removeIf([](int code) {
            return code == rtcore::KeyShift || code == rtcore::KeyControl || code == rtcore::KeyAlt;
        });
        return all;
    }

    QMainWindow window;
    QWidget* view = new QWidget;
    InputCapture input{view};
    QSignalSpy pressed{&input, &InputCapture::keyPressed}, released{&input, &InputCapture::keyReleased},
        allReleased{&input, &InputCapture::allKeysReleased}, turned{&input, &InputCapture::turned},
        commands{&input, &InputCapture::commandKey};
    int shortcuts = 0;
};

class OrbitInputTest : public InputTest {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(InputTest::SetUp());
        input.setHand(Hand::Turns);
    }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
        QTest::mousePress(view, button, modifiers, {100, 100});
        for (const QPoint to : {QPoint{110, 100}, QPoint{110, 95}}) {
            QMouseEvent move(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, button, modifiers);
            QCoreApplication::sendEvent(view, &move);
        }
        QTest::mouseRelease(view, button, modifiers, {110, 95});
    }
    QPointF sumOf(const QSignalSpy& spy) const {
        QPointF sum;
        for (const QList<QVariant>& each : spy) sum += each.front().toPointF();
        return sum;
    }
    QSignalSpy grasped{&input, &InputCapture::grasped}, dragged{&input, &InputCapture::dragged},
        pushed{&input, &InputCapture::pushed}, reached{&input, &InputCapture::reached},
        centred{&input, &InputCapture::centred}, wheel{&input, &InputCapture::wheelTurned};
};

TEST_F(OrbitInputTest, ADragTurnsTheModelAndCapturesNothing) {
    drag(Qt::LeftButton, Qt::NoModifier);
    ASSERT_EQ(grasped.count(), 1);
    EXPECT_EQ(grasped.front().front().toPointF(), QPointF(100, 100));
    EXPECT_EQ(sumOf(dragged), QPointF(10, -5));
    EXPECT_EQ(pushed.count(), 0);
    EXPECT_FALSE(input.captured());
    EXPECT_EQ(turned.count(), 0);
    QTest::mouseMove(view, {200, 200});
    EXPECT_EQ(sumOf(dragged), QPointF(10, -5)) << "it has ended";
}

TEST_F(OrbitInputTest, ShiftAndTheMiddleButtonMoveIt) {
    drag(Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_EQ(sumOf(pushed), QPointF(10, -5));
    drag(Qt::MiddleButton, Qt::NoModifier);
    EXPECT_EQ(sumOf(pushed), QPointF(20, -10));
    EXPECT_EQ(dragged.count(), 0);
}

TEST_F(OrbitInputTest, TheWheelGoesThereAndADoubleClickCentres) {
    QWheelEvent turn(QPointF(50, 60), view->mapToGlobal(QPointF(50, 60)), {}, {0, 240}, Qt::NoButton,
                     Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view, &turn);
    ASSERT_EQ(reached.count(), 1);
    EXPECT_EQ(reached.front().front().toPointF(), QPointF(50, 60));
    EXPECT_EQ(reached.front().back().toDouble(), 2);
    EXPECT_EQ(wheel.count(), 0);
    test::doubleClick(view, {}, {30, 40});
    ASSERT_EQ(centred.count(), 1);
    EXPECT_EQ(centred.front().front().toPointF(), QPointF(30, 40));
    EXPECT_FALSE(input.captured());
}

TEST_F(OrbitInputTest, KeysStayTheCamerasButThoseThatChooseViews) {
    QAction views(&window);
    views.setShortcuts({QKeySequence(QStringLiteral("Home")), QKeySequence(QStringLiteral("Num+1"))});
    window.addAction(&views);
    QSignalSpy chosen(&views, &QAction::triggered);
    QTest::keyClick(view, Qt::Key_1);
    QTest::keyClick(view, Qt::Key_W);
    EXPECT_EQ(keys(), (QList<int>{'1', 'W'}));
    EXPECT_EQ(chosen.count(), 0);
    QTest::keyClick(view, Qt::Key_1, Qt::KeypadModifier);
    QTest::keyClick(view, Qt::Key_Home);
    EXPECT_EQ(chosen.count(), 2);
    input.setHand(Hand::Looks);
    QTest::keyClick(view, Qt::Key_1, Qt::KeypadModifier);
    EXPECT_EQ(keys(), (QList<int>{'1', 'W', '1'})) << "a light, as the thesis has it";
}

TEST_F(InputTest, KeysOfTheFocusedPictureAreTheCameras) {
    QTest::keyPress(view, Qt::Key_W);
    QTest::keyPress(view, Qt::Key_Left);
    QTest::keyRelease(view, Qt::Key_W);
    EXPECT_EQ(codes(pressed), (QList<int>{'W', rtcore::KeyLeft}));
    EXPECT_EQ(codes(released), QList<int>{'W'});
}

TEST_F(InputTest, ShortcutsWorkUntilTheKeysAreCaptured) {
    QTest::keyClick(view, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(shortcuts, 1);
    EXPECT_TRUE(pressed.isEmpty());

    QTest::mouseClick(view, Qt::LeftButton);
    ASSERT_TRUE(input.captured());
    QTest::keyPress(view, Qt::Key_Control);
    QTest::keyPress(view, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(shortcuts, 1) << "crawling backwards starts no server";
    EXPECT_EQ(codes(pressed), (QList<int>{rtcore::KeyControl, 'S'}));

    QTest::keyClick(view, Qt::Key_Escape);
    EXPECT_FALSE(input.captured());
    EXPECT_GE(allReleased.count(), 1);
    QTest::keyClick(view, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(shortcuts, 2);
}

// Only what keys that move make together is the camera's.
TEST_F(InputTest, OtherCombinationsStayShortcutsWhileCaptured) {
    input.capture();
    QTest::keyClick(view, Qt::Key_1, Qt::AltModifier);
    QTest::keyClick(view, Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(view, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClick(view, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::keyClick(view, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(shortcuts, 5);
    EXPECT_TRUE(keys().isEmpty()) << "neither a light nor the bloom is switched";
    EXPECT_TRUE(commands.isEmpty());
    EXPECT_TRUE(input.captured());
    for (const Qt::Key key : {Qt::Key_1, Qt::Key_B, Qt::Key_C}) QTest::keyClick(view, key);
    QTest::keyClick(view, Qt::Key_W, Qt::ShiftModifier);
    QTest::keyClick(view, Qt::Key_X, Qt::ControlModifier); // nobody's shortcut
    EXPECT_EQ(keys(), (QList<int>{'1', 'B', 'C', 'W', 'X'}));
    EXPECT_EQ(shortcuts, 5);
}

TEST_F(InputTest, WhatIsTheCamerasFollowsFromTheBindings) {
    input.setBindings({{QStringLiteral("B"), QStringLiteral("forward"), 0},
                       {QStringLiteral("Control"), QStringLiteral("crawl"), 0},
                       {QStringLiteral("S"), QStringLiteral("toggleBloom"), 0},
                       {QStringLiteral("Alt+1"), QStringLiteral("toggleLight"), 1}});
    input.capture();
    QTest::keyClick(view, Qt::Key_B, Qt::ControlModifier);
    QTest::keyClick(view, Qt::Key_1, Qt::AltModifier);
    EXPECT_EQ(shortcuts, 0);
    EXPECT_EQ(keys(), (QList<int>{'B', '1'}));
    QTest::keyClick(view, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(shortcuts, 1);
}

// Whoever holds W and adds Control and S means to crawl.
TEST_F(InputTest, ControlCrawlsWhileAKeyThatMovesIsDown) {
    QTest::keyPress(view, Qt::Key_Control);
    EXPECT_TRUE(pressed.isEmpty()) << "it begins a shortcut";
    QTest::keyRelease(view, Qt::Key_Control);
    QTest::keyPress(view, Qt::Key_W);
    QTest::keyPress(view, Qt::Key_Control);
    QTest::keyPress(view, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(codes(pressed), (QList<int>{'W', rtcore::KeyControl, 'S'}));
    EXPECT_EQ(shortcuts, 0);
    QTest::keyRelease(view, Qt::Key_S, Qt::ControlModifier);
    QTest::keyRelease(view, Qt::Key_Control);
    QTest::keyRelease(view, Qt::Key_W);
    EXPECT_EQ(released.count(), 3);
    QTest::keyClick(view, Qt::Key_S, Qt::ControlModifier);
    EXPECT_EQ(shortcuts, 1);
}

TEST_F(InputTest, EnterCapturesToo) {
    QTest::keyClick(view, Qt::Key_Return);
    EXPECT_TRUE(input.captured());
    QTest::keyClick(view, Qt::Key_Return);
    EXPECT_EQ(codes(pressed), QList<int>{rtcore::KeyReturn});
}

TEST_F(InputTest, RepeatsAreNoPresses) {
    QKeyEvent press(QEvent::KeyPress, Qt::Key_F, Qt::NoModifier, QStringLiteral("f"));
    QKeyEvent repeat(QEvent::KeyPress, Qt::Key_F, Qt::NoModifier, QStringLiteral("f"), true);
    QKeyEvent repeatedRelease(QEvent::KeyRelease, Qt::Key_F, Qt::NoModifier, QStringLiteral("f"), true);
    for (QKeyEvent* event : {&press, &repeatedRelease, &repeat, &repeatedRelease, &repeat})
        QCoreApplication::sendEvent(view, event);
    EXPECT_EQ(pressed.count(), 1);
    EXPECT_EQ(released.count(), 0);
}

// With Shift the same key has another name in Qt.
TEST_F(InputTest, AKeyIsReleasedAsWhatItWasPressed) {
    const auto key = [&](QEvent::Type type, int qtKey, Qt::KeyboardModifiers modifiers) {
        QKeyEvent event(type, qtKey, modifiers, 10U + 100U, 0, 0);
        QCoreApplication::sendEvent(view, &event);
    };
    key(QEvent::KeyPress, Qt::Key_3, Qt::NoModifier);
    key(QEvent::KeyRelease, Qt::Key_NumberSign, Qt::ShiftModifier);
    EXPECT_EQ(codes(pressed), QList<int>{'3'});
    EXPECT_EQ(codes(released), QList<int>{'3'});
}

TEST_F(InputTest, CapsLockHeldTurnsArrowsIntoRotation) {
    QTest::keyPress(view, Qt::Key_CapsLock);
    QTest::keyPress(view, Qt::Key_Left);
    EXPECT_EQ(codes(pressed), (QList<int>{rtcore::KeyCapsLock, rtcore::KeyLeft}));
}

TEST_F(InputTest, KeysAreReleasedWhenTheFocusGoes) {
    auto* other = new QPlainTextEdit(&window);
    other->show();
    QTest::keyPress(view, Qt::Key_W);
    QTest::mouseClick(view, Qt::LeftButton);
    other->setFocus();
    EXPECT_FALSE(input.captured());
    EXPECT_EQ(allReleased.count(), 1);
    QTest::keyRelease(view, Qt::Key_W);
    EXPECT_EQ(released.count(), 0);
}

TEST_F(InputTest, RAloneAndRWithLAreTwoCommands) {
    QTest::keyClick(view, Qt::Key_R);
    QTest::keyPress(view, Qt::Key_R);
    QTest::keyPress(view, Qt::Key_L);
    QTest::keyRelease(view, Qt::Key_L);
    QTest::keyRelease(view, Qt::Key_R);
    QTest::keyPress(view, Qt::Key_L);
    QTest::keyClick(view, Qt::Key_R);
    QTest::keyRelease(view, Qt::Key_L);
    QTest::keyClick(view, Qt::Key_E);
    ASSERT_EQ(commands.count(), 4);
    EXPECT_EQ(commands[0], (QList<QVariant>{int('R'), false}));
    EXPECT_EQ(commands[1], (QList<QVariant>{int('R'), true}));
    EXPECT_EQ(commands[2], (QList<QVariant>{int('R'), true}));
    EXPECT_EQ(commands[3], (QList<QVariant>{int('E'), false}));
    EXPECT_TRUE(pressed.isEmpty()) << "the server does not know of them";
}

TEST_F(InputTest, TheMouseTurnsWhileCaptured) {
    input.setMouseSensitivity(0.5, false);
    QTest::mouseMove(view, QPoint(100, 100));
    EXPECT_TRUE(turned.isEmpty());
    QTest::mouseClick(view, Qt::LeftButton);
    const QPoint from = view->mapFromGlobal(QCursor::pos());
    QMouseEvent move(QEvent::MouseMove, from + QPoint(20, 10), view->mapToGlobal(from + QPoint(20, 10)),
                     Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view, &move);
    ASSERT_EQ(turned.count(), 1);
    EXPECT_DOUBLE_EQ(turned[0][0].toDouble(), 10);
    EXPECT_DOUBLE_EQ(turned[0][1].toDouble(), -5);
}

} // namespace
