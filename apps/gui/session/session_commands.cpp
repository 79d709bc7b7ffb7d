// What a session sends: commands, keys, turns.
#include "gui/session/session_link.h"

#include <algorithm>
#include <cmath>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostWaiting = 1000;
constexpr double kLeastTurn = 1e-4; ///< degrees

} // namespace

// --- Commands ---

void Session::send(const std::string& command) { send(command, this, {}); }

void Session::send(const std::string& command, const QObject* context,
                   std::function<void(const Answer&)> done) {
    const bool wanted = state_ != SessionState::Disconnected && state_ != SessionState::Refused;
    if (!wanted || link_->waiting.size() >= kMostWaiting) {
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

void Session::sendTurn() {
    if (link_->turning) {
        if (link_->client->wait(*link_->turning, 0ns).status == ipc::ReplyStatus::TimedOut) return;
        link_->turning.reset();
    }
    if (std::abs(link_->right) + std::abs(link_->upwards) < kLeastTurn) return;
    ipc::Ticket ticket = 0;
    const std::string line = command::cameraTurn(link_->right, link_->upwards);
    if (link_->client->send(line, &ticket) != ipc::SendStatus::Sent) return;
    link_->turning = ticket;
    link_->right = link_->upwards = 0;
}

// What is called may send more, or leave: the list is taken first.
void Session::collectAnswers() {
    std::vector<std::pair<Order, Answer>> ready;
    std::erase_if(link_->open, [&](Order& order) {
        const ipc::Reply reply = link_->client->wait(order.ticket, 0ns);
        if (reply.status == ipc::ReplyStatus::TimedOut) return false;
        const bool done = reply.status == ipc::ReplyStatus::Done;
        const QString text = QString::fromStdString(reply.text);
        ready.emplace_back(std::move(order), Answer{done, text});
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

void Session::turn(double right, double upwards) {
    constexpr double kMost = 180;
    link_->right = std::clamp(link_->right + right, -kMost, kMost);
    link_->upwards = std::clamp(link_->upwards + upwards, -kMost, kMost);
    link_->lastNews = Clock::now();
    pace();
}

} // namespace gui
