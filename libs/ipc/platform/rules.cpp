#include "ipc/platform/rules.h"

#ifdef RT_IPC_RULES

#include <cstdlib>
#include <string_view>

namespace ipc {

bool keeps(const char* rule) {
    static const char* const broken = std::getenv("RT_BROKEN_RULE");
    return broken == nullptr || std::string_view(rule) != broken;
}

} // namespace ipc

#endif
