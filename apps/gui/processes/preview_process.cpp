#include "gui/processes/preview_process.h"

#include "gui/processes/detach.h"
#include "gui/processes/model_cache.h"
#include "gui/processes/private_folder.h"
#include "gui/processes/programs.h"
#include "gui/session/printed_lines.h"
#include "gui/session/server_list.h"

#include "common/process/exit_codes.h"
#include "common/process/resting_image.h"

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
constexpr int kMaxTries = 5;      ///< while the predecessor, on a busy machine, takes its time to die
constexpr auto kKept = 10min;     ///< so long a Renderer holds its model for the next image
constexpr auto kEndPatience = 1s; ///< with a Renderer that does not end when it is asked to

int nextNumber() {
    static int number = 0;
    return ++number;
}

// Does not wait for the end. Until it has become a Renderer, a process may lose the request to end.
void endSoon(QProcess& process) {
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
    patience_.setSingleShot(true);
    patience_.setInterval(kKept);
    connect(&patience_, &QTimer::timeout, this, &PreviewProcess::leave);
}

PreviewProcess::~PreviewProcess() {
    blockSignals(true);
    leave();
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

QString PreviewProcess::file(const QString& extension, quint64 run) const {
    return folder_->file(QStringLiteral("%1.%2").arg(run).arg(extension));
}

void PreviewProcess::render(const StillQuality& quality) {
    cancel();
    if (folder_ == nullptr) folder_ = std::make_unique<PrivateFolder>("view");
    if (!folder_->trouble().isEmpty()) return fail(std::exchange(folder_, nullptr)->trouble());
    active_ = true;
    patience_.stop();
    tries_ = 0;
    quality_ = quality;
    emit progressed();
    exportScene();
}

// Answers that come after cancel() are another run's.
void PreviewProcess::exportScene() {
    const auto wanted = [this, run = run_] { return active_ && run == run_; };
    const auto fileOf = [this](const char* extension) {
        return file(QLatin1String(extension), run_).toStdString();
    };
    session_.send(command::exportScene(fileOf("scn")), this, [this, wanted](const Answer& answer) {
        if (wanted() && !answer.done) fail(answer.text);
    });
    session_.send(command::exportCamera(fileOf("cam")), this, [this, wanted](const Answer& answer) {
        if (!wanted()) return;
        answer.done ? ask() : fail(answer.text);
    });
}

QStringList PreviewProcess::options() const {
    QStringList words;
    for (const std::string& each :
         app::standByOptions(instance_.toStdString(), QCoreApplication::applicationPid()))
        words.append(QString::fromStdString(each));
    return words + rendererOptions(quality_);
}

/// One that reads the scene's own model reads others as well, and has no use for what became of it since.
bool PreviewProcess::serves(const QStringList& options, const QString& model) const {
    return process_ != nullptr && process_->state() != QProcess::NotRunning && options == options_ &&
           (model_.isEmpty() || model == model_);
}

/// The Renderer that is there, where it was started with the options that are wanted now, or another.
void PreviewProcess::ask() {
    const QStringList wanted = options();
    const QString scene = file(QStringLiteral("scn"), run_), camera = file(QStringLiteral("cam"), run_);
    const QString model = models_.find(scene);
    if (serves(wanted, model)) {
        process_->write(app::standByRequest(run_, scene.toStdString(), camera.toStdString()).c_str());
    } else {
        end();
        launch(wanted, model);
    }
    if (process_ == nullptr) return; // it failed to start
    reader_.emplace(instance_, run_);
    timer_.start(kPreviewPace);
}

void PreviewProcess::launch(const QStringList& options, const QString& model) {
    const QString program = programPath(QStringLiteral("Renderer"));
    if (program.isEmpty())
        return fail(tr("The program Renderer was found neither beside this one nor in PATH."));
    process_ = new QProcess(this);
    options_ = options;
    model_ = model;
    process_->setStandardOutputFile(QProcess::nullDevice());
    startInBackground(*process_);
    connect(process_, &QProcess::finished, this, [this](int exitCode, QProcess::ExitStatus status) {
        finish(exitCode, status == QProcess::CrashExit);
    });
    connect(process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) fail(process_->errorString());
    });
    QStringList words{file(QStringLiteral("scn"), run_),
                      QStringLiteral("--camera=") + file(QStringLiteral("cam"), run_),
                      QStringLiteral("--run-id=%1").arg(run_)};
    if (!model.isEmpty()) words.append(QStringLiteral("--model=") + model);
    process_->start(program, words + options);
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
    const PictureOrigin origin{quality_.byPaths, picture->samples, picture->error, picture->largestError};
    emit refined(picture->image, picture->last, origin, picture->errors);
}

// Its last image can be read even now, by viewers that were attached before.
void PreviewProcess::finish(int exitCode, bool crashed) {
    if (!crashed && exitCode == 0) look();
    if (!active_) return end();
    const bool later = !crashed && exitCode == static_cast<int>(app::ExitCode::TryAgain);
    if (later && ++tries_ < kMaxTries) return tryAgain();
    const QString words = translatedOutput(QString::fromUtf8(process_->readAllStandardError())).trimmed();
    fail(words.isEmpty() ? tr("The Renderer failed.") : words);
}

void PreviewProcess::tryAgain() {
    timer_.stop();
    reader_.reset();
    end();
    ask();
}

void PreviewProcess::fail(const QString& text) {
    release();
    end();
    emit failed(text);
}

void PreviewProcess::cancel() {
    if (!active_) return;
    if (process_ != nullptr) process_->write(app::kNoRequest);
    release();
}

void PreviewProcess::leave() {
    cancel();
    end();
}

/// Its files stay until the next image but one: its Renderer may be about to read them.
void PreviewProcess::release() {
    timer_.stop();
    reader_.reset();
    if (folder_ != nullptr) {
        for (const char* extension : {"scn", "cam"}) QFile::remove(file(QLatin1String(extension), run_ - 1));
    }
    ++run_;
    active_ = false;
    progress_ = 0;
    patience_.start();
    emit progressed();
}

void PreviewProcess::end() {
    if (process_ == nullptr) return;
    QProcess* const process = std::exchange(process_, nullptr);
    process->disconnect(this);
    // Its event reaps it; the destructor would wait for it.
    connect(process, &QProcess::finished, process, &QObject::deleteLater);
    process->state() == QProcess::NotRunning ? process->deleteLater() : endSoon(*process);
}

} // namespace gui
