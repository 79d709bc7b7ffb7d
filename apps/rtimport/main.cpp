/// rtimport: reads a model, most formats with Assimp, and writes it as a .bsp without a tree. It is started
/// by importModel, which watches its memory and its time; whatever a damaged file does to Assimp ends with
/// this process. Files of CAD's surfaces are handed to rtimport_cad beside it, where that is there: the
/// libraries that read them take longer to load than most models.
#include "rtimport/importer_run.h"

#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/replace_process.h"

#include <string>
#include <vector>

namespace {

rtcore::FileImport read(const std::filesystem::path& path, const rtcore::FileImportOptions& options) {
    return rtcore::importFile(path, options);
}

/// The model is the last word but one. What is none is complained of later.
void handOverCad(int argc, char** argv) {
    if (argc < 3) return;
    try {
        const std::filesystem::path reader = rtcore::programFolder() / "rtimport_cad";
        if (rtcore::cadFormat(argv[argc - 2]) && std::filesystem::exists(reader))
            rtcore::becomeProgram(reader, std::vector<std::string>(argv + 1, argv + argc));
    } catch (const std::exception&) {
        return;
    }
}

} // namespace

int main(int argc, char** argv) {
    handOverCad(argc, argv);
    return importer::runImporter(argc, argv, read);
}
