/// A certificate of this user's own, for https without an authority: browsers ask once whether to trust it.
#pragma once

#include <string>
#include <vector>

namespace bridge {

struct OwnCertificate {
    std::string file;        ///< PEM, the certificate and its key; mode 0600
    std::string fingerprint; ///< SHA-256, as browsers show it: "AB:CD:..."
};

/// The one that is kept in `folder`, if it is good for all of `names` and a month more; else a new one, for
/// these and a year, in its place (P-256, signed by itself). `names`: addresses and host names; a name
/// with other signs than letters, digits, dots and hyphens is left out. Throws
/// rtcore::FileError: CannotWrite, BadData where others may read the file; NoInput without OpenSSL.
OwnCertificate ownCertificate(const std::string& folder, const std::vector<std::string>& names);

} // namespace bridge
