#include "rtcore/neural/nets.h"

#include "rtcore/platform/error.h"

namespace rtcore {

std::shared_ptr<const UNet> Nets::of(Net net) {
    std::shared_ptr<const UNet>& kept = nets_[static_cast<std::size_t>(net)];
    if (kept) return kept;
    const FoundNet found = findNet(fileOf(net), chosen_);
    if (found.file.empty()) throw FileError(FailureKind::NoInput, "", found.missing);
    kept = readNet(fileOf(net), found.file);
    return kept;
}

} // namespace rtcore
