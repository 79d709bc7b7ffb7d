/// The command line of RTBridge.
#pragma once

#include "bridge/control/caps.h"
#include "bridge/net/http_server.h"

#include "common/cli/command_line.h"
#include "common/cli/options.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bridge {

const app::ProgramSpec& bridgeSpec();

constexpr double kPingSeconds = 15; ///< half of the time after which a page is gone

struct BridgeOptions {
    std::vector<std::string> instances; ///< at least one
    ListenAddress listen;
    TlsFiles tls;
    Names names; ///< without those that follow from the port
    std::optional<OriginOption> origin;
    Limits limits;
    bool viewOnly = false;
    std::size_t clients = 64;
    double mostBits = 0; ///< per second; 0: no limit
    double pingSeconds = kPingSeconds;
    std::optional<std::filesystem::path> tokenFile, start;
};

/// Throws app::UsageError.
BridgeOptions readBridgeOptions(const app::Arguments& arguments);

} // namespace bridge
