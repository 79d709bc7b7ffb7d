#include "renderer/requests.h"

#include "common/process/stop.h"
#include "common/process/terminal.h"

#include "rtcore/platform/error.h"

#include <array>
#include <charconv>
#include <chrono>
#include <utility>

namespace renderer {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMaxLine = 65536;
constexpr auto kLook = 50ms; ///< between two looks at the flags of stopping

/// The text up to the next tab, which is taken from `rest`.
std::optional<std::string_view> cutField(std::string_view& rest) {
    const std::size_t tab = rest.find('\t');
    if (tab == std::string_view::npos) return std::nullopt;
    const std::string_view field = rest.substr(0, tab);
    rest.remove_prefix(tab + 1);
    return field;
}

} // namespace

Request parseRequest(std::string_view line) {
    Request request;
    std::string_view rest = line;
    const std::optional<std::string_view> run = cutField(rest), scene = cutField(rest);
    bool good = run && scene && !scene->empty() && rest.find('\t') == std::string_view::npos;
    if (good) {
        const char* const end = run->data() + run->size();
        const auto [last, error] = std::from_chars(run->data(), end, request.run);
        good = error == std::errc() && last == end;
    }
    if (!good) {
        throw rtcore::FileError(
            rtcore::FailureKind::BadData, std::string("standard input"),
            "a request is a line of a number, a scene and a camera, with tabs between them");
    }
    request.scene = *scene;
    request.camera = rest;
    return request;
}

Requests::Requests() : thread_([this](const std::stop_token& stop) { read(stop); }) {}

Requests::~Requests() = default;

std::optional<Request> Requests::next() {
    std::unique_lock lock(mutex_);
    while (!newest_ && !ended_ && failure_ == nullptr && app::stopSignal() == 0) {
        came_ = false;
        wake_.wait_for(lock, kLook);
    }
    if (failure_ != nullptr) std::rethrow_exception(failure_);
    if (app::stopSignal() != 0 || ended_) return std::nullopt;
    came_ = false;
    app::beginWork();
    return std::exchange(newest_, std::nullopt);
}

bool Requests::pending() {
    const std::lock_guard lock(mutex_);
    return came_;
}

void Requests::read(const std::stop_token& stop) {
    std::array<char, 4096> bytes{};
    while (!stop.stop_requested()) {
        const std::optional<std::string_view> got = app::readInput(bytes, kLook);
        const std::lock_guard lock(mutex_);
        if (!got) {
            ended_ = came_ = true;
            app::endWork();
            wake_.notify_all();
            return;
        }
        for (const char byte : *got) {
            if (byte == '\n') {
                take(std::exchange(unfinished_, {}));
            } else if (unfinished_.size() < kMaxLine) {
                unfinished_ += byte;
            }
        }
    }
}

void Requests::take(std::string_view line) {
    newest_.reset();
    try {
        if (!line.empty()) newest_ = parseRequest(line);
    } catch (...) {
        failure_ = std::current_exception();
    }
    came_ = true;
    app::endWork();
    wake_.notify_all();
}

} // namespace renderer
