// Built without OpenSSL.
#include "bridge/net/http_state.h"

#include "rtcore/platform/error.h"

namespace bridge {

std::unique_ptr<TlsDoor> openTlsDoor(const TlsFiles& files) {
    throw rtcore::FileError(
        rtcore::FailureKind::NoInput, files.certificate,
        "this RTBridge was built without OpenSSL; use ssh or a proxy, or build it with OpenSSL");
}

} // namespace bridge
