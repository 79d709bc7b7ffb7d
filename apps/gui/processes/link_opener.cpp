#include "gui/processes/link_opener.h"

#include "gui/processes/private_folder.h"

#include <QDesktopServices>
#include <QFile>
#include <QUrl>

namespace gui {

LinkOpener::LinkOpener() = default;
LinkOpener::~LinkOpener() = default;

bool LinkOpener::open(const QString& link) {
    folder_ = std::make_unique<PrivateFolder>("link");
    QFile page(folder_->file(QStringLiteral("link.html")));
    const QString text = QStringLiteral("<!doctype html><meta charset=\"utf-8\">"
                                        "<meta http-equiv=\"refresh\" content=\"0;url=%1\">"
                                        "<title>rtsuite</title><a href=\"%1\">rtsuite</a>\n")
                             .arg(link.toHtmlEscaped());
    const auto mine = QFileDevice::ReadOwner | QFileDevice::WriteOwner;
    if (!page.open(QIODevice::WriteOnly, mine) || page.write(text.toUtf8()) < 0 || !page.flush())
        return false;
    return QDesktopServices::openUrl(QUrl::fromLocalFile(page.fileName()));
}

void LinkOpener::forget() { folder_.reset(); }

} // namespace gui
