/// Handles of sections in the image: where they are, and planes that are dragged by them, with a real server.
#include "gui/window_support.h"

#include "gui/models/section_marks.h"
#include "gui/models/section_turn.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/sections_panel.h"
#include "gui/view/section_handles.h"

#include <QListWidget>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace gui {
namespace {

using rtcore::Vec3;
using rtcore::Vec3d;
using test::comes;

const rtcore::Box3 kHouse{{-2, 0, -4}, {2, 3, 4}};

TEST(SectionMarkTest, IsOutlinedInTheBoxAsOthersLeaveIt) {
    rtcore::SectionPlanes sections;
    sections.planes = {{{9, 1, 9}, {0, 5, 0}}, {{1, 0, 0}, {1, 0, 0}}};
    const SectionMark storey = markOf(sections, 0, kHouse);
    ASSERT_EQ(storey.outline.size(), 4U);
    EXPECT_LT(length(centroidOf(storey.outline) - Vec3d{-0.5, 1, 0}), 1e-3);
    EXPECT_EQ(storey.normal, (Vec3d{0, 1, 0}));
    EXPECT_EQ(storey.middle, (Vec3d{0, 1, 0}));
    EXPECT_NEAR(storey.back, -1, 1e-12);
    EXPECT_NEAR(storey.on, 2, 1e-12);
    sections.planes[1].point.x = -3; // takes all away
    EXPECT_LT(length(centroidOf(markOf(sections, 0, kHouse).outline) - Vec3d{0, 1, 0}), 1e-3);
}

TEST(SectionMarkTest, OfABoxHasSixFaces) {
    rtcore::SectionPlanes sections;
    sections.planes = rtcore::planesAround({-1, 1, -1}, {1, 2, 1});
    for (std::size_t i = 0; i < 6; ++i) {
        const SectionMark face = markOf(sections, i, kHouse);
        ASSERT_GE(face.outline.size(), 4U);
        const Vec3d middle = Vec3d{0, 1.5, 0} + face.normal * (face.normal.y != 0 ? 0.5 : 1.0);
        EXPECT_LT(length(centroidOf(face.outline) - middle), 1e-3) << i;
    }
}

TEST(SectionMarkTest, OfAPlaneThatMissesTheBoxCanComeBack) {
    rtcore::SectionPlanes sections;
    sections.planes = {{{0, 5, 0}, {0, 1, 0}}};
    const SectionMark above = markOf(sections, 0, kHouse);
    EXPECT_TRUE(above.outline.empty());
    EXPECT_NEAR(above.back, -5, 1e-12);
    EXPECT_EQ(above.on, 0);
    EXPECT_EQ(above.middle, (Vec3d{0, 5, 0}));
    sections.planes[0].point.y = 3;
    EXPECT_EQ(markOf(sections, 0, kHouse).outline.size(), 4U) << "along the top of the box";
}

TEST(SectionMarkTest, IsHeldWhereItIsSeen) {
    rtcore::SectionPlanes sections;
    sections.planes = {{{0, 1, 0}, {0, 1, 0}}};
    const SectionMark mark = markOf(sections, 0, kHouse);
    View view;
    view.eye = {0, 2, 0};
    view.forward = {0, -0.3F, -1};
    view.fieldOfView = 60;
    const SceneImage in(view, 0, QRectF(0, 0, 300, 200), 1.5);
    const auto hold = holdOf(mark, in);
    ASSERT_TRUE(hold);
    EXPECT_NEAR(hold->y, 1, 1e-9);
    EXPECT_LT(hold->z, 0) << "the middle of the box is below the eye";
    const auto at = in.at(*hold);
    ASSERT_TRUE(at);
    EXPECT_TRUE(QRectF(10, 10, 280, 180).contains(*at));
    view.forward = {0, 1, -0.1F};
    EXPECT_FALSE(holdOf(mark, SceneImage(view, 0, QRectF(0, 0, 300, 200), 1.5)));
}

constexpr double kDegree = std::numbers::pi / 180;

TEST(SectionTurnTest, IsAboutALevelAxisAndOneAcrossIt) {
    const TurnAxes wall = turnAxesOf({0, 0, 1}, {0, 1, 0});
    EXPECT_LT(length(wall[0] - Vec3d{1, 0, 0}), 1e-12);
    EXPECT_LT(length(wall[1] - Vec3d{0, 1, 0}), 1e-12);
    const TurnAxes storey = turnAxesOf({0, 0, -1}, {0, 0, 1});
    for (const Vec3d& axis : storey) EXPECT_NEAR(axis.z, 0, 1e-12);
    EXPECT_NEAR(dot(storey[0], storey[1]), 0, 1e-12);
    const Vec3d slanted = normalize(Vec3d{1, 2, 2});
    const TurnAxes roof = turnAxesOf(slanted, {0, 0, 1});
    EXPECT_NEAR(roof[0].z, 0, 1e-12);
    for (const Vec3d& axis : roof) {
        EXPECT_NEAR(dot(axis, slanted), 0, 1e-12);
        EXPECT_NEAR(length(axis), 1, 1e-12);
    }
}

TEST(SectionTurnTest, GoesTheRightWayRound) {
    EXPECT_LT(length(turned({1, 0, 0}, {0, 0, 1}, 90 * kDegree) - Vec3d{0, 1, 0}), 1e-12);
    EXPECT_LT(length(turned({0, 0, 2}, {0, 0, 1}, 1) - Vec3d{0, 0, 2}), 1e-12);
}

TEST(SectionTurnTest, StepsAreCountedFromTheAxesOfTheScene) {
    EXPECT_NEAR(inTurnSteps({0, 1, 0}, {0, 0, 1}, 37 * kDegree), 30 * kDegree, 1e-12);
    EXPECT_NEAR(inTurnSteps({0, 1, 0}, {0, 0, 1}, -38 * kDegree), -45 * kDegree, 1e-12);
    const Vec3d leaning = turned({0, 1, 0}, {0, 0, 1}, 7 * kDegree);
    EXPECT_NEAR(inTurnSteps(leaning, {0, 0, 1}, 1 * kDegree), 8 * kDegree, 1e-12) << "to 15 degrees";
    EXPECT_NEAR(inTurnSteps(leaning, {0, 0, 1}, 0), -7 * kDegree, 1e-12);
}

TEST(SectionTurnTest, OfABoxIsNone) {
    rtcore::SectionPlanes sections;
    sections.planes = rtcore::planesAround({-1, 1, -1}, {1, 2, 1});
    EXPECT_TRUE(isBox(sections));
    sections.planes[2].normal = {0, 0.9F, 0.1F};
    EXPECT_FALSE(isBox(sections));
    sections.planes.resize(5);
    EXPECT_FALSE(isBox(sections));
}

/// Along -z, 1 unit across 100 pixels, with perspective or without; the middle is (0, 0, 0) at (200, 150).
SceneImage alongZ(bool parallel) {
    View view;
    view.eye = {0, 0, 10};
    view.forward = {0, 0, -1};
    view.fieldOfView = parallel ? 0 : static_cast<float>(2 * std::atan(0.2) / kDegree);
    return {view, parallel ? 4.0 : 0.0, QRectF(0, 0, 400, 300), 4.0 / 3};
}

TEST(SectionTurnTest, GoesWithTheHandAroundTheAxis) {
    for (const bool parallel : {true, false}) {
        const SceneImage image = alongZ(parallel);
        const TurnCircle circle{{0, 0, 0}, {0, 0, 1}, 1, {1, 0, 0}};
        EXPECT_NEAR(turnLed(image, circle, {300, 150}, {200, 50}, 0), 90 * kDegree, 1e-4);
        EXPECT_NEAR(turnLed(image, circle, {300, 150}, {200, 250}, 0), -90 * kDegree, 1e-4);
        EXPECT_NEAR(turnLed(image, circle, {300, 150}, {200, 250}, 170 * kDegree), 270 * kDegree, 1e-4)
            << "on, not back";
    }
}

TEST(SectionTurnTest, GoesAlongACircleThatIsSeenFromItsSide) {
    for (const bool parallel : {true, false}) {
        const SceneImage image = alongZ(parallel);
        const TurnCircle before{{0, 0, 0}, {0, 1, 0}, 1, normalize(Vec3d{1, 0, 1})};
        EXPECT_NEAR(turnLed(image, before, {200, 150}, {250, 150}, 0), 0.5, 1e-4) << "z goes to x";
        const TurnCircle behind{{0, 0, 0}, {0, 1, 0}, 1, normalize(Vec3d{1, 0, -1})};
        EXPECT_NEAR(turnLed(image, behind, {200, 150}, {250, 150}, 0), -0.5, 1e-4);
        EXPECT_NEAR(turnLed(image, before, {200, 150}, {200, 250}, 0), 0, 1e-12) << "across it";
    }
}

class SectionHandlesTest : public test::WindowFixture {
  protected:
    const SceneState& state() { return window->editor().state(); }
    SectionHandles& handles() { return *window->findChild<SectionHandles*>(); }
    const rtcore::SectionPlane& plane(int number) {
        return state().sections.planes.at(static_cast<std::size_t>(number - 1));
    }
    void command(const char* line) {
        const Answer answer = ask(window->session(), QString::fromLatin1(line));
        ASSERT_TRUE(answer.done) << line << ": " << answer.text.toStdString();
    }
    /// With that view, that section, and handles.
    void cut(const char* view, const char* section, const std::string& scene = "room.obj") {
        ASSERT_NO_FATAL_FAILURE(open(scene));
        const View before = status().view;
        ASSERT_NO_FATAL_FAILURE(command(view));
        ASSERT_TRUE(comes([&] { return !(status().view == before); }));
        ASSERT_NO_FATAL_FAILURE(command(section));
        action(ActionId::SectionHandles)->trigger();
        window->editor().refresh();
        ASSERT_TRUE(comes([&] { return !state().sections.empty() && status().idle; }));
        ASSERT_TRUE(comes([&] { return handles().place(1).has_value(); }));
        before_ = state().edits;
    }
    void moveTo(const QPointF& to, Qt::KeyboardModifiers keys = {}) {
        QWidget* view = &window->view();
        QMouseEvent event(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, keys);
        QApplication::sendEvent(view, &event);
    }
    void press(const QPointF& at) { button(QEvent::MouseButtonPress, at, Qt::LeftButton); }
    void release(const QPointF& at) { button(QEvent::MouseButtonRelease, at, Qt::NoButton); }
    void button(QEvent::Type type, const QPointF& at, Qt::MouseButtons held) {
        QWidget* view = &window->view();
        QMouseEvent event(type, at, view->mapToGlobal(at), Qt::LeftButton, held, {});
        QApplication::sendEvent(view, &event);
    }
    /// In four steps, so far apart that the server is asked for each.
    void drag(const QPointF& from, const QPointF& by) {
        pixel_ = unitsPerPixel();
        press(from);
        for (int i = 1; i <= 4; ++i) {
            moveTo(from + by * i / 4);
            QTest::qWait(20);
        }
        release(from + by);
    }
    double unitsPerPixel() {
        return double{status().view.parallelWidth} / window->view().pictureArea().width();
    }
    /// Takes a knob around the arrow's foot, seen along its axis, by so many degrees, clockwise.
    void turn(int axis, double degrees, Qt::KeyboardModifiers keys = {}, bool release = true) {
        const QPointF foot = *handles().place(1), from = *handles().knob(axis), arm = from - foot;
        const auto at = [&](double angle) {
            const double c = std::cos(angle * kDegree), s = std::sin(angle * kDegree);
            return foot + QPointF(arm.x() * c - arm.y() * s, arm.x() * s + arm.y() * c);
        };
        press(from);
        for (int i = 1; i <= 4; ++i) {
            moveTo(at(degrees * i / 4), keys);
            QTest::qWait(20);
        }
        if (release) this->release(at(degrees));
    }
    Vec3 normal() { return normalize(plane(1).normal); }
    /// That of the section comes to this.
    bool turnsTo(Vec3 wanted) {
        return comes([&] { return length(normal() - normalize(wanted)) < 0.03F; });
    }
    /// Sides of small frames are rounded, and the handles go with what is shown.
    bool comesTo(const std::function<double()>& position, double from, double pixels) {
        const double wanted = from + pixels * pixel_;
        return comes([&] { return std::abs(position() - wanted) < 2.5 * pixel_; });
    }
    /// So many since cut().
    bool edits(int count) {
        return comes([&] { return state().edits == before_ + count; });
    }
    int before_ = 0;
    double pixel_ = 0; ///< scene units, when the last drag began
};

constexpr const char* kFromFront = "camera orthographic 0 1 6 0 0 -1 8";
constexpr const char* kAboveHalf = "section add 0 0.5 0 0 1 0";

TEST_F(SectionHandlesTest, ADragMovesThePlaneAsFarAsTheHandGoesInOneStep) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    const QPointF place = *handles().place(1), tip = *handles().tip(1);
    EXPECT_LT(tip.y(), place.y() - 50) << "upwards, where the model is taken away";
    EXPECT_NEAR(tip.x(), place.x(), 0.01);
    drag(tip, {0, 20});
    ASSERT_TRUE(comesTo([&] { return plane(1).point.y; }, 0.5, -20)) << plane(1).point.y;
    EXPECT_EQ(plane(1).point.x, 0);
    ASSERT_TRUE(edits(1)) << state().edits;
    EXPECT_EQ(state().undo, SectionsPanel::stepAt(1));
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(comes([&] { return plane(1).point.y == 0.5F; }));
    EXPECT_EQ(state().edits, before_);
}

