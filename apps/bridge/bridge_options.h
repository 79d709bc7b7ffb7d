/// The command line of RTBridge.
#pragma once

#include "bridge/control/caps.h"
#include "bridge/net/http_server.h"
#include "bridge/stream/stream_options.h"

#include "common/cli/command_line.h"
#include "common/cli/options.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bridge {

const app::ProgramSpec& bridgeSpec();

struct BridgeOptions {
    std::vector<std::string> instances; ///< at least one
    ListenAddress listen;
    TlsFiles tls;
    bool ownCertificate = false; ///< in place of these, one that is made and kept
    Names names;                 ///< without those that follow from the port
    std::optional<OriginOption> origin;
    Limits limits;
    bool viewOnly = false;
    std::size_t clients = 64;
    StreamOptions stream;
    bool byPaths = true; ///< images at rest
    bool watch = false;  ///< print a line a second
    std::optional<std::filesystem::path> tokenFile, start;
    std::optional<std::int64_t> parent; ///< ends with this process
};

/// Throws app::UsageError.
BridgeOptions readBridgeOptions(const app::Arguments& arguments);

} // namespace bridge
