#include "rtcore/io/import/assimp/fbx_elements.h"

#include "rtcore/platform/files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

namespace rtcore {

namespace {

constexpr std::size_t kMaxValues = 16;
constexpr int kDeepestElement = 32;

constexpr std::string_view kBinaryMark{"Kaydara FBX Binary  \0", 21};

template <std::size_t N>
bool isOneOf(std::string_view name, const std::array<std::string_view, N>& names) {
    return std::ranges::find(names, name) != names.end();
}

/// By the names of the elements around it and its own.
bool isWanted(std::span<const std::string> around, std::string_view name) {
    using Names = std::string_view;
    if (around.empty())
        return isOneOf(name, std::array<Names, 3>{"FBXHeaderExtension", "Objects", "Connections"});
    if (around[0] == "FBXHeaderExtension")
        return (around.size() == 1 && name == "SceneInfo") ||
               (around.size() == 2 && name == "Properties70") || (around.size() == 3 && name == "P");
    if (around[0] == "Connections") return around.size() == 1 && name == "C";
    if (around.size() == 1)
        return isOneOf(name,
                       std::array<Names, 5>{"Model", "Deformer", "NodeAttribute", "Geometry", "Material"});
    const bool hasProperties = isOneOf(around[1], std::array<Names, 2>{"Model", "Deformer"});
    if (around.size() == 2)
        return hasProperties &&
               isOneOf(name, std::array<Names, 3>{"Properties70", "DeformPercent", "FullWeights"});
    return around.size() == 3 && (name == "P" || name == "a");
}

bool isKept(const FbxElement& element) {
    using Names = std::string_view;
    constexpr std::array<Names, 5> kProperties{"Visibility", "Visibility Inheritance", "Show",
                                               "DeformPercent", kFbxApplication};
    return element.name != "P" || isOneOf(element.text(0), kProperties);
}

/// "Cube\0\1Model" of binary files, "Model::Cube" of text.
std::string plainName(std::string_view name) {
    const std::size_t zero = name.find('\0');
    if (zero != std::string_view::npos) return std::string(name.substr(0, zero));
    for (const std::string_view kind :
         {"Model::", "SubDeformer::", "Deformer::", "Geometry::", "NodeAttribute::", "Material::"}) {
        if (name.starts_with(kind)) return std::string(name.substr(kind.size()));
    }
    return std::string(name);
}

class BinaryFbx {
  public:
    explicit BinaryFbx(std::span<const std::byte> bytes) : bytes_(bytes) {
        at_ = kBinaryMark.size() + 2;
        wide_ = number<std::uint32_t>().value_or(0) >= 7500;
    }

    /// Up to `end`, or where there is none or the file is damaged.
    std::vector<FbxElement> elements(std::uint64_t end) {
        std::vector<FbxElement> list;
        while (at_ < end) {
            const std::uint64_t begin = at_;
            const auto last = offset(), count = offset(), length = offset();
            const auto nameLength = number<std::uint8_t>();
            if (!last || !count || !length || !nameLength) break;
            if (*last <= begin || *last > bytes_.size()) break;
            FbxElement element{std::string(characters(*nameLength)), {}, {}};
            const std::uint64_t behind = at_ + *length;
            if (isWanted(around_, element.name) && behind >= at_ && behind <= *last) {
                readValues(*count, behind, element);
                at_ = behind;
                around_.push_back(element.name);
                element.children = elements(*last);
                around_.pop_back();
                if (isKept(element)) list.push_back(std::move(element));
            }
            at_ = *last;
        }
        return list;
    }

