/// Windows that are no larger than their screen: a scaled one is small.
#pragma once

#include <QObject>

class QWidget;

namespace gui {

/// Makes a window small enough for the room that the desktop leaves, its title included, and moves it there
/// where it has a place. Before it is shown.
void fitIntoScreen(QWidget& window);

/// Does so with each dialog whose size was chosen. An event filter of the application; works until it is
/// deleted.
class ScreenFit : public QObject {
    Q_OBJECT

  public:
    explicit ScreenFit(QObject* parent = nullptr);
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace gui
