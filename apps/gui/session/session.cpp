#include "gui/session/session.h"

#include "gui/session/pixel_order.h"
#include "gui/session/server_sentence.h"
#include "gui/session/session_link.h"

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kPace = 4ms;      ///< while frames come
constexpr auto kSlowPace = 15ms; ///< after a while without
constexpr auto kSlowAfter = 500ms;

QVector3D vector(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

ServerStatus statusOf(const ipc::Status& from) {
    ServerStatus to;
    to.framesPerSecond = from.framesPerSecond;
    to.frameSeconds = from.frameSeconds;
    to.raysPerSecond = from.raysPerSecond;
    to.kept = static_cast<double>(from.kept);
    to.indirectError = static_cast<double>(from.lightError);
    to.polygons = from.polygons;
    to.resolution = QSize(static_cast<int>(from.width), static_cast<int>(from.height));
    to.exposure = from.exposure;
    to.progress = from.progress;
    to.view = {{from.origin[0], from.origin[1], from.origin[2]},
               vector(from.eye),
               vector(from.forward),
               vector(from.up),
               from.fieldOfView,
               from.parallelWidth,
               from.mode != 0};
    to.idle = from.idle != 0;
    to.paused = from.paused != 0;
    to.recording = from.recording != 0;
    to.messages = from.messages;
    to.stateRevision = from.stateRevision;
    to.imageRevision = from.imageRevision;
    return to;
}

} // namespace

Session::Session(QObject* parent) : QObject(parent), link_(std::make_unique<Link>()) {
    link_->timer.setTimerType(Qt::PreciseTimer);
    connect(&link_->timer, &QTimer::timeout, this, &Session::poll);
}

Session::~Session() = default;

void Session::connectTo(const QString& instance, std::chrono::milliseconds patience) {
    leave();
    instance_ = instance;
    lastView_ = {};
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
    link_->steering = {};
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
        const QString text = translated(error);
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
    if (!link_->client) return; // a called function has left the server; so below
    if (gone) {
        failAll(tr("the server ended before it answered"));
        if (state_ != SessionState::Connecting) become(SessionState::Lost);
        return;
    }
    readStatus();
    if (!link_->client) return;
    become(now == ipc::LinkState::Busy ? SessionState::Busy : SessionState::Connected);
    if (!link_->client) return;
    sendSteering();
    sendWaiting();
    if (link_->client->readFrame(link_->next)) {
        link_->lastNews = Clock::now();
        toRgb32(link_->next.pixels);
        std::swap(link_->frame, link_->next);
        // The next frame must be newer than this one.
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

} // namespace gui
