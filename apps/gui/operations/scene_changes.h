/// What lies on the undo stack. The first redo() does nothing where the server has made the change already.
#pragma once

#include "gui/operations/scene_editor.h"

#include <QUndoCommand>

namespace gui {

/// One setting; changes of the same one within a second become one step.
class SettingChange : public QUndoCommand {
  public:
    SettingChange(SceneEditor& editor, const QString& name, const QString& before, const QString& after);
    void undo() override;
    void redo() override;
    int id() const override { return 1; }
    bool mergeWith(const QUndoCommand* other) override;

  private:
    SceneEditor& editor_;
    QString name_, before_, after_;
    qint64 time_; ///< milliseconds
    bool done_ = true;
};

/// Settings, lights, environment at once; redo() makes it.
class StateChange : public QUndoCommand {
  public:
    StateChange(SceneEditor& editor, const QString& label, SceneState before, SceneState after);
    void undo() override;
    void redo() override;

  private:
    SceneEditor& editor_;
    SceneState before_, after_;
};

/// The camera, and what a .cam file brings with it.
class PlacementChange : public QUndoCommand {
  public:
    PlacementChange(SceneEditor& editor, const QString& label, Placement before, Placement after);
    void undo() override;
    void redo() override;

  private:
    SceneEditor& editor_;
    Placement before_, after_;
    bool done_ = true;
};

} // namespace gui
