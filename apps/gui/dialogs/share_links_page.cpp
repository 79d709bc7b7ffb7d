#include "gui/dialogs/share_links_page.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/qr_dialog.h"
#include "gui/view/plain_widgets.h"
#include "gui/view/qr_code.h"

#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QSysInfo>
#include <QUrl>
#include <QVBoxLayout>

#include <initializer_list>

namespace gui {

namespace {

// The start, with the address, is what one looks for.
void set(QLineEdit& field, const QString& text) {
    field.setText(text);
    field.setCursorPosition(0);
}

QString visitorsText(const QList<Visitor>& visitors) {
    if (visitors.isEmpty()) return ShareLinksPage::tr("No visitors at the moment.");
    QStringList names;
    for (const Visitor& each : visitors) {
        const QString name = each.name.isEmpty() ? ShareLinksPage::tr("without a name") : each.name;
        names.append(each.drives ? ShareLinksPage::tr("%1 (drives)").arg(name) : name);
    }
    return ShareLinksPage::tr("Visitors at the moment: %1 – %2")
        .arg(visitors.size())
        .arg(names.join(QStringLiteral(", ")));
}

QString wayText(const BridgeRequest& request, const BridgeLinks& links) {
    if (!request.address.isEmpty() && !links.certificate.isEmpty())
        return ShareLinksPage::tr("Browsers ask once whether to go on. This certificate is known by %1")
            .arg(links.certificate);
    if (!request.address.isEmpty() && !request.encrypted())
        return ShareLinksPage::tr("Not encrypted: anyone on the network can see the images and the links.");
    if (!request.address.isEmpty()) return {};
    return ShareLinksPage::tr("From another machine: ssh -L %1:127.0.0.1:%1 %2, and then the same links.")
        .arg(QUrl(links.viewer).port())
        .arg(QSysInfo::machineHostName());
}

} // namespace

ShareLinksPage::ShareLinksPage(QWidget* parent)
    : QWidget(parent), column_(new QVBoxLayout(this)),
      driver_(addRow({tr("&Driver's link:"), tr("&Copy"), tr("&Open here"), tr("&QR code"), {}})),
      viewer_(addRow({tr("&Viewer's link:"), tr("Co&py"), tr("Open &here"), tr("Q&R code"),
                      tr("For any number of visitors who only look.")})),
      way_(wrappedLabel()), visitors_(wrappedLabel()), told_(wrappedLabel()) {
    column_->setContentsMargins(0, 0, 0, 0);
    for (PlainLabel* label : {way_, visitors_, told_}) column_->addWidget(label);
    column_->addStretch();
    way_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    visitors_->setAccessibleName(tr("Visitors"));
}

ShareLinksPage::Row ShareLinksPage::addRow(const RowTexts& texts) {
    const Row row{new QWidget, new QLineEdit, wrappedLabel(texts.meaning), new QPushButton(texts.code)};
    const QString name = QString(texts.title).remove(QLatin1Char('&')).remove(QLatin1Char(':'));
    auto* label = new PlainLabel(texts.title);
    label->setBuddy(row.link);
    row.link->setReadOnly(true);
    row.link->setAccessibleName(name);
    auto* copy = new QPushButton(texts.copy);
    auto* open = new QPushButton(texts.open);
    auto* grid = new QGridLayout(row.box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(label, 0, 0, 1, -1);
    int column = 0;
    for (QWidget* each : std::initializer_list<QWidget*>{row.link, copy, open, row.code})
        grid->addWidget(each, 1, column++);
    grid->addWidget(row.meaning, 2, 0, 1, -1);
    column_->addWidget(row.box);
    for (QPushButton* button : {copy, open, row.code}) {
        button->setAutoDefault(false);
        button->setAccessibleDescription(name);
    }
    connect(copy, &QPushButton::clicked, this, [this, link = row.link] {
        QGuiApplication::clipboard()->setText(link->text());
        tell(tr("The link was copied."));
    });
    connect(open, &QPushButton::clicked, this, [this, link = row.link] { emit openWanted(link->text()); });
    connect(row.code, &QPushButton::clicked, this, [this, name, link = row.link] {
        auto* code = new QrDialog(name, link->text(), this);
        connect(link, &QLineEdit::textChanged, code, &QDialog::close); // it was used
        code->open();
    });
    return row;
}

void ShareLinksPage::show(const BridgeRequest& request, const BridgeLinks& links) {
    if (links.viewer != viewer_.link->text()) told_->clear();
    driver_.box->setVisible(!links.driver.isEmpty());
    set(*driver_.link, links.driver);
    set(*viewer_.link, links.viewer);
    driver_.meaning->setText(
        request.mayEdit ? tr("For visitors who may walk, one at a time, and change settings, lights and "
                             "materials. They cannot load or save anything, nor end the server.")
                        : tr("For visitors who may walk, one at a time. They cannot change, load or save "
                             "anything, nor end the server."));
    driver_.meaning->setText(driver_.meaning->text() + QLatin1Char(' ') +
                             tr("The link is good once, for one page; then the next one is shown here."));
    viewer_.meaning->setText(
        request.mayNote ? tr("For any number of visitors who only look, and write notes with their name.")
                        : tr("For any number of visitors who only look."));
    // A phone does not reach an address that only this machine knows.
    for (const Row& row : {driver_, viewer_})
        row.code->setVisible(hasQrCodes() && !request.address.isEmpty());
    const QString way = wayText(request, links);
    way_->setText(way);
    way_->setVisible(!way.isEmpty());
}

void ShareLinksPage::show(const QList<Visitor>& visitors) { visitors_->setText(visitorsText(visitors)); }
void ShareLinksPage::tell(const QString& text) { told_->setText(text); }

} // namespace gui
