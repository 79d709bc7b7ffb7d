#include "gui/dialogs/connect_dialog.h"

#include "gui/models/plain_text.h"
#include "gui/view/plain_widgets.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace gui {

namespace {

constexpr int kLookMilliseconds = 1000;

QTreeWidgetItem* rowOf(const RunningServer& server) {
    const QString size =
        server.resolution.isEmpty()
            ? ConnectDialog::tr("loading")
            : QStringLiteral("%1 × %2").arg(server.resolution.width()).arg(server.resolution.height());
    auto* row = new QTreeWidgetItem({server.instance, QString::number(server.process),
                                     server.trouble.isEmpty() ? size : ConnectDialog::tr("does not suit"),
                                     QLocale().toString(server.polygons), QString::number(server.clients)});
    for (int column = 0; column < row->columnCount(); ++column)
        row->setToolTip(column, plainTip(server.trouble));
    for (const int column : {1, 3, 4}) row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    row->setDisabled(!server.trouble.isEmpty());
    return row;
}

} // namespace

ConnectDialog::ConnectDialog(const QString& present, QWidget* parent)
    : QDialog(parent), wanted_(present), list_(new QTreeWidget) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Connect"));
    list_->setHeaderLabels({tr("Name"), tr("Process"), tr("Image"), tr("Triangles"), tr("Clients")});
    list_->setRootIsDecorated(false);
    list_->setAlternatingRowColors(true);
    list_->setAccessibleName(tr("Servers"));
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    auto* label = new PlainLabel(tr("&Servers that run on this machine:"));
    label->setBuddy(list_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    connect_ = buttons->addButton(tr("&Connect"), QDialogButtonBox::AcceptRole);
    auto* column = new QVBoxLayout(this);
    column->addWidget(label);
    column->addWidget(list_);
    column->addWidget(buttons);
    connect_->setDefault(true); // once it is in the dialog
    constexpr QSize kSize(560, 280);
    resize(kSize);
    connect(buttons, &QDialogButtonBox::accepted, this, &ConnectDialog::choose);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QTreeWidget::itemActivated, this, &ConnectDialog::choose);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        connect_->setEnabled(item != nullptr);
        if (item != nullptr) wanted_ = item->text(0);
    });
    connect(&timer_, &QTimer::timeout, this, &ConnectDialog::refresh);
    timer_.start(kLookMilliseconds);
    refresh();
    list_->setFocus();
}

void ConnectDialog::refresh() {
    const QString wanted = wanted_;
    list_->clear();
    for (const RunningServer& server : runningServers()) {
        QTreeWidgetItem* row = rowOf(server);
        list_->addTopLevelItem(row);
        const bool first = list_->currentItem() == nullptr && !row->isDisabled();
        if (first || server.instance == wanted) list_->setCurrentItem(row);
    }
    if (list_->topLevelItemCount() > 0) {
        for (const int column : {1, 2, 3, 4}) list_->resizeColumnToContents(column);
    } else {
        auto* none = new QTreeWidgetItem({tr("There is none. “Start new server” starts one.")});
        none->setDisabled(true);
        list_->addTopLevelItem(none);
        none->setFirstColumnSpanned(true);
    }
    connect_->setEnabled(list_->currentItem() != nullptr && !list_->currentItem()->isDisabled());
}

void ConnectDialog::choose() {
    const QTreeWidgetItem* item = list_->currentItem();
    if (item == nullptr || item->isDisabled()) return;
    emit chosen(item->text(0));
    accept();
}

} // namespace gui
