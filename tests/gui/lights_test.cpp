/// Lights that are edited in their panel and by their marks, with a real server.
#include "gui/lit_scene.h"
#include "gui/window_support.h"

#include "gui/operations/scene_editor.h"
#include "gui/panels/column_area.h"
#include "gui/panels/light_fields.h"
#include "gui/panels/lights_panel.h"
#include "gui/panels/power_field.h"
#include "gui/panels/value_box.h"
#include "gui/view/input_capture.h"
#include "gui/view/light_handles.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>

#include <gtest/gtest.h>

namespace gui {
namespace {

using test::comes;

class LightsTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        test::writeLitScene(folder());
        openAndRest("lit.scn");
        ASSERT_TRUE(comes([&] { return state().lights.size() == 2; }));
    }
    const SceneState& state() { return window->editor().state(); }
    LightsPanel& panel() { return *window->findChild<LightsPanel*>(); }
    LightHandles& handles() { return *window->findChild<LightHandles*>(); }
    rtcore::Light light(int id) {
        const ShownLight* found = lightOf(state(), id);
        return found != nullptr && found->description ? found->description->light : rtcore::Light();
    }
    bool edits(int count) {
        return comes([&] { return state().edits == count; });
    }
    void drag(const QPointF& from, const QPointF& by, Qt::KeyboardModifiers modifiers = {}) {
        QWidget* view = &window->view();
        QTest::mousePress(view, Qt::LeftButton, modifiers, from.toPoint());
        for (int i = 1; i <= 4; ++i) {
            const QPoint at = (from + by * i / 4).toPoint();
            QMouseEvent event(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                              modifiers);
            QApplication::sendEvent(view, &event);
            QTest::qWait(20);
        }
        QTest::mouseRelease(view, Qt::LeftButton, modifiers, (from + by).toPoint());
    }
};

// Numbers with their units, also the longer one of a directional light.
TEST_F(LightsTest, FieldsHaveRoomForTheirTexts) {
    action(ActionId::LightsPanel)->trigger();
    LightFields& fields = panel().fields();
    const auto fits = [](const QWidget& field, const QString& text, int around) {
        return field.fontMetrics().horizontalAdvance(text) + around <= field.width();
    };
    panel().lights().setCurrentRow(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        fields.position(axis).setValue(-12.345);
        const auto* edit = fields.position(axis).findChild<QLineEdit*>();
        EXPECT_TRUE(comes([&] { return fits(*edit, QStringLiteral("-12.345 m"), 0); })) << edit->width();
    }
    ASSERT_TRUE(comes([&] { return light(1).position == rtcore::Vec3{-12.345F, -12.345F, -12.345F}; }));
    ask(window->session(), QStringLiteral("light kind 1 directional"));
    ASSERT_TRUE(comes([&] { return light(1).kind == rtcore::LightKind::Directional; }));
    fields.power().unit().setCurrentIndex(1);
    constexpr int kArrow = 16; // pixels
    EXPECT_TRUE(comes([&] { return fits(fields.power().unit(), QStringLiteral("W/m²"), kArrow); }));
}

TEST_F(LightsTest, FieldsOfTheSelectedLightReachTheServer) {
    action(ActionId::LightsPanel)->trigger();
    LightFields& fields = panel().fields();
    panel().lights().setCurrentRow(1);
    ASSERT_TRUE(fields.isVisible());
    EXPECT_EQ(fields.position(0).value(), 4);
    fields.position(1).setValue(3.5);
    ASSERT_TRUE(edits(1));
    EXPECT_EQ(light(2).position, (rtcore::Vec3{4, 3.5F, 3}));
    fields.power().value().setValue(200);
    ASSERT_TRUE(edits(2));
    EXPECT_NEAR(fields.power().value().value(), 200, 0.01);
    fields.hasTemperature().click();
    ASSERT_TRUE(edits(3));
    EXPECT_EQ(lightOf(state(), 2)->description->temperature, 4000);
    fields.kind().setCurrentIndex(static_cast<int>(rtcore::LightKind::Spot));
    emit fields.kind().activated(static_cast<int>(rtcore::LightKind::Spot));
    ASSERT_TRUE(edits(4));
    EXPECT_EQ(light(2).kind, rtcore::LightKind::Spot);
    EXPECT_TRUE(fields.angle(0).isVisible());
    EXPECT_NEAR(fields.power().value().value(), 200, 0.01);
    fields.name().setText(QStringLiteral("a \"bulb\""));
    emit fields.name().editingFinished();
    ASSERT_TRUE(edits(5));
    EXPECT_EQ(panel().light(1)->text(), QStringLiteral("a \"bulb\""));
    EXPECT_EQ(action(ActionId::Undo)->text(), QStringLiteral("&Undo: name of light 2"));
    for (int left = 4; left >= 0; --left) {
        action(ActionId::Undo)->trigger();
        ASSERT_TRUE(edits(left));
    }
    EXPECT_EQ(light(2).position, (rtcore::Vec3{4, 5, 3}));
    EXPECT_EQ(light(2).kind, rtcore::LightKind::Point);
}

