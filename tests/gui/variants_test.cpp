/// The menu of variants, with a real server.
#include "gui/lit_scene.h"
#include "gui/window_support.h"

#include "gui/dialogs/variant_name_dialog.h"
#include "gui/operations/scene_editor.h"

#include <QLineEdit>
#include <QMenu>

#include <gtest/gtest.h>

namespace gui {
namespace {

using test::comes;

class VariantsTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        test::writeLitScene(folder());
    }
    const SceneState& state() { return window->editor().state(); }
    QMenu& menu() { return *window->actions().variants(); }
    QAction* entry(const QString& text) {
        for (QAction* each : menu().actions())
            if (each->text().remove(QLatin1Char('&')) == text) return each;
        return nullptr;
    }
    bool has(const QString& text) {
        return comes([&] { return entry(text) != nullptr; });
    }
    void typeName(const QString& name) {
        VariantNameDialog* dialog = nullptr;
        ASSERT_TRUE(comes([&] {
            for (auto* each : window->findChildren<VariantNameDialog*>())
                if (each->isVisible()) dialog = each;
            return dialog != nullptr;
        }));
        dialog->name().setText(name);
        dialog->accept();
    }
    void keep(const QString& name) {
        action(ActionId::KeepVariant)->trigger();
        typeName(name);
        ASSERT_TRUE(comes([&] { return state().variants.contains(name); }));
    }
};

TEST_F(VariantsTest, KeepsSwitchesAndRemoves) {
    openAndRest("lit.scn");
    EXPECT_FALSE(menu().isEnabled());
    const int light = state().lights[0].id;
    window->editor().switchLight(light, false);
    ASSERT_TRUE(comes([&] { return !state().lights[0].on; }));
    keep(QStringLiteral("dark & late"));
    ASSERT_TRUE(menu().isEnabled());
    ASSERT_TRUE(has(QStringLiteral("Without a variant")));
    EXPECT_EQ(menu().actions()[1]->text(), QStringLiteral("dark && late")) << "no mnemonic";
    EXPECT_TRUE(menu().actions()[1]->isChecked());
    entry(QStringLiteral("Without a variant"))->trigger();
    ASSERT_TRUE(comes([&] { return state().lights[0].on && state().variant.isEmpty(); }));
    EXPECT_EQ(menu().actions().size(), 2) << "nothing to change";
    menu().actions()[1]->trigger();
    ASSERT_TRUE(comes([&] { return !state().lights[0].on && !state().variant.isEmpty(); }));
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(comes([&] { return state().lights[0].on && state().variant.isEmpty(); }));
    action(ActionId::Redo)->trigger();
    ASSERT_TRUE(comes([&] { return state().variant == QStringLiteral("dark & late"); }));
    menu().actions()[4]->trigger();
    typeName(QStringLiteral("night"));
    ASSERT_TRUE(comes([&] { return state().variant == QStringLiteral("night"); }));
    entry(QStringLiteral("Remove “night”"))->trigger();
    ASSERT_TRUE(comes([&] { return state().variants.isEmpty(); }));
    EXPECT_FALSE(menu().isEnabled());
    EXPECT_FALSE(state().lights[0].on);
}

TEST_F(VariantsTest, TellsWhereNothingDiffers) {
    openAndRest("lit.scn");
    action(ActionId::KeepVariant)->trigger();
    typeName(QStringLiteral("same"));
    EXPECT_TRUE(comes([&] { return window->notice().text().contains(QStringLiteral("nothing differs")); }))
        << window->notice().text().toStdString();
}

} // namespace
} // namespace gui
