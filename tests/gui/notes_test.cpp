/// Notes: their texts, their panel and their dialog alone, and writing them with a real server.
#include "gui/window_support.h"

#include "gui/dialogs/note_dialog.h"
#include "gui/models/note_texts.h"
#include "gui/models/plain_text.h"
#include "gui/operations/note_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/notes_panel.h"
#include "gui/view/measure_marks.h"
#include "gui/view/note_marks.h"
#include "gui/view/notice_bar.h"
#include "gui/view/plain_widgets.h"

#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>

#include <gtest/gtest.h>

#include <csignal>

namespace gui {
namespace {

using test::comes;

SceneState notedState() {
    SceneState state;
    state.notes = {{.point = {0, 0, 0}, .text = "too <b>dark</b>\nhere & there", .author = "Ada", .view = {}},
                   {.point = {1, 0, 0}, .text = "fine", .view = {}, .written = "2026-11-30T18:40:00Z"}};
    state.noteCount = 2;
    return state;
}

TEST(NoteTextsTest, TellNumberAuthorAndTextOnOneLine) {
    const SceneState state = notedState();
    EXPECT_EQ(noteRow(state.notes[0], 1), QStringLiteral("1  Ada: too <b>dark</b> here & there"));
    EXPECT_EQ(noteRow(state.notes[1], 2), QStringLiteral("2  fine"));
    EXPECT_EQ(noteHead(state.notes[0]), QStringLiteral("Ada"));
    EXPECT_NE(noteHead(state.notes[1]), QString());
    EXPECT_EQ(wholeNote(state.notes[0]), QStringLiteral("Ada\ntoo <b>dark</b>\nhere & there"));
}

TEST(NotesPanelTest, ShowsTextsOfStrangersAsText) {
    NotesPanel panel;
    SceneState state = notedState();
    state.noteCount = 5;
    panel.show(state);
    ASSERT_EQ(panel.list().count(), 3);
    EXPECT_EQ(panel.list().item(2)->text(), QStringLiteral("3 more"));
    EXPECT_EQ(panel.list().currentRow(), 1) << "the newest";
    panel.select(0);
    EXPECT_EQ(panel.whole().text(), QStringLiteral("Ada\ntoo <b>dark</b>\nhere & there"));
    EXPECT_EQ(panel.whole().textFormat(), Qt::PlainText);
    const QString tip = panel.list().item(0)->toolTip();
    EXPECT_EQ(tip, plainTip(wholeNote(state.notes[0]))) << "which is no markup";
    state.notes.push_back(state.notes[1]);
    panel.show(state);
    EXPECT_EQ(panel.list().currentRow(), 0) << "the selected one, though others write";
}

TEST(NotesPanelTest, AsksForWhatIsChosen) {
    NotesPanel panel;
    for (QPushButton* each : {&panel.going(), &panel.editing(), &panel.removal(), &panel.exporting()})
        EXPECT_FALSE(each->isEnabled());
    panel.show(notedState());
    std::vector<std::string> lines;
    QObject::connect(&panel, &NotesPanel::wanted, &panel,
                     [&](const std::string& line) { lines.push_back(line); });
    QObject::connect(&panel, &NotesPanel::goWanted, &panel,
                     [&](int index) { lines.push_back("go " + std::to_string(index)); });
    QObject::connect(&panel, &NotesPanel::editWanted, &panel,
                     [&](int index) { lines.push_back("edit " + std::to_string(index)); });
    panel.select(0);
    panel.going().click();
    panel.editing().click();
    emit panel.list().itemActivated(panel.list().item(0));
    panel.select(1);
    panel.removal().click();
    EXPECT_EQ(lines, (std::vector<std::string>{"go 0", "edit 0", "go 0", "note remove 2"}));
}

TEST(NoteDialogTest, KeepsATextThatIsNotTooLong) {
    NoteDialog dialog(QString(), QStringLiteral("Ada"));
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    QStringList kept;
    QObject::connect(&dialog, &NoteDialog::written, &dialog,
                     [&](const QString& text, const QString& author) { kept << text << author; });
    EXPECT_FALSE(dialog.keeping().isEnabled());
    dialog.text().setPlainText(QStringLiteral(" \n"));
    EXPECT_FALSE(dialog.keeping().isEnabled());
    dialog.text().setPlainText(QString(2001, QLatin1Char('x')));
    EXPECT_FALSE(dialog.keeping().isEnabled());
    dialog.text().setPlainText(QStringLiteral("too\ndark \x1B"));
    EXPECT_TRUE(dialog.keeping().isEnabled());
    dialog.author().setText(QStringLiteral(" Ben "));
    dialog.keeping().click();
    EXPECT_EQ(kept, (QStringList{QStringLiteral("too\ndark"), QStringLiteral("Ben")}));
}

class NotesOfAServer : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        window->preferences().set(pref::noteAuthor, QString());
        openAndRest();
    }
    NotesPanel& panel() { return *window->findChild<NotesPanel*>(); }
    NoteMarks& marks() { return *window->findChild<NoteMarks*>(); }
    NoteDialog* dialog() { return window->findChild<NoteOperations*>()->dialog(); }
    const rtcore::SceneNotes& notes() { return window->editor().state().notes; }
    bool keeps(std::size_t count) {
        return comes([&] { return notes().size() == count; });
    }
    void click(const QPointF& at) { QTest::mouseClick(&window->view(), Qt::LeftButton, {}, at.toPoint()); }
    QPointF belowTheMiddle() {
        const QRectF area = window->view().pictureArea();
        return area.center() + QPointF(0, 0.2 * area.height());
    }
    void write(const QString& text, const QString& author) {
        ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
        dialog()->text().setPlainText(text);
        dialog()->author().setText(author);
        dialog()->keeping().click();
    }
    void add(const QString& text) {
        action(ActionId::AddNote)->trigger();
        click(belowTheMiddle());
        write(text, QStringLiteral("Ada"));
    }
};

