/// Notes: writing them, their panel, and their marks in the image.
#pragma once

#include "gui/dialogs/note_dialog.h"
#include "gui/operations/gui_context.h"

#include "rtcore/math/vec.h"

#include <QObject>
#include <QPointF>
#include <QPointer>

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
    void change(int index, const QString& text);
    void goTo(int index);
    void askForFile();
    NoteDialog* open(const QString& text, const QString& author);

    GuiContext context_;
    NotesPanel* panel_;
    NoteMarks* marks_;
    QDockWidget* dock_;
    QPointer<NoteDialog> dialog_;
};

} // namespace gui
