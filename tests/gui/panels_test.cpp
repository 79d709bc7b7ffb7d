/// Settings, lights, bookmarks and what takes changes back, with a real server.
#include "gui/gui_support.h"
#include "gui/lit_scene.h"

#include "gui/dialogs/field_of_view_dialog.h"
#include "gui/main_window.h"
#include "gui/models/bookmark_store.h"
#include "gui/models/edit_labels.h"
#include "gui/models/setting_labels.h"
#include "gui/operations/actions.h"
#include "gui/operations/look_operations.h"
#include "gui/panels/bookmarks_panel.h"
#include "gui/panels/fold_box.h"
#include "gui/panels/lights_panel.h"
#include "gui/panels/settings_panel.h"
#include "gui/panels/value_box.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

#include "rtcore/settings/settings_table.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QSpinBox>
#include <QToolButton>
#include <QWheelEvent>

#include <array>
#include <cmath>
#include <utility>

namespace {

using namespace test;
using namespace gui;

class PanelsTest : public GuiTest {
  protected:
    void SetUp() override {
        GuiTest::SetUp();
        writeLitScene(folder());
        window.emplace(name());
        window->preferences().set(pref::followWindowSize, false);
        settings().advanced().setFolded(false);
        window->resize(900, 640);
        window->show();
        window->activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
    }
    void TearDown() override {
        window->close();
        window.reset();
        QDir(BookmarkStore::usualFolder()).removeRecursively();
    }
    void open() {
        window->open(file("lit.scn"));
        ASSERT_TRUE(shows(window->session())) << window->notice().text().toStdString();
        ASSERT_TRUE(comes([&] { return window->editor().state().lights.size() == 2; }));
        ASSERT_TRUE(comes([&] { return window->session().status().idle; }));
    }
    QAction* action(ActionId id) { return window->actions()[id]; }
    SettingsPanel& settings() { return *window->findChild<SettingsPanel*>(); }
    LightsPanel& lights() { return *window->findChild<LightsPanel*>(); }
    bool lightIsOn(int place) { return lights().light(place)->checkState() == Qt::Checked; }
    void switchLight(int place, bool on) {
        lights().light(place)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }
    BookmarksPanel& bookmarks() { return *window->findChild<BookmarksPanel*>(); }
    template <typename Box>
    Box& field(const char* setting) {
        return *qobject_cast<Box*>(settings().editor(QString::fromLatin1(setting)));
    }
    QString served(const char* setting) {
        return ask(window->session(), QStringLiteral("get %1").arg(QString::fromLatin1(setting))).text;
    }
    bool becomes(const char* setting, const char* value) {
        return comes([&] { return served(setting) == QLatin1String(value); });
    }
    QString camera() { return ask(window->session(), QStringLiteral("camera get")).text; }
    QImage picture() {
        EXPECT_TRUE(ask(window->session(), QStringLiteral("wait-idle")).done);
        QTest::qWait(50);
        return window->session().frame().copy();
    }

    std::optional<MainWindow> window;
};

TEST_F(PanelsTest, EverySettingOfTheTableHasAField) {
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        QWidget* editor = settings().editor(QString::fromStdString(std::string(setting.name)));
        ASSERT_NE(editor, nullptr) << setting.name;
        EXPECT_FALSE(editor->accessibleName().isEmpty()) << setting.name;
        EXPECT_FALSE(editor->toolTip().isEmpty()) << setting.name;
        EXPECT_FALSE(editor->isEnabled()) << setting.name << " without a server";
        EXPECT_NE(editor->focusPolicy() & Qt::TabFocus, 0) << setting.name;
    }
    open();
    for (const rtcore::Setting& setting : rtcore::settingsTable())
        EXPECT_TRUE(settings().editor(QString::fromStdString(std::string(setting.name)))->isEnabled());
}

TEST_F(PanelsTest, AChangeReachesTheServerAndIsTakenBack) {
    open();
    const QImage before = picture();
    field<QCheckBox>("shadows").click();
    EXPECT_TRUE(becomes("shadows", "false"));
    EXPECT_NE(picture(), before);
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(becomes("shadows", "true"));
    EXPECT_EQ(picture(), before);
    EXPECT_TRUE(comes([&] { return field<QCheckBox>("shadows").isChecked(); }));
    action(ActionId::Redo)->trigger();
    EXPECT_TRUE(becomes("shadows", "false"));
}

