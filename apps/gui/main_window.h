/// Puts the parts together: no logic of its own.
#pragma once

#include "gui/models/preferences.h"
#include "gui/operations/scene_editor.h"
#include "gui/processes/server_keeper.h"
#include "gui/session/session.h"

#include <QMainWindow>
#include <QStringList>

namespace gui {

class Actions;
class ConnectionOperations;
class FrameView;
class FullScreen;
class JobOperations;
class NoticeBar;
class SaveOperations;
class SurroundingsOperations;

class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    /// `instance`: the name for the servers of this window; empty: as the preferences say.
    explicit MainWindow(const QString& instance = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// As if the file were dropped on the window.
    void open(const QString& path);
    /// Options of the server that the next open() starts, as RTServer takes them.
    void startWith(const QStringList& options);
    void connectToServer();

    Session& session() { return session_; }
    ServerKeeper& keeper() { return keeper_; }
    FrameView& view() { return *view_; }
    Actions& actions() { return *actions_; }
    NoticeBar& notice() { return *notice_; }
    JobOperations& jobs() { return *jobs_; }
    Preferences& preferences() { return preferences_; }
    SceneEditor& editor() { return editor_; }

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void layOut();
    void restoreGeometryAndState();
    void showTitle();

    Preferences preferences_;
    Session session_;
    ServerKeeper keeper_{session_};
    SceneEditor editor_{session_};
    FrameView* view_;
    FullScreen* fullScreen_;
    NoticeBar* notice_;
    Actions* actions_;
    ConnectionOperations* connection_;
    JobOperations* jobs_;
    SaveOperations* save_;
    SurroundingsOperations* surroundings_;
};

} // namespace gui
