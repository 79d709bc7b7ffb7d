/// A model is turned in the hand.
#include "gui/view/view_cube.h"
#include "gui/window_support.h"

#include <QSignalSpy>
#include <QToolButton>
#include <QVector3D>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace {

namespace orbit_test {

using namespace test;
using namespace gui;

class OrbitTest : public WindowFixture {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(WindowFixture::SetUp());
        window->preferences().set(pref::progressiveRendering, false);
        writeText(folder() / "block.obj", "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\n"
                                          "v 1 1 1\nv -1 1 1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\n"
                                          "f 3 4 8 7\nf 4 1 5 8\n");
    }
    QVector3D eye() { return status().view.eye; }
    void drag(QPoint from, QPoint by, Qt::KeyboardModifiers modifiers = {},
              Qt::MouseButton button = Qt::LeftButton) {
        FrameView& view = window->view();
        QTest::mousePress(&view, button, modifiers, from);
        for (int i = 1; i <= 4; ++i) {
            const QPoint to = from + by * i / 4;
            QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, button, modifiers);
            QCoreApplication::sendEvent(&view, &move);
        }
        QTest::mouseRelease(&view, button, modifiers, from + by);
    }
    /// Until the server has done all that was sent before, and the window has heard of it.
    void settle() {
        ASSERT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
        QTest::qWait(60);
        ASSERT_TRUE(comes([&] { return status().idle; }));
    }
    void useMouse(MouseScheme scheme) { window->preferences().set(pref::mouse, nameOf(scheme)); }
    QPoint middle() { return window->view().pictureArea().center().toPoint(); }
    bool moves(const QVector3D& before) {
        return comes([&] { return (eye() - before).length() > 0.1F; }) &&
               comes([&] { return status().idle; });
    }
};

TEST_F(OrbitTest, AnObjectOpensInItAndIsTurnedByADrag) {
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    const QVector3D before = eye();
    drag(middle(), {60, 0});
    ASSERT_TRUE(moves(before));
    EXPECT_FALSE(window->view().input().captured());
    EXPECT_NEAR(eye().y(), before.y(), 0.6F);
    // About what was seen there, which is a little more than 1 before the middle.
    EXPECT_NEAR(eye().length(), before.length(), 1.5F);

    const QVector3D turned = eye();
    drag(middle(), {40, 0}, Qt::ShiftModifier);
    ASSERT_TRUE(moves(turned));
    action(ActionId::FitView)->trigger();
    ASSERT_TRUE(comes([&] { return std::abs(eye().length() - before.length()) < 0.5F; })) << eye().length();
    action(ActionId::ViewFront)->trigger();
    ASSERT_TRUE(comes([&] { return std::abs(eye().x()) < 1e-3F && std::abs(eye().y()) < 1e-3F; }));
    EXPECT_GT(eye().z(), 2);
}

TEST_F(OrbitTest, TheCubeShowsTheDirectionAndChoosesIt) {
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    auto* cube = window->view().findChild<ViewCube*>();
    ASSERT_NE(cube, nullptr);
    ASSERT_TRUE(comes([&] { return cube->isVisible() && cube->mode() == Mode::Orbit; }));
    EXPECT_EQ(cube->sideAt({2, 2}), QString()) << "beside it";
    const auto top = cube->middleOf(QStringLiteral("top"));
    ASSERT_TRUE(top) << "an object is seen from a little above";
    EXPECT_EQ(cube->sideAt(*top), QStringLiteral("top"));
    EXPECT_FALSE(cube->middleOf(QStringLiteral("back")));
    QTest::mouseClick(cube, Qt::LeftButton, {}, top->toPoint());
    ASSERT_TRUE(comes([&] { return eye().y() > 2 && std::abs(eye().x()) < 1e-3F; }));
    ASSERT_TRUE(comes([&] { return !cube->middleOf(QStringLiteral("front")); })) << "it turns with the view";

    window->preferences().set(pref::showCube, false);
    EXPECT_FALSE(cube->isVisible());
    window->preferences().set(pref::showCube, true);
    EXPECT_TRUE(cube->isVisible());
}

TEST_F(OrbitTest, ButtonsChangeBetweenOrbitWalkAndFly) {
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    auto* cube = window->view().findChild<ViewCube*>();
    ASSERT_NE(cube, nullptr);
    ASSERT_TRUE(comes([&] { return cube->isVisible() && cube->mode() == Mode::Orbit; }));
    const QList<QToolButton*> buttons = cube->findChildren<QToolButton*>();
    ASSERT_EQ(buttons.size(), 3);
    const QVector3D before = eye();
    buttons[2]->click();
    EXPECT_EQ(cube->mode(), Mode::Fly);
    EXPECT_EQ(window->view().input().hand(), Hand::Looks);
    EXPECT_FALSE(action(ActionId::Orbit)->isChecked());
    EXPECT_EQ(eye(), before) << "the view stays";
    buttons[0]->click();
    EXPECT_EQ(cube->mode(), Mode::Orbit);
    buttons[1]->click();
    ASSERT_TRUE(comes([&] { return status().view.walking || !window->view().told().isEmpty(); }));
    ASSERT_TRUE(comes([&] { return cube->mode() == (status().view.walking ? Mode::Walk : Mode::Orbit); }));
    EXPECT_TRUE(buttons[static_cast<int>(cube->mode())]->isChecked());
}