TEST_F(PanelsTest, AKeyBringsAPanelBehindAnotherToTheFront) {
    const auto inFront = [](const QWidget& panel) {
        // The dock shows its title at least; the contents may cover the panel as a whole.
        return comes([&] { return panel.isVisible() && !panel.parentWidget()->visibleRegion().isEmpty(); });
    };
    QTest::keyClick(&*window, Qt::Key_F5);
    ASSERT_TRUE(inFront(settings()));
    QTest::keyClick(&*window, Qt::Key_F6);
    ASSERT_TRUE(inFront(lights()));
    ASSERT_TRUE(settings().parentWidget()->visibleRegion().isEmpty()) << "a tab behind the lights";
    QTest::keyClick(&*window, Qt::Key_F5);
    EXPECT_TRUE(inFront(settings()));
    EXPECT_TRUE(action(ActionId::SettingsPanel)->isChecked());
    EXPECT_TRUE(action(ActionId::LightsPanel)->isChecked());
    QTest::keyClick(&*window, Qt::Key_F5);
    EXPECT_FALSE(settings().isVisible()) << "it was in front";
    EXPECT_FALSE(action(ActionId::SettingsPanel)->isChecked());
    EXPECT_TRUE(inFront(lights()));
}

TEST_F(PanelsTest, AKeyLeadsToAPanelAndEscBack) {
    open();
    QTest::keyClick(&*window, Qt::Key_F5);
    EXPECT_TRUE(comes([&] { return settings().isAncestorOf(QApplication::focusWidget()); }));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_TRUE(comes([&] { return QApplication::focusWidget() == &window->view(); }));
    // A field that was typed into leaves the key of undo to the window.
    action(ActionId::SettingsPanel)->trigger();
    action(ActionId::SettingsPanel)->trigger();
    auto& depth = field<QSpinBox>("maxDepth");
    depth.setFocus();
    depth.stepUp();
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    QTest::keyClick(&depth, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(becomes("maxDepth", "5"));
}

// Whichever panel, beside others or as a tab before them, by its key or by its own button.
TEST_F(PanelsTest, AClosedPanelGivesTheKeysBackToTheImage) {
    open();
    const std::array keys{std::pair{Qt::Key_F5, Qt::KeyboardModifiers()},
                          std::pair{Qt::Key_F5, Qt::KeyboardModifiers(Qt::ShiftModifier)},
                          std::pair{Qt::Key_F6, Qt::KeyboardModifiers()},
                          std::pair{Qt::Key_F6, Qt::KeyboardModifiers(Qt::ShiftModifier)},
                          std::pair{Qt::Key_F7, Qt::KeyboardModifiers()},
                          std::pair{Qt::Key_F7, Qt::KeyboardModifiers(Qt::ShiftModifier)},
                          std::pair{Qt::Key_F7, Qt::KeyboardModifiers(Qt::ControlModifier)},
                          std::pair{Qt::Key_F8, Qt::KeyboardModifiers()},
                          std::pair{Qt::Key_F8, Qt::KeyboardModifiers(Qt::ShiftModifier)},
                          std::pair{Qt::Key_J, Qt::KeyboardModifiers(Qt::ControlModifier)}};
    const auto focusIsInImage = [&] { return QApplication::focusWidget() == &window->view(); };
    for (const bool others : {false, true}) {
        for (const auto& [key, modifiers] : keys) {
            SCOPED_TRACE(key);
            QTest::keyClick(&*window, key, modifiers);
            ASSERT_TRUE(comes([&] { return !focusIsInImage(); }));
            QTest::keyClick(QApplication::focusWidget(), key, modifiers);
            ASSERT_TRUE(comes(focusIsInImage));
            if (others) QTest::keyClick(&*window, key, modifiers); // stays, behind or beside the next
        }
    }
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        dock->widget()->setFocus();
        dock->close();
        ASSERT_TRUE(comes(focusIsInImage)) << dock->objectName().toStdString();
    }
    const QString before = camera();
    QTest::keyPress(QApplication::focusWidget(), Qt::Key_W);
    EXPECT_TRUE(comes([&] { return camera() != before; }));
    QTest::keyRelease(QApplication::focusWidget(), Qt::Key_W);
}

