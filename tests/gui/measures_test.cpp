/// Measures: their texts, their panel alone, and measuring with a real server.
#include "gui/window_support.h"

#include "gui/models/measure_texts.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/measures_panel.h"
#include "gui/view/hidden_measures.h"
#include "gui/view/measure_marks.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>

#include <gtest/gtest.h>

namespace gui {
namespace {

using rtcore::KeptMeasure;
using rtcore::MeasureKind;
using rtcore::Vec3d;
using test::comes;

/// A model of centimetres.
SceneState measuredState() {
    SceneState state;
    state.metresPerUnit = 0.01F;
    state.measures.all = {
        {.points = {{0, 0, 0}, {300, 400, 0}}, .name = "door"},
        {.kind = MeasureKind::Chain, .points = {{0, 0, 0}, {100, 0, 0}, {100, 50, 0}}},
        {.kind = MeasureKind::Angle, .points = {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}},
        {.kind = MeasureKind::Area, .points = {{0, 0, 0}}, .normal = {0, 1, 0}, .amount = 25000}};
    state.measureCount = 4;
    return state;
}

TEST(MeasureTextsTest, TellValueUnitAndName) {
    SceneState state = measuredState();
    EXPECT_EQ(measureRow(state, 0), QStringLiteral("1  Distance 5.000 m  door"));
    EXPECT_EQ(measureRow(state, 2), QStringLiteral("3  Angle 90.0°"));
    EXPECT_EQ(measureRow(state, 3), QStringLiteral("4  Area 2.500 m²"));
    state.measures.unit = rtcore::LengthUnit::Centimetre;
    state.measures.decimals = 0;
    EXPECT_EQ(measureRow(state, 1), QStringLiteral("2  Chain 150 cm"));
}

TEST(MeasureTextsTest, LabelALengthInItsMiddleAndEachLegOfAChain) {
    const SceneState state = measuredState();
    const QList<MeasureLabel> one = labelsOf(state.measures.all[0], state);
    ASSERT_EQ(one.size(), 1);
    EXPECT_EQ(one[0].point, (Vec3d{150, 200, 0}));
    EXPECT_EQ(one[0].text, QStringLiteral("door 5.000 m"));
    const QList<MeasureLabel> chain = labelsOf(state.measures.all[1], state);
    ASSERT_EQ(chain.size(), 3);
    EXPECT_EQ(chain[0].text, QStringLiteral("Σ 1.500 m"));
    EXPECT_EQ(chain[0].point, (Vec3d{100, 50, 0}));
    EXPECT_EQ(chain[2].text, QStringLiteral("0.500 m"));
}

TEST(MeasureMarksTest, ReadWhatThePointerCatches) {
    const rtcore::LocalOrigin origin{{100, 0, 0}};
    const auto caught = readCaught(QStringLiteral("corner 101 2 -3.5"), origin);
    ASSERT_TRUE(caught);
    EXPECT_EQ(caught->kind, QStringLiteral("corner"));
    EXPECT_EQ(caught->point, (Vec3d{1, 2, -3.5}));
    EXPECT_FALSE(readCaught(QString(), origin));
    EXPECT_FALSE(readCaught(QStringLiteral("corner 1 2 x"), origin));
}

TEST(HiddenMeasuresTest, AreReadLineByLine) {
    EXPECT_TRUE(readHidden(QString()).empty());
    EXPECT_EQ(readHidden(QStringLiteral("2 1\n4 1 3")), (HiddenPoints{{1, 0}, {3, 0}, {3, 2}}));
    EXPECT_TRUE(readHidden(QStringLiteral("x 1\n0 2\n-1 1")).empty());
    EXPECT_EQ(readHidden(QStringLiteral("2 1 0 3")), (HiddenPoints{{1, 0}}));
}

TEST(MeasuresPanelTest, ShowsTheListAndEmitsNothing) {
    MeasuresPanel panel;
    std::vector<std::string> lines;
    QObject::connect(&panel, &MeasuresPanel::wanted, &panel,
                     [&](const std::string& line) { lines.push_back(line); });
    SceneState state = measuredState();
    state.measureCount = 9;
    panel.show(state);
    ASSERT_EQ(panel.list().count(), 5);
    EXPECT_EQ(panel.list().item(4)->text(), QStringLiteral("5 more"));
    EXPECT_EQ(panel.list().currentRow(), 3) << "the newest";
    state.measures.decimals = 1;
    panel.show(state);
    EXPECT_EQ(panel.decimals().value(), 1);
    EXPECT_TRUE(lines.empty());
}

TEST(MeasuresPanelTest, SendsCommands) {
    MeasuresPanel panel;
    panel.show(measuredState());
    std::vector<std::string> lines;
    QObject::connect(&panel, &MeasuresPanel::wanted, &panel,
                     [&](const std::string& line) { lines.push_back(line); });
    panel.list().setCurrentRow(0);
    EXPECT_EQ(panel.name().text(), QStringLiteral("door"));
    panel.name().setText(QStringLiteral("gate"));
    emit panel.name().editingFinished();
    panel.removal().click();
    panel.clearing().click();
    panel.unit().setCurrentIndex(2);
    emit panel.unit().activated(2);
    panel.decimals().setValue(0);
    EXPECT_EQ(lines,
              (std::vector<std::string>{"measure name 1 gate", "measure remove 1", "measure remove all",
                                        "measure unit mm 3", "measure unit mm 0"}));
}

TEST(MeasuresPanelTest, EnablesWhatCanBeDone) {
    MeasuresPanel panel;
    for (QPushButton* each : {&panel.going(), &panel.removal(), &panel.clearing(), &panel.exporting()})
        EXPECT_FALSE(each->isEnabled());
    panel.show(measuredState());
    for (QPushButton* each : {&panel.going(), &panel.removal(), &panel.clearing(), &panel.exporting()})
        EXPECT_TRUE(each->isEnabled());
    panel.setTool(MeasureKind::Angle);
    EXPECT_TRUE(panel.tool(MeasureKind::Angle).isChecked());
    panel.setTool({});
    EXPECT_FALSE(panel.tool(MeasureKind::Angle).isChecked());
}

class MeasuresOfAServer : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        openAndRest();
        action(ActionId::Measure)->trigger();
        ASSERT_TRUE(comes([&] { return panel().isVisible() && status().idle; }));
    }
    MeasuresPanel& panel() { return *window->findChild<MeasuresPanel*>(); }
    MeasureMarks& marks() { return *window->findChild<MeasureMarks*>(); }
    const rtcore::KeptMeasures& measures() { return window->editor().state().measures; }
    /// At a part of the image from its left and from its top.
    void click(double right, double down, Qt::KeyboardModifiers modifiers = {}) {
        const QRectF area = window->view().pictureArea();
        const QPointF at = area.topLeft() + QPointF(right * area.width(), down * area.height());
        QTest::mouseClick(&window->view(), Qt::LeftButton, modifiers, at.toPoint());
    }
    bool has(std::size_t count) {
        return comes([&] { return marks().points().size() == count; });
    }
    bool keeps(std::size_t count) {
        return comes([&] { return measures().all.size() == count; });
    }
    void key(Qt::Key which) { QTest::keyClick(&window->view(), which); }
};

