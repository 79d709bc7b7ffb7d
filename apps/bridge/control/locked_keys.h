/// Keys of the server that change what pages may not change. Pure.
#pragma once

#include "bridge/control/caps.h"
#include "bridge/control/server_commands.h"
#include "bridge/stream/wire.h"

#include "common/commands/key_restraint.h"

#include <optional>
#include <string_view>

namespace bridge {

/// Which ones is known from the server's answer to `bindings`; none is let through before. One thread.
class LockedKeys {
  public:
    /// `limits` must outlive it.
    explicit LockedKeys(const Limits& limits) : limits_(limits) {}

    /// Whether any key could be locked.
    bool possible() const { return restraint() != app::KeyRestraint::None; }
    /// The restraint that the server has to enforce itself: keys may have been bound anew since.
    app::KeyRestraint restraint() const {
        using app::KeyRestraint;
        return limits_.isLocked("edits")          ? KeyRestraint::Edits
               : limits_.isLocked("bloom.radius") ? KeyRestraint::Bloom
                                                  : KeyRestraint::None;
    }
    /// Lines such as "M+1 selectEnvironment 1".
    void read(std::string_view bindings);
    void forget() { locked_.reset(); }
    /// The input without them.
    InputMessage allowed(InputMessage input) const;

  private:
    bool isLocked(std::string_view action) const;

    const Limits& limits_;
    std::optional<KeySet> locked_;
};

} // namespace bridge
