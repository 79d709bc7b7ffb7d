/// Handles of sections in the image: where they are, and planes that are dragged by them, with a real server.
#include "gui/window_support.h"

#include "gui/models/section_marks.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/sections_panel.h"
#include "gui/view/section_handles.h"

#include <QListWidget>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
    void moveTo(const QPointF& to) {
        QWidget* view = &window->view();
        QMouseEvent event(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
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
