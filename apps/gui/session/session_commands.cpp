// The part of Session that sends: commands, keys, turns.
#include "gui/session/session_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMaxWaiting = 1000;
constexpr double kMin = 1e-4; ///< degrees, or of the image's width

bool isSome(const Steering::Move& move) { return std::abs(move.right) + std::abs(move.upwards) >= kMin; }

/// The next command of it, which it is without then; "" for none.
std::string takeLine(Steering& steering) {
    if (const auto hold = std::exchange(steering.hold, {}))
        return command::cameraPivot(hold->right, hold->upwards);
    const auto take = [](auto& what) { return std::exchange(what, {}); };
    if (isSome(steering.orbit)) {
        const Steering::Move move = take(steering.orbit);
        return command::cameraOrbit(move.right, move.upwards);
    }
    if (isSome(steering.pan)) {
        const Steering::Move move = take(steering.pan);
        return command::cameraPan(move.right, move.upwards);
    }
    if (steering.approach != 1) return command::cameraApproach(std::exchange(steering.approach, 1));
    if (!isSome(steering.turn)) return {};
    const Steering::Move move = take(steering.turn);
    return command::cameraTurn(move.right, move.upwards);
}

/// Added up, within what a command takes.
void add(Steering::Move& sum, double right, double upwards, double max) {
    sum.right = std::clamp(sum.right + right, -max, max);
    sum.upwards = std::clamp(sum.upwards + upwards, -max, max);
}

} // namespace

// --- Commands ---

void Session::send(const std::string& command) { send(command, this, {}); }

void Session::send(const std::string& command, const QObject* context,
                   std::function<void(const Answer&)> done) {
    const bool wanted = state_ != SessionState::Disconnected && state_ != SessionState::Refused;
    if (!wanted || link_->waiting.size() >= kMaxWaiting) {
        const QString text = wanted ? tr("the server takes no commands") : tr("there is no server");
        if (!done) return emit commandFailed(QString::fromStdString(command), text);
        QMetaObject::invokeMethod(
            const_cast<QObject*>(context),
            [done, text] {
                done({false, text});
            },
            Qt::QueuedConnection);
        return;
    }
    link_->waiting.push_back({command, context, std::move(done), 0});
    link_->lastNews = Clock::now();
}

void Session::sendWaiting() {
    while (!link_->waiting.empty()) {
        Order& order = link_->waiting.front();
        if (link_->client->send(order.command, &order.ticket) != ipc::SendStatus::Sent) return;
        link_->open.push_back(std::move(order));
        link_->waiting.pop_front();
    }
}

void Session::sendSteering() {
    if (link_->turning) {
        if (link_->client->wait(*link_->turning, 0ns).status == ipc::ReplyStatus::TimedOut) return;
        link_->turning.reset();
    }
    Steering left = link_->steering;
    const std::string line = takeLine(left);
    ipc::Ticket ticket = 0;
    if (line.empty() || link_->client->send(line, &ticket) != ipc::SendStatus::Sent) return;
    link_->turning = ticket;
    link_->steering = left;
}

// Callbacks may send more, or leave: the answered orders are moved out of the list first.
void Session::collectAnswers() {
    std::vector<std::pair<Order, Answer>> ready;
    std::erase_if(link_->open, [&](Order& order) {
        const ipc::Reply reply = link_->client->wait(order.ticket, 0ns);
        if (reply.status == ipc::ReplyStatus::TimedOut) return false;
        const bool done = reply.status == ipc::ReplyStatus::Done;
        const QString text = QString::fromStdString(reply.text);
        const QString detail = QString::fromStdString(reply.detail);
        ready.emplace_back(std::move(order), Answer{done, done ? text : serverText(text, detail), detail});
        return true;
    });
    for (const auto& [order, answer] : ready) {
        if (order.done) {
            if (order.context) order.done(answer);
        } else if (!answer.done) {
            emit commandFailed(QString::fromStdString(order.command), answer.text);
        }
    }
}

void Session::failAll(const QString& text) {
    std::vector<Order> all = std::exchange(link_->open, {});
    for (Order& order : std::exchange(link_->waiting, {})) all.push_back(std::move(order));
    link_->turning.reset();
    for (const Order& order : all) {
        if (order.done && order.context) order.done({false, text});
    }
}

// --- Input ---

void Session::pressKey(int key) {
    if (!link_->client) return;
    try {
        link_->client->pressKey(key);
    } catch (const ipc::Error&) {
        return; // poll() tells of it
    }
    link_->lastNews = Clock::now();
    pace();
}

void Session::releaseKey(int key) {
    if (!link_->client) return;
    try {
        link_->client->releaseKey(key);
    } catch (const ipc::Error&) {
        return;
    }
}

void Session::releaseAllKeys() {
    if (!link_->client) return;
    try {
        link_->client->releaseAllKeys();
    } catch (const ipc::Error&) {
        return;
    }
}

void Session::steer() {
    link_->lastNews = Clock::now();
    pace();
}

void Session::turn(double right, double upwards) {
    add(link_->steering.turn, right, upwards, 180);
    steer();
}

void Session::takeHold(double right, double down) {
    link_->steering.hold = Steering::Move{right, down};
    steer();
}

void Session::orbit(double right, double upwards) {
    add(link_->steering.orbit, right, upwards, 180);
    steer();
}

void Session::pan(double right, double upwards) {
    add(link_->steering.pan, right, upwards, 10);
    steer();
}

void Session::approach(double factor) {
    constexpr double kMax = 1000;
    link_->steering.approach = std::clamp(link_->steering.approach * factor, 1 / kMax, kMax);
    steer();
}

} // namespace gui