  private:
    template <typename T>
    std::optional<T> number() {
        T value{};
        if (at_ + sizeof(T) > bytes_.size()) return std::nullopt;
        std::memcpy(&value, bytes_.data() + at_, sizeof(T));
        at_ += sizeof(T);
        return value;
    }
    std::optional<std::uint64_t> offset() {
        if (wide_) return number<std::uint64_t>();
        const auto value = number<std::uint32_t>();
        return value ? std::optional<std::uint64_t>(*value) : std::nullopt;
    }
    /// None where they go beyond the end.
    std::string_view characters(std::uint64_t count) {
        if (at_ > bytes_.size() || count > bytes_.size() - at_) {
            at_ = bytes_.size();
            return {};
        }
        const std::string_view text(reinterpret_cast<const char*>(bytes_.data()) + at_, count);
        at_ += count;
        return text;
    }

    void readValues(std::uint64_t count, std::uint64_t behind, FbxElement& element) {
        for (std::uint64_t i = 0; i < count && at_ < behind && element.values.size() < kMaxValues; ++i) {
            const auto kind = number<char>();
            if (!kind || !readValue(*kind, element)) return;
        }
    }

    template <typename T, typename As>
    bool addNumber(FbxElement& element) {
        const auto value = number<T>();
        if (value) element.values.emplace_back(static_cast<As>(*value));
        return value.has_value();
    }

    bool readValue(char kind, FbxElement& element) {
        switch (kind) {
        case 'Y':
            return addNumber<std::int16_t, std::int64_t>(element);
        case 'C':
            return addNumber<std::int8_t, std::int64_t>(element);
        case 'I':
            return addNumber<std::int32_t, std::int64_t>(element);
        case 'L':
            return addNumber<std::int64_t, std::int64_t>(element);
        case 'F':
            return addNumber<float, double>(element);
        case 'D':
            return addNumber<double, double>(element);
        case 'S':
        case 'R': {
            const auto length = number<std::uint32_t>();
            if (!length) return false;
            element.values.emplace_back(plainName(characters(*length)));
            return true;
        }
        case 'd':
            return addList<double>(element);
        case 'f':
            return addList<float>(element);
        default:
            return false; // lists of whole numbers: none is asked for
        }
    }

    /// Compressed ones are long, and none of those is asked for.
    template <typename T>
    bool addList(FbxElement& element) {
        const auto count = number<std::uint32_t>(), packed = number<std::uint32_t>(),
                   length = number<std::uint32_t>();
        if (!count || !packed || !length || *packed != 0) return false;
        for (std::uint32_t i = 0; i < *count && element.values.size() < kMaxValues; ++i)
            if (!addNumber<T, double>(element)) return false;
        return true;
    }

    std::span<const std::byte> bytes_;
    std::uint64_t at_ = 0;
    bool wide_ = false; ///< offsets of 64 bits
    std::vector<std::string> around_;
};

class TextFbx {
  public:
    explicit TextFbx(std::string_view text) : text_(text) {}

    /// Up to the brace that ends the element around them.
    std::vector<FbxElement> elements(bool wanted) {
        std::vector<FbxElement> list;
        for (;;) {
            skip(" \t\r\n,");
            if (at_ >= text_.size() || text_[at_] == '}') break;
            const std::size_t colon = text_.find_first_of(":{}\n\"", at_);
            if (colon == std::string_view::npos) {
                at_ = text_.size();
                break;
            }
            if (text_[colon] != ':') {
                skipOddPiece(colon);
                continue;
            }
            FbxElement element{std::string(text_.substr(at_, colon - at_)), {}, {}};
            at_ = colon + 1;
            const bool keeps = wanted && isWanted(around_, element.name);
            around_.push_back(element.name);
            readValues(keeps, element);
            around_.pop_back();
            if (keeps && isKept(element)) list.push_back(std::move(element));
        }
        return list;
    }

  private:
    /// Blanks, and comments to the ends of their lines.
    void skip(const char* blanks) {
        for (;;) {
            at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
            if (at_ >= text_.size() || text_[at_] != ';') return;
            at_ = std::min(text_.find('\n', at_), text_.size());
        }
    }