TEST_F(PanelsTest, OneKeyHidesAllPanelsAndBringsThemBack) {
    const auto shown = [&] {
        QStringList names;
        for (const QDockWidget* dock : window->findChildren<QDockWidget*>())
            if (!dock->isHidden()) names.append(dock->objectName());
        names.sort();
        return names;
    };
    QTest::keyClick(&*window, Qt::Key_F4);
    EXPECT_EQ(shown(),
              (QStringList{QStringLiteral("bookmarks"), QStringLiteral("flights"), QStringLiteral("lights"),
                           QStringLiteral("measures"), QStringLiteral("model"), QStringLiteral("notes"),
                           QStringLiteral("sections"), QStringLiteral("settings"), QStringLiteral("views")}));
    QTest::keyClick(&*window, Qt::Key_F4);
    EXPECT_EQ(shown(), QStringList());
    QTest::keyClick(&*window, Qt::Key_F6);
    QTest::keyClick(&*window, Qt::Key_F5);
    QTest::keyClick(&*window, Qt::Key_J, Qt::ControlModifier);
    const QStringList some{QStringLiteral("jobs"), QStringLiteral("lights"), QStringLiteral("settings")};
    ASSERT_EQ(shown(), some);
    ASSERT_TRUE(comes([&] { return lights().parentWidget()->visibleRegion().isEmpty(); })) << "behind";
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F4);
    EXPECT_EQ(shown(), QStringList());
    EXPECT_EQ(QApplication::focusWidget(), &window->view());
    for (const ActionId id : {ActionId::SettingsPanel, ActionId::LightsPanel, ActionId::Jobs})
        EXPECT_FALSE(action(id)->isChecked());
    QTest::keyClick(&*window, Qt::Key_F4);
    EXPECT_EQ(shown(), some);
    EXPECT_TRUE(action(ActionId::Jobs)->isChecked());
    EXPECT_TRUE(comes([&] {
        return lights().parentWidget()->visibleRegion().isEmpty() &&
               !settings().parentWidget()->visibleRegion().isEmpty();
    })) << "the same one in front";
}

TEST_F(PanelsTest, ManyStepsInAMomentAreOneStepBack) {
    open();
    auto& box = field<QSpinBox>("maxDepth");
    for (int i = 0; i < 20; ++i) box.stepUp();
    EXPECT_TRUE(becomes("maxDepth", "25"));
    ASSERT_TRUE(comes([&] {
        return window->editor().state().settings[QStringLiteral("maxDepth")] == QLatin1String("25");
    }));
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 1; }));
    action(ActionId::Undo)->trigger();
    EXPECT_EQ(window->view().told(), QStringLiteral("Undone: ") + settingLabel("maxDepth"));
    EXPECT_TRUE(becomes("maxDepth", "5"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Redo)->isEnabled(); }));
    action(ActionId::Redo)->trigger();
    EXPECT_EQ(window->view().told(), QStringLiteral("Redone: ") + settingLabel("maxDepth"));
}

TEST_F(PanelsTest, AWordStandsForZero) {
    open();
    auto& focus = field<ValueBox>("depthOfField.focus");
    auto& bloom = field<QSpinBox>("bloom.radius");
    EXPECT_EQ(focus.text(), QStringLiteral("Automatic"));
    EXPECT_EQ(bloom.text(), QStringLiteral("Off"));
    focus.setValue(2.5);
    EXPECT_TRUE(becomes("depthOfField.focus", "2.5"));
    EXPECT_EQ(focus.text(), QStringLiteral("2.5 scene units"));
    focus.setFocus();
    focus.selectAll();
    QTest::keyClicks(&focus, QStringLiteral("automatic"));
    QTest::keyClick(&focus, Qt::Key_Return);
    EXPECT_TRUE(becomes("depthOfField.focus", "0"));
    EXPECT_EQ(focus.text(), QStringLiteral("Automatic"));
}

TEST(ValueBoxes, ShowAnExponentOnlyWhereItHelps) {
    ValueBox box(-1e15, 1e15);
    for (const auto& [value, shown] : {std::pair{100000., "100000"},
                                       {-20000., "-20000"},
                                       {0.0001, "0.0001"},
                                       {0.1, "0.1"},
                                       {0., "0"},
                                       {4.5e12, "4.5E+12"},
                                       {2e-9, "2E-09"}}) {
        box.setValue(value);
        EXPECT_EQ(box.text().toUpper(), QLatin1String(shown)); // E or e, by the language
        EXPECT_EQ(box.value(), value);
    }
}

TEST_F(PanelsTest, NumbersAndChoicesAreSetToo) {
    open();
    auto& key = field<ValueBox>("exposure.key");
    EXPECT_EQ(key.value(), 0.18);
    key.findChild<QLineEdit*>()->setText(QStringLiteral("0.3"));
    QTest::keyClick(&key, Qt::Key_Return);
    EXPECT_TRUE(becomes("exposure.key", "0.3"));
    key.stepBy(1);
    EXPECT_TRUE(becomes("exposure.key", "0.31"));
    auto& mode = field<QComboBox>("exposure.mode");
    EXPECT_EQ(mode.currentData().toString(), QStringLiteral("fixed"));
    mode.setCurrentIndex(mode.findData(QStringLiteral("automatic")));
    EXPECT_TRUE(becomes("exposure.mode", "automatic"));
}

