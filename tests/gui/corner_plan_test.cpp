/// The plan in the corner of the image, and the ways from storey to storey.
#include "gui/models/plan_fit.h"
#include "gui/operations/scene_editor.h"
#include "gui/view/corner_plan.h"
#include "gui/window_support.h"

#include <QToolButton>

#include <array>
#include <cmath>
#include <sstream>

namespace {

namespace corner_plan_test {

using namespace test;
using namespace gui;

using Position = std::array<double, 3>;

/// Boxes as an .obj, up along y.
class Boxes {
  public:
    void add(Position lo, Position hi) {
        for (int i = 0; i < 8; ++i)
            text_ << "v " << ((i & 1) != 0 ? hi : lo)[0] << ' ' << ((i & 2) != 0 ? hi : lo)[1] << ' '
                  << ((i & 4) != 0 ? hi : lo)[2] << '\n';
        constexpr int kFaces[6][4]{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (const auto& face : kFaces) {
            text_ << 'f';
            for (const int corner : face) text_ << ' ' << first_ + corner;
            text_ << '\n';
        }
        first_ += 8;
    }
    void part(const char* name) { text_ << "o " << name << '\n'; }
    std::string text() const { return "# units = metres\n" + text_.str(); }

  private:
    std::ostringstream text_;
    int first_ = 1;
};

/// Two storeys of 20 x 10 m at 0 and 3 m, with walls of 0.5 m, a post in the upper one.
std::string twoStoreyHouse() {
    Boxes boxes;
    boxes.part("house");
    for (const double floor : {0.0, 3.0, 6.0}) boxes.add({0, floor - 0.25, 0}, {20, floor, 10});
    for (const double floor : {0.0, 3.0}) {
        boxes.add({0, floor, 0}, {20, floor + 2.75, 0.5});
        boxes.add({0, floor, 9.5}, {20, floor + 2.75, 10});
        boxes.add({0, floor, 0.5}, {0.5, floor + 2.75, 9.5});
        boxes.add({19.5, floor, 0.5}, {20, floor + 2.75, 9.5});
    }
    boxes.part("post");
    boxes.add({5, 3, 5}, {6, 5.75, 6});
    return boxes.text();
}

class CornerPlanTest : public WindowFixture {
  protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(WindowFixture::SetUp());
        window->preferences().set(pref::progressiveRendering, false);
        window->resize(1000, 700);
        writeText(folder() / "house.obj", twoStoreyHouse());
        writeText(folder() / "block.obj", [] {
            Boxes boxes;
            boxes.add({0, 0, 0}, {1, 1, 1});
            return boxes.text();
        }());
    }
    void openHouse() {
        ASSERT_NO_FATAL_FAILURE(openAndRest("house.obj"));
        ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 10 1.6 5 0 0 -1 60")).done);
    }
    void showPlan() {
        action(ActionId::PlanInCorner)->trigger();
        ASSERT_TRUE(comes([&] { return plan().isVisible() && !plan().planArea().isEmpty(); }));
    }
    bool shows(const char* title) {
        return comes([&] { return plan().title() == QLatin1String(title); });
    }
    CornerPlan& plan() { return *window->view().findChild<CornerPlan*>(); }
    QToolButton& arrow(Qt::ArrowType type) {
        for (QToolButton* button : plan().findChildren<QToolButton*>())
            if (button->arrowType() == type) return *button;
        throw std::logic_error("no such arrow");
    }
    QVector3D eye() { return status().view.eye; }
    bool isAt(QVector3D wanted, float tolerance = 1e-3F) {
        return comes([&] { return (eye() - wanted).length() < tolerance; });
    }
    /// Of a position on the floor.
    QPoint pointOf(Position position) {
        return PlanFit(plan().outline(), plan().planArea()).at(position).toPoint();
    }
};

TEST_F(CornerPlanTest, ShowsTheStoreyOfTheCamera) {
    ASSERT_NO_FATAL_FAILURE(openHouse());
    EXPECT_FALSE(plan().isVisible()) << "unless it is asked for";
    ASSERT_NO_FATAL_FAILURE(showPlan());
    EXPECT_TRUE(shows("Storey 1 of 2"));
    EXPECT_LE(plan().width(), window->view().width() / 4);
    EXPECT_TRUE(window->view().rect().contains(plan().geometry()));
    ASSERT_TRUE(comes([&] { return plan().mark().has_value(); }));
    EXPECT_LT(QLineF(*plan().mark(), plan().planArea().center()).length(), 1.5) << "in the middle";
    EXPECT_EQ(plan().outline().solids.size(), 2U) << "walls outside and inside";
    // Up the stairs, and to a corner.
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 0 4.6 0 0 0 -1")).done);
    EXPECT_TRUE(shows("Storey 2 of 2"));
    EXPECT_EQ(plan().outline().solids.size(), 3U) << "the post, too";
    EXPECT_TRUE(comes([&] {
        return QLineF(*plan().mark(), plan().planArea().topLeft()).length() < plan().planArea().width() / 10;
    }));
    // Another one by its arrows, until the camera changes the storey.
    QTest::mouseClick(&arrow(Qt::DownArrow), Qt::LeftButton);
    EXPECT_TRUE(shows("Storey 1 of 2"));
    EXPECT_FALSE(arrow(Qt::DownArrow).isEnabled());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 4.6 1 0 0 -1")).done);
    QTest::qWait(100);
    EXPECT_EQ(plan().title(), QStringLiteral("Storey 1 of 2"));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("storey go 1")).done);
    ASSERT_TRUE(isAt({1, 1.6F, 1}));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("storey go 2")).done);
    EXPECT_TRUE(shows("Storey 2 of 2"));
    action(ActionId::PlanInCorner)->trigger();
    EXPECT_FALSE(plan().isVisible());
}