TEST_F(SectionHandlesTest, AHandleGoesWithTheHandInPerspective) {
    ASSERT_NO_FATAL_FAILURE(cut("camera look-at 3 3 8 0 0 0 60", kAboveHalf));
    const QPointF place = *handles().place(1), tip = *handles().tip(1);
    const QPointF along = (tip - place) / std::hypot(tip.x() - place.x(), tip.y() - place.y());
    press(place);
    for (const double far : {10.0, -25.0}) {
        moveTo(place + far * along);
        const QPointF now = *handles().place(1);
        EXPECT_NEAR(now.x(), (place + far * along).x(), 4);
        EXPECT_NEAR(now.y(), (place + far * along).y(), 4);
    }
    release(place - 25 * along);
    EXPECT_TRUE(comes([&] { return plane(1).point.y < 0.3F; })) << plane(1).point.y;
    EXPECT_TRUE(edits(1));
}

TEST_F(SectionHandlesTest, WhereItPointsAtTheEyeUpwardsLeadsAway) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, "section add 0 0 -1 0 0 1"));
    const QPointF place = *handles().place(1);
    EXPECT_EQ(*handles().tip(1), place);
    drag(place, {0, -20});
    EXPECT_TRUE(comesTo([&] { return plane(1).point.z; }, -1, -20)) << plane(1).point.z;
}

