/// A session's connection to its server, for the sources of Session alone, since it includes ipc.
#pragma once

#include "gui/session/session.h"

#include "ipc/endpoint/client.h"

#include <QPointer>
#include <QTimer>

#include <chrono>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace gui {

using Clock = std::chrono::steady_clock;

/// A command and the receiver of its answer.
struct Order {
    std::string command;
    QPointer<const QObject> context;
    std::function<void(const Answer&)> done; ///< empty: the answer is not wanted
    ipc::Ticket ticket = 0;                  ///< 0: not sent yet
};

/// How the mouse moves the camera.
struct Steering {
    struct Move {
        double right = 0, upwards = 0;
        bool operator==(const Move&) const = default;
    };
    Move turn, orbit, pan;
    double approach = 1;
    std::optional<Move> hold; ///< before all others
};

struct Session::Link {
    std::unique_ptr<ipc::Client> client;
    Clock::time_point deadline{}, lastNews{};
    std::uint64_t epoch = 0;
    ipc::Frame frame, next; ///< the one that is shown, and where the next one is read to
    std::deque<Order> waiting;
    std::vector<Order> open;
    Steering steering;                  ///< not yet sent
    std::optional<ipc::Ticket> turning; ///< the server has not taken the last of it yet
    QTimer timer;
};

} // namespace gui
