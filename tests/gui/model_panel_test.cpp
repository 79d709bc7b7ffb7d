// The model's parts and materials in the window: read, hidden, isolated, changed, selected in the image.
#include "gui/gui_support.h"

#include "gui/main_window.h"
#include "gui/models/model_lists.h"
#include "gui/operations/actions.h"
#include "gui/panels/material_fields.h"
#include "gui/panels/model_panel.h"
#include "gui/panels/model_search.h"
#include "gui/panels/value_box.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include "process/sample_scene.h"

#include <QAction>
#include <QCheckBox>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <optional>

namespace {

using namespace test;
using namespace gui;

TEST(ModelLists, AreRead) {
    const QList<PartRow> parts =
        readParts(QStringLiteral("1 shown 480 house/front door\n2 hidden 7\nnonsense\n3 shown 1 x"));
    ASSERT_EQ(parts.size(), 3);
    EXPECT_EQ(parts[0], (PartRow{1, false, 480, QStringLiteral("house/front door")}));
    EXPECT_EQ(parts[1], (PartRow{2, true, 7, QString()}));
    const QList<MaterialRow> materials = readMaterials(QStringLiteral("1 - oak\n2 edited\n"));
    ASSERT_EQ(materials.size(), 2);
    EXPECT_EQ(materials[1], (MaterialRow{2, true, QString()}));
    const auto seen = readSeen(QStringLiteral("part 12 house/door\nmaterial 3 oak"));
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->part, 12);
    EXPECT_EQ(seen->material, 3);
    EXPECT_FALSE(readSeen(QStringLiteral("nothing")));
}

TEST(ModelLists, AMarkOutlinesItsMask) {
    const QColor colour(255, 160, 40);
    const QImage mark = readMark(QStringLiteral("5 5 6 3 2 3 2 3 6"), colour);
    ASSERT_EQ(mark.size(), QSize(5, 5));
    EXPECT_EQ(mark.pixelColor(0, 0).alpha(), 0);
    EXPECT_EQ(mark.pixelColor(1, 1), colour);
    EXPECT_LT(mark.pixelColor(2, 2).alpha(), 100) << "inside it is a veil";
    EXPECT_GT(mark.pixelColor(2, 2).alpha(), 0);
    for (const char* wrong : {"", "5 5", "5 5 6 3", "5 5 25", "5 5 30", "-1 5 6", "99999 99999 1"})
        EXPECT_TRUE(readMark(QString::fromLatin1(wrong), colour).isNull()) << wrong;
}

TEST(ModelSearch, TextIsAPartOfANameAndAPatternAllOfIt) {
    const auto meant = [](const char* text, const char* name) {
        return isMeant(QString::fromUtf8(text), QString::fromUtf8(name));
    };
    for (const char* all :
         {"", "  ", "*", "DOOR", " front d", "house/f", "*door", "house/*", "f?ont*", "front door"})
        EXPECT_TRUE(meant(all, "house/Front Door")) << all;
    for (const char* none : {"window", "door*", "?", "[f]*", "house/"})
        EXPECT_FALSE(meant(none, "Front Door")) << none;
    EXPECT_TRUE(meant("dve\xC5\x98", "Dve\xC5\x99"
                                     "e"))
        << "of other letters, too";
    EXPECT_TRUE(meant("[f]*", "[F] 2")) << "brackets are letters";
}

