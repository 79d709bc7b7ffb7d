/// What pages ask for, by name, and the commands that this becomes. Text is composed from numbers and words
/// of tables alone: what a page writes is never part of a command.
#pragma once

#include "bridge/control/caps.h"

#include "common/commands/command_table.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

/// A request that cannot be done; the text is a sentence for people.
class Refused : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What the answer to a command holds beside its text.
enum class AnswerShape { Text, Light, Parts, Materials, Material, Seen };

struct PlannedCommand {
    app::CommandId id{};
    std::string line;    ///< for the server
    bool anyone = false; ///< viewers may, too
    bool edits = false;  ///< one step of undo
    AnswerShape shape = AnswerShape::Text;
    std::string setting; ///< that `set` changes
};

/// What requests are held against.
struct RequestSurroundings {
    const Limits& limits;
    std::span<const std::string> bookmarks; ///< of the scene
    std::size_t lights = 0;                 ///< that it has
    bool sky = false;                       ///< that it has one
};

/// Throws Refused for an unknown name, a key that is missing, of another type or out of range, and what is
/// locked. Never another exception but std::bad_alloc, whatever `request` holds. Who asks is not looked at.
PlannedCommand planRequest(const nlohmann::json& request, const RequestSurroundings& surroundings);

/// The names that planRequest() knows, and their commands; for tests and documents.
struct RequestName {
    std::string_view name;
    app::CommandId command;
};
std::vector<RequestName> requestNames();

/// The server's answer as a page gets it: keys beside `ok` and `text`. What is not as expected is left out.
nlohmann::json answerContent(AnswerShape shape, const std::string& text);

} // namespace bridge
