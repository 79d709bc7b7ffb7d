#include "gui/processes/server_process.h"

#include "gui/processes/detach.h"
#include "gui/processes/programs.h"
#include "gui/session/printed_lines.h"

#include "common/process/private_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTimer>

#include <utility>

namespace gui {

namespace {

constexpr qint64 kMaxServerLog = 256 * 1024;

QStringList wordsOf(const ServerRequest& request) {
    QStringList words{request.scene, QStringLiteral("--instance=") + request.instance};
    if (!request.resolution.isEmpty()) {
        words.append(QStringLiteral("--resolution=%1x%2")
                         .arg(request.resolution.width())
                         .arg(request.resolution.height()));
    }
    if (!request.keep) words.append(QStringLiteral("--parent=%1").arg(QCoreApplication::applicationPid()));
    return words + request.options;
}

} // namespace

QStringList frameTimeOption(int milliseconds) {
    return {QStringLiteral("--frame-time=%1").arg(milliseconds)};
}

ServerProcess::ServerProcess(QObject* parent) : QObject(parent) {}

ServerProcess::~ServerProcess() {
    if (!running()) return;
    process_->disconnect(this);
    process_->terminate();
    constexpr int kPatience = 3000;
    if (!process_->waitForFinished(kPatience)) {
        process_->kill();
        process_->waitForFinished(kPatience);
    }
}

bool ServerProcess::running() const {
    return process_ != nullptr && process_->state() != QProcess::NotRunning;
}
qint64 ServerProcess::process() const { return running() ? process_->processId() : 0; }

void ServerProcess::start(const ServerRequest& request) {
    request_ = request;
    stopping_ = false;
    logFile_ = logPath(QStringLiteral("RTServer-") + request.instance);
    QFile::remove(logFile_);
    app::makePrivateFile(logFile_.toStdString());
    const QString program = programPath(QStringLiteral("RTServer"));
    if (program.isEmpty()) {
        const QString text = tr("The program RTServer was found neither beside this one nor in PATH.");
        QTimer::singleShot(0, this, [this, text] { emit ended(text); });
        return;
    }
    if (process_ != nullptr) process_->deleteLater();
    process_ = new QProcess(this);
    process_->setProcessChannelMode(QProcess::MergedChannels);
    process_->setStandardOutputFile(logFile_);
    process_->setStandardInputFile(QProcess::nullDevice());
    startDetached(*process_);
    connect(process_, &QProcess::finished, this, [this](int exitCode, QProcess::ExitStatus status) {
        tellEnd(exitCode, status == QProcess::CrashExit);
    });
    connect(process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            emit ended(tr("RTServer cannot be started: %1").arg(process_->errorString()));
    });
    process_->start(program, wordsOf(request));
}

void ServerProcess::tellEnd(int exitCode, bool crashed) {
    if (std::exchange(stopping_, false)) return emit ended({});
    const QString words = lastWords();
    if (crashed) {
        emit ended(tr("The server was killed or has crashed (signal %1).").arg(exitCode));
    } else if (exitCode != 0) {
        emit ended(words.isEmpty() ? tr("The server ended with exit code %1.").arg(exitCode) : words);
    } else {
        emit ended({}); // another program ended it
    }
}

QString ServerProcess::log() const {
    QFile file(logFile_);
    if (!file.open(QIODevice::ReadOnly)) return {};
    if (file.size() > kMaxServerLog) file.seek(file.size() - kMaxServerLog);
    return translatedOutput(QString::fromUtf8(file.readAll()));
}

QString ServerProcess::lastWords() const {
    const QString prefix = QStringLiteral("RTServer: ");
    const QString line = log().trimmed().section(QLatin1Char('\n'), -1);
    const bool failure = line.startsWith(prefix) && !line.startsWith(prefix + QStringLiteral("ready: "));
    return failure ? line.mid(prefix.size()) : QString();
}

void ServerProcess::stop(int patienceMilliseconds) {
    if (!running()) return;
    stopping_ = true;
    process_->terminate();
    QTimer::singleShot(patienceMilliseconds, process_, [process = process_] {
        if (process->state() != QProcess::NotRunning) process->kill();
    });
}

// A QProcess kills what it started when it is destroyed; so this one never is.
void ServerProcess::release() {
    if (!running()) return;
    process_->disconnect(this);
    process_->setParent(nullptr);
    static auto* const released = new QList<QProcess*>;
    released->append(process_);
    process_ = nullptr;
}

} // namespace gui