/// A light in a model of millimetres.
TEST_F(LightsTest, FieldsAreInMetresAndLumens) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("units mm")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light add sphere at 1000 2000 500")).done);
    action(ActionId::LightsPanel)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return state().lights.size() == 3; }));
    panel().select(3);
    LightFields& fields = panel().fields();
    EXPECT_EQ(fields.position(1).text(), QStringLiteral("2 m"));
    EXPECT_EQ(fields.size(0).text(), QStringLiteral("0.06 m"));
    EXPECT_EQ(fields.power().value().value(), 800);
    EXPECT_EQ(fields.power().unit().currentText(), QStringLiteral("lm"));
    fields.power().unit().setCurrentIndex(1);
    EXPECT_NEAR(fields.power().value().value(), 800 / 683.0, 1e-4);
    const int before = state().edits;
    fields.power().value().setValue(5);
    ASSERT_TRUE(edits(before + 1));
    EXPECT_NEAR(light(3).intensity.g, 5e6F / 12.566371F, 10);
    fields.position(0).setValue(2.5);
    ASSERT_TRUE(edits(before + 2));
    EXPECT_EQ(light(3).position, (rtcore::Vec3{2500, 2000, 500}));
    fields.size(0).setValue(0.1);
    ASSERT_TRUE(edits(before + 3));
    EXPECT_EQ(light(3).radius, 100);
}

TEST_F(LightsTest, MirrorsShowWhatHasASurface) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light add rectangle")).done);
    action(ActionId::LightsPanel)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return state().lights.size() == 3; }));
    panel().select(3);
    LightFields& fields = panel().fields();
    ASSERT_TRUE(fields.mirrored().isVisible());
    fields.mirrored().click();
    ASSERT_TRUE(comes([&] { return light(3).mirrored != 0; }));
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(comes([&] { return light(3).mirrored == 0; }));
    EXPECT_FALSE(fields.mirrored().isChecked());
    panel().select(1);
    EXPECT_FALSE(fields.mirrored().isVisible()) << "a point has none";
}

TEST_F(LightsTest, TheSizeOfADirectionalLightIsItsAngle) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light add directional")).done);
    action(ActionId::LightsPanel)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return state().lights.size() == 3; }));
    panel().select(3);
    LightFields& fields = panel().fields();
    EXPECT_TRUE(fields.size(0).isVisible());
    EXPECT_FALSE(fields.size(1).isVisible());
    EXPECT_EQ(fields.power().unit().currentText(), QStringLiteral("lx"));
    fields.size(0).setValue(0.53);
    ASSERT_TRUE(comes([&] { return light(3).discSine > 0; }));
    EXPECT_NEAR(light(3).discSine, 0.004625F, 1e-6);
    EXPECT_EQ(fields.size(0).text(), QStringLiteral("0.53°"));
}

TEST_F(LightsTest, FieldsFitIntoTheirPanel) {
    action(ActionId::LightsPanel)->trigger();
    const auto* area = panel().findChild<ColumnArea*>();
    for (const char* kind : {"point", "rectangle", "spot", "directional"}) {
        emit panel().addWanted(kind);
        const int id = static_cast<int>(state().lights.size()) + 1;
        ASSERT_TRUE(comes([&] { return panel().selected() == id && panel().fields().isVisible(); })) << kind;
        EXPECT_TRUE(comes([&] {
            return area->viewport()->width() >= area->widget()->minimumSizeHint().width() &&
                   area->widget()->width() == area->viewport()->width();
        })) << kind;
        EXPECT_FALSE(area->horizontalScrollBar()->isVisible()) << kind;
    }
}