class ModelPanelTest : public GuiTest {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        writeText(folder() / "m.mtl", "newmtl red\nKd 0.8 0.1 0.1\nnewmtl blue\nKd 0.1 0.1 0.8\n");
        writeText(folder() / "m.obj",
                  "mtllib m.mtl\nv -4 -4 0\nv 4 -4 0\nv 4 4 0\nv -4 4 0\nv -1 -1 1\nv 1 -1 1\n"
                  "v 1 1 1\nv -1 1 1\no wall\nusemtl red\nf 1 2 3 4\no sign\nusemtl blue\n"
                  "f 5 6 7 8\n");
        writeText(folder() / "m.scn",
                  "version = 2\nmodel = \"m.obj\"\nambient = [1, 1, 1]\n[camera]\n"
                  "eye = [0, 0, 6]\nlookAt = [0, 0, 0]\n[live]\nexposure.mode = \"fixed\"\n");
        window.emplace(name());
        window->preferences().set(pref::followWindowSize, false);
        window->resize(1000, 700);
        window->show();
        window->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
        window->open(file("m.scn"));
        ASSERT_TRUE(shows(window->session())) << window->notice().text().toStdString();
        window->actions()[ActionId::ModelPanel]->trigger();
        ASSERT_TRUE(comes([&] { return panel().parts().topLevelItemCount() == 2; }));
        ASSERT_TRUE(comes([&] { return panel().materials().topLevelItemCount() == 2; }));
    }
    void TearDown() override {
        window->close();
        window.reset();
    }
    ModelPanel& panel() { return *window->findChild<ModelPanel*>(); }
    QTreeWidgetItem& part(int number) { return *panel().parts().topLevelItem(number); }
    QString told(const char* command) { return ask(window->session(), QString::fromLatin1(command)).text; }
    bool becomes(const char* command, const char* wanted) {
        return comes([&] { return told(command) == QLatin1String(wanted); });
    }
    /// The right button at a fraction of the image.
    void pick(double x, double y) {
        const QSize size = window->view().size();
        const QPoint at(static_cast<int>(x * size.width()), static_cast<int>(y * size.height()));
        QTest::mouseClick(&window->view(), Qt::RightButton, {}, at);
    }
    void undo() {
        QAction* action = window->actions()[ActionId::Undo];
        ASSERT_TRUE(comes([&] { return action->isEnabled(); }));
        action->trigger();
    }
    QAction* menuAction(const char* text) {
        for (const QMenu* menu : window->findChildren<QMenu*>()) {
            if (!menu->isVisible()) continue;
            for (QAction* action : menu->actions()) {
                if (action->text() == QLatin1String(text)) return action;
            }
        }
        return nullptr;
    }

    std::optional<MainWindow> window;
};

TEST_F(ModelPanelTest, ACheckBoxHidesAndUndoShows) {
    EXPECT_EQ(part(1).text(0), QStringLiteral("sign"));
    part(1).setCheckState(0, Qt::Unchecked);
    EXPECT_TRUE(becomes("parts", "1 shown 2 wall\n2 hidden 2 sign"));
    undo();
    EXPECT_TRUE(becomes("parts", "1 shown 2 wall\n2 shown 2 sign"));
    EXPECT_TRUE(comes([&] { return part(1).checkState(0) == Qt::Checked; }));
    EXPECT_TRUE(ask(window->session(), QStringLiteral("part isolate sign")).done);
    EXPECT_TRUE(comes([&] { return part(0).checkState(0) == Qt::Unchecked; })) << "by another client";
}

TEST_F(ModelPanelTest, ARightClickSelectsMarksAndOffersToHide) {
    pick(0.5, 0.5);
    ASSERT_TRUE(comes([&] { return menuAction("&Hide") != nullptr; }));
    EXPECT_EQ(panel().chosenParts(), QStringList{QStringLiteral("2")});
    EXPECT_EQ(panel().chosenMaterial(), 2);
    EXPECT_TRUE(comes([&] { return !window->view().mark().isNull(); }));
    menuAction("&Hide")->trigger();
    EXPECT_TRUE(becomes("parts", "1 shown 2 wall\n2 hidden 2 sign"));
    for (QMenu* menu : window->findChildren<QMenu*>()) menu->close();
    pick(0.5, 0.5);
    EXPECT_TRUE(comes([&] { return panel().chosenMaterial() == 1; })) << "what was behind";
    for (QMenu* menu : window->findChildren<QMenu*>()) menu->close();
}

