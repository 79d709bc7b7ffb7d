#include "common/process/message.h"

#include "common/process/terminal.h"

#include "rtcore/settings/plain_text.h"

#include <new>
#include <string>

namespace app {

void printMessage(std::string_view program, std::string_view text) noexcept {
    try {
        std::string line(program);
        line.append(": ").append(rtcore::printable(text)).append("\n");
        writeError(line);
    } catch (const std::bad_alloc&) {
        writeError("not enough memory\n");
    }
}

} // namespace app
