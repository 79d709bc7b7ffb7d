/// How the window looks, the image's size, preferences, help, statistics.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QPointer>
#include <QSize>

class QDialog;

namespace gui {

class DisplayOperations : public QObject {
    Q_OBJECT

  public:
    DisplayOperations(const GuiContext& context, QObject* parent);

  private:
    void applyPreferences();
    void askForResolution(const QSize& devicePixels);
    void configure();
    void showKeys();
    void showStatistics();

    GuiContext context_;
    QPointer<QDialog> statistics_, keys_;
    QString theme_;
};

} // namespace gui
