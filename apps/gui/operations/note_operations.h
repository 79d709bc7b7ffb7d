/// Notes: writing them, their panel, and their marks in the image.
#pragma once

#include "gui/dialogs/note_dialog.h"
#include "gui/operations/gui_context.h"

#include "rtcore/math/vec.h"
#include "rtcore/scene/scene_note.h"

#include <QObject>
#include <QPointF>
#include <QPointer>

#include <functional>
#include <optional>
#include <string>

class QDockWidget;

namespace gui {

class NoteMarks;
class NotesPanel;

class NoteOperations : public QObject {
    Q_OBJECT

  public:
    NoteOperations(const GuiContext& context, QObject* parent);

    /// While one is written; null: none is.
    NoteDialog* dialog() const { return dialog_; }

  private:
    void connectPanel();
    void connectMarks();
    void setAdding(bool adding);
    void ask(const QPointF& at);
    void write(const rtcore::Vec3d& point);
    void edit(int index);
    void change(const rtcore::SceneNote& before, const QString& text);
    int indexOf(const rtcore::SceneNote& note) const;
    void onScene();
    void keepUnfinished(const QString& text, const QString& author);
    void send(const std::string& line, const QString& text, const QString& author);
    void goTo(int index);
    void askForFile();
    /// `again` opens it once more, with what was written.
    NoteDialog* open(const QString& text, const QString& author, std::function<void()> again);

    GuiContext context_;
    NotesPanel* panel_;
    NoteMarks* marks_;
    QDockWidget* dock_;
    QPointer<NoteDialog> dialog_;

    /// A text that was neither kept by a server nor given up by the user.
    struct Unfinished {
        QString text, author;
        QString scene;               ///< in which it was begun
        std::function<void()> again; ///< opens the dialog once more
    };
    std::optional<Unfinished> unfinished_;
    QString scene_, begun_;       ///< in which the last dialog was opened, and with what text
    std::function<void()> again_; ///< of that
};

} // namespace gui
