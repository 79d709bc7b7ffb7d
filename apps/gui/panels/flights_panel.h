/// The flights of the scene: cameras along a path by key frames. Knows neither files nor servers.
#pragma once

#include "gui/models/scene_state.h"

#include <QWidget>

#include <optional>
#include <string>

class QCheckBox;
class QComboBox;
class QPushButton;
class QTableWidget;

namespace gui {

class FlightKeys;
class FlightPlayer;
class ValueBox;

class FlightsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FlightsPanel(QWidget* parent = nullptr);

    /// Emits nothing.
    void show(const SceneState& state);
    using QWidget::show;
    /// Selects the flight, once it is there.
    void select(const QString& name);
    QString selected() const; ///< its name; "": none
    /// Keeps the current view as the last key frame of the selected flight, or of a new one.
    void addKey();
    /// An edit that was wanted is not taken: all is as in the last state again. Emits nothing.
    void refused();

    // For tests.
    QTableWidget& list() { return *list_; }
    FlightPlayer& player() { return *player_; }
    FlightKeys& keys() { return *keys_; }
    QPushButton& making() { return *new_; }
    QPushButton& turning() { return *turntable_; }
    QPushButton& passing() { return *through_; }
    QPushButton& removal() { return *remove_; }
    QPushButton& filming() { return *film_; }
    ValueBox& seconds() { return *seconds_; }
    QComboBox& timing() { return *timing_; }
    QCheckBox& closing() { return *closed_; }

  signals:
    /// A command (common/commands/command_lines.h) that is a step of undo by itself.
    void wanted(const std::string& line);
    /// The same of one that may go on with the last one of the same name.
    void edited(const QString& step, const std::string& line);
    /// The current view is to be the last key frame of the flight, which may be a new one.
    void keyWanted(const QString& name);
    void goWanted(const QString& name, double seconds, std::optional<bool> goesOn); ///< FlightPlayer
    void playWanted(const QString& name, double from);                              ///< seconds
    void stopWanted();
    void filmWanted(const QString& name);

  private:
    void makeList();
    void makeButtons();
    void makeFields();
    void listenToParts();
    QWidget* buttonGrid();
    /// Selects the flight of that name and a free number, once it is there.
    QString newName(const QString& pattern);
    void remove();
    void rename(int row, const QString& text);
    void showList();
    void showSelected();
    const ShownFlight* flight() const; ///< the selected one; null: none

    SceneState state_;
    QString chosen_; ///< the name of the selected one, or of one that is on its way
    QTableWidget* list_;
    QPushButton *new_, *turntable_, *through_, *remove_, *film_;
    FlightPlayer* player_;
    FlightKeys* keys_;
    ValueBox* seconds_;
    QComboBox* timing_;
    QCheckBox* closed_;
};

} // namespace gui