    void skipOddPiece(std::size_t at) {
        if (text_[at] == '"') {
            at_ = at;
            string();
        } else if (text_[at] == '{') {
            at_ = at;
            block(false);
        } else {
            at_ = text_[at] == '}' ? at : at + 1;
        }
    }

    std::string_view string() {
        const std::size_t begin = at_ + 1, end = std::min(text_.find('"', begin), text_.size());
        at_ = std::min(end + 1, text_.size());
        return text_.substr(begin, end - begin);
    }

    std::vector<FbxElement> block(bool wanted) {
        ++at_;
        if (++depth_ > kDeepestElement) {
            at_ = text_.size();
            return {};
        }
        std::vector<FbxElement> list = elements(wanted);
        --depth_;
        if (at_ < text_.size()) ++at_;
        return list;
    }

    void readValues(bool wanted, FbxElement& element) {
        bool mayEnd = false; // a line that does not end with a comma ends the element
        for (;;) {
            skip(mayEnd ? " \t\r" : " \t\r\n");
            if (at_ >= text_.size()) return;
            const char c = text_[at_];
            if (c == '{') {
                element.children = block(wanted);
                return;
            }
            if (c == '\n' || c == '}') return;
            if (c == ',') {
                ++at_;
                mayEnd = false;
                continue;
            }
            if (isNextElement()) return;
            addValue(wanted, element);
            mayEnd = true;
        }
    }

    /// An element without values, of which the line ends at its colon.
    bool isNextElement() const {
        if (text_[at_] == '"') return false;
        const std::size_t end = text_.find_first_of(":,\r\n{}\" \t", at_);
        return end != std::string_view::npos && text_[end] == ':';
    }

    void addValue(bool wanted, FbxElement& element) {
        const bool keeps = wanted && element.values.size() < kMaxValues;
        if (text_[at_] == '"') {
            const std::string_view value = string();
            if (keeps) element.values.emplace_back(plainName(value));
            return;
        }
        const std::size_t end = std::min(text_.find_first_of(",\r\n{} \t", at_), text_.size());
        const std::string_view word = text_.substr(at_, end - at_);
        at_ = std::max(end, at_ + 1);
        if (keeps) element.values.push_back(valueOf(word));
    }

    static FbxValue valueOf(std::string_view word) {
        std::int64_t whole = 0;
        const char* const last = word.data() + word.size();
        if (const auto read = std::from_chars(word.data(), last, whole); read.ptr == last) return whole;
        double number = 0;
        if (const auto read = std::from_chars(word.data(), last, number); read.ptr == last) return number;
        return std::string(word);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::vector<std::string> around_;
};

} // namespace

const FbxElement* FbxElement::child(std::string_view childName) const {
    const auto found = std::ranges::find(children, childName, &FbxElement::name);
    return found != children.end() ? &*found : nullptr;
}

double FbxElement::number(std::size_t index) const {
    if (index >= values.size()) return 0;
    if (const auto* whole = std::get_if<std::int64_t>(&values[index])) return static_cast<double>(*whole);
    const auto* real = std::get_if<double>(&values[index]);
    return real != nullptr ? *real : 0;
}

std::int64_t FbxElement::id(std::size_t index) const {
    const auto* whole = index < values.size() ? std::get_if<std::int64_t>(&values[index]) : nullptr;
    return whole != nullptr ? *whole : 0;
}

std::string FbxElement::text(std::size_t index) const {
    const auto* string = index < values.size() ? std::get_if<std::string>(&values[index]) : nullptr;
    return string != nullptr ? *string : std::string();
}

bool isFbx(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".fbx" || ending == ".FBX") return true;
    const FileBytes file = openFileBytes(path);
    const std::string_view text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    return text.starts_with(kBinaryMark) || text.starts_with("; FBX");
}

std::vector<FbxElement> readFbxElements(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    const std::string_view text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    if (text.starts_with(kBinaryMark)) return BinaryFbx(file.bytes).elements(file.bytes.size());
    return TextFbx(text).elements(true);
}

} // namespace rtcore
