#include "gui/operations/note_operations.h"

#include "gui/models/output_file.h"
#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/notes_panel.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/measure_marks.h"
#include "gui/view/note_marks.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QPlainTextEdit>

#include <algorithm>
#include <utility>

namespace gui {

NoteOperations::NoteOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new NotesPanel),
      marks_(new NoteMarks(context.view, context.session, this)),
      dock_(addPanel(context_, panel_, tr("Notes"), QStringLiteral("notes"), ActionId::NotesPanel)) {
    context_.actions.bind(ActionId::ShowNotes, pref::showNotes);
    const auto showMarks = [this] { marks_->setShown(context_.preferences.get(pref::showNotes)); };
    connect(&context_.preferences, &Preferences::changed, marks_, showMarks);
    showMarks();
    connect(context_.actions[ActionId::AddNote], &QAction::toggled, this, &NoteOperations::setAdding);
    connect(&context_.editor, &SceneEditor::stateChanged, this, [this] {
        panel_->show(context_.editor.state());
        marks_->setState(context_.editor.state());
    });
    connect(&context_.editor, &SceneEditor::sceneChanged, this, &NoteOperations::onScene);
    const auto enable = [this] {
        panel_->setEnabled(context_.session.live());
        if (!context_.session.live()) setAdding(false);
    };
    connect(&context_.session, &Session::stateChanged, panel_, enable);
    enable();
    connectPanel();
    connectMarks();
}

void NoteOperations::connectPanel() {
    connect(panel_, &NotesPanel::addWanted, this, &NoteOperations::setAdding);
    connect(panel_, &NotesPanel::editWanted, this, &NoteOperations::edit);
    connect(panel_, &NotesPanel::goWanted, this, &NoteOperations::goTo);
    connect(panel_, &NotesPanel::exportWanted, this, &NoteOperations::askForFile);
    connect(panel_, &NotesPanel::wanted, this,
            [this](const std::string& line) { context_.editor.edit(line); });
}

void NoteOperations::connectMarks() {
    connect(marks_, &NoteMarks::placed, this, &NoteOperations::ask);
    connect(marks_, &NoteMarks::left, this, [this] { setAdding(false); });
    connect(marks_, &NoteMarks::picked, this, [this](int index) {
        dock_->show();
        dock_->raise();
        panel_->select(index);
    });
}

// Clicks are for one thing at a time.
void NoteOperations::setAdding(bool adding) {
    adding = adding && context_.session.live();
    if (adding && !marks_->adding()) {
        context_.actions[ActionId::Measure]->setChecked(false);
        context_.view.input().release();
        context_.view.setFocus();
        context_.view.tell(tr("Click the place that the note is about. Esc ends."));
    }
    marks_->setAdding(adding);
    panel_->setAdding(adding);
    context_.actions[ActionId::AddNote]->setChecked(adding);
}

void NoteOperations::ask(const QPointF& at) {
    context_.session.send(command::measurePoint(at.x(), at.y()), this, [this](const Answer& answer) {
        const auto caught =
            answer.done ? readCaught(answer.text, context_.editor.state().origin) : std::nullopt;
        if (!caught) return context_.view.tell(tr("Nothing of the model is seen there."));
        if (marks_->adding()) write(caught->point);
    });
}

NoteDialog* NoteOperations::open(const QString& text, const QString& author, std::function<void()> again) {
    if (dialog_ != nullptr) dialog_->reject();
    dialog_ = new NoteDialog(text, author, &context_.window);
    scene_ = context_.editor.scene();
    begun_ = text;
    again_ = std::move(again);
    dialog_->open();
    return dialog_;
}

// A dialog would be in the way of what the window offers when its server is gone.
void NoteOperations::onScene() {
    setAdding(false);
    if (dialog_ != nullptr) {
        const QString text = dialog_->text().toPlainText();
        if (text != begun_) keepUnfinished(text, dialog_->author().text());
        dialog_->reject();
    } else if (unfinished_ && unfinished_->scene == context_.editor.scene()) {
        std::function<void()>(unfinished_->again)(); // which takes it
    }
}

