/// Recording by one key, also while one walks: a list of its own each time.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>

namespace gui {

class RecordingMark;

class RecordingOperations : public QObject {
    Q_OBJECT

  public:
    RecordingOperations(const GuiContext& context, QObject* parent);

  private:
    void toggle();
    void onStatus();
    void take(const QString& answer);

    GuiContext context_;
    RecordingMark* mark_;
    bool recording_ = false;
    bool byKey_ = false; ///< it was this key that began it
};

} // namespace gui
