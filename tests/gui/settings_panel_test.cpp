/// The quality as one choice, what most people change, the rest under its fold, sliders, the image at rest.
#include "gui/window_support.h"

#include "gui/models/at_rest.h"
#include "gui/models/setting_labels.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/fold_box.h"
#include "gui/panels/quality_bar.h"
#include "gui/panels/settings_panel.h"
#include "gui/panels/value_box.h"
#include "gui/panels/value_slider.h"

#include "rtcore/settings/main_settings.h"
#include "rtcore/settings/quality.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>

namespace gui {
namespace {

using test::comes;

class SettingsPanelTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        window->preferences().set(pref::progressiveRendering, false);
        window->resize(900, 640);
    }
    void openWithPanel() {
        ASSERT_NO_FATAL_FAILURE(openAndRest());
        ASSERT_TRUE(comes([&] { return !window->editor().state().settings.isEmpty(); }));
        action(ActionId::SettingsPanel)->trigger();
        ASSERT_TRUE(comes([&] { return panel().isVisible(); }));
    }
    SettingsPanel& panel() { return *window->findChild<SettingsPanel*>(); }
    QAbstractButton& step(const char* name) { return *panel().quality().step(QString::fromLatin1(name)); }
    QString served(std::string_view setting) {
        return ask(window->session(), QStringLiteral("get ") + QString::fromStdString(std::string(setting)))
            .text;
    }
    bool isAt(const char* name) {
        return comes([&] { return step(name).isChecked(); });
    }
};

TEST_F(SettingsPanelTest, AQualityIsOneStepOfManySettings) {
    EXPECT_FALSE(step("good").isEnabled()) << "no server";
    ASSERT_NO_FATAL_FAILURE(openWithPanel());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("quality good")).done);
    ASSERT_TRUE(isAt("good"));
    const int before = window->editor().state().edits;
    step("final").click();
    ASSERT_TRUE(isAt("final"));
    EXPECT_FALSE(step("good").isChecked());
    for (const rtcore::QualityRow& row : rtcore::qualityTable())
        EXPECT_EQ(served(row.setting).toStdString(), row.of(rtcore::Quality::Final)) << row.setting;
    EXPECT_EQ(window->editor().state().edits, before + 1) << "one step of undo";
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(isAt("good"));
    EXPECT_EQ(served("antialiasing"), QStringLiteral("1"));
}

TEST_F(SettingsPanelTest, ANumberOfOnesOwnIsNoneOfTheThree) {
    ASSERT_NO_FATAL_FAILURE(openWithPanel());
    step("draft").click();
    ASSERT_TRUE(isAt("draft"));
    EXPECT_FALSE(panel().quality().saysCustom());
    qobject_cast<QSpinBox*>(panel().editor(QStringLiteral("maxDepth")))->setValue(17);
    ASSERT_TRUE(comes([&] { return panel().quality().saysCustom(); }));
    for (const char* each : {"draft", "good", "final"}) EXPECT_FALSE(step(each).isChecked());
    step("draft").click();
    EXPECT_TRUE(isAt("draft"));
    EXPECT_EQ(served("maxDepth"), QStringLiteral("3"));
}

TEST_F(SettingsPanelTest, TheRestIsUnderAFoldWhichIsRemembered) {
    ASSERT_NO_FATAL_FAILURE(openWithPanel());
    const auto seen = [&](std::string_view name) {
        return panel().editor(QString::fromStdString(std::string(name)))->isVisible();
    };
    for (const rtcore::MainSetting& each : rtcore::mainSettings()) EXPECT_TRUE(seen(each.name)) << each.name;
    EXPECT_FALSE(seen("maxDepth")) << "folded up at first";
    EXPECT_TRUE(panel().advanced().folded());
    panel().advanced().header().click();
    EXPECT_TRUE(seen("maxDepth"));
    {
        MainWindow other(name());
        EXPECT_FALSE(other.findChild<SettingsPanel*>()->advanced().folded());
    }
    panel().advanced().header().click();
    EXPECT_FALSE(seen("maxDepth"));
    MainWindow other(name());
    EXPECT_TRUE(other.findChild<SettingsPanel*>()->advanced().folded());
}

