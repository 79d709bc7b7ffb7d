/// A run of the Renderer or of BSPBuilder, and its progress.
#pragma once

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>

namespace gui {

class PrivateFolder;

struct JobRequest {
    QString title;                        ///< for people: "nave.png"
    QString program;                      ///< "Renderer", "BSPBuilder"
    QStringList arguments;                ///< without what the queue adds: progress, parent
    QString result;                       ///< the file that it makes; #### stands for the numbers of frames
    std::shared_ptr<PrivateFolder> files; ///< private input; lives as long as the job; may be null
};

enum class JobState { Waiting, Running, Stopping, Done, Failed, Cancelled };

struct Job {
    quint64 id = 0; ///< counts from 1; never used twice in a queue
    JobRequest request;
    JobState state = JobState::Waiting;
    QString phase;                     ///< as the program calls it: "rendering"
    std::optional<double> fraction;    ///< of the phase, 0..1
    std::optional<double> secondsLeft; ///< estimate
    int frame = 0, frames = 0;         ///< of a list; 0 = none
    QString log;                       ///< the last part of the program's output
    QString message;                   ///< of a failure: why, in the program's words

    /// There is nothing to wait for any more.
    bool over() const { return state > JobState::Stopping; }
};

/// The command as a shell takes it.
QString commandText(const QString& program, const QStringList& arguments);

/// The result as a file: of a pattern the newest frame. Empty when there is none.
QString resultFile(const QString& result);

} // namespace gui
