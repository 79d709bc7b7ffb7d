#include "rtserver/messages.h"

#include "rtserver/server_options.h"

#include "common/process/message.h"
#include "common/process/terminal.h"

#include "rtcore/io/text/sentence_json.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace rtserver {

namespace {

constexpr std::size_t kLongest = 4000;
constexpr std::size_t kMaxKept = 100, kLongestKept = 500; ///< all fit into one answer
constexpr auto kSayEvery = std::chrono::seconds(1);

} // namespace

void Messages::print(const rtcore::Sentence& said) {
    if (!app::errorTakesMore()) return;
    const std::string text = rtcore::printable(said.english());
    if (text.size() > kLongest)
        app::printMessage(serverSpec().name, text.substr(0, kLongest));
    else
        app::printSentence(serverSpec().name, said);
}

void Messages::warn(const rtcore::Sentence& said) {
    print(rtcore::say("warning: {0}", said));
    keep("warning", said);
}

void Messages::complain(const rtcore::Sentence& said) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < kSayEvery) {
        ++others_;
        return;
    }
    last_ = now;
    const rtcore::Sentence all =
        others_ == 0 ? said : rtcore::say("{0} (and {1} other failures before)", said, others_);
    others_ = 0;
    print(all);
    keep("warning", all);
}

void Messages::offer(const rtcore::Sentence& said) { keep("offer", said); }

// Their lines stay, since clients count them, but are empty.
void Messages::withdrawOffers() {
    for (Kept& kept : kept_) {
        if (kept.line.compare(kept.line.find(' ') + 1, 6, "offer ") == 0) kept = {};
    }
}

void Messages::tell(const rtcore::Sentence& said) { keep("event", said); }

void Messages::keep(const char* kind, const rtcore::Sentence& said) {
    const std::string text = rtcore::printable(said.english());
    const bool whole = text.size() <= kLongestKept; // then the detail is of a like length
    kept_.push_back({fmt::format("{} {} {}", ++count_, kind, rtcore::printable(text, kLongestKept)),
                     whole ? rtcore::sentenceJson(said) : ""});
    if (kept_.size() > kMaxKept) kept_.pop_front();
}

std::string Messages::since(std::uint32_t known) const { return since(known, &Kept::line); }

std::string Messages::detailsSince(std::uint32_t known) const { return since(known, &Kept::detail); }

std::string Messages::since(std::uint32_t known, std::string Kept::*which) const {
    const std::size_t news = std::min<std::size_t>(kept_.size(), count_ - std::min(known, count_));
    std::string text;
    bool first = true;
    for (auto kept = kept_.end() - static_cast<std::ptrdiff_t>(news); kept != kept_.end(); ++kept) {
        if (kept->line.empty()) continue;
        text += (std::exchange(first, false) ? "" : "\n") + (*kept).*which;
    }
    return text;
}

} // namespace rtserver
