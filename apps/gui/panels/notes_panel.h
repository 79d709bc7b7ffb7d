/// The notes of the scene. Knows neither files nor servers.
#pragma once

#include "gui/models/scene_state.h"

#include <QWidget>

#include <string>

class QListWidget;
class QPushButton;

namespace gui {

class PlainLabel;

class NotesPanel : public QWidget {
    Q_OBJECT

  public:
    explicit NotesPanel(QWidget* parent = nullptr);

    /// Selects a note that is new. Emits nothing.
    void show(const SceneState& state);
    using QWidget::show;
    void select(int index);
    int selected() const; ///< index; -1: none
    /// A click in the image sets the point of the next note; emits nothing.
    void setAdding(bool adding);

    // For tests.
    QListWidget& list() { return *list_; }
    PlainLabel& whole() { return *whole_; }
    QPushButton& adding() { return *add_; }
    QPushButton& going() { return *go_; }
    QPushButton& editing() { return *edit_; }
    QPushButton& removal() { return *remove_; }
    QPushButton& exporting() { return *export_; }

  signals:
    void addWanted(bool on);
    void editWanted(int index);
    void goWanted(int index);
    void exportWanted();
    /// A command (common/commands/command_lines.h) that is a step of undo by itself.
    void wanted(const std::string& line);

  private:
    void addButtons();
    void showList();
    void showWhole();
    void remove();

    SceneState state_;
    QListWidget* list_;
    PlainLabel* whole_;
    QPushButton *add_, *go_, *edit_, *remove_, *export_;
};

} // namespace gui