TEST_F(SectionHandlesTest, APlaneStaysInTheModelsBox) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    const float top = state().bounds.hi.y;
    drag(*handles().place(1), {0, -150});
    ASSERT_TRUE(edits(1));
    EXPECT_TRUE(comes([&] { return std::abs(plane(1).point.y - top) < 1e-4F; })) << plane(1).point.y;
    EXPECT_TRUE(comes([&] { return handles().place(1).has_value(); })) << "it can be taken back";
}

TEST_F(SectionHandlesTest, AClickSelectsAndMovesNothingAndTheMouseStaysFree) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    ASSERT_NO_FATAL_FAILURE(command("section add 1 0 0 1 0 0"));
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return state().sections.planes.size() == 2 && status().idle; }));
    SectionsPanel& panel = *window->findChild<SectionsPanel*>();
    EXPECT_EQ(panel.selectedNumber(), 2);
    QTest::mouseClick(&window->view(), Qt::LeftButton, {}, handles().place(1)->toPoint());
    EXPECT_EQ(panel.selectedNumber(), 1);
    EXPECT_FALSE(window->view().input().captured());
    EXPECT_EQ(state().edits, before_ + 1);
}

TEST_F(SectionHandlesTest, HandlesUnderThePointerAreBright) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    const QPoint tip = handles().tip(1)->toPoint();
    const QImage before = grabbed();
    QTest::mouseMove(&window->view(), tip);
    ASSERT_TRUE(comes([&] { return handles().hovered() == 1; }));
    EXPECT_EQ(window->view().cursor().shape(), Qt::PointingHandCursor);
    EXPECT_NE(grabbed().pixelColor(handles().place(1)->toPoint()),
              before.pixelColor(handles().place(1)->toPoint()));
    QTest::mouseMove(&window->view(), QPoint(5, 5));
    EXPECT_TRUE(comes([&] { return handles().hovered() == 0; }));
    EXPECT_NE(window->view().cursor().shape(), Qt::PointingHandCursor);
}

