/// Answers from the server to one client, through the ring in the client's slot. Never waits.
#pragma once

#include "ipc/layout/control_block.h"
#include "ipc/layout/message_headers.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace ipc {

struct ReplyRecord {
    std::uint64_t sequence = 0;
    std::uint16_t code = 0; ///< as ReplyHeader has it
    std::string text;
    std::string detail; ///< the same for programs; may be empty
};

enum class RingResult {
    Done,
    Nothing, ///< no room (write) or no reply (read)
    Broken,  ///< the other side's counter is invalid
};

/// The server's end. It keeps its own counter and does not trust that in the ring.
class ReplyWriter {
  public:
    /// Empties the ring for a new client.
    void reset(ReplyRing& ring);
    /// Text and detail have at most kMaxAnswerText bytes.
    RingResult write(ReplyRing& ring, const ReplyRecord& reply);

  private:
    std::uint64_t head_ = 0;
};

/// The client's end.
class ReplyReader {
  public:
    RingResult read(ReplyRing& ring, ReplyRecord& reply);

  private:
    std::uint64_t tail_ = 0;
};

} // namespace ipc
