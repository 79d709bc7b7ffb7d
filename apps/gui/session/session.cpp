#include "gui/session/session.h"

#include "gui/session/pixel_order.h"

#include "common/words.h"

#include "ipc/endpoint/client.h"

#include <QPointer>
#include <QStringList>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

namespace gui {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kPace = 4ms;      ///< while frames come
constexpr auto kSlowPace = 15ms; ///< after a while without
constexpr auto kSlowAfter = 500ms;
constexpr std::size_t kMostWaiting = 1000;
constexpr double kLeastTurn = 1e-4; ///< degrees

QVector3D vector(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

ServerStatus statusOf(const ipc::Status& from) {
    ServerStatus to;
    to.framesPerSecond = from.framesPerSecond;
    to.frameSeconds = from.frameSeconds;
    to.raysPerSecond = from.raysPerSecond;
    to.polygons = from.polygons;
    to.resolution = QSize(static_cast<int>(from.width), static_cast<int>(from.height));
    to.exposure = from.exposure;
    to.progress = from.progress;
    to.view = {vector(from.eye), vector(from.forward), from.fieldOfView, from.mode != 0};
    to.idle = from.idle != 0;
    to.paused = from.paused != 0;
    to.recording = from.recording != 0;
    return to;
}

// A server's failure begins with an exit code for shells.
QString withoutCode(const QString& text) {
    qsizetype digits = 0;
    while (digits < text.size() && text[digits].isDigit()) ++digits;
    return digits > 0 && digits < text.size() && text[digits] == QLatin1Char(' ') ? text.mid(digits + 1)
                                                                                  : text;
}

struct Order {
    QString command;
    QPointer<const QObject> context;
    std::function<void(const Answer&)> done; ///< empty: nobody waits
    ipc::Ticket ticket = 0;                  ///< 0: not sent yet
};

} // namespace

struct Session::Link {
    std::unique_ptr<ipc::Client> client;
    Clock::time_point deadline{}, lastNews{};
    std::uint64_t epoch = 0;
    ipc::Frame frame, next; ///< the one that is shown, and where the next one is read to
    std::deque<Order> waiting;
    std::vector<Order> open;
    double right = 0, upwards = 0;      ///< turned, not yet sent
    std::optional<ipc::Ticket> turning; ///< the server has not taken the last turn yet
    QTimer timer;
};

Session::Session(QObject* parent) : QObject(parent), link_(std::make_unique<Link>()) {
    link_->timer.setTimerType(Qt::PreciseTimer);
    connect(&link_->timer, &QTimer::timeout, this, &Session::poll);
}

Session::~Session() = default;

void Session::connectTo(const QString& instance, std::chrono::milliseconds patience) {
    leave();
    instance_ = instance;
    link_->deadline = Clock::now() + patience;
    become(SessionState::Connecting);
    link_->timer.start(kPace);
}

void Session::leave() {
    link_->timer.stop();
    failAll(tr("the window left the server"));
    link_->client.reset();
    link_->frame = {};
    link_->next = {};
    link_->right = link_->upwards = 0;
    link_->turning.reset();
    process_ = 0;
    if (status_ != ServerStatus()) {
        status_ = {};
        emit statusChanged();
    }
    become(SessionState::Disconnected);
}

QImage Session::frame() const {
    const ipc::Frame& frame = link_->frame;
    if (frame.info.number == 0) return {};
    const auto* pixels = reinterpret_cast<const uchar*>(frame.pixels.data());
    const auto width = static_cast<int>(frame.info.width), height = static_cast<int>(frame.info.height);
    return {pixels, width, height, qsizetype{4} * width, QImage::Format_RGB32};
}

quint64 Session::frameNumber() const { return link_->frame.info.number; }

std::chrono::nanoseconds Session::frameAge() const {
    return Clock::now().time_since_epoch() - std::chrono::nanoseconds(link_->frame.info.nanoseconds);
}

// --- Looking for news ---

void Session::poll() {
    try {
        if (!link_->client) tryToConnect();
        if (link_->client) look();
        pace();
    } catch (const ipc::Error& error) {
        const QString text = QString::fromUtf8(error.what());
        failAll(text);
        become(SessionState::Refused, text);
        if (link_->client) return; // it looks again, at leisure
        link_->timer.stop();
    }
}

void Session::tryToConnect() {
    try {
        link_->client = std::make_unique<ipc::Client>(instance_.toStdString(), 0ns);
        link_->lastNews = Clock::now();
    } catch (const ipc::Error& error) {
        if (error.problem != ipc::Problem::NoServer) throw;
        if (Clock::now() < link_->deadline) return;
        link_->timer.stop();
        failAll(tr("there is no server"));
        become(SessionState::Disconnected, tr("There is no server “%1”.").arg(instance_));
    }
}

void Session::look() {
    const ipc::LinkState now = link_->client->update();
    const bool gone = now == ipc::LinkState::Gone;
    if (!gone && link_->client->epoch() != link_->epoch) {
        link_->epoch = link_->client->epoch();
        process_ = link_->client->serverProcess();
    }
    collectAnswers();
    if (!link_->client) return; // who was called left the server; so below
    if (gone) {
        failAll(tr("the server ended before it answered"));
        if (state_ != SessionState::Connecting) become(SessionState::Lost);
        return;
    }
    readStatus();
    if (!link_->client) return;
    become(now == ipc::LinkState::Busy ? SessionState::Busy : SessionState::Connected);
    if (!link_->client) return;
    sendTurn();
    sendWaiting();
    if (link_->client->readFrame(link_->next)) {
        link_->lastNews = Clock::now();
        toRgb32(link_->next.pixels);
        std::swap(link_->frame, link_->next);
        // What comes next must be newer than this one.
        link_->next.info = link_->frame.info;
        link_->next.epoch = link_->frame.epoch;
        emit frameChanged();
    }
}

void Session::readStatus() {
    const ServerStatus now = statusOf(link_->client->status());
    if (now == status_) return;
    status_ = now;
    link_->lastNews = Clock::now();
    if (!now.resolution.isEmpty()) lastView_ = now.view;
    emit statusChanged();
}

void Session::pace() {
    const bool quiet = Clock::now() - link_->lastNews > kSlowAfter && link_->open.empty();
    const auto wanted = quiet ? kSlowPace : kPace;
    if (link_->timer.isActive() && link_->timer.intervalAsDuration() != wanted)
        link_->timer.setInterval(wanted);
}

void Session::become(SessionState state, const QString& reason) {
    if (state == state_ && reason == reason_) return;
    state_ = state;
    reason_ = reason;
    emit stateChanged(state);
}

// --- Commands ---

QString Session::line(const QStringList& words) {
    std::vector<std::string> plain;
    for (const QString& word : words) plain.push_back(word.toStdString());
    return QString::fromStdString(app::joinWords(plain));
}

void Session::send(const QString& command) { send(command, this, {}); }

void Session::send(const QString& command, const QObject* context, std::function<void(const Answer&)> done) {
    const bool wanted = state_ != SessionState::Disconnected && state_ != SessionState::Refused;
    if (!wanted || link_->waiting.size() >= kMostWaiting) {
        const QString text = wanted ? tr("the server takes no commands") : tr("there is no server");
        QMetaObject::invokeMethod(
            const_cast<QObject*>(context),
            [done, text] {
                if (done) done({false, text});
            },
            Qt::QueuedConnection);
        if (!done) emit commandFailed(command, text);
        return;
    }
    link_->waiting.push_back({command, context, std::move(done), 0});
    link_->lastNews = Clock::now();
}

void Session::sendWaiting() {
    while (!link_->waiting.empty()) {
        Order& order = link_->waiting.front();
        if (link_->client->send(order.command.toStdString(), &order.ticket) != ipc::SendStatus::Sent) return;
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
    const QString command =
        QStringLiteral("camera turn %1 %2").arg(link_->right, 0, 'f', 5).arg(link_->upwards, 0, 'f', 5);
    ipc::Ticket ticket = 0;
    if (link_->client->send(command.toStdString(), &ticket) != ipc::SendStatus::Sent) return;
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
        ready.emplace_back(std::move(order), Answer{done, done ? text : withoutCode(text)});
        return true;
    });
    for (const auto& [order, answer] : ready) {
        if (order.done) {
            if (order.context) order.done(answer);
        } else if (!answer.done) {
            emit commandFailed(order.command, answer.text);
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
