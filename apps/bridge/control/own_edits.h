/// Which of the server's edits were made here, and by whom: each session takes only its own back. Pure.
#pragma once

#include "bridge/control/roles.h"

#include <string>
#include <utility>
#include <vector>

namespace bridge {

/// The server counts its edits; one that was made here is known by its count and by what undo says of it,
/// once the server has told its state after it. Until then nothing may be taken back: the last edit might be
/// another client's. One thread.
class OwnEdits {
  public:
    enum class Step { Edit, Undo, Redo };

    /// A step goes to the server, whose last state told of so many edits.
    void sent(int edits) {
        if (!busy()) {
            before_ = edits;
            made_ = 0;
        }
        ++underWay_;
    }
    /// The answer to one that was sent().
    void answered(SessionId by, Step step, bool done) {
        --underWay_;
        if (!done) return;
        unread_ = true;
        if (step == Step::Edit) {
            made_ = (editor_ == by ? made_ : 0) + 1;
            editor_ = by;
        } else {
            before_ += step == Step::Undo ? -1 : 1;
            step == Step::Undo ? moveLast(done_, undone_) : moveLast(undone_, done_);
        }
    }
    /// A state that the server told after all that is answered: its count, and what undo says.
    void read(int edits, const std::string& label) {
        if (underWay_ > 0 || !unread_) return;
        unread_ = false;
        // One that changed nothing is none of the server's; beyond ours there are another's.
        if (edits > before_ && edits <= before_ + made_) made(editor_, edits, label);
    }
    /// Steps are under way, or the state after them was not read yet.
    bool busy() const { return underWay_ > 0 || unread_; }

    bool mayUndo(SessionId by, int edits, const std::string& label) const {
        return !busy() && !done_.empty() && done_.back() == Edit{by, edits, label};
    }
    bool mayRedo(SessionId by, int edits, const std::string& label) const {
        return !busy() && !undone_.empty() && undone_.back() == Edit{by, edits + 1, label};
    }
    /// Whether an edit may be joined to the last one, which that session made or is making.
    bool mayGoOn(SessionId by, int edits, const std::string& label) const {
        return busy() ? made_ == 0 || editor_ == by : mayUndo(by, edits, label);
    }
    /// Of a server that is gone; answers to what was sent to it still come.
    void clear() {
        done_.clear();
        undone_.clear();
        unread_ = false;
        made_ = 0;
    }

  private:
    struct Edit {
        SessionId by;
        int count;
        std::string label;
        friend bool operator==(const Edit&, const Edit&) = default;
    };
    void made(SessionId by, int edits, const std::string& label) {
        std::erase_if(done_, [&](const Edit& each) { return each.count >= edits; });
        undone_.clear();
        done_.push_back({by, edits, label});
    }
    static void moveLast(std::vector<Edit>& from, std::vector<Edit>& to) {
        if (from.empty()) return;
        to.push_back(std::move(from.back()));
        from.pop_back();
    }

    std::vector<Edit> done_, undone_;
    int underWay_ = 0;
    bool unread_ = false;
    int before_ = 0, made_ = 0; ///< edits of the server before those of `editor_`; how many those are
    SessionId editor_ = 0;
};

} // namespace bridge