TEST_F(PanelsTest, ASettingGoesBackToItsDefaultByItself) {
    open();
    action(ActionId::SettingsPanel)->trigger();
    QToolButton* back = settings().resetButton(QStringLiteral("maxDepth"));
    ASSERT_NE(back, nullptr);
    EXPECT_FALSE(back->isVisible()) << "nothing differs";
    field<QSpinBox>("maxDepth").setValue(9);
    ASSERT_TRUE(comes([&] { return back->isVisible(); }));
    EXPECT_FALSE(back->accessibleName().isEmpty());
    back->click();
    EXPECT_TRUE(becomes("maxDepth", "5"));
    EXPECT_TRUE(comes([&] { return !back->isVisible(); }));
    EXPECT_TRUE(field<QSpinBox>("maxDepth").hasFocus()) << "the button that had it is gone";
    EXPECT_FALSE(settings().resetButton(QStringLiteral("width"))->isVisible()) << "follows the window";
    EXPECT_TRUE(settings().resetButton(QStringLiteral("exposure.mode"))->isVisible()) << "fixed by the scene";
}

TEST_F(PanelsTest, GroupsFoldUpByKeysAndStaySo) {
    action(ActionId::SettingsPanel)->trigger();
    FoldBox* exposure = settings().group(QStringLiteral("exposure"));
    ASSERT_NE(exposure, nullptr);
    ASSERT_NE(settings().group(QString()), nullptr);
    QWidget* key = settings().editor(QStringLiteral("exposure.local"));
    EXPECT_TRUE(comes([&] { return key->isVisible(); }));
    EXPECT_NE(exposure->header().focusPolicy() & Qt::TabFocus, 0);
    QTest::keyClick(&exposure->header(), Qt::Key_Left);
    EXPECT_FALSE(key->isVisible());
    EXPECT_TRUE(settings().editor(QStringLiteral("shadows"))->isVisible()) << "another group";
    EXPECT_EQ(window->preferences().get(pref::foldedSettings), QStringList(QStringLiteral("exposure")));
    QTest::keyClick(&exposure->header(), Qt::Key_Left);
    EXPECT_FALSE(key->isVisible()) << "folded already";
    MainWindow other(name());
    EXPECT_TRUE(other.findChild<SettingsPanel*>()->group(QStringLiteral("exposure"))->folded());
    QTest::keyClick(&exposure->header(), Qt::Key_Space);
    EXPECT_TRUE(key->isVisible());
    EXPECT_TRUE(window->preferences().get(pref::foldedSettings).isEmpty());
}

TEST_F(PanelsTest, AGroupTellsThatSomethingInsideDiffers) {
    open();
    FoldBox* exposure = settings().group(QStringLiteral("exposure"));
    FoldBox* occlusion = settings().group(QStringLiteral("ambientOcclusion"));
    EXPECT_TRUE(exposure->header().text().endsWith(QChar(u'•')));
    EXPECT_FALSE(occlusion->header().text().endsWith(QChar(u'•')));
    emit settings().defaultsWanted();
    EXPECT_TRUE(comes([&] { return !exposure->header().text().endsWith(QChar(u'•')); }));
}

TEST_F(PanelsTest, AChangeBySomebodyElseShowsUp) {
    open();
    action(ActionId::SettingsPanel)->trigger();
    ASSERT_TRUE(comes([&] { return settings().isVisible(); }));
    const ProgramResult done =
        runProgram(programPath("CUI"), {"--instance=" + instance.name(), "set", "antialiasing", "2"});
    ASSERT_EQ(done.exitCode, 0) << done.error;
    EXPECT_TRUE(comes([&] { return field<QSpinBox>("antialiasing").value() == 2; }));
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    EXPECT_EQ(action(ActionId::Undo)->text(), QStringLiteral("&Undo: Anti-aliasing"));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(becomes("antialiasing", "1"));
    EXPECT_TRUE(
        comes([&] { return action(ActionId::Redo)->text() == QStringLiteral("Re&do: Anti-aliasing"); }));
}

