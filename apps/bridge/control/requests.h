/// Requests of pages: commands that the table permits them, with arguments that are checked against its rows.
/// A line is composed of numbers and of words of tables alone. Text of a page is part of it in notes only, as
/// one word in quotation marks, without control characters but for line breaks.
#pragma once

#include "bridge/control/caps.h"

#include "common/commands/command_table.h"

#include "rtcore/platform/sentence.h"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <stdexcept>
#include <string>

namespace bridge {

/// A request that cannot be done; the text is a sentence for people.
class Refused : public std::runtime_error, public rtcore::Worded {
  public:
    explicit Refused(const rtcore::Sentence& why) : std::runtime_error(why.english()), Worded(why) {}
};

struct PlannedCommand {
    app::CommandId id{};
    std::string line;    ///< for the server
    bool anyone = false; ///< viewers may, too
    bool note = false;   ///< adds one
    bool named = false;  ///< it has an author
    bool edits = false;  ///< one step of undo
    std::string setting; ///< that `set` changes
};

/// The limits and the scene that requests are checked against.
struct RequestContext {
    const Limits& limits;
    std::span<const std::string> bookmarks;             ///< of the scene
    std::size_t lights = 0;                             ///< that it has
    bool sky = false;                                   ///< that it has one
    std::span<const std::string> flights{}, variants{}; ///< of the scene
};

/// Whether pages may ask for it.
bool isRequest(const app::CommandSpec& command);

/// The command for {"do": "light temperature", "args": [3, 4000]}; {"also": true} makes an edit part of the
/// last one. Throws Refused for a command that pages may not ask for, arguments of another number, type or
/// range, and anything locked; no other exception but std::bad_alloc, whatever `request` holds. Does not
/// check which session asks.
PlannedCommand planRequest(const nlohmann::json& request, const RequestContext& context);

/// The rows of commands that pages may ask for, with the names, ranges and words of their arguments.
nlohmann::json commandTableJson();

/// The server's answer to a command as a page gets it: keys beside `ok` and `text`; none where `text` is the
/// answer. Unexpected parts are left out.
nlohmann::json answerContent(app::CommandId id, const std::string& text);

} // namespace bridge
