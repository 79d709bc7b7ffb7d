#include "bridge/admission.h"

#include "bridge/net/doorkeeper.h"

#include <algorithm>
#include <utility>

namespace bridge {

namespace {

constexpr double kLoadedAgain = 60, kLost = 3600; // seconds
constexpr std::size_t kMaxUsed = 64;

} // namespace

Admission::OwnToken* Admission::find(std::string_view token, double now) {
    std::erase_if(own_, [&](const OwnToken& each) { return each.pages == 0 && now > each.until; });
    const auto found =
        std::ranges::find_if(own_, [&](const OwnToken& each) { return sameToken(token, each.token); });
    return found == own_.end() ? nullptr : &*found;
}

Right Admission::rightOf(std::string_view token, double now) {
    const bool drives = sameToken(token, tokens_.driver), views = sameToken(token, tokens_.viewer);
    if (drives || find(token, now) != nullptr) return Right::Drive;
    if (views) return Right::View;
    const bool used =
        std::ranges::any_of(used_, [&](const std::string& each) { return sameToken(token, each); });
    return used ? Right::Used : Right::None;
}

Admission::Entered Admission::enter(std::string_view token, double now) {
    if (OwnToken* const own = find(token, now)) {
        ++own->pages;
        return {own->token, false};
    }
    if (tokens_.lasting || !sameToken(token, tokens_.driver)) return {};
    used_.push_back(std::exchange(tokens_.driver, newToken()));
    if (used_.size() > kMaxUsed) used_.pop_front();
    own_.push_back({newToken(), 1, 0});
    return {own_.back().token, true};
}

void Admission::left(std::string_view own, bool inOrder, double now) {
    OwnToken* const found = find(own, now);
    if (found == nullptr) return;
    --found->pages;
    found->until = now + (inOrder ? kLoadedAgain : kLost);
}

} // namespace bridge