TEST_F(CornerPlanTest, AClickGoesThereAndIsTakenBack) {
    ASSERT_NO_FATAL_FAILURE(openHouse());
    ASSERT_NO_FATAL_FAILURE(showPlan());
    ASSERT_TRUE(isAt({10, 1.6F, 5}));
    const auto metre = static_cast<float>(20 / plan().planArea().width());
    QTest::mouseClick(&plan(), Qt::LeftButton, {}, pointOf({3, 0, 8}));
    EXPECT_TRUE(isAt({3, 1.6F, 8}, metre));
    EXPECT_EQ(status().view.forward, QVector3D(0, 0, -1));
    // To the storey that is shown.
    QTest::mouseClick(&arrow(Qt::UpArrow), Qt::LeftButton);
    ASSERT_TRUE(shows("Storey 2 of 2"));
    QTest::mouseClick(&plan(), Qt::LeftButton, {}, pointOf({15, 3, 2}));
    EXPECT_TRUE(isAt({15, 4.6F, 2}, metre));
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(isAt({3, 1.6F, 8}, metre));
    EXPECT_TRUE(window->view().hasFocus()) << "keys stay the camera's";
}

TEST_F(CornerPlanTest, ADragLooksThere) {
    ASSERT_NO_FATAL_FAILURE(openHouse());
    ASSERT_NO_FATAL_FAILURE(showPlan());
    ASSERT_TRUE(isAt({10, 1.6F, 5}));
    const QPoint from = pointOf({10, 0, 7});
    const QPoint to = pointOf({18, 0, 5});
    QTest::mousePress(&plan(), Qt::LeftButton, {}, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
        QMouseEvent move(QEvent::MouseMove, at, plan().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&plan(), &move);
    }
    QTest::mouseRelease(&plan(), Qt::LeftButton, {}, to);
    EXPECT_TRUE(comes([&] { return (status().view.forward - QVector3D(1, 0, 0)).length() < 0.1F; }));
    EXPECT_TRUE(isAt({10, 1.6F, 5})) << "where it was";
}