TEST_F(LightsTest, WithoutAServerNothingIsToBeChanged) {
    action(ActionId::LightsPanel)->trigger();
    EXPECT_TRUE(panel().isEnabled());
    const Answer answer = ask(window->session(), QStringLiteral("exit"));
    ASSERT_TRUE(answer.done) << answer.text.toStdString();
    EXPECT_TRUE(comes([&] { return !window->session().live(); }));
    EXPECT_FALSE(panel().isEnabled());
}

TEST_F(LightsTest, ValuesThatFollowAHandAreOneStep) {
    panel().select(1);
    for (const double power : {100.0, 200.0, 300.0, 400.0}) {
        panel().fields().power().value().setValue(power);
        QTest::qWait(10);
    }
    ASSERT_TRUE(comes([&] { return std::abs(light(1).intensity.g * 683 - 400 / 12.566371F) < 0.01F; }));
    EXPECT_EQ(state().edits, 1);
}

TEST_F(LightsTest, AreAddedCopiedAndRemoved) {
    emit panel().addWanted("sphere");
    ASSERT_TRUE(comes([&] { return state().lights.size() == 3; }));
    ASSERT_TRUE(comes([&] { return panel().selected() == 3; }));
    EXPECT_EQ(light(3).kind, rtcore::LightKind::Sphere);
    emit panel().copyWanted(1);
    ASSERT_TRUE(comes([&] { return panel().selected() == 4; }));
    EXPECT_EQ(light(4).position, light(1).position);
    emit panel().removeWanted(1);
    ASSERT_TRUE(comes([&] { return state().lights.size() == 3; }));
    EXPECT_EQ(lightOf(state(), 1), nullptr);
    EXPECT_EQ(panel().selected(), 4) << "ids stay";
    emit panel().removeWanted(4);
    EXPECT_TRUE(comes([&] { return panel().selected() == 0; }));
}

TEST_F(LightsTest, AMarkSelectsAndMovesItsLightInOneStep) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light move 1 at 0 1 2")).done);
    action(ActionId::LightMarks)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return light(1).position == rtcore::Vec3{0, 1, 2}; }));
    ASSERT_TRUE(comes([&] { return status().idle; }));
    const std::optional<QPointF> place = handles().place(1);
    ASSERT_TRUE(place);
    QTest::mouseClick(&window->view(), Qt::LeftButton, {}, place->toPoint());
    EXPECT_EQ(panel().selected(), 1);
    EXPECT_FALSE(window->view().input().captured()) << "the mouse stays free";
    EXPECT_EQ(state().edits, 1) << "a click moves nothing";
    drag(*place, {40, 0});
    ASSERT_TRUE(edits(2));
    ASSERT_TRUE(comes([&] { return light(1).position.x > 0.1F; }));
    EXPECT_NEAR(light(1).position.y, 1, 0.05);
    const std::optional<QPointF> moved = handles().place(1);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->x(), place->x() + 40, 2) << "it follows the hand";
    EXPECT_EQ(state().edits, 2);
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(comes([&] { return light(1).position == rtcore::Vec3{0, 1, 2}; }));
}

TEST_F(LightsTest, AHandleMovesAlongItsAxis) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light move 1 at 0 1 2")).done);
    action(ActionId::LightMarks)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return light(1).position == rtcore::Vec3{0, 1, 2}; }));
    emit handles().picked(1);
    const std::optional<QPointF> end = handles().handle(1);
    ASSERT_TRUE(end);
    drag(*end, {13, -30});
    ASSERT_TRUE(comes([&] { return light(1).position.y > 1.1F; }));
    EXPECT_EQ(light(1).position.x, 0);
    EXPECT_EQ(light(1).position.z, 2);
}