TEST_F(SettingsPanelTest, SlidersSetNumbersAndFollowThem) {
    ASSERT_NO_FATAL_FAILURE(openWithPanel());
    ValueSlider* depth = panel().slider(QStringLiteral("maxDepth"));
    ASSERT_NE(depth, nullptr);
    EXPECT_EQ(panel().slider(QStringLiteral("width")), nullptr) << "follows the window";
    EXPECT_EQ(panel().slider(QStringLiteral("exposure.value")), nullptr) << "has no two ends";
    EXPECT_EQ(panel().slider(QStringLiteral("shadows")), nullptr);
    const int before = window->editor().state().edits;
    for (const int value : {7, 9, 12}) depth->setValue(value);
    EXPECT_TRUE(comes([&] { return served("maxDepth") == QStringLiteral("12"); }));
    EXPECT_TRUE(comes([&] { return window->editor().state().edits == before + 1; })) << "one gesture";
    EXPECT_EQ(qobject_cast<QSpinBox*>(panel().editor(QStringLiteral("maxDepth")))->value(), 12);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("set maxDepth 500")).done);
    window->editor().refresh();
    EXPECT_TRUE(comes([&] { return depth->value() == depth->maximum(); })) << "ends where pages do";
    EXPECT_EQ(served("maxDepth"), QStringLiteral("500"));
}

TEST_F(SettingsPanelTest, ADoubleClickOnALabelLeadsBackToTheDefault) {
    ASSERT_NO_FATAL_FAILURE(openWithPanel());
    auto* key = qobject_cast<ValueBox*>(panel().editor(QStringLiteral("exposure.key")));
    key->setValue(0.5);
    ASSERT_TRUE(comes([&] { return served("exposure.key") == QStringLiteral("0.5"); }));
    ASSERT_TRUE(comes([&] { return panel().resetButton(QStringLiteral("exposure.key"))->isVisible(); }));
    for (QLabel* label : panel().findChildren<QLabel*>())
        if (label->buddy() == key) test::doubleClick(label);
    EXPECT_TRUE(comes([&] { return served("exposure.key") == QStringLiteral("0.18"); }));
}

TEST(ValueSliders, GoByFactorsWhereTheRangeIsWide) {
    ValueSlider even(0, 10, false), whole(1, 4, true), wide(1e-4, 100, false);
    QList<double> moved;
    for (ValueSlider* each : {&even, &whole, &wide})
        QObject::connect(each, &ValueSlider::moved, [&](double value) { moved.append(value); });
    even.setValue(even.maximum() / 2);
    whole.setValue(2);
    wide.setValue(wide.maximum() / 2);
    EXPECT_EQ(moved, (QList<double>{5, 3, 0.1}));
    moved.clear();
    for (ValueSlider* each : {&even, &whole, &wide}) each->showValue(1e9);
    EXPECT_TRUE(moved.isEmpty()) << "shown, not wanted";
    EXPECT_EQ(wide.value(), wide.maximum());
}

TEST(ImagesAtRest, AreOneChoiceOfThree) {
    Preferences preferences;
    for (const AtRest each : kAtRest) {
        setAtRest(preferences, each);
        EXPECT_EQ(atRest(preferences), each);
    }
    toggleAtRest(preferences, AtRest::Live);
    EXPECT_EQ(atRest(preferences), AtRest::Live);
    toggleAtRest(preferences, AtRest::Live);
    EXPECT_EQ(atRest(preferences), AtRest::Global) << "as before";
    toggleAtRest(preferences, AtRest::Global);
    EXPECT_EQ(atRest(preferences), AtRest::Refined);
}

TEST_F(SettingsPanelTest, TheImageAtRestIsChosenInPanelAndMenuAlike) {
    QComboBox* box = nullptr;
    for (QComboBox* each : panel().findChildren<QComboBox*>())
        if (each->count() == static_cast<int>(kAtRest.size()) &&
            each->itemText(0) == atRestText(AtRest::Live))
            box = each;
    ASSERT_NE(box, nullptr);
    action(ActionId::AtRestGlobal)->trigger();
    EXPECT_EQ(box->currentIndex(), static_cast<int>(AtRest::Global));
    EXPECT_TRUE(action(ActionId::AtRestGlobal)->isChecked());
    EXPECT_FALSE(action(ActionId::AtRestLive)->isChecked());
    emit box->activated(static_cast<int>(AtRest::Refined));
    EXPECT_TRUE(action(ActionId::AtRestRefined)->isChecked());
    action(ActionId::AtRestRefined)->trigger();
    EXPECT_TRUE(action(ActionId::AtRestRefined)->isChecked()) << "one is always on";
}

} // namespace
} // namespace gui
