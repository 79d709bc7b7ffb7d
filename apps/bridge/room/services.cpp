#include "bridge/room/services.h"

#include "bridge/control/command_link.h"
#include "bridge/paths/renderer_process.h"
#include "bridge/stream/frame_source.h"

#include <utility>

namespace bridge {

RoomServices realServices(Post post, std::function<void(const std::string& line)> note, bool byPaths) {
    return {.commands =
                [](const std::string& instance, app::KeyRestraint restraint, ServerEvents events) {
                    return std::make_unique<CommandLink>(instance, restraint, std::move(events));
                },
            .frames =
                [](const std::string& instance, const RungTable& rungs, FrameEvents events) {
                    return std::make_unique<FrameSource>(instance, rungs, std::move(events));
                },
            .renderer = [byPaths]() -> std::unique_ptr<PathRenderer> {
                if (!byPaths) return nullptr;
                return std::make_unique<RendererProcess>(steadyClock());
            },
            .post = std::move(post),
            .note = std::move(note)};
}

} // namespace bridge
