/// A model is turned in the hand.
#include "gui/view/view_cube.h"
#include "gui/window_support.h"

#include <QToolButton>
#include <QVector3D>

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
    void drag(QPoint from, QPoint by, Qt::KeyboardModifiers modifiers = {}) {
        FrameView& view = window->view();
        QTest::mousePress(&view, Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 4; ++i) {
            const QPoint to = from + by * i / 4;
            QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                             modifiers);
            QCoreApplication::sendEvent(&view, &move);
        }
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, from + by);
    }
    bool moves(const QVector3D& before) {
        return comes([&] { return (eye() - before).length() > 0.1F; }) &&
               comes([&] { return status().idle; });
    }
};

TEST_F(OrbitTest, AnObjectOpensInItAndIsTurnedByADrag) {
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    const QVector3D before = eye();
    const QPoint middle = window->view().pictureArea().center().toPoint();
    drag(middle, {60, 0});
    ASSERT_TRUE(moves(before));
    EXPECT_FALSE(window->view().input().captured());
    EXPECT_NEAR(eye().y(), before.y(), 0.6F);
    // About what was seen there, which is a little more than 1 before the middle.
    EXPECT_NEAR(eye().length(), before.length(), 1.5F);

    const QVector3D turned = eye();
    drag(middle, {40, 0}, Qt::ShiftModifier);
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
