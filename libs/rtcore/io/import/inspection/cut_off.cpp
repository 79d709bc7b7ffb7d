#include "rtcore/io/import/inspection/cut_off.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace rtcore {

namespace {

using View = std::string_view;
using namespace std::string_view_literals;

std::string lower(View text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// A file as the formats below look at it.
class Ends {
  public:
    explicit Ends(const std::filesystem::path& path)
        : file_(path), ending(lower(path.extension().string())), size(file_.size()), head(text(0, 1024)),
          tail(text(size - std::min(size, kTail), kTail)) {}

    /// 0 for numbers behind the end.
    std::uint64_t number(std::uint64_t at, std::size_t bytes, bool bigEndian = false) const {
        std::array<std::byte, 8> room{};
        const std::span<std::byte> read = std::span(room).first(bytes);
        if (file_.readAt(at, read) < bytes) return 0;
        if (!bigEndian) std::ranges::reverse(read);
        std::uint64_t value = 0;
        for (const std::byte b : read) value = value << 8U | std::to_integer<std::uint64_t>(b);
        return value;
    }

  private:
    /// A zip archive may end in a comment of 65,535 bytes.
    static constexpr std::uint64_t kTail = 65557;

    std::string text(std::uint64_t at, std::size_t max) const {
        std::string room(max, '\0');
        room.resize(file_.readAt(at, std::as_writable_bytes(std::span(room))));
        return room;
    }

    InputFile file_;

  public:
    const std::string ending; ///< with its dot, in small letters
    const std::uint64_t size;
    const std::string head, tail;
};

// The length that a format's head states, in bytes of the whole file; 0 where it is not that format.

/// A head of 12 bytes, then chunks, each behind its length and kind: JSON, binary, and what is passed over.
std::uint64_t lengthOfGlb(const Ends& file) {
    constexpr std::uint64_t kFirst = 12, kChunkHead = 8;
    if (!file.head.starts_with("glTF") || (file.size >= 8 && file.number(4, 4) != 2)) return 0;
    const std::uint64_t stated = file.number(8, 4);
    if (file.size < kFirst + kChunkHead) return std::max(stated, kFirst + kChunkHead);
    std::uint64_t at = kFirst;
    int chunks = 0;
    for (; chunks < 2 && at < stated && at + kChunkHead <= file.size; ++chunks)
        at += kChunkHead + file.number(at, 4);
    if (at > file.size) return stated == file.size ? 0 : std::max(at, stated);
    return chunks < 2 ? stated : 0; // a wrong sum of right lengths harms nothing
}

bool isTextStl(const Ends& file) {
    return file.ending == ".stl" && file.head.starts_with("solid") && file.head.find('\0') == View::npos;
}

std::uint64_t lengthOfStl(const Ends& file) {
    constexpr std::uint64_t kBegin = 84, kEach = 50;
    if (file.ending != ".stl" || isTextStl(file)) return 0;
    return file.size < kBegin ? kBegin : kBegin + kEach * file.number(80, 4);
}

std::uint64_t lengthOf3ds(const Ends& file) {
    return file.head.starts_with("MM") && file.ending == ".3ds" ? file.number(2, 4) : 0;
}

std::uint64_t lengthOfLwo(const Ends& file) {
    return file.head.starts_with("FORM") ? 8 + file.number(4, 4, true) : 0;
}

std::uint64_t lengthOfB3d(const Ends& file) {
    return file.head.starts_with("BB3D") ? 8 + file.number(4, 4) : 0;
}

/// Nodes behind each other, each of which begins with where it ends; the last one is empty.
std::uint64_t lengthOfFbx(const Ends& file) {
    constexpr std::uint64_t kFirst = 27, kWideSince = 7500;
    if (!file.head.starts_with("Kaydara FBX Binary  \0"sv)) return 0;
    const std::size_t wide = file.number(23, 4) >= kWideSince ? 8 : 4;
    const std::uint64_t emptyNode = 3 * wide + 1;
    constexpr int kMaxNodes = 1000; // programs write a dozen
    std::uint64_t at = kFirst;
    for (int nodes = 0; nodes < kMaxNodes; ++nodes) {
        if (at + emptyNode > file.size) return at + emptyNode;
        const std::uint64_t end = file.number(at, wide);
        if (end <= at) return 0;
        at = end;
    }
    return 0;
}

constexpr std::array kLengths{lengthOfGlb, lengthOfStl, lengthOf3ds, lengthOfLwo, lengthOfB3d, lengthOfFbx};

// Marks at the end of a format's files.

struct EndMark {
    bool (*is)(const Ends& file);
    View mark;        ///< in small letters
    std::size_t room; ///< bytes at the end among which it stands
    View name;        ///< for people; "" for the list of what an archive holds
};

constexpr std::array kEndMarks{
    EndMark{[](const Ends& f) { return f.head.starts_with("ISO-10303-21"); }, "end-iso-10303-21"sv, 1024,
            "'END-ISO-10303-21'"sv},
    EndMark{[](const Ends& f) { return f.head.starts_with("PK\x03\x04"); }, "pk\x05\x06"sv, 65557, ""sv},
    EndMark{[](const Ends& f) { return f.head.starts_with("BLENDER"); }, "endb"sv, 64, "'ENDB'"sv},
    EndMark{isTextStl, "endsolid"sv, 1024, "'endsolid'"sv},
    EndMark{[](const Ends& f) { return f.ending == ".dxf" && !f.head.starts_with("AutoCAD Binary"); },
            "eof"sv, 64, "'EOF'"sv},
    EndMark{[](const Ends& f) { return f.ending == ".smd"; }, "end"sv, 64, "'end'"sv},
};

/// The name of the outermost element of an XML file; "" for others.
View rootOf(View head) {
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    if (!head.starts_with("<")) return {};
    for (std::size_t at = 0; at != View::npos; at = head.find('<', at + 1)) {
        if (head.substr(at).starts_with("<!--")) { // may hold what looks like an element
            at = head.find("-->", at);
            if (at == View::npos) return {};
            continue;
        }
        const View name = head.substr(at + 1, head.find_first_of(" \t\r\n/>", at) - at - 1);
        if (!name.empty() && name[0] != '!' && name[0] != '?') return name;
    }
    return {};
}

bool endsWithout(const Ends& file, View mark, std::size_t room) {
    const View tail = View(file.tail).substr(file.tail.size() - std::min(room, file.tail.size()));
    return lower(tail).find(mark) == std::string::npos;
}

std::optional<Sentence> missingMark(const Ends& file) {
    constexpr std::size_t kXmlEnd = 4096; // comments may follow
    const auto without = [](View name) {
        if (name.empty()) return say(import_forms::kNoContents);
        return say(import_forms::kNoEndMark, name);
    };
    for (const EndMark& m : kEndMarks)
        if (m.is(file) && endsWithout(file, m.mark, m.room)) return without(m.name);
    const std::string root(rootOf(file.head));
    if (!root.empty() && endsWithout(file, lower("</" + root), kXmlEnd)) return without("'</" + root + ">'");
    return {};
}

} // namespace

std::optional<Sentence> cutOff(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) return {};
    const Ends file(path);
    for (const auto& lengthOf : kLengths) {
        const std::uint64_t length = lengthOf(file);
        if (length > file.size) return say(import_forms::kCutOff, file.size, length);
    }
    return missingMark(file);
}

} // namespace rtcore
