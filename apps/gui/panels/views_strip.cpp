#include "gui/panels/views_strip.h"

#include "gui/models/plain_text.h"

#include <QAction>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace gui {

namespace {

constexpr QSize kStripImage{160, 100};
constexpr int kSpace = 6;

} // namespace

ViewsStrip::ViewsStrip(QWidget* parent)
    : QWidget(parent), list_(new QListWidget), add_(new QToolButton), menu_(new QMenu(this)) {
    list_->setAccessibleName(tr("Views"));
    list_->setViewMode(QListView::IconMode);
    list_->setFlow(QListView::LeftToRight);
    list_->setWrapping(false);
    list_->setMovement(QListView::Static);
    list_->setIconSize(kStripImage);
    list_->setSpacing(kSpace);
    list_->setUniformItemSizes(true);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    add_->setText(QStringLiteral("+"));
    add_->setAccessibleName(tr("Add"));
    add_->setToolTip(tr("Keep the current view"));
    add_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(list_, 1);
    layout->addWidget(add_);
    fillMenu();
    connect(add_, &QToolButton::clicked, this, &ViewsStrip::addWanted);
    connect(list_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { emit goWanted(list_->row(item)); });
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
        connect(addKey(*list_, key), &QAction::triggered, this, &ViewsStrip::go);
    connect(list_, &QListWidget::itemChanged, this, &ViewsStrip::onEdited);
    connect(list_, &QListWidget::currentRowChanged, this, &ViewsStrip::enable);
    connect(list_, &QWidget::customContextMenuRequested, this, [this](const QPoint& position) {
        const QListWidgetItem* item = list_->itemAt(position);
        if (item == nullptr) item = list_->currentItem(); // by the key
        if (item == nullptr) return;
        list_->setCurrentRow(list_->row(item));
        menu_->popup(list_->viewport()->mapToGlobal(list_->visualItemRect(item).center()));
    });
    enable();
}

QAction* ViewsStrip::addEntry(const QString& text, const QKeySequence& key, void (ViewsStrip::*act)()) {
    QAction* action = menu_->addAction(text);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    list_->addAction(action); // the key works in the list
    connect(action, &QAction::triggered, this, act);
    return action;
}

void ViewsStrip::fillMenu() {
    go_ = addEntry(tr("&Go there"), {}, &ViewsStrip::go);
    rename_ = addEntry(tr("&Rename"), Qt::Key_F2, &ViewsStrip::beginRename);
    replace_ = addEntry(tr("Re&place by the current view"), {}, &ViewsStrip::replace);
    menu_->addSeparator();
    left_ = addEntry(tr("Move &left"), Qt::CTRL | Qt::Key_Left, &ViewsStrip::moveLeft);
    right_ = addEntry(tr("Move r&ight"), Qt::CTRL | Qt::Key_Right, &ViewsStrip::moveRight);
    menu_->addSeparator();
    delete_ = addEntry(tr("&Delete"), Qt::Key_Delete, &ViewsStrip::remove);
}

QSize ViewsStrip::sizeHint() const {
    const int text = 2 * list_->fontMetrics().lineSpacing();
    return {4 * kStripImage.width(), kStripImage.height() + text + 4 * kSpace +
                                         list_->horizontalScrollBar()->sizeHint().height() + 2 * kSpace};
}

void ViewsStrip::show(const QList<BookmarkRow>& rows) {
    const QSignalBlocker quiet(list_);
    const int before = list_->currentRow();
    prepareList(*list_, names_, rows);
    const qsizetype moved = names_.indexOf(std::exchange(moving_, QString()));
    const int current = moved >= 0 ? static_cast<int>(moved) : before;
    const QColor empty = palette().color(QPalette::Midlight);
    for (int i = 0; i < rows.size(); ++i) {
        const BookmarkRow& row = rows[i];
        QString tip = i < 9 ? tr("%1\nAlt+%2").arg(row.name, QString::number(i + 1)) : row.name;
        if (row.picture.isNull()) tip += QLatin1Char('\n') + tr("Its image comes when you go there.");
        showView(*list_, i, row.name, viewIcon(row.picture, kStripImage, devicePixelRatioF(), empty), tip);
    }
    list_->setCurrentRow(std::min(std::max(current, 0), list_->count() - 1));
    enable();
}

void ViewsStrip::setServerThere(bool there) {
    server_ = there;
    enable();
}

void ViewsStrip::enable() {
    const int row = list_->currentRow();
    add_->setEnabled(server_);
    for (QAction* action : {go_, replace_}) action->setEnabled(server_ && row >= 0);
    for (QAction* action : {rename_, delete_}) action->setEnabled(row >= 0);
    left_->setEnabled(row > 0);
    right_->setEnabled(row >= 0 && row + 1 < list_->count());
}

void ViewsStrip::go() {
    if (list_->currentRow() >= 0) emit goWanted(list_->currentRow());
}

void ViewsStrip::beginRename() {
    if (list_->currentItem() == nullptr) return;
    list_->setFocus();
    list_->editItem(list_->currentItem());
}

void ViewsStrip::replace() { emit replaceWanted(list_->currentRow()); }

void ViewsStrip::moveLeft() { moveBy(-1); }
void ViewsStrip::moveRight() { moveBy(1); }

// The moved one stays the current one; until it is there no other one moves.
void ViewsStrip::moveBy(int by) {
    const int row = list_->currentRow();
    if (!moving_.isEmpty() || row < 0) return;
    moving_ = names_[row];
    emit moveWanted(row, by);
}

void ViewsStrip::remove() {
    if (list_->currentRow() >= 0) emit deleteWanted(list_->currentRow());
}

void ViewsStrip::onEdited(QListWidgetItem* item) {
    const int row = list_->row(item);
    if (row >= 0 && row < names_.size() && item->text() != names_[row]) emit renameWanted(row, item->text());
}

} // namespace gui