TEST_F(PanelsTest, WhatAKeyDidIsTakenBackAsWell) {
    open();
    QTest::keyClick(&window->view(), Qt::Key_2);
    ASSERT_TRUE(comes([&] { return !window->editor().state().lights[1].on; }));
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->text() == QStringLiteral("&Undo: light 2"); }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return window->editor().state().lights[1].on; }));
    EXPECT_TRUE(comes([&] { return !action(ActionId::Undo)->isEnabled(); }));
}

TEST_F(PanelsTest, StepsOfTheWindowAndOfTheServerAreTakenBackInTheirOrder) {
    open();
    action(ActionId::AddBookmark)->trigger();
    ASSERT_TRUE(comes([&] { return bookmarks().list().count() == 1; }));
    switchLight(0, false);
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 1; }));
    emit bookmarks().deleteWanted(0);
    ASSERT_EQ(bookmarks().list().count(), 0);
    field<QCheckBox>("shadows").click();
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 2; }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(becomes("shadows", "true"));
    EXPECT_EQ(bookmarks().list().count(), 0);
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 1; }));
    action(ActionId::Undo)->trigger();
    EXPECT_EQ(bookmarks().list().count(), 1);
    EXPECT_FALSE(window->editor().state().lights[0].on);
    action(ActionId::Undo)->trigger();
    ASSERT_TRUE(comes([&] { return window->editor().state().lights[0].on; }));
    EXPECT_FALSE(action(ActionId::Undo)->isEnabled());
    action(ActionId::Redo)->trigger();
    ASSERT_TRUE(comes([&] { return !window->editor().state().lights[0].on; }));
    action(ActionId::Redo)->trigger();
    EXPECT_EQ(bookmarks().list().count(), 0);
    action(ActionId::Redo)->trigger();
    EXPECT_TRUE(becomes("shadows", "false"));
}

TEST_F(PanelsTest, WhatTheServerRefusesIsToldAndGoesBack) {
    open();
    const int width = field<QSpinBox>("width").value();
    field<QSpinBox>("width").setValue(32768);
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    EXPECT_TRUE(window->notice().text().contains(QStringLiteral("16384")))
        << window->notice().text().toStdString();
    EXPECT_TRUE(comes([&] { return field<QSpinBox>("width").value() == width; }));
    EXPECT_FALSE(action(ActionId::Undo)->isEnabled());
}

TEST_F(PanelsTest, DefaultsAreOneStep) {
    open();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("set maxDepth 9")).done);
    window->editor().refresh();
    ASSERT_TRUE(comes([&] { return field<QSpinBox>("maxDepth").value() == 9; }));
    emit settings().defaultsWanted();
    EXPECT_TRUE(becomes("maxDepth", "5"));
    EXPECT_EQ(served("exposure.mode"), QStringLiteral("automatic"));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(becomes("maxDepth", "9"));
    EXPECT_EQ(served("exposure.mode"), QStringLiteral("fixed"));
}

TEST_F(PanelsTest, LightsAndEnvironmentsAreSwitched) {
    open();
    action(ActionId::LightsPanel)->trigger();
    ASSERT_NE(lights().light(1), nullptr);
    EXPECT_EQ(lights().light(0)->text(), QStringLiteral("lamp & co"));
    EXPECT_EQ(lights().environment(1)->text(), QStringLiteral("dusk"));
    EXPECT_TRUE(lights().environment(0)->isChecked());
    const QImage before = picture();
    switchLight(0, false);
    const auto told = [&](const char* command) {
        return ask(window->session(), QString::fromLatin1(command)).text;
    };
    EXPECT_TRUE(comes([&] { return told("lights").startsWith(QStringLiteral("1 off")); }));
    EXPECT_NE(picture(), before);
    lights().environment(1)->click();
    EXPECT_TRUE(comes([&] { return told("environments").contains(QStringLiteral("2 active")); }));
    action(ActionId::Undo)->trigger();
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return lightIsOn(0) && lights().environment(0)->isChecked(); }));
    EXPECT_EQ(picture(), before);
    // A digit key is the server's; the panel follows.
    QTest::keyClick(&window->view(), Qt::Key_2);
    EXPECT_TRUE(comes([&] { return !lightIsOn(1); }));
}

