/// Parts shared by the tests of the text formats.
#pragma once

#include "rtcore/platform/error.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#ifndef RT_FORMATS_DOCUMENT
#error "RT_FORMATS_DOCUMENT is the path of docs/formats.md"
#endif

namespace test {

/// The message of the FileError BadData that `work` throws; "no error" when it throws none.
template <typename Work>
std::string badData(Work work) {
    try {
        work();
    } catch (const rtcore::FileError& error) {
        return (error.kind == rtcore::FailureKind::BadData ? "" : "wrong kind: ") + std::string(error.what());
    }
    return "no error";
}

inline std::string fileContent(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void writeFile(const std::string& path, std::string_view content) {
    std::ofstream(path, std::ios::binary) << content;
}

/// The fenced blocks of docs/formats.md that begin with ```<tag>.
inline std::vector<std::string> documentedExamples(const std::string& tag) {
    std::vector<std::string> examples;
    const std::string document = "\n" + fileContent(RT_FORMATS_DOCUMENT), fence = "\n```" + tag + "\n";
    for (std::size_t at = document.find(fence); at != std::string::npos; at = document.find(fence, at + 1)) {
        const std::size_t begin = at + fence.size(), end = document.find("\n```", begin - 1);
        examples.push_back(document.substr(begin, end + 1 - begin));
    }
    return examples;
}

/// Random values, the same for the same seed on every standard library.
class Random {
  public:
    explicit Random(std::uint32_t seed) : bits_(seed) {}

    std::uint32_t bits() { return static_cast<std::uint32_t>(bits_()); }
    std::size_t below(std::size_t end) { return static_cast<std::size_t>(bits()) % end; }
    bool flag() { return below(2) == 1; }
    /// In [0, 1).
    float fraction() { return static_cast<float>(bits() >> 8U) * 0x1p-24F; }
    /// Any size from 1e-12 to 1e12.
    float positive() {
        float value = 1 + fraction();
        for (int i = static_cast<int>(below(80)) - 40; i != 0; i += i < 0 ? 1 : -1)
            value *= i < 0 ? 0.5F : 2.0F;
        return value;
    }
    float number() { return flag() ? positive() : -positive(); }

  private:
    std::mt19937 bits_;
};

} // namespace test
