// Built without OpenSSL.
#include "bridge/net/http_state.h"
#include "bridge/net/own_certificate.h"

#include "rtcore/platform/error.h"

namespace bridge {

namespace {

[[noreturn]] void refuse(const std::string& file) {
    throw rtcore::FileError(
        rtcore::FailureKind::NoInput, file,
        "this RTBridge was built without OpenSSL; use ssh or a proxy, or build it with OpenSSL");
}

} // namespace

std::unique_ptr<TlsDoor> openTlsDoor(const TlsFiles& files) { refuse(files.certificate); }

OwnCertificate ownCertificate(const std::string& folder, const std::vector<std::string>&) { refuse(folder); }

} // namespace bridge
