/// The queue as one sees it: rows with progress, the result and the log of the row that is chosen, and what
/// can be done with it.
#pragma once

#include "gui/processes/job.h"

#include <QWidget>

class QPlainTextEdit;
class QToolButton;
class QTreeView;

namespace gui {

class JobQueue;
class PlainLabel;

class JobsPanel : public QWidget {
    Q_OBJECT

  public:
    /// `queue` must outlive it.
    explicit JobsPanel(JobQueue& queue, QWidget* parent = nullptr);

    void choose(quint64 id);
    QSize sizeHint() const override;

  signals:
    void showWanted(const QString& file); ///< the result

  private:
    void makeTable();
    QWidget* makeButtons();
    QToolButton* addButton(const QString& text, const QString& tip, void (JobsPanel::*act)());
    void moveUp();
    void moveDown();
    void cancel();
    void runAgain();
    void remove();
    void removeFinished();
    void openFolder();
    void show();
    int row() const; ///< that is chosen; -1 = none
    void refresh();
    void showWhetherAny();
    void showDetails();

    JobQueue& queue_;
    QTreeView* table_;
    PlainLabel *picture_, *message_, *none_;
    QWidget *jobs_, *details_; ///< all but none_; of the job that is chosen
    QPlainTextEdit* log_;
    QToolButton *show_, *folder_, *up_, *down_, *cancel_, *again_, *remove_, *clear_;
    quint64 detailed_ = 0; ///< whose result picture_ shows
    bool over_ = false;
};

} // namespace gui
