/// The objects that the operations work on. An operation is made once, with the window; its constructor
/// connects it to its actions and signals.
#pragma once

class QWidget;

namespace gui {

class Actions;
class FrameView;
class FullScreen;
class NoticeBar;
class Preferences;
class SceneEditor;
class ServerKeeper;
class Session;

/// All of it outlives the operations.
struct GuiContext {
    QWidget& window;
    Session& session;
    ServerKeeper& keeper;
    Preferences& preferences;
    Actions& actions;
    FrameView& view;
    FullScreen& fullScreen;
    NoticeBar& notice;
    SceneEditor& editor;
};

} // namespace gui
