/// The light meter: the light at the pointer, in a box beside it.
#pragma once

#include "gui/models/light_meter.h"
#include "gui/operations/gui_context.h"
#include "gui/session/server_status.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <optional>

namespace gui {

class PlainLabel;

class LightMeterOperations : public QObject {
    Q_OBJECT

  public:
    LightMeterOperations(const GuiContext& context, QObject* parent);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void setOn(bool on);
    void pointAt(const std::optional<QPointF>& position);
    void noticeStatus();
    void goOn();
    void restart();
    std::optional<QPointF> pointOfImage() const;
    void measure();
    void show();

    GuiContext context_;
    LightMeter meter_;
    PlainLabel* label_;
    QTimer rest_;                     ///< since the pointer or the view moved
    QTimer glances_;                  ///< since the last one
    std::optional<QPointF> position_; ///< of the pointer in the viewport
    View view_;                       ///< that was measured
    quint64 revision_ = 0;            ///< ServerStatus::imageRevision
    QSize size_;
    bool on_ = false;
};

} // namespace gui
