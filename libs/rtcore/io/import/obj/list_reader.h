/// Statements of an OBJ file that add to its lists.
#pragma once

#include "rtcore/io/import/obj/obj_model.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/scene/local_origin.h"

#include <optional>
#include <string_view>
#include <vector>

namespace rtcore {

class ObjListReader {
  public:
    /// `origin` is taken off positions. `lists`, which must outlive the object, are those of all statements
    /// before, or begin `amidst` them: what counts from their ends is not understood then.
    ObjListReader(ObjLists& lists, const LocalOrigin& origin, bool amidst, bool texcoordsBefore = false)
        : lists_(lists), origin_(origin), amidst_(amidst), texcoordsBefore_(texcoordsBefore) {}

    static bool reads(std::string_view keyword) {
        return keyword == "v" || keyword == "vt" || keyword == "vn" || keyword == "f" ||
               keyword == "fo"; // of earlier versions
    }
    /// What follows such a keyword. False where it is not understood: then nothing is added.
    bool read(std::string_view keyword, StatementText& in);
    /// In place of what is not understood, so that others keep their numbers. Nothing for a face.
    void addDamaged(std::string_view keyword);

  private:
    struct Corner {
        std::uint32_t position = kNoIndex, texcoord = kNoIndex, normal = kNoIndex;
    };
    bool readPosition(StatementText& in);
    bool readTexcoord(StatementText& in);
    bool readNormal(StatementText& in);
    bool readFace(StatementText& in);
    std::optional<Corner> readCorner(StatementText& in) const;
    void addFace();
    Vec3 divided(Vec3 p, float weight) const;

    ObjLists& lists_;
    LocalOrigin origin_;
    bool amidst_, texcoordsBefore_;
    std::vector<Corner> face_; ///< the one that is read
};

} // namespace rtcore
