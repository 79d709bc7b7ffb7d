/// The planes that cut the model open, and what closes the solids that they cut. Knows neither files nor
/// servers.
#pragma once

#include "gui/models/scene_state.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <string>

class QCheckBox;
class QComboBox;
class QGroupBox;
class QListWidget;
class QPushButton;

namespace gui {

class ColourButton;
class ValueBox;
class ValueSlider;

/// The side that a section takes away, and the line along which its position is told: the axis that its
/// normal lies on, if it lies on one, else the normal.
struct SectionSide {
    QString away;       ///< "above %1", with room for the position
    QString coordinate; ///< "y"; empty: it is along no axis
    rtcore::Vec3 along; ///< unit vector
};
/// `up`: as SceneState has it. `normal`: not zero.
SectionSide sideOf(rtcore::Vec3 normal, const QString& up);

class SectionsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SectionsPanel(QWidget* parent = nullptr);

    /// Selects a section that is new. Emits nothing.
    void show(const SceneState& state);
    using QWidget::show;
    void select(int number);    ///< from 1; emits selectionChanged()
    int selectedNumber() const; ///< from 1; 0: none
    /// The step of undo of moving a section, from 1.
    static QString stepAt(int number) { return QStringLiteral("section at %1").arg(number); }

    // For tests.
    QPushButton& above() { return *above_; }
    QPushButton& front() { return *front_; }
    QPushButton& right() { return *right_; }
    QPushButton& here() { return *here_; }
    QListWidget& list() { return *list_; }
    QPushButton& turn() { return *turn_; }
    QPushButton& removal() { return *remove_; }
    QPushButton& clearing() { return *clear_; }
    ValueSlider& slider() { return *slider_; }
    ValueBox& position() { return *position_; }
    QComboBox& light() { return *light_; }
    QComboBox& caps() { return *caps_; }
    ColourButton& colour() { return *colour_; }
    QCheckBox& hatching() { return *hatching_; }

  signals:
    /// A command (common/commands/command_lines.h) that is a step of undo by itself.
    void wanted(const std::string& line);
    /// One of those that follow a hand, and the step that it makes; `goesOn` as SceneEditor::follow() has it.
    void edited(const QString& step, const std::string& line, std::optional<bool> goesOn);
    void selectionChanged(int number); ///< from 1; 0: none

  private:
    /// A line through the model along which the selected plane moves: coordinates of the model's file, in
    /// scene units.
    struct Track {
        rtcore::Vec3 along;
        double at = 0, zero = 0; ///< of the plane, of the scene's own zero
        double lo = 0, hi = 0;   ///< ends of the model
    };
    Track trackOf(const rtcore::SectionPlane& plane) const;
    /// Null while none is selected.
    const rtcore::SectionPlane* selected() const;

    void addCuts(QGroupBox& box);
    void addList(QGroupBox& box);
    void addPosition(QGroupBox& box);
    void addStyle(QGroupBox& box);
    QPushButton* button(const QString& text, const QString& tip);
    void cutThrough(rtcore::Vec3 axis);
    void moveTo(double position, std::optional<bool> goesOn);
    void showList();
    void showPosition();
    void showStyle();
    void enable();
    QString nameOf(const rtcore::SectionPlane& plane) const;
    double metresPerUnit() const;
    double inMetres(double length) const { return length * metresPerUnit(); }

    SceneState state_;
    bool showing_ = false; ///< changes are not the user's
    bool dragged_ = false; ///< the slider has moved since it was taken
    QPushButton *above_, *front_, *right_, *here_, *turn_, *remove_, *clear_;
    QListWidget* list_;
    ValueSlider* slider_;
    ValueBox* position_;
    QComboBox *light_, *caps_;
    ColourButton* colour_;
    QCheckBox* hatching_;
};

} // namespace gui