TEST_F(SectionHandlesTest, AreThereWhileThePanelIsOpen) {
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_NO_FATAL_FAILURE(command(kAboveHalf));
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return !state().sections.empty(); }));
    EXPECT_FALSE(handles().place(1));
    action(ActionId::SectionsPanel)->trigger();
    EXPECT_TRUE(comes([&] { return handles().place(1).has_value(); }));
    action(ActionId::SectionsPanel)->trigger();
    EXPECT_TRUE(comes([&] { return !handles().place(1); }));
}

// With bars beside it, since its shape is not the window's.
TEST_F(SectionHandlesTest, GoWithAnImageThatDoesNotFillTheView) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    ASSERT_NO_FATAL_FAILURE(command("resolution 40 80"));
    ASSERT_TRUE(comes([&] { return status().resolution == QSize(40, 80) && status().idle; }));
    ASSERT_TRUE(comes([&] { return window->session().frame().size() == QSize(40, 80); }));
    ASSERT_LT(window->view().pictureArea().width(), window->view().width() / 2.0);
    const QPointF place = *handles().place(1);
    EXPECT_TRUE(window->view().pictureArea().contains(place));
    drag(place, {0, 15});
    EXPECT_TRUE(comesTo([&] { return plane(1).point.y; }, 0.5, -15)) << plane(1).point.y;
}