TEST_F(MeasuresOfAServer, AreKeptByTwoClicksAndTakenBack) {
    EXPECT_TRUE(panel().tool(MeasureKind::Distance).isChecked());
    click(0.3, 0.6);
    ASSERT_TRUE(has(1));
    click(0.7, 0.6);
    ASSERT_TRUE(keeps(1));
    EXPECT_TRUE(marks().points().empty());
    EXPECT_EQ(measures().all[0].kind, MeasureKind::Distance);
    EXPECT_EQ(marks().labelPlaces().size(), 1U);
    EXPECT_FALSE(window->view().input().captured());
    EXPECT_EQ(window->editor().state().edits, 1);
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(keeps(0));
    EXPECT_EQ(panel().list().count(), 0);
}

TEST_F(MeasuresOfAServer, KeepToAnAxisWithShift) {
    click(0.3, 0.6);
    ASSERT_TRUE(has(1));
    click(0.7, 0.8, Qt::ShiftModifier);
    ASSERT_TRUE(keeps(1));
    const Vec3d way = measures().all[0].points[1] - measures().all[0].points[0];
    EXPECT_EQ((way.x != 0) + (way.y != 0) + (way.z != 0), 1) << way.x << " " << way.y << " " << way.z;
}

TEST_F(MeasuresOfAServer, EndAChainByEnterAndMeasuringByEsc) {
    panel().tool(MeasureKind::Chain).click();
    for (std::size_t i = 0; i < 4; ++i) {
        click(0.2 + 0.15 * static_cast<double>(i), 0.6 + 0.05 * static_cast<double>(i % 2));
        ASSERT_TRUE(has(i + 1));
    }
    key(Qt::Key_Backspace);
    EXPECT_EQ(marks().points().size(), 3U);
    key(Qt::Key_Return);
    ASSERT_TRUE(keeps(1));
    EXPECT_EQ(measures().all[0].points.size(), 3U);
    key(Qt::Key_Escape);
    EXPECT_FALSE(marks().measuring());
    EXPECT_FALSE(action(ActionId::Measure)->isChecked());
    EXPECT_FALSE(panel().tool(MeasureKind::Chain).isChecked());
}

