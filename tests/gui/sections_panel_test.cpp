/// Sections in their panel: alone, and with a real server.
#include "gui/window_support.h"

#include "gui/operations/scene_editor.h"
#include "gui/panels/colour_button.h"
#include "gui/panels/sections_panel.h"
#include "gui/panels/value_box.h"
#include "gui/panels/value_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>

#include <gtest/gtest.h>

namespace gui {
namespace {

using rtcore::Vec3;
using test::comes;

/// A model of centimetres, 2 m wide, 4 m high, far from its file's zero; z is up.
SceneState cutState() {
    SceneState state;
    state.up = QStringLiteral("+z");
    state.metresPerUnit = 0.01F;
    state.origin.at = {0, 0, 1000};
    state.bounds = {{-100, -100, 0}, {100, 100, 400}};
    state.sections.planes = {{{0, 0, 160}, {0, 0, 2}}, {{0, 50, 0}, {0, -1, 0}}};
    return state;
}

QString textOf(SectionsPanel& panel, int row) { return panel.list().item(row)->text(); }

/// All that the panel wants, in order; what follows a hand with whether it goes on.
struct Wishes {
    explicit Wishes(SectionsPanel& panel) {
        QObject::connect(&panel, &SectionsPanel::wanted, &panel,
                         [this](const std::string& line) { lines.push_back(line); });
        QObject::connect(&panel, &SectionsPanel::edited, &panel,
                         [this](const QString& step, const std::string& line, std::optional<bool> goesOn) {
                             steps.push_back(step.toStdString());
                             lines.push_back(line);
                             joins.push_back(goesOn);
                         });
    }
    std::vector<std::string> lines, steps;
    std::vector<std::optional<bool>> joins;
};

TEST(SectionsPanelTest, NamesSectionsByWhatTheyTakeAway) {
    SectionsPanel panel;
    panel.show(cutState());
    ASSERT_EQ(panel.list().count(), 2);
    EXPECT_EQ(textOf(panel, 0), QStringLiteral("1  above z = 11.6 m"));
    EXPECT_EQ(textOf(panel, 1), QStringLiteral("2  in front of y = 0.5 m"));
    SceneState slanting;
    slanting.sections.planes = {{{1, 0, 1}, {1, 0, 1}}};
    panel.show(slanting);
    EXPECT_EQ(textOf(panel, 0), QStringLiteral("1  beyond 1.4142 m (0.71; 0; 0.71)"));
    EXPECT_EQ(sideOf({0, 0, -1}, QStringLiteral("-z")).away, SectionsPanel::tr("above %1"));
    EXPECT_EQ(sideOf({-1, 0, 0}, QStringLiteral("+y")).away, SectionsPanel::tr("left of %1"));
}

TEST(SectionsPanelTest, ShowsPositionAndStyleAndEmitsNothing) {
    SectionsPanel panel;
    Wishes wishes(panel);
    SceneState state = cutState();
    state.sections.light = rtcore::SectionLight::Cut;
    state.sections.caps = {rtcore::CapColours::One, {1, 0, 0}, true};
    panel.show(state);
    panel.list().setCurrentRow(0);
    EXPECT_EQ(panel.position().text(), QStringLiteral("11.6 m"));
    EXPECT_EQ(panel.slider().value(), panel.slider().maximum() * 160 / 400);
    EXPECT_EQ(panel.light().currentIndex(), 1);
    EXPECT_EQ(panel.caps().currentIndex(), 1);
    EXPECT_EQ(panel.colour().text(), QStringLiteral("#ff0000"));
    EXPECT_TRUE(panel.hatching().isChecked());
    EXPECT_TRUE(wishes.lines.empty());
}

TEST(SectionsPanelTest, EnablesWhatCanBeDone) {
    SectionsPanel panel;
    panel.show(SceneState());
    EXPECT_TRUE(panel.above().isEnabled());
    EXPECT_FALSE(panel.turn().isEnabled());
    EXPECT_FALSE(panel.position().isEnabled());
    EXPECT_FALSE(panel.clearing().isEnabled());
    EXPECT_FALSE(panel.colour().isEnabled());
    SceneState state = cutState();
    state.sections.caps.colours = rtcore::CapColours::None;
    state.sections.planes.resize(rtcore::kMaxSectionPlanes, {{0, 0, 0}, {0, 1, 0}});
    panel.show(state);
    EXPECT_FALSE(panel.above().isEnabled()) << "there are six";
    EXPECT_FALSE(panel.here().isEnabled());
    EXPECT_TRUE(panel.turn().isEnabled());
    EXPECT_TRUE(panel.clearing().isEnabled());
    EXPECT_FALSE(panel.hatching().isEnabled()) << "no caps";
}

TEST(SectionsPanelTest, ButtonsSendCommands) {
    SectionsPanel panel;
    panel.show(cutState());
    Wishes wishes(panel);
    panel.list().setCurrentRow(1);
    for (QPushButton* each : {&panel.above(), &panel.front(), &panel.right(), &panel.here(), &panel.turn(),
                              &panel.removal(), &panel.clearing()})
        each->click();
    emit panel.light().activated(1);
    emit panel.caps().activated(2);
    panel.hatching().click();
    EXPECT_EQ(wishes.lines, (std::vector<std::string>{
                                "section through z", "section through -y", "section through x",
                                "section here 0.5 0.5", "section turn 2", "section remove 2", "section clear",
                                "section light cut", "section caps none", "section hatching on"}));
}

TEST(SectionsPanelTest, ADragIsOneStep) {
    SectionsPanel panel;
    panel.show(cutState());
    Wishes wishes(panel);
    panel.list().setCurrentRow(0);
    panel.slider().setSliderDown(true);
    panel.slider().setSliderPosition(panel.slider().maximum() / 2);
    panel.slider().setSliderPosition(panel.slider().maximum());
    panel.slider().setSliderDown(false);
    panel.position().setValue(12);
    EXPECT_EQ(wishes.lines, (std::vector<std::string>{"section at 1 0 0 1200", "section at 1 0 0 1400",
                                                      "section at 1 0 0 1200"}));
    EXPECT_EQ(wishes.joins, (std::vector<std::optional<bool>>{false, true, std::nullopt}));
    EXPECT_EQ(textOf(panel, 0), QStringLiteral("1  above z = 12 m"));
    EXPECT_EQ(panel.slider().value(), panel.slider().maximum() / 2) << "it goes with the number";
}

class SectionsOfAServer : public test::WindowFixture {
  protected:
    const rtcore::SectionPlanes& sections() { return window->editor().state().sections; }
    SectionsPanel& panel() { return *window->findChild<SectionsPanel*>(); }
    bool edits(int count) {
        return comes([&] { return window->editor().state().edits == count; });
    }
};

TEST_F(SectionsOfAServer, AreMadeMovedAndTakenBack) {
    ASSERT_NO_FATAL_FAILURE(open());
    action(ActionId::SectionsPanel)->trigger();
    ASSERT_TRUE(comes([&] { return panel().above().isEnabled() && panel().isVisible(); }));
    panel().above().click();
    ASSERT_TRUE(edits(1));
    ASSERT_EQ(sections().planes.size(), 1U);
    EXPECT_EQ(sections().planes[0].normal, (Vec3{0, 1, 0}));
    EXPECT_EQ(panel().list().currentRow(), 0);
    panel().position().setValue(0.5);
    ASSERT_TRUE(edits(2));
    EXPECT_EQ(sections().planes[0].point.y, 0.5F);
    EXPECT_EQ(textOf(panel(), 0), QStringLiteral("1  above y = 0.5 m"));
    panel().turn().click();
    ASSERT_TRUE(edits(3));
    EXPECT_EQ(textOf(panel(), 0), QStringLiteral("1  below y = 0.5 m"));
    panel().hatching().click();
    ASSERT_TRUE(edits(4));
    EXPECT_TRUE(sections().caps.hatched);
    for (int left = 3; left >= 0; --left) {
        action(ActionId::Undo)->trigger();
        ASSERT_TRUE(edits(left));
    }
    EXPECT_EQ(panel().list().count(), 0);
}

TEST_F(SectionsOfAServer, ThatAreRefusedAreTold) {
    ASSERT_NO_FATAL_FAILURE(open());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 0 50 0 0 1 -1")).done); // nothing is there
    panel().here().click();
    EXPECT_TRUE(
        comes([&] { return window->notice().text().contains(QStringLiteral("nothing of the model")); }));
    EXPECT_EQ(panel().list().count(), 0);
}

} // namespace
} // namespace gui
