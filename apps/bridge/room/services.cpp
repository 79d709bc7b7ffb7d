#include "bridge/room/services.h"

#include "bridge/control/command_link.h"
#include "bridge/stream/frame_source.h"

#include <utility>

namespace bridge {

RoomServices realServices(Post post, std::function<void(const std::string& line)> note) {
    return {.commands =
                [](const std::string& instance, app::KeyRestraint restraint, ServerEvents events) {
                    return std::make_unique<CommandLink>(instance, restraint, std::move(events));
                },
            .frames =
                [](const std::string& instance, const RungTable& rungs, FrameEvents events) {
                    return std::make_unique<FrameSource>(instance, rungs, std::move(events));
                },
            .post = std::move(post),
            .note = std::move(note)};
}

} // namespace bridge