TEST_F(PanelsTest, ABookmarkGoesBackToTheSameCamera) {
    open();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 0.1 1.7 5.3 0.3 -0.2 -1 51.3")).done);
    (void)picture();
    ASSERT_TRUE(ask(window->session(), command::exportCamera(file("a.cam").toStdString())).done);
    const QString kept = camera();
    action(ActionId::AddBookmark)->trigger();
    ASSERT_TRUE(comes([&] { return bookmarks().list().count() == 1; }));
    EXPECT_FALSE(bookmarks().list().item(0)->icon().isNull());
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 2 4 0 0 -1 70")).done);
    const QString elsewhere = camera();
    QTest::keyClick(&*window, Qt::Key_1, Qt::AltModifier);
    EXPECT_TRUE(comes([&] { return camera() == kept; }));
    (void)picture();
    ASSERT_TRUE(ask(window->session(), command::exportCamera(file("b.cam").toStdString())).done);
    EXPECT_EQ(readBytes(folder() / "b.cam"), readBytes(folder() / "a.cam"));
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return camera() == elsewhere; }));
}

TEST_F(PanelsTest, BookmarksAreRenamedDeletedAndBroughtBack) {
    open();
    action(ActionId::AddBookmark)->trigger();
    ASSERT_TRUE(comes([&] { return bookmarks().list().count() == 1; }));
    action(ActionId::AddBookmark)->trigger();
    ASSERT_TRUE(comes([&] { return bookmarks().list().count() == 2; }));
    bookmarks().list().item(0)->setText(QStringLiteral("By the altar / left"));
    ASSERT_TRUE(
        comes([&] { return bookmarks().list().item(0)->text() == QStringLiteral("By the altar - left"); }));
    BookmarkStore store;
    store.setScene(file("lit.scn"));
    ASSERT_EQ(store.list().size(), 2);
    EXPECT_EQ(store.list()[0].file, QStringLiteral("01 By the altar - left"));
    EXPECT_FALSE(store.picture(store.list()[0]).isNull());
    bookmarks().list().setCurrentRow(0);
    emit bookmarks().deleteWanted(0);
    EXPECT_EQ(store.list().size(), 1);
    EXPECT_EQ(QDir(store.folder()).entryList(QDir::Files).size(), 2);
    action(ActionId::Undo)->trigger();
    ASSERT_EQ(store.list().size(), 2);
    EXPECT_EQ(bookmarks().list().item(0)->text(), QStringLiteral("By the altar - left"));
}

TEST_F(PanelsTest, PlacementsAreTakenBackWithAllThatTheFileBrought) {
    open();
    const QString before = camera();
    writeCamera(folder() / "view.cam", 1.5, "antialiasing = 2\nexposure = 0.75\nlights = [false, true]\n");
    window->editor().edit(command::loadCamera(file("view.cam").toStdString()));
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    EXPECT_EQ(action(ActionId::Undo)->text(), QStringLiteral("&Undo: camera view"));
    EXPECT_EQ(served("antialiasing"), QStringLiteral("2"));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(becomes("antialiasing", "1"));
    EXPECT_EQ(served("exposure.value"), QStringLiteral("2"));
    EXPECT_EQ(camera(), before);
    EXPECT_TRUE(ask(window->session(), QStringLiteral("lights")).text.startsWith(QStringLiteral("1 on")));
}

