/// How a viewer or client stands to its server.
#pragma once

namespace ipc {

enum class LinkState {
    Connected,
    Busy, ///< the server lives but has been silent for half a second: it draws a long frame, or is stopped
    Gone, ///< no server; a new one is looked for with every call
};

} // namespace ipc
