/// The measures that are kept with the scene, and what one measures next. Knows neither files nor servers.
#pragma once

#include "gui/models/scene_state.h"

#include <QString>
#include <QWidget>

#include <array>
#include <optional>
#include <string>

class QComboBox;
class QGroupBox;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace gui {

class PlainLabel;

class MeasuresPanel : public QWidget {
    Q_OBJECT

  public:
    explicit MeasuresPanel(QWidget* parent = nullptr);

    /// Selects a measure that is new. Emits nothing.
    void show(const SceneState& state);
    using QWidget::show;
    /// The tool that is in hand; emits nothing.
    void setTool(std::optional<rtcore::MeasureKind> kind);
    /// Points that are set: of a chain they can be kept.
    void setHint(const QString& hint);
    int selected() const; ///< index; -1: none

    // For tests.
    QPushButton& tool(rtcore::MeasureKind kind) { return *tools_.at(static_cast<std::size_t>(kind)); }
    QListWidget& list() { return *list_; }
    QLineEdit& name() { return *name_; }
    QPushButton& going() { return *go_; }
    QPushButton& removal() { return *remove_; }
    QPushButton& clearing() { return *clear_; }
    QPushButton& exporting() { return *export_; }
    QComboBox& unit() { return *unit_; }
    QSpinBox& decimals() { return *decimals_; }

  signals:
    void toolChosen(std::optional<rtcore::MeasureKind> kind);
    /// A command (common/commands/command_lines.h) that is a step of undo by itself.
    void wanted(const std::string& line);
    void goWanted(int index);
    void exportWanted();

  private:
    void addTools(QGroupBox& box);
    void addList(QGroupBox& box);
    void addLabels(QGroupBox& box);
    void showList();
    void showName();
    void enable();
    void remove();
    void rename();
    void chooseUnit();

    SceneState state_;
    bool showing_ = false; ///< changes are not the user's
    std::array<QPushButton*, rtcore::kMeasureKinds.size()> tools_{};
    PlainLabel* hint_;
    QListWidget* list_;
    QLineEdit* name_;
    QPushButton *go_, *remove_, *clear_, *export_;
    QComboBox* unit_;
    QSpinBox* decimals_;
};

} // namespace gui