TEST_F(SectionHandlesTest, AKnobTurnsThePlaneAboutTheArrowsFootInOneStep) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    EXPECT_FALSE(handles().knob(0)) << "it would be on the arrow";
    ASSERT_TRUE(handles().knob(1));
    ASSERT_NO_FATAL_FAILURE(turn(1, 30));
    const float c = std::cos(static_cast<float>(30 * kDegree)), s = 0.5F;
    ASSERT_TRUE(turnsTo({s, c, 0})) << normal().x << ' ' << normal().y;
    EXPECT_NEAR(plane(1).point.y, 0.5F, 1e-4F);
    ASSERT_TRUE(edits(1)) << state().edits;
    EXPECT_EQ(state().undo, QStringLiteral("section plane 1"));
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(turnsTo({0, 1, 0}));
    EXPECT_EQ(state().edits, before_);
}

// The middle of what is seen of the plane is elsewhere by then.
TEST_F(SectionHandlesTest, TheFootStaysWhereItIsAfterATurn) {
    ASSERT_NO_FATAL_FAILURE(cut("camera look-at 3 3 8 0 0 0 60", kAboveHalf));
    ASSERT_TRUE(handles().knob(1));
    const QPointF before = *handles().place(1), from = *handles().knob(1),
                  to = from + 0.4 * (*handles().tip(1) - from);
    drag(from, to - from);
    ASSERT_TRUE(comes([&] { return normal().y < 0.99F; }));
    ASSERT_TRUE(edits(1));
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return status().idle; }));
    EXPECT_LT(QLineF(*handles().place(1), before).length(), 1.5);
    ASSERT_NO_FATAL_FAILURE(command("section plane 1 0 0.2 0 0 1 0"));
    window->editor().refresh();
    ASSERT_TRUE(turnsTo({0, 1, 0}));
    EXPECT_TRUE(comes([&] { return handles().place(1)->y() > before.y() + 1.5; })) << "another plane";
}