TEST_F(LightsTest, ShiftMovesAlongSurfaces) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light move 1 at 0 1 2")).done);
    action(ActionId::LightMarks)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return light(1).position == rtcore::Vec3{0, 1, 2}; }));
    const std::optional<QPointF> place = handles().place(1);
    ASSERT_TRUE(place);
    drag(*place, {0, 60}, Qt::ShiftModifier);
    ASSERT_TRUE(comes([&] { return light(1).position != rtcore::Vec3{0, 1, 2}; }));
    EXPECT_LT(light(1).position.y, 0.5F) << "near the floor";
}

TEST_F(LightsTest, ADirectionalLightIsMarkedWhereItComesFrom) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera look-at 0 1 6 0 1 0")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light add directional")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light aim 3 along 0.2 -0.1 1")).done);
    action(ActionId::LightMarks)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return light(3).direction.x > 0; }));
    ASSERT_TRUE(comes([&] { return status().idle && handles().place(3).has_value(); }));
    const QPointF middle = window->view().pictureArea().center(), place = *handles().place(3);
    EXPECT_LT(place.x(), middle.x()) << "it shines to the right";
    EXPECT_LT(place.y(), middle.y()) << "and downwards";
    EXPECT_FALSE(handles().handle(0));
    const int edits = state().edits;
    drag(place, {30, 0});
    ASSERT_TRUE(comes([&] { return std::abs(handles().place(3)->x() - place.x() - 30) < 2; }));
    ASSERT_TRUE(comes([&] { return light(3).direction.x < 0.19F && state().edits == edits + 1; }));
    EXPECT_LT(light(3).direction.y, 0);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light aim 3 along 0 0 -1")).done);
    window->editor().refresh();
    EXPECT_TRUE(comes([&] { return !handles().place(3); })) << "behind the camera";
}

TEST_F(LightsTest, TheMarkOfTheSunTurnsTheSky) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera look-at 0 1 6 0 2 0")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("sky direction 0.1 0.3 -1")).done);
    action(ActionId::LightMarks)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return state().sky && state().lights.size() == 3; }));
    const int sun = state().lights.last().id;
    ASSERT_TRUE(comes([&] { return status().idle && handles().place(sun).has_value(); }));
    const rtcore::Vec3 before = light(sun).direction;
    drag(*handles().place(sun), {-40, 0});
    ASSERT_TRUE(comes([&] { return light(sun).direction.x > before.x + 0.05F; }));
    EXPECT_FALSE(state().sky->date);
    EXPECT_NEAR(state().sky->direction.x, -light(sun).direction.x, 1e-4);
    EXPECT_EQ(state().undo, QStringLiteral("sky direction"));
}

TEST_F(LightsTest, TheMarkOfAnotherLightThatIsCalledSunTurnsThatLight) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera look-at 0 1 6 0 2 0")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("sky direction 0.1 0.3 1")).done);
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return state().sun != 0; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light remove %1").arg(state().sun)).done);
    const Answer added = ask(window->session(), QStringLiteral("light add directional at 0 0 0"));
    const int id = added.text.toInt();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light name %1 sun").arg(id)).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("light aim %1 along -0.1 -0.3 1").arg(id)).done);
    action(ActionId::LightMarks)->trigger();
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return lightOf(state(), id) != nullptr && light(id).direction.z > 0; }));
    EXPECT_EQ(state().lights.size(), 3);
    EXPECT_EQ(state().sun, 0);
    const rtcore::Sky sky = *state().sky;
    ASSERT_TRUE(comes([&] { return status().idle && handles().place(id).has_value(); }));
    const rtcore::Vec3 before = light(id).direction;
    drag(*handles().place(id), {-40, 0});
    ASSERT_TRUE(comes([&] { return light(id).direction.x > before.x + 0.05F; }));
    EXPECT_EQ(state().sky, sky);
    EXPECT_EQ(state().undo, QStringLiteral("light aim %1").arg(id));
}

TEST_F(LightsTest, WithoutMarksAClickIsTheCameras) {
    window->view().input().setHand(Hand::Looks);
    QTest::mouseClick(&window->view(), Qt::LeftButton);
    EXPECT_TRUE(window->view().input().captured());
}

} // namespace
} // namespace gui
