/// Named points at which a fault test may kill the process. Nothing at all in the product; the fault tests
/// compile the library a second time with RT_IPC_STAGES and bring a stage() of their own.
#pragma once

namespace ipc {

#ifdef RT_IPC_STAGES
void stage(const char* name);
#else
inline void stage(const char*) {}
#endif

} // namespace ipc