TEST_F(PanelsTest, APastedCameraBringsWhatItsTextNamesAndIsTakenBack) {
    open();
    const QString before = camera();
    QGuiApplication::clipboard()->setText(QStringLiteral(
        "version = 1\neye = [0.5, 1.5, 7.0]\nforward = [0.1, 0.0, -1.0]\nup = [0.1, 1.0, 0.0]\n"
        "orthographicWidth = 5.5\nantialiasing = 2\nlights = [true, false]\nenvironment = 1\n"));
    action(ActionId::PasteCamera)->trigger();
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    EXPECT_TRUE(camera().contains(QStringLiteral("orthographicWidth = 5.5"))) << camera().toStdString();
    EXPECT_TRUE(camera().contains(QStringLiteral("up = [0.1, 1.0, 0.0]"))) << camera().toStdString();
    EXPECT_EQ(served("antialiasing"), QStringLiteral("2"));
    EXPECT_TRUE(comes([&] { return !lightIsOn(1) && lights().environment(1)->isChecked(); }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(becomes("antialiasing", "1"));
    EXPECT_TRUE(comes([&] { return camera() == before; })) << camera().toStdString();
    EXPECT_TRUE(comes([&] { return lightIsOn(1) && lights().environment(0)->isChecked(); }));
    QGuiApplication::clipboard()->setText(QStringLiteral("eye = 3"));
    action(ActionId::PasteCamera)->trigger();
    EXPECT_EQ(camera(), before);
    EXPECT_TRUE(comes([&] { return !action(ActionId::Undo)->isEnabled(); }));
}

TEST_F(PanelsTest, ResetShowsTheScenesOwnView) {
    open();
    const QString own = camera();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 1 2 4 0 0 -1 70")).done);
    QTest::keyClick(&*window, Qt::Key_Home, Qt::ControlModifier);
    EXPECT_TRUE(comes([&] { return camera() == own; }));
}

TEST_F(PanelsTest, ADoubleClickLooksThere) {
    open();
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    action(ActionId::Orbit)->trigger();
    const QString before = camera();
    const View view = window->session().status().view;
    FrameView& shown = window->view();
    const QPoint place(shown.width() * 2 / 3, shown.height() * 2 / 5);
    const std::optional<QPointF> point = shown.inPicture(place);
    ASSERT_TRUE(point.has_value());
    const QSize size = window->session().frame().size();
    const QVector3D wanted =
        directionThrough(view, *point, static_cast<double>(size.width()) / size.height());
    QTest::mouseClick(&shown, Qt::LeftButton, Qt::NoModifier, place);
    doubleClick(&shown, {}, place);
    EXPECT_FALSE(shown.input().captured());
    EXPECT_TRUE(comes([&] { return (window->session().status().view.forward - wanted).length() < 1e-5F; }));
    EXPECT_EQ(window->session().status().view.eye, view.eye);
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    EXPECT_TRUE(comes([&] { return window->editor().state().edits == 1; }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return camera() == before; }));
}

// Where rays are parallel, the direction says nothing of what is in the middle.
TEST_F(PanelsTest, ADoubleClickInAParallelViewMovesThePointToTheMiddle) {
    open();
    ASSERT_TRUE(comes([&] { return action(ActionId::Orbit)->isChecked(); }));
    action(ActionId::Orbit)->trigger();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera orthographic 0 1 6 0 0 -1 8")).done);
    ASSERT_TRUE(comes([&] {
        return window->session().status().view.parallelWidth == 8 && window->session().status().idle;
    }));
    const View view = window->session().status().view;
    FrameView& shown = window->view();
    const QPoint place(shown.width() * 5 / 8, shown.height() / 2);
    const std::optional<QPointF> point = shown.inPicture(place);
    ASSERT_TRUE(point.has_value());
    QTest::mouseClick(&shown, Qt::LeftButton, Qt::NoModifier, place);
    doubleClick(&shown, {}, place);
    EXPECT_FALSE(shown.input().captured());
    const float wanted = view.eye.x() + static_cast<float>(point->x()) * 4;
    EXPECT_TRUE(comes([&] { return std::fabs(window->session().status().view.eye.x() - wanted) < 0.05F; }))
        << window->session().status().view.eye.x() << " in place of " << wanted;
    EXPECT_EQ(window->session().status().view.forward, view.forward);
}

TEST_F(PanelsTest, ADoubleClickWithCtrlFocusesThere) {
    open();
    const QString before = camera();
    FrameView& shown = window->view();
    const QPoint place(shown.width() / 2, shown.height() / 2);
    QTest::mouseClick(&shown, Qt::LeftButton, Qt::ControlModifier, place);
    doubleClick(&shown, Qt::ControlModifier, place);
    EXPECT_FALSE(shown.input().captured());
    EXPECT_TRUE(becomes("depthOfField.on", "true"));
    EXPECT_GT(served("depthOfField.focus").toDouble(), 0);
    EXPECT_EQ(camera(), before);
    ASSERT_TRUE(comes([&] { return action(ActionId::Undo)->isEnabled(); }));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(becomes("depthOfField.on", "false"));
}

TEST_F(PanelsTest, CtrlAndTheWheelZoomAsOneStep) {
    open();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera angle 80")).done);
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 1; }));
    const QString before = camera();
    FrameView& shown = window->view();
    const QPointF place(shown.width() / 2.0, shown.height() / 2.0);
    for (int i = 0; i < 6; ++i) {
        QWheelEvent wheel(place, shown.mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::ControlModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&shown, &wheel);
    }
    // tan 40 / 1.1^6
    EXPECT_TRUE(comes([&] { return std::fabs(window->session().status().view.fieldOfView - 50.7F) < 0.1F; }))
        << window->session().status().view.fieldOfView;
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 2; }));
    EXPECT_EQ(action(ActionId::Undo)->text(), QStringLiteral("&Undo: field of view"));
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return camera() == before; }));
}