// The lists are read when the panel is seen for the first time.
TEST_F(ModelPanelTest, WhatWasClickedIsSelectedWhenThePanelOpens) {
    window->close();
    window.emplace(name());
    window->preferences().set(pref::followWindowSize, false);
    window->resize(1000, 700);
    window->show();
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
    window->actions()[ActionId::ModelPanel]->setChecked(false);
    panel().parentWidget()->hide();
    window->open(file("m.scn"));
    ASSERT_TRUE(shows(window->session()));
    ASSERT_EQ(panel().parts().topLevelItemCount(), 0) << "not read yet";
    pick(0.5, 0.5);
    ASSERT_TRUE(comes([&] { return menuAction("&Hide") != nullptr; }));
    for (QMenu* menu : window->findChildren<QMenu*>()) menu->close();
    QTest::keyClick(&window->view(), Qt::Key_F8);
    ASSERT_TRUE(comes([&] { return panel().chosenParts() == QStringList{QStringLiteral("2")}; }));
    ASSERT_TRUE(comes([&] { return panel().chosenMaterial() == 2; }));
    EXPECT_TRUE(comes([&] { return panel().fields().isEnabled(); }));
    EXPECT_FALSE(window->view().mark().isNull()) << "the part is outlined still";
}

TEST_F(ModelPanelTest, FieldsChangeTheChosenMaterial) {
    EXPECT_FALSE(panel().fields().isEnabled());
    panel().materials().setCurrentItem(panel().materials().topLevelItem(1));
    ASSERT_TRUE(comes([&] { return panel().fields().isEnabled(); }));
    EXPECT_FALSE(panel().fields().textures()->isEnabled()) << "it has none";
    panel().fields().number(QStringLiteral("roughness"))->setValue(0.25);
    panel().fields().number(QStringLiteral("roughness"))->setValue(0.125);
    EXPECT_TRUE(becomes("materials", "1 - red\n2 edited blue"));
    EXPECT_TRUE(
        comes([&] { return told("material get 2").contains(QStringLiteral("roughness = 0.125\n")); }));
    const auto roughnessIs = [&](double value) {
        return comes([&] {
            return std::abs(panel().fields().number(QStringLiteral("roughness"))->value() - value) < 0.01;
        });
    };
    EXPECT_TRUE(roughnessIs(0.125));
    window->editor().edit(command::materialSet(2, "shininess", {7.5}));
    EXPECT_TRUE(roughnessIs(0.5)) << "which follows";
    undo();
    EXPECT_TRUE(roughnessIs(0.125));
    undo();
    EXPECT_TRUE(becomes("materials", "1 - red\n2 - blue")) << "one gesture, one step";
    panel().fields().number(QStringLiteral("opacity"))->setValue(0.5);
    EXPECT_TRUE(becomes("materials", "1 - red\n2 edited blue"));
    panel().fields().reset()->click();
    EXPECT_TRUE(becomes("materials", "1 - red\n2 - blue"));
}

TEST_F(ModelPanelTest, ACopiedMaterialIsPastedOverOthers) {
    ASSERT_TRUE(ask(window->session(), QStringLiteral("material set blue roughness 0.25")).done);
    QTreeWidget& materials = panel().materials();
    EXPECT_FALSE(panel().copyAction().isEnabled()) << "none is chosen";
    materials.setCurrentItem(materials.topLevelItem(1));
    EXPECT_FALSE(panel().pasteAction().isEnabled()) << "none is copied";
    panel().copyAction().trigger();
    EXPECT_FALSE(panel().pasteAction().isEnabled()) << "over itself";
    materials.setCurrentItem(materials.topLevelItem(0));
    ASSERT_TRUE(panel().pasteAction().isEnabled());
    EXPECT_TRUE(panel().pasteAction().toolTip().contains(QStringLiteral("blue")));
    panel().pasteAction().trigger();
    ASSERT_TRUE(becomes("materials", "1 edited red\n2 edited blue"));
    EXPECT_EQ(told("material get 1").replace(QStringLiteral("red"), QStringLiteral("blue")),
              told("material get 2"));
    undo();
    EXPECT_TRUE(becomes("materials", "1 - red\n2 edited blue"));
    EXPECT_TRUE(panel().pasteAction().isEnabled());
    ask(window->session(), QStringLiteral("load scene ") + file("m.obj"));
    EXPECT_TRUE(comes([&] { return !panel().pasteAction().isEnabled(); })) << "of another scene";
}

