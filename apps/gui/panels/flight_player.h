/// Plays the selected flight, and shows when it is where.
#pragma once

#include "gui/models/scene_state.h"

#include <QWidget>

#include <optional>

class QPushButton;
class QSlider;

namespace gui {

class PlainLabel;
class TickedSlider;

class FlightPlayer : public QWidget {
    Q_OBJECT

  public:
    explicit FlightPlayer(QWidget* parent = nullptr);

    /// Null: none is selected. Another one begins at 0, and ends what is played.
    void setFlight(const ShownFlight* flight);
    /// The flight is called so from its next setFlight() on, and stays where it is.
    void rename(const QString& name) { name_ = name; }
    double seconds() const; ///< from the beginning
    /// Emits nothing.
    void showSeconds(double seconds);
    void setPlaying(bool playing);
    bool playing() const { return playing_; }

    // For tests.
    QSlider& slider();
    QPushButton& button() { return *play_; }

  signals:
    /// `goesOn` as in SceneEditor::follow(): one drag is one step.
    void goWanted(double seconds, std::optional<bool> goesOn);
    void playWanted(double from); ///< seconds
    void stopWanted();

  private:
    void press();
    void move(int milliseconds);
    void showTime();

    QPushButton* play_;
    TickedSlider* slider_;
    PlainLabel* time_;
    QString name_;
    bool playing_ = false;
    bool begun_ = false; ///< a drag has moved the slider
};

} // namespace gui