TEST_F(MeasuresOfAServer, ForgetPointsByEscAndRemoveTheSelectedByDelete) {
    click(0.3, 0.6);
    ASSERT_TRUE(has(1));
    key(Qt::Key_Escape);
    EXPECT_TRUE(marks().points().empty());
    EXPECT_TRUE(marks().measuring());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("measure keep distance 0 0 0 1 0 0")).done);
    ASSERT_TRUE(keeps(1));
    key(Qt::Key_Delete);
    EXPECT_TRUE(keeps(0));
}

TEST_F(MeasuresOfAServer, CatchWhatIsAtThePointer) {
    const QPoint at = window->view().pictureArea().center().toPoint();
    QTest::mouseMove(&window->view(), at + QPoint(3, 30));
    QTest::mouseMove(&window->view(), at + QPoint(0, 30));
    EXPECT_TRUE(comes([&] { return marks().caught().has_value(); }));
    key(Qt::Key_Escape);
    EXPECT_FALSE(marks().caught());
}

TEST_F(MeasuresOfAServer, AreFacesToo) {
    panel().tool(MeasureKind::Area).click();
    click(0.5, 0.8);
    ASSERT_TRUE(keeps(1));
    EXPECT_EQ(measures().all[0].kind, MeasureKind::Area);
    EXPECT_GT(measures().all[0].amount, 0);
}

TEST_F(MeasuresOfAServer, AreLedTo) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("measure keep distance 0 0 0 1 0 0")).done);
    ASSERT_TRUE(keeps(1));
    panel().list().setCurrentRow(0);
    panel().going().click();
    EXPECT_TRUE(comes([&] {
        const auto at = marks().place({0.5, 0, 0});
        return at && (*at - window->view().pictureArea().center()).manhattanLength() < 2;
    }));
}

/// Of lines that are not dimmed.
int amberPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == QColor(255, 200, 60);
    return count;
}

// The floor's top is at y = -0.5, its bottom at -20.5.
TEST_F(MeasuresOfAServer, AreDimmedWhereSomethingHidesThem) {
    const auto tell = [&](const char* line) {
        ASSERT_TRUE(ask(window->session(), QString::fromLatin1(line)).done) << line;
    };
    action(ActionId::Measure)->trigger();
    const char *const above = "camera look-at 0 1 9 7 -50 -50", *const below =
                                                                    "camera look-at 7 -52 -40 7 -50 -50";
    ASSERT_NO_FATAL_FAILURE(tell(above));
    ASSERT_NO_FATAL_FAILURE(tell("measure keep distance 2 -50 -50 12 -50 -50"));
    ASSERT_NO_FATAL_FAILURE(tell("measure keep chain 0 0.5 8 0.5 0.5 8 2 -50 -50"));
    ASSERT_NO_FATAL_FAILURE(tell("measure keep distance 0 0.5 8 0.5 0.5 8"));
    ASSERT_TRUE(keeps(3));
    EXPECT_TRUE(comes([&] { return marks().isDimmed(0) && marks().isDimmed(1); }));
    EXPECT_FALSE(marks().isDimmed(1, 0));
    EXPECT_TRUE(marks().isDimmed(1, 1)) << "one end";
    EXPECT_FALSE(marks().isDimmed(2));
    ASSERT_NO_FATAL_FAILURE(tell("measure remove 3"));
    ASSERT_NO_FATAL_FAILURE(tell("measure remove 2"));
    ASSERT_TRUE(keeps(1));
    EXPECT_TRUE(comes([&] { return amberPixels(grabbed()) == 0; }));
    ASSERT_NO_FATAL_FAILURE(tell(below));
    EXPECT_TRUE(comes([&] { return !marks().isDimmed(0); }));
    EXPECT_TRUE(comes([&] { return amberPixels(grabbed()) > 20; }));
    ASSERT_NO_FATAL_FAILURE(tell(above));
    EXPECT_TRUE(comes([&] { return marks().isDimmed(0); }));
    ASSERT_NO_FATAL_FAILURE(tell("section add 0 -60 0 0 1 0"));
    EXPECT_TRUE(comes([&] { return !marks().isDimmed(0); })) << "nothing is there to hide it";
}

TEST_F(MeasuresOfAServer, AreNotAskedAboutWhileTheyAreNotShown) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera look-at 0 1 9 7 -50 -50")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("measure keep distance 2 -50 -50 12 -50 -50")).done);
    ASSERT_TRUE(keeps(1));
    ASSERT_TRUE(comes([&] { return marks().isDimmed(0); }));
    action(ActionId::Measure)->trigger();
    EXPECT_TRUE(marks().isDimmed(0));
    action(ActionId::ShowMeasures)->trigger();
    EXPECT_FALSE(marks().isDimmed(0));
    action(ActionId::ShowMeasures)->trigger();
    EXPECT_TRUE(comes([&] { return marks().isDimmed(0); }));
}

} // namespace
} // namespace gui
