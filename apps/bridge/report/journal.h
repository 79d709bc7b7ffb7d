/// Events, a line each on standard error: ten per second at most, and none that would have to wait.
#pragma once

#include "bridge/net/doorkeeper.h"

#include <cstdint>
#include <string>

namespace bridge {

/// One thread. Callers put text from outside into `text` as names without controls only, and never a token.
class Journal {
  public:
    void note(const std::string& text);

  private:
    TokenBucket lines_{10, 10};
    std::uint64_t leftOut_ = 0;
};

} // namespace bridge
