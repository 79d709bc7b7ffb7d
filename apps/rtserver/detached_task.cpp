#include "rtserver/detached_task.h"

#include <atomic>

namespace rtserver {

namespace {
std::atomic<int> atWork{0};
} // namespace

int tasksAtWork() noexcept { return atWork.load(); }
void countTask(int change) noexcept { atWork += change; }

} // namespace rtserver
