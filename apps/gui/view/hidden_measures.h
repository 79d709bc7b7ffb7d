/// Which points of kept measures something hides, as the server finds by the camera of its newest frame.
#pragma once

#include "gui/session/server_status.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstdint>
#include <optional>
#include <set>
#include <utility>

namespace gui {

class Session;

/// The numbers of a measure and of a point of it, both from 0.
using HiddenPoints = std::set<std::pair<std::size_t, std::size_t>>;
/// Of the answer to `measure hidden`; what is no number from 1 is left out, with the rest of its line.
HiddenPoints readHidden(const QString& answer);

/// Asks while it is wanted, when the camera or the scene is another one, and not more often than three times
/// a second. Until the answer comes what was hidden before counts.
class HiddenMeasures : public QObject {
    Q_OBJECT

  public:
    /// `session` must outlive it.
    explicit HiddenMeasures(Session& session, QObject* parent = nullptr);

    /// Unwanted, nothing is hidden.
    void setWanted(bool wanted);
    bool isHidden(std::size_t measure, std::size_t point) const { return hidden_.contains({measure, point}); }

  signals:
    void changed();

  private:
    /// What the answer depends on.
    struct Seen {
        View view;
        std::uint64_t revision = 0; ///< of the server's state
        friend bool operator==(const Seen&, const Seen&) = default;
    };

    void look();
    void take(HiddenPoints hidden);

    Session& session_;
    QTimer pause_; ///< since the last question
    HiddenPoints hidden_;
    std::optional<Seen> asked_;
    bool wanted_ = false;
    bool asking_ = false;
};

} // namespace gui
