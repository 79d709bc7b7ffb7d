/// The sky, looks and environment maps in the window, with a real server.
#include "gui/lit_scene.h"
#include "gui/window_support.h"

#include "gui/models/installed_skies.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/lights_panel.h"
#include "gui/panels/sky_fields.h"
#include "gui/panels/value_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QImage>
#include <QMimeData>
#include <QSlider>
#include <QTimeEdit>
#include <QUrl>

#include <gtest/gtest.h>

#include <filesystem>

namespace gui {
namespace {

using test::comes;

class SkyTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        test::writeLitScene(folder());
    }
    const SceneState& state() { return window->editor().state(); }
    LightsPanel& panel() { return *window->findChild<LightsPanel*>(); }
    SkyFields& fields() { return panel().sky(); }
    bool edits(int count) {
        return comes([&] { return state().edits == count; });
    }
    void drop(const QString& path) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&*window, &enter);
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&*window, &event);
    }
};

/// Types over the whole of a field, as a user would.
void typeOver(QAbstractSpinBox& field, const QString& text, Qt::Key end = Qt::Key_Tab) {
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, end);
}

TEST_F(SkyTest, ATimeAndADateMayBeTypedAsAWhole) {
    openAndRest("lit.scn");
    action(ActionId::LightsPanel)->trigger();
    panel().computedSky().click();
    ASSERT_TRUE(edits(1));
    ASSERT_TRUE(comes([&] { return fields().time().isVisible(); }));
    const auto is = [&](int hour, int minute) {
        return comes([&] { return state().sky->date->second == (60 * hour + minute) * 60; }) &&
               fields().time().text() == QTime(hour, minute).toString(QStringLiteral("HH:mm"));
    };
    typeOver(fields().time(), QStringLiteral("17:00"));
    EXPECT_TRUE(is(17, 0)) << fields().time().text().toStdString();
    EXPECT_FALSE(fields().time().hasFocus());
    typeOver(fields().time(), QStringLiteral("7:05"), Qt::Key_Return);
    EXPECT_TRUE(is(7, 5));
    typeOver(fields().time(), QStringLiteral("1730"));
    EXPECT_TRUE(is(17, 30));
    typeOver(fields().time(), QStringLiteral("9"));
    EXPECT_TRUE(is(9, 0));
    for (const char* wrong : {"25:00", "noon", "12:99", ":"}) {
        typeOver(fields().time(), QLatin1String(wrong));
        EXPECT_EQ(fields().time().text(), QStringLiteral("09:00")) << wrong << ": the value before";
    }
    fields().time().setFocus();
    QTest::keyClick(&fields().time(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&fields().time(), Qt::Key_Delete);
    QTest::keyClicks(&fields().time(), QStringLiteral("6.15"));
    fields().latitude().setFocus(); // a click elsewhere
    EXPECT_TRUE(is(6, 15));
    fields().time().setFocus();
    QTest::keyClick(&fields().time(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&fields().time(), QStringLiteral("22:00"));
    QTest::keyClick(&fields().time(), Qt::Key_Escape);
    EXPECT_EQ(fields().time().text(), QStringLiteral("06:15"));
    typeOver(fields().date(), QStringLiteral("2024-02-29"));
    EXPECT_TRUE(comes([&] { return state().sky->date->month == 2 && state().sky->date->day == 29; }));
    typeOver(fields().date(), QStringLiteral("2023-02-29"));
    EXPECT_EQ(fields().date().date(), QDate(2024, 2, 29));
    typeOver(fields().date(), QStringLiteral("20251224"));
    EXPECT_TRUE(comes([&] { return state().sky->date->year == 2025 && state().sky->date->day == 24; }));
    // By its parts as ever.
    fields().time().setFocus();
    fields().time().setCurrentSection(QDateTimeEdit::MinuteSection);
    QTest::keyClick(&fields().time(), Qt::Key_Up);
    EXPECT_TRUE(is(6, 16));
}

TEST_F(SkyTest, FieldsReachTheServerAndFollowIt) {
    openAndRest("lit.scn");
    action(ActionId::LightsPanel)->trigger();
    ASSERT_FALSE(panel().computedSky().isChecked());
    EXPECT_FALSE(fields().turbidity().isVisible());
    panel().computedSky().click();
    ASSERT_TRUE(edits(1));
    ASSERT_TRUE(state().sky && state().sky->date);
    ASSERT_TRUE(comes([&] { return fields().turbidity().isVisible(); }));
    fields().hour().setValue(fields().hour().maximum() * 7 / 24);
    ASSERT_TRUE(edits(2));
    EXPECT_EQ(state().sky->date->second, 7 * 3600);
    EXPECT_EQ(fields().time().time(), QTime(7, 0));
    fields().time().setTime(QTime(8, 31));
    ASSERT_TRUE(comes([&] { return state().sky->date->second == (8 * 60 + 31) * 60; }));
    fields().date().setDate(QDate(2024, 2, 29));
    ASSERT_TRUE(comes([&] { return state().sky->date->month == 2 && state().sky->date->day == 29; }));
    fields().latitude().setValue(-33.25);
    ASSERT_TRUE(comes([&] { return state().sky->date->latitude == -33.25; }));
    fields().turbidity().setValue(6);
    ASSERT_TRUE(comes([&] { return state().sky->turbidity == 6; }));
    fields().ground().click();
    ASSERT_TRUE(comes([&] { return state().sky->ground; }));
    const int made = state().edits;
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(edits(made - 1));
    EXPECT_FALSE(fields().ground().isChecked());
}

TEST_F(SkyTest, SkyMapsAndNoneAreOneChoice) {
    openAndRest("lit.scn");
    action(ActionId::LightsPanel)->trigger();
    const auto chosen = [&](const QAbstractButton* button) {
        return comes([&] { return button->isChecked(); });
    };
    ASSERT_TRUE(chosen(panel().environment(0)));
    panel().computedSky().click();
    ASSERT_TRUE(edits(1));
    EXPECT_TRUE(chosen(&panel().computedSky()));
    EXPECT_FALSE(panel().environment(0)->isChecked());
    EXPECT_EQ(panel().environment(2), nullptr) << "the sky's own environment is no map";
    panel().environment(1)->click();
    ASSERT_TRUE(edits(2));
    EXPECT_TRUE(chosen(panel().environment(1)));
    EXPECT_FALSE(panel().computedSky().isChecked());
    panel().computedSky().click();
    ASSERT_TRUE(edits(3));
    EXPECT_TRUE(chosen(&panel().computedSky())) << "the same sky again";
    panel().noBackground().click();
    ASSERT_TRUE(edits(4));
    EXPECT_TRUE(chosen(&panel().noBackground()));
    EXPECT_FALSE(state().sky);
    EXPECT_FALSE(panel().computedSky().isChecked() || panel().environment(0)->isChecked());
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(chosen(&panel().computedSky()));
}

TEST_F(SkyTest, TheSunStaysWhereItIsUntilItIsMoved) {
    openAndRest("lit.scn");
    action(ActionId::LightsPanel)->trigger();
    panel().computedSky().click();
    ASSERT_TRUE(edits(1));
    emit fields().sun().activated(1);
    ASSERT_TRUE(edits(2));
    EXPECT_FALSE(state().sky->date);
    EXPECT_GT(state().sky->direction.y, 0.8F) << "at noon";
    ASSERT_TRUE(comes([&] { return fields().direction(0).isVisible(); }));
    EXPECT_FALSE(fields().time().isVisible());
    fields().direction(0).setValue(2);
    ASSERT_TRUE(comes([&] { return state().sky->direction.x == 2; }));
    emit fields().sunAheadWanted();
    ASSERT_TRUE(comes([&] { return state().sky->direction.z < -0.9F; })) << "where the camera looks";
}

TEST_F(SkyTest, LooksOfTheMenuTakeThePlaceOfAllLight) {
    openAndRest("lit.scn");
    action(ActionId::LookStudio)->trigger();
    ASSERT_TRUE(comes([&] { return state().lights.size() == 3 && state().edits == 1; }));
    EXPECT_EQ(window->view().told(), QStringLiteral("Lit as in a studio"));
    action(ActionId::LightsPanel)->trigger();
    ASSERT_TRUE(comes([&] { return state().sky && state().sky->studio; })) << "lit.scn is an object";
    EXPECT_FALSE(panel().computedSky().isChecked());
    EXPECT_TRUE(fields().strength().isVisible());
    EXPECT_FALSE(fields().turbidity().isVisible());
    panel().computedSky().click();
    ASSERT_TRUE(comes([&] { return state().sky && !state().sky->studio; })) << "a sky in its place";
    action(ActionId::LookSky)->trigger();
    ASSERT_TRUE(comes([&] { return state().sky.has_value(); }));
    action(ActionId::NoEnvironment)->trigger();
    ASSERT_TRUE(comes([&] { return !state().sky; }));
    action(ActionId::LookHeadlight)->trigger();
    ASSERT_TRUE(comes([&] { return state().lights.size() == 1; }));
}

TEST_F(SkyTest, AMapThatIsDroppedLightsTheScene) {
    drop(file("map.hdr"));
    EXPECT_FALSE(window->notice().text().isEmpty()) << "there is no scene yet";
    openAndRest("lit.scn");
    ASSERT_TRUE(comes([&] { return state().environments.size() == 2; }));
    drop(file("none.hdr"));
    ASSERT_TRUE(comes([&] { return window->notice().text().contains(QStringLiteral("none.hdr")); }));
    QImage map(8, 4, QImage::Format_RGB32);
    map.fill(Qt::red);
    ASSERT_TRUE(map.save(file("map.png")));
    drop(file("map.png"));
    ASSERT_TRUE(comes([&] { return state().environments.size() == 3; }));
    ASSERT_TRUE(state().map);
    EXPECT_TRUE(state().environments.last().on);
    action(ActionId::LightsPanel)->trigger();
    ASSERT_TRUE(fields().mapRotation().isVisible());
    fields().mapRotation().setValue(45);
    ASSERT_TRUE(comes([&] { return state().map && state().map->rotation == 45; }));
    fields().mapStrength().setValue(2);
    ASSERT_TRUE(comes([&] { return state().map && state().map->strength == 2; }));
}

TEST(InstalledSkies, AreThoseThatLieThere) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "environments/generated");
    test::writeText(folder / "environments/generated/sunset.hdr", "#?RADIANCE");
    const QList<InstalledSky> skies = installedSkiesIn(QString::fromStdString(folder.path().string()));
    ASSERT_EQ(skies.size(), 1);
    EXPECT_EQ(skies[0].name, QStringLiteral("Sunset"));
    EXPECT_TRUE(isEnvironmentFile(skies[0].path));
    EXPECT_TRUE(isEnvironmentFile(QStringLiteral("A.JPG")));
    EXPECT_FALSE(isEnvironmentFile(QStringLiteral("a.scn")));
    EXPECT_FALSE(isEnvironmentFile(QStringLiteral("a.glb")));
}

} // namespace
} // namespace gui
