#include "rtcore/io/import/scan/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_set>
#include <utility>

namespace rtcore {

namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array kTypeNames{
    TypeName{"char", PlyType::Int8},      TypeName{"int8", PlyType::Int8},
    TypeName{"uchar", PlyType::UInt8},    TypeName{"uint8", PlyType::UInt8},
    TypeName{"short", PlyType::Int16},    TypeName{"int16", PlyType::Int16},
    TypeName{"ushort", PlyType::UInt16},  TypeName{"uint16", PlyType::UInt16},
    TypeName{"int", PlyType::Int32},      TypeName{"int32", PlyType::Int32},
    TypeName{"uint", PlyType::UInt32},    TypeName{"uint32", PlyType::UInt32},
    TypeName{"float", PlyType::Float32},  TypeName{"float32", PlyType::Float32},
    TypeName{"double", PlyType::Float64}, TypeName{"float64", PlyType::Float64},
};

std::optional<PlyType> typeOf(std::string_view name) {
    for (const TypeName& known : kTypeNames) {
        if (known.name == name) return known.type;
    }
    return {};
}

std::vector<std::string_view> wordsOf(std::string_view line) {
    constexpr std::string_view kBlanks = " \t";
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(kBlanks, end);
    }
    return words;
}

using Words = std::vector<std::string_view>;

/// One line after another; false for what it does not know.
class HeaderReader {
  public:
    bool read(const Words& words) {
        if (words.empty()) return false;
        // Assimp takes the name of a texture from a comment.
        if (words[0] == "comment") return words.size() < 2 || words[1] != "TextureFile";
        if (words[0] == "obj_info") return header_.elements.empty();
        if (words[0] == "format") return readFormat(words);
        if (words[0] == "element") return readElement(words);
        return words[0] == "property" && readProperty(words);
    }
    bool hasFormat() const { return hasFormat_; }
    PlyHeader header() { return std::move(header_); }

  private:
    bool readFormat(const Words& words) {
        if (hasFormat_ || words.size() != 3 || words[2] != "1.0") return false;
        hasFormat_ = true;
        header_.bigEndian = words[1] == "binary_big_endian";
        header_.isText = words[1] == "ascii";
        return header_.isText || header_.bigEndian || words[1] == "binary_little_endian";
    }

    bool readElement(const Words& words) {
        if (!hasFormat_ || words.size() != 3) return false;
        PlyElement element{std::string(words[1]), 0, {}};
        const char* const end = words[2].data() + words[2].size();
        const auto [last, error] = std::from_chars(words[2].data(), end, element.count);
        if (error != std::errc() || last != end || !names_.insert(element.name).second) return false;
        header_.elements.push_back(std::move(element));
        return true;
    }

    bool readProperty(const Words& words) {
        const bool list = words.size() == 5 && words[1] == "list";
        if (header_.elements.empty() || (!list && words.size() != 3)) return false;
        const auto type = typeOf(words[list ? 3 : 1]);
        const auto length = list ? typeOf(words[2]) : std::nullopt;
        if (!type || (list && !length)) return false;
        header_.elements.back().properties.push_back({std::string(words.back()), *type, length});
        return true;
    }

    PlyHeader header_;
    std::unordered_set<std::string> names_; ///< of elements
    bool hasFormat_ = false;
};

} // namespace

std::size_t sizeOf(PlyType type) {
    constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

bool PlyElement::hasList() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& p) { return p.listLength.has_value(); });
}

std::size_t PlyElement::fixedSize() const {
    std::size_t size = 0;
    for (const PlyProperty& p : properties) size += p.listLength ? 0 : sizeOf(p.type);
    return size;
}

std::optional<PlyHeader> readPlyHeader(std::string_view head) {
    constexpr std::string_view kMagic = "ply\n";
    if (!head.starts_with(kMagic)) return {};
    const std::string_view text = head.substr(0, kMaxPlyHeader);
    HeaderReader reader;
    for (std::size_t at = kMagic.size();;) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string_view::npos) return {};
        const std::string_view line = text.substr(at, end - at);
        at = end + 1;
        if (line != "end_header") {
            if (!reader.read(wordsOf(line))) return {};
            continue;
        }
        if (!reader.hasFormat()) return {};
        PlyHeader header = reader.header();
        header.size = at;
        return header;
    }
}

bool endsInPlyHeader(std::string_view text) {
    constexpr std::string_view kMagic = "ply";
    constexpr std::string_view kLineEnds = "\r\n";
    if (!text.starts_with(kMagic)) return false;
    if (text.size() > kMagic.size() && kLineEnds.find(text[kMagic.size()]) == std::string_view::npos)
        return false;
    for (std::size_t at = 0;;) {
        const std::size_t end = text.find_first_of(kLineEnds, at);
        if (end == std::string_view::npos) return true;
        const Words words = wordsOf(text.substr(at, end - at));
        if (words.size() == 1 && words[0] == "end_header") return false;
        at = end + 1;
    }
}

} // namespace rtcore
