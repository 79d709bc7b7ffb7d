/// The Renderer and BSPBuilder, run from the window: their dialogs, the queue and its dock.
#pragma once

#include "gui/operations/gui_context.h"
#include "gui/processes/job_queue.h"

#include <QObject>
#include <QPointer>

class QDockWidget;
class QMessageBox;

namespace gui {

class JobsPanel;
struct RenderWish;

class JobOperations : public QObject {
    Q_OBJECT

  public:
    JobOperations(const GuiContext& context, QObject* parent);

    JobQueue& queue() { return queue_; }
    /// The dialog, with this recorded list.
    void renderList(const QString& list);
    /// The same with this flight of the scene.
    void renderFlight(const QString& flight);
    /// Whether the window may close now. If not, the user is asked, and the window is closed when they agree.
    bool mayClose();
    /// The server writes what the job needs; then it is queued.
    void prepare(const RenderWish& wish);

  signals:
    /// A scene that a job has made is to be shown.
    void openWanted(const QString& path);

  private:
    void makeDock();
    void openRenderDialog(const QString& list, const QString& flight = {});
    void openBuildDialog();
    QString freeOutput() const;
    void prepareCamera(const RenderWish& wish);
    void enqueue(const JobRequest& request);
    void onFinished(quint64 id);
    void showResult(const QString& file);

    GuiContext context_;
    JobQueue queue_;
    QDockWidget* dock_ = nullptr;
    JobsPanel* panel_;
    QPointer<QMessageBox> question_;
    bool closing_ = false; ///< the user has agreed
};

} // namespace gui
