/// A part of an OBJ file that one thread reads by itself.
#pragma once

#include "rtcore/io/import/obj/obj_model.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/scene/local_origin.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rtcore {

/// Statements that add to lists are read; those that need what stands before them - groups, materials,
/// indices that count from the end, all that is not understood - wait until that is known.
class ObjBlock {
  public:
    /// `text` is of whole statements, and must live until they are taken. `texcoordsBefore`: whether some
    /// stand before it.
    void read(std::string_view text, const LocalOrigin& origin, bool texcoordsBefore);

    /// Adds all of the block to `lists`, in its order; `readWaiting` reads the statement at which it stands,
    /// `added` is called when faces were added.
    template <typename Read, typename Added>
    void moveTo(ObjLists& lists, const Read& readWaiting, const Added& added) {
        Ends taken;
        const auto take = [&](const Ends& end) {
            append(lists, taken, end);
            if (end.faces > taken.faces) added();
            taken = end;
        };
        for (const Waiting& waiting : waiting_) {
            take(waiting.before);
            readWaiting(waiting.statement);
        }
        take(ends());
    }
    std::uint64_t lines() const { return lines_; }

  private:
    /// How many elements lists have.
    struct Ends {
        std::size_t positions = 0, normals = 0, texcoords = 0, corners = 0, faces = 0;
    };
    struct Waiting {
        StatementText statement;
        Ends before; ///< what was read before it
    };
    Ends ends() const;
    void append(ObjLists& to, const Ends& begin, const Ends& end) const;

    ObjLists lists_;
    std::vector<Waiting> waiting_;
    std::uint64_t lines_ = 0;
};

/// Parts of about so many bytes that begin and end as statements do.
std::vector<std::string_view> partsOfStatements(std::string_view text, std::size_t bytes);

} // namespace rtcore
