#include "gui/processes/private_folder.h"

#include "gui/processes/programs.h"
#include "gui/session/server_sentence.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/temporary_folder.h"

namespace gui {

PrivateFolder::PrivateFolder(const std::string& kind) {
    try {
        folder_ =
            std::make_unique<rtcore::TemporaryFolder>(sessionFolder().toStdString(), "rtsuite-" + kind + "-");
    } catch (const rtcore::FileError& error) {
        trouble_ = translated(error);
    }
}

PrivateFolder::~PrivateFolder() = default;

QString PrivateFolder::file(const QString& name) const {
    return folder_ ? QString::fromStdString((folder_->path() / name.toStdString()).string()) : QString();
}

} // namespace gui
