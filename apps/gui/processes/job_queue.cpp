#include "gui/processes/job_queue.h"

#include "gui/models/plain_text.h"
#include "gui/processes/job_process.h"
#include "gui/session/server_sentence.h"

#include "bspbuilder/builder_spec.h"
#include "common/progress/progress_format.h"
#include "renderer/renderer_spec.h"
#include "rtcore/platform/sentence.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>

namespace gui {

namespace {

constexpr qsizetype kMaxLog = 256 * 1024;

QStringList withQueueOptions(const JobRequest& request) {
    QStringList words{QStringLiteral("--progress=json")};
    for (const app::ProgramSpec* spec : {&renderer::rendererSpec(), &bspbuilder::builderSpec()}) {
        if (request.program == QString::fromStdString(spec->name) && spec->find("parent") != nullptr)
            words += QStringLiteral("--parent=%1").arg(QCoreApplication::applicationPid());
    }
    return words + request.arguments;
}

// "Renderer: nave.scn: there is no such file", without what hints at --help.
QString lastMessage(const Job& job) {
    const QString prefix = job.request.program + QStringLiteral(": ");
    const QString warning = prefix + translated(rtcore::say("warning: {0}", std::string()));
    const QStringList lines = job.log.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        if (line->startsWith(prefix) && !line->startsWith(warning)) return line->mid(prefix.size());
    }
    return lines.isEmpty() ? QString() : lines.last();
}

QString phaseText(const QString& phase) {
    static constexpr const char* kPhases[] = {QT_TRANSLATE_NOOP("JobPhase", "reading the scene"),
                                              QT_TRANSLATE_NOOP("JobPhase", "importing"),
                                              QT_TRANSLATE_NOOP("JobPhase", "building the tree"),
                                              QT_TRANSLATE_NOOP("JobPhase", "checking the tree"),
                                              QT_TRANSLATE_NOOP("JobPhase", "loading images"),
                                              QT_TRANSLATE_NOOP("JobPhase", "checking"),
                                              QT_TRANSLATE_NOOP("JobPhase", "waiting for frames"),
                                              QT_TRANSLATE_NOOP("JobPhase", "measuring the light"),
                                              QT_TRANSLATE_NOOP("JobPhase", "rendering"),
                                              QT_TRANSLATE_NOOP("JobPhase", "denoising"),
                                              QT_TRANSLATE_NOOP("JobPhase", "writing"),
                                              QT_TRANSLATE_NOOP("JobPhase", "finishing the film")};
    for (const char* known : kPhases) {
        if (phase == QLatin1String(known)) return QCoreApplication::translate("JobPhase", known);
    }
    return phase;
}

} // namespace

JobQueue::JobQueue(QObject* parent) : QAbstractTableModel(parent) {}
JobQueue::~JobQueue() = default;

quint64 JobQueue::add(const JobRequest& request) {
    const auto row = static_cast<int>(jobs_.size());
    beginInsertRows({}, row, row);
    Job job;
    job.id = ++last_;
    job.request = request;
    jobs_.append(job);
    endInsertRows();
    startNext();
    return job.id;
}

int JobQueue::rowOf(quint64 id) const {
    const auto found =
        std::find_if(jobs_.begin(), jobs_.end(), [id](const Job& job) { return job.id == id; });
    return found == jobs_.end() ? -1 : static_cast<int>(found - jobs_.begin());
}

Job* JobQueue::current() {
    const int row = rowOf(running_);
    return row < 0 ? nullptr : &jobs_[row];
}

int JobQueue::unfinished() const {
    return static_cast<int>(
        std::count_if(jobs_.begin(), jobs_.end(), [](const Job& job) { return !job.over(); }));
}

bool JobQueue::busy() const { return unfinished() > 0; }

bool JobQueue::makes(const QString& result) const {
    return std::any_of(jobs_.begin(), jobs_.end(),
                       [&](const Job& job) { return !job.over() && job.request.result == result; });
}

void JobQueue::startNext() {
    if (running_ != 0) return;
    const auto next = std::find_if(jobs_.begin(), jobs_.end(),
                                   [](const Job& job) { return job.state == JobState::Waiting; });
    if (next != jobs_.end()) launch(*next);
}

void JobQueue::launch(Job& job) {
    running_ = job.id;
    job.state = JobState::Running;
    process_ = std::make_unique<JobProcess>(this);
    connect(process_.get(), &JobProcess::progressed, this, &JobQueue::onProgress);
    connect(process_.get(), &JobProcess::printed, this, &JobQueue::onPrinted);
    connect(process_.get(), &JobProcess::ended, this, &JobQueue::onEnded);
    process_->start(job.request.program, withQueueOptions(job.request), {});
    tell(rowOf(running_));
}

void JobQueue::onProgress(const ProgressReport& report) {
    Job* job = current();
    if (job == nullptr) return;
    job->phase = report.phase;
    job->fraction = report.fraction;
    job->secondsLeft = report.secondsLeft;
    job->frame = report.frame;
    job->frames = report.frames;
    tell(rowOf(job->id));
}

void JobQueue::onPrinted(const QString& line) {
    Job* job = current();
    if (job == nullptr) return;
    job->log += line + QLatin1Char('\n');
    if (job->log.size() > kMaxLog) job->log = job->log.right(kMaxLog / 2);
    tell(rowOf(job->id));
}

