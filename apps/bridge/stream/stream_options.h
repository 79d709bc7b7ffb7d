/// How the frames of an instance are to be sent.
#pragma once

#include "bridge/stream/rung.h"

#include <algorithm>
#include <optional>

namespace bridge {

constexpr double kPingSeconds = 15; ///< half of the time after which a page is gone

struct StreamOptions {
    /// JPEG quality of moving frames, 50..95; these have full size then, unless a page or `maxBits` asks for
    /// less. Nothing: by the link of each page.
    std::optional<int> quality;
    double maxBits = 0;                ///< a second, for all viewers together; 0: no limit
    double pingSeconds = kPingSeconds; ///< of silence, after which a page gets a ping

    /// The rung of pages that choose none; nothing: by their links.
    std::optional<int> fixedRung() const { return quality ? std::optional(kFirstRung) : std::nullopt; }
    /// kRungs with that quality at kFirstRung, finest first as ever.
    RungTable rungs() const {
        RungTable table = kRungs;
        if (!quality) return table;
        for (int i = 0; i < kRungCount && table[static_cast<std::size_t>(i)].divide == 1; ++i) {
            int& each = table[static_cast<std::size_t>(i)].quality;
            each = i < kFirstRung   ? std::max(each, *quality)
                   : i > kFirstRung ? std::min(each, *quality)
                                    : *quality;
        }
        return table;
    }
};

} // namespace bridge