TEST_F(PanelsTest, TheFieldOfViewIsGivenAsAnAngleOrALens) {
    open();
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera angle 80")).done);
    ASSERT_TRUE(comes([&] { return window->session().status().view.fieldOfView == 80; }));
    action(ActionId::FieldOfView)->trigger();
    auto* const dialog = window->findChild<FieldOfViewDialog*>();
    ASSERT_NE(dialog, nullptr);
    const QList<QDoubleSpinBox*> fields = dialog->findChildren<QDoubleSpinBox*>();
    ASSERT_EQ(fields.size(), 2);
    EXPECT_EQ(fields[0]->value(), 80);
    EXPECT_EQ(fields[1]->value(), 21.5);
    fields[1]->setValue(50);
    EXPECT_EQ(fields[0]->value(), 39.6);
    EXPECT_TRUE(
        comes([&] { return std::fabs(window->session().status().view.fieldOfView - 39.6F) < 0.01F; }));
    fields[0]->setValue(90);
    EXPECT_EQ(fields[1]->value(), 18);
    EXPECT_TRUE(comes([&] { return window->session().status().view.fieldOfView == 90; }));
    ASSERT_TRUE(comes([&] { return window->editor().state().edits == 2; })) << "one gesture, one step";
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera angle 70")).done);
    EXPECT_TRUE(comes([&] { return fields[0]->value() == 70; })) << "it follows other programs";
    dialog->close();
}

TEST(LookTest, TheDirectionThroughACornerHasTheAngleOfTheField) {
    View view;
    view.forward = {1, 0, 0};
    view.fieldOfView = 90;
    const QVector3D middle = directionThrough(view, {0, 0}, 2), side = directionThrough(view, {1, 0}, 2);
    EXPECT_LT((middle - view.forward).length(), 1e-6F);
    EXPECT_LT((side - QVector3D(1, 0, 1).normalized()).length(), 1e-6F);
    const QVector3D top = directionThrough(view, {0, 1}, 2);
    EXPECT_LT((top - QVector3D(1, 0.5F, 0).normalized()).length(), 1e-6F);
}

TEST(SceneStateTest, AnswersAreRead) {
    const QString answer = QStringLiteral(
        "version = 1\nscene = \"/a/b.scn\"\nup = \"+z\"\nmetresPerUnit = 0.01\n"
        "undo = \"set exposure.key\"\nredo = \"\"\nundoEdit = [4, 0]\nredoEdit = [0, 0]\nedits = 4\n"
        "modified = true\nindoors = true\nbookmarks = [\"door\"]\n"
        "[lights]\non = [true, false]\nnames = [\"sun and moon\", \"\"]\nids = [3, 1]\n"
        "[environments]\non = [true, false]\nnames = [\"day\", \"night\"]\n"
        "[camera]\neye = [1.0, 2.0, 3.0]\nforward = [0.0, 0.0, -1.0]\n"
        "[settings]\nbloom = 0\nexposure.key = 0.18\n");
    const std::optional<StateAnswer> read = readState(answer);
    ASSERT_TRUE(read);
    EXPECT_FALSE(readState(QStringLiteral("version = 1\n")));
    EXPECT_EQ(read->scene, QStringLiteral("/a/b.scn"));
    const SceneState& state = read->state;
    EXPECT_EQ(state.settings.value(QStringLiteral("exposure.key")), QStringLiteral("0.18"));
    EXPECT_EQ(state.lights, (QList<ShownLight>{{3, true, QStringLiteral("sun and moon")}, {1, false, {}}}));
    EXPECT_EQ(state.environments,
              (QList<NamedSwitch>{{true, QStringLiteral("day")}, {false, QStringLiteral("night")}}));
    EXPECT_EQ(state.undo, QStringLiteral("set exposure.key"));
    EXPECT_EQ(state.edits, 4);
    EXPECT_TRUE(state.modified);
    EXPECT_EQ(state.bookmarks, QStringList{QStringLiteral("door")});
}

TEST(EditLabelTest, SaysWhatIsTakenBack) {
    EXPECT_EQ(editLabel({}), QString());
    EXPECT_EQ(editLabel(QStringLiteral("set exposure.key")), settingLabel("exposure.key"));
    EXPECT_EQ(editLabel(QStringLiteral("light 2")), QStringLiteral("light 2"));
    EXPECT_EQ(editLabel(QStringLiteral("load camera \"by the altar\"")),
              QStringLiteral("camera by the altar"));
    EXPECT_EQ(editLabel(QStringLiteral("camera set")), QStringLiteral("look there"));
    EXPECT_EQ(editLabel(QStringLiteral("fold the room")), QStringLiteral("fold the room"));
}

} // namespace
