/// How the window looks, the picture's size, preferences, help, statistics.
#pragma once

#include "gui/operations/desk.h"

#include <QObject>
#include <QPointer>
#include <QSize>

class QDialog;

namespace gui {

class DisplayOperations : public QObject {
    Q_OBJECT

  public:
    DisplayOperations(const Desk& desk, QObject* parent);

  private:
    void applyPreferences();
    void askForResolution(const QSize& devicePixels);
    void configure();
    void showKeys();
    void showStatistics();

    Desk desk_;
    QPointer<QDialog> statistics_, keys_;
    QString theme_;
};

} // namespace gui
