#include "rtserver/messages.h"

#include "rtserver/server_options.h"

#include "common/process/message.h"
#include "common/process/terminal.h"

#include "rtcore/settings/plain_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace rtserver {

namespace {

constexpr std::size_t kLongest = 4000;
constexpr std::size_t kMaxKept = 100, kLongestKept = 500; ///< all fit into one answer
constexpr auto kSayEvery = std::chrono::seconds(1);

} // namespace

void Messages::print(const std::string& text) {
    if (app::errorTakesMore())
        app::printMessage(serverSpec().name, rtcore::printable(text).substr(0, kLongest));
}

void Messages::warn(const std::string& text) {
    print("warning: " + text);
    keep("warning", text);
}

void Messages::complain(const std::string& text) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < kSayEvery) {
        ++others_;
        return;
    }
    last_ = now;
    const std::string others = others_ == 0 ? "" : fmt::format(" (and {} other failures before)", others_);
    others_ = 0;
    print(text + others);
    keep("warning", text + others);
}

void Messages::offer(const std::string& text) { keep("offer", text); }

// Their lines stay, since clients count them, but are empty.
void Messages::withdrawOffers() {
    for (std::string& line : kept_) {
        if (line.compare(line.find(' ') + 1, 6, "offer ") == 0) line.clear();
    }
}

void Messages::tell(const std::string& text) { keep("event", text); }

void Messages::keep(const char* kind, const std::string& text) {
    kept_.push_back(
        fmt::format("{} {} {}", ++count_, kind, rtcore::printable(rtcore::printable(text), kLongestKept)));
    if (kept_.size() > kMaxKept) kept_.pop_front();
}

std::string Messages::since(std::uint32_t known) const {
    const std::size_t news = std::min<std::size_t>(kept_.size(), count_ - std::min(known, count_));
    std::string text;
    for (auto line = kept_.end() - static_cast<std::ptrdiff_t>(news); line != kept_.end(); ++line) {
        if (!line->empty()) text += (text.empty() ? "" : "\n") + *line;
    }
    return text;
}

} // namespace rtserver
