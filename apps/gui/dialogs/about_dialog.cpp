#include "gui/dialogs/about_dialog.h"

#include "gui/gui_spec.h"
#include "gui/view/plain_widgets.h"

#include "common/cli/help_text.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QVBoxLayout>

namespace gui {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("About"));
    constexpr int kIcon = 64;
    auto* icon = new PlainLabel;
    icon->setPixmap(QIcon(QStringLiteral(":/gui.png")).pixmap(kIcon));
    icon->setAlignment(Qt::AlignTop);
    auto* what = markupLabel(
        tr("<h3>rtsuite</h3><p>Interactive ray tracing.</p><p>Open a scene or a model and walk in it, with "
           "shadows, mirrors and glass traced ray by ray by the processor alone.</p>"
           "<p>After <i>Ray Tracing Algorithm For Interactive Applications</i>.</p>"));
    what->setWordWrap(true);
    auto* version = new PlainLabel(QString::fromStdString(app::versionText(guiSpec())).trimmed() +
                                   tr("\nQt %1").arg(QString::fromLatin1(qVersion())));
    version->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    version->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* right = new QVBoxLayout;
    right->addWidget(what);
    right->addWidget(version);
    auto* row = new QHBoxLayout;
    row->addWidget(icon);
    row->addLayout(right, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(buttons);
    constexpr int kWide = 460;
    setMinimumWidth(kWide);
}

} // namespace gui
