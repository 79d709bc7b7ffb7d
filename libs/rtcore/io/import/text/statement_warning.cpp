#include "rtcore/io/import/text/statement_warning.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/settings/plain_text.h"

namespace rtcore {

void OddStatements::warn(const std::filesystem::path& file, ImportReport& report) const {
    if (count_ == 0) return;
    const std::string name = inQuotes(file.filename().string()), keyword = inQuotes(keyword_);
    const char* const form = count_ == 1   ? import_forms::kOddStatement
                             : count_ == 2 ? import_forms::kTwoOddStatements
                                           : import_forms::kOddStatements;
    addWarning(report, say(form, name, line_, keyword, count_ - 1));
}

} // namespace rtcore
