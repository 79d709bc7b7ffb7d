#include "gui/processes/link_opener.h"

#include "gui/processes/programs.h"

#include <QDesktopServices>
#include <QTemporaryFile>
#include <QUrl>

namespace gui {

LinkOpener::LinkOpener() = default;
LinkOpener::~LinkOpener() = default;

bool LinkOpener::open(const QString& link) {
    page_ = std::make_unique<QTemporaryFile>(sessionFolder() + QStringLiteral("/rtsuite-link-XXXXXX.html"));
    const QString text = QStringLiteral("<!doctype html><meta charset=\"utf-8\">"
                                        "<meta http-equiv=\"refresh\" content=\"0;url=%1\">"
                                        "<title>rtsuite</title><a href=\"%1\">rtsuite</a>\n")
                             .arg(link.toHtmlEscaped());
    if (!page_->open() || page_->write(text.toUtf8()) < 0) return false;
    page_->close();
    return QDesktopServices::openUrl(QUrl::fromLocalFile(page_->fileName()));
}

void LinkOpener::forget() { page_.reset(); }

} // namespace gui
