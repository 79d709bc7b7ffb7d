/// Named points at which a fault test may kill the process. Nothing at all in the product; the fault tests
/// compile the library a second time with RT_IPC_FAULT_POINTS and bring a faultPoint() of their own.
#pragma once

namespace ipc {

#ifdef RT_IPC_FAULT_POINTS
void faultPoint(const char* name);
#else
inline void faultPoint(const char*) {}
#endif

} // namespace ipc
