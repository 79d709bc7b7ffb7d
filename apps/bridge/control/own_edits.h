/// Which of the server's edits were made here, and by whom: each session takes only its own back. Pure.
#pragma once

#include "bridge/control/roles.h"

#include <string>
#include <vector>

namespace bridge {

/// The server counts its edits; one that was made here is known by its count and by what undo says of it.
class OwnEdits {
  public:
    /// The state that the server told after an edit of that session; `edits`: made and not taken back.
    void made(SessionId by, int edits, const std::string& label) {
        std::erase_if(done_, [&](const Edit& each) { return each.count >= edits; });
        undone_.clear();
        if (edits > 0) done_.push_back({by, edits, label});
    }
    bool mayUndo(SessionId by, int edits, const std::string& label) const {
        return !done_.empty() && done_.back() == Edit{by, edits, label};
    }
    bool mayRedo(SessionId by, int edits, const std::string& label) const {
        return !undone_.empty() && undone_.back() == Edit{by, edits + 1, label};
    }
    void undone() {
        undone_.push_back(done_.back());
        done_.pop_back();
    }
    void redone() {
        done_.push_back(undone_.back());
        undone_.pop_back();
    }
    void clear() {
        done_.clear();
        undone_.clear();
    }

  private:
    struct Edit {
        SessionId by;
        int count;
        std::string label;
        friend bool operator==(const Edit&, const Edit&) = default;
    };
    std::vector<Edit> done_, undone_;
};

} // namespace bridge
