#include "gui/dialogs/share_plan_page.h"

#include "gui/dialogs/fields.h"
#include "gui/dialogs/file_field.h"
#include "gui/models/preferences.h"
#include "gui/view/plain_widgets.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>

namespace gui {

namespace {

enum Encryption { ByOwnCertificate, ByCertificate, Unencrypted };

} // namespace

SharePlanPage::SharePlanPage(Preferences& preferences, const QList<OwnAddress>& addresses, QWidget* parent)
    : QWidget(parent), preferences_(preferences), from_(new QComboBox), encryption_(new QComboBox),
      certificate_(new FileField(FileField::Kind::Open, tr("Certificate"),
                                 tr("Certificates (*.pem *.crt);;All files (*)"))),
      key_(new FileField(FileField::Kind::Open, tr("Key of the certificate"),
                         tr("Keys (*.pem *.key);;All files (*)"))),
      drive_(new QCheckBox(tr("&Visitors may walk, one at a time"))),
      edit_(new QCheckBox(tr("They may also change settings, &lights and materials"))),
      note_(new QCheckBox(tr("Visitors who only look may &write notes, with their name"))),
      hint_(wrappedLabel()), trouble_(wrappedLabel()), form_(new QFormLayout(this)) {
    from_->setAccessibleName(tr("From"));
    encryption_->setAccessibleName(tr("Encryption"));
    from_->addItem(tr("this machine only"));
    for (const OwnAddress& each : addresses)
        from_->addItem(tr("other machines, by %1 (%2)").arg(each.address, each.network), each.address);
    encryption_->addItems(
        {tr("TLS, by a certificate that is made"), tr("TLS, by a certificate of yours"), tr("none")});
    drive_->setChecked(preferences_.get(pref::shareDriving));
    edit_->setChecked(preferences_.get(pref::shareEdits));
    note_->setChecked(preferences_.get(pref::shareNotes));
    certificate_->setPath(preferences_.get(pref::shareCertificate));
    key_->setPath(preferences_.get(pref::shareKey));
    if (!certificate_->path().isEmpty()) encryption_->setCurrentIndex(ByCertificate);
    build();
    check();
}

void SharePlanPage::build() {
    form_->setContentsMargins(0, 0, 0, 0);
    form_->addRow(
        wrappedLabel(tr("Show what this server renders in web pages: visitors walk or look there and need "
                        "to install nothing. Anyone with a link can do what it allows, until you "
                        "stop sharing.")));
    form_->addRow(QString(), drive_);
    form_->addRow(QString(), edit_);
    form_->addRow(QString(), note_);
    form_->addRow(tr("&From:"), from_);
    form_->addRow(tr("&Encryption:"), encryption_);
    form_->addRow(tr("&Certificate:"), certificate_);
    form_->addRow(tr("&Key:"), key_);
    form_->addRow(hint_);
    form_->addRow(trouble_);
    for (QComboBox* box : {from_, encryption_})
        connect(box, &QComboBox::currentIndexChanged, this, &SharePlanPage::check);
    for (FileField* field : {certificate_, key_})
        connect(field, &FileField::pathChanged, this, &SharePlanPage::check);
    connect(drive_, &QCheckBox::toggled, this, &SharePlanPage::check);
}

bool SharePlanPage::outside() const { return from_->currentData().isValid(); }
bool SharePlanPage::takesCertificate() const {
    return outside() && encryption_->currentIndex() == ByCertificate;
}
bool SharePlanPage::encrypted() const { return outside() && encryption_->currentIndex() != Unencrypted; }

void SharePlanPage::check() {
    edit_->setEnabled(drive_->isChecked());
    form_->setRowVisible(encryption_, outside());
    form_->setRowVisible(certificate_, takesCertificate());
    form_->setRowVisible(key_, takesCertificate());
    QString hint = tr("Other machines get there by ssh; the next page shows how.");
    if (encrypted()) hint = tr("Browsers warn of a certificate that they do not know.");
    if (outside() && !encrypted())
        hint =
            tr("Without encryption everybody in between can read images and links, and use the links. Choose "
               "this only in a network that you trust.");
    hint_->setText(hint);
    trouble_->clear();
    emit changed();
}

bool SharePlanPage::complete() const {
    return !takesCertificate() ||
           (QFileInfo(certificate_->path()).isFile() && QFileInfo(key_->path()).isFile());
}

BridgeRequest SharePlanPage::request() const {
    BridgeRequest request;
    request.address = from_->currentData().toString();
    request.ownCertificate = encrypted() && !takesCertificate();
    if (takesCertificate()) {
        request.certificate = certificate_->path();
        request.key = key_->path();
    }
    request.mayDrive = drive_->isChecked();
    request.mayEdit = edit_->isChecked();
    request.mayNote = note_->isChecked();
    return request;
}

void SharePlanPage::remember() {
    preferences_.set(pref::shareDriving, drive_->isChecked());
    preferences_.set(pref::shareEdits, edit_->isChecked());
    preferences_.set(pref::shareNotes, note_->isChecked());
    preferences_.set(pref::shareCertificate, certificate_->path());
    preferences_.set(pref::shareKey, key_->path());
}

void SharePlanPage::tell(const QString& trouble) { trouble_->setText(trouble); }

} // namespace gui
