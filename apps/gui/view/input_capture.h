/// Keys and mouse of a widget, turned into key codes and angles. Keys without Ctrl, Alt and Meta are the
/// server's; while captured, or while a key that moves is down, so are the combinations of keys that move
/// (Control+W crawls), and all others are shortcuts. While captured the mouse turns the camera; or, by
/// another preference, a drag turns the model without any capture.
#pragma once

#include "gui/models/camera_keys.h"
#include "gui/models/mouse_scheme.h"

#include <QHash>
#include <QObject>
#include <QPoint>
#include <QSet>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace gui {

/// The effect of the mouse on the image.
enum class Hand {
    Looks, ///< a click captures the mouse, which turns the camera
    Turns  ///< a drag turns the model
};

class InputCapture : public QObject {
    Q_OBJECT

  public:
    /// Watches the events of `widget`, which should take the focus by click and Tab.
    explicit InputCapture(QWidget* widget);

    bool captured() const { return captured_; }
    /// With capture the pointer is hidden and stays.
    void capture();
    void release();
    void setMouseSensitivity(double degreesPerPixel, bool invert);
    Hand hand() const { return hand_; }
    void setHand(Hand hand);
    MouseScheme mouseScheme() const { return scheme_; }
    void setMouseScheme(MouseScheme scheme);
    /// Sets the server's bindings of keys.
    void setBindings(const QList<Binding>& bindings) { keys_ = CameraKeys(bindings); }

  signals:
    void capturedChanged(bool captured);
    void keyPressed(int code);
    void keyReleased(int code);
    void allKeysReleased();
    void turned(double right, double upwards); ///< degrees
    void wheelTurned(double steps);            ///< away from the user is positive
    // Signals of a hand that turns the model; widget pixels.
    void grasped(const QPointF& position);               ///< a drag begins there
    void dragged(const QPointF& by);                     ///< the model is to turn
    void pushed(const QPointF& by);                      ///< it is to move
    void neared(double by);                              ///< it is to come nearer: pixels upwards
    void reached(const QPointF& position, double steps); ///< the wheel, there
    void centred(const QPointF& position);               ///< a double click
    void zoomed(double steps);                           ///< the wheel with Ctrl, of either hand
    /// Keys that the window acts on (E, H, R and L with it); R comes when it is let go, unless L came with
    /// it.
    void commandKey(int code, bool withL);
    /// A double click that took the keyboard and the mouse, and gave them back; widget pixels.
    void pointed(const QPointF& position);
    void focused(const QPointF& position); ///< the same with Ctrl
    /// The right button, while nothing is captured; where it drags, when it is let go at the same place.
    void picked(const QPointF& position);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool takesAll() const;
    bool isCameras(const QKeyEvent& event) const;
    bool onShortcutOverride(QKeyEvent& event);
    bool onPress(QKeyEvent& event);
    bool onRelease(QKeyEvent& event);
    void press(int code);
    void commandRelease(int code);
    bool onMousePress(const QMouseEvent& event);
    void onWheel(const QWheelEvent& event);
    bool onDoubleClick(const QMouseEvent& event);
    bool onMouseMove(const QMouseEvent& event);
    bool onGrasp(const QMouseEvent& event);
    bool onDrag(const QMouseEvent& event);
    bool onMouseRelease(const QMouseEvent& event);
    void centrePointer();
    void releaseKeys();

    QWidget* widget_;
    CameraKeys keys_;
    bool captured_ = false;
    QHash<quint64, int> held_; ///< by the key's place, as long as it is down
    QSet<int> commands_;       ///< E, H, R, L that are down
    bool renderPending_ = false;
    QPoint last_;              ///< of the pointer, widget pixels
    QPoint pressed_;           ///< where the button went down
    bool byThisClick_ = false; ///< captured, and the mouse has not moved since
    Hand hand_ = Hand::Looks;
    MouseScheme scheme_ = MouseScheme::Usual;
    Qt::MouseButton grasp_ = Qt::NoButton; ///< of a drag that goes on
    bool picks_ = false;                   ///< and it is no drag yet but a click
    double degreesPerPixel_ = 0.12;
    double upwards_ = 1; ///< -1: inverted
};

} // namespace gui
