#include "gui/dialogs/jobs_panel.h"

#include "gui/models/plain_text.h"
#include "gui/processes/job_queue.h"
#include "gui/view/plain_widgets.h"
#include "gui/view/progress_delegate.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QImageReader>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>
#include <QUrl>
#include <QVBoxLayout>

namespace gui {

namespace {

constexpr int kPictureWide = 200, kPictureHigh = 120;

// As large as it is needed: an image of many megapixels is not unpacked as a whole where its format allows.
QPixmap readSmall(const QString& file, const QSize& room, double ratio) {
    QImageReader reader(file);
    const QSize size = reader.size();
    if (size.isValid()) reader.setScaledSize(size.scaled(room * ratio, Qt::KeepAspectRatio));
    QPixmap small = QPixmap::fromImage(reader.read());
    small.setDevicePixelRatio(ratio);
    return small;
}

} // namespace

JobsPanel::JobsPanel(JobQueue& queue, QWidget* parent)
    : QWidget(parent), queue_(queue), table_(new QTreeView), picture_(new PlainLabel),
      message_(new PlainLabel), none_(new PlainLabel(tr("There are no jobs. Render > Render… makes one."))),
      log_(new QPlainTextEdit) {
    makeTable();
    picture_->setFixedSize(kPictureWide, kPictureHigh);
    picture_->setAlignment(Qt::AlignCenter);
    picture_->setAccessibleName(tr("Result"));
    picture_->hide();
    message_->setWordWrap(true);
    message_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    log_->setReadOnly(true);
    log_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    log_->setLineWrapMode(QPlainTextEdit::NoWrap);
    log_->setAccessibleName(tr("Log of the job"));
    log_->setTabChangesFocus(true);

    auto* text = new QVBoxLayout;
    text->addWidget(message_);
    text->addWidget(log_, 1);
    details_ = new QWidget;
    auto* beside = new QHBoxLayout(details_);
    beside->setContentsMargins(0, 0, 0, 0);
    beside->addLayout(text, 1);
    beside->addWidget(picture_, 0, Qt::AlignTop);
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(table_);
    parts->addWidget(details_);
    parts->setChildrenCollapsible(false);
    jobs_ = new QWidget;
    auto* rows = new QVBoxLayout(jobs_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(makeButtons());
    rows->addWidget(parts, 1);
    none_->setFocusPolicy(Qt::StrongFocus);
    auto* column = new QVBoxLayout(this);
    column->addWidget(none_);
    column->addWidget(jobs_, 1);

    connect(&queue_, &JobQueue::changed, this, [this](quint64 id) {
        if (row() == queue_.rowOf(id)) refresh();
    });
    connect(&queue_, &QAbstractItemModel::rowsMoved, this, &JobsPanel::refresh);
    connect(&queue_, &QAbstractItemModel::rowsRemoved, this, &JobsPanel::refresh);
    connect(&queue_, &QAbstractItemModel::rowsInserted, this,
            [this](const QModelIndex&, int, int last) { table_->setCurrentIndex(queue_.index(last, 0)); });
    refresh();
}

void JobsPanel::makeTable() {
    table_->setModel(&queue_);
    table_->setRootIsDecorated(false);
    table_->setUniformRowHeights(true);
    table_->setAlternatingRowColors(true);
    table_->setAllColumnsShowFocus(true);
    table_->setAccessibleName(tr("Jobs"));
    table_->setItemDelegateForColumn(
        JobQueue::Progress, new ProgressDelegate(JobQueue::FractionRole, JobQueue::RunningRole, this));
    table_->header()->setStretchLastSection(false);
    table_->header()->setSectionResizeMode(JobQueue::Title, QHeaderView::Stretch);
    constexpr int kStateWide = 130, kProgressWide = 110, kTimeWide = 70, kMinWide = 480;
    table_->setColumnWidth(JobQueue::State, kStateWide);
    table_->setColumnWidth(JobQueue::Progress, kProgressWide);
    table_->setColumnWidth(JobQueue::TimeLeft, kTimeWide);
    table_->setMinimumWidth(kMinWide);
    connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, &JobsPanel::refresh);
    connect(table_, &QTreeView::activated, this, &JobsPanel::show);
}

QToolButton* JobsPanel::addButton(const QString& text, const QString& tip, void (JobsPanel::*act)()) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(plainTip(tip));
    button->setAccessibleName(tip);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, act);
    return button;
}

