#include "gui/operations/job_operations.h"

#include "gui/dialogs/build_dialog.h"
#include "gui/dialogs/jobs_panel.h"
#include "gui/dialogs/picture_dialog.h"
#include "gui/dialogs/render_dialog.h"
#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"
#include "gui/view/plain_widgets.h"

#include "common/process/stop.h"

#include <QAction>
#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QPushButton>
#include <QUrl>

namespace gui {

JobOperations::JobOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new JobsPanel(queue_)) {
    makeDock();
    context_.actions.on(ActionId::Render, [this] { openRenderDialog({}); });
    context_.actions.on(ActionId::BuildTree, [this] { openBuildDialog(); });
    connect(&queue_, &QAbstractItemModel::rowsInserted, this, [this] {
        dock_->show();
        dock_->raise();
    });
    connect(&queue_, &JobQueue::finished, this, &JobOperations::onFinished);
    connect(panel_, &JobsPanel::showWanted, this, &JobOperations::showResult);
}

void JobOperations::makeDock() {
    auto* window = qobject_cast<QMainWindow*>(&context_.window);
    dock_ = new QDockWidget(tr("Jobs"), &context_.window);
    dock_->setObjectName(QStringLiteral("jobs"));
    dock_->setWidget(panel_);
    dock_->hide();
    if (window != nullptr) window->addDockWidget(Qt::BottomDockWidgetArea, dock_);
    QAction* action = context_.actions[ActionId::Jobs];
    context_.actions.onToggle(ActionId::Jobs, [this](bool on) {
        dock_->setVisible(on);
        if (on) panel_->setFocus(Qt::ShortcutFocusReason);
    });
    leadBack(*dock_, context_.view);
    connect(dock_, &QDockWidget::visibilityChanged, action,
            [this, action] { action->setChecked(!dock_->isHidden()); });
}

void JobOperations::renderList(const QString& list) { openRenderDialog(list); }

void JobOperations::renderFlight(const QString& flight) { openRenderDialog({}, flight); }

void JobOperations::openRenderDialog(const QString& list, const QString& flight) {
    RenderContext context;
    context.live = context_.session.live() && !context_.session.status().resolution.isEmpty();
    context.size = context_.session.status().resolution;
    // The server shows more than its file holds: lights, settings.
    context.scene = context.live ? QString() : context_.preferences.recentFiles().value(0);
    context.list = list;
    for (const ShownFlight& each : context_.editor.state().flights) context.flights.append(each.name);
    context.flight = flight;
    context.output = freeOutput();
    context.antialiasing = context_.preferences.get(pref::stillAntialiasing);
    auto* dialog = new RenderDialog(context, &context_.window);
    connect(dialog, &RenderDialog::wanted, this, &JobOperations::prepare);
    dialog->open();
}

// Neither a file nor the result of a job that has not written it yet.
QString JobOperations::freeOutput() const {
    const QDir folder(context_.preferences.picturesFolder());
    for (int number = 1;; ++number) {
        const QString path =
            folder.filePath(QStringLiteral("render-%1.png").arg(number, 4, 10, QLatin1Char('0')));
        if (!QFileInfo::exists(path) && !queue_.makes(path)) return path;
    }
}

void JobOperations::openBuildDialog() {
    const QString scene = context_.keeper.scene();
    const QString suffix = QFileInfo(scene).suffix().toLower();
    const bool model = suffix != QLatin1String("scn") && suffix != QLatin1String("bsp");
    auto* dialog = new BuildDialog(model ? scene : QString(), &context_.window);
    connect(dialog, &BuildDialog::wanted, this, &JobOperations::enqueue);
    dialog->open();
}

void JobOperations::prepare(const RenderWish& wish) {
    if (wish.sceneFile.isEmpty()) return enqueue(wish.job);
    context_.session.send(command::exportScene(wish.sceneFile.toStdString()), this,
                          [this, wish](const Answer& answer) {
                              if (!answer.done) return context_.notice.explain(answer.text, {});
                              if (wish.cameraFile.isEmpty()) enqueue(wish.job);
                          });
    // Sent at once, so that the camera is that of the same moment.
    if (!wish.cameraFile.isEmpty()) prepareCamera(wish);
}

void JobOperations::prepareCamera(const RenderWish& wish) {
    context_.session.send(command::exportCamera(wish.cameraFile.toStdString()), this,
                          [this, wish](const Answer& answer) {
                              if (!answer.done) return context_.notice.explain(answer.text, {});
                              if (QFileInfo::exists(wish.sceneFile)) enqueue(wish.job);
                          });
}

void JobOperations::enqueue(const JobRequest& request) { panel_->choose(queue_.add(request)); }

void JobOperations::onFinished(quint64 id) {
    const Job& job = queue_.job(queue_.rowOf(id));
    if (job.state == JobState::Done) {
        context_.view.tell(tr("%1: done.").arg(job.request.title));
    } else if (job.state == JobState::Failed) {
        context_.view.tell(tr("%1 failed: %2").arg(job.request.title, job.message));
    }
}

void JobOperations::showResult(const QString& file) {
    if (file.endsWith(QLatin1String(".bsp"), Qt::CaseInsensitive)) return emit openWanted(file);
    auto* dialog = new PictureDialog(file, &context_.window);
    if (dialog->readable()) return dialog->show();
    delete dialog;
    // Films, and kinds of images that Qt does not know.
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(file)))
        context_.notice.explain(tr("There is no program that shows %1.").arg(file), {});
}

bool JobOperations::mayClose() {
    if (closing_ || !queue_.busy() || app::stopRequested()) return true;
    if (question_ != nullptr) {
        question_->raise();
        return false;
    }
    question_ =
        plainBox(QMessageBox::Question, tr("Jobs are not finished"),
                 tr("Unfinished jobs: %n. Stop and close?", nullptr, queue_.unfinished()), &context_.window);
    QPushButton* stop = question_->addButton(tr("&Stop and close"), QMessageBox::AcceptRole);
    question_->setDefaultButton(question_->addButton(tr("&Keep running"), QMessageBox::RejectRole));
    connect(stop, &QPushButton::clicked, this, [this] {
        closing_ = true;
        queue_.cancelAll();
        context_.window.close();
    });
    question_->open();
    return false;
}

} // namespace gui
