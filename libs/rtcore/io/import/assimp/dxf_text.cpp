#include "rtcore/io/import/assimp/dxf_text.h"

#include "rtcore/io/import/text/statement_text.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <vector>

namespace rtcore {

namespace {

using View = std::string_view;

/// Without blanks at both ends; cut off `text`.
View takeLine(View& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    View line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

/// 0 where there is none.
int integerOf(View text) {
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

/// Finds the signs of corners in records of faces.
class FaceRecords {
  public:
    void add(int code, View value) {
        if (code == 0) {
            end();
            isVertex_ = value == "VERTEX";
        } else if (isVertex_ && code == 70) {
            flags_ = integerOf(value);
        } else if (isVertex_ && code >= 71 && code <= 74 && value.starts_with('-')) {
            ofRecord_.push_back(value.data());
        }
    }
    void end() {
        constexpr int kFace = 128, kPosition = 64;
        if ((flags_ & kFace) != 0 && (flags_ & kPosition) == 0)
            signs_.insert(signs_.end(), ofRecord_.begin(), ofRecord_.end());
        ofRecord_.clear();
        flags_ = 0;
    }
    const std::vector<const char*>& signs() const { return signs_; }

  private:
    std::vector<const char*> signs_, ofRecord_;
    int flags_ = 0;
    bool isVertex_ = false;
};

} // namespace

std::optional<std::string> dxfForAssimp(const std::filesystem::path& path) {
    if (inSmallLetters(path.extension().string()) != ".dxf") return std::nullopt;
    const FileBytes file = openFileBytes(path);
    const View text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    FaceRecords faces;
    for (View rest = text; !rest.empty();) {
        const int code = integerOf(takeLine(rest));
        faces.add(code, takeLine(rest));
    }
    faces.end();
    if (faces.signs().empty()) return std::nullopt;
    std::string unsignedText;
    const char* from = text.data();
    for (const char* const sign : faces.signs()) {
        unsignedText.append(from, sign);
        from = sign + 1;
    }
    return unsignedText.append(from, text.data() + text.size());
}

} // namespace rtcore
