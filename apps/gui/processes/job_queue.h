/// The jobs as a table: one runs at a time, the others wait in the order of the rows. Needs no window.
#pragma once

#include "gui/processes/job.h"

#include <QAbstractTableModel>
#include <QList>

#include <memory>

namespace gui {

class JobProcess;
struct ProgressReport;

/// One thread.
class JobQueue : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { Title, State, Progress, TimeLeft, Columns };
    /// Roles of the column Progress: 0..1, or invalid when it is not known; and whether the job runs.
    enum Role { FractionRole = Qt::UserRole, RunningRole };

    explicit JobQueue(QObject* parent = nullptr);
    ~JobQueue() override; ///< stops the running job

    /// At the end; starts at once when nothing else is under way. Returns the job's number.
    quint64 add(const JobRequest& request);
    /// The row must be there for this one, and for all that follow.
    const Job& job(int row) const { return jobs_.at(row); }
    int rowOf(quint64 id) const;             ///< -1 when it is gone
    bool busy() const;                       ///< something runs or waits
    bool makes(const QString& result) const; ///< the result of a job that runs or waits
    int unfinished() const;                  ///< how many run or wait

    /// `step`: -1 up, 1 down. Only jobs that wait can be moved, and none past the one that runs.
    bool canMove(int row, int step) const;
    void move(int row, int step);
    /// A job that waits is cancelled at once; one that runs is asked to end, and asked again by force.
    void cancel(int row);
    void cancelAll();
    /// Only jobs that are over.
    void runAgain(int row); ///< it goes to the end
    void remove(int row);
    void removeFinished();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  signals:
    void changed(quint64 id);  ///< anything of that job
    void finished(quint64 id); ///< done, failed or cancelled

  private:
    void startNext();
    void launch(Job& job);
    void onProgress(const ProgressReport& report);
    void onPrinted(const QString& line);
    void onEnded(int exitCode, const QString& trouble);
    void moveTo(int from, int to);
    void tell(int row);
    Job* current();
    QString stateText(const Job& job) const;

    QList<Job> jobs_;
    std::unique_ptr<JobProcess> process_; ///< of the job that runs
    quint64 running_ = 0, last_ = 0;      ///< numbers; 0 = none
};

} // namespace gui
