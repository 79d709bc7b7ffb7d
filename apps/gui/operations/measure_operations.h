/// Measuring: the mode, the panel of the measures that are kept, and their labels in the image.
#pragma once

#include "gui/operations/gui_context.h"
#include "gui/session/session.h"

#include "rtcore/scene/kept_measure.h"

#include <QObject>
#include <QPointF>

#include <optional>

namespace gui {

class MeasureMarks;
class MeasuresPanel;

class MeasureOperations : public QObject {
    Q_OBJECT

  public:
    MeasureOperations(const GuiContext& context, QObject* parent);

  private:
    void connectPanel();
    void connectMarks();
    void showState();
    /// Nothing: one measures no more.
    void measure(std::optional<rtcore::MeasureKind> kind);
    void showHint();
    void keepPart(const QPointF& at);
    void keep(const std::string& line);
    void goTo(int index);
    void askForFile();

    GuiContext context_;
    MeasuresPanel* panel_;
    MeasureMarks* marks_;
    rtcore::MeasureKind last_ = rtcore::MeasureKind::Distance; ///< that one measured
};

} // namespace gui
