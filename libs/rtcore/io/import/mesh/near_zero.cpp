#include "rtcore/io/import/mesh/near_zero.h"

#include "rtcore/io/import/inspection/import_warnings.h"

namespace rtcore {

void noteOrigin(const LocalOrigin& origin, FileImport& import) {
    import.report.origin.zero = origin;
    warnOfCoarseness(import.coarseness, import.model, import.report);
}

} // namespace rtcore
