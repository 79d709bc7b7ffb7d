/// Archives of tensors (.tza): the weights of neural nets as Intel Open Image Denoise keeps them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace rtcore {

/// An array of numbers in one dimension ("x") or four ("oihw": outputs, inputs, rows, columns), the last
/// side the fastest.
struct Tensor {
    std::vector<std::uint32_t> sides;
    std::vector<float> values; ///< finite
};
using TensorArchive = std::map<std::string, Tensor, std::less<>>;

/// Nothing of the bytes is trusted: at most 256 tensors, sides of 1 to 1024, 2^24 numbers in all, each of
/// half or single precision and finite, no name twice. Throws FileError (BadData), which names `file`.
TensorArchive parseTensorArchive(std::span<const std::byte> bytes, const std::string& file);

/// The same of a file of at most 64 MiB. Throws FileError.
TensorArchive readTensorArchive(const std::filesystem::path& file);

} // namespace rtcore
