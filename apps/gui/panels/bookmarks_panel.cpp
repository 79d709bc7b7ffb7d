#include "gui/panels/bookmarks_panel.h"

#include "gui/models/plain_text.h"

#include <QAction>
#include <QGridLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

constexpr QSize kThumbnail{112, 70};

} // namespace

BookmarksPanel::BookmarksPanel(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), add_(new QPushButton(tr("Add"))),
      go_(new QPushButton(tr("Go"))), rename_(new QPushButton(tr("Rename"))),
      delete_(new QPushButton(tr("Delete"))) {
    list_->setAccessibleName(tr("Bookmarks"));
    list_->setIconSize(kThumbnail);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setSpacing(2);
    add_->setToolTip(tr("Keep the current view"));
    go_->setToolTip(tr("Go to this view; also Enter or a double click"));
    rename_->setToolTip(tr("Also by F2"));
    delete_->setToolTip(tr("Can be undone"));
    auto* buttons = new QGridLayout;
    buttons->addWidget(add_, 0, 0);
    buttons->addWidget(go_, 0, 1);
    buttons->addWidget(rename_, 1, 0);
    buttons->addWidget(delete_, 1, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(list_, 1);
    layout->addLayout(buttons);
    connect(add_, &QPushButton::clicked, this, &BookmarksPanel::addWanted);
    connect(go_, &QPushButton::clicked, this, [this] { emit goWanted(list_->currentRow()); });
    connect(rename_, &QPushButton::clicked, this, [this] { beginRename(list_->currentRow()); });
    const auto remove = [this] {
        if (list_->currentRow() >= 0) emit deleteWanted(list_->currentRow());
    };
    connect(delete_, &QPushButton::clicked, this, remove);
    connect(addKey(*list_, Qt::Key_Delete), &QAction::triggered, this, remove);
    connect(list_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { emit goWanted(list_->row(item)); });
    connect(list_, &QListWidget::itemChanged, this, &BookmarksPanel::onEdited);
    connect(list_, &QListWidget::currentRowChanged, this, &BookmarksPanel::enable);
    enable();
}

void BookmarksPanel::show(const QList<BookmarkRow>& rows) {
    const int current = list_->currentRow();
    const QSignalBlocker quiet(list_);
    prepareList(*list_, names_, rows);
    for (int i = 0; i < rows.size(); ++i) {
        const QString tip = i < 9 ? tr("%1\nAlt+%2").arg(rows[i].name, QString::number(i + 1)) : rows[i].name;
        showView(*list_, i, rows[i].name, viewIcon(rows[i].picture, kThumbnail, devicePixelRatioF()), tip);
    }
    list_->setCurrentRow(std::min(std::max(current, 0), list_->count() - 1));
    enable();
}

void BookmarksPanel::setServerThere(bool there) {
    server_ = there;
    enable();
}

void BookmarksPanel::enable() {
    const bool one = list_->currentRow() >= 0;
    add_->setEnabled(server_);
    go_->setEnabled(server_ && one);
    rename_->setEnabled(one);
    delete_->setEnabled(one);
}

void BookmarksPanel::beginRename(int row) {
    if (row < 0 || row >= list_->count()) return;
    list_->setCurrentRow(row);
    list_->setFocus();
    list_->editItem(list_->item(row));
}

void BookmarksPanel::onEdited(QListWidgetItem* item) {
    const int row = list_->row(item);
    if (row >= 0 && row < names_.size() && item->text() != names_[row]) emit renameWanted(row, item->text());
}

} // namespace gui
