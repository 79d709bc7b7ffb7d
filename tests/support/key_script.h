/// A player whose keys are pressed and released at random moments, looked at between frames of any length.
#pragma once

#include "rtcore/motion/player.h"
#include "support/random_numbers.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

namespace test {

inline constexpr std::int64_t kSecond = 1'000'000'000; ///< ns

struct KeyEvent {
    std::int64_t at = 0; ///< ns
    rtcore::Action action = rtcore::Action::Forward;
    bool down = true;
};

/// Ascending, three a second and more, the last one after `until`.
inline std::vector<KeyEvent> randomEvents(std::uint64_t seed, std::int64_t until) {
    Random random(seed);
    std::vector<KeyEvent> events;
    std::int64_t at = 0;
    while (at < until) {
        at += static_cast<std::int64_t>(random.index(kSecond / 3));
        events.push_back({at, static_cast<rtcore::Action>(random.index(14)), random.coin()});
    }
    return events;
}

/// Cameras at ten fixed moments a second, with frames whose lengths (ns) `nextFrame` gives in between.
template <typename NextFrame>
std::vector<rtcore::Camera> playKeys(rtcore::Player& player, const std::vector<KeyEvent>& events,
                                     std::int64_t until, NextFrame&& nextFrame) {
    std::vector<rtcore::Camera> cameras;
    rtcore::ActionSet held;
    std::int64_t now = 0, frame = nextFrame(), look = kSecond / 10;
    auto event = events.begin();
    while (now < until) {
        std::int64_t next = std::min(frame, look);
        if (event != events.end()) next = std::min(next, event->at);
        player.advance(std::chrono::nanoseconds(next - now));
        now = next;
        for (; event != events.end() && event->at == now; ++event) held.set(event->action, event->down);
        player.hold(held);
        if (now == frame) frame += nextFrame();
        if (now == look) {
            cameras.push_back(player.camera());
            look += kSecond / 10;
        }
    }
    return cameras;
}

} // namespace test
