/// Which edit of the server a session takes back: its own last one, by the number that the server gave it.
/// Pure.
#pragma once

#include "bridge/control/roles.h"

#include "common/commands/state_report.h"

namespace bridge {

/// The server says for whom it made an edit, and takes back or makes again the one of a number or none. So
/// nothing is counted here; but until it has told its state after a step, no other one is taken. One thread.
class OwnEdits {
  public:
    /// A step goes to the server: an edit, undo or redo.
    void sent() { ++underWay_; }
    void answered() {
        --underWay_;
        unread_ = true;
    }
    /// The state that the server told last: what undo takes back, and what redo makes again.
    void read(const app::ReportedEdit& undo, const app::ReportedEdit& redo) {
        undo_ = undo;
        redo_ = redo;
        if (underWay_ == 0) unread_ = false;
    }
    bool busy() const { return underWay_ > 0 || unread_; }

    bool mayUndo(SessionId by) const { return isOf(undo_, by); }
    bool mayRedo(SessionId by) const { return isOf(redo_, by); }
    int undo() const { return undo_.number; }
    int redo() const { return redo_.number; }

    /// The server is gone; answers to steps that were sent to it still come.
    void clear() {
        undo_ = redo_ = {};
        unread_ = false;
    }

  private:
    bool isOf(const app::ReportedEdit& edit, SessionId by) const {
        return !busy() && edit.person != 0 && edit.person == static_cast<int>(by);
    }

    app::ReportedEdit undo_, redo_;
    int underWay_ = 0;
    bool unread_ = false;
};

} // namespace bridge
