#include "ipc/endpoint/open_link.h"

#include "ipc/platform/error.h"

#include <thread>

namespace ipc {

Link openLink(const Names& names, Access access, Clock::time_point deadline) {
    while (true) {
        if (std::optional<Link> link = Link::open(names, access)) return std::move(*link);
        if (Clock::now() >= deadline) {
            throw Error(Problem::NoServer, "no server '{0}' is running; start one or name another instance",
                        {names.instance()});
        }
        std::this_thread::sleep_for(kLookEvery);
    }
}

} // namespace ipc
