#include "gui/operations/flight_operations.h"

#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/flight_player.h"
#include "gui/panels/flights_panel.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

#include <QSlider>

#include <chrono>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 50ms;

} // namespace

FlightOperations::FlightOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new FlightsPanel) {
    addPanel(context_, panel_, tr("Flights"), QStringLiteral("flights"), ActionId::FlightsPanel);
    context_.actions.on(ActionId::AddKeyFrame, [this] { panel_->addKey(); });
    connect(&context_.editor, &SceneEditor::stateChanged, this,
            [this] { panel_->show(context_.editor.state()); });
    const auto enable = [this] {
        panel_->setEnabled(context_.session.live());
        if (!context_.session.live()) endPlaying();
    };
    connect(&context_.session, &Session::stateChanged, panel_, enable);
    enable();
    connectPanel();
    ticks_.setInterval(kTick);
    connect(&ticks_, &QTimer::timeout, this, &FlightOperations::showPlaying);
    listenToHand();
}

void FlightOperations::connectPanel() {
    connect(panel_, &FlightsPanel::wanted, this, &FlightOperations::edit);
    connect(panel_, &FlightsPanel::keyWanted, this, &FlightOperations::addKey);
    connect(panel_, &FlightsPanel::edited, &context_.editor,
            [this](const QString& step, const std::string& line) { context_.editor.follow(step, line); });
    connect(panel_, &FlightsPanel::goWanted, this, &FlightOperations::go);
    connect(panel_, &FlightsPanel::playWanted, this, &FlightOperations::play);
    connect(panel_, &FlightsPanel::stopWanted, this, &FlightOperations::stop);
    connect(panel_, &FlightsPanel::filmWanted, this, &FlightOperations::filmWanted);
}

// The server ends a flight when the user moves.
void FlightOperations::listenToHand() {
    InputCapture& input = context_.view.input();
    connect(&input, &InputCapture::keyPressed, this, &FlightOperations::endPlaying);
    connect(&input, &InputCapture::turned, this, &FlightOperations::endPlaying);
    connect(&input, &InputCapture::dragged, this, &FlightOperations::endPlaying);
    connect(&input, &InputCapture::pushed, this, &FlightOperations::endPlaying);
    connect(&input, &InputCapture::neared, this, &FlightOperations::endPlaying);
    connect(&input, &InputCapture::reached, this, &FlightOperations::endPlaying);
}

void FlightOperations::edit(const std::string& line) {
    context_.editor.edit(line, [this](const Answer& answer) { onRefusal(answer); });
}

void FlightOperations::addKey(const QString& name) {
    context_.editor.edit(command::flightKeyAdd(name.toStdString()), [this, name](const Answer& answer) {
        if (answer.done) context_.view.tell(tr("Key frame %1 of %2").arg(answer.text, name));
        onRefusal(answer);
    });
}

void FlightOperations::onRefusal(const Answer& answer) {
    if (answer.done) return;
    panel_->refused();
    context_.notice.explain(answer.text, {});
}

void FlightOperations::go(const QString& name, double seconds, std::optional<bool> goesOn) {
    endPlaying();
    context_.view.showLive();
    context_.editor.follow(QStringLiteral("flight go ") + name,
                           command::flightGo(name.toStdString(), seconds), goesOn);
}

// --- Playing ---

void FlightOperations::play(const QString& name, double from) {
    context_.view.showLive();
    context_.session.send(command::flightPlay(name.toStdString(), from), this,
                          [this, from](const Answer& answer) {
                              if (!answer.done) return context_.notice.explain(answer.text, {});
                              from_ = from;
                              moved_ = false;
                              clock_.start();
                              ticks_.start();
                              panel_->player().setPlaying(true);
                          });
}

void FlightOperations::stop() {
    context_.session.send(command::playStop());
    endPlaying();
}

// The server tells of no time: it is that of the window's clock, until it rests.
void FlightOperations::showPlaying() {
    constexpr double kThousand = 1000, kStart = 1; // milliseconds; seconds until a server begins
    FlightPlayer& player = panel_->player();
    const double lasts = static_cast<double>(clock_.elapsed()) / kThousand;
    moved_ = moved_ || !context_.session.status().idle;
    player.showSeconds(from_ + lasts);
    const bool over = from_ + lasts >= player.slider().maximum() / kThousand;
    if (over || (context_.session.status().idle && (moved_ || lasts > kStart))) endPlaying();
}

void FlightOperations::endPlaying() {
    ticks_.stop();
    panel_->player().setPlaying(false);
}

} // namespace gui
