/// Save, Save as and Pack in the window; the mark in its title; the question before changes are lost.
#include "gui/dialog_support.h"
#include "gui/lit_scene.h"
#include "gui/window_support.h"

#include "gui/dialogs/plan_dialog.h"
#include "gui/models/bookmark_store.h"
#include "gui/operations/job_operations.h"
#include "gui/panels/bookmarks_panel.h"
#include "gui/session/server_list.h"
#include "rtcore/io/text/scn.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>

namespace {

using namespace test;
using namespace gui;

class SavingTest : public WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        writeLitScene(folder());
        hand_ = readBytes(folder() / "lit.scn");
    }
    void edit() {
        window->editor().switchLight(1, false);
        ASSERT_TRUE(comes([&] { return window->isWindowModified(); }));
    }
    QMessageBox* question() const { return window->findChild<QMessageBox*>(); }
    /// Answers the question, by the beginning of a button's text.
    void answer(const char* text) {
        ASSERT_TRUE(comes([&] { return question() != nullptr; }));
        QMessageBox* box = question();
        for (QAbstractButton* button : box->buttons()) {
            if (!button->text().remove(QLatin1Char('&')).startsWith(QLatin1String(text))) continue;
            button->click();
            box->setObjectName(QStringLiteral("answered"));
            ASSERT_TRUE(comes([&] { return question() == nullptr || question()->objectName().isEmpty(); }));
            return;
        }
        FAIL() << "no button " << text;
    }
    void choose(const std::string& name) {
        QFileDialog* dialog = nullptr;
        ASSERT_TRUE(comes([&] { return (dialog = window->findChild<QFileDialog*>()) != nullptr; }));
        emit dialog->fileSelected(file(name));
        dialog->close();
        ASSERT_TRUE(comes([&] { return window->findChild<QFileDialog*>() == nullptr; }));
    }
    bool comesUnmodified() {
        return comes([&] { return !window->isWindowModified(); });
    }
    rtcore::SceneFile saved(const std::string& name) { return rtcore::readSceneFile(folder() / name); }
    QStringList bookmarks() {
        QStringList names;
        const QListWidget& list = window->findChild<BookmarksPanel*>()->list();
        for (int i = 0; i < list.count(); ++i) names.append(list.item(i)->text());
        return names;
    }

    std::string hand_;
};

TEST_F(SavingTest, AModelBecomesAScene) {
    ASSERT_NO_FATAL_FAILURE(open());
    EXPECT_EQ(window->windowTitle(), QStringLiteral("room.obj[*] – rtsuite"));
    EXPECT_FALSE(window->isWindowModified());
    ASSERT_NO_FATAL_FAILURE(edit());
    QTest::keyClick(&*window, Qt::Key_S, Qt::ControlModifier);
    ASSERT_NO_FATAL_FAILURE(choose("mine.scn"));
    ASSERT_TRUE(comesUnmodified());
    EXPECT_TRUE(comes([&] { return window->windowTitle() == QStringLiteral("mine.scn[*] – rtsuite"); }));
    EXPECT_FALSE(saved("mine.scn").sun.on);
    EXPECT_EQ(window->preferences().recentFiles().front(), file("mine.scn"));
    EXPECT_EQ(window->keeper().scene(), file("mine.scn"));
    window->editor().switchLight(1, true);
    ASSERT_TRUE(comes([&] { return window->isWindowModified(); }));
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&*window));
    QTest::keyClick(&*window, Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(comesUnmodified()) << "without a question: the window has written it";
    EXPECT_TRUE(saved("mine.scn").sun.on);
    EXPECT_EQ(window->notice().isVisible(), false);
}

TEST_F(SavingTest, UndoBackToWhatWasSavedClearsTheMark) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    ASSERT_NO_FATAL_FAILURE(edit());
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comesUnmodified());
    action(ActionId::Redo)->trigger();
    EXPECT_TRUE(comes([&] { return window->isWindowModified(); }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("undo")).done);
    EXPECT_TRUE(comesUnmodified()) << "by another client, too";
}

TEST_F(SavingTest, APlanIsDrawn) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    action(ActionId::Plan)->trigger();
    auto* dialog = window->findChild<PlanDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>()->setText(file("plan.svg"));
    accept(*dialog);
    EXPECT_TRUE(comes([&] { return std::filesystem::exists(folder() / "plan.svg"); }))
        << window->notice().text().toStdString();
}

// Lines by the server at once, then the Renderer's light under them.
TEST_F(SavingTest, APlanHasLight) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    action(ActionId::Plan)->trigger();
    auto* dialog = window->findChild<PlanDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QLineEdit*>()->setText(file("plan.png"));
    dialog->findChildren<QComboBox*>()[3]->setCurrentIndex(1);
    accept(*dialog);
    const JobQueue& jobs = window->jobs().queue();
    ASSERT_TRUE(comes([&] { return jobs.rowCount() == 1 && jobs.job(0).over(); }))
        << window->notice().text().toStdString();
    EXPECT_EQ(jobs.job(0).state, JobState::Done) << jobs.job(0).message.toStdString();
    EXPECT_TRUE(jobs.job(0).request.arguments.contains(QStringLiteral("--plan-image=light")));
}

