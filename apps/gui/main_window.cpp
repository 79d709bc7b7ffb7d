#include "gui/main_window.h"

#include "gui/models/installed_skies.h"
#include "gui/models/plain_text.h"
#include "gui/operations/actions.h"
#include "gui/operations/bar_operations.h"
#include "gui/operations/bookmark_operations.h"
#include "gui/operations/camera_operations.h"
#include "gui/operations/comparison_operations.h"
#include "gui/operations/connection_operations.h"
#include "gui/operations/corner_plan_operations.h"
#include "gui/operations/display_operations.h"
#include "gui/operations/flight_operations.h"
#include "gui/operations/job_operations.h"
#include "gui/operations/light_meter_operations.h"
#include "gui/operations/light_operations.h"
#include "gui/operations/look_operations.h"
#include "gui/operations/measure_operations.h"
#include "gui/operations/message_operations.h"
#include "gui/operations/mode_operations.h"
#include "gui/operations/model_operations.h"
#include "gui/operations/motion_operations.h"
#include "gui/operations/note_operations.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/plan_operations.h"
#include "gui/operations/recording_operations.h"
#include "gui/operations/render_operations.h"
#include "gui/operations/save_operations.h"
#include "gui/operations/section_operations.h"
#include "gui/operations/share_operations.h"
#include "gui/operations/surroundings_operations.h"
#include "gui/operations/up_and_unit_operations.h"
#include "gui/operations/variant_operations.h"
#include "gui/view/button_keys.h"
#include "gui/view/frame_view.h"
#include "gui/view/full_screen.h"
#include "gui/view/notice_bar.h"
#include "gui/view/plain_widgets.h"
#include "gui/view/screen_fit.h"

#include <QAction>
#include <QCloseEvent>
#include <QFileInfo>
#include <QIcon>
#include <QMenuBar>
#include <QMimeData>
#include <QVBoxLayout>

// A static library's resources are not there by themselves.
static void loadResources() { Q_INIT_RESOURCE(gui); }

namespace gui {

MainWindow::MainWindow(const QString& instance, QWidget* parent)
    : QMainWindow(parent), view_(new FrameView(session_)), fullScreen_(new FullScreen(*this)),
      notice_(new NoticeBar), actions_(new Actions(*this, preferences_)) {
    loadResources();
    new PlainLabels(this);
    new ButtonKeys(this);
    new ScreenFit(this);
    setWindowIcon(QIcon(QStringLiteral(":/gui.png")));
    layOut();
    const GuiContext context{*this,  session_,     keeper_,  preferences_, *actions_,
                             *view_, *fullScreen_, *notice_, editor_};
    connection_ = new ConnectionOperations(context, this);
    connection_->setInstance(instance);
    new ShareOperations(context, this);
    auto* camera = new CameraOperations(context, this);
    new DisplayOperations(context, this);
    new MotionOperations(context, this);
    new ModeOperations(context, this);
    new MessageOperations(context, this);
    new RenderOperations(context, this);
    new ComparisonOperations(context, this);
    new LookOperations(context, this);
    new UpAndUnitOperations(context, this);
    new PanelOperations(context, this);
    new LightOperations(context, this);
    new LightMeterOperations(context, this);
    surroundings_ = new SurroundingsOperations(context, this);
    new ModelOperations(context, this);
    new SectionOperations(context, this);
    new MeasureOperations(context, this);
    new NoteOperations(context, this);
    new VariantOperations(context, this);
    auto* flights = new FlightOperations(context, this);
    new RecordingOperations(context, this);
    auto* plans = new PlanOperations(context, this);
    new CornerPlanOperations(context, this);
    auto* bookmarks = new BookmarkOperations(context, this);
    save_ = new SaveOperations(context, this);
    connection_->askBeforeLeaving([this](const auto& go) { save_->beforeLeaving(go); });
    connect(save_, &SaveOperations::aboutToSave, bookmarks, &BookmarkOperations::giveToScene);
    connect(save_, &SaveOperations::savedAs, bookmarks, &BookmarkOperations::follow);
    jobs_ = new JobOperations(context, this);
    connect(jobs_, &JobOperations::openWanted, this, &MainWindow::open);
    connect(camera, &CameraOperations::filmWanted, jobs_, &JobOperations::renderList);
    connect(flights, &FlightOperations::filmWanted, jobs_, &JobOperations::renderFlight);
    connect(plans, &PlanOperations::lightWanted, jobs_, &JobOperations::prepare);
    connect(&session_, &Session::stateChanged, this, &MainWindow::showTitle);
    connect(&keeper_, &ServerKeeper::started, this, &MainWindow::showTitle);
    connect(&editor_, &SceneEditor::sceneChanged, this, &MainWindow::showTitle);
    new BarOperations(context, this);
    showTitle();
    restoreGeometryAndState();
    view_->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::layOut() {
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(notice_);
    column->addWidget(view_, 1);
    setCentralWidget(centre);
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowTabbedDocks);
    actions_->fill(*menuBar());
}

void MainWindow::restoreGeometryAndState() {
    resize(view_->sizeHint());
    restoreGeometry(preferences_.get(pref::geometry));
    restoreState(preferences_.get(pref::windowState));
    fitIntoScreen(*this); // a first one on a scaled screen, and one whose preferences are damaged
}

void MainWindow::showTitle() {
    const QString shown = session_.live() && !editor_.scene().isEmpty() ? editor_.scene() : keeper_.scene();
    const QString scene = QFileInfo(shown).fileName();
    const QString what = scene.isEmpty() && session_.live() ? session_.instance() : scene;
    if (what.isEmpty()) return setWindowTitle(tr("rtsuite"));
    setWindowTitle(plainTitle(what) + QStringLiteral("[*] – ") + tr("rtsuite"));
}

void MainWindow::open(const QString& path) { connection_->open(path); }
void MainWindow::startWith(const QStringList& options) { connection_->startWith(options); }

void MainWindow::connectToServer() { keeper_.connectTo(connection_->instanceName()); }

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!save_->mayClose() || !jobs_->mayClose()) return event->ignore();
    fullScreen_->set(false); // the next one begins with its menus and panels
    preferences_.set(pref::geometry, saveGeometry());
    preferences_.set(pref::windowState, saveState());
    keeper_.close();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() != 1) return;
    const QString path = urls.first().toLocalFile();
    isEnvironmentFile(path) ? surroundings_->open(path) : open(path);
}

} // namespace gui