TEST_F(SectionHandlesTest, ShiftKeepsTurnsToFifteenDegrees) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    ASSERT_NO_FATAL_FAILURE(turn(1, -50, Qt::ShiftModifier));
    const float half = std::sqrt(0.5F);
    EXPECT_TRUE(comes([&] {
        return length(normal() - Vec3{-half, half, 0}) < 1e-5F;
    })) << normal().x
        << ' ' << normal().y;
    ASSERT_NO_FATAL_FAILURE(command("section plane 1 0 0.5 0 0 1 0"));
    window->editor().refresh();
    ASSERT_TRUE(turnsTo({0, 1, 0}));
    ASSERT_TRUE(comes([&] { return handles().knob(1).has_value(); }));
    ASSERT_NO_FATAL_FAILURE(turn(1, 92, Qt::ShiftModifier));
    EXPECT_TRUE(comes([&] { return normal() == Vec3{1, 0, 0}; })) << "an axis stays one";
}

TEST_F(SectionHandlesTest, EscGivesADragUp) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, kAboveHalf));
    ASSERT_NO_FATAL_FAILURE(turn(1, 40, {}, false));
    ASSERT_TRUE(comes([&] { return edits(1); }));
    QTest::keyClick(&window->view(), Qt::Key_Escape);
    moveTo(*handles().place(1) + QPointF(80, 80));
    EXPECT_TRUE(turnsTo({0, 1, 0}));
    release(*handles().place(1) + QPointF(80, 80));
    EXPECT_TRUE(comes([&] { return plane(1) == (rtcore::SectionPlane{{0, 0.5F, 0}, {0, 1, 0}}); }));
    EXPECT_TRUE(edits(0)) << "nothing is left to take back";
    EXPECT_FALSE(window->view().input().captured());
    const QPointF tip = *handles().tip(1);
    press(tip);
    moveTo(tip + QPointF(0, 30));
    ASSERT_TRUE(comes([&] { return plane(1).point.y < 0.4F; }));
    QTest::keyClick(&window->view(), Qt::Key_Escape);
    EXPECT_TRUE(comes([&] { return plane(1).point.y == 0.5F; })) << plane(1).point.y;
    release(tip);
    EXPECT_TRUE(edits(0)) << state().edits - before_;
}

TEST_F(SectionHandlesTest, OfOneThatPointsAtTheEyeTurnItAboutBothAxes) {
    ASSERT_NO_FATAL_FAILURE(cut(kFromFront, "section add 0 0 -1 0 0 1"));
    ASSERT_TRUE(handles().knob(0) && handles().knob(1));
    EXPECT_GT(QLineF(*handles().knob(0), *handles().place(1)).length(), 20);
    drag(*handles().knob(1), {-20, 0});
    EXPECT_TRUE(comes([&] { return normal().x < -0.2F && std::fabs(normal().y) < 1e-4F; }))
        << normal().x << ' ' << normal().y;
    EXPECT_TRUE(edits(1));
}