TEST_F(ModelPanelTest, APresetIsForAllThatAreChosen) {
    ASSERT_TRUE(comes([&] { return panel().presets().actions().size() == 24; }));
    EXPECT_FALSE(panel().presets().menuAction()->isEnabled());
    panel().materials().selectAll();
    EXPECT_FALSE(panel().fields().isEnabled()) << "they are of one";
    ASSERT_TRUE(panel().presets().menuAction()->isEnabled());
    for (QAction* action : panel().presets().actions())
        if (action->text() == QLatin1String("Frosted glass")) action->trigger();
    ASSERT_TRUE(becomes("materials", "1 edited red\n2 edited blue"));
    EXPECT_TRUE(comes([&] { return told("material get 2").contains(QStringLiteral("opacity = 0.0\n")); }));
    undo();
    EXPECT_TRUE(becomes("materials", "1 - red\n2 - blue")) << "one step";
}

#ifdef RT_TRANSLATED
TEST_F(ModelPanelTest, PresetsHaveNamesInTheUsersLanguage) {
    QTranslator sentences;
    ASSERT_TRUE(sentences.load(QStringLiteral(":/translations/sentences_cs.qm")));
    QCoreApplication::installTranslator(&sentences);
    panel().showPresets({QStringLiteral("clear-glass"), QStringLiteral("of-a-newer-server")});
    QCoreApplication::removeTranslator(&sentences);
    EXPECT_EQ(panel().presets().actions()[0]->text(), QString::fromUtf8("\xC4\x8Cir\xC3\xA9 sklo"));
    EXPECT_EQ(panel().presets().actions()[1]->text(), QStringLiteral("Of a newer server"));
}
#endif

TEST_F(ModelPanelTest, ASearchShowsAndSelectsWhatItFinds) {
    ModelSearch& search = panel().search();
    search.setFocus();
    QTest::keyClicks(&search, QStringLiteral("SI"));
    EXPECT_TRUE(part(0).isHidden());
    EXPECT_FALSE(part(1).isHidden());
    EXPECT_TRUE(panel().materials().topLevelItem(0)->isHidden()) << "red";
    QTest::keyClick(&search, Qt::Key_Return);
    EXPECT_EQ(panel().chosenParts(), QStringList{QStringLiteral("2")});
    EXPECT_EQ(panel().chosenMaterials(), QList<int>());
    EXPECT_TRUE(comes([&] { return !window->view().mark().isNull(); })) << "as by a click on its row";
    QTest::keyClick(&search, Qt::Key_Escape);
    EXPECT_EQ(search.text(), QString());
    EXPECT_FALSE(part(0).isHidden() || panel().materials().topLevelItem(0)->isHidden());
    EXPECT_FALSE(panel().selectFound().isEnabled());
    QTest::keyClicks(&search, QStringLiteral("*"));
    panel().selectFound().click();
    EXPECT_EQ(panel().chosenParts().size(), 2);
    EXPECT_EQ(panel().chosenMaterials().size(), 2);
    search.setText(QStringLiteral("attic"));
    EXPECT_TRUE(part(0).isHidden() && part(1).isHidden());
    EXPECT_FALSE(panel().selectFound().isEnabled());
    panel().selectPart(2);
    EXPECT_EQ(search.text(), QString()) << "what a click on the image chose is to be seen";
    search.setFocus();
    QTest::keyClick(&search, Qt::Key_Escape);
    EXPECT_TRUE(comes([&] { return window->view().hasFocus(); })) << "with nothing to clear";
}

} // namespace
