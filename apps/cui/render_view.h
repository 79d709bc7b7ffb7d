/// The command `render`: the server's view, rendered by the Renderer.
#pragma once

#include "cui/conversation.h"

#include <span>
#include <string>

namespace cui {

/// FILE and options for the Renderer, which gets the scene and the camera that the server exports into a
/// private folder, our standard streams and our current folder. A "--" between them may be there. Throws
/// CommandFailure with the Renderer's exit code, app::UsageError without a FILE, and what
/// Conversation::request() throws.
void renderView(Conversation& conversation, std::span<const std::string> arguments);

} // namespace cui
