/// A process that keeps secrets in its memory, and what it makes them of.
#pragma once

#include <span>
#include <string>

namespace app {

/// No core files from now on, and no more rights for this process or its children.
void protectSecrets() noexcept;

/// Takes them from the system. Throws std::runtime_error where it has none.
void fillWithRandomBytes(std::span<unsigned char> bytes);

/// From now on SIGUSR1 asks to make secrets anew, in place of ending the process. Before the first thread.
void installRenewalHandler();
/// Whether it came since the last call. Any thread.
bool takeRenewalRequest() noexcept;

/// The name of this machine; "" where the system gives none.
std::string hostName();

} // namespace app
