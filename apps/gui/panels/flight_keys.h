/// The key frames of the selected flight.
#pragma once

#include "gui/models/scene_state.h"

#include <QWidget>

#include <optional>
#include <string>

class QListWidget;
class QPushButton;

namespace gui {

class ValueBox;

class FlightKeys : public QWidget {
    Q_OBJECT

  public:
    explicit FlightKeys(QWidget* parent = nullptr);

    /// Nothing: no flight is selected. Emits nothing.
    void show(const std::optional<ShownFlight>& flight);
    using QWidget::show;
    int selected() const; ///< index; -1: none

    // For tests.
    QListWidget& list() { return *list_; }
    QPushButton& adding() { return *add_; }
    QPushButton& replacing() { return *set_; }
    QPushButton& movingUp() { return *up_; }
    QPushButton& movingDown() { return *down_; }
    QPushButton& removal() { return *remove_; }
    ValueBox& time() { return *time_; }

  signals:
    void addWanted();
    void goWanted(double seconds);
    /// A command (common/commands/command_lines.h) that is a step of undo by itself.
    void wanted(const std::string& line);
    /// The same of one that may go on with the last one of the same name.
    void edited(const QString& step, const std::string& line);

  private:
    void addButtons();
    void showList();
    void enable();
    void go();
    void move(int by);
    void remove();
    double secondsOf(int key) const;

    std::optional<ShownFlight> flight_;
    QListWidget* list_;
    QPushButton *add_, *set_, *up_, *down_, *remove_;
    ValueBox* time_;
};

} // namespace gui