TEST_F(SavingTest, AFileByHandIsAskedForAndKept) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    ASSERT_NO_FATAL_FAILURE(edit());
    action(ActionId::Save)->trigger();
    ASSERT_TRUE(comes([&] { return question() != nullptr; }));
    EXPECT_TRUE(question()->text().contains(QStringLiteral("comments"))) << question()->text().toStdString();
    EXPECT_TRUE(question()->text().contains(QStringLiteral("“lit.scn~”")));
    ASSERT_NO_FATAL_FAILURE(answer("Cancel"));
    EXPECT_EQ(readBytes(folder() / "lit.scn"), hand_);
    EXPECT_TRUE(window->isWindowModified());
    action(ActionId::Save)->trigger();
    ASSERT_NO_FATAL_FAILURE(answer("Replace"));
    ASSERT_TRUE(comesUnmodified());
    EXPECT_EQ(readBytes(folder() / "lit.scn~"), hand_);
    EXPECT_EQ(saved("lit.scn").lights.front().light.on, 0U);
}

TEST_F(SavingTest, WhatCannotBeWrittenIsExplained) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    ASSERT_NO_FATAL_FAILURE(edit());
    action(ActionId::SaveAs)->trigger();
    ASSERT_NO_FATAL_FAILURE(choose("none/mine.scn"));
    ASSERT_TRUE(comes([&] { return window->notice().text().contains(QStringLiteral("none/mine.scn")); }));
    EXPECT_TRUE(window->isWindowModified());
    EXPECT_EQ(window->editor().scene(), file("lit.scn"));
}

TEST_F(SavingTest, ClosingAsksAndSaves) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    EXPECT_EQ(question(), nullptr);
    ASSERT_NO_FATAL_FAILURE(edit());
    EXPECT_FALSE(window->close());
    ASSERT_NO_FATAL_FAILURE(answer("Cancel"));
    EXPECT_TRUE(window->isVisible());
    EXPECT_FALSE(window->close());
    ASSERT_NO_FATAL_FAILURE(answer("Save"));
    ASSERT_NO_FATAL_FAILURE(answer("Replace")); // it is by hand
    EXPECT_TRUE(comes([&] { return !window->isVisible(); }));
    EXPECT_EQ(saved("lit.scn").lights.front().light.on, 0U);
}

TEST_F(SavingTest, ClosingAsksAndDiscards) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    ASSERT_NO_FATAL_FAILURE(edit());
    EXPECT_FALSE(window->close());
    ASSERT_NO_FATAL_FAILURE(answer("Discard"));
    EXPECT_TRUE(comes([&] { return !window->isVisible(); }));
    EXPECT_EQ(readBytes(folder() / "lit.scn"), hand_);
}

TEST_F(SavingTest, OnlyTheLastWindowAsks) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    {
        MainWindow second(window->session().instance());
        second.show();
        second.connectToServer();
        ASSERT_TRUE(shows(second.session()));
        ASSERT_NO_FATAL_FAILURE(edit());
        ASSERT_TRUE(comes([&] { return second.isWindowModified(); })) << "it is the server's mark";
        EXPECT_TRUE(second.close()) << "this window goes on";
    }
    ASSERT_TRUE(comes([&] { return clientsOf(window->session().instance()) == 1; }));
    EXPECT_FALSE(window->close());
    ASSERT_NO_FATAL_FAILURE(answer("Discard"));
}

TEST_F(SavingTest, AnotherSceneAsksFirst) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    ASSERT_NO_FATAL_FAILURE(edit());
    window->open(file("room.obj"));
    ASSERT_NO_FATAL_FAILURE(answer("Cancel"));
    EXPECT_EQ(window->editor().scene(), file("lit.scn"));
    window->open(file("room.obj"));
    ASSERT_NO_FATAL_FAILURE(answer("Discard"));
    EXPECT_TRUE(comes([&] { return window->editor().scene() == file("room.obj"); }));
    EXPECT_TRUE(comesUnmodified());
}

TEST_F(SavingTest, ARestartAsksFirst) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    ASSERT_NO_FATAL_FAILURE(edit());
    const qint64 process = window->session().serverProcess();
    action(ActionId::RestartServer)->trigger();
    ASSERT_NO_FATAL_FAILURE(answer("Cancel"));
    EXPECT_EQ(window->session().serverProcess(), process);
    action(ActionId::RestartServer)->trigger();
    ASSERT_NO_FATAL_FAILURE(answer("Discard"));
    EXPECT_TRUE(
        comes([&] { return window->session().serverProcess() != process && window->session().live(); }));
    EXPECT_TRUE(comesUnmodified());
}