void NoteOperations::keepUnfinished(const QString& text, const QString& author) {
    if (text.trimmed().isEmpty()) return;
    unfinished_ = {text, author, scene_, again_};
    context_.view.tell(tr("The text of the note is kept for the next one."));
}

void NoteOperations::send(const std::string& line, const QString& text, const QString& author) {
    context_.editor.edit(line, [this, text, author](const Answer& answer) {
        if (answer.done) return;
        keepUnfinished(text, author);
        context_.notice.explain(answer.text, {});
    });
}

void NoteOperations::write(const rtcore::Vec3d& point) {
    setAdding(false);
    const std::optional<Unfinished> left = std::exchange(unfinished_, std::nullopt);
    NoteDialog* dialog = open(QString(), left ? left->author : context_.preferences.get(pref::noteAuthor),
                              [this, point] { write(point); });
    if (left) dialog->text().setPlainText(left->text);
    marks_->setPending(point);
    connect(dialog, &QDialog::finished, marks_, [this] { marks_->setPending({}); });
    const std::array<double, 3>& zero = context_.editor.state().origin.at;
    const command::Position place{point.x + zero[0], point.y + zero[1], point.z + zero[2]};
    connect(dialog, &NoteDialog::written, this, [this, place](const QString& text, const QString& author) {
        context_.preferences.set(pref::noteAuthor, author);
        send(command::noteAdd(place, text.toStdString(), author.toStdString()), text, author);
    });
}

// The state has the beginnings of long texts only, where there are very many.
void NoteOperations::edit(int index) {
    const SceneState& state = context_.editor.state();
    if (index < 0 || index >= std::ssize(state.notes)) return;
    const rtcore::SceneNote note = state.notes[static_cast<std::size_t>(index)];
    if (!state.notesShortened) return change(note, QString::fromStdString(note.text));
    context_.session.send(command::noteGet(index + 1), this, [this, note](const Answer& answer) {
        if (!answer.done) return context_.notice.explain(answer.text, {});
        change(note, answer.text);
    });
}

int NoteOperations::indexOf(const rtcore::SceneNote& note) const {
    const rtcore::SceneNotes& all = context_.editor.state().notes;
    const auto found = std::ranges::find(all, note);
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

void NoteOperations::change(const rtcore::SceneNote& before, const QString& text) {
    const auto again = [this, before, text] {
        if (indexOf(before) < 0) return; // it stays for a new note
        const std::optional<Unfinished> left = std::exchange(unfinished_, std::nullopt);
        change(before, text);
        dialog_->text().setPlainText(left->text);
        dialog_->author().setText(left->author);
    };
    NoteDialog* dialog = open(text, QString::fromStdString(before.author), again);
    // Its number may be another one by then.
    connect(dialog, &NoteDialog::written, this, [this, before](const QString& now, const QString& by) {
        const int index = indexOf(before);
        if (index >= 0)
            return send(command::noteText(index + 1, now.toStdString(), by.toStdString()), now, by);
        keepUnfinished(now, by);
        context_.notice.explain(tr("This note was changed or removed meanwhile."), {});
    });
}

void NoteOperations::goTo(int index) {
    if (index < 0) return;
    context_.view.showLive();
    context_.editor.edit(command::noteGo(index + 1));
}

void NoteOperations::askForFile() {
    const QString kept = context_.preferences.get(pref::planFolder);
    const QString folder =
        !kept.isEmpty() && QFileInfo(kept).isDir() ? kept : context_.preferences.picturesFolder();
    auto* dialog = new QFileDialog(&context_.window, tr("Export the notes"),
                                   nextFreeName(folder, QStringLiteral("notes"), QStringLiteral("csv")),
                                   tr("Tables (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        context_.session.send(command::noteExport(path.toStdString()), this,
                              [this, path](const Answer& answer) {
                                  if (!answer.done) return context_.notice.explain(answer.text, {});
                                  context_.view.tell(tr("The notes were written to %1.").arg(path));
                              });
    });
    dialog->open();
}

} // namespace gui
