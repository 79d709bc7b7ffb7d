/// The figures that a room reports, at one moment.
#pragma once

#include "bridge/control/roles.h"
#include "bridge/control/server_commands.h"
#include "bridge/stream/histogram.h"
#include "bridge/stream/rate_control.h"
#include "bridge/stream/server_frames.h"

#include "ipc/layout/status.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bridge {

struct SessionFigures {
    SessionId id = 0;
    std::string name;
    bool drives = false;
    LinkReport link;
    double bitsPerSecond = 0;            ///< that are sent, over the last second or so
    std::uint64_t sent = 0, skipped = 0; ///< moving frames
    double seconds = 0;                  ///< since it came
};

struct RoomFigures {
    std::string instance;
    std::string
        state; ///< of the server: "there", "busy", "gone", "refused"; "unknown" until it was looked for
    bool hasServer = false;
    ipc::Status server; ///< all 0 without one
    std::vector<SessionFigures> sessions;
    /// Since the bridge began, all sessions together.
    std::array<std::uint64_t, kRungCount> sent{};
    std::uint64_t parts = 0, skipped = 0, bytes = 0;
    Histogram publishToSocket; ///< until the last byte of a frame was written
    FrameFigures frames;
    CommandFigures commands;
};

} // namespace bridge
