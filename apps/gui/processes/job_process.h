/// One run of a program of the suite that tells its progress as JSON.
#pragma once

#include "gui/session/printed_lines.h"

#include <QByteArray>
#include <QObject>
#include <QString>
#include <QStringList>

#include <optional>

class QProcess;

namespace gui {

struct ProgressReport {
    QString phase;
    std::optional<double> fraction;
    int frame = 0, frames = 0;
    std::optional<double> secondsLeft;
};

/// A line as app::jsonText() writes it; nothing when it is something else.
std::optional<ProgressReport> readProgress(const QByteArray& line);

class JobProcess : public QObject {
    Q_OBJECT

  public:
    explicit JobProcess(QObject* parent = nullptr);
    /// A program that still runs is asked to end, and killed when it does not.
    ~JobProcess() override;

    /// Once. It runs behind what the user is doing, and in the folder `folder`.
    void start(const QString& program, const QStringList& arguments, const QString& folder);
    /// SIGTERM: the program removes what it has half written.
    void stop();
    /// SIGKILL: for one that does not listen.
    void kill();
    qint64 process() const;

  signals:
    void progressed(const gui::ProgressReport& report);
    void printed(const QString& line);
    /// `trouble` is not empty when it could not be started or was killed. Comes once.
    void ended(int exitCode, const QString& trouble);

  private:
    /// What the program prints in one of its two ways.
    struct Stream {
        QByteArray rest; ///< a line that has not ended yet
        PrintedLines lines;
    };
    void read(Stream& stream, const QByteArray& bytes);
    void take(Stream& stream, const QByteArray& line);
    void finish(int exitCode, const QString& trouble);

    QProcess* process_;
    Stream output_, error_;
};

} // namespace gui
