/// The image alone on the screen: while the window fills it, menus and panels are hidden.
#pragma once

#include <QByteArray>
#include <QObject>

class QMainWindow;

namespace gui {

class FullScreen : public QObject {
    Q_OBJECT

  public:
    /// Watches `window`, however it becomes full screen.
    explicit FullScreen(QMainWindow& window);

    void set(bool on);

  signals:
    void changed(bool on);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void enter();
    void leave();

    QMainWindow& window_;
    bool on_ = false;
    QByteArray panels_; ///< before, as QMainWindow::saveState() says it
};

} // namespace gui
