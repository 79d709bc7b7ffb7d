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

#include <algorithm>

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
    connect(&context_.editor, &SceneEditor::sceneChanged, this, [this] {
        setAdding(false);
        if (dialog_ != nullptr) dialog_->reject();
    });
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

NoteDialog* NoteOperations::open(const QString& text, const QString& author) {
    if (dialog_ != nullptr) dialog_->reject();
    dialog_ = new NoteDialog(text, author, &context_.window);
    dialog_->open();
    return dialog_;
}

void NoteOperations::write(const rtcore::Vec3d& point) {
    setAdding(false);
    NoteDialog* dialog = open(QString(), context_.preferences.get(pref::noteAuthor));
    marks_->setPending(point);
    connect(dialog, &QDialog::finished, marks_, [this] { marks_->setPending({}); });
    const std::array<double, 3>& zero = context_.editor.state().origin.at;
    const command::Position place{point.x + zero[0], point.y + zero[1], point.z + zero[2]};
    connect(dialog, &NoteDialog::written, this, [this, place](const QString& text, const QString& author) {
        context_.preferences.set(pref::noteAuthor, author);
        context_.editor.edit(command::noteAdd(place, text.toStdString(), author.toStdString()));
    });
}

// The state has the beginnings of long texts only, where there are very many.
void NoteOperations::edit(int index) {
    const SceneState& state = context_.editor.state();
    if (index < 0 || index >= std::ssize(state.notes)) return;
    const rtcore::SceneNote& note = state.notes[static_cast<std::size_t>(index)];
    if (!state.notesShortened) return change(index, QString::fromStdString(note.text));
    context_.session.send(command::noteGet(index + 1), this, [this, index](const Answer& answer) {
        if (!answer.done) return context_.notice.explain(answer.text, {});
        change(index, answer.text);
    });
}

void NoteOperations::change(int index, const QString& text) {
    const rtcore::SceneNotes& notes = context_.editor.state().notes;
    if (index >= std::ssize(notes)) return;
    const rtcore::SceneNote before = notes[static_cast<std::size_t>(index)];
    NoteDialog* dialog = open(text, QString::fromStdString(before.author));
    // Its number may be another one by then.
    connect(dialog, &NoteDialog::written, this, [this, before](const QString& now, const QString& by) {
        const rtcore::SceneNotes& all = context_.editor.state().notes;
        const auto found = std::ranges::find(all, before);
        if (found == all.end()) return context_.view.tell(tr("This note was changed or removed meanwhile."));
        const int number = static_cast<int>(found - all.begin()) + 1;
        context_.editor.edit(command::noteText(number, now.toStdString(), by.toStdString()));
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
