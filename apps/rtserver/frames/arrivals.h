/// Arrivals at the server while a frame is drawn, as far as they matter to the frame.
#pragma once

namespace rtserver {

struct Arrivals {
    bool change = false; ///< something that the state does not know yet, and that may change what is shown
    bool end = false;    ///< the server is to end
    bool obstructed = false; ///< a client has sent more commands behind one that waits for this frame
};

} // namespace rtserver
