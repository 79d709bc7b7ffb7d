/// The fields of one light: what can be changed of it, as its kind has it. Knows no server.
#pragma once

#include "gui/models/scene_state.h"

#include <QColor>
#include <QString>
#include <QStringList>
#include <QWidget>

#include <array>
#include <string>

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QCheckBox;

namespace gui {

class PowerField;
class ValueBox;

/// The name of a kind of light, for users.
QString lightKindText(rtcore::LightKind kind);
/// All of them in English; the context is "LightKinds".
QStringList lightKindTexts();
/// The name of a light, or what stands for it.
QString lightText(const ShownLight& light);

/// That of a light, as bright as a screen shows it.
QColor lightColour(const rtcore::LightDescription& light);

class LightFields : public QWidget {
    Q_OBJECT

  public:
    explicit LightFields(QWidget* parent = nullptr);

    /// Emits nothing. `light` has a description. Lengths are shown in metres.
    /// `origin`: of the scene, from which its positions count.
    void show(const ShownLight& light, float metresPerUnit, const rtcore::LocalOrigin& origin);
    using QWidget::show;

    // For tests.
    QLineEdit& name() { return *name_; }
    QComboBox& kind() { return *kind_; }
    ValueBox& position(std::size_t axis) { return *position_.at(axis); }
    ValueBox& direction(std::size_t axis) { return *direction_.at(axis); }
    PowerField& power() { return *power_; }
    QCheckBox& hasTemperature() { return *hasTemperature_; }
    ValueBox& temperature() { return *temperature_; }
    ValueBox& size(std::size_t i) { return *size_.at(i); }
    ValueBox& angle(std::size_t i) { return *angles_.at(i); }
    QCheckBox& mirrored() { return *mirrored_; }

  signals:
    /// A command (common/commands/command_lines.h), and the step of undo that it makes.
    void edited(const QString& step, const std::string& line);

  private:
    using Vector = std::array<ValueBox*, 3>;

    void addIdentity();
    void addPlace();
    void addColour();
    void addShape();
    void addFile();
    Vector vectorFields(const QString& name, double max);
    /// The other two components stay to the last bit.
    void onPosition();
    void onDirection();
    void showPosition(rtcore::Vec3 position);
    QWidget* row(const QString& label, std::initializer_list<QWidget*> fields);
    /// Below their label, so that all digits have room.
    QWidget* rowBelow(const QString& label, const Vector& fields);
    QPushButton* button(const QString& text, const QString& tip, const char* step, std::string (*line)(int));
    void send(const char* step, const std::string& line);
    void showSize(const rtcore::Light& light);
    void showRows(const rtcore::LightTraits& traits);
    void chooseColour();
    void chooseFile();
    void showColour();

    double inMetres(double length) const { return length * static_cast<double>(metresPerUnit_); }
    double inUnits(double metres) const;

    QFormLayout* form_;
    ShownLight light_;
    float metresPerUnit_ = 1;
    rtcore::LocalOrigin origin_;
    bool showing_ = false; ///< changes are not the user's
    QLineEdit* name_;
    QComboBox* kind_;
    Vector position_, direction_;
    QPushButton* colour_;
    QCheckBox *hasTemperature_, *mirrored_;
    ValueBox* temperature_;
    PowerField* power_;
    std::array<ValueBox*, 2> size_, angles_;
    QWidget *positionRow_, *positionButtons_, *directionRow_, *directionButtons_, *turnRow_, *sizeRow_,
        *anglesRow_;
    QPushButton* file_;
};

} // namespace gui