QWidget* JobsPanel::makeButtons() {
    show_ = addButton(tr("Show"), tr("Show the result"), &JobsPanel::show);
    folder_ = addButton(tr("Open folder"), tr("Open the folder of the result"), &JobsPanel::openFolder);
    up_ = addButton(tr("Up"), tr("Let the job run earlier"), &JobsPanel::moveUp);
    down_ = addButton(tr("Down"), tr("Let the job run later"), &JobsPanel::moveDown);
    cancel_ = addButton(tr("Cancel"), tr("Stop the job, or take it out of the queue"), &JobsPanel::cancel);
    again_ =
        addButton(tr("Run again"), tr("Put the job at the end of the queue once more"), &JobsPanel::runAgain);
    remove_ =
        addButton(tr("Remove"), tr("Remove the job from the list; its result stays"), &JobsPanel::remove);
    clear_ = addButton(tr("Remove finished"), tr("Remove all jobs that are over from the list"),
                       &JobsPanel::removeFinished);
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    for (QToolButton* button : {show_, folder_, up_, down_, cancel_, again_, remove_, clear_})
        row->addWidget(button);
    row->addStretch(1);
    return bar;
}

QSize JobsPanel::sizeHint() const {
    constexpr QSize kSize(900, 200);
    return queue_.rowCount() > 0 ? kSize : layout()->sizeHint();
}

int JobsPanel::row() const {
    const QModelIndex index = table_->currentIndex();
    return index.isValid() && index.row() < queue_.rowCount() ? index.row() : -1;
}

void JobsPanel::choose(quint64 id) {
    if (queue_.rowOf(id) >= 0) table_->setCurrentIndex(queue_.index(queue_.rowOf(id), 0));
}

void JobsPanel::moveUp() {
    queue_.move(row(), -1);
    refresh();
}
void JobsPanel::moveDown() {
    queue_.move(row(), 1);
    refresh();
}
void JobsPanel::cancel() {
    if (row() >= 0) queue_.cancel(row());
}
void JobsPanel::runAgain() {
    if (row() < 0) return;
    const quint64 id = queue_.job(row()).id;
    queue_.runAgain(row());
    choose(id);
}
void JobsPanel::remove() {
    if (row() >= 0) queue_.remove(row());
}
void JobsPanel::removeFinished() { queue_.removeFinished(); }

void JobsPanel::openFolder() {
    if (row() < 0) return;
    const QFileInfo result(queue_.job(row()).request.result);
    QDesktopServices::openUrl(QUrl::fromLocalFile(result.absolutePath()));
}

void JobsPanel::show() {
    if (row() < 0) return;
    const QString file = resultFile(queue_.job(row()).request.result);
    if (queue_.job(row()).state == JobState::Done && !file.isEmpty()) emit showWanted(file);
}

void JobsPanel::refresh() {
    const int at = row();
    const Job* job = at < 0 ? nullptr : &queue_.job(at);
    const bool over = job != nullptr && job->over();
    show_->setEnabled(job != nullptr && job->state == JobState::Done);
    folder_->setEnabled(job != nullptr && !job->request.result.isEmpty());
    up_->setEnabled(queue_.canMove(at, -1));
    down_->setEnabled(queue_.canMove(at, 1));
    cancel_->setEnabled(job != nullptr && !over);
    cancel_->setText(job != nullptr && job->state == JobState::Stopping ? tr("Kill") : tr("Cancel"));
    again_->setEnabled(over);
    remove_->setEnabled(over);
    bool anyOver = false;
    for (int each = 0; each < queue_.rowCount(); ++each) anyOver |= queue_.job(each).over();
    clear_->setEnabled(anyOver);
    showWhetherAny();
    showDetails();
}

// One line while there is nothing to see.
void JobsPanel::showWhetherAny() {
    const bool any = queue_.rowCount() > 0;
    jobs_->setVisible(any);
    none_->setVisible(!any);
    QWidget* focused = any ? static_cast<QWidget*>(table_) : none_;
    if (focusProxy() != focused) setFocusProxy(focused);
    setMaximumHeight(any ? QWIDGETSIZE_MAX : layout()->sizeHint().height());
    updateGeometry();
}

void JobsPanel::showDetails() {
    const int at = row();
    details_->setVisible(at >= 0);
    const Job job = at < 0 ? Job() : queue_.job(at);
    message_->setText(job.message);
    message_->setVisible(!job.message.isEmpty());
    if (log_->toPlainText() != job.log) {
        log_->setPlainText(job.log);
        log_->verticalScrollBar()->setValue(log_->verticalScrollBar()->maximum());
    }
    const bool done = job.state == JobState::Done;
    if (job.id == detailed_ && done == over_) return;
    detailed_ = job.id;
    over_ = done;
    const QString file = done ? resultFile(job.request.result) : QString();
    const QPixmap small = file.isEmpty() ? QPixmap() : readSmall(file, picture_->size(), devicePixelRatioF());
    picture_->setPixmap(small);
    picture_->setVisible(!small.isNull());
}

} // namespace gui
