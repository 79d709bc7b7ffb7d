/// Services that rooms use: threads that talk with servers, the thread of the sockets, a clock. Tests put
/// others in their place.
#pragma once

#include "bridge/clock.h"
#include "bridge/control/server_commands.h"
#include "bridge/paths/path_renderer.h"
#include "bridge/stream/server_frames.h"

#include "common/commands/key_restraint.h"

#include <functional>
#include <memory>
#include <string>

namespace bridge {

/// Runs a function on the thread of the sockets, soon; safe from any thread.
using Post = std::function<void(std::function<void()>)>;

struct RoomServices {
    std::function<std::unique_ptr<ServerCommands>(const std::string& instance, app::KeyRestraint,
                                                  ServerEvents)>
        commands;
    std::function<std::unique_ptr<ServerFrames>(const std::string& instance, const RungTable&, FrameEvents)>
        frames;
    /// For images by paths at rest; null, as a function or as what it makes: none.
    std::function<std::unique_ptr<PathRenderer>()> renderer;
    Post post;
    std::function<void(const std::string& line)> note; ///< for the journal; on the thread of the sockets
    const Clock& clock = steadyClock();                ///< outlives all of it
};

/// By CommandLink, FrameSource and, where images at rest are `byPaths`, RendererProcess.
RoomServices realServices(Post post, std::function<void(const std::string& line)> note, bool byPaths);

} // namespace bridge
