/// Rules of the protocol that some test must notice when they are broken.
#pragma once

namespace ipc {

/// Whether a rule is kept: always, and at no cost, in the product. scripts/check-mutants.sh compiles the
/// library with RT_IPC_RULES; then the rule that the environment variable RT_BROKEN_RULE names is broken.
#ifdef RT_IPC_RULES
bool keeps(const char* rule);
#else
constexpr bool keeps(const char*) { return true; }
#endif

} // namespace ipc