TEST_F(SectionHandlesTest, AKnobGoesWithTheHandInPerspective) {
    ASSERT_NO_FATAL_FAILURE(cut("camera look-at 3 3 8 0 0 0 60", kAboveHalf));
    ASSERT_TRUE(handles().knob(1));
    const QPointF foot = *handles().place(1), from = *handles().knob(1);
    const QPointF to = from + 0.4 * (*handles().tip(1) - from); // towards the arrow's tip
    press(from);
    moveTo(to);
    ASSERT_TRUE(handles().knob(1));
    const QLineF hand(foot, to), knob(foot, *handles().knob(1));
    EXPECT_LT(std::fabs(std::remainder(hand.angleTo(knob), 360)), 4);
    release(to);
    EXPECT_TRUE(comes([&] { return normal().y < 0.99F; }));
    EXPECT_TRUE(edits(1));
}

TEST_F(SectionHandlesTest, TheSidesOfABoxAreNotTurned) {
    ASSERT_NO_FATAL_FAILURE(cut("camera look-at 3 3 8 0 0 0 60", "section box -1 -1 -1 1 1 1"));
    EXPECT_FALSE(handles().knob(0));
    EXPECT_FALSE(handles().knob(1));
}

TEST_F(SectionHandlesTest, FarFromTheFilesZeroTheyTurnAboutTheSamePoint) {
    test::writeText(
        folder() / "survey.obj",
        "v 740000000 1040000000 200000\nv 740004000 1040000000 200000\nv 740004000 1040004000 200000\n"
        "v 740000000 1040004000 203000\nf 1 2 3\nf 1 3 4\n");
    test::writeText(folder() / "survey.scn",
                    "version = 1\nmodel = \"survey.obj\"\nup = \"+z\"\nmetresPerUnit = 0.001\n");
    ASSERT_NO_FATAL_FAILURE(cut("camera orthographic 740002000 1039990000 201500 0 1 0 8000 0 0 1",
                                "section add 740002000 1040002000 201500 0 0 1", "survey.scn"));
    const int axis = handles().knob(1) ? 1 : 0;
    ASSERT_TRUE(handles().knob(axis));
    ASSERT_NO_FATAL_FAILURE(turn(axis, 45, Qt::ShiftModifier));
    EXPECT_TRUE(turnsTo({1, 0, 1})) << normal().x << ' ' << normal().y << ' ' << normal().z;
    const rtcore::FilePoint through = state().origin.inFile(plane(1).point);
    EXPECT_NEAR(through[2], 201500, 1);
    EXPECT_NEAR(through[0], 740002000, 1500);
}

TEST_F(SectionHandlesTest, FarFromTheFilesZeroTheyGoAsFar) {
    test::writeText(
        folder() / "survey.obj",
        "v 740000000 1040000000 200000\nv 740004000 1040000000 200000\nv 740004000 1040004000 200000\n"
        "v 740000000 1040004000 203000\nf 1 2 3\nf 1 3 4\n");
    test::writeText(folder() / "survey.scn",
                    "version = 1\nmodel = \"survey.obj\"\nup = \"+z\"\nmetresPerUnit = 0.001\n");
    ASSERT_NO_FATAL_FAILURE(cut("camera orthographic 740002000 1039990000 201500 0 1 0 8000 0 0 1",
                                "section add 740002000 1040002000 201500 0 0 1", "survey.scn"));
    const QPointF tip = *handles().tip(1);
    EXPECT_LT(tip.y(), handles().place(1)->y() - 50);
    drag(tip, {0, 20});
    const auto height = [&] { return state().origin.inFile(plane(1).point)[2]; };
    EXPECT_TRUE(comesTo(height, 201500, -20)) << height();
    EXPECT_NEAR(state().origin.inFile(plane(1).point)[0], 740002000, 0.1);
}

} // namespace
} // namespace gui