TEST_F(CornerPlanTest, IsOfWhatIsShown) {
    ASSERT_NO_FATAL_FAILURE(openHouse());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("storey go 2")).done);
    ASSERT_NO_FATAL_FAILURE(showPlan());
    ASSERT_TRUE(comes([&] { return plan().outline().solids.size() == 3; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("part hide post")).done);
    EXPECT_TRUE(comes([&] { return plan().outline().solids.size() == 2; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("part show-all")).done);
    EXPECT_TRUE(comes([&] { return plan().outline().solids.size() == 3; }));
}

TEST_F(CornerPlanTest, AModelWithoutStoreysHasContourLines) {
    ASSERT_NO_FATAL_FAILURE(openAndRest("house.obj"));
    ASSERT_NO_FATAL_FAILURE(showPlan());
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    EXPECT_TRUE(shows("No storeys: contour lines"));
    EXPECT_FALSE(arrow(Qt::UpArrow).isVisible());
    EXPECT_FALSE(plan().outline().light.empty());
}

TEST_F(CornerPlanTest, CommandsLeadFromStoreyToStorey) {
    ASSERT_NO_FATAL_FAILURE(openHouse());
    action(ActionId::StoreyAbove)->trigger();
    EXPECT_TRUE(isAt({10, 4.6F, 5}));
    EXPECT_TRUE(comes([&] { return window->view().told() == QStringLiteral("Storey 2 of 2"); }));
    action(ActionId::StoreyAbove)->trigger();
    EXPECT_TRUE(
        comes([&] { return window->view().told() == QStringLiteral("This is the highest storey."); }));
    action(ActionId::GroundFloor)->trigger();
    EXPECT_TRUE(isAt({10, 1.6F, 5}));
    action(ActionId::StoreyBelow)->trigger();
    EXPECT_TRUE(comes([&] { return window->view().told() == QStringLiteral("This is the lowest storey."); }));
    ASSERT_NO_FATAL_FAILURE(openAndRest("block.obj"));
    ASSERT_TRUE(comes([&] { return window->editor().scene() == file("block.obj"); }));
    action(ActionId::GroundFloor)->trigger();
    EXPECT_TRUE(comes([&] { return window->view().told() == QStringLiteral("This model has no storeys."); }));
}

TEST_F(CornerPlanTest, IsReadableInLightAndDark) {
    ASSERT_NO_FATAL_FAILURE(openHouse());
    ASSERT_NO_FATAL_FAILURE(showPlan());
    for (const bool dark : {false, true}) {
        QPalette palette;
        palette.setColor(QPalette::Window, dark ? Qt::black : Qt::white);
        palette.setColor(QPalette::WindowText, dark ? Qt::white : Qt::black);
        plan().setPalette(palette);
        QImage image(plan().size(), QImage::Format_RGB32);
        image.fill(Qt::gray);
        plan().render(&image, {}, {}, QWidget::DrawChildren);
        const int paper = image.pixelColor(pointOf({15, 0, 7})).lightness();
        const int wall = image.pixelColor(pointOf({0, 0, 5})).lightness();
        EXPECT_GT(std::abs(paper - wall), 60) << dark;
        EXPECT_EQ(paper < 128, dark);
    }
}

app::ToldOutline outline() {
    return {.storey = 2,
            .floors = {100, 103},
            .top = 106,
            .eyeHeight = 1.6,
            .corner = {4.5e6, 5.4e6, 103},
            .right = {1, 0, 0},
            .ahead = {0, 1, 0},
            .up = {0, 0, 1},
            .step = 0.01,
            .size = {2000, 1000}};
}

// On a national grid, up along z.
TEST(PlanFit, LeadsThereAndBack) {
    const PlanFit fit(outline(), {10, 20, 200, 300});
    EXPECT_EQ(fit.at({4.5e6, 5.4e6, 110}), QPointF(10, 220));
    EXPECT_EQ(fit.at({4.5e6 + 20, 5.4e6 + 10, 0}), QPointF(210, 120));
    const Position eye = fit.eyeAt({110, 170}, 0);
    EXPECT_NEAR(eye[0], 4.5e6 + 10, 1e-6);
    EXPECT_NEAR(eye[1], 5.4e6 + 5, 1e-6);
    EXPECT_NEAR(eye[2], 104.6, 1e-6);
    app::ToldOutline none = outline();
    none.storey = 0;
    none.floors.clear();
    EXPECT_NEAR(PlanFit(none, {10, 20, 200, 300}).eyeAt({110, 170}, 150)[2], 150, 1e-6)
        << "as high as before";
}

TEST(PlanFit, KnowsDirections) {
    const PlanFit fit(outline(), {0, 0, 200, 100});
    View view{.origin = {4.5e6, 5.4e6, 100}, .eye = {10, 5, 4.6F}, .forward = {1, 1, 0}, .up = {0, 0, 1}};
    EXPECT_EQ(fit.directionOf(view).p1(), QPointF(100, 50));
    EXPECT_NEAR(fit.directionOf(view).angle(), 45, 1e-3);
    view.forward = {0, 0, -1};
    view.up = {-1, 0, 0};
    EXPECT_NEAR(fit.directionOf(view).angle(), 180, 1e-3) << "what is up in the image";
    EXPECT_NEAR(fit.turnedTo({100, 0}, view)[1], 1, 1e-6) << "level";
    view.forward = {0.8F, 0, -0.6F};
    const std::array<float, 3> turned = fit.turnedTo({100, 0}, view);
    EXPECT_NEAR(turned[0], 0, 1e-6);
    EXPECT_NEAR(turned[1], 0.8F, 1e-6);
    EXPECT_NEAR(turned[2], -0.6F, 1e-6) << "as steep as before";
    EXPECT_EQ(fit.turnedTo({100, 50}, view), (std::array<float, 3>{0.8F, 0, -0.6F}));
}

TEST(PlanFit, TheGroundFloorIsAtZeroOrTheLowest) {
    EXPECT_EQ(groundFloor({-2.8, 0.1, 3}), 2);
    EXPECT_EQ(groundFloor({212, 215}), 1);
    EXPECT_EQ(groundFloor({0.4, -0.2}), 2);
    EXPECT_EQ(groundFloor({}), 0);
}

} // namespace corner_plan_test

} // namespace
