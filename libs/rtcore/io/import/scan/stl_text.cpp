#include "rtcore/io/import/scan/stl_text.h"

#include "rtcore/io/import/mesh/polygon.h"
#include "rtcore/io/import/text/statement_pieces.h"
#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/io/import/text/statement_warning.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

bool isKeyword(std::string_view word, std::string_view keyword) {
    return word.size() == keyword.size() && (word == keyword || inSmallLetters(word) == keyword);
}

class StlTextReader {
  public:
    explicit StlTextReader(const LocalOrigin& origin) : origin_(origin) {}

    void read(std::string_view text) {
        StatementText in(text);
        while (!in.atEnd()) {
            while (in.hasWord()) readWord(in);
            in.endStatement();
        }
        lines_ += in.lines();
    }
    std::vector<ScanPart> finish(const std::filesystem::path& path, ImportReport& report) {
        endFacet();
        odd_.warn(path, report);
        return std::move(solids_);
    }

  private:
    void readWord(StatementText& in) {
        const std::uint64_t line = lines_ + in.lines() + 1;
        const std::string_view word = in.word();
        if (isKeyword(word, "vertex")) {
            readVertex(line, in);
        } else if (isKeyword(word, "facet")) {
            endFacet();
            line_ = line;
        } else if (isKeyword(word, "normal")) {
            for (int i = 0; i < 3 && in.hasWord(); ++i) in.word();
        } else if (isKeyword(word, "endfacet") || isKeyword(word, "endsolid")) {
            endFacet();
            if (isKeyword(word, "endsolid")) in.rest();
        } else if (isKeyword(word, "solid")) {
            endFacet();
            solids_.push_back({std::string(in.word()), {}});
            in.rest();
        }
    }

    void readVertex(std::uint64_t line, StatementText& in) {
        const auto& zero = origin_.at;
        const auto x = in.coordinate(zero[0]), y = in.coordinate(zero[1]), z = in.coordinate(zero[2]);
        if (x && y && z) {
            corners_.push_back({*x, *y, *z});
        } else {
            odd_.add(line, "vertex");
            broken_ = true;
        }
    }

    void endFacet() {
        if (!corners_.empty() && !broken_) addFacet();
        corners_.clear();
        broken_ = false;
    }

    void addFacet() {
        if (corners_.size() < 3) {
            odd_.add(line_, "facet");
            return;
        }
        if (solids_.empty()) solids_.emplace_back();
        ScanMesh& mesh = solids_.back().mesh;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), corners_.begin(), corners_.end());
        for (const Triangle& t : cutter_.cut(corners_))
            mesh.triangles.push_back({{first + t.v[0], first + t.v[1], first + t.v[2]}});
    }

    LocalOrigin origin_;
    std::vector<ScanPart> solids_;
    std::vector<Vec3> corners_; ///< of the facet at hand
    PolygonCutter cutter_;
    bool broken_ = false;     ///< one of them is no position
    std::uint64_t line_ = 0;  ///< of the facet
    std::uint64_t lines_ = 0; ///< of the pieces before
    OddStatements odd_;
};

bool beginsAsText(InputFile& file) {
    constexpr std::size_t kLongestBeginning = 1024;
    const auto head = file.head(kLongestBeginning);
    std::string_view text(reinterpret_cast<const char*>(head.data()), head.size());
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const std::string word = inSmallLetters(text.substr(0, 5));
    return text.find('\0') == std::string_view::npos && (word == "solid" || word == "facet");
}

} // namespace

std::optional<std::vector<ScanPart>> readTextStl(const std::filesystem::path& path, const LocalOrigin& origin,
                                                 ImportReport& report, const std::function<void()>& alive) {
    InputFile file(path);
    if (!beginsAsText(file)) return std::nullopt;
    StlTextReader reader(origin);
    forEachStatements(file, alive, [&](std::string_view text, std::uint64_t) { reader.read(text); });
    return reader.finish(path, report);
}

} // namespace rtcore
