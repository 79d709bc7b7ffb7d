#include "gui/operations/look_operations.h"

#include "gui/dialogs/field_of_view_dialog.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/operations/to_middle.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/input_capture.h"
#include "gui/view/notice_bar.h"

#include <QPointF>
#include <QtMath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gui {

namespace {

constexpr int kMilliseconds = 350;

} // namespace

QVector3D directionThrough(const View& view, const QPointF& inPicture, double aspect) {
    const QVector3D right = QVector3D::crossProduct(view.forward, view.up).normalized();
    const QVector3D up = QVector3D::crossProduct(right, view.forward).normalized();
    const double side = std::tan(qDegreesToRadians(static_cast<double>(view.fieldOfView)) / 2);
    const auto x = static_cast<float>(inPicture.x() * side),
               y = static_cast<float>(inPicture.y() * side / aspect);
    return (view.forward.normalized() + x * right + y * up).normalized();
}

LookOperations::LookOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    context_.actions.on(ActionId::ResetCamera, [this] { reset(); });
    InputCapture& input = context_.view.input();
    connect(&input, &InputCapture::pointed, this, &LookOperations::lookAt);
    connect(&input, &InputCapture::focused, this, &LookOperations::focusAt);
    connect(&input, &InputCapture::zoomed, this, &LookOperations::zoom);
    context_.actions.on(ActionId::FieldOfView, [this] { askForAngle(); });
    turn_.setStartValue(0.0);
    turn_.setEndValue(1.0);
    turn_.setDuration(kMilliseconds);
    turn_.setEasingCurve(QEasingCurve::InOutQuad);
    connect(&turn_, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& fraction) { step(fraction.toDouble()); });
    // The user's own movement has precedence.
    const auto stop = [this] { turn_.stop(); };
    connect(&input, &InputCapture::keyPressed, this, stop);
    connect(&input, &InputCapture::turned, this, stop);
}

void LookOperations::reset() {
    turn_.stop();
    context_.view.showLive();
    context_.editor.edit(command::cameraReset());
}

void LookOperations::lookAt(const QPointF& position) {
    const std::optional<QPointF> point = context_.view.inPicture(position);
    const View& view = context_.session.status().view;
    if (!point || !context_.session.live()) return;
    if (view.fieldOfView <= 0) { // all rays are parallel: the direction says nothing of what is in the middle
        context_.view.showLive();
        return bringToMiddle(context_, position);
    }
    const QSize size =
        context_.view.showsLive() ? context_.session.frame().size() : context_.view.picture().size();
    from_ = view.forward;
    to_ = directionThrough(view, *point, static_cast<double>(size.width()) / size.height());
    turn_.stop();
    begun_ = false;
    context_.view.showLive();
    turn_.start();
}

void LookOperations::focusAt(const QPointF& position) {
    const std::optional<QPointF> point = context_.view.inPicture(position);
    if (!point || !context_.session.live()) return;
    context_.view.showLive();
    const auto fraction = [](double value) { return std::clamp((1 + value) / 2, 0.0, 1.0); };
    const std::string line = command::focus(fraction(point->x()), fraction(-point->y()));
    context_.editor.edit(line, [this](const Answer& answer) {
        if (!answer.done) context_.view.tell(answer.text);
    });
}

// --- The field of view ---

// One gesture is one step of undo.
bool LookOperations::goesOn() {
    const bool goesOn = sinceAngle_.isValid() && sinceAngle_.elapsed() < SceneEditor::kOneGesture;
    sinceAngle_.start();
    return goesOn;
}

void LookOperations::askForAngle() {
    auto* dialog = new FieldOfViewDialog(context_.session.status().view.fieldOfView, &context_.window);
    connect(dialog, &FieldOfViewDialog::wanted, this, &LookOperations::setAngle);
    connect(&context_.session, &Session::statusChanged, dialog, [this, dialog] {
        const bool byHand = sinceAngle_.isValid() && sinceAngle_.elapsed() < SceneEditor::kOneGesture;
        if (!byHand) dialog->follow(context_.session.status().view.fieldOfView);
    });
    dialog->show();
}

void LookOperations::setAngle(double degrees) {
    context_.view.showLive();
    const std::string line = command::cameraAngle(degrees);
    context_.editor.edit(goesOn() ? command::also(line) : line);
}

// Steps that come faster than the server takes them add up.
void LookOperations::zoom(double steps) {
    constexpr double kStep = 1.1;
    if (!context_.session.live()) return;
    factor_ *= std::pow(kStep, steps);
    if (!zooming_) sendZoom();
}

void LookOperations::sendZoom() {
    context_.view.showLive();
    zooming_ = true;
    const std::string line = command::cameraZoom(std::exchange(factor_, 1));
    context_.editor.edit(goesOn() ? command::also(line) : line, [this](const Answer& answer) {
        zooming_ = false;
        if (!answer.done) return context_.view.tell(answer.text);
        const bool perspective = context_.session.status().view.fieldOfView > 0;
        if (perspective)
            context_.view.tell(tr("Field of view %1").arg(fieldOfViewText(answer.text.toDouble())));
        if (factor_ != 1) sendZoom();
    });
}

// Steps that the server is too slow for are left out; the last one never is.
void LookOperations::step(double fraction) {
    const bool last = fraction >= 1;
    if (underWay_ && !last) return;
    send(((1 - static_cast<float>(fraction)) * from_ + static_cast<float>(fraction) * to_).normalized(),
         last);
}

void LookOperations::send(const QVector3D& direction, bool last) {
    const View& view = context_.session.status().view;
    const std::string line = command::cameraSet(positionOf(view.eye, view), numbersOf(direction));
    underWay_ = true;
    context_.editor.edit(std::exchange(begun_, true) ? command::also(line) : line,
                         [this, last](const Answer& answer) {
                             underWay_ = false;
                             if (!answer.done && last) context_.notice.explain(answer.text, {});
                         });
}

} // namespace gui
