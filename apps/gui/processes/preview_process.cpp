#include "gui/processes/preview_process.h"

#include "gui/processes/detach.h"
#include "gui/processes/model_cache.h"
#include "gui/processes/private_folder.h"
#include "gui/processes/programs.h"
#include "gui/session/printed_lines.h"
#include "gui/session/server_list.h"

#include "common/process/exit_codes.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFile>
#include <QProcess>

#include <chrono>
#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kPreviewPace = 15ms;
constexpr int kLingerSeconds = 60; ///< it is ended as soon as its last image is seen, however late that is
constexpr int kMaxTries = 5;       ///< while the predecessor, on a busy machine, takes its time to die
constexpr auto kEndPatience = 1s;  ///< with a Renderer that does not end when it is asked to

int nextNumber() {
    static int number = 0;
    return ++number;
}

// Does not wait for the end. Until it has become a Renderer, a process may lose the request to end.
void end(QProcess& process) {
    if (process.state() == QProcess::Starting) return process.kill();
    process.terminate();
    QTimer::singleShot(kEndPatience, &process, [&process] { process.kill(); });
}

} // namespace

// Numbers of runs grow also from one window to the next that happens to get its name.
PreviewProcess::PreviewProcess(Session& session, const ModelCache& models, QObject* parent)
    : QObject(parent), session_(session), models_(models), instance_(previewInstance(nextNumber())),
      run_(static_cast<quint64>(QDateTime::currentMSecsSinceEpoch()) * 1000) {
    connect(&timer_, &QTimer::timeout, this, &PreviewProcess::look);
}

PreviewProcess::~PreviewProcess() {
    blockSignals(true);
    cancel();
    const QList<QProcess*> dying = findChildren<QProcess*>();
    for (QProcess* process : dying) {
        process->disconnect();
        if (process->waitForFinished(static_cast<int>(std::chrono::milliseconds(kEndPatience).count())))
            continue;
        process->kill();
        process->waitForFinished();
    }
    if (folder_ != nullptr) removeLeftovers(instance_);
}

qint64 PreviewProcess::process() const { return process_ == nullptr ? 0 : process_->processId(); }

QString PreviewProcess::file(const QString& extension) const {
    return folder_->file(QStringLiteral("%1.%2").arg(run_).arg(extension));
}

void PreviewProcess::render(const StillQuality& quality) {
    cancel();
    if (folder_ == nullptr) folder_ = std::make_unique<PrivateFolder>("view");
    if (!folder_->trouble().isEmpty()) return fail(std::exchange(folder_, nullptr)->trouble());
    active_ = true;
    tries_ = 0;
    quality_ = quality;
    emit progressed();
    exportScene();
}

// Answers that come after cancel() are another run's.
void PreviewProcess::exportScene() {
    const auto wanted = [this, run = run_] { return active_ && run == run_; };
    session_.send(command::exportScene(file(QStringLiteral("scn")).toStdString()), this,
                  [this, wanted](const Answer& answer) {
                      if (wanted() && !answer.done) fail(answer.text);
                  });
    session_.send(command::exportCamera(file(QStringLiteral("cam")).toStdString()), this,
                  [this, wanted](const Answer& answer) {
                      if (!wanted()) return;
                      answer.done ? launch() : fail(answer.text);
                  });
}

void PreviewProcess::launch() {
    const QString program = programPath(QStringLiteral("Renderer"));
    if (program.isEmpty())
        return fail(tr("The program Renderer was found neither beside this one nor in PATH."));
    process_ = new QProcess(this);
    process_->setStandardOutputFile(QProcess::nullDevice());
    startInBackground(*process_);
    connect(process_, &QProcess::finished, this, [this](int exitCode, QProcess::ExitStatus status) {
        finish(exitCode, status == QProcess::CrashExit);
    });
    connect(process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) fail(process_->errorString());
    });
    QStringList words{file(QStringLiteral("scn")),
                      QStringLiteral("--camera=") + file(QStringLiteral("cam")),
                      QStringLiteral("--preview=") + instance_,
                      QStringLiteral("--run-id=%1").arg(run_),
                      QStringLiteral("--linger=%1").arg(kLingerSeconds),
                      QStringLiteral("--parent=%1").arg(QCoreApplication::applicationPid()),
                      QStringLiteral("--progress=none")};
    words += rendererOptions(quality_);
    const QString model = models_.find(file(QStringLiteral("scn")));
    if (!model.isEmpty()) words.append(QStringLiteral("--model=") + model);
    process_->start(program, words);
    reader_.emplace(instance_, run_);
    timer_.start(kPreviewPace);
}

void PreviewProcess::look() {
    const std::optional<PreviewPicture> picture = reader_->read(session_.frame());
    if (!reader_->trouble().isEmpty()) return fail(reader_->trouble());
    if (progress_ != reader_->progress()) {
        progress_ = reader_->progress();
        emit progressed();
    }
    if (!picture || !active_) return;
    if (picture->last) release();
    emit refined(picture->image, picture->last, {quality_.byPaths, picture->samples});
}

// Its last image can be read even now, by viewers that were attached before.
void PreviewProcess::finish(int exitCode, bool crashed) {
    if (!crashed && exitCode == 0) look();
    if (!active_) return;
    const bool later = !crashed && exitCode == static_cast<int>(app::ExitCode::TryAgain);
    if (later && ++tries_ < kMaxTries) return tryAgain();
    const QString words = translatedOutput(QString::fromUtf8(process_->readAllStandardError())).trimmed();
    fail(words.isEmpty() ? tr("The Renderer failed.") : words);
}

void PreviewProcess::tryAgain() {
    timer_.stop();
    reader_.reset();
    std::exchange(process_, nullptr)->deleteLater();
    launch();
}

void PreviewProcess::fail(const QString& text) {
    release();
    emit failed(text);
}

void PreviewProcess::cancel() {
    if (active_) release();
}

void PreviewProcess::release() {
    timer_.stop();
    reader_.reset();
    if (process_ != nullptr) {
        QProcess* const process = std::exchange(process_, nullptr);
        process->disconnect(this);
        // Its event reaps it; the destructor would wait for it.
        connect(process, &QProcess::finished, process, &QObject::deleteLater);
        process->state() == QProcess::NotRunning ? process->deleteLater() : end(*process);
    }
    if (folder_ != nullptr) {
        QFile::remove(file(QStringLiteral("scn")));
        QFile::remove(file(QStringLiteral("cam")));
    }
    ++run_;
    active_ = false;
    progress_ = 0;
    emit progressed();
}

} // namespace gui
