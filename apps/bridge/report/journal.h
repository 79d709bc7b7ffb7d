/// What happens, a line each on standard error: ten a second at most, and none that would have to wait.
#pragma once

#include "bridge/net/doorkeeper.h"

#include <cstdint>
#include <string>

namespace bridge {

/// One thread. What comes from outside is in `text` as names without controls only; never a token.
class Journal {
  public:
    void note(const std::string& text);

  private:
    TokenBucket lines_{10, 10};
    std::uint64_t leftOut_ = 0;
};

} // namespace bridge
