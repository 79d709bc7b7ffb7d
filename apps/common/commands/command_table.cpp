#include "common/commands/command_table.h"

#include "common/commands/command_rows.h"

namespace app {

std::span<const CommandSpec> commandTable() {
    static const std::vector<CommandSpec> table = [] {
        std::vector<CommandSpec> all;
        for (const auto& group :
             {shellCommands(), serverCommands(), settingCommands(), editCommands(), cameraCommands(),
              fileCommands(), lightCommands(), skyCommands(), bookmarkCommands(), modelCommands(),
              sectionCommands(), planCommands(), dimensionCommands(), keptMeasureCommands(), noteCommands(),
              flightCommands(), variantCommands(), measureCommands(), keyCommands()})
            all.insert(all.end(), group.begin(), group.end());
        return all;
    }();
    return table;
}

const CommandSpec& commandOf(CommandId id) { return commandTable()[static_cast<std::size_t>(id)]; }

const CommandSpec* commandNamed(std::string_view name) {
    for (const CommandSpec& command : commandTable())
        if (command.name == name) return &command;
    return nullptr;
}

} // namespace app
