#include "bridge/report/journal.h"

#include "bridge/clock.h"

#include "common/process/message.h"
#include "common/process/terminal.h"

#include <fmt/core.h>

#include <utility>

namespace bridge {

void Journal::note(const std::string& text) {
    // A terminal that is stopped must not stop the pages.
    if (!lines_.take(nowSeconds()) || !app::errorTakesMore()) {
        ++leftOut_;
        return;
    }
    const std::uint64_t missing = std::exchange(leftOut_, 0);
    app::printMessage("RTBridge", missing == 0
                                      ? text
                                      : fmt::format("{} ({} lines before it were left out)", text, missing));
}

} // namespace bridge