TEST_F(NotesOfAServer, AreWrittenAfterAClickAndTakenBack) {
    action(ActionId::AddNote)->trigger();
    EXPECT_TRUE(marks().adding());
    EXPECT_TRUE(panel().adding().isChecked());
    click(belowTheMiddle());
    write(QStringLiteral("<b>too dark</b>"), QStringLiteral("Ada"));
    ASSERT_TRUE(keeps(1));
    EXPECT_FALSE(marks().adding());
    EXPECT_FALSE(window->view().input().captured());
    EXPECT_EQ(notes()[0].text, "<b>too dark</b>");
    EXPECT_EQ(notes()[0].author, "Ada");
    EXPECT_EQ(window->preferences().get(pref::noteAuthor), QStringLiteral("Ada"));
    const auto place = marks().place(0);
    ASSERT_TRUE(place);
    EXPECT_LT((*place - belowTheMiddle()).manhattanLength(), 80)
        << "corners catch within 8 pixels of an image of a quarter of these";
    action(ActionId::Undo)->trigger();
    EXPECT_TRUE(keeps(0));
}

TEST_F(NotesOfAServer, AreWrittenOnWhenTheServerIsBack) {
    action(ActionId::AddNote)->trigger();
    click(belowTheMiddle());
    ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
    dialog()->text().setPlainText(QStringLiteral("half a no"));
    dialog()->author().setText(QStringLiteral("Ada"));
    ::kill(static_cast<pid_t>(window->session().serverProcess()), SIGKILL);
    ASSERT_TRUE(comes([&] { return !window->session().live(); }));
    ASSERT_TRUE(comes([&] { return dialog() == nullptr; })) << "in the way of the button";
    ASSERT_TRUE(comes([&] { return window->notice().isVisible(); }));
    QPushButton* restart = window->notice().findChild<QPushButton*>();
    ASSERT_NE(restart, nullptr);
    restart->click();
    ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
    EXPECT_EQ(dialog()->text().toPlainText(), QStringLiteral("half a no"));
    EXPECT_EQ(dialog()->author().text(), QStringLiteral("Ada"));
    write(QStringLiteral("half a note"), QStringLiteral("Ada"));
    ASSERT_TRUE(keeps(1));
    EXPECT_EQ(notes()[0].text, "half a note");
    ASSERT_TRUE(comes([&] { return status().idle; })) << "there is an image to click into";
    action(ActionId::AddNote)->trigger();
    click(belowTheMiddle());
    ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
    EXPECT_EQ(dialog()->text().toPlainText(), QString()) << "it was kept";
    dialog()->reject();
}

TEST_F(NotesOfAServer, ThatAreRefusedAreThereForTheNext) {
    ASSERT_NO_FATAL_FAILURE(add(QStringLiteral("dark")));
    ASSERT_TRUE(keeps(1));
    panel().select(0);
    panel().editing().click();
    ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("note remove 1")).done);
    ASSERT_TRUE(keeps(0));
    write(QStringLiteral("much darker"), QStringLiteral("Ada"));
    ASSERT_TRUE(comes([&] { return dialog() == nullptr; }));
    action(ActionId::AddNote)->trigger();
    click(belowTheMiddle());
    ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
    EXPECT_EQ(dialog()->text().toPlainText(), QStringLiteral("much darker"));
    dialog()->reject();
    ASSERT_TRUE(comes([&] { return dialog() == nullptr; }));
    action(ActionId::AddNote)->trigger();
    click(belowTheMiddle());
    ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
    EXPECT_EQ(dialog()->text().toPlainText(), QString()) << "it was given up";
    dialog()->reject();
}