void JobQueue::onEnded(int exitCode, const QString& trouble) {
    process_.release()->deleteLater(); // it is in the middle of telling us
    Job* job = current();
    running_ = 0;
    if (job == nullptr) return;
    const quint64 id = job->id;
    // One that came to its end before it heard of the wish is done.
    if (exitCode == 0 && trouble.isEmpty()) {
        job->state = JobState::Done;
    } else if (job->state == JobState::Stopping) {
        job->state = JobState::Cancelled;
    } else {
        job->state = JobState::Failed;
        const QString words = lastMessage(*job);
        job->message = !trouble.isEmpty() ? trouble
                       : words.isEmpty()  ? tr("It ended with exit code %1.").arg(exitCode)
                                          : words;
    }
    job->secondsLeft.reset();
    tell(rowOf(id));
    emit finished(id);
    startNext();
}

bool JobQueue::canMove(int row, int step) const {
    const int to = row + step;
    if (row < 0 || to < 0 || row >= jobs_.size() || to >= jobs_.size()) return false;
    return jobs_[row].state == JobState::Waiting && jobs_[to].id != running_;
}

void JobQueue::move(int row, int step) {
    if (canMove(row, step)) moveTo(row, row + step);
}

void JobQueue::moveTo(int from, int to) {
    if (from == to) return;
    beginMoveRows({}, from, from, {}, to > from ? to + 1 : to);
    jobs_.move(from, to);
    endMoveRows();
}

void JobQueue::cancel(int row) {
    Job& job = jobs_[row];
    if (job.state == JobState::Waiting) {
        job.state = JobState::Cancelled;
        tell(row);
        emit finished(job.id);
    } else if (job.state == JobState::Running) {
        job.state = JobState::Stopping;
        process_->stop();
        constexpr int kPatience = 20000;
        QTimer::singleShot(kPatience, process_.get(), &JobProcess::kill);
        tell(row);
    } else if (job.state == JobState::Stopping) {
        process_->kill();
    }
}

void JobQueue::cancelAll() {
    for (auto row = static_cast<int>(jobs_.size()) - 1; row >= 0; --row) {
        if (jobs_[row].state == JobState::Waiting || jobs_[row].state == JobState::Running) cancel(row);
    }
}

void JobQueue::runAgain(int row) {
    if (!jobs_[row].over()) return;
    moveTo(row, static_cast<int>(jobs_.size()) - 1);
    Job& job = jobs_.last();
    Job fresh;
    fresh.id = job.id;
    fresh.request = job.request;
    job = fresh;
    tell(static_cast<int>(jobs_.size()) - 1);
    startNext();
}

void JobQueue::remove(int row) {
    if (!jobs_[row].over()) return;
    beginRemoveRows({}, row, row);
    jobs_.removeAt(row);
    endRemoveRows();
}

void JobQueue::removeFinished() {
    for (auto row = static_cast<int>(jobs_.size()) - 1; row >= 0; --row) remove(row);
}

void JobQueue::tell(int row) {
    emit dataChanged(index(row, 0), index(row, Columns - 1));
    emit changed(jobs_[row].id);
}

int JobQueue::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(jobs_.size());
}
int JobQueue::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : Columns; }

QString JobQueue::stateText(const Job& job) const {
    switch (job.state) {
    case JobState::Waiting:
        return tr("waiting");
    case JobState::Running:
        if (job.frames > 1)
            return tr("%1 %2 of %3")
                .arg(phaseText(job.phase), QString::number(job.frame), QString::number(job.frames));
        return job.phase.isEmpty() ? tr("starting") : phaseText(job.phase);
    case JobState::Stopping:
        return tr("stopping");
    case JobState::Done:
        return tr("done");
    case JobState::Failed:
        return tr("failed");
    case JobState::Cancelled:
        return tr("cancelled");
    }
    return {};
}

QVariant JobQueue::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= jobs_.size()) return {};
    const Job& job = jobs_[index.row()];
    const bool runs = job.state == JobState::Running;
    if (role == RunningRole) return runs;
    if (role == FractionRole) {
        if (job.state == JobState::Done) return 1.0;
        return runs && job.fraction ? QVariant(*job.fraction) : QVariant();
    }
    if (role == Qt::ToolTipRole)
        return plainTip(job.message.isEmpty() ? commandText(job.request.program, job.request.arguments)
                                              : job.message);
    if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
    constexpr double kPercent = 100;
    switch (index.column()) {
    case Title:
        return plainText(job.request.title);
    case State:
        return stateText(job);
    case Progress:
        if (job.state == JobState::Done) return tr("%1 %").arg(100);
        return runs && job.fraction ? tr("%1 %").arg(static_cast<int>(*job.fraction * kPercent)) : QString();
    case TimeLeft:
        return runs && job.secondsLeft ? QString::fromStdString(app::durationText(*job.secondsLeft))
                                       : QString();
    default:
        return {};
    }
}

QVariant JobQueue::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
    case Title:
        return tr("Job");
    case State:
        return tr("State");
    case Progress:
        return tr("Progress");
    case TimeLeft:
        return tr("Time left");
    default:
        return {};
    }
}

} // namespace gui
