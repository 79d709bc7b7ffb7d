#include "gui/processes/job_process.h"

#include "gui/processes/detach.h"
#include "gui/processes/programs.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTimer>

#include <utility>

namespace gui {

std::optional<ProgressReport> readProgress(const QByteArray& line) {
    if (!line.startsWith('{')) return std::nullopt;
    const QJsonObject object = QJsonDocument::fromJson(line).object();
    const QJsonValue phase = object.value(QLatin1String("phase"));
    if (!phase.isString()) return std::nullopt;
    const auto number = [&](const char* name) -> std::optional<double> {
        const QJsonValue value = object.value(QLatin1String(name));
        return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
    };
    ProgressReport report;
    report.phase = phase.toString();
    report.fraction = number("fraction");
    report.frame = static_cast<int>(number("frame").value_or(0));
    report.frames = static_cast<int>(number("frames").value_or(0));
    report.secondsLeft = number("secondsLeft");
    return report;
}

JobProcess::JobProcess(QObject* parent) : QObject(parent), process_(new QProcess(this)) {
    process_->setStandardInputFile(QProcess::nullDevice());
    connect(process_, &QProcess::readyReadStandardOutput, this,
            [this] { read(output_, process_->readAllStandardOutput()); });
    connect(process_, &QProcess::readyReadStandardError, this,
            [this] { read(error_, process_->readAllStandardError()); });
    connect(process_, &QProcess::finished, this, [this](int exitCode, QProcess::ExitStatus status) {
        const bool crashed = status == QProcess::CrashExit;
        finish(exitCode,
               crashed ? tr("The program was killed or has crashed (signal %1).").arg(exitCode) : QString());
    });
    connect(
        process_, &QProcess::errorOccurred, this,
        [this](QProcess::ProcessError error) {
            if (error == QProcess::FailedToStart) finish(-1, process_->errorString());
        },
        Qt::QueuedConnection); // never from within start()
}

JobProcess::~JobProcess() {
    process_->disconnect(this);
    if (process_->state() == QProcess::NotRunning) return;
    process_->terminate();
    constexpr int kPatience = 5000;
    if (process_->waitForFinished(kPatience)) return;
    process_->kill();
    process_->waitForFinished(kPatience);
}

void JobProcess::start(const QString& program, const QStringList& arguments, const QString& folder) {
    const QString path = programPath(program);
    if (path.isEmpty()) {
        const QString text = tr("The program %1 was found neither beside this one nor in PATH.").arg(program);
        QTimer::singleShot(0, this, [this, text] { emit ended(-1, text); });
        return;
    }
    process_->setWorkingDirectory(folder);
    startInBackground(*process_);
    process_->start(path, arguments);
}

void JobProcess::stop() { process_->terminate(); }
void JobProcess::kill() { process_->kill(); }
qint64 JobProcess::process() const { return process_->processId(); }

void JobProcess::read(Stream& stream, const QByteArray& bytes) {
    QByteArray& rest = stream.rest += bytes;
    qsizetype begin = 0;
    for (qsizetype end = 0; (end = rest.indexOf('\n', begin)) >= 0; begin = end + 1)
        take(stream, rest.mid(begin, end - begin));
    rest.remove(0, begin);
}

void JobProcess::take(Stream& stream, const QByteArray& line) {
    if (const auto report = readProgress(line)) {
        emit progressed(*report);
    } else {
        if (const auto shown = stream.lines.shown(QString::fromUtf8(line))) emit printed(*shown);
    }
}

void JobProcess::finish(int exitCode, const QString& trouble) {
    read(output_, process_->readAllStandardOutput());
    read(error_, process_->readAllStandardError());
    for (Stream* stream : {&output_, &error_}) {
        if (!stream->rest.isEmpty()) take(*stream, std::exchange(stream->rest, {}));
    }
    emit ended(exitCode, trouble);
}

} // namespace gui