TEST_F(NotesOfAServer, AreShownAtThePointerAndPickedByAClick) {
    ASSERT_NO_FATAL_FAILURE(add(QStringLiteral("dark")));
    ASSERT_TRUE(keeps(1));
    ASSERT_TRUE(ask(window->session(), QStringLiteral("note add 0 1e6 0 far")).done);
    ASSERT_TRUE(keeps(2));
    const QPointF place = *marks().place(0);
    QTest::mouseMove(&window->view(), place.toPoint() + QPoint(60, 60));
    EXPECT_EQ(marks().hovered(), -1);
    QTest::mouseMove(&window->view(), place.toPoint());
    EXPECT_EQ(marks().hovered(), 0);
    panel().select(1);
    click(place);
    EXPECT_EQ(panel().selected(), 0);
    EXPECT_TRUE(panel().isVisible());
    EXPECT_FALSE(window->view().input().captured());
    action(ActionId::ShowNotes)->trigger();
    EXPECT_FALSE(marks().place(0));
    action(ActionId::ShowNotes)->trigger();
}

TEST_F(NotesOfAServer, AreHiddenWhereASectionTakesTheirPlaceAway) {
    ASSERT_NO_FATAL_FAILURE(add(QStringLiteral("dark")));
    ASSERT_TRUE(keeps(1));
    const rtcore::Vec3d p = notes()[0].point;
    const auto section = [&](double down) {
        return QStringLiteral("section add %1 %2 %3 0 1 0").arg(p.x).arg(p.y + down).arg(p.z);
    };
    ASSERT_TRUE(ask(window->session(), section(1)).done);
    ASSERT_TRUE(comes([&] { return window->editor().state().sections.planes.size() == 1; }));
    EXPECT_TRUE(marks().place(0));
    ASSERT_TRUE(ask(window->session(), section(-1)).done);
    EXPECT_TRUE(comes([&] { return !marks().place(0); }));
}

TEST_F(NotesOfAServer, AreEditedAndRemoved) {
    ASSERT_NO_FATAL_FAILURE(add(QStringLiteral("dark")));
    ASSERT_TRUE(keeps(1));
    panel().select(0);
    panel().editing().click();
    ASSERT_TRUE(comes([&] { return dialog() != nullptr; }));
    EXPECT_EQ(dialog()->text().toPlainText(), QStringLiteral("dark"));
    EXPECT_EQ(dialog()->author().text(), QStringLiteral("Ada"));
    write(QStringLiteral("bright"), QString());
    ASSERT_TRUE(comes([&] { return notes()[0].text == "bright"; }));
    EXPECT_EQ(notes()[0].author, "");
    panel().removal().click();
    EXPECT_TRUE(keeps(0));
    EXPECT_EQ(panel().list().count(), 0);
}

TEST_F(NotesOfAServer, LeadToTheirView) {
    ASSERT_NO_FATAL_FAILURE(add(QStringLiteral("dark")));
    ASSERT_TRUE(keeps(1));
    const QVector3D eye = status().view.eye;
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera turn 90 0")).done);
    ASSERT_TRUE(ask(window->session(), QStringLiteral("camera set 50 50 50 1 0 0")).done);
    ASSERT_TRUE(comes([&] { return (status().view.eye - eye).length() > 1; }));
    panel().select(0);
    panel().going().click();
    EXPECT_TRUE(comes([&] { return (status().view.eye - eye).length() < 1e-3F; }));
}

TEST_F(NotesOfAServer, GiveClicksToOneThingAtATime) {
    action(ActionId::AddNote)->trigger();
    action(ActionId::Measure)->trigger();
    EXPECT_FALSE(marks().adding());
    EXPECT_FALSE(action(ActionId::AddNote)->isChecked());
    EXPECT_TRUE(window->view().clicksTaken());
    action(ActionId::AddNote)->trigger();
    EXPECT_FALSE(action(ActionId::Measure)->isChecked());
    EXPECT_TRUE(window->view().clicksTaken());
    QTest::keyClick(&window->view(), Qt::Key_Escape);
    EXPECT_FALSE(marks().adding());
    EXPECT_FALSE(window->view().clicksTaken());
}

} // namespace
} // namespace gui