// Another program's walk may begin where the camera stands: no image tells of it.
TEST_F(OrbitTest, ButtonsShowWhatAnotherProgramBegins) {
    writeText(folder() / "room.obj", "v -3 0 -3\nv 3 0 -3\nv 3 2.6 -3\nv -3 2.6 -3\nv -3 0 3\nv 3 0 3\n"
                                     "v 3 2.6 3\nv -3 2.6 3\nf 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\n"
                                     "f 7 8 4 3\nf 8 5 1 4\n");
    ASSERT_NO_FATAL_FAILURE(openAndRest("room.obj"));
    auto* cube = window->view().findChild<ViewCube*>();
    ASSERT_NE(cube, nullptr);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("walk")).done);
    settle();
    for (const auto& [order, mode] : {std::pair{"fly", Mode::Fly}, {"walk", Mode::Walk}}) {
        ASSERT_TRUE(ask(window->session(), QString::fromLatin1(order)).done);
        EXPECT_TRUE(comes([&, shown = mode] { return cube->mode() == shown; })) << order;
    }
}

TEST_F(OrbitTest, DragsAsBlenderDoesByPreference) {
    useMouse(MouseScheme::Blender);
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    const QVector3D before = eye();
    drag(middle(), {60, 0});
    drag(middle(), {0, -60}, Qt::ControlModifier, Qt::MiddleButton);
    ASSERT_TRUE(moves(before));
    const QVector3D nearer = eye();
    EXPECT_LT(nearer.length(), before.length() - 0.1F);
    EXPECT_GT(QVector3D::dotProduct(nearer.normalized(), before.normalized()), 0.99F)
        << "a drag by the left button turns nothing";
    drag(middle(), {60, 0}, {}, Qt::MiddleButton);
    ASSERT_TRUE(moves(nearer));
    EXPECT_LT(QVector3D::dotProduct(eye().normalized(), nearer.normalized()), 0.99F);
}

TEST_F(OrbitTest, DragsAsF3dDoesByPreference) {
    useMouse(MouseScheme::F3d);
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    const QSignalSpy picked(&window->view().input(), &InputCapture::picked);
    const QVector3D before = eye();
    drag(middle(), {0, -60}, {}, Qt::RightButton);
    ASSERT_TRUE(moves(before));
    EXPECT_LT(eye().length(), before.length() - 0.1F);
    EXPECT_EQ(picked.size(), 0);
    const QVector3D nearer = eye();
    drag(middle(), {2, -1}, {}, Qt::RightButton);
    EXPECT_EQ(picked.size(), 1) << "a click selects, as ever";
    EXPECT_EQ(eye(), nearer);
}

// RT_DRAGS: how many (check-long.sh: 1,000).
TEST_F(OrbitTest, HomeShowsTheModelAfterAnyDrags) {
    const char* const wanted = std::getenv("RT_DRAGS");
    const int count = wanted != nullptr ? std::atoi(wanted) : 40, atOnce = 20;
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    action(ActionId::FitView)->trigger();
    ASSERT_NO_FATAL_FAILURE(settle());
    const QVector3D fitted = eye();
    std::mt19937 random(11);
    const auto number = [&](int from, int to) { return std::uniform_int_distribution(from, to)(random); };
    const QRect area = window->view().pictureArea().toRect();
    float furthest = 0;
    for (int i = 1; i <= count; ++i) {
        useMouse(static_cast<MouseScheme>(number(0, 2)));
        const QPoint from(number(area.left(), area.right()), number(area.top(), area.bottom()));
        const Qt::KeyboardModifiers modifiers[]{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
        const Qt::MouseButton buttons[]{Qt::LeftButton, Qt::MiddleButton};
        drag(from, {number(-400, 400), number(-300, 300)}, modifiers[number(0, 2)], buttons[number(0, 1)]);
        if (i % atOnce != 0) continue;
        ASSERT_NO_FATAL_FAILURE(settle());
        furthest = std::max(furthest, (eye() - fitted).length());
        action(ActionId::FitView)->trigger();
        ASSERT_NO_FATAL_FAILURE(settle());
        EXPECT_NEAR(eye().length(), fitted.length(), 0.35F * fitted.length()) << i;
        const QVector3D ahead = status().view.forward.normalized();
        EXPECT_GT(QVector3D::dotProduct(ahead, -eye().normalized()), 0.95F) << i;
    }
    EXPECT_GT(furthest, 1) << "the drags moved it";
}

TEST_F(OrbitTest, CanBeLeftAndKeepsTheView) {
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    const QVector3D before = eye();
    action(ActionId::Orbit)->trigger();
    EXPECT_EQ(window->view().input().hand(), Hand::Looks);
    QTest::mouseClick(&window->view(), Qt::LeftButton, {}, {50, 50});
    EXPECT_TRUE(window->view().input().captured());
    EXPECT_EQ(eye(), before);
    action(ActionId::Orbit)->trigger();
    EXPECT_FALSE(window->view().input().captured()) << "the mouse is given back";
}

} // namespace orbit_test

} // namespace
