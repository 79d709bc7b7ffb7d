#include "gui/view/input_capture.h"

#include "gui/models/key_map.h"

#include "rtcore/motion/key_codes.h"

#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace gui {

namespace {

constexpr int kTremble = 6;        ///< pixels
constexpr double kWheelStep = 120; ///< Qt's unit of one notch

// The same key has the same number when it comes up again, whatever Shift has made of it.
quint64 placeOf(const QKeyEvent& event) {
    const quint64 scanCode = event.nativeScanCode();
    return scanCode != 0 ? scanCode : (quint64{1} << 32) + static_cast<quint64>(event.key());
}

bool isModifier(int key) {
    return key == Qt::Key_Control || key == Qt::Key_Alt || key == Qt::Key_Meta || key == Qt::Key_AltGr;
}

// One of the window or of the desktop, unless the camera has it.
bool isShortcut(const QKeyEvent& event) {
    return isModifier(event.key()) ||
           (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
}

// The code of the only modifier that is down; KeyNone when there are several, or another one.
int onlyModifier(Qt::KeyboardModifiers modifiers) {
    const auto down = modifiers & ~Qt::KeypadModifier;
    return down == Qt::ControlModifier ? rtcore::KeyControl
           : down == Qt::AltModifier   ? rtcore::KeyAlt
                                       : rtcore::KeyNone;
}

// Home, and while a drag turns the model the numbers at the side of the keyboard, choose views.
bool choosesViews(const QKeyEvent& event, Hand hand) {
    const bool number =
        (event.modifiers() & Qt::KeypadModifier) != 0 && event.key() >= Qt::Key_0 && event.key() <= Qt::Key_9;
    return event.key() == Qt::Key_Home || (number && hand == Hand::Turns);
}

bool isFunctionKey(int key) { return key >= Qt::Key_F1 && key <= Qt::Key_F35; }

bool isCommand(int code) { return code == 'E' || code == 'H' || code == 'R' || code == 'L'; }

} // namespace

InputCapture::InputCapture(QWidget* widget) : QObject(widget), widget_(widget) {
    widget->installEventFilter(this);
    widget->setMouseTracking(true);
}

void InputCapture::setMouseSensitivity(double degreesPerPixel, bool invert) {
    degreesPerPixel_ = degreesPerPixel;
    upwards_ = invert ? -1 : 1;
}

void InputCapture::setHand(Hand hand) {
    if (hand == Hand::Turns) release();
    hand_ = hand;
    grasp_ = Qt::NoButton;
}

void InputCapture::setMouseScheme(MouseScheme scheme) {
    scheme_ = scheme;
    grasp_ = Qt::NoButton;
}

void InputCapture::capture() {
    if (captured_) return;
    captured_ = true;
    widget_->setFocus(Qt::OtherFocusReason);
    widget_->setCursor(Qt::BlankCursor);
    byThisClick_ = false;
    last_ = widget_->mapFromGlobal(QCursor::pos());
    emit capturedChanged(true);
}

void InputCapture::release() {
    if (!captured_) return;
    captured_ = false;
    widget_->unsetCursor();
    releaseKeys();
    emit capturedChanged(false);
}

void InputCapture::releaseKeys() {
    held_.clear();
    commands_.clear();
    renderPending_ = false;
    emit allKeysReleased();
}

bool InputCapture::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
    case QEvent::ShortcutOverride:
        return onShortcutOverride(static_cast<QKeyEvent&>(*event));
    case QEvent::KeyPress:
        return onPress(static_cast<QKeyEvent&>(*event));
    case QEvent::KeyRelease:
        return onRelease(static_cast<QKeyEvent&>(*event));
    case QEvent::MouseButtonPress:
        return onMousePress(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
        return onDoubleClick(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
        return onMouseRelease(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
        return onMouseMove(static_cast<const QMouseEvent&>(*event));
    case QEvent::Wheel:
        onWheel(static_cast<const QWheelEvent&>(*event));
        return true;
    case QEvent::FocusOut:
    case QEvent::WindowDeactivate:
    case QEvent::Hide:
        release();
        if (!held_.isEmpty()) releaseKeys();
        return false;
    default:
        return false;
    }
}

// --- Keys ---

// The camera is being moved by the keyboard.
bool InputCapture::takesAll() const {
    return captured_ ||
           std::any_of(held_.begin(), held_.end(), [this](int code) { return keys_.moves(code); });
}

bool InputCapture::isCameras(const QKeyEvent& event) const {
    const int code = keyCodeOf(event);
    if (isFunctionKey(event.key())) return false;
    if (!captured_ && choosesViews(event, hand_)) return false;
    if (!isShortcut(event)) return captured_ || code != rtcore::KeyNone;
    if (!takesAll()) return false;
    if (isModifier(event.key())) return captured_ || keys_.moves(code);
    return keys_.combines(onlyModifier(event.modifiers()), code);
}

// Accepted: Qt sends it as a key, and no shortcut fires.
bool InputCapture::onShortcutOverride(QKeyEvent& event) {
    const bool ours = isCameras(event);
    event.setAccepted(ours);
    return ours;
}

bool InputCapture::onPress(QKeyEvent& event) {
    const int code = keyCodeOf(event);
    if (captured_ && event.key() == Qt::Key_Escape) {
        release();
        return true;
    }
    if (!captured_) {
        const bool toFocus = code == rtcore::KeyTab || code == rtcore::KeyEscape;
        if (!isCameras(event) || toFocus) return false;
        if (code == rtcore::KeyReturn) {
            capture();
            return true;
        }
    }
    if (code == rtcore::KeyNone) return captured_;
    if (event.isAutoRepeat() || held_.contains(placeOf(event))) return true;
    held_.insert(placeOf(event), code);
    press(code);
    return true;
}

bool InputCapture::onRelease(QKeyEvent& event) {
    if (event.isAutoRepeat()) return true;
    const auto held = held_.constFind(placeOf(event));
    if (held == held_.constEnd()) return captured_;
    const int code = *held;
    held_.erase(held);
    if (isCommand(code)) {
        commandRelease(code);
    } else {
        emit keyReleased(code);
    }
    return true;
}

void InputCapture::press(int code) {
    if (!isCommand(code)) return emit keyPressed(code);
    commands_.insert(code);
    if (code == 'E' || code == 'H') emit commandKey(code, false);
    if (code == 'R') renderPending_ = true;
    // R and L together are another command than R alone, in whichever order they come down.
    if (commands_.contains('R') && commands_.contains('L') && renderPending_) {
        renderPending_ = false;
        emit commandKey('R', true);
    }
}

void InputCapture::commandRelease(int code) {
    commands_.remove(code);
    if (code == 'R' && std::exchange(renderPending_, false)) emit commandKey('R', false);
}

// --- Mouse ---

bool InputCapture::onMousePress(const QMouseEvent& event) {
    const bool turns = hand_ == Hand::Turns && !captured_;
    if (turns && hasDrags(scheme_, event.button())) return onGrasp(event);
    if (event.button() == Qt::RightButton && !captured_) {
        emit picked(event.position());
        return true;
    }
    if (turns) {
        widget_->setFocus(Qt::MouseFocusReason);
        return event.button() == Qt::LeftButton;
    }
    if (event.button() != Qt::LeftButton) return false;
    const bool was = captured_;
    capture();
    byThisClick_ = !was;
    pressed_ = event.position().toPoint();
    return true;
}

bool InputCapture::onDoubleClick(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton) return false;
    if (hand_ == Hand::Turns && !captured_ && (event.modifiers() & Qt::ControlModifier) == 0) {
        emit centred(event.position());
        return true;
    }
    if (hand_ == Hand::Looks && (!captured_ || !byThisClick_)) return onMousePress(event);
    release();
    if ((event.modifiers() & Qt::ControlModifier) != 0)
        emit focused(event.position());
    else
        emit pointed(event.position());
    return true;
}

void InputCapture::onWheel(const QWheelEvent& event) {
    const double steps = event.angleDelta().y() / kWheelStep;
    if ((event.modifiers() & Qt::ControlModifier) != 0)
        emit zoomed(steps);
    else if (hand_ == Hand::Turns && !captured_)
        emit reached(event.position(), steps);
    else
        emit wheelTurned(steps);
}

// Where the pointer cannot be moved (Wayland), it is followed until it leaves the window.
bool InputCapture::onMouseMove(const QMouseEvent& event) {
    if (grasp_ != Qt::NoButton) return onDrag(event);
    if (!captured_) return false;
    const QPoint now = event.position().toPoint();
    const QPoint moved = now - last_;
    last_ = now;
    if (moved.isNull()) return true;
    // A hand that trembles between two clicks does not turn the camera.
    if (byThisClick_ && (now - pressed_).manhattanLength() < kTremble) return true;
    byThisClick_ = false;
    emit turned(moved.x() * degreesPerPixel_, -moved.y() * degreesPerPixel_ * upwards_);
    const QPoint off = now - widget_->rect().center();
    if (std::abs(off.x()) > widget_->width() / 4 || std::abs(off.y()) > widget_->height() / 4)
        centrePointer();
    return true;
}

bool InputCapture::onGrasp(const QMouseEvent& event) {
    widget_->setFocus(Qt::MouseFocusReason);
    grasp_ = event.button();
    last_ = pressed_ = event.position().toPoint();
    picks_ = grasp_ == Qt::RightButton;
    widget_->setCursor(Qt::ClosedHandCursor);
    emit grasped(event.position());
    return true;
}

bool InputCapture::onDrag(const QMouseEvent& event) {
    const QPoint now = event.position().toPoint(), moved = now - last_;
    if (picks_ && (now - pressed_).manhattanLength() < kTremble) return true;
    picks_ = false;
    last_ = now;
    if (moved.isNull()) return true;
    switch (dragOf(scheme_, grasp_, event.modifiers())) {
    case Drag::Turns:
        emit dragged(moved);
        break;
    case Drag::Moves:
        emit pushed(moved);
        break;
    case Drag::Nears:
        emit neared(-moved.y());
        break;
    case Drag::None:
        break;
    }
    return true;
}

bool InputCapture::onMouseRelease(const QMouseEvent& event) {
    if (grasp_ == Qt::NoButton || event.button() != grasp_) return false;
    grasp_ = Qt::NoButton;
    if (!captured_) widget_->unsetCursor();
    if (std::exchange(picks_, false)) emit picked(event.position());
    return true;
}

void InputCapture::centrePointer() {
    const QPoint centre = widget_->rect().center();
    QCursor::setPos(widget_->mapToGlobal(centre));
    last_ = widget_->mapFromGlobal(QCursor::pos());
}

} // namespace gui
