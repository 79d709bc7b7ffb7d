/// Flights: their panel, playing them, and key frames of the current view.
#pragma once

#include "gui/operations/gui_context.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <optional>
#include <string>

namespace gui {

class FlightsPanel;
struct Answer;

class FlightOperations : public QObject {
    Q_OBJECT

  public:
    FlightOperations(const GuiContext& context, QObject* parent);

  signals:
    /// A film of the flight is to be rendered.
    void filmWanted(const QString& name);

  private:
    void connectPanel();
    void listenToHand();
    void edit(const std::string& line);
    void addKey(const QString& name);
    void onRefusal(const Answer& answer);
    void go(const QString& name, double seconds, std::optional<bool> goesOn);
    void play(const QString& name, double from);
    void stop();
    void showPlaying();
    void endPlaying();

    GuiContext context_;
    FlightsPanel* panel_;
    QTimer ticks_; ///< while one is played
    QElapsedTimer clock_;
    double from_ = 0;    ///< seconds from its beginning, when clock_ began
    bool moved_ = false; ///< the server was seen moving since
};

} // namespace gui