TEST_F(SavingTest, BookmarksGoIntoTheScene) {
    ASSERT_NO_FATAL_FAILURE(openAndRest("lit.scn"));
    for (int i = 1; i <= 2; ++i) {
        action(ActionId::AddBookmark)->trigger();
        ASSERT_TRUE(comes([&] { return bookmarks().size() == i; }));
    }
    EXPECT_FALSE(window->isWindowModified()) << "the window keeps them by itself";
    action(ActionId::SaveAs)->trigger();
    ASSERT_NO_FATAL_FAILURE(choose("mine.scn"));
    ASSERT_TRUE(comes([&] { return window->editor().scene() == file("mine.scn"); }));
    EXPECT_TRUE(comesUnmodified());
    ASSERT_EQ(saved("mine.scn").bookmarks.size(), 2U);
    EXPECT_EQ(bookmarks(), (QStringList{QStringLiteral("Place 1"), QStringLiteral("Place 2")}));
    BookmarkStore store;
    store.setScene(file("mine.scn"));
    EXPECT_FALSE(store.picture(store.list().front()).isNull()) << "the images come along";
    store.setScene(file("lit.scn"));
    EXPECT_EQ(store.list().size(), 2) << "those of the other file stay";
}

TEST_F(SavingTest, BookmarksComeFromTheScene) {
    writeText(folder() / "marked.scn",
              "version = 2\nmodel = \"room.obj\"\n"
              "[[bookmark]]\nname = \"By the door\"\neye = [1, 2, 4]\nlookAt = [0, 1, 0]\n"
              "[[bookmark]]\nname = \"Above\"\neye = [0, 9, 1]\nlookAt = [0, 1, 0]\n");
    ASSERT_NO_FATAL_FAILURE(openAndRest("marked.scn"));
    ASSERT_TRUE(comes([&] { return bookmarks().size() == 2; }));
    QTest::keyClick(&*window, Qt::Key_1, Qt::AltModifier);
    EXPECT_TRUE(comes([&] { return window->session().status().view.eye == QVector3D(1, 2, 4); }));
    auto* panel = window->findChild<BookmarksPanel*>();
    panel->list().item(1)->setText(QStringLiteral("From above"));
    EXPECT_TRUE(comes([&] {
        return ask(window->session(), QStringLiteral("bookmarks")).text ==
               QStringLiteral("By the door\nFrom above");
    }));
    emit panel->deleteWanted(0);
    EXPECT_TRUE(comes([&] { return bookmarks() == QStringList{QStringLiteral("From above")}; }));
    EXPECT_TRUE(window->isWindowModified());
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(comes([&] { return bookmarks().size() == 2; }));
}

TEST_F(SavingTest, APackHasAllThatTheSceneNeeds) {
    ASSERT_NO_FATAL_FAILURE(open("lit.scn"));
    action(ActionId::Pack)->trigger();
    ASSERT_NO_FATAL_FAILURE(choose("packed"));
    ASSERT_TRUE(comes([&] { return QFileInfo::exists(file("packed/lit.scn")); }));
    EXPECT_TRUE(QFileInfo::exists(file("packed/model/room.obj")));
    EXPECT_TRUE(QFileInfo::exists(file("packed/environments/sky.ppm")));
    EXPECT_EQ(window->editor().scene(), file("lit.scn"));
}

TEST_F(SavingTest, APackAsksForFilesFromElsewhereByTheirNames) {
    ASSERT_TRUE(QDir().mkpath(file("scene")));
    for (const char* name : {"lit.scn", "room.obj"})
        ASSERT_TRUE(QFile::rename(file(name), file(std::string("scene/") + name)));
    ASSERT_TRUE(QFile::link(file("sky.ppm"), file("scene/sky.ppm")));
    ASSERT_NO_FATAL_FAILURE(open("scene/lit.scn"));
    action(ActionId::Pack)->trigger();
    ASSERT_NO_FATAL_FAILURE(choose("packed"));
    ASSERT_TRUE(comes([&] { return question() != nullptr; }));
    EXPECT_TRUE(question()->text().contains(file("sky.ppm"))) << question()->text().toStdString();
    EXPECT_EQ(question()->textFormat(), Qt::PlainText);
    EXPECT_FALSE(QFileInfo::exists(file("packed")));
    ASSERT_NO_FATAL_FAILURE(answer("Pack them"));
    ASSERT_TRUE(comes([&] { return QFileInfo::exists(file("packed/environments/sky.ppm")); }));
}

TEST_F(SavingTest, ShortcutsFollowTheScheme) {
    EXPECT_EQ(action(ActionId::Save)->shortcut(), QKeySequence(QStringLiteral("Ctrl+S")));
    window->preferences().set(pref::shortcuts, QStringLiteral("thesis"));
    EXPECT_EQ(action(ActionId::StartServer)->shortcut(), QKeySequence(QStringLiteral("Ctrl+S")));
    EXPECT_EQ(action(ActionId::Connect)->shortcut(), QKeySequence(QStringLiteral("Ctrl+C")));
    EXPECT_EQ(action(ActionId::Save)->shortcut(), QKeySequence(QStringLiteral("Ctrl+Alt+S")));
    window->preferences().set(pref::shortcuts, QStringLiteral("desktop"));
    EXPECT_EQ(action(ActionId::CopyCamera)->shortcut(), QKeySequence(QStringLiteral("Ctrl+C")));
}

} // namespace
