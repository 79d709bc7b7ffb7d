/// The light at a point of the image: roughly while the view moves, better and better while nothing does.
/// Needs no window.
#pragma once

#include "gui/models/light_reading.h"
#include "gui/session/session.h"

#include <QObject>
#include <QPointF>

#include <functional>
#include <optional>
#include <string>

namespace gui {

/// One measurement is under way at a time; the answer to one that is out of date is dropped. Nothing waits.
class LightMeter : public QObject {
    Q_OBJECT

  public:
    /// Sends a line and calls back once with the answer, later.
    using Send = std::function<void(const std::string& line, std::function<void(const Answer&)> done)>;
    explicit LightMeter(Send send, QObject* parent = nullptr);

    /// What was measured does not hold any more: the point, the view or the scene is another one. Stops what
    /// is measured.
    void forget();
    /// The point, 0..1 from the left and from the top, has been at rest for a while: it is measured by few
    /// paths, then by four times as many, until both standard errors are half a percent or there are 2^19 of
    /// them.
    void measure(const QPointF& point);

    /// The point while the view moves: roughly, by 512 paths. What was measured before is shown until the
    /// answer comes; nothing is asked while another glance is under way.
    void glance(const QPointF& point);

    const LightReading& reading() const { return reading_; }
    /// Whether nothing better is to come.
    bool done() const { return !wanted_ && !busy_; }

  signals:
    void changed();

  private:
    void drop();
    void showNone();
    void ask();
    void take(const Answer& answer);

    Send send_;
    LightReading reading_;
    std::optional<QPointF> wanted_; ///< to be measured, or better than before
    std::optional<QPointF> asked_;  ///< nothing: the answer that comes is out of date
    int paths_ = 0;
    bool busy_ = false;
    bool glances_ = false; ///< what is asked is a glance
};

} // namespace gui
