/// Fields of the sky with its sun, and of the environment map that is shown. They know no server.
#pragma once

#include "gui/models/scene_state.h"

#include <QString>
#include <QWidget>

#include <array>
#include <string>

class QCheckBox;
class QComboBox;
class QDateEdit;
class QFormLayout;
class QSlider;
class QTimeEdit;

namespace gui {

class ValueBox;

class SkyFields : public QWidget {
    Q_OBJECT

  public:
    explicit SkyFields(QWidget* parent = nullptr);

    /// Emits nothing.
    void show(const SceneState& state);
    using QWidget::show;

    // For tests.
    QComboBox& sun() { return *sun_; }
    QSlider& hour() { return *hour_; }
    QTimeEdit& time() { return *time_; }
    QDateEdit& date() { return *date_; }
    ValueBox& latitude() { return *latitude_; }
    ValueBox& longitude() { return *longitude_; }
    ValueBox& zone() { return *zone_; }
    ValueBox& north() { return *north_; }
    ValueBox& direction(std::size_t axis) { return *direction_.at(axis); }
    ValueBox& turbidity() { return *turbidity_; }
    ValueBox& strength() { return *strength_; }
    QCheckBox& ground() { return *ground_; }
    ValueBox& mapRotation() { return *mapRotation_; }
    ValueBox& mapStrength() { return *mapStrength_; }

  signals:
    /// A command (common/commands/command_lines.h), and the step of undo that it makes.
    void edited(const QString& step, const std::string& line);
    /// The sun is to stand where the camera looks.
    void sunAheadWanted();

  private:
    enum SunBy { Date, Direction };

    void addMap();
    void addSun();
    void addTime();
    void addPlace();
    void addDirection();
    void addAir();
    ValueBox* number(const QString& label, double min, double max, const QString& unit = {});
    /// Sends each change of the value as the command that `line` makes of it.
    void sends(ValueBox* box, const char* step, std::string (*line)(double));
    void sendPlace();
    void sendDirection();
    void chooseSun(int by);
    void send(const char* step, const std::string& line);
    void showSky(const rtcore::Sky& sky);
    void showRows();

    QFormLayout* form_;
    SceneState state_;
    bool showing_ = false; ///< changes are not the user's
    ValueBox *mapRotation_, *mapStrength_;
    QCheckBox *ground_, *haze_;
    QComboBox* sun_;
    QSlider* hour_;
    QTimeEdit* time_;
    QDateEdit* date_;
    ValueBox *latitude_, *longitude_, *zone_, *north_, *turbidity_, *strength_;
    std::array<ValueBox*, 3> direction_;
    QWidget *timeRow_, *directionRow_, *aheadRow_;
};

} // namespace gui
